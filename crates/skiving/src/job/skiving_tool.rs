//! `[skiving_tool]`: teeth, rake face, edge.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// The tool as its drawing has it; module and pressure angle are those of the workpiece. Lengths in mm.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SkivingToolEntry {
    /// z_1: number of teeth.
    #[schemars(extend("minimum" = 3, "maximum" = 1000, "x-way-out" = "give the number of teeth of the tool, 3 or more"))]
    pub teeth: u32,
    /// beta_1: helix angle in degrees, positive for a right-hand tool.
    #[schemars(extend("exclusiveMinimum" = -60, "exclusiveMaximum" = 60, "x-way-out" = "give the helix angle of the tool in degrees, > 0 right-hand"))]
    pub helix_angle_deg: f64,
    /// The rake face.
    pub rake: Rake,
    /// rho_e: radius of the rounding between rake and clearance face.
    #[schemars(extend("minimum" = 0, "maximum" = 5, "x-way-out" = "give the radius of the edge in mm, e.g. 0.03; 0 for a sharp edge"))]
    pub edge_radius: f64,
    /// alpha_c: clearance angle, degrees.
    #[schemars(extend("minimum" = 0, "exclusiveMaximum" = 90, "x-way-out" = "give the clearance angle in degrees, e.g. 8"))]
    pub clearance_angle_deg: f64,
    /// A chamfer on the rake face along the edge; default none.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub rake_chamfer: Option<RakeChamfer>,
    /// Angle of a chamfer on the clearance face along the edge, degrees; default 0, none.
    #[serde(default)]
    #[schemars(extend("minimum" = 0, "exclusiveMaximum" = 90, "x-way-out" = "give the angle of the chamfer in degrees, 0 for none"))]
    pub clearance_chamfer_angle_deg: f64,
}

/// A rake face.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Rake {
    /// Its form.
    pub form: RakeForm,
    /// gamma_r: rake angle at the pitch circle, degrees.
    #[schemars(extend("minimum" = -30, "maximum" = 45, "x-way-out" = "give the rake angle in degrees, e.g. 5"))]
    pub angle_deg: f64,
    /// sigma: step angle of planes ground tooth by tooth, degrees; the tool's helix angle puts them across the teeth. Default 0.
    #[serde(default)]
    #[schemars(extend("exclusiveMinimum" = -60, "exclusiveMaximum" = 60, "x-way-out" = "give the step angle in degrees, usually the helix angle of the tool; 0 without steps"))]
    pub step_angle_deg: f64,
    /// Change of the slope up the tooth against its plane at the pitch point, degrees per mm of height, > 0: more rake towards the tip.
    /// This and the three below: of a `"variable"` face only, default 0.
    #[serde(default, skip_serializing_if = "is_zero")]
    #[schemars(extend("minimum" = -20, "maximum" = 20, "x-way-out" = "give the change in degrees per mm of height, or leave it out"))]
    pub height_deg_per_mm: f64,
    /// The same per square millimetre.
    #[serde(default, skip_serializing_if = "is_zero")]
    #[schemars(extend("minimum" = -10, "maximum" = 10, "x-way-out" = "give the change in degrees per square millimetre of height, or leave it out"))]
    pub height_deg_per_mm2: f64,
    /// Change of the slope across the tooth, degrees per mm from its middle, > 0: hollow, so that both edges gain rake.
    #[serde(default, skip_serializing_if = "is_zero")]
    #[schemars(extend("minimum" = -20, "maximum" = 20, "x-way-out" = "give the change in degrees per mm from the middle of the tooth, or leave it out"))]
    pub hollow_deg_per_mm: f64,
    /// Change of the slope across the tooth, degrees per mm of height: one edge gains rake towards the tip, the other loses it.
    #[serde(default, skip_serializing_if = "is_zero")]
    #[schemars(extend("minimum" = -20, "maximum" = 20, "x-way-out" = "give the change in degrees per mm of height, or leave it out"))]
    pub twist_deg_per_mm: f64,
}

#[expect(clippy::trivially_copy_pass_by_ref, reason = "as serde calls it")]
fn is_zero(value: &f64) -> bool {
    *value == 0.0
}

impl Rake {
    /// Keys and values of the change over the tooth.
    pub(crate) fn changes(&self) -> [(&'static str, f64); 4] {
        [
            ("height_deg_per_mm", self.height_deg_per_mm),
            ("height_deg_per_mm2", self.height_deg_per_mm2),
            ("hollow_deg_per_mm", self.hollow_deg_per_mm),
            ("twist_deg_per_mm", self.twist_deg_per_mm),
        ]
    }
}

/// Forms of rake faces.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum RakeForm {
    /// A plane for every tooth.
    Plane,
    /// One cone for all teeth.
    Cone,
    /// One hollow sphere for all teeth, as a cup wheel grinds it.
    Sphere,
    /// A face for every tooth whose rake angle changes over the tooth.
    Variable,
}

/// A chamfer on the rake face.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RakeChamfer {
    /// b_r: its width.
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 5, "x-way-out" = "give the width in mm, e.g. 0.05"))]
    pub width: f64,
    /// kappa_r: its angle against the rake face, degrees.
    #[schemars(extend("exclusiveMinimum" = 0, "exclusiveMaximum" = 90, "x-way-out" = "give the angle in degrees, e.g. 10"))]
    pub angle_deg: f64,
}
