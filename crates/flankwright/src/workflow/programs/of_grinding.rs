//! The programs of a generating-grinding run: its strokes as work for a machine, and its referee asked with motions from a text.

use super::proof::ReadBack;
use super::result::{CheckedFlank, CheckedStroke};
use super::run_programs::{RunPrograms, dialects};
use super::task::{DressingWork, GrindingWork, ProgramTask, machine_of_job};
use super::technology::Technology;
use crate::exchange::job::{DressingFlanks, Job, Machine as JobMachine};
use crate::exchange::machine::LoadedMachine;
use crate::exchange::{Diagnostic, LoadedJob};
use crate::geometry::{Flank, Sides};
use crate::kinematics::{DressingMotion, GeneratingMotion, MotionLaw};
use crate::machine::{GearCoupling, Machine, Role};
use crate::metrology::Topography;
use crate::motion::{MotionError, ReadStroke, Tracked, dresser_contacts};
use crate::numerics::{Progress, Silent, equidistant};
use crate::process::dressing::DresserTool;
use crate::workflow::execution::{ExecutedTool, Execution};
use crate::workflow::finding::{Remark, RunFailure};
use crate::workflow::prepare::Prepared;
use crate::workflow::referee::{self, Cutting, Verdict};
use crate::workflow::run::{Outcome, plan_job, simulate_job};
use nalgebra::Vector3;
use std::collections::BTreeMap;
use std::f64::consts::TAU;

/// Contacts looked at along the line in which the dresser touches a flank.
const CONTACTS: usize = 5;
/// Phases of two flanks closer than this (rad) are one motion.
const SAME_PHASE: f64 = 1e-9;

/// The strokes of a run with the bodies that they move.
struct Strokes {
    technology: Technology,
    coupling: GearCoupling,
    gear: [f64; 2],
    /// Dressing strokes, each with the flanks and their strokes that it makes.
    dressing: Vec<(DressingWork, Vec<(Flank, usize)>)>,
    /// Grinding strokes, each with the flanks that it makes.
    grinding: Vec<(GrindingWork, Vec<Flank>)>,
}

impl Strokes {
    fn new(job: &Job, machine: &JobMachine, prepared: &Prepared, execution: &Execution) -> Self {
        let setup = &prepared.setup;
        let worm = &setup.pair.worm;
        let hand = if worm.data().helix_angle < 0.0 { -1.0 } else { 1.0 };
        let sizes = (hand, setup.largest_tip_radius, setup.worm_module(), setup.input.worm_width);
        let any = &setup.pair.flanks.left;
        let data = setup.pair.work.data();
        let two_flanks = job.dressing.flanks == DressingFlanks::Two;
        Self {
            technology: Technology::new(machine, sizes, job.grinding.feed_per_revolution),
            coupling: GearCoupling {
                threads: worm.data().teeth.unsigned_abs(),
                teeth: data.teeth,
                shift: any.shift_coupling,
                feed: any.feed_coupling,
                crossed_axes_angle: setup.pair.chain.crossed_axes_angle,
            },
            gear: [data.normal_module, data.helix_angle],
            dressing: dressing_work(prepared, execution, two_flanks),
            grinding: grinding_work(prepared, execution),
        }
    }
}

/// Target and flank of a run.
fn flanks_of(execution: &Execution, verdicts: &Sides<Option<Verdict>>) -> [Sides<Option<Topography>>; 2] {
    [
        Sides::from_fn(|flank| execution.flanks[flank].as_ref().map(|f| f.target.clone())),
        Sides::from_fn(|flank| verdicts[flank].as_ref().map(|v| v.simulated.clone())),
    ]
}

