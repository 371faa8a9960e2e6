//! Programs and proof of a run of whatever process.

use super::build::Built;
use super::proof::{Judge, RunFlank, proofs};
use super::result::ProgramsResult;
use super::task::ProgramTask;
use crate::exchange::job::Program as DialectName;
use crate::exchange::machine::LoadedMachine;
use crate::geometry::Sides;
use crate::workflow::finding::{Remark, RunFailure};
use std::time::Instant;

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

/// The dialects that a job asks for; without a wish, those of the machine.
pub(in crate::workflow) fn dialects(asked: &[DialectName], machine: &LoadedMachine) -> Vec<DialectName> {
    if !asked.is_empty() {
        return asked.to_vec();
    }
    let all = [DialectName::Linuxcnc, DialectName::Siemens, DialectName::Fanuc];
    all.into_iter().filter(|&dialect| machine.file.controls.of(dialect).is_some()).collect()
}

impl RunPrograms {
    /// Makes the programs of a task and has them proven. `judge` runs the referee on what was read back; `flanks` are those of the run
    /// itself.
    ///
    /// # Errors
    /// [`RunFailure`]: a machine that cannot do it; programs that are not proven.
    pub(super) fn new(
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
                    task.technology.feed_per_revolution
                ),
                way_out: "give grinding.feed_per_revolution".into(),
            });
        }
        let seconds = [written, begun.elapsed().as_secs_f64() - written];
        Ok(Self { result, built, machine: task.machine.clone(), warnings, seconds })
    }
}
