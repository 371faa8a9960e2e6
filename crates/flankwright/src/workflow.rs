//! Tasks on jobs, and what they come to: what command, server and Python call. What is special to a process stands in a module by its name.

pub use ::inspection::workflow::{GearOfRexs, gear_of_rexs, rexs_of_job};
pub use ::run::program_check::{
    BodyClearance, CheckedAxis, CheckedFlank, CheckedMeasuring, CheckedProgram, CheckedStroke, PartProof,
    ProgramCheck, ProgramFault, ThreadProof,
};
pub use ::run::{
    Answer, AnyProcess, CharacteristicsUm, Conclusion, DerivedGeometry, DerivedQuantity, DerivedSection,
    DocumentFormat, FlankMaps, JobFailure, JobTitle, Preview, PreviewChart, PreviewFlank, Process, Processes,
    Remark, RunFailure, Task, TaskOutcome, WriteError, blank_of_job, cancel, gear_of_job, json, report_head,
    summary, write_with_report,
};
pub use generating_grinding::workflow::{
    AxisInfluence, AxisResult, Built, BuiltProgram, CandidateResult, CatalogueLimits, CatalogueOutcome,
    CataloguePair, ClearanceResult, ControlFlankResult, ControlResult, CrowningCurve, CrowningPoint,
    CurveEnd, Deviation, DeviationCurve, DeviationQuantile, DressingModel, DressingStudyOutcome,
    DressingWork, EqualRatioOffer, ErrorTrace, ExecutedFlank, Execution, ExploreCandidate, ExploreOutcome,
    FilletResult, FilletSection, FlankFigures, FlankResult, ForwardModel, FreeOutcome, FreePair, FreePoint,
    FreeRange, GearRootResult, GrindingWork, Indexing, JobOutcome, JobResult, LifeCurve, LifePoint,
    LineDressingResult, MOST_COMBINATIONS, MOST_PAIRS, Outcome, PAIR_RANKING, PairFlank, PairLife, Partition,
    PassResult, PlannedPair, Prepared, ProfileCurve, ProgramResult, ProgramTask, ProgramsResult, ProofResult,
    RANKING, Refused, RunPrograms, SettingsResult, StageReport, StrokeCurve, StrokeFigures, StrokePlan,
    StudyCurves, Trace, Verdict, WormCurve, WormPoint, WormUse, WrittenFlank, controlled, equal_ratio_offers,
    explore_job, occupation_chart, plan_from_catalogue, plan_job, prepare, proven, rank_catalogue,
    setup_of_job, simulate_job, study_dressing, study_free_worm, tolerance_of_job, wanted_of_catalogue,
    write_catalogue, write_dressing_study, write_exploration, write_free_study, write_outcome,
};
pub use verdict::Status;

use crate::processes;
use ::job::machine::LoadedMachine;
use ::job::{AnyJob, Diagnostic};
use ::run::program_check::checked_program;
use foundation::numerics::Progress;
use nc::Dialect;
use std::io::BufRead;
use std::path::{Path, PathBuf};

/// Tangential dressing.
pub mod tangential {
    pub use ::tangential_dressing::workflow::*;
}

/// The electronic gearbox.
pub mod gearbox {
    pub use ::gearbox::workflow::*;
}

/// Five-axis milling.
pub mod milling {
    pub use ::milling::workflow::*;
}

/// Measuring a skiving tool.
pub mod skiving {
    pub use ::skiving::workflow::*;
}

/// Inspection of gears.
pub mod inspection {
    pub use ::inspection::workflow::*;
}

/// Bodies and motions for a view in space.
pub mod scene {
    pub use ::milling::workflow::scene::scene_of_milling;
    pub use ::scene::{Body, BodyKind, Coordinate, Frame, Scene, Stage};
    pub use ::skiving::workflow::scene::scene_of_skiving;
    pub use ::tangential_dressing::workflow::scene::scene_of_tangential;
    pub use generating_grinding::workflow::scene::scene_of_grinding;
}

/// Carries a task out on a job of any process.
///
/// # Errors
/// [`JobFailure`]: a job or a file that it names is at fault, the process has no such task, or the bodies cannot make the target. A target
/// that is missed is no error.
pub fn carry_out(
    task: Task,
    job: &AnyJob,
    progress: &dyn Progress,
) -> Result<Box<dyn TaskOutcome>, JobFailure> {
    let outcome = processes().carry_out(task, job, progress)?;
    match outcome.refusal() {
        Some(refusal) => Err(refusal.clone().into()),
        None => Ok(outcome),
    }
}

