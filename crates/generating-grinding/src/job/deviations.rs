//! `[deviations]`: axes of the machine that are off.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use job::{Diagnostic, Problem};

/// Axes that are off: what the planned settings leave on such a machine stands beside the plan.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct MachineDeviations {
    /// Deviation of the centre distance over the feed, um: coefficients of q^k, k = 0, 1, .., where q runs from -1 to 1 over the face
    /// width.
    #[schemars(length(max = 6), inner(range(min = -1000, max = 1000)))]
    pub radial_feed_um: Vec<f64>,
    /// Deviation of the workpiece's angle over the feed, arcsec: coefficients of q^k.
    #[schemars(length(max = 6), inner(range(min = -3600, max = 3600)))]
    pub work_angle_arcsec: Vec<f64>,
    /// Deviation of the crossing angle of worm and workpiece, degrees.
    #[schemars(extend("minimum" = -1, "maximum" = 1, "x-way-out" = "give a deviation of some thousandths of a degree"))]
    pub crossing_angle_deg: f64,
    /// Deviations of the dressing axes while the worm is dressed.
    pub dressing: DressingDeviation,
}

/// Deviations of the dressing axes, the same over the whole worm.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct DressingDeviation {
    /// Worm angle, degrees.
    #[serde(rename = "d_phi_S_deg")]
    #[schemars(extend("minimum" = -1, "maximum" = 1, "x-way-out" = "give some hundredths of a degree"))]
    pub d_phi_s_deg: f64,
    /// Crossing angle, degrees.
    #[schemars(extend("minimum" = -1, "maximum" = 1, "x-way-out" = "give some hundredths of a degree"))]
    pub d_gamma_deg: f64,
    /// Centre distance, mm.
    #[schemars(extend("minimum" = -1, "maximum" = 1, "x-way-out" = "give some thousandths of a millimetre"))]
    pub d_d_mm: f64,
    /// Offset of the dresser, mm.
    #[serde(rename = "d_v_yA_mm")]
    #[schemars(extend("minimum" = -1, "maximum" = 1, "x-way-out" = "give some hundredths of a millimetre"))]
    pub d_v_ya_mm: f64,
}

impl DressingDeviation {
    /// rad, rad, mm, mm.
    pub fn values(&self) -> [f64; 4] {
        [self.d_phi_s_deg.to_radians(), self.d_gamma_deg.to_radians(), self.d_d_mm, self.d_v_ya_mm]
    }
}

impl MachineDeviations {
    /// A table that says of no axis that it is off asks for nothing.
    pub(super) fn check(&self, findings: &mut Vec<Diagnostic>) {
        let each =
            self.radial_feed_um.iter().chain(&self.work_angle_arcsec).chain([&self.crossing_angle_deg]);
        if each.chain(&self.dressing.values()).all(|value| *value == 0.0) {
            findings.push(
                Diagnostic::new(Problem::InvalidJob, "no axis is off")
                    .field("deviations")
                    .value("zeros")
                    .allowed("a deviation other than 0, or no table")
                    .way_out("give a deviation, e.g. crossing_angle_deg = 0.002, or leave the table out"),
            );
        }
    }
}
