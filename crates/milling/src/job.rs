//! The job file of five-axis milling as types: one table of the file, one file here. A `MillingJob` has the right keys, types and
//! ranges; contradictions between entries are found by [`job::read_any_job`]. What other processes say in the same words is taken
//! from [`generating_grinding::job`]. Knows nothing of how a cutter is led along a flank.

#[cfg(test)]
mod bad_input;
mod bevel;
mod blade;
mod checks;
mod compensation;
mod contact_height;
mod coolant;
mod cutter;
mod density;
mod end_move;
mod gear;
mod grid_gear;
mod lead;
mod machine;
mod mate;
mod measuring_grid;
mod milling;
mod naca;
mod output;
mod point_grid;
mod probe;
mod root;
mod roughing;
mod simulation;
mod stock;
mod target;
#[cfg(test)]
mod tests;
mod work_offset;

pub use self::milling::{CutSense, Milling, RowDistances, RowSequence, Spaces, Traversal};
pub use bevel::{BevelFlank, BevelGear, BevelSpiral, DoubleHelicalBevel, SpiralLine};
pub use blade::{Blade, BladePoints, BladeSide, RuledBlade};
pub use compensation::MillingCompensation;
pub use contact_height::{ContactHeight, HeightRamp};
pub use coolant::CutterCoolant;
pub use cutter::{CutterForm, CutterShank, MillingCutter};
pub use density::{Density, GridChoice};
pub use end_move::EndMove;
pub use gear::{DoubleHelical, MillingGear};
pub use grid_gear::{BodyLine, FlankPoints, GridGear};
pub use lead::Lead;
pub use machine::{LengthHolder, MillingMachine, MillingMount, PoleWay, Rtcp};
pub use mate::Mate;
pub use measuring_grid::MeasuringGrid;
pub use naca::{FourDigits, NacaBlade, NacaSide};
pub use output::MillingOutput;
pub use point_grid::{PointGrid, parse_point_grid, read_flank_points, read_point_grid};
pub use probe::TouchProbe;
pub use root::{MilledRoot, RootBottom};
pub use roughing::Roughing;
pub use simulation::MillingSimulation;
pub use stock::{MillingStock, StockForm};
pub use target::{EaseOffAmounts, MillingTarget};
pub use work_offset::WorkOffset;

use job::{Diagnostic, Loaded, ProcessJob};
use schemars::{JsonSchema, Schema, json_schema};
use serde::{Deserialize, Serialize};

use foundation::geometry::Flank;
use job::tables::{JobInfo, Language};

/// A job of five-axis milling: a cutter finishes the flanks of a gear, a bevel gear or a blade row by row.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(extend(
    "if" = { "required": ["gear"] },
    "then" = { "not": { "anyOf": [{ "required": ["bevel"] }, { "required": ["blade"] }, { "required": ["grid_gear"] }] } },
    "else" = {
        "if": { "required": ["bevel"] },
        "then": { "not": { "anyOf": [{ "required": ["blade"] }, { "required": ["grid_gear"] }] } },
        "else": {
            "if": { "required": ["blade"] },
            "then": { "not": { "required": ["grid_gear"] } },
            "else": { "required": ["grid_gear"] }
        }
    }
))]
pub struct MillingJob {
    /// Name and process.
    pub job: JobInfo,
    /// The workpiece, if it is a cylindrical gear.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub gear: Option<MillingGear>,
    /// The workpiece, if it is a bevel gear.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub bevel: Option<BevelGear>,
    /// The workpiece, if it has blades.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub blade: Option<Blade>,
    /// The workpiece, if it is a gear whose flanks are given by points.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub grid_gear: Option<GridGear>,
    /// The gear that a gear or bevel gear is rolled against.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub mate: Option<Mate>,
    /// The workpiece as it comes to the machine.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub stock: Option<MillingStock>,
    /// The wanted flank.
    #[serde(default)]
    pub target: MillingTarget,
    /// What paths are planned with beside the target, as an answer to a measurement.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub compensation: Option<MillingCompensation>,
    /// Where a measuring machine touches the flanks of a bevel gear; with it `plan` writes the points.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub measuring_grid: Option<MeasuringGrid>,
    /// The cutter that finishes the flanks.
    pub cutter: MillingCutter,
    /// The cutter of the bottom pass; default `cutter`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub bottom_cutter: Option<MillingCutter>,
    /// The cutter that clears the space; default `cutter`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub roughing_cutter: Option<MillingCutter>,
    /// How the flanks are milled.
    pub milling: Milling,
    /// Rays of the simulation, which are the points of the result.
    #[serde(default)]
    pub simulation: MillingSimulation,
    /// The machine for which programs are written; without one there are cutter locations only.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub machine: Option<MillingMachine>,
    /// What to write beside result and report.
    #[serde(default)]
    pub output: MillingOutput,
}

