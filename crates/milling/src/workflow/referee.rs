//! The referee on a milled flank: normal rays shortened by all cutters of the plan, and what was predicted for each of them.

use super::finding::failure;
use super::prepare::MillingBodies;
use crate::{FlankModel, FlankPlan, MilledSide, MillingError, MillingPlan, OperationKind, Prediction};
use foundation::geometry::Cutter;
use foundation::numerics::{Progress, equidistant};
use rayon::prelude::*;
use referee::{CutterPlace, MillPath, MillStatistics, MilledRay, Milling, NormalRay, Swept, Unmilled};
use run::RunFailure;

/// A flank as the rays found it, row-major [height][length]. mm.
#[derive(Clone, Debug)]
pub struct RefereedFlank {
    /// Which.
    pub side: MilledSide,
    /// Height parameters of the rays, root to tip.
    pub heights: Vec<f64>,
    /// Length parameters.
    pub lengths: Vec<f64>,
    /// What the rays found, > 0 stock; `None` where no cutter comes by.
    pub simulated: Vec<Option<f64>>,
    /// What was predicted.
    pub predicted: Vec<Option<Prediction>>,
    /// Whether each ray is judged. In the middle of a double-helical gear rows end where the other half is in the way; what they leave
    /// there is counted, not simulated nor predicted, unless it is gouged.
    pub judged: Vec<bool>,
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

/// Motions of cutters made ready for rays that begin `stock` mm outside the surface.
///
/// # Errors
/// [`RunFailure`] for motions that the referee cannot follow.
pub(super) fn swept<'a>(
    cutters: &'a [Cutter],
    paths: &'a [MillPath],
    stock: f64,
) -> Result<Swept<'a>, RunFailure> {
    let setup = Milling { cutters, paths, stock, depth: DEPTH };
    Swept::new(&setup).map_err(|error| RunFailure::of_removal(&error, "milling"))
}

/// Why rays were not milled, with their number.
pub(super) fn unmilled<'a>(
    rays: impl IntoIterator<Item = &'a Result<MilledRay, Unmilled>>,
) -> Vec<(Unmilled, usize)> {
    let mut counts: Vec<(Unmilled, usize)> = Vec::new();
    for reason in rays.into_iter().filter_map(|ray| ray.as_ref().err()) {
        let same = |known: &Unmilled| std::mem::discriminant(known) == std::mem::discriminant(reason);
        match counts.iter_mut().find(|(known, _)| same(known)) {
            Some((_, count)) => *count += 1,
            None => counts.push((*reason, 1)),
        }
    }
    counts
}

/// Rays at all places of a flank, row-major [height][length].
pub(super) fn rays(flank: &FlankPlan, heights: &[f64], lengths: &[f64]) -> Vec<NormalRay> {
    let places = heights.iter().flat_map(|a| lengths.iter().map(move |b| (*a, *b)));
    let ray = |(a, b)| {
        let jet = flank.active.surface.jet(a, b);
        NormalRay { point: jet.point, normal: jet.normal }
    };
    places.map(ray).collect()
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
    let swept = swept(&cutters, &paths, STOCK)?;
    let of_flank = |flank: &FlankPlan| {
        let heights = equidistant(flank.active.height_span(), counts[0]);
        let lengths = equidistant(flank.active.face, counts[1]);
        let rays = rays(flank, &heights, &lengths);
        let milled =
            swept.mill(&rays, progress).map_err(|error| RunFailure::of_removal(&error, "milling"))?;
        let judged = judged(flank, &heights, &lengths, &milled.rays)?;
        let length = |(ray, judged): (&Result<MilledRay, Unmilled>, &bool)| match ray {
            Ok(ray) if *judged => Some(ray.length),
            _ => None,
        };
        let simulated = milled.rays.iter().zip(&judged).map(length).collect();
        let found = milled.rays.iter().zip(&judged).filter_map(|(ray, judged)| judged.then_some(ray));
        let unmilled = unmilled(found);
        let predicted = predict(bodies, flank, &heights, &lengths)?;
        Ok(RefereedFlank {
            side: flank.side,
            heights,
            lengths,
            simulated,
            predicted,
            judged,
            unmilled,
            statistics: milled.statistics,
            error_um: milled.error_um,
        })
    };
    plan.flanks.iter().map(of_flank).collect()
}

