//! `[settings]` of tangential dressing: values of the design variables. `plan` writes it, `simulate` runs it.

use std::collections::BTreeMap;

use schemars::{JsonSchema, Schema, json_schema};
use serde::{Deserialize, Serialize};

use super::channel::Channel;
use super::spline::{SplineValues, coefficient_schema};
use super::variable::{Variable, pattern};
use foundation::geometry::Flank;

/// Values of the variables, for both flanks together or for each; what is not named is 0.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct TangentialSettings {
    /// What holds for both flanks unless the table of a flank says otherwise.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub both: Option<FlankValues>,
    /// The left flank.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub left: Option<FlankValues>,
    /// The right flank.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub right: Option<FlankValues>,
}

/// Values of the variables of a flank.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct FlankValues {
    /// Ratio of the tool shift to the feed; default `grinding.shift_ratio`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("minimum" = -1000, "maximum" = 1000, "x-way-out" = "give a ratio of a few units, or leave it out"))]
    pub kap: Option<f64>,
    /// Coefficients by the names of their variables, mm; of `gA` rad. `FT0` is the whole shift in the middle of the feed;
    /// default `grinding.shift_offset`.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    #[schemars(schema_with = "values_schema")]
    pub values: BTreeMap<Variable, f64>,
    /// Splines beside the powers.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    #[schemars(length(max = 12))]
    pub splines: Vec<SplineValues>,
}

impl TangentialSettings {
    /// The values of one flank: those for both, each replaced by what the table of the flank says of the same variable or of
    /// the spline of the same channel.
    pub fn of_flank(&self, flank: Flank) -> FlankValues {
        let mut values = self.both.clone().unwrap_or_default();
        let own = match flank {
            Flank::Left => &self.left,
            Flank::Right => &self.right,
        };
        if let Some(own) = own {
            values.kap = own.kap.or(values.kap);
            values.values.extend(&own.values);
            values.splines.retain(|spline| own.splines.iter().all(|s| s.channel != spline.channel));
            values.splines.extend(own.splines.iter().cloned());
        }
        values
    }

    /// The tables that are there, each with its key.
    pub fn tables(&self) -> impl Iterator<Item = (&'static str, &FlankValues)> {
        let tables = [("both", &self.both), ("left", &self.left), ("right", &self.right)];
        tables.into_iter().filter_map(|(key, table)| Some((key, table.as_ref()?)))
    }
}

/// The shift ratio is no coefficient and has a key of its own.
fn values_schema(_: &mut schemars::SchemaGenerator) -> Schema {
    json_schema!({
        "type": "object",
        "propertyNames": { "pattern": pattern(|channel| channel != Channel::ShiftRatio) },
        "additionalProperties": coefficient_schema()
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_table_of_a_flank_goes_before_that_of_both() {
        let text = r#"{
            "both": { "kap": 1.2, "values": { "Fp1": 0.1, "dX2": 0.2 },
                "splines": [{ "channel": "dX", "intervals": 1, "coefficients": [1] },
                    { "channel": "dA", "intervals": 1, "coefficients": [2] }] },
            "right": { "values": { "dX2": -0.2 }, "splines": [{ "channel": "dX", "intervals": 2, "coefficients": [3] }] }
        }"#;
        let settings: TangentialSettings = serde_json::from_str(text).unwrap();
        let (left, right) = (settings.of_flank(Flank::Left), settings.of_flank(Flank::Right));
        assert_eq!(Some(&left), settings.both.as_ref());
        assert_eq!(right.kap, Some(1.2));
        let values: Vec<(String, f64)> = right.values.iter().map(|(v, c)| (v.to_string(), *c)).collect();
        assert_eq!(values, [("Fp1".to_owned(), 0.1), ("dX2".to_owned(), -0.2)]);
        let splines: Vec<(Channel, f64)> =
            right.splines.iter().map(|s| (s.channel, s.coefficients[0])).collect();
        assert_eq!(splines, [(Channel::DressingDistance, 2.0), (Channel::AxialOffset, 3.0)]);
    }
}
