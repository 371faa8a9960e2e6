//! The referee on the drawn root: fillets and bottom in sections along the face, under all cutters of the plan, and what was predicted
//! for every ray.

use super::finding::failure;
use super::prepare::MillingBodies;
use super::referee::{STOCK, mill_paths, swept, unmilled};
use super::result::RootDeviationResult;
use crate::{FlankPlan, MillingPlan, RootModel, RootPart, RootPoint, drawn_root};
use foundation::numerics::{Progress, equidistant, extremes, root_mean_square};
use rayon::prelude::*;
use referee::{NormalRay, Unmilled};
use run::RunFailure;

/// Rays in one section: on each fillet and on the bottom.
const RAYS: [usize; 2] = [21, 15];

/// A part of the root under its rays, section by section. mm.
#[derive(Clone, Debug)]
pub struct RefereedRoot {
    /// Which part.
    pub part: RootPart,
    /// Where the rays stand.
    pub points: Vec<RootPoint>,
    /// What the rays found, > 0 stock; `None` where no cutter comes by.
    pub simulated: Vec<Option<f64>>,
    /// What was predicted.
    pub predicted: Vec<Option<f64>>,
    /// Why rays were not milled, with their number.
    pub unmilled: Vec<(Unmilled, usize)>,
}

/// The root of a plan under the referee in so many sections over the face; nothing without a pass of the root.
///
/// # Errors
/// [`RunFailure`] where a section cannot be drawn, or for motions that the referee cannot follow.
pub fn referee_root(
    bodies: &MillingBodies,
    plan: &MillingPlan,
    sections: usize,
    progress: &dyn Progress,
) -> Result<Vec<RefereedRoot>, RunFailure> {
    let mut all: Vec<RootPoint> = Vec::new();
    for space in &bodies.parts {
        let Some(flank) = space.flanks.first() else { continue };
        let milled = plan.flanks.iter().filter(|made| made.side.half == flank.side().half);
        for u in equidistant(flank.active.face, sections) {
            // Where rows end in the middle of a double-helical gear, nothing of the root is milled either.
            let comes_by = |made: &FlankPlan| made.reaches(made.active.height_span()[0], u);
            let all_come = milled.clone().map(comes_by).collect::<Result<Vec<_>, _>>();
            if all_come.map_err(|error| failure(&error))?.into_iter().all(|comes| comes) {
                all.extend(drawn_root(space, &bodies.options, u, RAYS).map_err(|error| failure(&error))?);
            }
        }
    }
    // Passes of halves end short of the face; what their last places leave is not predicted.
    let model = RootModel::new(plan, &bodies.options).filter(|_| bodies.parts.len() == 1);
    let (cutters, paths) = mill_paths(bodies, plan);
    let swept = swept(&cutters, &paths, STOCK)?;
    let mut parts: Vec<RefereedRoot> = Vec::new();
    for point in &all {
        if parts.iter().any(|known| known.part == point.part) {
            continue;
        }
        let points: Vec<RootPoint> = all.iter().copied().filter(|other| other.part == point.part).collect();
        let rays: Vec<NormalRay> =
            points.iter().map(|at| NormalRay { point: at.point, normal: at.normal }).collect();
        let milled =
            swept.mill(&rays, progress).map_err(|error| RunFailure::of_removal(&error, "milling"))?;
        parts.push(RefereedRoot {
            part: point.part,
            simulated: milled.rays.iter().map(|ray| ray.as_ref().ok().map(|ray| ray.length)).collect(),
            predicted: points.par_iter().map(|at| model.as_ref()?.stock(at)).collect(),
            unmilled: unmilled(&milled.rays),
            points,
        });
    }
    Ok(parts)
}

/// How far below the drawn root a cut counts as a gouge, mm: where the tooth is not straight what is swept goes up to 7 um below the
/// drawn section by itself (`docs/mathematics/milling.md#root-and-clearance`).
const GOUGED: f64 = 0.01;

impl RefereedRoot {
    /// Rays at which a cutter digs into the drawn root.
    pub fn gouged(&self) -> usize {
        let beyond = self.unmilled.iter().filter(|(reason, _)| matches!(reason, Unmilled::TooDeep { .. }));
        let deep = self.simulated.iter().flatten().filter(|left| **left < -GOUGED);
        beyond.map(|(_, count)| count).sum::<usize>() + deep.count()
    }

    /// Rays that no cutter reaches, or only grazes.
    pub fn not_reached(&self) -> usize {
        let short = self.unmilled.iter().filter(|(reason, _)| !matches!(reason, Unmilled::TooDeep { .. }));
        short.map(|(_, count)| count).sum()
    }

    /// Name of the part in results: `left_fillet`, `bottom`.
    pub fn name(&self) -> String {
        match self.part {
            RootPart::Fillet(side) => format!("{}_fillet", side.name().replace('-', "_")),
            RootPart::Bottom => "bottom".into(),
        }
    }

    /// Its figures.
    pub(super) fn result(&self) -> RootDeviationResult {
        let um =
            |values: &[Option<f64>]| -> Vec<f64> { values.iter().flatten().map(|mm| 1e3 * mm).collect() };
        let (found, planned) = (um(&self.simulated), um(&self.predicted));
        let ends = |values: &[f64]| {
            let ends = extremes(values.iter().copied());
            (!values.is_empty()).then_some(ends)
        };
        let both = self.simulated.iter().zip(&self.predicted);
        let differences = both.filter_map(|(found, planned)| Some(1e3 * ((*found)? - (*planned)?).abs()));
        RootDeviationResult {
            rays: self.points.len(),
            gouged: self.gouged(),
            not_reached: self.not_reached(),
            min_um: ends(&found).map(|[least, _]| least),
            max_um: ends(&found).map(|[_, most]| most),
            rms_um: (!found.is_empty()).then(|| root_mean_square(&found)),
            planned_um: ends(&planned),
            model_difference_um: differences.reduce(f64::max),
            unmilled: self.unmilled.iter().map(|(reason, count)| (reason.to_string(), *count)).collect(),
        }
    }
}