/// A side with its deviations, mm; `None` where no cutter comes by.
type RaysOfSide = (MilledSide, Vec<Option<f64>>);

/// Deviations of the planned flanks at places of their own, row-major [height][length], > 0 stock, mm; `None` where no cutter comes by.
///
/// # Errors
/// [`RunFailure`] for motions that the referee cannot follow.
pub fn deviations_at(
    bodies: &MillingBodies,
    plan: &MillingPlan,
    places: impl Fn(MilledSide) -> [Vec<f64>; 2],
    progress: &dyn Progress,
) -> Result<Vec<RaysOfSide>, RunFailure> {
    let (cutters, paths) = mill_paths(bodies, plan);
    let swept = swept(&cutters, &paths, STOCK)?;
    let of_flank = |flank: &FlankPlan| {
        let [heights, lengths] = places(flank.side);
        let rays = rays(flank, &heights, &lengths);
        let milled =
            swept.mill(&rays, progress).map_err(|error| RunFailure::of_removal(&error, "milling"))?;
        Ok((flank.side, milled.rays.iter().map(|ray| ray.as_ref().ok().map(|ray| ray.length)).collect()))
    };
    plan.flanks.iter().map(of_flank).collect()
}

/// Which rays of a flank are judged: those that rows come by, and any other one that is gouged all the same.
fn judged(
    flank: &FlankPlan,
    heights: &[f64],
    lengths: &[f64],
    milled: &[Result<MilledRay, Unmilled>],
) -> Result<Vec<bool>, RunFailure> {
    let places = heights.iter().flat_map(|a| lengths.iter().map(move |b| (*a, *b)));
    let judged = places.zip(milled).map(|((a, b), ray)| {
        let gouged = match ray {
            Ok(ray) => ray.length < 0.0,
            Err(reason) => matches!(reason, Unmilled::TooDeep { .. }),
        };
        Ok(gouged || flank.reaches(a, b)?)
    });
    judged.collect::<Result<_, _>>().map_err(|error: MillingError| failure(&error))
}

/// What the rows leave at every place.
pub(super) fn predict(
    bodies: &MillingBodies,
    flank: &FlankPlan,
    heights: &[f64],
    lengths: &[f64],
) -> Result<Vec<Option<Prediction>>, RunFailure> {
    let (active, lead) = (&flank.active, &*flank.lead);
    let cutter = bodies.options.cutter_of(OperationKind::Flank(flank.side));
    // With fewer than four columns there is no spline through them and nothing is predicted between.
    let Ok(model) = FlankModel::new(active, lead, flank, cutter) else {
        return Ok(vec![None; heights.len() * lengths.len()]);
    };
    let places: Vec<(f64, f64)> =
        heights.iter().flat_map(|&a| lengths.iter().map(move |&b| (a, b))).collect();
    // As far as a tool is wide beside the end of a row the cutter of the other half takes some of what is left.
    let beyond = 2.0 * cutter.shape().radius() * flank.side.half.map_or(0.0, |half| -half.sign());
    let face = active.face;
    let of_place = |&(a, b): &(f64, f64)| -> Result<Option<Prediction>, MillingError> {
        let alone = flank.reaches(a, b)? && flank.reaches(a, (b + beyond).clamp(face[0], face[1]))?;
        if alone { model.at(a, b).map(Some) } else { Ok(None) }
    };
    places.par_iter().map(of_place).collect::<Result<_, _>>().map_err(|error| failure(&error))
}