/// What follows from a job of any process before anything is planned, and remarks on it.
///
/// # Errors
/// [`JobFailure`]: bodies or targets that cannot exist, a file that the job names.
pub fn derived_geometry(job: &AnyJob) -> Result<(DerivedGeometry, Vec<Remark>), JobFailure> {
    processes().derived_geometry(job)
}

/// The plan of a job of any process without its referee.
///
/// # Errors
/// [`JobFailure`] as for a plan; a process without a preview, a job that takes its bodies from a catalogue.
pub fn preview_job(job: &AnyJob) -> Result<Preview, JobFailure> {
    processes().preview(job)
}

/// Writes what a job that its bodies cannot make hands over: `result.json` with status, reason, bodies and candidates, and the report with
/// the picture of what limits; returns their paths, the report last.
///
/// # Errors
/// [`WriteError`].
pub fn write_refusal(
    job: &AnyJob,
    finding: &Diagnostic,
    directory: &Path,
) -> Result<Vec<PathBuf>, WriteError> {
    ::run::write_refusal(processes(), job, finding, directory)
}

/// Checks any number of programs on one machine and on the bodies of one job, whose own run is made once.
pub struct ProgramChecker<'a> {
    machine: &'a LoadedMachine,
    bodies: Option<Box<dyn ProgramCheck + 'a>>,
}

impl<'a> ProgramChecker<'a> {
    /// On a machine alone, or with the bodies of a job.
    ///
    /// # Errors
    /// A process that has no programs; what the job's own run says.
    pub fn new(
        machine: &'a LoadedMachine,
        job: Option<&'a AnyJob>,
        progress: &dyn Progress,
    ) -> Result<Self, RunFailure> {
        let bodies = job
            .map(|job| {
                let made = processes().of(job)?.program_check(job, machine, progress);
                made.unwrap_or_else(|| Err(RunFailure::bad_input(processes().refused("program check", job))))
            })
            .transpose()?;
        Ok(Self { machine, bodies })
    }

    /// Reads a program of a dialect and follows it; `netlist`: the HAL netlist of a LinuxCNC program whose gears are in one.
    ///
    /// # Errors
    /// [`RunFailure`]: a text that is no program, axes that the machine has not, no stroke on these bodies.
    pub fn check(
        &self,
        (mut text, netlist): (impl BufRead, Option<&str>),
        dialect: Dialect,
        progress: &dyn Progress,
    ) -> Result<CheckedProgram, RunFailure> {
        match &self.bodies {
            Some(bodies) => bodies.check(&mut text, netlist, dialect, progress),
            None => checked_program(text, netlist, dialect, self.machine).map(|(checked, _)| checked),
        }
    }
}

/// Reads a program of a dialect and follows it on a machine; with a job also to the flank. `netlist`: the HAL netlist of a LinuxCNC
/// program whose gears are in one.
///
/// # Errors
/// [`RunFailure`]: a text that is no program, axes that the machine has not, a job that cannot be planned.
pub fn check_program(
    program: (impl BufRead, Option<&str>),
    dialect: Dialect,
    machine: &LoadedMachine,
    job: Option<&AnyJob>,
    progress: &dyn Progress,
) -> Result<CheckedProgram, RunFailure> {
    ProgramChecker::new(machine, job, progress)?.check(program, dialect, progress)
}

/// The documents that the program writes: those of the tasks of every process, of inspections, refusals, previews and checked programs.
pub fn documents() -> Vec<DocumentFormat> {
    let mut all: Vec<DocumentFormat> = processes().all().flat_map(|process| process.documents()).collect();
    all.extend([
        DocumentFormat::of::<::inspection::workflow::GearInspectionResult>("inspection", "result.json"),
        DocumentFormat::of::<::inspection::workflow::BevelInspectionResult>(
            "bevel-inspection",
            "result.json",
        ),
        DocumentFormat::of::<::inspection::workflow::series::InspectionSeriesResult>(
            "inspection-series",
            "series.json",
        ),
        DocumentFormat::of::<::inspection::workflow::BlankStockResult>("blank-stock", "blank.json"),
        DocumentFormat::of::<::run::RefusedResult<'static>>("refusal", "result.json"),
        DocumentFormat::of::<Preview>("preview", "the answer of a preview"),
        DocumentFormat::of::<CheckedProgram>("program-check", "the answer of `program check --json`"),
    ]);
    all
}
