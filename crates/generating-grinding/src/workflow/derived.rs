//! Gear, worm and dresser of a grinding job, and how they stand.

use crate::catalogue::LoadedCatalogue;
use crate::job::LoadedJob;
use crate::workflow::catalogue::wanted_of_catalogue;
use crate::workflow::prepare;
use foundation::geometry::{Flank, Gear};
use generating::GrindingSetup;
use job::tables::Gear as JobGear;
use run::{DerivedGeometry, RunFailure, ToothMeasures, gear_of_job};
use verdict::Remark;

/// What follows from the job: base data and measures of the gear, worm, dresser and how they stand; of a catalogue how much it
/// holds.
///
/// # Errors
/// A finding about bodies or targets that cannot exist.
pub fn of_grinding(
    loaded: &LoadedJob,
    catalogue: Option<&LoadedCatalogue>,
) -> Result<(DerivedGeometry, Vec<Remark>), RunFailure> {
    let job = &loaded.job;
    let mut derived = DerivedGeometry::default();
    let gear = gear_of_job(&job.gear).map_err(RunFailure::bad_input)?;
    gear_sections(&mut derived, &job.gear, &gear);
    if let Some(found) = catalogue {
        let wanted = wanted_of_catalogue(loaded, found)?;
        derived.section("catalogue");
        let (worms, dressers) = (found.catalogue.worm.len(), found.catalogue.dresser.len());
        derived.quantity("worms", "worms", worms, "");
        derived.quantity("dressers", "dressers", dressers, "");
        derived.quantity("pairs", "pairs", worms * dressers, "");
        for (flank, key, label) in [
            ("left", "profile_crowning_left_um", "profile crowning wanted, left"),
            ("right", "profile_crowning_right_um", "profile crowning wanted, right"),
        ] {
            if let Some(um) = wanted.get(flank) {
                derived.quantity(key, label, *um, "um");
            }
        }
        return Ok((derived, Vec::new()));
    }
    let cylindrical = gear.is_cylindrical() && job.worm.cone_angle_deg == 0.0;
    let ready = prepare(loaded)?;
    if !cylindrical {
        let mut remarks = ready.warnings;
        remarks.push(Remark {
            code: "geometry-only",
            text: "of conical gears and worms the data of worm, contact and dresser are not listed".into(),
            way_out: "plan the job; its report has them".into(),
        });
        return Ok((derived, remarks));
    }
    tool_sections(&mut derived, &ready.setup);
    Ok((derived, ready.warnings))
}

/// Base data and measures of the gear, as sections.
pub fn gear_sections(derived: &mut DerivedGeometry, drawing: &JobGear, gear: &Gear) {
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
    let measures = ToothMeasures::of(drawing, gear);
    if let Some(span) = measures.span(gear) {
        derived.quantity("span_teeth", "teeth spanned k", span.teeth, "");
        derived.quantity("span_mm", "span W_k", span.length, "mm");
    }
    if let Some(balls) = measures.over_balls(gear) {
        derived.quantity("ball_diameter_mm", "ball diameter D_M", balls.ball, "mm");
        derived.quantity("over_balls_mm", "size over balls M_dK", balls.size, "mm");
    }
}

/// Keys of the quantities of a flank.
pub fn flank_keys(flank: Flank) -> [&'static str; 8] {
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

fn tool_sections(derived: &mut DerivedGeometry, setup: &GrindingSetup) {
    let worm = setup.pair.worm.data();
    derived.section("worm");
    derived.quantity("hand", "hand", if worm.helix_angle > 0.0 { "right" } else { "left" }, "");
    derived.quantity("normal_module_mm", "normal module", worm.normal_module, "mm");
    let angle = worm.pressure_angle;
    derived.quantity(
        "normal_pressure_angle_left_deg",
        "normal pressure angle, left",
        angle.left.to_degrees(),
        "deg",
    );
    derived.quantity(
        "normal_pressure_angle_right_deg",
        "normal pressure angle, right",
        angle.right.to_degrees(),
        "deg",
    );
    derived.quantity("pitch_diameter_mm", "pitch diameter", 2.0 * setup.worm_pitch_radius, "mm");
    derived.quantity("tip_diameter_mm", "tip diameter", 2.0 * setup.worm_tip_radius, "mm");
    derived.quantity("root_diameter_mm", "root diameter", 2.0 * setup.worm_root_radius, "mm");
    derived.quantity("lead_angle_deg", "lead angle", 90.0 - worm.helix_angle.to_degrees().abs(), "deg");
    derived.section("contact");
    let chain = &setup.pair.chain;
    derived.quantity("centre_distance_mm", "centre distance", chain.centre_distance, "mm");
    derived.quantity(
        "crossed_axes_angle_deg",
        "crossed-axes angle",
        chain.crossed_axes_angle.to_degrees(),
        "deg",
    );
    for (flank, f) in setup.pair.flanks.iter() {
        let (angle, direction) = match flank {
            Flank::Left => (
                ("operating_pressure_angle_left_deg", "operating pressure angle, left"),
                ("contact_path_left_deg", "contact path on the gear, left"),
            ),
            Flank::Right => (
                ("operating_pressure_angle_right_deg", "operating pressure angle, right"),
                ("contact_path_right_deg", "contact path on the gear, right"),
            ),
        };
        derived.quantity(angle.0, angle.1, f.operating_alpha_n.to_degrees(), "deg");
        derived.quantity(direction.0, direction.1, setup.lines[flank].t_k.atan().to_degrees(), "deg");
    }
    let Ok(tool) = setup.dresser() else { return };
    derived.section("dressing");
    // A dresser designed for another worm is settled on this one; the nominal place is without that.
    let nominal = tool.unsettled();
    let dressing = &nominal.flanks.left.chain;
    derived.quantity("centre_distance_mm", "nominal centre distance", dressing.centre_distance, "mm");
    derived.quantity(
        "crossing_angle_deg",
        "nominal crossing angle",
        dressing.crossing_angle.to_degrees(),
        "deg",
    );
    for (flank, dresser) in tool.flanks.iter() {
        let (from, to) = match flank {
            Flank::Left => {
                (("roll_from_left_mm", "worm roll from, left"), ("roll_to_left_mm", "worm roll to, left"))
            }
            Flank::Right => {
                (("roll_from_right_mm", "worm roll from, right"), ("roll_to_right_mm", "worm roll to, right"))
            }
        };
        derived.quantity(from.0, from.1, dresser.range.w_nf, "mm");
        derived.quantity(to.0, to.1, dresser.range.w_na, "mm");
    }
}
