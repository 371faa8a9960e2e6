//! What follows from a job of measuring a skiving tool before anything is measured.

use crate::job::LoadedSkivingJob;
use crate::workflow::prepare_skiving;
use foundation::geometry::Flank;
use run::{DerivedGeometry, RunFailure, gear_of_job, gear_sections};

/// Of a job of measuring a skiving tool: the drawing of the workpiece, how tool and workpiece stand, edges, tracks.
///
/// # Errors
/// Bodies that do not skive, an edge that does not make the flank, poses that the machine does not reach.
pub fn of_skiving(loaded: &LoadedSkivingJob) -> Result<DerivedGeometry, RunFailure> {
    let bodies = prepare_skiving(loaded)?.bodies;
    let (tool, motion) = (bodies.pair.tool(), bodies.pair.motion());
    let mut derived = DerivedGeometry::default();
    let gear = gear_of_job(&loaded.job.gear).map_err(RunFailure::bad_input)?;
    gear_sections(&mut derived, &loaded.job.gear, &gear).map_err(RunFailure::bad_input)?;
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
