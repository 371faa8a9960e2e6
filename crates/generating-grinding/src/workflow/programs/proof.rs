//! The proof: what the texts say goes through reader, axes and forward kinematics to the bodies, and from there to the referee.

use super::build::{Built, BuiltProgram};
use super::indexing::{Found, Indexing, Served, dressed_threads, ground_offsets};
use super::lines::{NOT_COVERED, prove_lines};
use super::result::{FlankProof, ProofResult};
use super::surroundings::Surroundings;
use super::task::ProgramTask;
use foundation::geometry::Sides;
use foundation::kinematics::{DressingMotion, GeneratingMotion};
use job::Diagnostic;
use machine::{Machine, Role, Station};
use metrology::Topography;
use motion::{MotionError, PassReport, ReadStroke, Tracked, track};
use nc::{Block, Dialect};
use run::RunFailure;
use run::program_check::{SPEED_ROUNDING, ThreadProof};
use std::collections::BTreeMap;
use std::f64::consts::TAU;
use verdict::Remark;

/// Finishing strokes of one thread and one index stroke, one for each stroke of the run.
#[derive(Clone, Debug)]
pub struct ReadBack {
    /// Dressing; empty for a worm that no program dresses.
    pub dressing: Vec<ReadStroke<DressingMotion>>,
    /// Grinding.
    pub grinding: Vec<ReadStroke<GeneratingMotion>>,
}

/// The referee of a process, asked with motions from a text.
pub trait Judge {
    /// The flanks that these strokes leave; `area`: z_V1 of their finishing area less that of the first, mm.
    ///
    /// # Errors
    /// Those of the stages.
    fn flanks(&self, read: &ReadBack, area: f64) -> Result<Sides<Option<Topography>>, RunFailure>;

    /// Lengths of rays on a coarse grid over the worm flank that these dressing strokes leave in a finishing area, mm.
    ///
    /// # Errors
    /// Those of dressing.
    fn thread(
        &self,
        dressing: &[ReadStroke<DressingMotion>],
        area: f64,
    ) -> Result<Sides<Option<Vec<f64>>>, RunFailure>;
}

/// A flank of the run itself.
#[derive(Clone, Debug)]
pub struct RunFlank {
    /// What the rays left, normal, mm.
    pub rays: Topography,
    /// Its deviation from the target, in the measure of the job, mm.
    pub deviation: Topography,
}

impl RunFlank {
    /// Largest difference of a flank from this one, and largest deviation from the target in the measure of the job, um.
    pub fn differences_um(&self, left: &Topography) -> [f64; 2] {
        let apart = left.minus(&self.rays);
        let f = self.deviation.f.iter().zip(&apart.f).map(|(d, a)| d + a).collect();
        let deviation = Topography { f, ..self.deviation.clone() };
        [largest(&apart), largest(&deviation)].map(|mm| mm * 1e3)
    }
}

impl RunFlank {
    /// Where a flank deviates most from the target: w and z, mm.
    pub fn worst(&self, left: &Topography) -> [f64; 2] {
        let apart = left.minus(&self.rays);
        let off = self.deviation.f.iter().zip(&apart.f).map(|(d, a)| (d + a).abs());
        let columns = self.deviation.z.len().max(1);
        let worst = off.enumerate().max_by(|a, b| a.1.total_cmp(&b.1)).map_or(0, |(k, _)| k);
        let at = |values: &[f64], k: usize| values.get(k).copied().unwrap_or(f64::NAN);
        [at(&self.deviation.w, worst / columns), at(&self.deviation.z, worst % columns)]
    }
}

/// Largest value; a value that is no number is infinite.
fn largest(of: &Topography) -> f64 {
    if of.f.iter().any(|f| f.is_nan()) { f64::INFINITY } else { of.largest() }
}
/// A dressing stroke turns the worm with its thread at the given speed, and beside it by its corrections.
const DRESSING_TURNS: f64 = 1.1;
/// Rays of the coarse grid for every thread of the worm: over the profile and along the worm.
pub const THREAD_GRID: [usize; 2] = [5, 9];
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

/// The blocks of a program that bear on its motion: neither comments nor the speed of a dresser, which is a body of revolution.
fn moves(program: &BuiltProgram) -> impl Iterator<Item = &Block> {
    let dressing = program.station == Station::Dresser;
    program.read.iter().filter(move |block| match block {
        Block::Comment(_) => false,
        Block::Spindle { .. } => !dressing,
        _ => true,
    })
}

