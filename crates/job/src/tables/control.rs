//! `[control]`: the control that couples the axes while the gear is ground.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::control::{ScaleInterpolation, Servo, ShiftScale, WorkpieceEncoder, WormEncoder};

/// The control that couples the axes: what its pulses, its coefficients and its servo leave on the flank is added to the result.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Control {
    /// Scale of the feed slide and interpolation of its pulses.
    pub feed: ScaleInterpolation,
    /// Encoder of the workpiece spindle.
    pub workpiece: WorkpieceEncoder,
    /// Encoder of the worm spindle.
    pub worm: WormEncoder,
    /// Scale of the slide that shifts the worm; without one the shift is taken as exact.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub shift: Option<ShiftScale>,
    /// Servo of the workpiece spindle.
    pub servo: Servo,
    /// In which senses of the feed the flank is ground: in one, or by a stroke there and one back, the deeper of which stays.
    #[serde(default, skip_serializing_if = "FeedSenses::is_one")]
    pub feed_senses: FeedSenses,
    /// Speed of the worm while it grinds, 1/min; default by the cutting speed of the machine.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 100_000, "x-way-out" = "give the speed of the worm in 1/min, e.g. 3000, or leave it out"))]
    pub worm_speed_rpm: Option<f64>,
}

/// Senses of the feed in which strokes grind.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum FeedSenses {
    /// All strokes run in one sense.
    #[default]
    One,
    /// A stroke there and one back, without centring the workpiece anew.
    Both,
}

impl FeedSenses {
    fn is_one(&self) -> bool {
        *self == Self::One
    }
}
