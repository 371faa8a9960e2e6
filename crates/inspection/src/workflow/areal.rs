//! What a measured gear shows as a surface, without a job: the features of each flank from its lines or fields.

use super::evaluate::{Design, EvaluatedGear};
use super::result::ArealResult;
use super::surface::measured_surface;
use foundation::geometry::Flank;
use measured_files::inspection::{Inspection, TraceKind};
use metrology::areal::{ArealDegree, ArealField, ArealFit};
use std::collections::BTreeMap;

/// Cells of the grid, by length of roll and along the face (`docs/mathematics/inspection.md#surfaces`).
const GRID: [usize; 2] = [25, 31];

/// The middles of cells: each stands for as much of the field, as the samples of a trace do, while places at the ends would count twice.
fn middles([from, to]: [f64; 2], cells: usize) -> Vec<f64> {
    (0..cells).map(|i| from + (to - from) * (i as f64 + 0.5) / cells as f64).collect()
}

/// Features of every flank of which a surface can be made: deviations from the design, else from the involute. Flanks without lines that
/// cross, and without a range, are left out.
pub(super) fn areal(
    inspection: &Inspection,
    gear: &EvaluatedGear,
    design: Option<Design<'_>>,
) -> BTreeMap<&'static str, ArealResult> {
    let involute = |_: Flank, _: f64, _: f64| 0.0;
    let design = design.unwrap_or(&involute);
    let found = Flank::BOTH
        .into_iter()
        .filter_map(|flank| Some((flank.name(), of_flank(inspection, gear, flank, design)?)));
    found.collect()
}

fn of_flank(
    inspection: &Inspection,
    gear: &EvaluatedGear,
    flank: Flank,
    design: Design<'_>,
) -> Option<ArealResult> {
    let range = |kind| inspection.conditions.range(kind, flank).ok();
    let field = ArealField::new(range(TraceKind::Profile)?, range(TraceKind::Helix)?).ok()?;
    let [w, z] = [middles(field.roll(), GRID[0]), middles(field.face(), GRID[1])];
    let surface = measured_surface(inspection, &gear.gear, flank, [&w, &z], design).ok()??;
    let fit = ArealFit::of_grid(&surface.deviation, &field, ArealDegree::Second).ok()?;
    let features = fit.features();
    Some(ArealResult {
        teeth: surface.teeth.len(),
        twist_um: surface.sees_twist.then_some(1e3 * features.twist),
        mismatch_um: surface.mismatch_um(),
        outside_traces: surface.outside_traces(),
        surface: surface.how,
        field_mm: [field.roll(), field.face()],
        profile_slope_um: 1e3 * features.profile_slope,
        helix_slope_um: 1e3 * features.helix_slope,
        profile_crowning_um: 1e3 * features.profile_crowning,
        helix_crowning_um: 1e3 * features.helix_crowning,
        rest_rms_um: 1e3 * fit.residual_rms,
        form_um: 1e3 * fit.form,
        explained_share: fit.explained_share,
    })
}
