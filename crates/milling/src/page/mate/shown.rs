//! A flank with its contact, as rolled and as its result has it.

use crate::page::shown_flank::flank_name;
use crate::workflow::{MateFlank, MateFlankResult, MateOutcome};

/// Contact on a flank of the gear.
pub(super) struct ShownContact<'a> {
    pub rolled: &'a MateFlank,
    pub result: &'a MateFlankResult,
    /// Whether it is that of a bevel gear.
    bevel: bool,
}

impl<'a> ShownContact<'a> {
    /// All flanks that were rolled.
    pub fn of_mate(mate: &'a MateOutcome) -> Vec<Self> {
        let of_flank = |rolled: &'a MateFlank| {
            let bevel = mate.result.centre_distance_mm.is_none();
            Some(Self { rolled, result: mate.result.flanks.get(rolled.side.name())?, bevel })
        };
        mate.flanks.iter().filter_map(of_flank).collect()
    }

    /// Heading, for example `Left flank`.
    pub fn name(&self) -> String {
        flank_name(self.rolled.side.name())
    }

    /// Names of both ends of the tooth, that of the smaller length first.
    pub fn ends(&self) -> [&'static str; 2] {
        if self.bevel { ["toe", "heel"] } else { ["lower face", "upper face"] }
    }
}
