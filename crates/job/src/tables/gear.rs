//! `[gear]`: the workpiece from drawing data.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::choices::Hand;
use super::one_or_sides::{OneOrSides, pressure_angle_schema};

/// Drawing data of the workpiece. Lengths in mm.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Gear {
    /// Number of teeth; negative for an internal gear.
    #[schemars(extend("minimum" = -2000, "maximum" = 2000, "not" = {"const": 0},
        "x-way-out" = "give the number of teeth of the drawing; negative for an internal gear"))]
    pub teeth: i32,
    /// Normal module.
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 100,
        "x-way-out" = "give the normal module of the drawing in mm"))]
    pub normal_module: f64,
    /// Normal pressure angle in degrees.
    #[schemars(schema_with = "pressure_angle_schema")]
    pub normal_pressure_angle_deg: OneOrSides<f64>,
    /// Helix angle at the pitch cylinder in degrees, positive for a right-hand gear.
    #[schemars(extend("exclusiveMinimum" = -90, "exclusiveMaximum" = 90,
        "x-way-out" = "give the helix angle in degrees: 0 for a spur gear, > 0 right-hand, < 0 left-hand"))]
    pub helix_angle_deg: f64,
    /// Profile shift coefficient x. Tooth thickness is given by this or by one of `normal_tooth_thickness`, `span`,
    /// `over_balls`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("minimum" = -20, "maximum" = 20,
        "x-way-out" = "the profile shift is a coefficient (length divided by the module), not a length"))]
    pub profile_shift: Option<f64>,
    /// Normal tooth thickness at the pitch cylinder.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 1000,
        "x-way-out" = "give the normal tooth thickness in mm, near 1.57 normal modules"))]
    pub normal_tooth_thickness: Option<f64>,
    /// Span measurement.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub span: Option<Span>,
    /// Measurement over (internal: between) balls.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub over_balls: Option<OverBalls>,
    /// Allowances of the tooth thickness, by the measure that gives it: of the span, of the size over balls, else of the normal tooth thickness.
    /// Teeth are made in the middle between both limits; default none.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub allowances_um: Option<Allowances>,
    /// How the tooth thickness is measured; what is absent is chosen so that it touches the middle of the flank.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub measured_over: Option<MeasuredOver>,
    /// Flank tolerance class of ISO 1328-1:2013: `check` lists its tolerances, `inspect` judges a measured gear by it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("minimum" = 1, "maximum" = 11, "x-way-out" = "give a class of ISO 1328-1:2013, 1 to 11"))]
    pub tolerance_class: Option<i32>,
    /// Face width.
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 5000, "x-way-out" = "give the face width in mm"))]
    pub face_width: f64,
    /// Tip diameter.
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 20000, "x-way-out" = "give the tip diameter in mm"))]
    pub tip_diameter: f64,
    /// Root diameter.
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 20000, "x-way-out" = "give the root diameter in mm"))]
    pub root_diameter: f64,
    /// Root form diameter, where the involute begins; default `evaluation.start_diameter`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 20000, "x-way-out" = "give the root form diameter in mm"))]
    pub form_diameter: Option<f64>,
    /// Cone angle in degrees; 0 for a cylindrical gear, positive: thinner towards +z.
    #[serde(default)]
    #[schemars(extend("exclusiveMinimum" = -90, "exclusiveMaximum" = 90,
        "x-way-out" = "leave the cone angle out for a cylindrical gear"))]
    pub cone_angle_deg: f64,
    /// Field on which the flank is evaluated.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub evaluation: Option<Evaluation>,
}

/// Span measurement (base tangent length).
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Span {
    /// Teeth (internal gear: spaces) spanned.
    #[schemars(extend("minimum" = 1, "maximum" = 2000, "x-way-out" = "give the number of teeth spanned"))]
    pub teeth: u32,
    /// Length in mm.
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 20000, "x-way-out" = "give the span in mm"))]
    pub length: f64,
}

