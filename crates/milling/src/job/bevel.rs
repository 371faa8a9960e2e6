//! `[bevel]`: a bevel gear, straight or spiral (`docs/mathematics/milling.md#flanks-as-patches`).

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use foundation::geometry::{self, BevelData, LineForm, Spiral};
use job::tables::Hand;

/// Drawing data of a bevel gear whose cones have one apex. Lengths in mm.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct BevelGear {
    /// Transverse module at the outer end.
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 100,
        "x-way-out" = "give the outer transverse module of the drawing in mm"))]
    pub outer_transverse_module: f64,
    /// Number of teeth.
    #[schemars(extend("minimum" = 3, "maximum" = 2000, "x-way-out" = "give the number of teeth of the drawing"))]
    pub teeth: u32,
    /// Angle of the pitch cone, degrees; 90 of a crown gear, whose pitch cone is a plane and whose teeth point towards -z.
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 90,
        "x-way-out" = "give the pitch cone angle of the drawing in degrees"))]
    pub pitch_cone_angle_deg: f64,
    /// Pressure angle, degrees.
    #[serde(default = "default_pressure_angle")]
    #[schemars(extend("minimum" = 5, "maximum" = 45,
        "x-way-out" = "give the pressure angle of the drawing in degrees, e.g. 20.0"))]
    pub pressure_angle_deg: f64,
    /// Width of the teeth along the pitch cone, from its outer end inwards.
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 5000, "x-way-out" = "give the face width in mm"))]
    pub face_width: f64,
    /// Outer addendum over the module.
    #[serde(default = "default_addendum")]
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 5, "x-way-out" = "it is a coefficient; 1 is the default"))]
    pub addendum_factor: f64,
    /// Outer dedendum over the module.
    #[serde(default = "default_dedendum")]
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 5, "x-way-out" = "it is a coefficient; 1.25 is the default"))]
    pub dedendum_factor: f64,
    /// The profile.
    #[serde(default)]
    pub flank: BevelFlank,
    /// Curved and skew teeth; without it the teeth are straight and point to the apex.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub spiral: Option<BevelSpiral>,
    /// Two halves of opposite hand. That at the heel has `spiral`, with its spiral angle in the middle of the half; `face_width` is that of
    /// both with the gap.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub double_helical: Option<DoubleHelicalBevel>,
    /// Angle between the axis and the ray from the apex on which the active flank begins, degrees; default 0.12 of the way from root
    /// or base cone, whichever is wider, to the tip cone.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0, "exclusiveMaximum" = 180,
        "x-way-out" = "give an angle between root cone and tip cone in degrees, or leave it out"))]
    pub start_polar_angle_deg: Option<f64>,
    /// Class of ISO 17485:2006 that its pitches and its run-out have to reach: `inspect` judges a measured gear by it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("minimum" = 2, "maximum" = 11, "x-way-out" = "give a class from 2 to 11, or leave it out"))]
    pub tolerance_class: Option<i32>,
}

/// The halves of a double-helical bevel gear.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct DoubleHelicalBevel {
    /// Where the halves would meet, along the pitch cone from the middle of the face towards the heel; the middle of the gap. mm.
    #[serde(default)]
    #[schemars(extend("minimum" = -5000, "maximum" = 5000, "x-way-out" = "give the position in mm; 0, the middle of the face, is the default"))]
    pub middle: f64,
    /// Width of the gap between the halves, mm; 0: herringbone teeth.
    #[schemars(extend("minimum" = 0, "maximum" = 5000, "x-way-out" = "give the width of the gap in mm; 0 for herringbone teeth"))]
    pub gap: f64,
}

/// Profile of a bevel tooth.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum BevelFlank {
    /// The involute on the sphere.
    #[default]
    SphericalInvolute,
    /// Cut by plane flanks of a crown gear.
    Octoid,
}

/// Teeth that are not straight, by their flank line on the developed pitch cone.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct BevelSpiral {
    /// What the line is.
    #[serde(default)]
    pub line: SpiralLine,
    /// Spiral angle in the middle of the face, degrees.
    #[schemars(extend("minimum" = 0, "maximum" = 70,
        "x-way-out" = "give the mean spiral angle in degrees; its hand stands in `hand`"))]
    pub mean_spiral_angle_deg: f64,
    /// Radius of the cutter head which a circle or an epicycloid comes from, mm.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 5000, "x-way-out" = "give the radius of the cutter in mm"))]
    pub cutter_radius: Option<f64>,
    /// Groups of blades on the head of an epicycloid.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("minimum" = 1, "maximum" = 100, "x-way-out" = "give the number of blade groups of the cutter head, e.g. 5"))]
    pub blade_groups: Option<u32>,
    /// Hand of the spiral.
    pub hand: Hand,
}

