//! Depth of the next grinding of the tool, and when it is due.

use crate::workflow::{BrokenEdge, HistoryResult, ResharpeningResult};
use report::Quantity;

/// Broken edges in the table, the deepest first.
const BROKEN_SHOWN: usize = 6;

/// Depth of the next grinding, and when it is due.
pub(super) fn quantities(depth: &ResharpeningResult, history: Option<&HistoryResult>) -> Vec<Quantity> {
    let mut rows = vec![
        Quantity::number("off the rake faces, along their normal", "", 1e3 * depth.depth_mm, "µm"),
        Quantity::number("the same along the tool's axis", "", 1e3 * depth.axial_depth_mm, "µm"),
    ];
    rows.extend(of_broken(depth));
    let Some(history) = history else { return rows };
    for (flank, trend) in &history.flanks {
        match (trend.limit_at_parts, trend.remaining_parts, &trend.no_forecast) {
            (Some(at), Some(left), _) => {
                let due = if left > 0.0 {
                    format!("at {at:.0} workpieces: {left:.0} are left")
                } else {
                    format!("since {at:.0} workpieces: {:.0} too many", -left)
                };
                rows.push(Quantity::text(&format!("{flank} flank reaches its limit of wear"), due));
            }
            (.., Some(why)) => rows.push(Quantity::text(&format!("{flank} flank"), why.clone())),
            _ => {}
        }
    }
    rows
}

/// What broken edges ask for, which of them by how much, and what the rest alone asks for.
fn of_broken(depth: &ResharpeningResult) -> Vec<Quantity> {
    let mut rows = Vec::new();
    if !depth.broken.is_empty() {
        let alone = &depth.without_broken;
        rows.push(Quantity::number(
            "without the broken edges, along the normal",
            "",
            1e3 * alone.depth_mm,
            "µm",
        ));
        rows.push(Quantity::number("the same along the tool's axis", "", 1e3 * alone.axial_depth_mm, "µm"));
    }
    let mut broken: Vec<&BrokenEdge> = depth.broken.iter().collect();
    broken.sort_by(|a, b| b.depth_mm.total_cmp(&a.depth_mm));
    for edge in broken.iter().take(BROKEN_SHOWN) {
        let text = format!("{:.0} µm missing, at least {:.0} µm off", edge.missing_um, 1e3 * edge.depth_mm);
        rows.push(Quantity::text(&format!("broken: tooth {}, {} edge", edge.tooth, edge.flank), text));
    }
    if let Some(more @ 1..) = broken.len().checked_sub(BROKEN_SHOWN) {
        rows.push(Quantity::text("further broken edges", format!("{more}, in resharpening.csv")));
    }
    if !depth.not_covered.is_empty() {
        let teeth: Vec<String> = depth.not_covered.iter().map(ToString::to_string).collect();
        let text = "no switch: not counted in the depths";
        rows.push(Quantity::text(&format!("tooth {}", teeth.join(", ")), text));
    }
    rows
}
