//! What follows from the drawing of a gear, for `check`: base data, measures of the tooth thickness with their limits, tolerances of its
//! class.

use super::derived::DerivedGeometry;
use super::tooth_measures::ToothMeasures;
use foundation::geometry::{Flank, Gear};
use job::Diagnostic;
use job::tables::Gear as JobGear;
use metrology::inspection::{ToleranceGear, ToleranceQuantity, Tolerances};

/// Base data and measures of the gear with their limits, tolerances of its class, as sections.
///
/// # Errors
/// A finding on `gear.measured_over`, `gear.allowances_um` or `gear.tolerance_class`.
pub fn gear_sections(
    derived: &mut DerivedGeometry,
    drawing: &JobGear,
    gear: &Gear,
) -> Result<(), Diagnostic> {
    let range = drawing.evaluation_range();
    derived.section("evaluation");
    derived.quantity("start_diameter", "start diameter", range.start_diameter, "mm");
    derived.quantity("end_diameter", "end diameter", range.end_diameter, "mm");
    derived.quantity("z_start", "z start", range.z_start, "mm");
    derived.quantity("z_end", "z end", range.z_end, "mm");
    derived.section("gear");
    derived.quantity("pitch_diameter_mm", "pitch diameter", 2.0 * gear.pitch_radius(), "mm");
    derived.quantity("transverse_module_mm", "transverse module", gear.transverse_module(), "mm");
    derived.quantity("profile_shift", "profile shift coefficient", gear.data().profile_shift, "");
    if let Ok(thickness) = gear.transverse_thickness(gear.pitch_radius(), 0.0) {
        derived.quantity(
            "transverse_tooth_thickness_mm",
            "transverse tooth thickness at pitch",
            thickness,
            "mm",
        );
    }
    for (flank, f) in gear.flanks().iter() {
        let keys = flank_keys(flank);
        derived.quantity(keys[0], keys[1], 2.0 * f.base_radius, "mm");
        derived.quantity(keys[2], keys[3], f.base_helix_angle.to_degrees(), "deg");
        derived.quantity(keys[4], keys[5], gear.transverse_pressure_angle(flank).to_degrees(), "deg");
        derived.quantity(keys[6], keys[7], gear.normal_base_pitch(flank), "mm");
    }
    thickness(derived, drawing, gear)?;
    tolerances(derived, drawing, gear)
}

/// Key and name of a quantity.
type Named = (&'static str, &'static str);

/// Tooth thickness by every measure: as made, and at the allowances of the drawing.
fn thickness(derived: &mut DerivedGeometry, drawing: &JobGear, gear: &Gear) -> Result<(), Diagnostic> {
    let measures = ToothMeasures::of(drawing, gear)?;
    derived.section("tooth thickness");
    let mut measure =
        |names: [Named; 3], before: Option<(Named, f64, &'static str)>, of: &dyn Fn(&Gear) -> Option<f64>| {
            let Some(made) = of(gear) else { return };
            if let Some(((key, label), value, unit)) = before {
                derived.quantity(key, label, value, unit);
            }
            let [made_as, least, greatest] = names;
            derived.quantity(made_as.0, made_as.1, made, "mm");
            for (end, name) in measures.between(of).into_iter().flatten().zip([least, greatest]) {
                derived.quantity(name.0, name.1, end, "mm");
            }
        };
    measure(
        [
            ("normal_tooth_thickness_mm", "normal tooth thickness s_n"),
            ("normal_tooth_thickness_least_mm", "s_n, least"),
            ("normal_tooth_thickness_greatest_mm", "s_n, greatest"),
        ],
        None,
        &ToothMeasures::normal_thickness,
    );
    measure(
        [("span_mm", "span W_k"), ("span_least_mm", "W_k, least"), ("span_greatest_mm", "W_k, greatest")],
        measures.span_teeth.map(|teeth| (("span_teeth", "teeth spanned k"), f64::from(teeth), "")),
        &|gear| Some(measures.span(gear)?.length),
    );
    measure(
        [
            ("over_balls_mm", "size over balls M_dK"),
            ("over_balls_least_mm", "M_dK, least"),
            ("over_balls_greatest_mm", "M_dK, greatest"),
        ],
        measures.ball.map(|ball| (("ball_diameter_mm", "ball diameter D_M"), ball, "mm")),
        &|gear| Some(measures.over_balls(gear)?.size),
    );
    measure(
        [
            ("over_rolls_mm", "size over rolls M_dR"),
            ("over_rolls_least_mm", "M_dR, least"),
            ("over_rolls_greatest_mm", "M_dR, greatest"),
        ],
        measures.roll.map(|roll| (("roll_diameter_mm", "roll diameter D_M"), roll, "mm")),
        &|gear| Some(measures.over_rolls(gear)?.size),
    );
    Ok(())
}

