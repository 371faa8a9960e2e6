//! What follows from a job of the electronic gearbox before anything runs.

use crate::job::{LoadedGearboxJob, reference_train};
use crate::workflow::figures;
use crate::workflow::prepare::Chain;
use run::{DerivedGeometry, JobFailure};

/// Of a job of the electronic gearbox: scale of the feed, lead, coefficient, how many reference pulses a train has.
///
/// # Errors
/// Everything that is wrong with the table of reference pulses that the job names; a coefficient beyond the rate multiplier.
pub fn of_gearbox(loaded: &LoadedGearboxJob) -> Result<DerivedGeometry, JobFailure> {
    let job = &loaded.job;
    let train = reference_train(loaded)?;
    let mut derived = DerivedGeometry::default();
    derived.section("feed");
    derived.quantity("pitch_mm", "pitch of the scale", job.feed.pitch_mm(), "mm");
    let greatest = 60.0 * job.feed.greatest_speed_mm_per_s();
    derived.quantity("greatest_speed_mm_per_min", "greatest speed v_max", greatest, "mm/min");
    let coupling = figures::coupling(&Chain::of_job(job)?);
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
