//! What the other half of a double-helical gear keeps the cutter from.

use super::referee::RefereedFlank;
use super::result::OutOfReachResult;
use crate::FlankPlan;

/// The longest row end that is not milled, with the rays that are not judged; nothing where all is reached.
pub(super) fn out_of_reach(plan: &FlankPlan, refereed: &RefereedFlank) -> Option<OutOfReachResult> {
    let lengths = (0..plan.rows.len()).map(|row| (row, plan.unmilled_length(row)));
    let (row, length_mm) = lengths.max_by(|a, b| a.1.total_cmp(&b.1)).filter(|(_, length)| *length > 0.0)?;
    let rays = refereed.judged.iter().filter(|judged| !**judged).count();
    Some(OutOfReachResult { length_mm, row, rays })
}
