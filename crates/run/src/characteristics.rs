//! Characteristics of a flank as result documents and pages give them.

use metrology::{Characteristics, Topography};
use schemars::JsonSchema;
use serde::Serialize;

/// Characteristics in micrometres, transverse unless the key says `normal`; > 0 material removed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, JsonSchema)]
pub struct CharacteristicsUm {
    /// C_beta.
    pub helix_crowning_um: f64,
    /// C_alpha.
    pub profile_crowning_um: f64,
    /// C_Hbeta: > 0 removes at face II.
    pub helix_slope_um: f64,
    /// C_Halpha: > 0 removes at the tip.
    pub profile_slope_um: f64,
    /// Twist S from the corners.
    pub twist_corner_um: f64,
    /// The same, normal.
    pub twist_corner_normal_um: f64,
    /// Twist S from the bilinear term.
    pub twist_fit_um: f64,
    /// The same, normal.
    pub twist_fit_normal_um: f64,
}

impl CharacteristicsUm {
    /// Of a topography of normal values.
    pub fn of(topography: &Topography, cos_b: f64) -> Self {
        let c = Characteristics::of(topography, cos_b);
        Self {
            helix_crowning_um: c.helix_crowning * 1e3,
            profile_crowning_um: c.profile_crowning * 1e3,
            helix_slope_um: c.helix_slope * 1e3,
            profile_slope_um: c.profile_slope * 1e3,
            twist_corner_um: c.twist_corner * 1e3,
            twist_corner_normal_um: c.twist_corner * 1e3 * cos_b,
            twist_fit_um: c.twist_fit * 1e3,
            twist_fit_normal_um: c.twist_fit * 1e3 * cos_b,
        }
    }
}
