//! Gear, worm and dresser of a job as bodies that mesh, each finding on the key of the drawing that it concerns.

use crate::job::{DesignedFor, Job, RootAlong};
use crate::workflow::generating_finding;
use contact::ContactError;
use foundation::geometry::{Flank, Gear, Sides, WormChoice, worm_for_gear};
use generating::{DresserChoice, GearRootChoice, GrindingSetup, SetupInput};
use job::Diagnostic;
use job::tables::{Gear as JobGear, Hand};
use run::{RunFailure, blank_of_job, gear_of_job, geometry_finding};

/// What the job chooses of its worm.
pub fn worm_choice_of_job(job: &Job) -> WormChoice {
    WormChoice {
        threads: i32::try_from(job.worm.threads).unwrap_or(i32::MAX),
        hand: job.worm_hand().sign(),
        pitch_diameter: job.worm.pitch_diameter,
        tip_diameter: job.worm.tip_diameter,
        pressure_angle: Some(job.worm_pressure_angle_deg().sides().left.to_radians()),
        profile_shift: job.worm.profile_shift,
        cone_angle: job.worm.cone_angle_deg.to_radians(),
    }
}

/// The worm that a job's dresser was designed for: of the hand of the one that it dresses.
pub fn designed_worm(gear: &JobGear, hand: Hand, there: &DesignedFor) -> WormChoice {
    let angles = there.normal_pressure_angle_deg.unwrap_or(gear.normal_pressure_angle_deg);
    WormChoice {
        threads: i32::try_from(there.threads).unwrap_or(i32::MAX),
        hand: hand.sign(),
        pitch_diameter: there.pitch_diameter,
        tip_diameter: there.tip_diameter,
        pressure_angle: Some(angles.sides().left.to_radians()),
        profile_shift: 0.0,
        cone_angle: 0.0,
    }
}

/// Refuses a worm for which no dresser was designed: an impossible one, pressure angles and a module with which it does not mesh.
///
/// # Errors
/// A finding on `dresser.designed_for`.
pub fn check_designed_worm(
    gear: &Gear,
    (of_job, hand): (&JobGear, Hand),
    there: &DesignedFor,
) -> Result<(), Diagnostic> {
    const FIELD: &str = "dresser.designed_for";
    let own = gear.own_rack();
    let rack = match there.normal_pressure_angle_deg {
        None => own,
        Some(angles) => {
            let angles = angles.sides();
            let rack = gear.rack_with_pressure_angle(Flank::Left, angles.left.to_radians()).map_err(|e| {
                geometry_finding(&e, FIELD).field(format!("{FIELD}.normal_pressure_angle_deg"))
            })?;
            let right = rack.pressure_angle.right.to_degrees();
            if (right - angles.right).abs() > 1e-6 {
                let text = format!(
                    "a worm that meshes on both flanks has {right:.6} deg on the right flank when its left flank has {:.6} deg",
                    angles.left
                );
                return Err(Diagnostic::with_code("not-mating", text)
                    .field(format!("{FIELD}.normal_pressure_angle_deg"))
                    .value(angles.right)
                    .allowed(format!("{right:.6}"))
                    .way_out("give the matching angle, or leave the pressure angle out"));
            }
            rack
        }
    };
    worm_for_gear(gear, &designed_worm(of_job, hand, there))
        .map_err(|e| geometry_finding(&e, FIELD).field(FIELD))?;
    let module = rack.normal_module;
    match there.normal_module {
        Some(stated) if (stated - module).abs() > MATING * module => {
            let text = format!("a worm of normal module {stated} mm does not mesh with the gear");
            Err(Diagnostic::with_code("not-mating", text)
                .field(format!("{FIELD}.normal_module"))
                .value(stated)
                .allowed(format!("{module} mm"))
                .way_out(
                    "take a dresser for this module, or leave the module out if it follows from the angle",
                ))
        }
        _ => Ok(()),
    }
}

/// Modules that mesh may differ by this share (`docs/mathematics/dressing.md#limits-of-a-correction`).
const MATING: f64 = 1e-6;

