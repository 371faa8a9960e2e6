//! What follows from the drawing of a gear, for `check`: base data, measures of the tooth thickness with their limits, tolerances of its
//! class.

use super::derived::DerivedGeometry;
use super::drawing::{DrawingResult, ThicknessResult, ToleranceResult};
use super::tooth_measures::ToothMeasures;
use foundation::geometry::{Flank, Gear};
use job::Diagnostic;
use job::tables::Gear as JobGear;

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
    let drawn = ToothMeasures::of(drawing, gear)?.result(gear);
    thickness(derived, &drawn);
    if let Some(of) = &drawn.tolerances {
        tolerances(derived, of);
    }
    Ok(())
}

/// Key and name of a quantity.
type Named = (&'static str, &'static str);

/// A measure of the tooth thickness: as made, and between the allowances of the drawing.
fn measure(derived: &mut DerivedGeometry, found: Option<&ThicknessResult>, names: [Named; 4]) {
    let Some(found) = found else { return };
    let [over, made, least, greatest] = names;
    if let Some(teeth) = found.teeth {
        derived.quantity(over.0, over.1, teeth, "");
    }
    if let Some(diameter) = found.diameter_mm {
        derived.quantity(over.0, over.1, diameter, "mm");
    }
    derived.quantity(made.0, made.1, found.size_mm, "mm");
    for (end, name) in found.limits_mm.into_iter().flatten().zip([least, greatest]) {
        derived.quantity(name.0, name.1, end, "mm");
    }
}

/// Tooth thickness by every measure.
fn thickness(derived: &mut DerivedGeometry, drawing: &DrawingResult) {
    derived.section("tooth thickness");
    measure(
        derived,
        drawing.normal_tooth_thickness.as_ref(),
        [
            ("", ""),
            ("normal_tooth_thickness_mm", "normal tooth thickness s_n"),
            ("normal_tooth_thickness_least_mm", "s_n, least"),
            ("normal_tooth_thickness_greatest_mm", "s_n, greatest"),
        ],
    );
    measure(
        derived,
        drawing.span.as_ref(),
        [
            ("span_teeth", "teeth spanned k"),
            ("span_mm", "span W_k"),
            ("span_least_mm", "W_k, least"),
            ("span_greatest_mm", "W_k, greatest"),
        ],
    );
    measure(
        derived,
        drawing.over_balls.as_ref(),
        [
            ("ball_diameter_mm", "ball diameter D_M"),
            ("over_balls_mm", "size over balls M_dK"),
            ("over_balls_least_mm", "M_dK, least"),
            ("over_balls_greatest_mm", "M_dK, greatest"),
        ],
    );
    measure(
        derived,
        drawing.over_rolls.as_ref(),
        [
            ("roll_diameter_mm", "roll diameter D_M"),
            ("over_rolls_mm", "size over rolls M_dR"),
            ("over_rolls_least_mm", "M_dR, least"),
            ("over_rolls_greatest_mm", "M_dR, greatest"),
        ],
    );
}

/// Tolerances of the class.
fn tolerances(derived: &mut DerivedGeometry, of: &ToleranceResult) {
    derived.section("tolerances of ISO 1328-1");
    derived.quantity("class", "flank tolerance class", of.class, "");
    for (key, label, um) in [
        ("f_pT_um", "single pitch f_pT", of.f_pT_um),
        ("F_pT_um", "total cumulative pitch F_pT", of.F_pT_um),
        ("f_HalphaT_um", "profile slope f_HalphaT", of.f_HalphaT_um),
        ("f_falphaT_um", "profile form f_falphaT", of.f_falphaT_um),
        ("F_alphaT_um", "total profile F_alphaT", of.F_alphaT_um),
        ("f_HbetaT_um", "helix slope f_HbetaT", of.f_HbetaT_um),
        ("f_fbetaT_um", "helix form f_fbetaT", of.f_fbetaT_um),
        ("F_betaT_um", "total helix F_betaT", of.F_betaT_um),
        ("F_rT_um", "run-out F_rT", of.F_rT_um),
    ] {
        derived.quantity(key, label, um, "um");
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
