//! `program check` of a milling job: a text of any origin is read, followed on the machine, and its cutters are milled against the
//! flanks of the job beside those of the job's own paths.

use super::bodies::prepare_milling;
use super::finding::failure;
use super::of_job::{machining, work};
use super::programs::CheckedMotion;
use super::referee::{DEPTH, STOCK, rays, referee};
use crate::exchange::machine::LoadedMachine;
use crate::exchange::{Diagnostic, LoadedMillingJob, Problem};
use crate::geometry::Cutter;
use crate::nc::Dialect;
use crate::numerics::Progress;
use crate::process::milling::plan_all;
use crate::removal::{Milling, Unmilled, mill};
use crate::workflow::finding::{Remark, RunFailure};
use crate::workflow::programs::{CheckedFlank, CheckedProgram, Moved, figures};
use std::collections::BTreeMap;
use std::io::BufRead;

/// Blocks of a hundredth of a millimetre with the usual four decimals: by so much of its speed an axis seems too fast where the plan
/// is at its limit.
const ROUNDING: f64 = 0.01;

/// Checks a text against a job.
///
/// # Errors
/// [`RunFailure`]: a job without a machine table or that cannot be planned, a text that is no program for this machine and job.
pub(in crate::workflow) fn check_milling(
    text: impl BufRead,
    dialect: Dialect,
    machine: &LoadedMachine,
    loaded: &LoadedMillingJob,
    progress: &dyn Progress,
) -> Result<CheckedProgram, RunFailure> {
    let job = &loaded.job;
    let Some(given) = &job.machine else {
        let text = "a program can only be followed with the mount and the tool length of the job";
        let finding = Diagnostic::new(Problem::MissingKey, text).field("machine");
        return Err(RunFailure::bad_input(finding.way_out("give the table [machine] in the job")));
    };
    let bodies = prepare_milling(loaded)?;
    let made = plan_all(&bodies.parts, &bodies.options).map_err(|error| failure(&error))?;
    let work = work(job, &bodies, &made);
    let found = machining(given, machine, &[]).follow_text(&work, text, dialect)?;
    let counts = [job.simulation.rays_profile, job.simulation.rays_length];
    let own = referee(&bodies, &made, counts, progress)?;

    let CheckedMotion { read, paths, ranges, ways, speeds, duration, words, remarks } = found;
    let moved = Moved { ranges: &ranges, ways: &ways, speeds: &speeds, duration, rounding: ROUNDING };
    let mut checked = figures(&read, dialect, machine, &words, &moved);
    checked.kind = Some("milling");
    checked.remarks.extend(remarks);
    let cutters: Vec<Cutter> = work.tools.iter().map(|tool| tool.cutter.clone()).collect();
    let setup = Milling { cutters: &cutters, paths: &paths, stock: STOCK, depth: DEPTH };
    let mut flanks = BTreeMap::new();
    for (plan, flank) in made.flanks.iter().zip(&own) {
        let rays = rays(plan, &flank.heights, &flank.lengths);
        let milled =
            mill(&setup, &rays, progress).map_err(|error| RunFailure::of_removal(&error, "milling"))?;
        let (mut max_deviation_um, mut difference_um) = (0.0f64, 0.0f64);
        let mut unmilled: Vec<Unmilled> = Vec::new();
        for (ray, wanted) in milled.rays.iter().zip(&flank.simulated) {
            match ray {
                Ok(ray) => {
                    max_deviation_um = max_deviation_um.max(1e3 * ray.length.abs());
                    let difference = wanted.map_or(0.0, |wanted| 1e3 * (ray.length - wanted).abs());
                    difference_um = difference_um.max(difference);
                }
                // A side that slides along itself while the cutter is drawn back: the ray tells nothing.
                Err(Unmilled::NotSettled) => {}
                Err(reason) => unmilled.push(*reason),
            }
        }
        if let Some(reason) = unmilled.first() {
            checked.remarks.push(Remark {
                code: "flank-not-milled",
                text: format!(
                    "{} flank: {} of {} rays are not milled by the program: {reason}",
                    flank.side,
                    unmilled.len(),
                    rays.len()
                ),
                way_out: "see that the program mills the space about +y with the tools of the job".into(),
            });
        }
        flanks.insert(flank.side.name(), CheckedFlank { max_deviation_um, difference_um });
    }
    checked.flanks = Some(flanks);
    Ok(checked)
}