/// Programs of a run whose job names a machine; `None` for one that names none.
///
/// # Errors
/// [`RunFailure`]: a machine that is none or cannot do it; programs that are not proven.
pub(in crate::workflow) fn programs_of_grinding(
    loaded: &LoadedJob,
    prepared: &Prepared,
    execution: &Execution,
    verdicts: &Sides<Option<Verdict>>,
    cutting: Cutting<'_>,
    roughing_shift: Vec<f64>,
) -> Result<Option<RunPrograms>, RunFailure> {
    let Some(job_machine) = &loaded.job.machine else { return Ok(None) };
    let machine = machine_of_job(loaded, job_machine)?;
    let mut strokes = Strokes::new(&loaded.job, job_machine, prepared, execution);
    strokes.technology.roughing_shift = roughing_shift;
    let task = ProgramTask {
        job: &loaded.job.job.name,
        machine: &machine,
        dialects: &dialects(&loaded.job.output.programs, &machine),
        technology: strokes.technology.clone(),
        dressing: strokes.dressing.iter().map(|(work, _)| work.clone()).collect(),
        grinding: strokes.grinding.iter().map(|(work, _)| work.clone()).collect(),
        coupling: strokes.coupling,
        gear: strokes.gear,
    };
    let flanks = flanks_of(execution, verdicts);
    let mut programs =
        RunPrograms::new(&task, loaded.job.grinding.feed_per_revolution.is_some(), &flanks, |read| {
            simulate(prepared, execution, cutting, read, &strokes)
        })?;
    if execution.flanks.iter().any(|(_, f)| f.as_ref().is_some_and(|f| f.made().is_some())) {
        programs.warnings.push(Remark {
            code: "dressing-without-program",
            text: "the worm is a table: no dressing strokes lead to it, only grinding programs are written"
                .into(),
            way_out: "take motions/dressing-lines-*.csv, or a dresser with a profile".into(),
        });
    }
    Ok(Some(programs))
}

/// A job made ready for looking at programs: its own run, and its strokes on a machine.
pub(super) struct PreparedPrograms<'a> {
    machine: &'a Machine,
    run: Outcome,
    strokes: Strokes,
}

impl<'a> PreparedPrograms<'a> {
    /// Runs the job, by its settings if it has some, without programs of its own.
    ///
    /// # Errors
    /// Those of the run.
    pub fn of_job(
        loaded: &LoadedJob,
        machine: &'a LoadedMachine,
        progress: &dyn Progress,
    ) -> Result<Self, RunFailure> {
        let mut plain = loaded.clone();
        plain.job.machine = None;
        let run = if plain.job.settings.is_some() {
            simulate_job(&plain, progress)?
        } else {
            plan_job(&plain, progress)?
        };
        let clamped = loaded.job.machine.clone().unwrap_or_default();
        let strokes = Strokes::new(&loaded.job, &clamped, &run.prepared, &run.execution);
        Ok(Self { machine: &machine.machine, run, strokes })
    }
}

/// What a program does to the bodies of a job: its kind, its strokes, the flank that it leaves with everything else as the job has it.
type BodiesOfProgram = (&'static str, Vec<CheckedStroke>, Option<BTreeMap<&'static str, CheckedFlank>>);

