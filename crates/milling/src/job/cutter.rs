//! `[cutter]`, `[bottom_cutter]`, `[roughing_cutter]`: mills with their shanks (`docs/mathematics/milling.md#cutter-location`).

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::coolant::CutterCoolant;
use foundation::geometry::{Cutter, CutterShape, GeometryError, ShankStep};

/// A mill. Heights count from its tip. Lengths in mm.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct MillingCutter {
    /// Its shape, which decides about the keys below.
    pub shape: CutterForm,
    /// Diameter; of a cone where the side meets the plane of the tip, of a barrel or drum the largest one.
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 1000, "x-way-out" = "give the diameter of the cutter in mm"))]
    pub diameter: f64,
    /// Radius of the rounded corner of an end mill, torus or cone; default 0, a sharp corner.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("minimum" = 0, "maximum" = 500, "x-way-out" = "give the radius of the corner in mm, or leave it out for a sharp one"))]
    pub corner_radius: Option<f64>,
    /// Half angle of a cone, degrees; the shank is thicker.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 80, "x-way-out" = "give the angle between side and axis in degrees"))]
    pub half_angle_deg: Option<f64>,
    /// Radius of the profile of a barrel or drum.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 1e5, "x-way-out" = "give the radius of the profile's arc in mm"))]
    pub profile_radius: Option<f64>,
    /// Height of the largest diameter of a barrel or drum.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("minimum" = 0, "maximum" = 1000, "x-way-out" = "give the height of the largest diameter above the tip in mm"))]
    pub largest_diameter_height: Option<f64>,
    /// Height up to which the edges cut.
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 2000, "x-way-out" = "give the length of the cutting edges in mm"))]
    pub cutting_length: f64,
    /// Neck, shank and holder, from the edges upwards; default none.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    #[schemars(length(max = 20))]
    pub shank: Vec<CutterShank>,
    /// Number in programs; default 1, of the bottom cutter 2, of the roughing cutter 3.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("minimum" = 1, "maximum" = 99_999_999, "x-way-out" = "give the number of the tool in the machine's store"))]
    pub number: Option<u32>,
    /// Number of cutting edges, for the feed per tooth in the report.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("minimum" = 1, "maximum" = 100, "x-way-out" = "give the number of cutting edges"))]
    pub teeth: Option<u32>,
    /// From the nose of the spindle to its tip; default that of `[machine]`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 2000, "x-way-out" = "give the distance from spindle nose to cutter tip in mm, or leave it out"))]
    pub tool_length: Option<f64>,
    /// Number of the tool's length on the control: H of LinuxCNC and Fanuc, D of Siemens; default the number of the tool, on Siemens 1.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("minimum" = 1, "maximum" = 999, "x-way-out" = "give the number behind H or D, or leave it out"))]
    pub length_offset: Option<u32>,
    /// Speed of the spindle with it, 1/min; default that of `[milling]`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 200_000, "x-way-out" = "give the speed in 1/min, e.g. 8000, or leave it out"))]
    pub spindle_rpm: Option<f64>,
    /// Speed of its contact along a path, mm/min; default that of `[milling]`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 1e5, "x-way-out" = "give the feed in mm/min, e.g. 1200, or leave it out"))]
    pub feed_mm_per_min: Option<f64>,
    /// Its speed towards a path, mm/min; default that of `[milling]`, and without it its feed.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 1e5, "x-way-out" = "give the feed in mm/min, or leave it out"))]
    pub plunge_feed_mm_per_min: Option<f64>,
    /// Coolant while it cuts; default that of `[milling]`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub coolant: Option<CutterCoolant>,
}

/// Shape of a mill.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum CutterForm {
    /// A cylinder, with a sharp or rounded corner.
    EndMill,
    /// A ball, and a cylinder above its middle.
    Ball,
    /// A cylinder with a large corner radius.
    Torus,
    /// A cone, thicker towards the shank, with a sharp or rounded corner.
    Cone,
    /// A profile of one arc.
    Barrel,
    /// The same as a barrel.
    Drum,
}

/// A cylinder of the tool behind its edges.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CutterShank {
    /// Its diameter.
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 2000, "x-way-out" = "give the diameter in mm"))]
    pub diameter: f64,
    /// Height above the tip at which it begins.
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 5000, "x-way-out" = "give the height above the tip in mm"))]
    pub from: f64,
}

impl CutterForm {
    /// The word in job files.
    pub fn name(self) -> &'static str {
        match self {
            Self::EndMill => "end-mill",
            Self::Ball => "ball",
            Self::Torus => "torus",
            Self::Cone => "cone",
            Self::Barrel => "barrel",
            Self::Drum => "drum",
        }
    }
}

impl MillingCutter {
    /// r_c: radius of the corner, mm; that of a ball is its own, a barrel has none.
    pub fn corner_radius(&self) -> f64 {
        match self.shape {
            CutterForm::Ball => self.diameter / 2.0,
            CutterForm::Barrel | CutterForm::Drum => 0.0,
            CutterForm::EndMill | CutterForm::Torus | CutterForm::Cone => self.corner_radius.unwrap_or(0.0),
        }
    }

    /// Half angle of the side, rad; 0 unless it is a cone.
    pub fn half_angle(&self) -> f64 {
        match self.shape {
            CutterForm::Cone => self.half_angle_deg.unwrap_or(0.0).to_radians(),
            _ => 0.0,
        }
    }

    /// Whether it has a straight side that can touch along its length: end mill, torus, cone.
    pub fn has_side(&self) -> bool {
        let round = self.corner_radius() >= self.diameter / 2.0 && self.half_angle() == 0.0;
        !matches!(self.shape, CutterForm::Ball | CutterForm::Barrel | CutterForm::Drum) && !round
    }

    /// Height at which the straight side begins, mm: r_c (1 - sin kappa).
    pub fn side_from(&self) -> f64 {
        self.corner_radius() * (1.0 - self.half_angle().sin())
    }

    /// The largest corner that the tip of a conical or cylindrical cutter has room for, mm.
    pub fn largest_corner_radius(&self) -> f64 {
        let (sin, cos) = self.half_angle().sin_cos();
        self.diameter / 2.0 * cos / (1.0 - sin)
    }

    /// The cutting part.
    pub fn cutting_part(&self) -> CutterShape {
        let radius = self.diameter / 2.0;
        match (self.shape, self.profile_radius) {
            (CutterForm::Barrel | CutterForm::Drum, Some(profile_radius)) => {
                let height = self.largest_diameter_height.unwrap_or(0.0);
                CutterShape::Barrel { radius, height, profile_radius }
            }
            _ => CutterShape::Conical {
                radius,
                half_angle: self.half_angle(),
                corner_radius: self.corner_radius(),
            },
        }
    }

    /// The cutter with its shank as a body.
    ///
    /// # Errors
    /// [`GeometryError::InvalidNumber`] for sizes that are no tool, which a checked job does not have.
    pub fn body(&self) -> Result<Cutter, GeometryError> {
        let step = |shank: &CutterShank| ShankStep { radius: shank.diameter / 2.0, from: shank.from };
        Cutter::new(self.cutting_part(), self.cutting_length, self.shank.iter().map(step).collect())
    }
}
