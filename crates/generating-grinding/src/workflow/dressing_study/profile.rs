//! The dressed profile itself: modification, what each radius of the dresser dresses, contact line (`docs/mathematics/dressing.md`).

use super::bodies::Bodies;
use super::crowning::{CrowningPoint, Task};
use crate::job::Steps;
use crate::workflow::explore::Refused;
use dressing::{DressedProfile, DressingError};
use foundation::geometry::Flank;
use foundation::numerics::equidistant;
use generating::GeneratingError;
use schemars::JsonSchema;
use serde::Serialize;

/// A dressed profile. The points belong to equidistant parameters of the dresser's profile, the same in all curves.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct ProfileCurve {
    /// Bodies and crowning.
    pub name: String,
    /// Figures of the correction; absent where it cannot be made.
    pub point: Option<CrowningPoint>,
    /// Length of roll on the worm.
    pub w_mm: Vec<f64>,
    /// Normal modification of the worm, positive = material left.
    pub f_n_um: Vec<f64>,
    /// How far the point on the worm lies from the one that its dresser radius was made for.
    pub shift_mm: Vec<f64>,
    /// Worm z of the contact, with the axial position of `point`.
    pub b_mm: Vec<f64>,
    /// Radius of the dresser.
    #[serde(rename = "r_A_mm")]
    pub r_a_mm: Vec<f64>,
    /// Why there is no curve.
    pub refused: Option<Refused>,
}

impl ProfileCurve {
    /// The figures of the curve in one line.
    pub fn summary(&self) -> String {
        match (&self.point, &self.refused) {
            (Some(p), _) => format!(
                "stretch {:.2} %, deviation from the parabola {:.4} um, v_zS {:.3} mm",
                100.0 * p.stretch,
                p.deviation_um,
                p.v_zs_mm
            ),
            (None, Some(refused)) => format!("{}: {}", refused.code, refused.text),
            (None, None) => String::new(),
        }
    }
}

/// Points of a curve.
const POINTS: usize = 25;

/// The profiles of one set of bodies.
pub fn curves(bodies: &Bodies, flank: Flank, steps: &Steps) -> Vec<ProfileCurve> {
    steps.values().map(|um| one(bodies, flank, um)).collect()
}

fn one(bodies: &Bodies, flank: Flank, crowning_um: f64) -> ProfileCurve {
    let of_crowning = format!("c_α = {crowning_um} µm");
    let name = if bodies.name.is_empty() { of_crowning } else { format!("{}, {of_crowning}", bodies.name) };
    let empty = ProfileCurve {
        name,
        point: None,
        w_mm: Vec::new(),
        f_n_um: Vec::new(),
        shift_mm: Vec::new(),
        b_mm: Vec::new(),
        r_a_mm: Vec::new(),
        refused: None,
    };
    let filled = Task::new(bodies, flank).and_then(|(task, _)| {
        fill(&task, crowning_um, empty.clone()).map_err(|error| Refused::from(&GeneratingError::from(error)))
    });
    filled.unwrap_or_else(|refused| ProfileCurve { refused: Some(refused), ..empty })
}

fn fill(task: &Task<'_>, crowning_um: f64, empty: ProfileCurve) -> Result<ProfileCurve, DressingError> {
    let crowning = crowning_um * 1e-3;
    let dk = task.solve(crowning, &[0.0; 4])?;
    let point = task.point(crowning, dk)?;
    let dresser = &task.tool.flanks[task.flank];
    let profile = DressedProfile::of_flank(dresser, dk);
    let (range, designed) = (dresser.range, dresser.designed);
    let mut curve = ProfileCurve { point: Some(point), ..empty };
    for t in equidistant([designed.w_nf, designed.w_na], POINTS) {
        let at = profile.at_parameter(t)?;
        let made_for = range.w_nf + (t - designed.w_nf) * (range.length() / designed.length());
        curve.w_mm.push(at.w);
        curve.f_n_um.push(at.f * 1e3);
        curve.shift_mm.push(at.w - made_for);
        curve.b_mm.push(at.b - point.v_zs_mm);
        curve.r_a_mm.push(at.r_a);
    }
    Ok(curve)
}
