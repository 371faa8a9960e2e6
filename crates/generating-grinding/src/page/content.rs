//! What a page on ground flanks shows: results and figures, in no order yet.

use super::motions::DressingCurves;
use super::target_amounts::TargetAmount;
use super::traces::traces;
use crate::workflow::ChangeResult;
use crate::workflow::drawn_values::TraceDirection;
use crate::workflow::executed_strokes::ExecutedStroke;
use crate::workflow::result::{FlankResult, SettingsResult};
use foundation::geometry::Sides;
use report::charts::{ChartError, DressingSectionChart, RangeMark, Topography, WormOccupationChart};
use report::{Block, FlankStages, Quantity, Sheet};
use run::{CharacteristicsUm, GrindingMotion, JobTitle, ToleranceResult};
use verdict::{Remark, Verdict};

/// What the page of a process that grinds flanks with a worm shows.
pub struct GrindingPage<'a> {
    /// Name, title block and language of the job.
    pub title: JobTitle<'a>,
    /// Process in words.
    pub process: &'static str,
    /// Status, reason and scope.
    pub verdict: &'a Verdict,
    /// Tolerance on the simulated deviation, um, normal.
    pub tolerance_um: f64,
    /// Tolerances of the drawing's class.
    pub class: Option<ToleranceResult>,
    /// Flanks that are ground.
    pub flanks: Sides<Option<ShownFlank<'a>>>,
    /// Settings, times, tools and tooth thickness for the first page.
    pub sheets: Vec<Sheet>,
    /// Data of the gear.
    pub gear: Vec<Quantity>,
    /// Data of the worm.
    pub worm: Vec<Quantity>,
    /// Data of the dresser.
    pub dresser: Vec<Quantity>,
    /// Settings of the machine and the process: distances, angles, feeds, used worm width.
    pub settings: Vec<Quantity>,
    /// The diagonal ratio and why it was chosen, for a plan that chose one.
    pub ratio: Option<&'a SettingsResult>,
    /// Who uses which part of the tool.
    pub occupation: Option<&'a WormOccupationChart>,
    /// Sections through dresser and thread space.
    pub sections: &'a [DressingSectionChart],
    /// The grinding motions over the feed: one, or one for each flank.
    pub grinding_motions: Vec<GrindingMotion>,
    /// Dressing corrections per flank; both equal if both flanks are dressed with one motion.
    pub dressing: Sides<Option<DressingCurves>>,
    /// Conditions of dressing with what is left of them, where some have a weight.
    pub conditions: Vec<Block>,
    /// The strokes per flank, where the worm is dressed in strokes.
    pub strokes: Sides<&'a [ExecutedStroke]>,
    /// What gearbox and servo leave, where the job describes its control.
    pub control: Vec<Block>,
    /// What strokes take of the stock, where the job gives one.
    pub removal: Vec<Block>,
    /// NC programs, where the job names a machine.
    pub programs: Vec<Block>,
    /// What to know, with a way out.
    pub warnings: &'a [Remark],
    /// Changes of the job that were planned because the flank is missed.
    pub changes: &'a [ChangeResult],
    /// What the settings leave with axes that are off, where the job gives some.
    pub deviated: Vec<Block>,
    /// What a measured worm says of the dressing axes, where the job gives one.
    pub measured_worm: Vec<Block>,
    /// How the result was verified.
    pub verification: Vec<Block>,
    /// Largest error by round of the precompensation, um.
    pub convergence: Option<&'a Sides<Vec<f64>>>,
    /// Files beside the page, with what is in them.
    pub files: &'a [(String, &'static str)],
}

/// A flank with its result. Topographies are normal to the flank, um, positive = material left standing.
pub struct ShownFlank<'a> {
    /// Amounts that the drawing asks for.
    pub amounts: Vec<TargetAmount>,
    /// What came out.
    pub result: &'a FlankResult,
    /// Characteristics of the planned flank.
    pub planned: CharacteristicsUm,
    /// Its topographies and traces.
    pub stages: FlankStages,
}

impl<'a> ShownFlank<'a> {
    /// Of a result.
    ///
    /// # Errors
    /// [`ChartError`] for topographies that are none.
    pub fn of(
        amounts: Vec<TargetAmount>,
        result: &'a FlankResult,
        planned: CharacteristicsUm,
    ) -> Result<Self, ChartError> {
        let map =
            |rows: &[Vec<f64>]| Topography::new(result.w_mm.clone(), result.z_mm.clone(), rows.to_vec());
        let (target, simulated) = (map(&result.target_um)?, map(&result.simulated_um)?);
        let (profiles, helices) = traces(&simulated, &target);
        let planned_map = map(&result.planned_um)?;
        let stages = FlankStages {
            target,
            planned: planned_map,
            simulated: Some(simulated),
            profile_marks: marks(result, TraceDirection::Profile),
            helix_marks: marks(result, TraceDirection::Helix),
            profiles,
            helices,
        };
        Ok(Self { amounts, result, planned, stages })
    }
}

/// Ends of the evaluated range of the traces of a direction, and of their parts without reliefs.
fn marks(result: &FlankResult, direction: TraceDirection) -> Vec<RangeMark> {
    let mut marks: Vec<RangeMark> = Vec::new();
    let mut mark = |at_mm: f64, ends_range: bool| {
        if marks.iter().all(|known| (known.at_mm - at_mm).abs() > SAME_PLACE) {
            marks.push(RangeMark { at_mm, ends_range });
        }
    };
    let of = || result.traces.iter().filter(|trace| trace.direction == direction);
    of().for_each(|trace| trace.range_mm.into_iter().for_each(|at| mark(at, true)));
    of().for_each(|trace| trace.unrelieved_mm.into_iter().for_each(|at| mark(at, false)));
    marks
}

/// Marks nearer to each other are one, mm.
const SAME_PLACE: f64 = 1e-6;
