//! A bevel gear of a job and its conjugate mate, both with the start of the flank that the drawing says or that follows from the tip of
//! the other.

use crate::job::{self as drawn, BevelFlank, MillingJob};
use crate::workflow::mate_flank::{SAME, needed_polar_angle};
use foundation::geometry::{BevelData, BevelGear, Flank, Octoid};
use run::{RunFailure, geometry_finding};

/// Two bevel gears that roll together, the one that is milled first.
pub(super) struct BevelPair {
    /// The gears.
    pub gears: [BevelGear; 2],
    /// Form of their flanks.
    pub flank: BevelFlank,
}

impl BevelPair {
    /// Of a job; `None` without a mate.
    ///
    /// # Errors
    /// [`RunFailure`] for a mate that is no gear.
    pub fn of_job(job: &MillingJob, bevel: &drawn::BevelGear) -> Result<Option<Self>, RunFailure> {
        let Some(mate) = &job.mate else { return Ok(None) };
        // A checked job has teeth for which there is a pitch cone.
        let Some(data) = mate.data(bevel) else { return Ok(None) };
        let made = |data, table| {
            BevelGear::new(data).map_err(|error| RunFailure::bad_input(geometry_finding(&error, table)))
        };
        let drawn = [made(bevel.data(), "bevel")?, made(data, "mate")?];
        let [own, other] = form_angles(&drawn, bevel.flank);
        let begins = |gear: &BevelGear, angle| BevelData { form_angle: Some(angle), ..*gear.data() };
        let gears = [made(begins(&drawn[0], own), "bevel")?, made(begins(&drawn[1], other), "mate")?];
        Ok(Some(Self { gears, flank: bevel.flank }))
    }
}

/// Polar angles at which the flanks begin, rad: as given, else so that the tip of the other gear finds a flank as far down as there can be
/// one.
fn form_angles([gear, mate]: &[BevelGear; 2], flank: BevelFlank) -> [f64; 2] {
    let start = |own: &BevelGear, other: &BevelGear| {
        if own.data().form_angle.is_some() {
            return own.form_angle();
        }
        let mut lowest = own.root_angle().max(own.base_angle());
        if flank == BevelFlank::Octoid {
            lowest = lowest.max(Octoid::new(own, Flank::Left).lowest_polar_angle() + SAME);
        }
        own.form_angle().min(needed_polar_angle(own, other).map_or(lowest, |needed| needed.max(lowest)))
    };
    [start(gear, mate), start(mate, gear)]
}