/// The strokes of a program on the bodies of a job, and the flank that they leave. Of several strokes for the same flank the one
/// nearest to the job's own finishes.
///
/// # Errors
/// A program whose axes do not bring these bodies together; the referee's.
pub(super) fn flank_of_program(
    ready: &PreparedPrograms<'_>,
    tracked: &Tracked,
) -> Result<BodiesOfProgram, RunFailure> {
    let strokes = &ready.strokes;
    let refused = |error: MotionError| {
        let finding = Diagnostic::with_code(error.code(), error.to_string());
        RunFailure::bad_input(finding.way_out(error.way_out()))
    };
    let nothing = |what: &str| {
        refused(MotionError::NotFollowed {
            block: 1,
            reason: format!("it has no {what} stroke on these bodies"),
        })
    };
    let turns = ready.machine.role(Role::Work).and_then(|axis| tracked.ranges[axis]);
    let grinds = turns.is_some_and(|[from, to]| to > from);
    let mut read = ReadBack { dressing: Vec::new(), grinding: Vec::new() };
    let mut listed: Vec<CheckedStroke> = Vec::new();
    let kind = if grinds {
        for (work, _) in &strokes.grinding {
            let there = tracked
                .grinding(ready.machine, &strokes.technology.grinding, &work.motion, work.phase)
                .map_err(refused)?;
            let off = |stroke: &ReadStroke<GeneratingMotion>| {
                let at = 0.5 * (stroke.range[0] + stroke.range[1]);
                let apart = |a: &MotionLaw, b: &MotionLaw| (a.value(at) - b.value(at)).abs();
                apart(&stroke.motion.delta_d, &work.motion.delta_d)
                    + work.per_turn * apart(&stroke.motion.delta_phi_2, &work.motion.delta_phi_2)
            };
            let best = serve(&there, off, &work.name, &mut listed).ok_or_else(|| nothing("grinding"))?;
            read.grinding.push(there[best].clone());
        }
        "grinding"
    } else {
        for (work, _) in &strokes.grinding {
            let motion = work.motion.clone();
            read.grinding.push(ReadStroke { motion, range: work.feeds, blocks: [0, 0], duration: 0.0 });
        }
        for (work, _) in &strokes.dressing {
            let there = tracked
                .dressing(ready.machine, &strokes.technology.dressing, &work.motion.chain)
                .map_err(refused)?;
            let off = |stroke: &ReadStroke<DressingMotion>| {
                let at = 0.5 * (stroke.range[0] + stroke.range[1]);
                let [a, b] = [stroke.motion.correction_at(at), work.motion.correction_at(at)];
                // Angles at a radius of some 100 mm.
                let weighed = [100.0, 100.0, 1.0, 1.0].iter().zip(a.iter().zip(b));
                weighed.map(|(weight, (a, b))| weight * (a - b).abs()).sum::<f64>()
            };
            let best = serve(&there, off, &work.name, &mut listed).ok_or_else(|| nothing("dressing"))?;
            read.dressing.push(there[best].clone());
        }
        "dressing"
    };
    let cutting = Cutting { feed_per_revolution: None, strokes: ready.run.result.settings.strokes.as_ref() };
    let (prepared, execution) = (&ready.run.prepared, &ready.run.execution);
    let flanks = simulate(prepared, execution, cutting, &read, strokes)?;
    let [target, simulated] = flanks_of(execution, &ready.run.verdicts);
    let mut of_flanks = BTreeMap::new();
    for (flank, left) in flanks.iter() {
        let (Some(left), Some(target), Some(simulated)) = (left, &target[flank], &simulated[flank]) else {
            continue;
        };
        let checked = CheckedFlank {
            max_deviation_um: left.minus(target).largest() * 1e3,
            difference_um: left.minus(simulated).largest() * 1e3,
        };
        of_flanks.insert(flank.name(), checked);
    }
    Ok((kind, listed, Some(of_flanks)))
}

/// The stroke nearest to a stroke of the job, and all strokes listed once, with the name of the one that they finish.
fn serve<M>(
    there: &[ReadStroke<M>],
    off: impl Fn(&ReadStroke<M>) -> f64,
    name: &str,
    listed: &mut Vec<CheckedStroke>,
) -> Option<usize> {
    let best = (0..there.len()).min_by(|&a, &b| off(&there[a]).total_cmp(&off(&there[b])))?;
    for (k, stroke) in there.iter().enumerate() {
        let serves = (k == best).then(|| name.to_owned());
        match listed.iter_mut().find(|known| known.blocks == stroke.blocks) {
            Some(known) => known.serves = known.serves.take().or(serves),
            None => listed.push(CheckedStroke {
                range_mm: stroke.range,
                blocks: stroke.blocks,
                duration_s: stroke.duration,
                serves,
            }),
        }
    }
    Some(best)
}

/// Contacts of the dresser with a worm flank at v_zS = 0, nominal.
fn contacts(dresser: &DresserTool, flank: Flank) -> Vec<(Vector3<f64>, Vector3<f64>)> {
    let dresser = &dresser.flanks[flank];
    let rolls = equidistant([dresser.range.w_nf, dresser.range.w_na], CONTACTS);
    dresser_contacts(&dresser.worm, dresser.chain.worm_angle, &rolls)
}

