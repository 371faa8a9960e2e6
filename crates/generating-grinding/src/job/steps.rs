//! Equidistant values of a study.

use schemars::{Schema, json_schema};
use serde::{Deserialize, Serialize};

/// Equidistant values, both ends included.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Steps {
    /// First value.
    pub from: f64,
    /// Last value.
    pub to: f64,
    /// Number of values.
    pub count: usize,
}

impl Steps {
    /// Values that one study may have in each direction.
    pub const MOST: usize = 10_000;

    /// The values; the ends are met exactly.
    pub fn values(&self) -> impl Iterator<Item = f64> {
        let Self { from, to, count } = *self;
        let last = count.saturating_sub(1);
        (0..count).map(move |i| {
            let share = if last == 0 { 0.0 } else { i as f64 / last as f64 };
            from * (1.0 - share) + to * share
        })
    }

    /// The values of steps that may be absent: `None` for what then stays as it is.
    pub fn each(steps: Option<Self>) -> Vec<Option<f64>> {
        steps.map_or_else(|| vec![None], |steps| steps.values().map(Some).collect())
    }

    /// How many these are.
    pub fn count_of(steps: Option<Self>) -> usize {
        steps.map_or(1, |steps| steps.count)
    }

    /// The schema of steps between two values of the schema `end`.
    pub fn schema(end: Schema) -> Schema {
        json_schema!({
            "type": "object",
            "properties": {
                "from": end,
                "to": end,
                "count": {
                    "type": "integer",
                    "minimum": 2,
                    "maximum": Self::MOST,
                    "x-way-out": "give the number of values, both ends included, e.g. 21"
                }
            },
            "required": ["from", "to", "count"],
            "additionalProperties": false
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn steps_meet_both_ends() {
        let values: Vec<f64> = Steps { from: -0.3, to: 0.7, count: 5 }.values().collect();
        assert_eq!((values[0], values[4], values.len()), (-0.3, 0.7, 5));
        assert!((values[1] + 0.05).abs() < 1e-16);
    }
}