/// Measurement over balls.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct OverBalls {
    /// Ball diameter in mm.
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 1000, "x-way-out" = "give the ball diameter in mm"))]
    pub ball: f64,
    /// Diametral size over (internal: between) balls in mm.
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 20000, "x-way-out" = "give the size over balls in mm"))]
    pub size: f64,
}

/// Lower and upper allowance of a measure of the tooth thickness.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Allowances {
    /// Lower allowance, um.
    #[schemars(extend("minimum" = -5000, "maximum" = 5000, "x-way-out" = "give the lower allowance in um, e.g. -90"))]
    pub lower: f64,
    /// Upper allowance, um.
    #[schemars(extend("minimum" = -5000, "maximum" = 5000, "x-way-out" = "give the upper allowance in um, e.g. -50"))]
    pub upper: f64,
}

impl Allowances {
    /// Between both, um.
    pub fn middle(&self) -> f64 {
        0.5 * (self.lower + self.upper)
    }
}

/// What the tooth thickness is measured over.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct MeasuredOver {
    /// Teeth (internal gear: spaces) spanned; default those of `span`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("minimum" = 1, "maximum" = 2000, "x-way-out" = "give the number of teeth spanned"))]
    pub span_teeth: Option<u32>,
    /// Diameter of the balls in mm; default that of `over_balls`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 1000, "x-way-out" = "give the diameter of the balls in mm"))]
    pub ball_diameter: Option<f64>,
    /// Diameter of the rolls in mm; without it no size over rolls is listed.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 1000, "x-way-out" = "give the diameter of the rolls in mm"))]
    pub roll_diameter: Option<f64>,
}

/// Field on which the flank is evaluated; what is absent follows from the gear.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Evaluation {
    /// Diameter at the root end of the evaluated profile; default the form diameter.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 20000,
        "x-way-out" = "leave it out to begin at the form diameter"))]
    pub start_diameter: Option<f64>,
    /// Diameter at the tip end of the evaluated profile; default the tip diameter.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 20000,
        "x-way-out" = "leave it out to end at the tip diameter"))]
    pub end_diameter: Option<f64>,
    /// Lower end along the face width, z = 0 in its middle; default the lower face.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("minimum" = -2500, "maximum" = 2500, "x-way-out" = "leave it out to begin at the face"))]
    pub z_start: Option<f64>,
    /// Upper end along the face width; default the upper face.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("minimum" = -2500, "maximum" = 2500, "x-way-out" = "leave it out to end at the face"))]
    pub z_end: Option<f64>,
}

/// The evaluation field with all defaults filled in. Lengths in mm.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct EvaluationRange {
    /// Diameter at the root end of the evaluated profile.
    pub start_diameter: f64,
    /// Diameter at the tip end of the evaluated profile.
    pub end_diameter: f64,
    /// Lower end along the face width.
    pub z_start: f64,
    /// Upper end along the face width.
    pub z_end: f64,
}

impl Gear {
    /// Hand of a worm for which the job gives none: that of the gear (spur: right).
    pub fn default_worm_hand(&self) -> Hand {
        if self.helix_angle_deg < 0.0 { Hand::Left } else { Hand::Right }
    }

    /// Root form diameter in mm: as given, else the start of the evaluation. A checked job has one of them; the
    /// root diameter stands in only for jobs built in code without either.
    pub fn root_form_diameter(&self) -> f64 {
        let start = self.evaluation.and_then(|e| e.start_diameter);
        self.form_diameter.or(start).unwrap_or(self.root_diameter)
    }

    /// The evaluation field with its defaults: form to tip diameter, face to face.
    pub fn evaluation_range(&self) -> EvaluationRange {
        let given = self.evaluation.unwrap_or_default();
        EvaluationRange {
            start_diameter: given.start_diameter.unwrap_or_else(|| self.root_form_diameter()),
            end_diameter: given.end_diameter.unwrap_or(self.tip_diameter),
            z_start: given.z_start.unwrap_or(-self.face_width / 2.0),
            z_end: given.z_end.unwrap_or(self.face_width / 2.0),
        }
    }
}
