//! From a checked job of measuring a skiving tool to edges, tracks and poses, and to the tables that the stages of a run take. What stands
//! behind [`prepare_skiving`] reads no job. Every finding names the job's key.

mod beam;
mod bodies;
mod calibration;
mod drawn;
mod mounting;
mod needs;
mod noted_history;
mod recording;

pub use bodies::SkivingBodies;
pub use calibration::{CalibrationOutcome, MandrelDrive};
pub use drawn::Drawn;
pub use mounting::ToolMounting;
pub use noted_history::HistoryFile;
pub use recording::Recording;

pub(super) use needs::needs_measurement;

use crate::job::{
    LoadedSkivingJob, MonteCarlo, RunoutCorrection, SkivingOutput, Stylus, ToolErrors, WorkpieceProbe,
};
use job::machine::LoadedMachine;
use job::tables::JobInfo;
use run::program_check::machine_of_job;
use run::{Release, RunFailure, parquet_warning};
use std::path::PathBuf;
use verdict::{Remark, Verdict};

/// A job made ready for measuring.
#[derive(Clone, Debug)]
pub struct PreparedSkiving {
    /// Name, process and description of the job.
    pub info: JobInfo,
    /// Edges, tracks and poses.
    pub bodies: SkivingBodies,
    /// Tool, workpiece and light barrier as they are drawn.
    pub drawn: Drawn,
    /// Senses, turns and times of the measurement at the light barrier.
    pub recording: Recording,
    /// Largest deviation of the workpiece's profile that is allowed, um.
    pub tolerance_um: f64,
    /// The file of readings that the job names.
    pub readings: Option<PathBuf>,
    /// Errors of the tool whose measurement is simulated.
    pub tool_errors: Option<ToolErrors>,
    /// How the run-out of the tool is answered.
    pub runout: Option<RunoutCorrection>,
    /// A probe that measures the machined workpiece.
    pub probe: Option<WorkpieceProbe>,
    /// The file of its values that the job names.
    pub probe_readings: Option<PathBuf>,
    /// A stylus that scans the edges.
    pub stylus: Option<Stylus>,
    /// How often the measurement is repeated with other noise.
    pub monte_carlo: Option<MonteCarlo>,
    /// The history in which the measurement is noted.
    pub history: Option<HistoryFile>,
    /// How the tool sits in the machine, where the job names one.
    pub mounting: Option<ToolMounting>,
    /// The machine whose programs are wanted, once [`PreparedSkiving::on_machine`] has read it.
    pub machine: Option<LoadedMachine>,
    /// What is written beside result and report.
    pub output: SkivingOutput,
    /// Remarks on the job, each with a way out.
    pub warnings: Vec<Remark>,
}

/// Edges, tracks and poses of a job, and what is done with them.
///
/// # Errors
/// [`RunFailure`] with a finding on the key concerned.
pub fn prepare_skiving(loaded: &LoadedSkivingJob) -> Result<PreparedSkiving, RunFailure> {
    let job = &loaded.job;
    Ok(PreparedSkiving {
        info: job.job.clone(),
        bodies: bodies::bodies_of_job(loaded)?,
        drawn: Drawn::of_job(job),
        recording: Recording::of_job(&job.measuring),
        tolerance_um: job.target.tolerance_um,
        readings: job.readings.as_ref().map(|given| loaded.beside(&given.file)),
        tool_errors: job.tool_errors.clone(),
        runout: job.runout,
        probe: job.workpiece_probe.clone(),
        probe_readings: job
            .workpiece_probe
            .as_ref()
            .and_then(|given| given.readings.as_ref())
            .map(|file| loaded.beside(file)),
        stylus: job.stylus.clone(),
        monte_carlo: job.monte_carlo,
        history: job.history.as_ref().map(|given| HistoryFile::of_job(loaded, given)),
        mounting: job.machine.as_ref().map(ToolMounting::of_job),
        machine: None,
        output: job.output.clone(),
        warnings: parquet_warning(&job.output.tables).into_iter().collect(),
    })
}

impl PreparedSkiving {
    /// With the machine of the job, where it names one, so that programs are made for it.
    ///
    /// # Errors
    /// [`RunFailure`] for a description that cannot be read.
    pub fn on_machine(self, loaded: &LoadedSkivingJob) -> Result<Self, RunFailure> {
        let given = loaded.job.machine.as_ref();
        let machine = given.map(|given| machine_of_job(&loaded.document, &given.file)).transpose()?;
        Ok(Self { machine, ..self })
    }

    /// Measuring programs are there to find out about a tool, however it turns out: they are written with the verdict in their first lines.
    /// Only where the ideal edge does not make the flank (`sound`) their poses are in doubt, and they are written on request.
    pub fn release(&self, verdict: &Verdict, sound: bool) -> Release {
        Release::of(verdict, sound || self.output.programs_of_missed)
    }
}