/// The strokes of a task, found in what a text does.
pub struct Sought<'a> {
    /// The machine.
    pub machine: &'a Machine,
    /// Speeds, clamping and passes.
    pub technology: &'a crate::workflow::programs::technology::Technology,
    /// Threads and index strokes.
    pub indexing: &'a Indexing,
    /// z_V1 of every finishing area less that of the first, mm.
    pub areas: &'a [f64],
    /// Dressing strokes in their order.
    pub dressing: Vec<&'a crate::workflow::programs::task::DressingWork>,
    /// Grinding strokes in their order.
    pub grinding: Vec<&'a crate::workflow::programs::task::GrindingWork>,
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
        let of = |work: &&crate::workflow::programs::task::DressingWork| {
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
        let of = |work: &&crate::workflow::programs::task::GrindingWork| {
            tracked.grinding(self.machine, &self.technology.grinding, &work.motion, work.phase)
        };
        let there = self.grinding.iter().map(of).collect::<Result<Vec<_>, _>>()?;
        Ok(ground_offsets(self.indexing, &self.grinding, there))
    }

    /// The dressing strokes of the job itself.
    pub fn own_dressing(&self) -> Vec<ReadStroke<DressingMotion>> {
        let own = |work: &&crate::workflow::programs::task::DressingWork| {
            let motion = work.motion.clone();
            ReadStroke { motion, range: work.interval, index: 0, blocks: [0, 0], duration: 0.0 }
        };
        self.dressing.iter().map(own).collect()
    }

    /// The grinding strokes of the job itself in a finishing area.
    pub fn own_grinding(&self, area: f64) -> Vec<ReadStroke<GeneratingMotion>> {
        let own = |work: &&crate::workflow::programs::task::GrindingWork| {
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
            Station::Work => (technology.worm_speed, "machine.cutting_speed_m_per_s"),
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

/// Proves the programs of every control; equal texts of different controls are proven once. `flanks` are those of the run itself.
///
/// # Errors
/// A text that cannot be followed; threads or tooth spaces left out; a flank that differs from that of the run by more than blocks and
/// digits explain: then nothing is written.
pub fn proofs(
    task: &ProgramTask<'_>,
    built: &Built,
    flanks: &Sides<Option<RunFlank>>,
    judge: &impl Judge,
) -> Result<Vec<ProofResult>, RunFailure> {
    let mut proven: Vec<(Vec<&BuiltProgram>, ProofResult)> = Vec::new();
    for dialect in Dialect::ALL {
        let programs: Vec<&BuiltProgram> = built.programs.iter().filter(|p| p.dialect == dialect).collect();
        if programs.is_empty() {
            continue;
        }
        let same = |known: &[&BuiltProgram]| {
            known.len() == programs.len()
                && known
                    .iter()
                    .zip(&programs)
                    .all(|(a, b)| a.words.numbers == b.words.numbers && moves(a).eq(moves(b)))
        };
        if let Some((_, proof)) = proven.iter_mut().find(|(known, _)| same(known)) {
            proof.controls.push(dialect.name());
            continue;
        }
        let proof = prove(task, dialect, &programs, flanks, judge)?;
        proven.push((programs, proof));
    }
    Ok(proven.into_iter().map(|(_, proof)| proof).collect())
}

/// The proof of one control's programs.
fn prove(
    task: &ProgramTask<'_>,
    dialect: Dialect,
    programs: &[&BuiltProgram],
    flanks: &Sides<Option<RunFlank>>,
    judge: &impl Judge,
) -> Result<ProofResult, RunFailure> {
    let files = programs.iter().map(|p| p.file.as_str()).collect::<Vec<_>>().join(" and ");
    let sought = Sought::of_task(task);
    let mut dressed = Vec::new();
    let mut ground: Vec<(usize, Vec<Served<GeneratingMotion>>)> = Vec::new();
    for program in programs.iter().filter(|program| program.lines.is_none()) {
        let refused = |error: MotionError| not_followed(program, &error);
        let tracked =
            track(&program.read, sought.machine, &program.words, &program.start).map_err(refused)?;
        let faults = match program.station {
            Station::Dresser => {
                let found = sought.dressed(&tracked).map_err(refused)?;
                dressed = found.served;
                found.faults
            }
            Station::Work => {
                let found = sought.ground(&tracked).map_err(refused)?;
                let (spaces, teeth) =
                    (sought.indexing.spaces_of(&found.served), task.indexing.teeth.unsigned_abs());
                if spaces != teeth {
                    let text = format!("{}: {spaces} of {teeth} tooth spaces are ground", program.file);
                    return Err(not_proven(text, "give every index stroke of the pass"));
                }
                ground.push((program.area, found.served));
                found.faults
            }
        };
        let too_fast = sought.too_fast(&tracked, program.station);
        if let Some(fault) = faults.iter().chain(&too_fast).next() {
            return Err(not_proven(format!("{}: {}", program.file, fault.text), &fault.way_out));
        }
    }
    // Dressing and grinding add up; of the programs of several areas the worst counts.
    let of_stations = |value: &dyn Fn(&PassReport) -> f64| -> f64 {
        let worst = |station: Station| {
            let of_station = programs.iter().filter(|p| p.station == station && p.lines.is_none());
            of_station.flat_map(|p| &p.layout.passes).map(value).fold(0.0, f64::max)
        };
        worst(Station::Dresser) + worst(Station::Work)
    };
    let chords = of_stations(&|pass| pass.chord_deviation);
    let rounding = of_stations(&|pass| pass.rounding);
    // A lead that a control takes in few digits turns the workpiece over the whole feed.
    let leads = programs.iter().map(|p| p.written.rounding.lead_ratio).fold(0.0, f64::max);
    let swept = task.grinding.iter().map(|work| (work.feeds[1] - work.feeds[0]) * work.per_turn);
    let rounding = rounding + leads * swept.fold(0.0, f64::max);
    let allowed = CHORDS * chords * 1e3 + rounding * 1e3 + MARGIN_UM;
    let fine = "lower chord_tolerance_um of the control or give it more decimals; nothing was written";
    let dressing = nearest(&dressed).map_or(Vec::new(), |served| served.strokes.clone());
    let mut of_flanks: BTreeMap<&'static str, FlankProof> = BTreeMap::new();
    for (area, served) in ground.iter().flat_map(|(area, all)| all.iter().map(move |served| (area, served))) {
        let read = ReadBack { dressing: dressing.clone(), grinding: served.strokes.clone() };
        let apart = task.areas.get(*area).copied().unwrap_or(0.0);
        for (flank, left) in judge.flanks(&read, apart)?.iter() {
            let (Some(left), Some(run)) = (left, &flanks[flank]) else { continue };
            let [difference_um, max_deviation_um] = run.differences_um(left);
            if difference_um > allowed {
                let on = if task.areas.len() > 1 {
                    format!(" in finishing area {}", area + 1)
                } else {
                    String::new()
                };
                let text = format!(
                    "read back and simulated, {files} deviate from the plan by {difference_um:.4} um on the {flank} flank{on}; segmentation and rounding account for {allowed:.4} um"
                );
                return Err(not_proven(text, fine));
            }
            let of = of_flanks.entry(flank.name()).or_insert(FlankProof { max_deviation_um, difference_um });
            of.max_deviation_um = of.max_deviation_um.max(max_deviation_um);
            of.difference_um = of.difference_um.max(difference_um);
        }
    }
    let (lines, threads_of_lines) = prove_lines(task, programs, &sought)?;
    let (mut threads, faults) = sought.threads(&dressed, judge)?;
    if let Some(fault) = faults.first() {
        return Err(not_proven(format!("{files}: {}", fault.text), &fault.way_out));
    }
    for thread in &threads {
        if let Some((flank, &um)) = thread.difference_um.iter().find(|(_, um)| **um > allowed) {
            let named = sought.named(thread.thread - 1, &thread.blocks);
            let text = format!(
                "read back and simulated, {files} deviate from the plan by {um:.4} um on the {flank} flank of {named}; segmentation and rounding account for {allowed:.4} um"
            );
            return Err(not_proven(text, fine));
        }
    }
    let teeth = task.indexing.teeth.unsigned_abs();
    let index_strokes = ground.first().map_or(0, |(_, served)| served.len());
    let largest = of_flanks.values().map(|f| f.max_deviation_um).fold(0.0, f64::max);
    let mut statement = format!("proven from the program text: max deviation {largest:.4} um");
    if !threads.is_empty() {
        let left_out = task.indexing.threads as usize - task.indexing.active.len();
        let rest = if left_out > 0 { format!(", {left_out} left out by the job") } else { String::new() };
        statement.push_str(&format!(
            "; {} of {} threads of the worm dressed, both counted and under rays ({} x {} rays on each flank of each thread{rest})",
            threads.len(),
            task.indexing.threads,
            THREAD_GRID[0],
            THREAD_GRID[1]
        ));
    } else if lines.is_empty() {
        statement.push_str("; the worm is dressed by no program");
    }
    for of_flank in &lines {
        statement.push_str(&format!("; {}", of_flank.statement()));
    }
    threads.extend(threads_of_lines);
    statement.push_str(&format!(
        "; {teeth} of {teeth} tooth spaces ground in {index_strokes} index stroke{} of a pass",
        if index_strokes == 1 { "" } else { "s" }
    ));
    if task.areas.len() > 1 {
        statement.push_str(&format!(
            "; {0} of {0} finishing areas of the worm dressed, and ground with by a program each",
            task.areas.len()
        ));
    }
    let mut not_covered = not_covered(task);
    if !lines.is_empty() {
        not_covered.extend(NOT_COVERED.map(String::from));
    }
    statement.push_str(&format!("; not proven: {}", not_covered.join(", ")));
    Ok(ProofResult {
        controls: vec![dialect.name()],
        statement,
        flanks: of_flanks,
        threads_of_worm: task.indexing.threads,
        threads,
        lines,
        thread_rays: THREAD_GRID,
        areas: task.areas.len(),
        tooth_spaces: teeth,
        index_strokes,
        not_covered,
        chords_um: chords * 1e3,
        rounding_um: rounding * 1e3,
        allowed_difference_um: allowed,
    })
}

/// What a proof says nothing of.
fn not_covered(task: &ProgramTask<'_>) -> Vec<String> {
    let around = Surroundings::new(task.machine, &task.technology);
    let unknown = around.not_covered().join(" and ");
    let unknown = (!unknown.is_empty()).then(|| format!("approach, retraction and rapids against {unknown}"));
    let mut not: Vec<String> = unknown.into_iter().chain(around.exchanged().map(String::from)).collect();
    if task.technology.dresser.is_none() && !task.dressing.is_empty() {
        not.push(
            "approach, retraction and rapids of the worm against the dresser, for want of the worm's width"
                .into(),
        );
    }
    not
}
