//! Scales of slides: reference pulses per metre, and what an interpolator inserts between them
//! (`docs/mathematics/gearbox.md#pulses-between-lines`).

use schemars::{JsonSchema, Schema, json_schema};
use serde::{Deserialize, Serialize};

/// The scale of the feed slide and the interpolator of its pulses.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ScaleInterpolation {
    /// Reference pulses per metre of feed.
    #[schemars(schema_with = "scale_pulses_schema")]
    pub pulses_per_metre: f64,
    /// Clock of the interpolator; one tick is one period of it.
    #[serde(default = "default_clock")]
    #[schemars(schema_with = "clock_schema")]
    pub clock_hz: f64,
    /// Pulses per reference interval, the reference pulse included.
    #[serde(default = "default_pulses_per_interval")]
    #[schemars(schema_with = "pulses_per_interval_schema")]
    pub pulses_per_interval: u32,
    /// How the pulses that are still missing at the end of an interval are counted.
    #[serde(default)]
    pub mode: InterpolationMode,
    /// Content at which the period counter stops.
    #[serde(default = "default_counter_limit")]
    #[schemars(extend("minimum" = 1, "maximum" = 4_294_967_295_u32,
        "x-way-out" = "leave it out for a counter of 24 bits, 16777215"))]
    pub counter_limit: u32,
}

impl ScaleInterpolation {
    /// Distance of two reference pulses, p = 1000/pulses_per_metre, mm.
    pub fn pitch_mm(&self) -> f64 {
        1e3 / self.pulses_per_metre
    }

    /// Greatest speed of the feed, mm/s: from there on an interval has fewer ticks than pulses, v_max = f1 p/P
    /// (`docs/mathematics/gearbox.md#pulses-between-lines`).
    pub fn greatest_speed_mm_per_s(&self) -> f64 {
        self.clock_hz * self.pitch_mm() / f64::from(self.pulses_per_interval)
    }
}

/// The scale of the slide that shifts the worm.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ShiftScale {
    /// Pulses per metre of shift.
    #[schemars(schema_with = "scale_pulses_schema")]
    pub pulses_per_metre: f64,
}

/// How corrections of an ended interval are counted, and in which sense they run.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum InterpolationMode {
    /// Every reference pulse brings as many pulses of its own sense: for grinding in one direction.
    OneWay,
    /// At a reversal the inserted pulses are taken back: both directions give the same position.
    #[default]
    NoBacklash,
    /// The circuit as printed in its source, which loses pulses at quick reversals: to show that effect only.
    Literal,
}

fn default_clock() -> f64 {
    1e6
}

fn default_pulses_per_interval() -> u32 {
    16
}

fn default_counter_limit() -> u32 {
    16_777_215
}

/// Pulses of a scale: pitches from 1 nm to 1 m.
pub fn scale_pulses_schema(_: &mut schemars::SchemaGenerator) -> Schema {
    json_schema!({
        "type": "number", "exclusiveMinimum": 0, "maximum": 1e9,
        "x-way-out": "give the pulses per metre of the scale, e.g. 100000 for a pitch of 10 um"
    })
}

/// The range of the clock.
pub fn clock_schema(_: &mut schemars::SchemaGenerator) -> Schema {
    json_schema!({
        "type": "number", "exclusiveMinimum": 0, "maximum": 1e9,
        "x-way-out": "give the clock of the interpolator in Hz, e.g. 1e6"
    })
}

/// The range of the pulses of an interval.
pub fn pulses_per_interval_schema(_: &mut schemars::SchemaGenerator) -> Schema {
    json_schema!({
        "type": "integer", "minimum": 2, "maximum": 256,
        "x-way-out": "give the pulses per reference interval, the reference pulse included, e.g. 16"
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pitch_and_greatest_speed() {
        let scale: ScaleInterpolation =
            serde_json::from_str(r#"{ "pulses_per_metre": 100000, "pulses_per_interval": 20 }"#).unwrap();
        assert_eq!((scale.clock_hz, scale.counter_limit), (1e6, (1 << 24) - 1));
        assert_eq!(scale.mode, InterpolationMode::NoBacklash);
        assert_eq!(scale.pitch_mm(), 0.01);
        assert_eq!(scale.greatest_speed_mm_per_s(), 500.0);
    }
}
