//! What follows from a job of five-axis milling before anything is planned.

use crate::Half;
use crate::job::LoadedMillingJob;
use crate::workflow::prepare_milling;
use foundation::geometry::Flank;
use run::{DerivedGeometry, RunFailure, gear_of_job, gear_sections};

/// Of a job of five-axis milling: the drawing of a cylindrical gear, what the guide curve has to cover, where the active flank lies.
///
/// # Errors
/// Bodies that do not fit, column planes that do not meet the flank.
pub fn of_milling(loaded: &LoadedMillingJob) -> Result<DerivedGeometry, RunFailure> {
    let bodies = prepare_milling(loaded)?.bodies;
    let mut derived = DerivedGeometry::default();
    if let Some(given) = &loaded.job.gear {
        let gear = gear_of_job(&given.drawing).map_err(RunFailure::bad_input)?;
        gear_sections(&mut derived, &given.drawing, &gear).map_err(RunFailure::bad_input)?;
    }
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
            (Some(Half::Heel), Flank::Left) => "left flank of the half at the heel",
            (Some(Half::Heel), Flank::Right) => "right flank of the half at the heel",
            (Some(Half::Toe), Flank::Left) => "left flank of the half at the toe",
            (Some(Half::Toe), Flank::Right) => "right flank of the half at the toe",
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
