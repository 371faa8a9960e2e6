//! `[measured_worm]`: a worm as it was measured after dressing, which tells which axes of dressing are off.

use super::conditions::DegreeOfFreedom;
use job::{Diagnostic, Problem};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Points of the worm that was dressed with the planned motion; deviations of the dressing axes that explain them stand beside the plan.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct MeasuredWorm {
    /// Table with the columns flank, w_mm (length of roll on the worm), z_mm (along the worm) and um (normal deviation from the unmodified
    /// flank, positive = material), beside the job file.
    #[schemars(extend("minLength" = 1))]
    pub file: String,
    /// Standard deviation of a measured value, um.
    #[serde(default = "noise")]
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 100, "x-way-out" = "give the repeatability of the measurement in um, e.g. 0.2"))]
    pub noise_um: f64,
    /// Whether the values count from the nominal flank, so that the thickness of the threads is known; default: each flank about its mean,
    /// which does not tell the angle of the worm.
    #[serde(default)]
    pub thickness: bool,
    /// Axes of dressing that are known to stand right.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    #[schemars(extend("uniqueItems" = true, "maxItems" = 3))]
    pub held: Vec<DegreeOfFreedom>,
}

fn noise() -> f64 {
    0.2
}

impl MeasuredWorm {
    /// Whether an axis is taken to stand right: named, or not told by the form of the flanks.
    pub fn holds(&self, axis: DegreeOfFreedom) -> bool {
        self.held.contains(&axis) || (!self.thickness && axis == DegreeOfFreedom::PhiS)
    }

    /// Something has to be left to find.
    pub(super) fn check(&self, findings: &mut Vec<Diagnostic>) {
        if DegreeOfFreedom::ALL.into_iter().all(|axis| self.holds(axis)) {
            findings.push(
                Diagnostic::new(Problem::InvalidJob, "no axis is left that could be off")
                    .field("measured_worm.held")
                    .value(self.held.iter().map(|axis| axis.name()).collect::<Vec<_>>().join(", "))
                    .allowed("an axis fewer; without `thickness` the angle of the worm is held as well")
                    .way_out("name the axes only that are known to stand right"),
            );
        }
    }
}
