//! `[explore.dressing]`: what a study of dressing looks at.

use schemars::{JsonSchema, Schema, json_schema};
use serde::{Deserialize, Serialize};

use super::steps::Steps;
use super::stroke_study::{AxisDeviations, StrokeStudy};
use foundation::geometry::Flank;

/// A study of dressing by the three-point method: corrections, axial position and profile stretch.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct DressingStudy {
    /// What runs along the abscissa.
    pub over: StudyOver,
    /// The worm flank that is dressed.
    #[serde(default = "left")]
    pub flank: Flank,
    /// Profile crownings on the gear, um; with `over = "crowning"` the whole producible range without it, with
    /// `over = "profile"` one curve each.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(schema_with = "crowning_steps")]
    pub crowning_um: Option<Steps>,
    /// Pitch diameters of the worm, for `over = "worm-diameter"`; the dresser stays the one of `[worm]` and `[dresser]`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(schema_with = "diameter_steps")]
    pub worm_pitch_diameter: Option<Steps>,
    /// Normal pressure angles of the worm in degrees, for `over = "pressure-angle"`; the dresser stays.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(schema_with = "angle_steps")]
    pub normal_pressure_angle_deg: Option<Steps>,
    /// Pitch diameter of the worms of a study over the pressure angle; without it that of the job's worm.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 2000, "x-way-out" = "give a diameter in mm, or leave it out"))]
    pub at_worm_pitch_diameter: Option<f64>,
    /// Active areas and sections, for `over = "strokes"`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub strokes: Option<StrokeStudy>,
    /// Deviations of the axes, for `over = "deviations"`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub deviations: Option<AxisDeviations>,
    /// Bodies side by side, one curve each.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub compare: Option<Compare>,
}

fn left() -> Flank {
    Flank::Left
}

/// What runs along the abscissa of a dressing study.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum StudyOver {
    /// The profile crowning on the gear, with a dresser made for the worm.
    Crowning,
    /// The length of roll: dressed profile, what each radius of the dresser dresses, contact line.
    Profile,
    /// The pitch diameter of the worm, with a dresser made for the job's worm.
    WormDiameter,
    /// The pressure angle of the worm, with a dresser made for the job's worm.
    PressureAngle,
    /// The length of roll of a profile that is dressed in several strokes.
    Strokes,
    /// The length of roll; what deviations of the axes do to the profile.
    Deviations,
}

impl StudyOver {
    /// The word in job files.
    pub fn name(self) -> &'static str {
        match self {
            Self::Crowning => "crowning",
            Self::Profile => "profile",
            Self::WormDiameter => "worm-diameter",
            Self::PressureAngle => "pressure-angle",
            Self::Strokes => "strokes",
            Self::Deviations => "deviations",
        }
    }

    /// What is studied, in words.
    pub fn words(self) -> &'static str {
        match self {
            Self::Crowning => "profile crowning",
            Self::Profile => "dressed profile",
            Self::WormDiameter | Self::PressureAngle => "dresser on other worms",
            Self::Strokes => "dressing in several strokes",
            Self::Deviations => "deviations of the axes",
        }
    }
}

/// Values of one quantity of the bodies; exactly one key. Lengths in mm.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Compare {
    /// Numbers of threads of the worm.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(schema_with = "threads")]
    pub threads: Option<Vec<u32>>,
    /// Pitch diameters of the worm.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(schema_with = "diameters")]
    pub worm_pitch_diameter: Option<Vec<f64>>,
    /// Tip diameters of the dresser.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(schema_with = "diameters")]
    pub dresser_tip_diameter: Option<Vec<f64>>,
    /// Normal pressure angles of the worm, degrees, the same on both flanks.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(schema_with = "angles")]
    pub normal_pressure_angle_deg: Option<Vec<f64>>,
}

impl Compare {
    /// The keys that are given.
    pub fn given(&self) -> Vec<&'static str> {
        let keys = [
            ("threads", self.threads.is_some()),
            ("worm_pitch_diameter", self.worm_pitch_diameter.is_some()),
            ("dresser_tip_diameter", self.dresser_tip_diameter.is_some()),
            ("normal_pressure_angle_deg", self.normal_pressure_angle_deg.is_some()),
        ];
        keys.iter().filter(|(_, given)| *given).map(|(key, _)| *key).collect()
    }
}

/// Curves that one chart may hold.
const MOST_CURVES: usize = 12;

fn list(item: Schema) -> Schema {
    json_schema!({ "type": "array", "items": item, "minItems": 1, "maxItems": MOST_CURVES, "uniqueItems": true })
}

fn crowning() -> Schema {
    json_schema!({ "type": "number", "minimum": -1000, "maximum": 1000, "x-way-out": "give a profile crowning in um, e.g. 5.0" })
}

fn diameter() -> Schema {
    json_schema!({ "type": "number", "exclusiveMinimum": 0, "maximum": 2000, "x-way-out": "give a diameter in mm" })
}

fn angle() -> Schema {
    json_schema!({ "type": "number", "minimum": 5, "maximum": 45, "x-way-out": "give a pressure angle in degrees, e.g. 20.0" })
}

fn threads(_: &mut schemars::SchemaGenerator) -> Schema {
    list(
        json_schema!({ "type": "integer", "minimum": 1, "maximum": 100, "x-way-out": "give a number of threads" }),
    )
}

fn diameters(_: &mut schemars::SchemaGenerator) -> Schema {
    list(diameter())
}

fn angles(_: &mut schemars::SchemaGenerator) -> Schema {
    list(angle())
}

fn crowning_steps(_: &mut schemars::SchemaGenerator) -> Schema {
    Steps::schema(crowning())
}

fn diameter_steps(_: &mut schemars::SchemaGenerator) -> Schema {
    Steps::schema(diameter())
}

fn angle_steps(_: &mut schemars::SchemaGenerator) -> Schema {
    Steps::schema(angle())
}
