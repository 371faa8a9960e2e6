//! What the planned dressing motion leaves of conditions that are met as nearly as their weights ask, for result and report.

use dressing::{RowAlong, RowMiss, WidthLaw};
use foundation::geometry::Flank;
use generating::{DressedFlank, GrindingPlan, PlannedTool};
use schemars::JsonSchema;
use serde::Serialize;

/// What is left of a condition of dressing over the dressed length of the worm.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct ConditionResult {
    /// Flank of the worm that it stands on; null for a height of the head and a correction of one motion for both flanks.
    pub flank: Option<Flank>,
    /// Its kind: "point", "map", "stretch", "head", "phi_S", "gamma", "d" or "v_y".
    pub kind: &'static str,
    /// What it names as coefficients of q^k over the width: share of the worm's profile, stretch in per cent, height in um, correction in
    /// degrees or mm.
    pub at: Vec<f64>,
    /// Its weight; null for one that is met exactly.
    pub weight: Option<f64>,
    /// Largest miss without sign.
    pub largest_miss: f64,
    /// Root of the mean square of the misses over the width.
    pub rms_miss: f64,
    /// Unit of both: "um", "percent" of the used profile, "deg" or "mm".
    pub unit: &'static str,
}

/// Of a plan; nothing where all conditions are met exactly.
pub(super) fn conditions_of_plan(plan: &GrindingPlan) -> Vec<ConditionResult> {
    let dressing = &plan.policy.dressing;
    if !dressing.set().is_weighed() {
        return Vec::new();
    }
    let dressed = |flank: Flank| -> Option<&DressedFlank> {
        match &plan.flanks[flank].as_ref()?.tool {
            PlannedTool::Dressed(dressed) => Some(dressed),
            PlannedTool::Stroked(_) | PlannedTool::Made(_) => None,
        }
    };
    let motions = Flank::BOTH.into_iter().filter_map(|flank| Some((flank, dressed(flank)?)));
    // One motion for both flanks leaves the same of its conditions, whichever flank is asked.
    let count = if dressing.of_both_flanks() { 1 } else { 2 };
    let rows = || dressing.rows().iter().zip(dressing.set().weights());
    motions
        .take(count)
        .flat_map(|(flank, dressed)| {
            let alone = (!dressing.of_both_flanks()).then_some(flank);
            rows().zip(&dressed.missed).map(move |((row, weight), miss)| {
                let on = row.names().or(alone);
                let length = dressed_length(plan, on.unwrap_or(flank));
                of_row(row, (on, *weight), miss, length)
            })
        })
        .collect()
}

/// Length of the used profile of the worm, mm.
fn dressed_length(plan: &GrindingPlan, flank: Flank) -> f64 {
    plan.dresser.as_ref().map_or(f64::NAN, |dresser| dresser.flanks[flank].range.length())
}

fn of_row(
    row: &RowAlong,
    (flank, weight): (Option<Flank>, Option<f64>),
    miss: &RowMiss,
    length: f64,
) -> ConditionResult {
    const DEG: f64 = 180.0 / std::f64::consts::PI;
    let times = |law: &WidthLaw, unit: f64| law.coefficients().iter().map(|c| c * unit).collect();
    // Kind, what it names, and what a miss in mm or rad counts in the unit.
    let (kind, at, scale, unit): (_, Vec<f64>, _, _) = match row {
        RowAlong::Point { at, .. } => ("point", times(at, 1.0), 1e3, "um"),
        RowAlong::Map { at, .. } => ("map", times(at, 1.0), 100.0 / length, "percent"),
        RowAlong::Stretch { stretch, .. } => ("stretch", times(stretch, 100.0), 100.0 / length, "percent"),
        RowAlong::Head { above, .. } => ("head", times(above, 1e3), 1e3, "um"),
        RowAlong::Fixed { j: 0, x } => ("phi_S", times(x, DEG), DEG, "deg"),
        RowAlong::Fixed { j: 1, x } => ("gamma", times(x, DEG), DEG, "deg"),
        RowAlong::Fixed { j: 2, x } => ("d", times(x, 1.0), 1.0, "mm"),
        RowAlong::Fixed { x, .. } => ("v_y", times(x, 1.0), 1.0, "mm"),
    };
    let (largest_miss, rms_miss) = (miss.largest * scale.abs(), miss.rms * scale.abs());
    ConditionResult { flank, kind, at, weight, largest_miss, rms_miss, unit }
}
