//! What follows from a job of tangential dressing before anything is planned.

use crate::job::LoadedTangentialJob;
use crate::workflow::prepare_tangential;
use foundation::geometry::Flank;
use run::{DerivedGeometry, RunFailure, gear_sections};

/// The same of a job of tangential dressing: gear, worm, dresser, how they stand, the shift.
///
/// # Errors
/// A finding about bodies or targets that cannot exist.
pub fn of_tangential(loaded: &LoadedTangentialJob) -> Result<DerivedGeometry, RunFailure> {
    let ready = prepare_tangential(loaded)?;
    let model = &ready.model;
    let input = model.input();
    let mut derived = DerivedGeometry::default();
    gear_sections(&mut derived, &loaded.job.gear, &input.gear).map_err(RunFailure::bad_input)?;
    let worm = &model.pair.worm;
    derived.section("worm");
    derived.quantity("worm_pitch_diameter_mm", "pitch diameter", 2.0 * worm.pitch_radius(), "mm");
    derived.quantity("worm_tip_diameter_mm", "tip diameter", 2.0 * ready.worm_tip_radius, "mm");
    derived.quantity(
        "lead_angle_deg",
        "lead angle",
        90.0 - worm.data().helix_angle.to_degrees().abs(),
        "deg",
    );
    derived.quantity("screw_parameter_mm", "screw parameter", model.chain.screw_parameter, "mm/rad");
    derived.section("grinding");
    derived.quantity("centre_distance_mm", "centre distance", model.pair.chain.centre_distance, "mm");
    let crossed = model.pair.chain.crossed_axes_angle.to_degrees();
    derived.quantity("crossed_axes_angle_deg", "crossed-axes angle", crossed, "deg");
    derived.quantity("shift_ratio", "tool shift per feed", model.shift_ratio, "");
    if let Some(neutral) = model.neutral_ratio() {
        derived.quantity("neutral_shift_ratio", "neutral tool shift per feed", neutral, "");
    } else {
        let keys = [
            ("neutral_shift_ratio_left", "neutral tool shift per feed, left flank", Flank::Left),
            ("neutral_shift_ratio_right", "neutral tool shift per feed, right flank", Flank::Right),
        ];
        for (key, name, flank) in keys {
            if let Some(neutral) = model.neutral_ratios[flank] {
                derived.quantity(key, name, neutral, "");
            }
        }
    }
    derived.quantity("shift_width_mm", "scale along the worm b_w", input.shift_width, "mm");
    let lines = &model.lines;
    derived.quantity("shift_offset_left_mm", "shift that centres the left flank", lines.left.offset, "mm");
    derived.quantity("shift_offset_right_mm", "shift that centres the right flank", lines.right.offset, "mm");
    let twist = model.natural_twist(Flank::Left);
    derived.quantity("natural_twist_left", "twist of radial feed per crowning, left", -twist, "");
    derived.section("dressing");
    derived.quantity(
        "dresser_pitch_diameter_mm",
        "pitch diameter of the dresser",
        2.0 * input.dresser_pitch_radius,
        "mm",
    );
    derived.quantity("dressing_centre_distance_mm", "centre distance", model.chain.centre_distance, "mm");
    let crossing = model.chain.crossing_angle.to_degrees();
    derived.quantity("dressing_crossing_angle_deg", "crossing angle", crossing, "deg");
    Ok(derived)
}