/// Bodies of the job.
///
/// # Errors
/// [`RunFailure`] with a finding on the key concerned.
pub fn setup_of_job(job: &Job) -> Result<GrindingSetup, RunFailure> {
    let gear = gear_of_job(&job.gear).map_err(RunFailure::bad_input)?;
    let blank = blank_of_job(&job.gear);
    blank.check(&gear).map_err(|e| RunFailure::bad_input(geometry_finding(&e, "gear")))?;
    if let Some(there) = job.dresser.as_ref().and_then(|d| d.designed_for.as_ref()) {
        check_designed_worm(&gear, (&job.gear, job.worm_hand()), there).map_err(RunFailure::bad_input)?;
    }
    let range = job.gear.evaluation_range();
    let angle = job.worm_pressure_angle_deg().sides();
    let point = job.point_dresser();
    let direction = if point.is_some() { job.dressing.line_direction_deg } else { job.worm.direction_deg };
    let setup = GrindingSetup::new(SetupInput {
        gear,
        blank,
        evaluation: [range.start_diameter, range.end_diameter, range.z_start, range.z_end],
        worm: worm_choice_of_job(job),
        worm_width: job.worm.width,
        // What a disc in point contact writes is any flank: for the plan the tool is made, not profiled.
        dresser: job.dresser.as_ref().filter(|_| point.is_none()).map(|d| DresserChoice {
            tip_diameter: d.tip_diameter,
            pitch_diameter: d.pitch_diameter,
            designed_for: d.designed_for.map(|there| designed_worm(&job.gear, job.worm_hand(), &there)),
        }),
        tool_direction: direction.map(|given| given.sides().map(|_, rho| rho.to_radians().tan())),
        root_clearance: job.dresser.as_ref().and_then(|d| d.root_clearance),
        gear_root: job.dressing.gear_root.map(|root| GearRootChoice {
            corner_radius: root.corner_radius,
            constant: root.along == RootAlong::Constant,
            least_fillet_radius: root.least_fillet_radius,
        }),
    })
    .map_err(|e| generating_finding::failure(&e))?;
    if let Some(given) = &direction {
        let key = if point.is_some() { "dressing.line_direction_deg" } else { "worm.direction_deg" };
        check_lines(&setup, &given.sides(), key).map_err(RunFailure::bad_input)?;
    }
    let made = setup.pair.worm.data().pressure_angle;
    for (flank, angle) in angle.iter() {
        let wanted = angle.to_radians();
        if (made[flank] - wanted).abs() > 1e-9 {
            let text = format!(
                "a worm that meshes on both flanks has {:.6} deg on the {flank} flank when its left flank has {:.6} deg",
                made[flank].to_degrees(),
                made.left.to_degrees()
            );
            let d = Diagnostic::with_code("not-mating", text)
                .field("worm.normal_pressure_angle_deg")
                .way_out("give the matching angle, or leave the worm's pressure angle out");
            return Err(RunFailure::bad_input(d));
        }
    }
    Ok(setup)
}

/// Lines of the tool are at least this far from the contact path: along it every direction on the workpiece asks for the ratio 0.
const FROM_CONTACT_PATH_DEG: f64 = 0.1;

/// Refuses lines of the tool along the contact path, for which there is no diagonal ratio.
fn check_lines(setup: &GrindingSetup, given: &Sides<f64>, key: &str) -> Result<(), Diagnostic> {
    for (flank, &degrees) in given.iter() {
        let [path, _] = setup.pair.flanks[flank].contact_path();
        let path = path.rho.to_degrees();
        if (degrees - path).abs() >= FROM_CONTACT_PATH_DEG {
            continue;
        }
        let error = ContactError::DirectionIsContactPath { direction_deg: degrees };
        let text = format!("on the {flank} flank {error}, and no diagonal ratio");
        return Err(Diagnostic::with_code(error.code(), text)
            .field(key)
            .value(degrees)
            .allowed(format!("at least {FROM_CONTACT_PATH_DEG} deg from {path:.4} deg, the contact path"))
            .way_out("turn the lines away from the contact path, or leave the key out"));
    }
    Ok(())
}
