//! The proof of line dressing: every line of a text on every thread, how far each is off that of the plan, and the referee's rays on the
//! lines of the text.

use super::find::Finder;
use super::judge::{blocks, judge};
use crate::workflow::programs::build::BuiltProgram;
use crate::workflow::programs::result::LinesProof;
use crate::workflow::programs::sought::{CHORDS, MARGIN_UM, Sought, not_followed, not_proven};
use crate::workflow::programs::task::ProgramTask;
use machine::Station;
use motion::{MotionError, track};
use run::RunFailure;
use run::program_check::ThreadProof;
use std::collections::BTreeMap;

/// Proves the programs of one control that dress by lines: one entry for each flank, and the threads with what either flank has of them.
///
/// # Errors
/// A text that cannot be followed; lines left out, off or in the way; rays that differ from those of the run by more than blocks and
/// digits explain: then nothing is written.
pub fn prove_lines(
    task: &ProgramTask<'_>,
    programs: &[&BuiltProgram],
    sought: &Sought<'_>,
) -> Result<(Vec<LinesProof>, Vec<ThreadProof>), RunFailure> {
    let mut proofs = Vec::new();
    let mut threads: BTreeMap<u32, ThreadProof> = BTreeMap::new();
    for program in programs {
        let Some(work) = task.lines.iter().find(|work| Some(work.flank) == program.lines) else { continue };
        let refused = |error: MotionError| not_followed(program, &error);
        let machine = &task.machine.machine;
        let tracked = track(&program.read, machine, &program.words, &program.start).map_err(refused)?;
        let finder = Finder { work: *work, indexing: &task.indexing, technology: &task.technology, machine };
        let found = finder.find(&tracked).map_err(refused)?;
        let judged = judge(work, &task.indexing, &found);
        let too_fast = sought.too_fast(&tracked, Station::Dresser);
        if let Some(fault) = judged.faults.iter().chain(&too_fast).next() {
            return Err(not_proven(format!("{}: {}", program.file, fault.text), &fault.way_out));
        }
        let largest = |of: fn(&motion::PassReport) -> f64| {
            program.layout.passes.iter().map(of).fold(0.0, f64::max) * 1e3
        };
        let chords_um = largest(|pass| pass.chord_deviation);
        let rounding_um = largest(|pass| pass.rounding);
        let allowed_um = CHORDS * chords_um + rounding_um + MARGIN_UM;
        let fine = "lower chord_tolerance_um of the control or give it more decimals; nothing was written";
        let plan = &work.written.plan;
        let mut proof = LinesProof {
            flank: work.flank.name(),
            file: program.file.clone(),
            lines: work.count(),
            threads: judged.threads.len(),
            rays: work.written.sample.over.len(),
            line_difference_um: 0.0,
            aside_um: 0.0,
            ray_difference_um: 0.0,
            scallop_um: 0.0,
            undercut_um: 0.0,
            outside_mm: Some(found.least[0]).filter(|mm| mm.is_finite()),
            inside_mm: Some(found.least[1]).filter(|mm| mm.is_finite()),
            chords_um,
            rounding_um,
            allowed_difference_um: allowed_um,
        };
        for thread in &judged.threads {
            let named =
                format!("{}, thread {} of {}", program.file, thread.thread + 1, task.indexing.threads);
            for off in thread.height {
                let um = off.by.abs() * 1e3;
                if um.is_nan() || um > allowed_um {
                    let text = format!(
                        "{named}: line {} (blocks {}) is {um:.4} um off that of the plan; segmentation and rounding account for {allowed_um:.4} um",
                        off.line + 1,
                        blocks([off.blocks])
                    );
                    return Err(not_proven(text, fine));
                }
                proof.line_difference_um = proof.line_difference_um.max(um);
            }
            let Some([least, most]) = thread.over else {
                let text = format!("{named}: the lines of the text leave rays of the referee unfinished");
                return Err(not_proven(text, fine));
            };
            // A line that lies aside raises the scallop to one side by its share of the pitch.
            let share = thread.across / plan.pitch;
            let allowed = allowed_um + 4.0 * plan.scallop * 1e3 * share * (1.0 + share);
            let um = thread.difference * 1e3;
            if um.is_nan() || um > allowed {
                let text = format!(
                    "{named}: read back and simulated, the worm flank deviates from that of the plan by {um:.4} um; segmentation and rounding account for {allowed:.4} um"
                );
                return Err(not_proven(text, fine));
            }
            proof.aside_um = proof.aside_um.max(thread.across * 1e3);
            proof.ray_difference_um = proof.ray_difference_um.max(um);
            proof.scallop_um = proof.scallop_um.max(most * 1e3);
            proof.undercut_um = proof.undercut_um.max(-least * 1e3);
            let of = threads.entry(thread.thread).or_insert_with(|| ThreadProof {
                thread: thread.thread + 1,
                blocks: Vec::new(),
                difference_um: BTreeMap::new(),
            });
            of.blocks.push(thread.blocks);
            of.difference_um.insert(work.flank.name(), um);
        }
        proofs.push(proof);
    }
    Ok((proofs, threads.into_values().collect()))
}

impl LinesProof {
    /// In words.
    pub fn statement(&self) -> String {
        let clear = match (self.outside_mm, self.inside_mm) {
            (Some(out), Some(inside)) => format!(
                "; beside its lines the disc stays {out:.3} mm or more off the tip of the worm, or with its rounded tip inside the thread space {inside:.3} mm or more off the opposite flank and out of the flank that it dresses"
            ),
            _ => String::new(),
        };
        format!(
            "{} flank of the worm: {} lines on each of {} threads counted, each within {:.4} um of the plan's in height and {:.4} um across; {} rays on each thread find {:.4} um above and {:.4} um below the wanted flank, {:.4} um from those of the run{clear}",
            self.flank,
            self.lines,
            self.threads,
            self.line_difference_um,
            self.aside_um,
            self.rays,
            self.scallop_um,
            self.undercut_um,
            self.ray_difference_um
        )
    }
}

/// What the proof of lines says nothing of.
pub const NOT_COVERED: [&str; 2] = [
    "rays on the worm between the places of the referee's sample, where each line is compared with the plan's alone",
    "the sides of the disc against the opposite flank, which the plan checks",
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_proof_says_lines_and_threads() {
        let proof = LinesProof {
            flank: "left",
            file: "programs/dressing-left-siemens.mpf".into(),
            lines: 69,
            threads: 2,
            rays: 81,
            line_difference_um: 0.004,
            aside_um: 0.2,
            ray_difference_um: 0.003,
            scallop_um: 3.95,
            undercut_um: 0.001,
            outside_mm: Some(1.5),
            inside_mm: Some(2.25),
            chords_um: 0.003,
            rounding_um: 0.05,
            allowed_difference_um: 0.06,
        };
        let text = proof.statement();
        for said in ["69 lines on each of 2 threads", "0.0040 um", "81 rays", "3.9500 um above", "2.250 mm"] {
            assert!(text.contains(said), "{said}: {text}");
        }
        let unknown = LinesProof { inside_mm: None, ..proof };
        assert!(!unknown.statement().contains("opposite flank"));
    }
}