/// The dressing strokes, each with the flanks and their strokes that it makes.
fn dressing_work(
    prepared: &Prepared,
    execution: &Execution,
    two_flanks: bool,
) -> Vec<(DressingWork, Vec<(Flank, usize)>)> {
    let mut works = Vec::new();
    let sin_an = |flank: Flank| prepared.setup.lines[flank].sin_an.abs();
    let shown = |flank: Flank| flank.name().to_uppercase();
    for flank in Flank::BOTH {
        let Some(executed) = &execution.flanks[flank] else { continue };
        match (&executed.tool, &execution.dresser) {
            (ExecutedTool::Dressed(dressing), Some(dresser)) => {
                let both = two_flanks && execution.flanks.iter().all(|(_, f)| f.is_some());
                if both && flank == Flank::Right {
                    continue;
                }
                let flanks: Vec<Flank> = if both { Flank::BOTH.to_vec() } else { vec![flank] };
                let name = if both {
                    "DRESSING BOTH FLANKS".to_owned()
                } else {
                    format!("DRESSING {} FLANK", shown(flank))
                };
                let work = DressingWork {
                    name,
                    motion: dressing.motion.clone(),
                    interval: dressing.driven,
                    contacts: flanks.iter().flat_map(|&flank| contacts(dresser, flank)).collect(),
                    per_distance: flanks.iter().map(|&f| sin_an(f)).fold(0.0, f64::max),
                };
                works.push((work, flanks.into_iter().map(|flank| (flank, 0)).collect()));
            }
            (ExecutedTool::Stroked(strokes), _) => {
                let Some(layout) = &prepared.setup.strokes else { continue };
                for (k, stroke) in strokes.strokes.iter().enumerate() {
                    let Some(dresser) = layout.dressers.get(stroke.place.dresser) else { continue };
                    let work = DressingWork {
                        name: format!(
                            "DRESSING {} FLANK STROKE {} DRESSER {}",
                            shown(flank),
                            k + 1,
                            stroke.place.dresser + 1
                        ),
                        motion: stroke.motion.clone(),
                        interval: stroke.driven,
                        contacts: contacts(dresser, flank),
                        per_distance: sin_an(flank),
                    };
                    works.push((work, vec![(flank, k)]));
                }
            }
            _ => {}
        }
    }
    works
}

/// The grinding strokes, each with the flanks that it makes.
fn grinding_work(prepared: &Prepared, execution: &Execution) -> Vec<(GrindingWork, Vec<Flank>)> {
    let setup = &prepared.setup;
    let ground: Vec<Flank> = Flank::BOTH.into_iter().filter(|&f| execution.flanks[f].is_some()).collect();
    let phase = &execution.motion.phase;
    let apart = phase.left - phase.right;
    let together = (apart - TAU * (apart / TAU).round()).abs() < SAME_PHASE;
    let groups: Vec<Vec<Flank>> =
        if together { vec![ground] } else { ground.into_iter().map(|f| vec![f]).collect() };
    groups
        .into_iter()
        .filter(|flanks| !flanks.is_empty())
        .map(|flanks| {
            let name = match flanks.as_slice() {
                [only] => format!("GRINDING {} FLANK", only.name().to_uppercase()),
                _ => "GRINDING BOTH FLANKS".to_owned(),
            };
            let largest =
                |f: &dyn Fn(Flank) -> f64| flanks.iter().map(|&flank| f(flank).abs()).fold(0.0, f64::max);
            let per_turn = largest(&|flank| {
                let f = setup.pair.work.flank(flank);
                f.base_radius * f.base_helix_angle.cos()
            });
            let work = GrindingWork {
                name,
                motion: execution.motion.clone(),
                phase: phase[flanks[0]],
                feeds: execution.feed_range,
                per_turn,
                per_distance: largest(&|flank| setup.lines[flank].sin_an),
            };
            (work, flanks)
        })
        .collect()
}

