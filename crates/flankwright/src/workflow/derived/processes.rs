//! What follows from jobs that grind nothing.

use super::DerivedGeometry;
use crate::exchange::{LoadedGearboxJob, LoadedMillingJob, LoadedSkivingJob};
use crate::geometry::Flank;
use crate::process::milling::Half;
use crate::workflow::finding::{JobFailure, RunFailure};
use crate::workflow::gearbox::coupling_of_job;
use crate::workflow::milling::prepare_milling;
use crate::workflow::skiving::prepare_skiving;

/// Of a job of five-axis milling: what the guide curve has to cover, where the active flank lies.
///
/// # Errors
/// Bodies that do not fit, column planes that do not meet the flank.
pub(super) fn of_milling(loaded: &LoadedMillingJob) -> Result<DerivedGeometry, RunFailure> {
    let bodies = prepare_milling(loaded)?;
    let mut derived = DerivedGeometry::default();
    derived.section("workpiece");
    derived.quantity("spaces", "tooth spaces", bodies.spaces as u64, "");
    derived.quantity("milled_spaces", "of these milled", bodies.milled as u64, "");
    for flank in bodies.ranges()? {
        derived.section(match (flank.side.half, flank.side.flank) {
            (None, Flank::Left) => "left flank",
            (None, Flank::Right) => "right flank",
            (Some(Half::Upper), Flank::Left) => "left flank of the upper half",
            (Some(Half::Upper), Flank::Right) => "right flank of the upper half",
            (Some(Half::Lower), Flank::Left) => "left flank of the lower half",
            (Some(Half::Lower), Flank::Right) => "right flank of the lower half",
        });
        let [[root, tip], [low, high], [from, to]] = [flank.heights, flank.radii, flank.lead];
        derived.quantity("height_at_root", "height parameter at the root", root, "");
        derived.quantity("height_at_tip", "height parameter at the tip", tip, "");
        derived.quantity("least_radius_mm", "least radius of the active flank", low, "mm");
        derived.quantity("greatest_radius_mm", "greatest radius of the active flank", high, "mm");
        derived.quantity("lead_from", "guide curve from", from, "");
        derived.quantity("lead_to", "guide curve to", to, "");
    }
    Ok(derived)
}

/// Of a job of measuring a skiving tool: how tool and workpiece stand, edges, tracks.
///
/// # Errors
/// Bodies that do not skive, an edge that does not make the flank, poses that the machine does not reach.
pub(super) fn of_skiving(loaded: &LoadedSkivingJob) -> Result<DerivedGeometry, RunFailure> {
    let bodies = prepare_skiving(loaded)?;
    let (tool, motion) = (bodies.pair.tool(), bodies.pair.motion());
    let mut derived = DerivedGeometry::default();
    derived.section("skiving");
    derived.quantity("centre_distance_mm", "centre distance", motion.centre_distance, "mm");
    let crossed = motion.crossed_axes_angle.to_degrees();
    derived.quantity("crossed_axes_angle_deg", "crossed-axes angle", crossed, "deg");
    derived.quantity("tool_shift_mm", "tool shift", motion.tool_shift, "mm");
    derived.quantity("ratio", "workpiece angle per tool angle", motion.ratio, "");
    derived.section("tool");
    derived.quantity("pitch_diameter_mm", "pitch diameter", 2.0 * tool.pitch_radius(), "mm");
    derived.quantity("rounding_depth_mm", "depth of the rounding's centres", tool.rounding().depth(), "mm");
    for flank in Flank::BOTH {
        derived.section(match flank {
            Flank::Left => "left edge",
            Flank::Right => "right edge",
        });
        let [from, to] = bodies.edges[flank].flank().range();
        derived.quantity("roll_from_mm", "length of roll from", from, "mm");
        derived.quantity("roll_to_mm", "length of roll to", to, "mm");
        let tracks = &bodies.flanks[flank].tracks;
        let (track, pose) = &tracks[tracks.len() / 2];
        derived.quantity("track_radius_mm", "radius of the middle track", track.radius(), "mm");
        let theta = track.section.contact_angle.to_degrees();
        derived.quantity("contact_angle_deg", "contact on the rounding", theta, "deg");
        derived.quantity("lever_mm_per_rad", "lever", track.contact.lever, "mm/rad");
        derived.quantity("a_deg", "swivel A of the middle track", pose.swivel.to_degrees(), "deg");
        derived.quantity("b_deg", "turn B of the middle track", pose.turn.to_degrees(), "deg");
    }
    Ok(derived)
}

/// Of a job of the electronic gearbox: scale of the feed, lead, coefficient, how many reference pulses a train has.
///
/// # Errors
/// Everything that is wrong with the table of reference pulses that the job names; a coefficient beyond the rate multiplier.
pub(super) fn of_gearbox(loaded: &LoadedGearboxJob) -> Result<DerivedGeometry, JobFailure> {
    let job = &loaded.job;
    let train = loaded.reference_train()?;
    let mut derived = DerivedGeometry::default();
    derived.section("feed");
    derived.quantity("pitch_mm", "pitch of the scale", job.feed.pitch_mm(), "mm");
    let greatest = 60.0 * job.feed.greatest_speed_mm_per_s();
    derived.quantity("greatest_speed_mm_per_min", "greatest speed v_max", greatest, "mm/min");
    let coupling = coupling_of_job(job)?;
    if let Some(lead) = coupling.lead_mm {
        derived.section("gear");
        derived.quantity("lead_mm", "lead", lead, "mm");
    }
    derived.section("coupling");
    derived.quantity("coefficient", "coefficient b", coupling.coefficient, "");
    if let Some((word, error)) = coupling.coefficient_word.zip(coupling.coefficient_relative_error) {
        derived.quantity("coefficient_word", "its word B of 18 bits", word, "");
        // A millionth has no digits among six decimals.
        derived.quantity("coefficient_error_ppm", "relative error of B", 1e6 * error, "ppm");
    }
    derived.quantity(
        "rotation_error_um_per_m",
        "rounding of the rotation in use",
        coupling.rotation_error_um_per_m,
        "um per m of feed",
    );
    if let Some(train) = train {
        derived.section("stimulus");
        derived.quantity("reference_pulses", "reference pulses", train.references().len(), "");
    }
    Ok(derived)
}
