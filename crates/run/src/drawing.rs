//! What a drawing says of a gear beside its flanks, as results have it: measures of the tooth thickness with their limits, tolerances of the
//! class. A plan judges neither.

use super::tooth_measures::ToothMeasures;
use foundation::geometry::Gear;
use job::Diagnostic;
use job::tables::Gear as JobGear;
use metrology::inspection::{InspectionError, ToleranceGear, ToleranceQuantity, Tolerances};
use schemars::JsonSchema;
use serde::Serialize;
use verdict::Verdict;

/// Tooth thickness and class of the drawing.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct DrawingResult {
    /// Normal tooth thickness on the pitch cylinder; absent of a conical gear.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub normal_tooth_thickness: Option<ThicknessResult>,
    /// Span; absent where the gear has none.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub span: Option<ThicknessResult>,
    /// Size over (internal: between) balls; absent where no ball touches.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub over_balls: Option<ThicknessResult>,
    /// Size over (internal: between) rolls; absent without `gear.measured_over.roll_diameter`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub over_rolls: Option<ThicknessResult>,
    /// Tolerances of ISO 1328-1:2013, rounded as the standard states them; absent without `gear.tolerance_class`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub tolerances: Option<ToleranceResult>,
}

/// One measure of the tooth thickness.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct ThicknessResult {
    /// Teeth spanned.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub teeth: Option<u32>,
    /// Diameter of balls or rolls.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub diameter_mm: Option<f64>,
    /// Of the gear that is made, in the middle of its allowances.
    pub size_mm: f64,
    /// Least and greatest between the allowances; absent without them.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub limits_mm: Option<[f64; 2]>,
}

/// Tolerances of a flank tolerance class.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
#[allow(non_snake_case, reason = "the standard's symbols")]
pub struct ToleranceResult {
    /// The class.
    pub class: i32,
    /// Single pitch.
    pub f_pT_um: f64,
    /// Total cumulative pitch.
    pub F_pT_um: f64,
    /// Profile slope.
    pub f_HalphaT_um: f64,
    /// Profile form.
    pub f_falphaT_um: f64,
    /// Total profile.
    pub F_alphaT_um: f64,
    /// Helix slope.
    pub f_HbetaT_um: f64,
    /// Helix form.
    pub f_fbetaT_um: f64,
    /// Total helix.
    pub F_betaT_um: f64,
    /// Run-out.
    pub F_rT_um: f64,
}

impl ToothMeasures {
    /// As results have it.
    pub fn result(&self, gear: &Gear) -> DrawingResult {
        let thickness = |teeth, diameter_mm, of: &dyn Fn(&Gear) -> Option<f64>| {
            let size_mm = of(gear)?;
            Some(ThicknessResult { teeth, diameter_mm, size_mm, limits_mm: self.between(of) })
        };
        DrawingResult {
            normal_tooth_thickness: thickness(None, None, &Self::normal_thickness),
            span: thickness(self.span_teeth, None, &|gear| Some(self.span(gear)?.length)),
            over_balls: thickness(None, self.ball, &|gear| Some(self.over_balls(gear)?.size)),
            over_rolls: thickness(None, self.roll, &|gear| Some(self.over_rolls(gear)?.size)),
            tolerances: self.tolerances,
        }
    }

    /// Says that nothing here judges the class of the drawing.
    pub fn leave_class(&self, verdict: &mut Verdict) {
        if let Some(ToleranceResult { class, .. }) = self.tolerances {
            verdict.leave(
                format!("class {class} of ISO 1328-1"),
                "a plan has no pitches and no run-out; `flankwright inspect` judges a measured gear by it",
            );
        }
    }
}

/// Tolerances of the class of a drawing; `None` without one.
///
/// # Errors
/// A finding on `gear.tolerance_class` for a gear outside the standard.
pub(super) fn tolerances(drawing: &JobGear, gear: &Gear) -> Result<Option<ToleranceResult>, Diagnostic> {
    let Some(class) = drawing.tolerance_class else { return Ok(None) };
    let of = ToleranceGear {
        teeth: drawing.teeth.unsigned_abs(),
        normal_module: drawing.normal_module,
        reference_diameter: 2.0 * gear.pitch_radius(),
        face_width: drawing.face_width,
        helix_angle: drawing.helix_angle_deg.to_radians(),
    };
    let refused = |error: InspectionError| {
        Diagnostic::of(&error).field("gear.tolerance_class").value(class.to_string())
    };
    let tolerances = Tolerances::new(&of).map_err(refused)?;
    // Multiples of a tenth of a micrometre.
    let um = |quantity| Ok((1e4 * tolerances.rounded(quantity, class).map_err(refused)?).round() / 10.0);
    Ok(Some(ToleranceResult {
        class,
        f_pT_um: um(ToleranceQuantity::SinglePitch)?,
        F_pT_um: um(ToleranceQuantity::TotalPitch)?,
        f_HalphaT_um: um(ToleranceQuantity::ProfileSlope)?,
        f_falphaT_um: um(ToleranceQuantity::ProfileForm)?,
        F_alphaT_um: um(ToleranceQuantity::ProfileTotal)?,
        f_HbetaT_um: um(ToleranceQuantity::HelixSlope)?,
        f_fbetaT_um: um(ToleranceQuantity::HelixForm)?,
        F_betaT_um: um(ToleranceQuantity::HelixTotal)?,
        F_rT_um: um(ToleranceQuantity::RunOut)?,
    }))
}