/// The referee's flanks with the motions of the texts in place of those of the run.
fn simulate(
    prepared: &Prepared,
    execution: &Execution,
    cutting: Cutting<'_>,
    read: &ReadBack,
    strokes: &Strokes,
) -> Result<Sides<Option<Topography>>, RunFailure> {
    let mut flanks = Sides { left: None, right: None };
    let cutting = Cutting { feed_per_revolution: None, ..cutting };
    for (stroke, (_, of)) in read.grinding.iter().zip(&strokes.grinding) {
        let mut run = execution.clone();
        run.motion = stroke.motion.clone();
        run.feed_range = stroke.range;
        for (stroke, (_, of)) in read.dressing.iter().zip(&strokes.dressing) {
            for &(flank, number) in of {
                match run.flanks[flank].as_mut().map(|f| &mut f.tool) {
                    Some(ExecutedTool::Dressed(dressing)) => {
                        dressing.motion = stroke.motion.clone();
                        dressing.driven = stroke.range;
                    }
                    Some(ExecutedTool::Stroked(strokes)) => {
                        if let Some(one) = strokes.strokes.get_mut(number) {
                            one.motion = stroke.motion.clone();
                            one.driven = stroke.range;
                        }
                    }
                    _ => {}
                }
            }
        }
        for flank in Flank::BOTH.into_iter().filter(|flank| !of.contains(flank)) {
            run.flanks[flank] = None;
        }
        let verdicts = referee::run(&prepared.setup, &run, cutting, &Silent)
            .map_err(|e| RunFailure::of_removal(&e, "machine"))?;
        for &flank in of {
            flanks[flank] = verdicts[flank].as_ref().map(|v| v.simulated.clone());
        }
    }
    Ok(flanks)
}

#[cfg(test)]
mod tests {
    use super::super::proof::proofs;
    use super::*;
    use crate::exchange::read_job;
    use crate::machine::Station;
    use crate::nc::Block;
    use std::path::Path;

    /// A text that says something else than the plan is not written, however small the difference.
    #[test]
    fn programs_that_differ_from_the_plan_are_not_proven() {
        let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
        let mut loaded = read_job(&root.join("examples/twist-free-crowning.toml")).unwrap();
        let job_machine = loaded.job.machine.take().unwrap();
        (loaded.job.grid.profile_points, loaded.job.grid.helix_points) = (5, 5);
        let machine = machine_of_job(&loaded, &job_machine).unwrap();
        let run = plan_job(&loaded, &Silent).unwrap();
        let strokes = Strokes::new(&loaded.job, &job_machine, &run.prepared, &run.execution);
        let task = ProgramTask {
            job: "TEST",
            machine: &machine,
            dialects: &dialects(&[], &machine)[..1],
            technology: strokes.technology.clone(),
            dressing: strokes.dressing.iter().map(|(work, _)| work.clone()).collect(),
            grinding: strokes.grinding.iter().map(|(work, _)| work.clone()).collect(),
            coupling: strokes.coupling,
            gear: strokes.gear,
        };
        let built = task.build().unwrap();
        let [target, simulated] = flanks_of(&run.execution, &run.verdicts);
        let cutting = Cutting { feed_per_revolution: None, strokes: None };
        let prove = |built: &super::super::Built| {
            proofs(&task, built, [&target, &simulated], |read| {
                simulate(&run.prepared, &run.execution, cutting, read, &strokes)
            })
        };
        assert_eq!(prove(&built).unwrap().len(), 1);
        let radial = machine.machine.role(Role::Radial).unwrap();
        for station in [Station::Dresser, Station::Work] {
            let mut changed = built.clone();
            let program = changed.programs.iter_mut().find(|p| p.station == station).unwrap();
            let word = program.words.place(radial).unwrap();
            for block in &mut program.read {
                if let Block::Linear { target, .. } = block
                    && let Some(value) = target.get(word)
                {
                    target.set(word, value + 2e-4);
                }
            }
            let error = match prove(&changed) {
                Err(RunFailure::NotProducible(finding)) => finding,
                other => panic!("{station:?}: {other:?}"),
            };
            assert_eq!(error.code, "program-not-proven", "{error:?}");
        }
    }
}
