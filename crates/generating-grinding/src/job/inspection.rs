//! `[inspection]`: how a measured gear is judged and corrected, and what a simulated measurement of it would find.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::measured_gear::SimulatedMeasurement;

/// How a measured gear is judged and what a correction may turn.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Inspection {
    /// Tolerance of a characteristic, um, normal; default `target.tolerance_um`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 1000, "x-way-out" = "give the tolerance in micrometres, e.g. 2.0"))]
    pub tolerance_um: Option<f64>,
    /// Standard uncertainty of the measuring machine's calibration, um.
    #[serde(default)]
    #[schemars(extend("minimum" = 0, "maximum" = 100, "x-way-out" = "give the standard uncertainty of the calibration in micrometres, e.g. 0.3"))]
    pub calibration_um: f64,
    /// Share of the tolerance below which nothing is corrected.
    #[serde(default = "dead_band")]
    #[schemars(extend("minimum" = 0, "maximum" = 1, "x-way-out" = "0.1 is the default"))]
    pub dead_band: f64,
    /// Level of the statistical tests.
    #[serde(default = "level")]
    #[schemars(extend("minimum" = 0.5, "exclusiveMaximum" = 1, "x-way-out" = "0.95 is the default"))]
    pub level: f64,
    /// What a correction may turn; default all.
    #[serde(default = "CorrectionSetting::all")]
    #[schemars(length(min = 1, max = 7))]
    pub settings: Vec<CorrectionSetting>,
    /// How far all corrections together may go.
    #[serde(default)]
    pub limits: CorrectionLimits,
    /// Band in which profiles have to lie (K-chart).
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub profile_band: Option<Band>,
    /// Band in which helix traces have to lie (K-chart).
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub helix_band: Option<Band>,
    /// The measurement that is simulated where no file is given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub simulated: Option<SimulatedMeasurement>,
}

/// What a correction may turn.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum CorrectionSetting {
    /// Centre distance, linear over the feed.
    Taper,
    /// Angle of the workpiece, linear over the feed.
    HelixAngle,
    /// Centre distance, quadratic over the feed.
    Crowning,
    /// Angle of the workpiece, quadratic over the feed.
    OppositeCrowning,
    /// Profile slope of the worm, each flank by itself.
    ProfileSlope,
    /// Profile crowning of the worm, each flank by itself.
    ProfileCrowning,
    /// Twist of the worm, each flank by itself.
    Twist,
}

impl CorrectionSetting {
    fn all() -> Vec<Self> {
        vec![
            Self::Taper,
            Self::HelixAngle,
            Self::Crowning,
            Self::OppositeCrowning,
            Self::ProfileSlope,
            Self::ProfileCrowning,
            Self::Twist,
        ]
    }
}

/// Bounds on the sum of all corrections, each to both sides.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct CorrectionLimits {
    /// Taper and crowning of the centre distance, um.
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 10_000, "x-way-out" = "50 um is the default"))]
    pub radial_feed_um: f64,
    /// Angle of the workpiece, arcsec.
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 36_000, "x-way-out" = "100 arcsec is the default"))]
    pub work_angle_arcsec: f64,
    /// Slope and crowning of the worm's profile, um.
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 1000, "x-way-out" = "20 um is the default"))]
    pub profile_um: f64,
    /// Twist of the worm, um.
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 1000, "x-way-out" = "20 um is the default"))]
    pub twist_um: f64,
}

impl Default for CorrectionLimits {
    fn default() -> Self {
        Self { radial_feed_um: 50.0, work_angle_arcsec: 100.0, profile_um: 20.0, twist_um: 20.0 }
    }
}

/// A band along a trace, relative to the design; straight lines between its places.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Band {
    /// Lengths of roll (profile) or heights z (helix), ascending, mm.
    #[schemars(extend("minItems" = 2, "maxItems" = 1000))]
    pub at_mm: Vec<f64>,
    /// Lower limit, um, positive = material.
    #[schemars(extend("minItems" = 2, "maxItems" = 1000))]
    pub lower_um: Vec<f64>,
    /// Upper limit, um, positive = material.
    #[schemars(extend("minItems" = 2, "maxItems" = 1000))]
    pub upper_um: Vec<f64>,
    /// Where the trace is held, mm; without it the trace may be shifted as a whole.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub held_at_mm: Option<f64>,
}

fn dead_band() -> f64 {
    0.1
}

fn level() -> f64 {
    0.95
}

impl Default for Inspection {
    fn default() -> Self {
        Self {
            tolerance_um: None,
            calibration_um: 0.0,
            dead_band: dead_band(),
            level: level(),
            settings: CorrectionSetting::all(),
            limits: CorrectionLimits::default(),
            profile_band: None,
            helix_band: None,
            simulated: None,
        }
    }
}
