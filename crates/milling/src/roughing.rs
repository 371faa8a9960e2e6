//! Clearing the space before its flanks are finished: layers from the tip down, passes side by side in every layer, the axis upright
//! in the column's plane, an allowance kept from both flanks and the bottom.

use super::{CutterPath, CutterPlace, LeadCurve, LeadPoint, MillingError, Patch};
use foundation::geometry::{Cutter, in_tool};
use nalgebra::Vector3;
use rayon::prelude::*;

/// How a space is cleared. mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RoughingOptions {
    /// What stays on flanks and bottom.
    pub allowance: f64,
    /// Height of the first layer's tip above the lead point.
    pub top: f64,
    /// Height of the bottom above the lead point.
    pub bottom: f64,
    /// Greatest depth of a layer.
    pub step_down: f64,
    /// Greatest distance of passes side by side.
    pub step_over: f64,
}

/// One layer.
#[derive(Clone, Debug, PartialEq)]
pub struct RoughingLayer {
    /// Height of the tip above the lead point, mm.
    pub height: f64,
    /// Its passes; one that is interrupted where the space is too narrow counts as several.
    pub passes: Vec<CutterPath>,
}

/// How far the cutter may stay short of its limit aside, mm: more stays on the flank, never less.
const SHORT: f64 = 0.03;

/// Steps aside at most; each covers a good third of the way that is left.
const STEPS: usize = 60;

/// Layers of a space between two flanks over the planes at the given lead parameters; `roots` are points of the drawn root in each of these
/// planes, which the allowance is kept from as well.
///
/// # Errors
/// Those of the guide curve; [`MillingError::RoughingNowhere`] if the cutter finds no room in any layer.
pub fn rough(
    cutter: &Cutter,
    lead: &dyn LeadCurve,
    at: &[f64],
    flanks: [Patch; 2],
    roots: &[Vec<Vector3<f64>>],
    options: &RoughingOptions,
) -> Result<Vec<RoughingLayer>, MillingError> {
    let leads = at.iter().map(|&u| lead.at(u)).collect::<Result<Vec<_>, _>>()?;
    let lowest = options.bottom + options.allowance;
    let layers = ((options.top - lowest) / options.step_down).ceil().max(1.0) as usize;
    let heights: Vec<f64> =
        (1..=layers).map(|n| options.top + (lowest - options.top) * n as f64 / layers as f64).collect();
    let layer = |&height: &f64| {
        let of_plane = |(lead, root): (&LeadPoint, &Vec<Vector3<f64>>)| {
            room(cutter, lead, (&flanks, root), height, options.allowance)
        };
        let mut room: Vec<Option<[f64; 2]>> = leads.par_iter().zip(roots).map(of_plane).collect();
        as_beside(&mut room);
        let widest = room.iter().flatten().map(|[from, to]| to - from).fold(0.0, f64::max);
        let beside = (widest / options.step_over).ceil() as usize + 1;
        let shares = (0..beside).map(|n| if beside == 1 { 0.5 } else { n as f64 / (beside - 1) as f64 });
        let passes = shares.flat_map(|share| pass(&leads, &room, height, share)).collect();
        RoughingLayer { height, passes }
    };
    let layers: Vec<RoughingLayer> = heights.iter().map(layer).filter(|l| !l.passes.is_empty()).collect();
    if layers.is_empty() {
        return Err(MillingError::RoughingNowhere { top: options.top, bottom: lowest });
    }
    Ok(layers)
}

fn upright(lead: &LeadPoint, aside: f64, height: f64) -> CutterPlace {
    let tip: Vector3<f64> = lead.point + lead.abscissa() * aside + lead.base_normal * height;
    CutterPlace { tip, axis: lead.base_normal, contact: None }
}

/// Where no flank stands beside the cutter (beyond the face), it goes no further aside than at the nearest place with one.
fn as_beside(room: &mut [Option<[f64; 2]>]) {
    for side in 0..2 {
        let limits: Vec<Option<f64>> =
            room.iter().map(|room| room.map(|room| room[side]).filter(|limit| limit.is_finite())).collect();
        for (n, room) in room.iter_mut().enumerate() {
            let Some(ends) = room.as_mut().filter(|ends| !ends[side].is_finite()) else { continue };
            let nearest = (0..limits.len()).filter(|k| limits[*k].is_some()).min_by_key(|k| k.abs_diff(n));
            match nearest.and_then(|k| limits[k]) {
                Some(limit) => ends[side] = limit,
                None => *room = None,
            }
        }
    }
}

/// How far aside the upright cutter can stand at a height, both ways, from a place in the middle at which it fits; infinite where
/// nothing limits it.
fn room(
    cutter: &Cutter,
    lead: &LeadPoint,
    (flanks, root): (&[Patch; 2], &[Vector3<f64>]),
    height: f64,
    allowance: f64,
) -> Option<[f64; 2]> {
    // What is kept beyond the allowance is free to go: a body that moves by x comes nearer by x at the most.
    let free = |aside: f64| {
        let place = upright(lead, aside, height);
        let free = flanks
            .iter()
            .map(|flank| flank.lower_bound(cutter, &place.tip, &place.axis, allowance, SHORT) - allowance);
        let above_root = root.iter().map(|point| {
            let [rho, z] = in_tool(point, &place.tip, &place.axis);
            cutter.distance(rho, z) - allowance
        });
        free.chain(above_root).fold(f64::INFINITY, f64::min)
    };
    let from_middle = free(0.0);
    if from_middle < 0.0 {
        return None;
    }
    let beyond = distance_of_middles(flanks);
    let limit = |sense: f64| {
        let (mut reached, mut step) = (0.0, from_middle);
        for _ in 0..STEPS {
            if step < 0.5 * SHORT {
                break;
            }
            reached += step;
            if reached > beyond {
                return sense * f64::INFINITY;
            }
            step = free(sense * reached);
        }
        sense * reached
    };
    Some([limit(-1.0), limit(1.0)])
}

/// A distance aside at which every cutter stands beyond both flanks: that of their middles.
fn distance_of_middles(flanks: &[Patch; 2]) -> f64 {
    let middle = |flank: &Patch| {
        let [a, b] = [flank.heights, flank.lengths].map(|[from, to]| 0.5 * (from + to));
        flank.surface.point(a, b)
    };
    (middle(&flanks[0]) - middle(&flanks[1])).norm()
}

/// The pass at a share of the room's width; interrupted where there is no room.
fn pass(leads: &[LeadPoint], room: &[Option<[f64; 2]>], height: f64, share: f64) -> Vec<CutterPath> {
    let mut paths = vec![CutterPath { places: Vec::new() }];
    for (lead, room) in leads.iter().zip(room) {
        match (room, paths.last_mut()) {
            (Some([from, to]), Some(path)) => {
                path.places.push(upright(lead, from + (to - from) * share, height));
            }
            _ => paths.push(CutterPath { places: Vec::new() }),
        }
    }
    paths.retain(|path| path.places.len() > 1);
    paths
}
