//! What a page on ground flanks shows: results and figures, in no order yet.

use super::motions::DressingCurves;
use super::target_amounts::TargetAmount;
use super::traces::traces;
use crate::workflow::executed_strokes::ExecutedStroke;
use crate::workflow::result::{FlankResult, SettingsResult};
use foundation::geometry::Sides;
use job::tables::JobInfo;
use report::charts::{ChartError, DressingSectionChart, Topography, WormOccupationChart};
use report::{Block, FlankStages, Quantity};
use run::{CharacteristicsUm, GrindingMotion};
use verdict::{Remark, Verdict};

/// What the page of a process that grinds flanks with a worm shows.
pub struct GrindingPage<'a> {
    /// Name and description of the job.
    pub info: &'a JobInfo,
    /// Process in words.
    pub process: &'static str,
    /// Version of the program.
    pub version: &'a str,
    /// Status, reason and scope.
    pub verdict: &'a Verdict,
    /// Tolerance on the simulated deviation, um, normal.
    pub tolerance_um: f64,
    /// Flanks that are ground.
    pub flanks: Sides<Option<ShownFlank<'a>>>,
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
        let stages =
            FlankStages { target, planned: planned_map, simulated: Some(simulated), profiles, helices };
        Ok(Self { amounts, result, planned, stages })
    }
}
