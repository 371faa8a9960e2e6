//! A bevel gear of a job and its mate, both with the start of the flank that the drawing says or that follows from the tip of the other.

use super::ease_off::amounts;
use crate::job::{BevelFlank, MillingJob};
use crate::workflow::mate_flank::{SAME, needed_polar_angle};
use foundation::geometry::{BevelData, BevelGear, EaseOffAmounts, Flank, Octoid};
use run::{RunFailure, geometry_finding};

/// Two bevel gears that roll together, the one that is milled first. Lengths in mm.
#[derive(Clone, Debug)]
pub struct MatePair {
    /// The gears.
    pub gears: [BevelGear; 2],
    /// Form of their flanks.
    pub flank: BevelFlank,
    /// Their ease-offs.
    pub ease_offs: [EaseOffAmounts; 2],
    /// Thickness of the marking compound, um.
    pub marking_um: f64,
    /// Roll positions for each mesh period.
    pub roll_positions: usize,
}

impl MatePair {
    /// Of a job; `None` without a mate.
    ///
    /// # Errors
    /// [`RunFailure`] for a mate that is no gear.
    pub(super) fn of_job(job: &MillingJob) -> Result<Option<Self>, RunFailure> {
        let (Some(mate), Some(bevel)) = (&job.mate, &job.bevel) else { return Ok(None) };
        // A checked job has teeth for which there is a pitch cone.
        let Some(data) = mate.data(bevel) else { return Ok(None) };
        let made = |data, table| {
            BevelGear::new(data).map_err(|error| RunFailure::bad_input(geometry_finding(&error, table)))
        };
        let drawn = [made(bevel.data(), "bevel")?, made(data, "mate")?];
        let [own, other] = form_angles(&drawn, bevel.flank);
        let begins = |gear: &BevelGear, angle| BevelData { form_angle: Some(angle), ..*gear.data() };
        let gears = [made(begins(&drawn[0], own), "bevel")?, made(begins(&drawn[1], other), "mate")?];
        Ok(Some(Self {
            gears,
            flank: bevel.flank,
            ease_offs: [job.target.ease_off.unwrap_or_default(), mate.ease_off].map(amounts),
            marking_um: mate.marking_um,
            roll_positions: mate.roll_positions,
        }))
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
