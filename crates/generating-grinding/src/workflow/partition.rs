//! Who uses which part of the tool: areas side by side, roughing and finishing, and the strokes of a tool whose threads are
//! partly left out (`docs/mathematics/planning.md#choice-of-the-ratio`). Cylindrical bodies.

use super::occupation::occupation_chart;
use super::prepare::Prepared;
use super::roughing_pass::{RoughingArea, RoughingPass};
use foundation::geometry::Sides;
use foundation::kinematics::MotionLaw;
use generating::areas::{AreaKind, AreaPlan, AreaSet, AreaTask, Occupation, WormExtent};
use generating::{FlankLines, GeneratingError, GrindingSetup};
use job::Diagnostic;
use report::charts::WormOccupationChart;
use run::RunFailure;
use schemars::JsonSchema;
use serde::Serialize;

/// The partition of the tool.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Partition {
    /// Length of one finishing area.
    pub area_length_mm: f64,
    /// Distance of neighbouring finishing areas.
    pub area_pitch_mm: f64,
    /// Finishing areas that fit beside the roughing areas; absent without a tool width.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub areas_that_fit: Option<usize>,
    /// Finishing areas laid out.
    pub areas: usize,
    /// Roughing areas laid out.
    pub roughing_areas: usize,
    /// Length from the first area to the end of the last.
    pub length_mm: f64,
    /// Added to z_V1 of the plan for each area, roughing first.
    pub shifts_mm: Vec<f64>,
    /// z_V2 at which the shift of the area plans begins at 0, mm.
    #[serde(skip)]
    first_feed: f64,
    #[serde(skip)]
    chart: WormOccupationChart,
}

/// Where the passes of a program use the tool, as the areas are laid out over its width.
#[derive(Clone, Debug, PartialEq)]
pub struct ToolAreas {
    /// Added to z_V1 of the plan in every finishing area, mm.
    pub finishing: Vec<f64>,
    /// What strokes do in every roughing area.
    pub roughing: Vec<RoughingPass>,
}

/// The plan of one area with a single ratio.
fn plain_area(lines: &Sides<Option<FlankLines>>, ratio: f64) -> Result<AreaPlan, GeneratingError> {
    AreaTask { lines: *lines, regions: Vec::new(), free_ratio: ratio }.plan()
}

/// A plan that takes so much more room at both of its ends, mm.
fn widened(plan: AreaPlan, room: f64) -> AreaPlan {
    let wider = |[from, to]: [f64; 2]| [from - room, to + room];
    let extents = plan.extents.map(|_, extent| {
        extent.as_ref().map(|extent| WormExtent { z_1: wider(extent.z_1), line: wider(extent.line) })
    });
    AreaPlan { extents, ..plan }
}

/// The plan of one finishing area under a law: its real extent on the tool.
fn finishing_area(
    prepared: &Prepared,
    lines: &Sides<Option<FlankLines>>,
    ratio: f64,
    shift: &MotionLaw,
) -> Result<AreaPlan, GeneratingError> {
    match &prepared.areas {
        Some(areas) => Ok(areas.clone()),
        None => {
            let mut plan = plain_area(lines, ratio)?;
            if !shift.is_affine() {
                let extents = plan.extents;
                plan.extents = extents.map(|flank, extent| {
                    let lines = lines[flank].as_ref()?;
                    extent.as_ref()?;
                    Some(WormExtent { z_1: lines.occupation(shift), line: lines.line_range(shift) })
                });
            }
            Ok(plan)
        }
    }
}

