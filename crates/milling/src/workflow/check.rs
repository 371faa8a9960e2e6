//! `program check` of a milling job: a text of any origin is read, followed on the machine, proven for the whole part, and its cutters are
//! milled against the flanks of the job's first space beside those of the job's own paths.

use super::clamping::Clamping;
use super::finding::failure;
use super::prepare::{Mounting, PreparedMilling, prepare_milling};
use super::programs::{CheckedMotion, ROUNDING};
use super::referee::{RefereedFlank, STOCK, rays, referee, swept};
use super::whole_program::{ProgramUnderTest, text_tolerance};
use super::work::{machining, work};
use crate::job::LoadedMillingJob;
use crate::{MillingPlan, plan_all};
use foundation::numerics::Progress;
use job::machine::LoadedMachine;
use job::{Diagnostic, Problem};
use nc::Dialect;
use run::RunFailure;
use run::program_check::{CheckedFlank, CheckedProgram, Moved, ProgramCheck, figures};
use std::collections::BTreeMap;
use std::io::BufRead;
use verdict::Remark;

/// A job made ready, so that texts can be held against it one after the other.
pub struct MillingCheck<'a> {
    prepared: PreparedMilling,
    mounting: Mounting,
    machine: &'a LoadedMachine,
    plan: MillingPlan,
    /// The flanks of the job's own paths.
    own: Vec<RefereedFlank>,
}

/// Checks a text against a job.
///
/// # Errors
/// [`RunFailure`]: a job without a machine table or that cannot be planned, a text that is no program for this machine and job.
pub fn check_milling(
    text: impl BufRead,
    dialect: Dialect,
    machine: &LoadedMachine,
    loaded: &LoadedMillingJob,
    progress: &dyn Progress,
) -> Result<CheckedProgram, RunFailure> {
    MillingCheck::new(loaded, machine, progress)?.check(text, dialect, progress)
}

impl<'a> MillingCheck<'a> {
    /// Plans the job.
    ///
    /// # Errors
    /// [`RunFailure`]: a job without a machine table or that cannot be planned.
    pub fn new(
        loaded: &LoadedMillingJob,
        machine: &'a LoadedMachine,
        progress: &dyn Progress,
    ) -> Result<Self, RunFailure> {
        let Some(given) = &loaded.job.machine else {
            let text = "a program can only be followed with the mount and the tool length of the job";
            let finding = Diagnostic::new(Problem::MissingKey, text).field("machine");
            return Err(RunFailure::bad_input(finding.way_out("give the table [machine] in the job")));
        };
        let prepared = prepare_milling(loaded)?;
        let bodies = &prepared.bodies;
        let plan = plan_all(&bodies.parts, &bodies.options).map_err(|error| failure(&error))?;
        let own = referee(bodies, &plan, prepared.rays, progress)?;
        Ok(Self { mounting: Mounting::of_job(given), prepared, machine, plan, own })
    }

    /// What a text does to axes and part.
    ///
    /// # Errors
    /// [`RunFailure`]: a text that is no program for this machine and job.
    pub fn check(
        &self,
        text: impl BufRead,
        dialect: Dialect,
        progress: &dyn Progress,
    ) -> Result<CheckedProgram, RunFailure> {
        let Self { prepared, mounting, machine, plan: made, own } = self;
        let work = &work(prepared, made);
        let found = machining(mounting, machine, &[]).follow_text(work, text, dialect)?;
        let CheckedMotion { read, moves, ranges, ways, speeds, duration, words, remarks, limits } = found;
        let moved = Moved {
            ranges: &ranges,
            ways: &ways,
            speeds: &speeds,
            duration,
            rounding: ROUNDING,
            tracked: None,
        };
        let mut checked = figures(&read, dialect, machine, &words, &moved);
        checked.kind = Some("milling");
        // The limits of the axes are told with their blocks instead.
        checked.remarks.clear();
        checked.remarks.extend(limits.into_iter().map(|fault| Remark {
            code: fault.code,
            text: format!("block {}: {}", fault.block, fault.text),
            way_out: fault.way_out,
        }));
        checked.remarks.extend(remarks);
        let (cutters, paths) = (work.cutters(), work.paths(&moves));
        let swept = swept(&cutters, &paths, STOCK)?;
        let under_test = ProgramUnderTest {
            bodies: &prepared.bodies,
            plan: made,
            work,
            moves: &moves,
            swept: &swept,
            tool_length: work.longest_tool(),
            tolerance: text_tolerance(prepared, mounting),
            clamping: Clamping::of_mounting(mounting),
        };
        let proof = under_test.prove(progress)?;
        let told =
            proof.faults.iter().map(|fault| Remark::new(fault.code, fault.text.clone(), fault.way_out));
        checked.remarks.extend(told);
        checked.part = Some(proof);
        let mut flanks = BTreeMap::new();
        for (plan, flank) in made.flanks.iter().zip(own) {
            let rays = rays(plan, &flank.heights, &flank.lengths);
            let milled =
                swept.mill(&rays, progress).map_err(|error| RunFailure::of_removal(&error, "milling"))?;
            let (mut max_deviation_um, mut difference_um) = (0.0f64, 0.0f64);
            for (ray, wanted) in milled.rays.iter().zip(&flank.simulated) {
                // Rays that no cutter meets are told with the whole part.
                let Ok(ray) = ray else { continue };
                max_deviation_um = max_deviation_um.max(1e3 * ray.length.abs());
                let difference = wanted.map_or(0.0, |wanted| 1e3 * (ray.length - wanted).abs());
                difference_um = difference_um.max(difference);
            }
            flanks.insert(flank.side.name(), CheckedFlank { max_deviation_um, difference_um });
        }
        checked.flanks = Some(flanks);
        Ok(checked)
    }
}

impl ProgramCheck for MillingCheck<'_> {
    fn check(
        &self,
        text: &mut dyn BufRead,
        _: Option<&str>,
        dialect: Dialect,
        progress: &dyn Progress,
    ) -> Result<CheckedProgram, RunFailure> {
        MillingCheck::check(self, text, dialect, progress)
    }
}
