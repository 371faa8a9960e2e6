//! `[target]` of five-axis milling: the wanted flank.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use job::tables::{Modification, default_tolerance};

/// The wanted flank; without amounts the nominal one.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct MillingTarget {
    /// Largest deviation allowed between target and simulated flank, in um, normal to the flank.
    #[serde(default = "default_tolerance")]
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 1000,
        "x-way-out" = "give the tolerance in micrometres, e.g. 5.0"))]
    pub tolerance_um: f64,
    /// Modifications of a gear or bevel gear that add up; amounts are transverse, positive = material removed. Of a bevel gear lengths of
    /// roll are those in the middle of the face, and positions count from there along the pitch cone, the heel at the upper end.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub modifications: Option<Vec<Modification>>,
    /// Ease-off of a bevel gear, beside its modifications.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub ease_off: Option<EaseOffAmounts>,
}

impl Default for MillingTarget {
    fn default() -> Self {
        Self { tolerance_um: default_tolerance(), modifications: None, ease_off: None }
    }
}

/// Material removed from a bevel flank, um, normal to it: of X = (R - R_m)/(b/2) along the tooth and Y from -1 at the root to 1 at
/// the tip.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct EaseOffAmounts {
    /// Of X^2: at both ends of the tooth.
    #[schemars(extend("minimum" = -1000, "maximum" = 1000, "x-way-out" = "give the amount in micrometres"))]
    pub lengthwise_um: f64,
    /// Of Y^2: at root and tip.
    #[schemars(extend("minimum" = -1000, "maximum" = 1000, "x-way-out" = "give the amount in micrometres"))]
    pub profile_um: f64,
    /// Of X Y: at the corners heel tip and toe root; as much is left at the other two.
    #[schemars(extend("minimum" = -1000, "maximum" = 1000, "x-way-out" = "give the amount in micrometres"))]
    pub bias_um: f64,
}
