//! What is to be known of a plan beside its verdict.

use super::out_of_reach::out_of_reach;
use super::referee::RefereedFlank;
use crate::MillingPlan;
use verdict::Remark;

/// Remarks on the flanks of a plan.
pub(super) fn remarks_on_plan(plan: &MillingPlan, refereed: &[RefereedFlank]) -> Vec<Remark> {
    let mut warnings = Vec::new();
    for (flank, rays) in plan.flanks.iter().zip(refereed) {
        if let Some(left) = out_of_reach(flank, rays) {
            warnings.push(Remark {
                code: "middle-out-of-reach",
                text: format!(
                    "{} flank: up to {:.3} mm towards the middle of the gear stay unmilled (row {}), and the root below, because the \
                     cutter meets the other half there; {} of {} rays lie there and are not judged",
                    flank.side,
                    left.length_mm,
                    left.row,
                    left.rays,
                    rays.judged.len()
                ),
                way_out: "give the halves a wider gap, or take a thinner cutter".into(),
            });
        }
        for limit in &flank.lines.dense.violated {
            warnings.push(Remark {
                code: "density-infeasible",
                text: format!(
                    "{} flank: {} = {} mm cannot be kept together with the upper limits, it is {:.4} mm",
                    flank.side, limit.name, limit.limit, limit.measured
                ),
                way_out: "relax this limit or the upper ones".into(),
            });
        }
        let limited: Vec<String> = flank
            .rows
            .iter()
            .enumerate()
            .filter(|(_, row)| row.limited)
            .map(|(n, _)| n.to_string())
            .collect();
        if !limited.is_empty() {
            warnings.push(Remark {
                code: "contact-height-limited",
                text: format!(
                    "{} flank, rows {}: contact height changed; limited by root or hub, cutting edge or opposite flank",
                    flank.side,
                    limited.join(", ")
                ),
                way_out: "see the contact heights in the result, or give others".into(),
            });
        }
    }
    warnings
}