/// The workpiece of a job.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum MilledBody<'a> {
    /// A cylindrical gear.
    Gear(&'a MillingGear),
    /// A bevel gear.
    Bevel(&'a BevelGear),
    /// Blades.
    Blade(&'a Blade),
    /// A gear by points.
    Grid(&'a GridGear),
}

/// What a cutter does.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CutterUse {
    /// It finishes flanks.
    Finishing,
    /// It mills the bottom of the space.
    Bottom,
    /// It clears the space.
    Roughing,
}

impl MillingJob {
    /// The workpiece; `None` only for a job that was built in code without one.
    pub fn body(&self) -> Option<MilledBody<'_>> {
        let gear = self.gear.as_ref().map(MilledBody::Gear);
        let bevel = || self.bevel.as_ref().map(MilledBody::Bevel);
        let blade = || self.blade.as_ref().map(MilledBody::Blade);
        gear.or_else(bevel).or_else(blade).or_else(|| self.grid_gear.as_ref().map(MilledBody::Grid))
    }

    /// Flanks that are milled: as `milling.flanks` has it, by default both; of a blade the side that its table describes.
    pub fn flanks(&self) -> Vec<Flank> {
        if let Some(blade) = &self.blade {
            return blade.side().map(BladeSide::flank).into_iter().collect();
        }
        let flanks = self.milling.flanks.unwrap_or_default();
        [Flank::Left, Flank::Right].into_iter().filter(|flank| flanks.includes(*flank)).collect()
    }

    /// From the nose of the spindle to the tip of a cutter, mm; `None` without a machine where the cutter does not say it.
    pub fn tool_length_of(&self, cutter: &MillingCutter) -> Option<f64> {
        cutter.tool_length.or(self.machine.as_ref().map(|machine| machine.tool_length))
    }

    /// The cutter for a purpose and its number in programs: its own, else 1 for `cutter`, 2 for `bottom_cutter`, 3 for
    /// `roughing_cutter`. Without a table of its own a purpose is served by `cutter`.
    pub fn cutter_for(&self, purpose: CutterUse) -> (&MillingCutter, u32) {
        let own = match purpose {
            CutterUse::Finishing => None,
            CutterUse::Bottom => self.bottom_cutter.as_ref().map(|cutter| (cutter, 2)),
            CutterUse::Roughing => self.roughing_cutter.as_ref().map(|cutter| (cutter, 3)),
        };
        let (cutter, usual) = own.unwrap_or((&self.cutter, 1));
        (cutter, cutter.number.unwrap_or(usual))
    }
}

/// Two numbers of one range each.
fn pair_schema(least: f64, most: f64, way_out: &str) -> Schema {
    json_schema!({
        "type": "array",
        "items": { "type": "number", "minimum": least, "maximum": most, "x-way-out": way_out },
        "minItems": 2,
        "maxItems": 2
    })
}

/// A checked job of five-axis milling.
pub type LoadedMillingJob = Loaded<MillingJob>;

impl ProcessJob for MillingJob {
    const NAME: &'static str = "five-axis-milling";
    const ABOUT: &'static str = "Five-axis milling of gears and blades.";
    const TEMPLATE: &'static str = include_str!("job/template.toml");

    fn info(&self) -> &JobInfo {
        &self.job
    }

    fn language(&self) -> Language {
        self.output.language
    }

    fn contradictions(&self) -> Vec<Diagnostic> {
        checks::check(self)
    }
}
