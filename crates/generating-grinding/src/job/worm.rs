//! `[worm]`: the grinding worm.

use schemars::{JsonSchema, Schema, json_schema};
use serde::{Deserialize, Serialize};

use job::tables::{Hand, Modification, OneOrSides, one_or_sides_schema, pressure_angle_schema};

/// The grinding worm. At least one of the two diameters is needed. Lengths in mm.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Worm {
    /// Number of threads.
    #[schemars(extend("minimum" = 1, "maximum" = 100, "x-way-out" = "give the number of threads of the worm, 1 or more"))]
    pub threads: u32,
    /// Hand of the threads; default the hand of the gear (spur: right).
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub hand: Option<Hand>,
    /// Pitch diameter; default tip diameter less 2.5 normal modules.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 2000, "x-way-out" = "give the pitch diameter of the worm in mm"))]
    pub pitch_diameter: Option<f64>,
    /// Tip diameter; default pitch diameter plus 2.5 normal modules.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 2000, "x-way-out" = "give the tip diameter of the worm in mm"))]
    pub tip_diameter: Option<f64>,
    /// Normal pressure angle in degrees; default that of the gear.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(schema_with = "pressure_angle_schema")]
    pub normal_pressure_angle_deg: Option<OneOrSides<f64>>,
    /// Profile shift coefficient of the worm.
    #[serde(default)]
    #[schemars(extend("minimum" = -20, "maximum" = 20, "x-way-out" = "leave it out: the gear's shift goes into the centre distance"))]
    pub profile_shift: f64,
    /// Usable width along the axis; without it the width needed is reported.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 2000,
        "x-way-out" = "give the usable width of the worm in mm, or leave it out"))]
    pub width: Option<f64>,
    /// Cone angle in degrees; 0 for a cylindrical worm.
    #[serde(default)]
    #[schemars(extend("exclusiveMinimum" = -90, "exclusiveMaximum" = 90,
        "x-way-out" = "leave the cone angle out for a cylindrical worm"))]
    pub cone_angle_deg: f64,
    /// How the tool gets its flanks.
    #[serde(default, skip_serializing_if = "Tool::is_default")]
    pub tool: Tool,
    /// Form of the flanks of a tool that exists, before its modifications; every other tool is an involute worm.
    #[serde(default, skip_serializing_if = "FlankForm::is_default")]
    pub flank_form: FlankForm,
    /// Diameter of the disc with straight sides that made a ZK worm, where it touches the worm's pitch cylinder.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 2000,
        "x-way-out" = "give the diameter of the disc in mm, where it touches the worm's pitch cylinder"))]
    pub form_disc_diameter: Option<f64>,
    /// What the flanks of the tool carry: f over its length of roll w_1 and axial position z_1, transverse,
    /// positive = material of the tool. Kinds polynomial, grid, points, formula. A given tool has it, left out: plain flanks; a dressed
    /// worm is to get it in place of a target, and the gear follows.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub modifications: Option<Vec<Modification>>,
    /// Direction rho_1 of the lines along which the tool's modification is constant, degrees, w_1 sin rho_1 + z_1 cos rho_1
    /// = constant; default the generatrix.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(schema_with = "direction_schema")]
    pub direction_deg: Option<OneOrSides<f64>>,
}

impl Worm {
    /// What stands for the table of a job that has a catalogue in its place: without data of a worm.
    pub fn absent() -> Self {
        Self {
            threads: 0,
            hand: None,
            pitch_diameter: None,
            tip_diameter: None,
            normal_pressure_angle_deg: None,
            profile_shift: 0.0,
            width: None,
            cone_angle_deg: 0.0,
            tool: Tool::Dressed,
            flank_form: FlankForm::Zi,
            form_disc_diameter: None,
            modifications: None,
            direction_deg: None,
        }
    }

    /// Whether the job says nothing of a worm; every worm has threads.
    pub fn is_absent(&self) -> bool {
        self.threads == 0
    }
}

/// How the tool gets its flanks.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Tool {
    /// The `[dresser]` profiles it.
    #[default]
    Dressed,
    /// It exists and carries `modifications`.
    Given,
    /// It is made as the plan computes it, any flank: plated worm, shaving or honing tool.
    Made,
}

impl Tool {
    /// The word in job files.
    pub fn name(self) -> &'static str {
        match self {
            Tool::Dressed => "dressed",
            Tool::Given => "given",
            Tool::Made => "made",
        }
    }

    fn is_default(&self) -> bool {
        *self == Self::default()
    }
}

/// Form of a worm's flanks, by the letters of ISO 10828.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "UPPERCASE")]
pub enum FlankForm {
    /// Involute helicoids.
    #[default]
    Zi,
    /// Straight in the axial section.
    Za,
    /// Straight in the normal section of the space.
    Zn,
    /// Made by a disc with straight sides that stands in the space under the lead angle.
    Zk,
}

impl FlankForm {
    /// The letters in job files.
    pub fn name(self) -> &'static str {
        match self {
            Self::Zi => "ZI",
            Self::Za => "ZA",
            Self::Zn => "ZN",
            Self::Zk => "ZK",
        }
    }

    fn is_default(&self) -> bool {
        *self == Self::default()
    }
}

/// At +-90 degrees the line would be a profile, along which the tool has no other value.
pub(super) fn direction_schema(_: &mut schemars::SchemaGenerator) -> Schema {
    one_or_sides_schema(json_schema!({
        "type": "number",
        "exclusiveMinimum": -90,
        "exclusiveMaximum": 90,
        "x-way-out": "give the direction in degrees between -90 and 90, or leave it out"
    }))
}
