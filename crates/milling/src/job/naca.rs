//! `blade.naca`: blades of NACA four-digit sections, computed from their formula (`docs/mathematics/milling.md#flanks-as-patches`).

use super::blade::BladeSide;
use super::pair_schema;
use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::{Deserialize, Serialize};

/// Sections at hub and tip, each given by four digits, between them linear over the height. The chord's middle stands at the middle of the
/// hub's length, z = 0 is where the section at the hub begins. Lengths in mm.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct NacaBlade {
    /// Sections at hub and tip: greatest camber in percent of the chord, its place in tenths, greatest thickness in percent.
    #[schemars(schema_with = "sections_schema")]
    pub sections: [String; 2],
    /// Chords at hub and tip.
    #[schemars(schema_with = "chord_schema")]
    pub chord: [f64; 2],
    /// Stagger at hub and tip: angle of the chord to the axis, counter-clockwise seen from +z towards the trailing edge, degrees.
    #[schemars(schema_with = "stagger_schema")]
    pub stagger_deg: [f64; 2],
    /// Radius at which the blade ends.
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 10_000, "x-way-out" = "give the radius at the blade's tip in mm"))]
    pub tip_radius: f64,
    /// The surface that is milled.
    pub side: NacaSide,
    /// Share of the chord that is left out at leading and trailing edge, which are other passes' work.
    #[serde(default = "default_edge")]
    #[schemars(extend("minimum" = 0.005, "maximum" = 0.3, "x-way-out" = "give a share of the chord; 0.05 is the default"))]
    pub edge: f64,
}

/// Surface of a section.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum NacaSide {
    /// The suction side of a cambered section.
    Upper,
    /// The pressure side.
    Lower,
}

/// Shares of the chord: m, p, t.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FourDigits {
    /// Greatest camber.
    pub camber: f64,
    /// Where it is.
    pub place: f64,
    /// Greatest thickness.
    pub thickness: f64,
}

impl NacaSide {
    /// As the side of a blade: towards the tip times along the row points out of the lower surface.
    pub fn side(self) -> BladeSide {
        match self {
            Self::Upper => BladeSide::Right,
            Self::Lower => BladeSide::Left,
        }
    }
}

impl FourDigits {
    /// From four digits; `None` for other texts, a camber without a place, a place without a camber, and no thickness.
    pub fn new(text: &str) -> Option<Self> {
        let digits: Vec<u32> = text.chars().map(|c| c.to_digit(10)).collect::<Option<_>>()?;
        let [camber, place, tens, ones] = digits[..] else { return None };
        let thickness = 10 * tens + ones;
        if thickness == 0 || (camber == 0) != (place == 0) {
            return None;
        }
        Some(Self {
            camber: f64::from(camber) / 100.0,
            place: f64::from(place) / 10.0,
            thickness: f64::from(thickness) / 100.0,
        })
    }

    /// Point of a surface (upper +1, lower -1) at a share of the chord: along the chord and across it, shares of the chord. The trailing edge
    /// is as thick as the formula has it.
    pub fn point(&self, x: f64, sense: f64) -> [f64; 2] {
        let Self { camber: m, place: p, thickness: t } = *self;
        let half = 5.0 * t * (0.2969 * x.sqrt() + x * (-0.1260 + x * (-0.3516 + x * (0.2843 - 0.1015 * x))));
        let (line, slope) = if m == 0.0 {
            (0.0, 0.0)
        } else if x < p {
            (m / (p * p) * (2.0 * p * x - x * x), 2.0 * m / (p * p) * (p - x))
        } else {
            let behind = (1.0 - p) * (1.0 - p);
            (m / behind * (1.0 - 2.0 * p + 2.0 * p * x - x * x), 2.0 * m / behind * (p - x))
        };
        let (sin, cos) = slope.atan().sin_cos();
        [x - sense * half * sin, line + sense * half * cos]
    }
}

fn sections_schema(_: &mut SchemaGenerator) -> Schema {
    json_schema!({
        "type": "array",
        "items": { "type": "string", "minLength": 4, "maxLength": 4, "x-way-out": "give four digits, e.g. \"4412\"" },
        "minItems": 2,
        "maxItems": 2
    })
}

fn chord_schema(_: &mut SchemaGenerator) -> Schema {
    pair_schema(1e-3, 5000.0, "give the chords at hub and tip in mm")
}

fn stagger_schema(_: &mut SchemaGenerator) -> Schema {
    pair_schema(-80.0, 80.0, "give the angles at hub and tip in degrees")
}

fn default_edge() -> f64 {
    0.05
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn four_digits_say_camber_place_and_thickness() {
        let section = FourDigits::new("2412").unwrap();
        assert_eq!(section, FourDigits { camber: 0.02, place: 0.4, thickness: 0.12 });
        for wrong in ["", "241", "24123", "24a2", "2012", "0412", "2400"] {
            assert_eq!(FourDigits::new(wrong), None, "{wrong}");
        }
        // Ordinates of NACA 0012 as tables have them, in percent of the chord: at 30 % the greatest, 6.002; at 5 % 3.555; at 90 % 1.448.
        let symmetric = FourDigits::new("0012").unwrap();
        for (x, y) in [(0.3, 6.002), (0.05, 3.555), (0.9, 1.448)] {
            for sense in [1.0, -1.0] {
                let [along, across] = symmetric.point(x, sense);
                assert!(along == x && (100.0 * across - sense * y).abs() < 1e-3, "{x}: {across}");
            }
        }
        // Of NACA 2412 at 30 % of the chord line the camber is 1.875 %.
        let [[_, upper], [_, lower]] = [1.0, -1.0].map(|sense| section.point(0.3, sense));
        assert!((50.0 * (upper + lower) - 1.875).abs() < 1e-3);
    }
}
