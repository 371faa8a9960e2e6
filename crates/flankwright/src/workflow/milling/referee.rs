//! The referee on a milled flank: normal rays shortened by all cutters of the plan, and what was predicted for each of them.

use super::bodies::MillingBodies;
use super::finding::failure;
use crate::geometry::Cutter;
use crate::numerics::{Progress, equidistant};
use crate::process::milling::{
    FlankPlan, MilledSide, MillingError, MillingPlan, OperationKind, RowModel, plane_through,
};
use crate::removal::{CutterPlace, MillPath, MillStatistics, MilledRay, Milling, NormalRay, Unmilled, mill};
use crate::workflow::finding::RunFailure;
use rayon::prelude::*;

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
    /// What was predicted: scallop and chord.
    pub predicted: Vec<Option<[f64; 2]>>,
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

/// Rays on a flank: equal steps of both parameters over the face.
pub(super) fn rays(flank: &FlankPlan, counts: [usize; 2]) -> Rays {
    let active = &flank.active;
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
    Rays { heights, lengths, rays }
}

/// Rays of one flank, row-major.
pub(super) struct Rays {
    pub heights: Vec<f64>,
    pub lengths: Vec<f64>,
    pub rays: Vec<NormalRay>,
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
        let Rays { heights, lengths, rays } = rays(flank, counts);
        let milled =
            mill(&setup, &rays, progress).map_err(|error| RunFailure::of_removal(&error, "milling"))?;
        let judged = judged(flank, &heights, &lengths, &milled.rays)?;
        let mut unmilled: Vec<(Unmilled, usize)> = Vec::new();
        let found = || milled.rays.iter().zip(&judged).filter_map(|(ray, judged)| judged.then_some(ray));
        for reason in found().filter_map(|ray| ray.as_ref().err()) {
            match unmilled
                .iter_mut()
                .find(|(known, _)| std::mem::discriminant(known) == std::mem::discriminant(reason))
            {
                Some((_, count)) => *count += 1,
                None => unmilled.push((*reason, 1)),
            }
        }
        let length = |(ray, judged): (&Result<MilledRay, Unmilled>, &bool)| match ray {
            Ok(ray) if *judged => Some(ray.length),
            _ => None,
        };
        let simulated = milled.rays.iter().zip(&judged).map(length).collect();
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

/// What the two rows beside every ray leave there.
fn predict(
    bodies: &MillingBodies,
    flank: &FlankPlan,
    heights: &[f64],
    lengths: &[f64],
) -> Result<Vec<Option<[f64; 2]>>, RunFailure> {
    let (active, lead) = (&flank.active, &*flank.lead);
    let cutter = bodies.options.cutter_of(OperationKind::Flank(flank.side));
    let grid = &flank.lines.path;
    let models = flank.rows.iter().enumerate().map(|(row, finished)| {
        let tool = (cutter.shape(), cutter.cutting_length());
        RowModel::new(active, lead, grid, row, tool, finished.contact_height, flank.orientation)
    });
    // With fewer than four columns there is no spline through them and nothing is predicted between.
    let Ok(models) = models.collect::<Result<Vec<_>, _>>() else {
        return Ok(vec![None; heights.len() * lengths.len()]);
    };
    // Row distance over the speed of the lead curve: how far along a row its cutter can do something beside it.
    let reach = {
        let columns = &grid.columns;
        let step = columns[1].lead.u - columns[0].lead.u;
        let speed = (columns[1].lead.point - columns[0].lead.point).norm() / step;
        flank.lines.dense.along_columns.greatest / speed
    };
    let places: Vec<(f64, f64)> =
        heights.iter().flat_map(|&a| lengths.iter().map(move |&b| (a, b))).collect();
    let of_place = |&(a, b): &(f64, f64)| -> Result<Option<[f64; 2]>, MillingError> {
        if !flank.reaches(a, b)? {
            return Ok(None);
        }
        let u = plane_through(active, lead, a, b)?;
        let jet = active.surface.jet(a, b);
        // Heights of the rows there, ascending or (internal gears) descending.
        let sense = (heights[heights.len() - 1] - heights[0]).signum();
        let above = models.partition_point(|model| sense * (model.height(u) - a) < 0.0);
        let beside = [above.checked_sub(1), (above < models.len()).then_some(above)];
        let mut best: Option<[f64; 2]> = None;
        for row in beside.into_iter().flatten() {
            let stock = models[row].stock(&jet, u, reach)?;
            if best.is_none_or(|[scallop, chord]| stock.stock() < scallop + chord) {
                best = Some([stock.scallop, stock.chord]);
            }
        }
        Ok(best)
    };
    places.par_iter().map(of_place).collect::<Result<_, _>>().map_err(|error| failure(&error))
}
