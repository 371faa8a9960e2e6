//! A motion of the feed slide, move by move: a travel with constant acceleration, speed and deceleration, or a dwell.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A part of a motion of the feed slide.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(untagged)]
pub enum Move {
    /// From where the slide stands to another position, at rest at both ends.
    Travel(Travel),
    /// The slide stands still.
    Dwell(Dwell),
}

/// A travel of the slide from rest to rest. Lengths in mm.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Travel {
    /// Position at the end.
    #[schemars(extend("minimum" = -1e5, "maximum" = 1e5, "x-way-out" = "give the position at the end of the travel in mm"))]
    pub to: f64,
    /// Speed between acceleration and deceleration, mm/min.
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 1e7, "x-way-out" = "give the speed in mm/min, e.g. 300"))]
    pub speed_mm_per_min: f64,
    /// Acceleration and deceleration, mm/s^2.
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 1e7, "x-way-out" = "give the acceleration in mm/s^2, e.g. 200"))]
    pub acceleration_mm_per_s2: f64,
}

/// Standstill of the slide.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Dwell {
    /// How long, s.
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 86_400, "x-way-out" = "give the time in s, more than 0"))]
    pub dwell_s: f64,
}

impl Travel {
    /// Time of the travel from a position in mm, s. Short travels never reach the speed.
    pub fn duration_s(&self, from: f64) -> f64 {
        let distance = (self.to - from).abs();
        let speed = self.speed_mm_per_min / 60.0;
        let acceleration = self.acceleration_mm_per_s2;
        if distance * acceleration >= speed * speed {
            distance / speed + speed / acceleration
        } else {
            2.0 * (distance / acceleration).sqrt()
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn travels_with_and_without_constant_speed() {
        let travel = Travel { to: -1.0, speed_mm_per_min: 300.0, acceleration_mm_per_s2: 10.0 };
        // 5 mm/s are reached after 1.25 mm: up and down need 2.5 mm.
        assert!((travel.duration_s(9.0) - (10.0 / 5.0 + 0.5)).abs() < 1e-15);
        assert!((travel.duration_s(1.5) - 1.0).abs() < 1e-15);
        assert!((travel.duration_s(-1.4) - 0.4).abs() < 1e-15);
    }
}
