//! The flanks of a run as the page takes them.

use crate::page::{DensityRow, FlankFigures, FlankView, RowView, WearView};
use crate::workflow::MillingBodies;
use crate::workflow::result::{FlankResult, RowResult, WearResult};
use crate::workflow::run::MillingOutcome;
use crate::workflow::wear::histograms;
use crate::{DenseGrid, DistanceLimits, FlankPlan, Lines};

/// All flanks in the order of the plan.
pub(super) fn flanks(outcome: &MillingOutcome) -> Vec<FlankView> {
    let of_plan = |plan: &FlankPlan| {
        let result = outcome.result.flanks.get(plan.side.name())?;
        Some(flank(&outcome.bodies, plan, result))
    };
    outcome.plan.flanks.iter().filter_map(of_plan).collect()
}

/// Names of the parameters by their units: length of roll and position of cylindrical gears, roll angle and distance from the apex of
/// bevel gears, fractions of blades.
fn titles(result: &FlankResult) -> [String; 2] {
    let [height, length] = match result.height_unit {
        "mm" => ["length of roll w [mm]", "z [mm]"],
        "rad" => ["roll angle [rad]", "distance from the apex [mm]"],
        _ => ["height, hub to tip [1]", "along the blade [1]"],
    };
    [height.into(), length.into()]
}

fn flank(bodies: &MillingBodies, plan: &FlankPlan, result: &FlankResult) -> FlankView {
    let side = plan.side.name();
    let [height_title, length_title] = titles(result);
    let [least_um, greatest_um] = result.stock_um;
    FlankView {
        name: format!("{}{} flank", side[..1].to_uppercase(), &side[1..]),
        height_title,
        length_title,
        height: result.height.clone(),
        length: result.length.clone(),
        planned_um: result.planned_um.clone(),
        simulated_um: result.simulated_um.clone(),
        figures: FlankFigures {
            max_um: result.max_deviation_um,
            rms_um: result.rms_deviation_um,
            least_um,
            greatest_um,
            model_difference_um: result.model_difference_um,
            referee_error_um: result.referee_error_um,
        },
        unmilled: unmilled(result),
        rows: result.rows.iter().map(row).collect(),
        wear: result.wear.as_ref().and_then(|wear| self::wear(bodies, plan, wear)),
        density: density(&plan.lines.dense, &bodies.options.lines),
    }
}

/// Rays that are not milled, by reason; among them those that the other half of a double-helical gear keeps the cutter from.
fn unmilled(result: &FlankResult) -> Vec<(String, usize)> {
    let out_of_reach = result.out_of_reach.map(|left| ("the other half is in the way".to_owned(), left.rays));
    let reasons = result.unmilled.iter().map(|(reason, count)| (reason.clone(), *count));
    reasons.chain(out_of_reach).collect()
}

fn row(row: &RowResult) -> RowView {
    RowView {
        scallop_um: row.scallop_um,
        chord_um: row.chord_um,
        out_of_plane_deg: row.out_of_plane_deg,
        axis_out_of_plane_deg: row.axis_out_of_plane_deg,
        contact_height_mm: row.contact_height_mm,
        allowed_mm: row.allowed_mm,
    }
}

fn wear(bodies: &MillingBodies, plan: &FlankPlan, result: &WearResult) -> Option<WearView> {
    let [_, fixed] = histograms(bodies, plan)?;
    Some(WearView {
        bin_mm: result.bin_mm,
        load_m_per_mm: result.load_m_per_mm.clone(),
        fixed_m_per_mm: fixed.load,
        peak_over_fixed: result.peak_over_fixed,
        spread_mm: result.spread_mm,
    })
}

/// The eight figures beside their limits.
fn density(dense: &DenseGrid, lines: &Lines) -> Vec<DensityRow> {
    let limits = match lines {
        Lines::Limited { limits, .. } => [limits.row, limits.column],
        Lines::Counted { .. } => [DistanceLimits::default(); 2],
    };
    let mut rows = Vec::new();
    for (key, of, found, limit) in [
        ("row", "along rows", &dense.along_rows, limits[0]),
        ("column", "along columns", &dense.along_columns, limits[1]),
    ] {
        for (end, words, measured_mm, limit_mm) in [
            ("max", "greatest", found.greatest, limit.greatest),
            ("min", "least", found.least, limit.least),
            ("max_mean", "greatest mean", found.greatest_mean, limit.greatest_mean),
            ("min_mean", "least mean", found.least_mean, limit.least_mean),
        ] {
            let name = format!("{key}_{end}");
            rows.push(DensityRow {
                name: format!("{of}, {words}"),
                measured_mm,
                limit_mm,
                violated: dense.violated.iter().any(|violated| violated.name == name),
            });
        }
    }
    rows
}