/// Tolerances of ISO 1328-1:2013 for the class of the drawing, rounded as the standard states them.
fn tolerances(derived: &mut DerivedGeometry, drawing: &JobGear, gear: &Gear) -> Result<(), Diagnostic> {
    let Some(class) = drawing.tolerance_class else { return Ok(()) };
    let of = ToleranceGear {
        teeth: drawing.teeth.unsigned_abs(),
        normal_module: drawing.normal_module,
        reference_diameter: 2.0 * gear.pitch_radius(),
        face_width: drawing.face_width,
        helix_angle: drawing.helix_angle_deg.to_radians(),
    };
    let refused = |error: &metrology::inspection::InspectionError| {
        Diagnostic::of(error).field("gear.tolerance_class").value(class.to_string())
    };
    let tolerances = Tolerances::new(&of).map_err(|e| refused(&e))?;
    derived.section("tolerances of ISO 1328-1");
    derived.quantity("class", "flank tolerance class", class, "");
    for quantity in ToleranceQuantity::ALL.into_iter().filter(|quantity| !quantity.is_informative()) {
        let (key, label) = tolerance_names(quantity);
        let um = 1e3 * tolerances.rounded(quantity, class).map_err(|e| refused(&e))?;
        derived.quantity(key, label, um, "um");
    }
    Ok(())
}

/// Key and name of a tolerance.
fn tolerance_names(quantity: ToleranceQuantity) -> Named {
    match quantity {
        ToleranceQuantity::SinglePitch => ("f_pT_um", "single pitch f_pT"),
        ToleranceQuantity::TotalPitch => ("F_pT_um", "total cumulative pitch F_pT"),
        ToleranceQuantity::ProfileSlope => ("f_HalphaT_um", "profile slope f_HalphaT"),
        ToleranceQuantity::ProfileForm => ("f_falphaT_um", "profile form f_falphaT"),
        ToleranceQuantity::ProfileTotal => ("F_alphaT_um", "total profile F_alphaT"),
        ToleranceQuantity::HelixSlope => ("f_HbetaT_um", "helix slope f_HbetaT"),
        ToleranceQuantity::HelixForm => ("f_fbetaT_um", "helix form f_fbetaT"),
        ToleranceQuantity::HelixTotal => ("F_betaT_um", "total helix F_betaT"),
        ToleranceQuantity::RunOut => ("F_rT_um", "run-out F_rT"),
        ToleranceQuantity::NeighbouringPitch => ("f_uT_um", "difference of neighbouring pitches f_uT"),
        ToleranceQuantity::SectorPitch => ("F_pzT_um", "pitch over an eighth F_pz/8T"),
    }
}

/// Keys of the quantities of a flank.
fn flank_keys(flank: Flank) -> [&'static str; 8] {
    match flank {
        Flank::Left => [
            "base_diameter_left_mm",
            "base diameter, left",
            "base_helix_angle_left_deg",
            "base helix angle, left",
            "transverse_pressure_angle_left_deg",
            "transverse pressure angle, left",
            "normal_base_pitch_left_mm",
            "normal base pitch, left",
        ],
        Flank::Right => [
            "base_diameter_right_mm",
            "base diameter, right",
            "base_helix_angle_right_deg",
            "base helix angle, right",
            "transverse_pressure_angle_right_deg",
            "transverse pressure angle, right",
            "normal_base_pitch_right_mm",
            "normal base pitch, right",
        ],
    }
}
