//! The referee on a milled flank: normal rays shortened by all cutters of the plan, and what was predicted for each of them.

use super::bodies::MillingBodies;
use super::finding::failure;
use crate::geometry::{Cutter, Flank};
use crate::numerics::{Progress, equidistant};
use crate::process::milling::{FlankModel, FlankPlan, MillingPlan, OperationKind, Prediction};
use crate::removal::{CutterPlace, MillPath, MillStatistics, MilledRay, Milling, NormalRay, Unmilled, mill};
use crate::workflow::finding::RunFailure;
use rayon::prelude::*;

/// A flank as the rays found it, row-major [height][length]. mm.
#[derive(Clone, Debug)]
pub struct RefereedFlank {
    /// Which.
    pub side: Flank,
    /// Height parameters of the rays, root to tip.
    pub heights: Vec<f64>,
    /// Length parameters.
    pub lengths: Vec<f64>,
    /// What the rays found, > 0 stock; `None` where no cutter comes by.
    pub simulated: Vec<Option<f64>>,
    /// What was predicted.
    pub predicted: Vec<Option<Prediction>>,
    /// Why rays were not milled, with their number.
    pub unmilled: Vec<(Unmilled, usize)>,
    /// How much the referee looked at.
    pub statistics: MillStatistics,
    /// Bound of the rays' own error, um.
    pub error_um: f64,
}

/// How far outside the flank material is assumed, and how deep below it gouges are looked for, mm.
pub(super) const STOCK: f64 = 5.0;
pub(super) const DEPTH: f64 = 1.0;

/// Cutters and paths of a plan for the referee.
pub(super) fn mill_paths(bodies: &MillingBodies, plan: &MillingPlan) -> (Vec<Cutter>, Vec<MillPath>) {
    let (mut cutters, mut paths) = (Vec::new(), Vec::new());
    for operation in &plan.operations {
        let cutter = cutters.len();
        cutters.push(bodies.options.cutter_of(operation.kind).clone());
        paths.extend(operation.paths.iter().map(|path| MillPath {
            cutter,
            places: path.places.iter().map(|p| CutterPlace { tip: p.tip, axis: p.axis }).collect(),
        }));
    }
    (cutters, paths)
}

/// Rays on a flank: equal steps of both parameters over the face.
pub(super) fn rays(flank: &FlankPlan, bodies: &MillingBodies, counts: [usize; 2]) -> Option<Rays> {
    let space_flank = bodies.space.flanks.iter().find(|other| other.side == flank.side)?;
    let active = &space_flank.active;
    let heights = equidistant(active.height_span(), counts[0]);
    let lengths = equidistant(active.face, counts[1]);
    let rays = heights
        .iter()
        .flat_map(|&a| lengths.iter().map(move |&b| (a, b)))
        .map(|(a, b)| {
            let jet = active.surface.jet(a, b);
            NormalRay { point: jet.point, normal: jet.normal }
        })
        .collect();
    Some(Rays { heights, lengths, rays })
}

/// Rays of one flank, row-major.
pub(super) struct Rays {
    pub heights: Vec<f64>,
    pub lengths: Vec<f64>,
    pub rays: Vec<NormalRay>,
}

/// Why rays were not milled, with their number.
pub(super) fn unmilled(rays: &[Result<MilledRay, Unmilled>]) -> Vec<(Unmilled, usize)> {
    let mut counts: Vec<(Unmilled, usize)> = Vec::new();
    for reason in rays.iter().filter_map(|ray| ray.as_ref().err()) {
        let same = |known: &Unmilled| std::mem::discriminant(known) == std::mem::discriminant(reason);
        match counts.iter_mut().find(|(known, _)| same(known)) {
            Some((_, count)) => *count += 1,
            None => counts.push((*reason, 1)),
        }
    }
    counts
}

/// The rays of a refereed flank.
pub(super) fn milled_rays(flank: &RefereedFlank, bodies: &MillingBodies) -> Option<Vec<NormalRay>> {
    let surface = &bodies.space.flanks.iter().find(|other| other.side == flank.side)?.active.surface;
    let places = flank.heights.iter().flat_map(|a| flank.lengths.iter().map(move |b| (*a, *b)));
    let ray = |(a, b)| {
        let jet = surface.jet(a, b);
        NormalRay { point: jet.point, normal: jet.normal }
    };
    Some(places.map(ray).collect())
}

/// All milled flanks under their rays.
///
/// # Errors
/// [`RunFailure`] for motions that the referee cannot follow.
pub fn referee(
    bodies: &MillingBodies,
    plan: &MillingPlan,
    counts: [usize; 2],
    progress: &dyn Progress,
) -> Result<Vec<RefereedFlank>, RunFailure> {
    let (cutters, paths) = mill_paths(bodies, plan);
    let setup = Milling { cutters: &cutters, paths: &paths, stock: STOCK, depth: DEPTH };
    let of_flank = |flank: &FlankPlan| {
        let Some(Rays { heights, lengths, rays }) = rays(flank, bodies, counts) else { return Ok(None) };
        let milled =
            mill(&setup, &rays, progress).map_err(|error| RunFailure::of_removal(&error, "milling"))?;
        let simulated = milled.rays.iter().map(|ray| ray.as_ref().ok().map(|ray| ray.length)).collect();
        let predicted = predict(bodies, flank, &heights, &lengths)?;
        Ok(Some(RefereedFlank {
            side: flank.side,
            heights,
            lengths,
            simulated,
            predicted,
            unmilled: unmilled(&milled.rays),
            statistics: milled.statistics,
            error_um: milled.error_um,
        }))
    };
    plan.flanks.iter().filter_map(|flank| of_flank(flank).transpose()).collect()
}

/// What the rows leave at every ray.
fn predict(
    bodies: &MillingBodies,
    flank: &FlankPlan,
    heights: &[f64],
    lengths: &[f64],
) -> Result<Vec<Option<Prediction>>, RunFailure> {
    let Some(space_flank) = bodies.space.flanks.iter().find(|other| other.side == flank.side) else {
        return Ok(Vec::new());
    };
    let (active, lead) = (&space_flank.active, &*bodies.space.lead);
    let cutter = bodies.options.cutter_of(OperationKind::Flank(flank.side));
    // With fewer than four columns there is no spline through them and nothing is predicted between.
    let Ok(model) = FlankModel::new(active, lead, flank, cutter, bodies.options.orientation) else {
        return Ok(vec![None; heights.len() * lengths.len()]);
    };
    let places: Vec<(f64, f64)> =
        heights.iter().flat_map(|&a| lengths.iter().map(move |&b| (a, b))).collect();
    let of_place = |&(a, b): &(f64, f64)| model.at(a, b).map(Some);
    places.par_iter().map(of_place).collect::<Result<_, _>>().map_err(|error| failure(&error))
}
