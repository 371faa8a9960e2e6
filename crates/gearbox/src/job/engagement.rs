//! `[engagement]` of the electronic gearbox: the workpiece is brought up to the speed of its running worm and into the gap
//! (`docs/mathematics/gearbox.md#engagement`).

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// How the workpiece comes into the gap of the running worm before the motion.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct GearboxEngagement {
    /// Greatest speed of the move into the gap, on top of the coupling.
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 1e6,
        "x-way-out" = "give the speed of the move into the gap in degrees a second, e.g. 90.0"))]
    pub phase_speed_deg_per_s: f64,
    /// Greatest acceleration of the workpiece.
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 1e8,
        "x-way-out" = "give the acceleration of the workpiece in degrees a second squared, e.g. 3600.0"))]
    pub acceleration_deg_per_s2: f64,
    /// Where a tooth space stands while the worm is at its zero, against where the workpiece stands at the beginning.
    #[serde(default)]
    #[schemars(extend("minimum" = -360, "maximum" = 360,
        "x-way-out" = "give the angle of a tooth space in degrees, or leave it out"))]
    pub gap_deg: f64,
    /// Cycle in which the gearbox reads its counters.
    #[serde(default = "default_cycle")]
    #[schemars(extend("minimum" = 1, "maximum" = 100_000,
        "x-way-out" = "give the cycle of the gearbox in microseconds, e.g. 1000"))]
    pub cycle_us: f64,
    /// Width of the counter of the worm, which wraps.
    #[serde(default = "default_bits")]
    #[schemars(extend("minimum" = 2, "maximum" = 63, "x-way-out" = "give the bits of the counter, e.g. 16"))]
    pub counter_bits: u32,
}

fn default_cycle() -> f64 {
    1000.0
}

fn default_bits() -> u32 {
    32
}
