//! What the result says of a flank: its plan and what the rays found.

use super::out_of_reach::out_of_reach;
use super::prepare::MillingBodies;
use super::referee::RefereedFlank;
use super::result::{DistancesResult, FlankResult, RootResult, RowResult, WearResult};
use super::wear::histograms;
use crate::{FlankPlan, NeighbourDistances};
use foundation::numerics::{extremes, root_mean_square};
use referee::Unmilled;
use std::collections::BTreeMap;

fn distances(of: &NeighbourDistances) -> DistancesResult {
    DistancesResult {
        min_mm: of.least,
        max_mm: of.greatest,
        min_mean_mm: of.least_mean,
        max_mean_mm: of.greatest_mean,
    }
}

/// A flank of a run, without the comparison of orientations.
pub(super) fn flank_result(
    bodies: &MillingBodies,
    plan: &FlankPlan,
    refereed: &RefereedFlank,
) -> FlankResult {
    let [height_unit, length_unit] = bodies.kind.units();
    let um = |value: &Option<f64>| value.map(|mm| 1e3 * mm);
    let simulated: Vec<Option<f64>> = refereed.simulated.iter().map(um).collect();
    let planned: Vec<Option<f64>> =
        refereed.predicted.iter().map(|p| p.map(|left| 1e3 * left.stock())).collect();
    let found: Vec<f64> = simulated.iter().flatten().copied().collect();
    let [lowest, highest] = extremes(found.iter().copied());
    let differences =
        simulated.iter().zip(&planned).filter_map(|(found, wanted)| Some(((*found)? - (*wanted)?).abs()));
    let mut unmilled = BTreeMap::new();
    let mut gouged = 0;
    for (reason, count) in &refereed.unmilled {
        if matches!(reason, Unmilled::TooDeep { .. }) {
            gouged += count;
        }
        *unmilled.entry(reason.to_string()).or_insert(0) += count;
    }
    let rows = plan.rows.iter().zip(&plan.figures).enumerate().map(|(row, (finished, figures))| RowResult {
        row,
        contact_height_mm: finished.locations[finished.locations.len() / 2].contact_height,
        allowed_mm: finished.window.map(|window| [window.least, window.greatest]),
        scallop_um: figures.scallop.map(|mm| 1e3 * mm),
        chord_um: 1e3 * figures.chord,
        out_of_plane_deg: figures.out_of_plane.to_degrees(),
        axis_out_of_plane_deg: figures.axis_off.to_degrees(),
        opening_per_mm: figures.opening,
        unmilled_mm: plan.ends[row].map(|_| plan.unmilled_length(row)),
    });
    let root = plan.root.get(plan.root.len() / 2).map(|(section, _)| RootResult {
        lean_deg: section.lean.to_degrees(),
        straight_mm: section.straight,
        contact_height_mm: section.contact_height,
        half_width_mm: section.half_width,
    });
    FlankResult {
        height_unit,
        length_unit,
        height: refereed.heights.clone(),
        length: refereed.lengths.clone(),
        planned_um: planned.clone(),
        max_deviation_um: lowest.abs().max(highest.abs()),
        stock_um: [lowest, highest],
        rms_deviation_um: root_mean_square(&found),
        model_difference_um: extremes(differences)[1].max(0.0),
        referee_error_um: refereed.error_um,
        simulated_um: simulated,
        unmilled,
        gouged,
        out_of_reach: out_of_reach(plan, refereed),
        lead_range: plan.lines.range,
        overrun_columns: plan.lines.first,
        along_rows: distances(&plan.lines.dense.along_rows),
        along_columns: distances(&plan.lines.dense.along_columns),
        rows: rows.collect(),
        wear: wear(bodies, plan),
        root,
        orientation: None,
    }
}

/// Wear along the edge, beside that of one height for all rows.
fn wear(bodies: &MillingBodies, plan: &FlankPlan) -> Option<WearResult> {
    let [made, fixed] = histograms(bodies, plan)?;
    Some(WearResult {
        bin_mm: made.bin,
        peak_over_fixed: made.peak() / fixed.peak(),
        spread_mm: made.spread(),
        load_m_per_mm: made.load,
    })
}
