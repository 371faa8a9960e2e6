//! Ruled blades on a conical hub (`docs/mathematics/milling.md#flanks-as-patches`).

use super::super::given::Checked;
use foundation::geometry::{BladeData, NormalSide, RuledBlade};
use milling::{ActiveFlank, FootOnHub, HeightLimits};
use serde::Deserialize;
use std::sync::Arc;

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct BladeInput {
    r_hub0: f64,
    r_hub1: f64,
    r_tip: f64,
    length: f64,
    th0: f64,
    th1: f64,
    dth_tip0: f64,
    dth_tip1: f64,
    side: f64,
}

/// Shares of the way from hub to tip between which a blade is milled.
const HEIGHTS: [f64; 2] = [0.05, 1.0];

impl BladeInput {
    /// The flank and the guide curve at its foot.
    pub fn case(&self) -> Checked<(ActiveFlank, FootOnHub)> {
        let side = match self.side {
            1.0 => NormalSide::Along,
            -1.0 => NormalSide::Against,
            _ => return Err("side: +1 or -1 is needed here".into()),
        };
        let blade = RuledBlade::of_data(&BladeData {
            hub_radius: [self.r_hub0, self.r_hub1],
            tip_radius: self.r_tip,
            length: self.length,
            hub_azimuth: [self.th0, self.th1],
            tip_lead: [self.dth_tip0, self.dth_tip1],
            side,
        })?;
        let lead = FootOnHub { curve: blade.hub().clone() };
        let heights = HeightLimits::Constant(HEIGHTS);
        Ok((ActiveFlank { surface: Arc::new(blade), heights, face: [0.0, 1.0], kink: None }, lead))
    }
}
