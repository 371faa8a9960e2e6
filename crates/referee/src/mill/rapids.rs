//! Rapid moves against the stock that stands at their time: points of the tool, shank and holder included, that lie in the body and that no
//! earlier move has swept.

use super::block::Block;
use super::body::Part;
use super::search::Search;
use super::tree::Tree;
use super::{NormalRay, Stores, Swept};
use crate::{RemovalError, error};
use foundation::geometry::Cutter;
use foundation::numerics::Progress;
use nalgebra::Vector3;
use rayon::prelude::*;
use std::f64::consts::TAU;

/// What is looked at.
#[derive(Clone, Copy)]
pub struct Rapids<'a> {
    /// All moves in the order of time, each a path of its own.
    pub swept: &'a Swept<'a>,
    /// Whether each of them is rapid.
    pub rapid: &'a [bool],
    /// Whether a place lies in the body before anything is milled.
    pub body: &'a (dyn Fn(&Vector3<f64>) -> bool + Sync),
    /// How far the tool is modelled above its tip, mm.
    pub reach: f64,
    /// Distance of places on the way and of points on the tool, mm.
    pub step: f64,
}

/// A rapid move that meets stock.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RapidHit {
    /// Index of its path.
    pub path: usize,
    /// A place in the stock, mm.
    pub place: Vector3<f64>,
}

/// How deep in the tool its points lie, mm: a tool that slides along what it has cut is no collision.
const WITHIN: f64 = 0.05;
/// A place counts as swept where a cutter comes nearer than this, mm.
const SWEPT: f64 = 1e-6;
/// Largest radius of a tool that is looked for, mm.
const WIDEST: f64 = 500.0;

/// The rapid moves that meet stock, each with the first place that was found.
///
/// # Errors
/// As [`super::mill`], and [`RemovalError::InvalidNumber`] for step and reach.
pub fn rapid_hits(setup: &Rapids<'_>, progress: &dyn Progress) -> Result<Vec<RapidHit>, RemovalError> {
    error::positive("step of rapid moves", setup.step)?;
    error::positive("length of the tool", setup.reach)?;
    let Swept { setup: milling, blocks: all, trees } = setup.swept;
    let tools: Vec<Vec<Vector3<f64>>> =
        milling.cutters.iter().map(|cutter| points(cutter, setup.reach, setup.step)).collect();
    // The blocks of a path stand one after the other.
    let mut moves: Vec<&[Block]> = all.chunk_by(|a, b| a.path == b.path).collect();
    moves.retain(|blocks| setup.rapid.get(blocks[0].path).copied().unwrap_or(false));
    progress.start("rapid moves", moves.len() as u64);
    let hits: Vec<Option<RapidHit>> = moves
        .par_iter()
        .map_init(Stores::default, |stores, blocks| {
            let path = blocks[0].path;
            let tool = &tools[milling.paths[path].cutter];
            let found = first_place(setup, blocks, tool, |point| stands(all, trees, point, path, stores));
            progress.advance(1);
            found.map(|place| RapidHit { path, place })
        })
        .collect();
    progress.finish();
    Ok(hits.into_iter().flatten().collect())
}

/// The first place on a move at which a point of the tool is in the stock.
fn first_place(
    setup: &Rapids<'_>,
    blocks: &[Block],
    tool: &[Vector3<f64>],
    mut stands: impl FnMut(&Vector3<f64>) -> bool,
) -> Option<Vector3<f64>> {
    // Way since the last place that was looked at.
    let mut since = f64::INFINITY;
    for (number, block) in blocks.iter().enumerate() {
        let way = block.speed(setup.reach);
        let pieces = (way / setup.step).ceil().max(1.0);
        let last = number + 1 == blocks.len();
        for k in 0..=pieces as usize {
            let is_end = k == pieces as usize;
            if since < setup.step && !(last && is_end) {
                since += if is_end { 0.0 } else { way / pieces };
                continue;
            }
            since = if is_end { 0.0 } else { way / pieces };
            let pose = block.pose(k as f64 / pieces);
            let across = pose.axis.cross(&any_other(&pose.axis)).normalize();
            let third = pose.axis.cross(&across);
            for at in tool {
                let point = pose.tip + across * at.x + third * at.y + pose.axis * at.z;
                if (setup.body)(&point) && stands(&point) {
                    return Some(point);
                }
            }
        }
    }
    None
}

/// A direction that is not that of the axis.
fn any_other(axis: &Vector3<f64>) -> Vector3<f64> {
    if axis.x.abs() < 0.7 { Vector3::x() } else { Vector3::y() }
}

/// Whether no move before a path has swept a place.
fn stands(
    blocks: &[Block],
    trees: &[Tree],
    point: &Vector3<f64>,
    before: usize,
    stores: &mut Stores,
) -> bool {
    let ray = NormalRay { point: *point, normal: Vector3::z() };
    let mut search =
        Search { ray: &ray, lowest: 0.0, best: SWEPT, found: None, unsettled: false, evaluations: 0 };
    for tree in trees {
        for part in &tree.parts {
            let range = [search.lowest, search.best];
            tree.visit(part, &ray, range, &mut stores.branches, &mut |index| {
                if blocks[index].path < before {
                    search.block(index, &blocks[index], part, &mut stores.stretches);
                }
                search.found.is_none().then_some(search.best)
            });
            if search.found.is_some() {
                return false;
            }
        }
    }
    true
}

/// Points just within the surface of a tool, in its coordinates: rings along it, and discs at its tip and at shoulders.
fn points(cutter: &Cutter, reach: f64, step: f64) -> Vec<Vector3<f64>> {
    let parts = Part::of(cutter);
    let is_within = |rho: f64, z: f64| parts.iter().any(|part| part.distance(rho, z)[0] <= -WITHIN);
    let mut points = Vec::new();
    let mut inner = 0.0;
    let count = (reach / step).ceil() as usize;
    for k in 0..=count {
        let z = (2.0 * WITHIN + k as f64 * step).min(reach);
        if !is_within(0.0, z) {
            continue;
        }
        let (mut low, mut high) = (0.0, WIDEST);
        for _ in 0..40 {
            let middle = 0.5 * (low + high);
            if is_within(middle, z) { low = middle } else { high = middle }
        }
        // A ring at the surface, and rings towards the axis as far as the tool is wider here than below.
        let mut rho = low;
        loop {
            let around = (TAU * rho / step).ceil().max(1.0);
            points.extend((0..around as usize).map(|i| {
                let (sin, cos) = (TAU * i as f64 / around).sin_cos();
                Vector3::new(rho * cos, rho * sin, z)
            }));
            if rho <= inner || rho == 0.0 {
                break;
            }
            rho = (rho - step).max(inner);
        }
        inner = low;
    }
    points
}
