//! A number that changes over the width of the worm.

use dressing::{MOST_COEFFICIENTS, WidthLaw};
use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::{Deserialize, Serialize};

/// One number, or the coefficients of q^k, k = 0, 1, .., where q runs from -1 to 1 over a width: of the worm in use, or of the evaluated face.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(untagged)]
pub enum OverWidth {
    /// The same everywhere.
    Constant(f64),
    /// Coefficients.
    Coefficients(Vec<f64>),
}

/// Places over the width at which the range of a law is looked at.
const PLACES: usize = 41;

impl OverWidth {
    /// The law, times `unit`.
    pub fn law(&self, unit: f64) -> WidthLaw {
        match self {
            Self::Constant(value) => WidthLaw::constant(value * unit),
            // The schema allows no more coefficients than a law has.
            Self::Coefficients(given) => {
                WidthLaw::new(given).unwrap_or(WidthLaw::constant(f64::NAN)).times(unit)
            }
        }
    }

    /// The value farthest beyond a range over the width, if there is one.
    pub fn beyond(&self, [least, most]: [f64; 2]) -> Option<f64> {
        let law = self.law(1.0);
        let values = (0..PLACES).map(|k| law.value(2.0 * k as f64 / (PLACES - 1) as f64 - 1.0));
        let excess = |x: f64| (least - x).max(x - most);
        values.filter(|&x| excess(x) > 0.0 || x.is_nan()).max_by(|a, b| excess(*a).total_cmp(&excess(*b)))
    }

    fn schema(least: f64, most: f64, way_out: &str) -> Schema {
        let number = |least: f64| json_schema!({ "type": "number", "minimum": least, "maximum": most, "x-way-out": way_out });
        let (value, coefficient) = (number(least), number(-most));
        json_schema!({
            "anyOf": [value, { "type": "array", "items": coefficient, "minItems": 1, "maxItems": MOST_COEFFICIENTS }]
        })
    }
}

/// Least and largest share of a profile.
pub(super) const SHARES: [f64; 2] = [-0.5, 1.5];
/// Least and largest stretch, per cent.
pub(super) const STRETCHES: [f64; 2] = [-50.0, 50.0];

pub(super) fn share(_: &mut SchemaGenerator) -> Schema {
    let [least, most] = SHARES;
    OverWidth::schema(
        least,
        most,
        "give a share of the used profile, 0 at w_NfS and 1 at w_NaS, or a list of coefficients of q^k",
    )
}

pub(super) fn stretch(_: &mut SchemaGenerator) -> Schema {
    let [least, most] = STRETCHES;
    OverWidth::schema(
        least,
        most,
        "give the stretch in per cent of the profile, e.g. 0, or a list of coefficients over the width",
    )
}

pub(super) fn micrometres(_: &mut SchemaGenerator) -> Schema {
    OverWidth::schema(-1000.0, 1000.0, "give a height in um, or a list of coefficients over the width")
}

pub(super) fn correction(_: &mut SchemaGenerator) -> Schema {
    OverWidth::schema(
        -100.0,
        100.0,
        "give the correction, e.g. 0.1, or a list of coefficients over the width",
    )
}

/// The weight of a condition that is met as nearly as possible.
pub(super) fn weight(_: &mut SchemaGenerator) -> Schema {
    json_schema!({ "type": "number", "exclusiveMinimum": 0, "maximum": 1000,
        "x-way-out": "give a weight above 0, e.g. 1, or leave it out for a condition that is met exactly" })
}

impl JsonSchema for OverWidth {
    fn schema_name() -> std::borrow::Cow<'static, str> {
        "OverWidth".into()
    }

    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        correction(generator)
    }
}
