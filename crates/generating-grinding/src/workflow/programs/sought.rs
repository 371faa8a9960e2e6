//! The strokes of a task, found in what a text does, and how a text is refused that does something else.

use super::build::BuiltProgram;
use super::indexing::{Found, Indexing, Served, dressed_threads, ground_offsets};
use super::judge::Judge;
use super::task::ProgramTask;
use super::technology::Technology;
use super::work::{DressingWork, GrindingWork};
use foundation::kinematics::{DressingMotion, GeneratingMotion};
use job::Diagnostic;
use machine::{Machine, Role, Station};
use motion::{MotionError, ReadStroke, Tracked};
use run::RunFailure;
use run::program_check::{SPEED_ROUNDING, ThreadProof};
use std::collections::BTreeMap;
use std::f64::consts::TAU;
use verdict::Remark;

/// A dressing stroke turns the worm with its thread at the given speed, and beside it by its corrections.
const DRESSING_TURNS: f64 = 1.1;
/// What the referee's own surface and solution may add to a comparison of two of its runs, um.
pub const MARGIN_UM: f64 = 0.005;
/// Chords count twice: as they stand, and with their corners rounded.
pub const CHORDS: f64 = 2.0;

/// A text whose axes cannot be followed.
pub fn not_followed(program: &BuiltProgram, error: &MotionError) -> RunFailure {
    let finding = Diagnostic::with_code(error.code(), format!("{}: {error}", program.file));
    RunFailure::not_producible(finding.field("machine").way_out(error.way_out()))
}

/// A text that does not do what the run does.
pub fn not_proven(text: String, way_out: &str) -> RunFailure {
    let finding = Diagnostic::with_code("program-not-proven", text).field("machine");
    RunFailure::not_producible(finding.way_out(way_out.to_owned()))
}

/// The strokes of a task, found in what a text does.
pub struct Sought<'a> {
    /// The machine.
    pub machine: &'a Machine,
    /// Speeds, clamping and passes.
    pub technology: &'a Technology,
    /// Threads and index strokes.
    pub indexing: &'a Indexing,
    /// z_V1 of every finishing area less that of the first, mm.
    pub areas: &'a [f64],
    /// Dressing strokes in their order.
    pub dressing: Vec<&'a DressingWork>,
    /// Grinding strokes in their order.
    pub grinding: Vec<&'a GrindingWork>,
}

impl<'a> Sought<'a> {
    /// The strokes of a task.
    pub fn of_task(task: &'a ProgramTask<'_>) -> Self {
        Self {
            machine: &task.machine.machine,
            technology: &task.technology,
            indexing: &task.indexing,
            areas: &task.areas,
            dressing: task.dressing.iter().collect(),
            grinding: task.grinding.iter().collect(),
        }
    }

    /// The dressing strokes by thread.
    ///
    /// # Errors
    /// [`MotionError::NotFollowed`].
    pub fn dressed(&self, tracked: &Tracked) -> Result<Found<DressingMotion>, MotionError> {
        let of = |work: &&DressingWork| {
            tracked.dressing(self.machine, &self.technology.dressing, &work.motion.chain)
        };
        let there = self.dressing.iter().map(of).collect::<Result<Vec<_>, _>>()?;
        Ok(dressed_threads(self.indexing, &self.dressing, there))
    }

    /// The grinding strokes by offset.
    ///
    /// # Errors
    /// [`MotionError::NotFollowed`].
    pub fn ground(&self, tracked: &Tracked) -> Result<Found<GeneratingMotion>, MotionError> {
        let of = |work: &&GrindingWork| {
            tracked.grinding(self.machine, &self.technology.grinding, &work.motion, work.phase)
        };
        let there = self.grinding.iter().map(of).collect::<Result<Vec<_>, _>>()?;
        Ok(ground_offsets(self.indexing, &self.grinding, there))
    }

    /// The dressing strokes of the job itself.
    pub fn own_dressing(&self) -> Vec<ReadStroke<DressingMotion>> {
        let own = |work: &&DressingWork| {
            let motion = work.motion.clone();
            ReadStroke { motion, range: work.interval, index: 0, blocks: [0, 0], duration: 0.0 }
        };
        self.dressing.iter().map(own).collect()
    }

    /// The grinding strokes of the job itself in a finishing area.
    pub fn own_grinding(&self, area: f64) -> Vec<ReadStroke<GeneratingMotion>> {
        let own = |work: &&GrindingWork| {
            let mut motion = work.motion.clone();
            motion.shift = motion.shift.raised(area);
            ReadStroke { motion, range: work.feeds, index: 0, blocks: [0, 0], duration: 0.0 }
        };
        self.grinding.iter().map(own).collect()
    }

