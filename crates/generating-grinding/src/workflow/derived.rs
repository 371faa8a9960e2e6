//! Gear, worm and dresser of a grinding job, and how they stand.

use super::machine_fit::{self, MachineFit};
use crate::catalogue::LoadedCatalogue;
use crate::job::LoadedJob;
use crate::workflow::catalogue::wanted_of_catalogue;
use crate::workflow::prepare::{Prepared, prepare};
use foundation::geometry::Flank;
use generating::GrindingSetup;
use job::machine::LoadedMachine;
use run::{DerivedGeometry, RunFailure, gear_of_job, gear_sections};
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
    gear_sections(&mut derived, &job.gear, &gear).map_err(RunFailure::bad_input)?;
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
    let ready = prepare(loaded)?.on_machine(loaded)?;
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
    contact_section(&mut derived, &ready);
    let mut remarks = ready.warnings.clone();
    if let Some(machine) = &ready.machine {
        remarks.extend(machine_section(&mut derived, &ready, machine));
    }
    Ok((derived, remarks))
}

/// What the worm reaches, and which feeds and part of it grind the evaluated field.
fn contact_section(derived: &mut DerivedGeometry, ready: &Prepared) {
    let setup = &ready.setup;
    derived.section("reach and feed");
    let ground = ready.ground_flanks();
    for &flank in &ground {
        let Some(from) = setup.generated_from(flank) else { continue };
        let (key, label) = match flank {
            Flank::Left => ("generated_from_left_mm", "worm's tip generates the involute from d, left"),
            Flank::Right => ("generated_from_right_mm", "worm's tip generates the involute from d, right"),
        };
        derived.quantity(key, label, from, "mm");
    }
    let root = 0.5 * setup.input.blank.root_diameter;
    let tip = 0.5 * setup.input.blank.tip_diameter;
    let distance = setup.pair.chain.centre_distance;
    derived.quantity(
        "clearance_root_mm",
        "worm's tip to the gear's root",
        distance - setup.worm_tip_radius - root,
        "mm",
    );
    derived.quantity(
        "clearance_tip_mm",
        "gear's tip to the worm's root",
        distance - setup.worm_root_radius - tip,
        "mm",
    );
    let (ratio, law) = machine_fit::shift_known_before(ready);
    if ready.law.is_none() {
        let label = if ready.rules.known_ratio().is_some() {
            "diagonal ratio"
        } else {
            "diagonal ratio (a plan chooses it)"
        };
        derived.quantity("diagonal_ratio", label, ratio, "");
    }
    let [from, to] = machine_fit::feeds(ready, &law);
    derived.quantity("feed_from_mm", "feed z_V2 from, with overrun", from, "mm");
    derived.quantity("feed_to_mm", "feed z_V2 to, with overrun", to, "mm");
    let [low, high] = setup.occupation(&law, &ground);
    derived.quantity("worm_used_mm", "width of the worm that grinds", high - low, "mm");
    if let Some(width) = setup.input.worm_width {
        let room = width - (high - low) - 2.0 * setup.run_in();
        derived.quantity("worm_room_mm", "left of its width beside the run-in", room, "mm");
    }
}

/// The axes of the machine, and what does not fit.
fn machine_section(derived: &mut DerivedGeometry, ready: &Prepared, machine: &LoadedMachine) -> Vec<Remark> {
    let MachineFit { axes, remarks } = machine_fit::machine_fit(ready, machine);
    derived.section("machine, before corrections");
    for need in axes {
        let key = |what: &str| format!("{}_{what}_{}", need.axis, need.unit);
        let label = |what: &str| format!("{} {what}", need.axis);
        derived.quantity(key("from"), label("from"), need.needed[0], need.unit);
        derived.quantity(key("to"), label("to"), need.needed[1], need.unit);
        derived.quantity(key("room"), label("room to the end of travel"), need.room(), need.unit);
    }
    remarks
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