impl Partition {
    /// Lays the areas of a job side by side; `None` for conical bodies, whose areas are not alike.
    ///
    /// # Errors
    /// A tool too short for the areas that the job asks for.
    pub fn of_cycle(prepared: &Prepared, ratio: f64, shift: &MotionLaw) -> Result<Option<Self>, RunFailure> {
        let setup = &prepared.setup;
        if !setup.pair.worm.is_cylindrical() || !setup.pair.work.is_cylindrical() {
            return Ok(None);
        }
        let fault = |e: GeneratingError| {
            let finding = Diagnostic::with_code(e.code(), e.to_string()).field("grinding.areas");
            RunFailure::not_producible(finding.way_out(
                "take a wider tool, fewer areas (grinding.areas, grinding.roughing_areas), or a smaller ratio",
            ))
        };
        let lines = Sides::from_fn(|flank| prepared.targets[flank].as_ref().map(|_| setup.lines[flank]));
        let finishing = finishing_area(prepared, &lines, ratio, shift).map_err(fault)?;
        // An area with a modification of its own has ways to those beside it, over which the dresser goes.
        let modified = prepared.cycle.roughing.iter().any(|area| area.share.is_some());
        let room = if modified { 0.75 * passage(setup) + beside_area(setup) } else { 0.0 };
        let roughing = prepared
            .cycle
            .roughing
            .iter()
            .map(|area| plain_area(&lines, area.ratio).map(|plan| widened(plan, room)))
            .collect::<Result<Vec<AreaPlan>, GeneratingError>>()
            .map_err(fault)?;
        let plain = plain_area(&lines, 0.0).map_err(fault)?;
        // From one finishing area to the next the dresser has to come back to where the plan begins: no line of either lies there.
        let apart =
            if setup.input.dresser.is_some() { passage(setup) + 2.0 * beside_area(setup) } else { 0.0 };
        let sets = |areas: usize| -> Vec<AreaSet<'_>> {
            let roughing =
                roughing.iter().map(|plan| AreaSet { kind: AreaKind::Roughing, plan, count: 1, apart: 0.0 });
            roughing
                .chain([AreaSet { kind: AreaKind::Finishing, plan: &finishing, count: areas, apart }])
                .collect()
        };
        let asked = prepared.cycle.areas;
        let (occupation, fit) = match setup.input.worm_width {
            Some(width) => {
                let end = 0.5 * width - setup.run_in();
                let ends = [-end, end];
                let lay = |areas: usize| Occupation::lay(ends, &sets(areas));
                let mut fit = 0;
                while fit < MOST_AREAS && lay(fit + 1).is_ok() {
                    fit += 1;
                }
                (lay(asked.unwrap_or(1)).map_err(fault)?, Some(fit))
            }
            None => {
                // Without a width the areas are laid out on a tool just wide enough.
                let long = Occupation::lay([0.0, UNLIMITED], &sets(asked.unwrap_or(1))).map_err(fault)?;
                let half = 0.5 * long.needed;
                let room = 1e-6;
                let laid = Occupation::lay([-half - room, half + room], &sets(asked.unwrap_or(1)));
                (laid.map_err(fault)?, None)
            }
        };
        Ok(Some(Self {
            area_length_mm: finishing.length(),
            area_pitch_mm: finishing.pitch() + apart,
            areas_that_fit: fit,
            areas: asked.unwrap_or(1),
            roughing_areas: roughing.len(),
            length_mm: occupation.needed,
            shifts_mm: occupation.shifts.clone(),
            first_feed: plain.segments.first().map_or(0.0, |segment| segment.feed[0]),
            chart: occupation_chart("Areas over the width of the tool", &occupation),
        }))
    }

    /// The shifts of the programs that use more than one area; `None` where all passes use the area of the plan. `shift` is the plan's
    /// own law of the tool shift.
    pub fn tool_areas(&self, prepared: &Prepared, shift: &MotionLaw) -> Option<ToolAreas> {
        if self.roughing_areas == 0 && self.areas == 1 {
            return None;
        }
        // Areas of straight and of broken laws are laid out as if z_V1 were 0 at the first feed.
        let laid_from_zero = shift.is_affine() || prepared.areas.is_some();
        let planned = if laid_from_zero { shift.value(self.first_feed) } else { 0.0 };
        let pass = |(at, area): (&f64, &RoughingArea)| RoughingPass {
            shift: MotionLaw::polynomial(self.first_feed, vec![*at, area.ratio]),
            area: *area,
        };
        let finishing = self.shifts_mm.iter().skip(self.roughing_areas).map(|at| at - planned).collect();
        let roughing = self.shifts_mm.iter().zip(&prepared.cycle.roughing).map(pass).collect();
        Some(ToolAreas { finishing, roughing })
    }

    /// The picture of the tool's width.
    pub fn chart(&self) -> &WormOccupationChart {
        &self.chart
    }
}

/// Length over which the dresser goes from one finishing area to the next, mm.
pub fn passage(setup: &GrindingSetup) -> f64 {
    setup.run_in()
}

/// How far the dresser goes on as in a finishing area beside it, mm: stock and corrections move the lines that are touched, and it reaches
/// beyond the line on which it stands.
pub fn beside_area(setup: &GrindingSetup) -> f64 {
    0.25 * setup.run_in()
}

/// More areas than this are not counted.
const MOST_AREAS: usize = 1000;
/// Length for laying out areas on a tool without a stated width, mm.
const UNLIMITED: f64 = 1e6;