    /// The finishing area, by z_V1 less that of the first, in which a stroke of a text stands.
    pub fn area_of(&self, strokes: &[ReadStroke<GeneratingMotion>]) -> f64 {
        let (Some(stroke), Some(work)) = (strokes.first(), self.grinding.first()) else { return 0.0 };
        let middle = 0.5 * (work.feeds[0] + work.feeds[1]);
        let at = stroke.motion.shift.value(middle) - work.motion.shift.value(middle);
        let nearest = self.areas.iter().copied().min_by(|a, b| (a - at).abs().total_cmp(&(b - at).abs()));
        nearest.unwrap_or(0.0)
    }

    /// Every thread of the worm under the coarse grid of rays in every finishing area: what each differs by from the worm of the job's own motions, um.
    ///
    /// # Errors
    /// Those of dressing with the job's own motions.
    pub fn threads(
        &self,
        served: &[Served<DressingMotion>],
        judge: &impl Judge,
    ) -> Result<(Vec<ThreadProof>, Vec<Remark>), RunFailure> {
        let mut proofs = Vec::with_capacity(served.len());
        let mut faults = Vec::new();
        if served.is_empty() {
            return Ok((proofs, faults));
        }
        let own_dressing = self.own_dressing();
        let own: Vec<_> =
            self.areas.iter().map(|&area| judge.thread(&own_dressing, area)).collect::<Result<_, _>>()?;
        for thread in served {
            let blocks: Vec<[usize; 2]> = thread.strokes.iter().map(|stroke| stroke.blocks).collect();
            let mut difference_um: BTreeMap<&'static str, f64> = BTreeMap::new();
            let mut finished = true;
            for (&area, own) in self.areas.iter().zip(&own) {
                let lengths = match judge.thread(&thread.strokes, area) {
                    Ok(lengths) => lengths,
                    Err(RunFailure::BadInput(finding) | RunFailure::NotProducible(finding)) => {
                        faults.push(Remark::new(
                            "thread-not-finished",
                            format!("{}: {}", self.named(thread.place, &blocks), finding.message),
                            "correct the index angle and the ends of the stroke",
                        ));
                        finished = false;
                        break;
                    }
                };
                for (flank, lengths) in lengths.iter() {
                    let (Some(lengths), Some(own)) = (lengths, &own[flank]) else { continue };
                    let apart = lengths.iter().zip(own).map(|(a, b)| (a - b).abs());
                    let apart =
                        apart.fold(0.0, |most: f64, x| if x.is_nan() { f64::INFINITY } else { most.max(x) });
                    let of = difference_um.entry(flank.name()).or_insert(0.0);
                    *of = of.max(apart * 1e3);
                }
            }
            if finished {
                proofs.push(ThreadProof { thread: thread.place + 1, blocks, difference_um });
            }
        }
        Ok((proofs, faults))
    }

    /// Blocks that turn the worm faster than the job has it: while it grinds at its peripheral speed, while it is dressed at that speed.
    pub fn too_fast(&self, tracked: &Tracked, station: Station) -> Vec<Remark> {
        let Some(worm) = self.machine.role(Role::Worm) else { return Vec::new() };
        let technology = self.technology;
        let (given, what) = match station {
            Station::Work => (technology.worm_speed(), "machine.cutting_speed_m_per_s"),
            Station::Dresser => {
                (technology.dressing_speed * DRESSING_TURNS, "machine.dressing_worm_speed_rpm")
            }
        };
        let rpm = |speed: f64| speed * 60.0 / TAU;
        let found = tracked.faster(worm, given * (1.0 + SPEED_ROUNDING));
        let fault = |(block, speed): (usize, f64)| {
            let text = format!(
                "block {block}: the worm would turn at {:.1} 1/min; {what} allows {:.1} 1/min",
                rpm(speed),
                rpm(given)
            );
            Remark::new("worm-too-fast", text, "give the block more time")
        };
        found.into_iter().map(fault).collect()
    }

    /// A thread as people name it, with its blocks.
    pub fn named(&self, thread: u32, blocks: &[[usize; 2]]) -> String {
        let blocks: Vec<String> = blocks.iter().map(|[from, to]| format!("{from} to {to}")).collect();
        format!(
            "thread {} of {} of the worm (blocks {})",
            thread + 1,
            self.indexing.threads,
            blocks.join(", ")
        )
    }
}

/// The place whose strokes stand nearest to the job's.
pub fn nearest<M>(served: &[Served<M>]) -> Option<&Served<M>> {
    served.iter().min_by(|a, b| a.apart.total_cmp(&b.apart))
}
