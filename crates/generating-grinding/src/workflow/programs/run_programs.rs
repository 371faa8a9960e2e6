//! Programs and proof of a run of whatever process.

use super::build::Built;
use super::judge::{Judge, RunFlank};
use super::proof::proofs;
use super::result::ProgramsResult;
use super::task::ProgramTask;
use foundation::geometry::Sides;
use job::machine::LoadedMachine;
use run::RunFailure;
use std::time::Instant;
use verdict::Remark;

/// Programs and proof of a run.
pub struct RunPrograms {
    /// For `result.json`.
    pub result: ProgramsResult,
    /// Texts and traces.
    pub built: Built,
    /// The machine.
    pub machine: LoadedMachine,
    /// Remarks.
    pub warnings: Vec<Remark>,
    /// Seconds for the programs, and for their proof.
    pub seconds: [f64; 2],
}

impl RunPrograms {
    /// Makes the programs of a task and has them proven. `judge` runs the referee on what was read back; `flanks` are those of the run
    /// itself.
    ///
    /// # Errors
    /// [`RunFailure`]: a machine that cannot do it; programs that are not proven.
    pub fn new(
        task: &ProgramTask<'_>,
        feed_given: bool,
        flanks: &Sides<Option<RunFlank>>,
        judge: &impl Judge,
    ) -> Result<Self, RunFailure> {
        let begun = Instant::now();
        let built = task.build().map_err(|failure| task.with_ways(failure))?;
        let written = begun.elapsed().as_secs_f64();
        let proofs = proofs(task, &built, flanks, judge)?;
        let result = ProgramsResult::new(task, &built, proofs);
        let mut warnings = built.warnings.clone();
        if !feed_given {
            warnings.push(Remark {
                code: "feed-by-default",
                text: format!(
                    "the programs feed {} mm per revolution of the gear",
                    task.technology.finishing().feed_per_revolution
                ),
                way_out: "give grinding.feed_per_revolution".into(),
            });
        }
        let seconds = [written, begun.elapsed().as_secs_f64() - written];
        Ok(Self { result, built, machine: task.machine.clone(), warnings, seconds })
    }
}