/// A flank line on the developed pitch cone.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum SpiralLine {
    /// Face milling, one space after the other.
    #[default]
    Circle,
    /// Face hobbing with a continuously turning gear.
    Epicycloid,
    /// Skew teeth: a straight line beside the apex.
    Skew,
    /// Palloid teeth: an involute.
    Involute,
}

impl SpiralLine {
    /// Whether it comes from a cutter head.
    pub fn of_head(self) -> bool {
        matches!(self, Self::Circle | Self::Epicycloid)
    }
}

impl BevelSpiral {
    /// As geometry takes it. Of a checked job the line has what it needs.
    fn data(&self) -> Spiral {
        let radius = self.cutter_radius.unwrap_or_default();
        Spiral {
            mean_angle: self.mean_spiral_angle_deg.to_radians(),
            form: match self.line {
                SpiralLine::Circle => LineForm::Circle { radius },
                SpiralLine::Epicycloid => {
                    LineForm::Epicycloid { radius, groups: f64::from(self.blade_groups.unwrap_or_default()) }
                }
                SpiralLine::Skew => LineForm::Straight,
                SpiralLine::Involute => LineForm::Involute,
            },
            hand: if self.hand.sign() > 0.0 { geometry::Hand::Right } else { geometry::Hand::Left },
        }
    }
}

impl BevelGear {
    /// The drawing as geometry takes it: rad.
    pub fn data(&self) -> BevelData {
        BevelData {
            outer_transverse_module: self.outer_transverse_module,
            teeth: self.teeth,
            pitch_angle: self.pitch_cone_angle_deg.to_radians(),
            pressure_angle: self.pressure_angle_deg.to_radians(),
            face_width: self.face_width,
            addendum_factor: self.addendum_factor,
            dedendum_factor: self.dedendum_factor,
            spiral: self.spiral.as_ref().map(BevelSpiral::data),
            form_angle: self.start_polar_angle_deg.map(f64::to_radians),
        }
    }

    /// Where the halves would meet: distance from the apex, mm.
    pub fn meeting_distance(&self, halves: &DoubleHelicalBevel) -> f64 {
        self.outer_cone_distance() - 0.5 * self.face_width + halves.middle
    }

    /// The half at the heel and that at the toe, rad: each with the ends of its teeth as distances from the apex, mm.
    pub fn halves(&self, halves: &DoubleHelicalBevel) -> [(BevelData, [f64; 2]); 2] {
        let (meeting, outer) = (self.meeting_distance(halves), self.outer_cone_distance());
        let (heel, gap) = (self.data(), 0.5 * halves.gap);
        let toe = BevelData { spiral: heel.spiral.map(Spiral::reversed), ..heel };
        [(heel, [meeting + gap, outer]), (toe, [outer - self.face_width, meeting - gap])]
    }

    /// R_e: outer cone distance, mm.
    pub fn outer_cone_distance(&self) -> f64 {
        let sine = self.pitch_cone_angle_deg.to_radians().sin();
        self.outer_transverse_module * f64::from(self.teeth) / (2.0 * sine)
    }

    /// Angle of the cone on which an involute that began at the base cone ends, degrees: beyond it there is no tip.
    pub fn end_of_involute_deg(&self) -> f64 {
        let [pitch, pressure] = [self.pitch_cone_angle_deg, self.pressure_angle_deg].map(f64::to_radians);
        180.0 - (pitch.sin() * pressure.cos()).asin().to_degrees()
    }

    /// Angles of root cone and tip cone, degrees.
    pub fn cone_angles_deg(&self) -> [f64; 2] {
        let by = |factor: f64| {
            (factor * self.outer_transverse_module / self.outer_cone_distance()).atan().to_degrees()
        };
        let pitch = self.pitch_cone_angle_deg;
        [pitch - by(self.dedendum_factor), pitch + by(self.addendum_factor)]
    }
}

fn default_pressure_angle() -> f64 {
    20.0
}

fn default_addendum() -> f64 {
    1.0
}

fn default_dedendum() -> f64 {
    1.25
}
