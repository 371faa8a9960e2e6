//! A flank that is milled, with its plan and its result, and what both of its parameters are called.

use crate::workflow::{FlankResult, MillingResult};
use crate::{FlankPlan, MillingPlan};

/// A flank of a run.
#[derive(Clone, Copy)]
pub(super) struct ShownFlank<'a> {
    pub plan: &'a FlankPlan,
    pub result: &'a FlankResult,
}

impl<'a> ShownFlank<'a> {
    /// All flanks of a run in the order of its plan.
    pub fn of_run(plan: &'a MillingPlan, result: &'a MillingResult) -> Vec<Self> {
        let of_plan = |plan: &'a FlankPlan| Some(Self { plan, result: result.flanks.get(plan.side.name())? });
        plan.flanks.iter().filter_map(of_plan).collect()
    }

    /// Heading, for example `Left flank`.
    pub fn name(&self) -> String {
        flank_name(self.plan.side.name())
    }

    /// Height and length parameter by their units: length of roll and position of cylindrical gears, roll angle and distance from the
    /// apex of bevel gears, fractions of blades.
    pub fn titles(&self) -> [&'static str; 2] {
        match self.result.height_unit {
            "mm" => ["length of roll w [mm]", "z [mm]"],
            "rad" => ["roll angle [rad]", "distance from the apex [mm]"],
            _ => ["height, hub to tip [1]", "along the blade [1]"],
        }
    }
}

/// The name of a side as a heading.
pub(super) fn flank_name(side: &str) -> String {
    format!("{}{} flank", side[..1].to_uppercase(), &side[1..])
}
