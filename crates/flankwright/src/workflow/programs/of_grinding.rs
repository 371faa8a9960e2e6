//! The programs of a generating-grinding run: its strokes as work for a machine, and its referee asked with motions from a text.

use super::build::Built;
use super::proof::{ReadBack, proofs};
use super::result::ProgramsResult;
use super::task::{DressingWork, GrindingWork, ProgramTask, machine_of_job};
use super::technology::Technology;
use crate::contact::ToolSurface;
use crate::exchange::LoadedJob;
use crate::exchange::job::{DressingFlanks, Program as DialectName};
use crate::exchange::machine::LoadedMachine;
use crate::geometry::{Flank, Sides};
use crate::machine::GearCoupling;
use crate::metrology::Topography;
use crate::numerics::{Chebyshev, Silent, equidistant};
use crate::process::dressing::{DressedWorm, DresserTool};
use crate::workflow::execution::{ExecutedTool, Execution};
use crate::workflow::finding::{Remark, RunFailure};
use crate::workflow::prepare::Prepared;
use crate::workflow::referee::{self, Cutting, Verdict};
use nalgebra::Vector3;
use std::f64::consts::TAU;

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
    /// Seconds for the programs alone, without the proof.
    pub seconds: f64,
}

/// Contacts looked at along the line in which the dresser touches a flank.
const CONTACTS: usize = 5;
/// Phases of two flanks closer than this (rad) are one motion.
const SAME_PHASE: f64 = 1e-9;

/// The dialects that a job asks for; without a wish, those of the machine.
fn dialects(asked: &[DialectName], machine: &LoadedMachine) -> Vec<DialectName> {
    if !asked.is_empty() {
        return asked.to_vec();
    }
    let all = [DialectName::Linuxcnc, DialectName::Siemens, DialectName::Fanuc];
    all.into_iter().filter(|&dialect| machine.file.controls.of(dialect).is_some()).collect()
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
    let begun = std::time::Instant::now();
    let setup = &prepared.setup;
    let worm = &setup.pair.worm;
    let hand = if worm.data().helix_angle < 0.0 { -1.0 } else { 1.0 };
    let sizes = (hand, setup.largest_tip_radius, setup.worm_module(), setup.input.worm_width);
    let mut technology = Technology::new(job_machine, sizes, loaded.job.grinding.feed_per_revolution);
    technology.roughing_shift = roughing_shift;
    let chain = &setup.pair.chain;
    let any = &setup.pair.flanks.left;
    let data = setup.pair.work.data();
    let dialects = dialects(&loaded.job.output.programs, &machine);
    let two_flanks = loaded.job.dressing.flanks == DressingFlanks::Two;
    let dressing = dressing_work(prepared, execution, two_flanks);
    let strokes_of: Vec<Vec<(Flank, usize)>> = dressing.iter().map(|(_, of)| of.clone()).collect();
    let grinding = grinding_work(prepared, execution);
    let task = ProgramTask {
        job: &loaded.job.job.name,
        machine: &machine,
        dialects: &dialects,
        technology,
        dressing: dressing.into_iter().map(|(work, _)| work).collect(),
        grinding: grinding.iter().map(|(work, _)| work.clone()).collect(),
        coupling: GearCoupling {
            threads: worm.data().teeth.unsigned_abs(),
            teeth: data.teeth,
            shift: any.shift_coupling,
            feed: any.feed_coupling,
            crossed_axes_angle: chain.crossed_axes_angle,
        },
        gear: [data.normal_module, data.helix_angle],
    };
    let built = task.build()?;
    let seconds = begun.elapsed().as_secs_f64();
    let flanks = |f: &dyn Fn(Flank) -> Option<Topography>| Sides::from_fn(f);
    let target = flanks(&|flank| execution.flanks[flank].as_ref().map(|f| f.target.clone()));
    let simulated = flanks(&|flank| verdicts[flank].as_ref().map(|v| v.simulated.clone()));
    let proofs = proofs(&task, &built, [&target, &simulated], |read| {
        simulate(prepared, execution, cutting, read, &strokes_of, &grinding)
    })?;
    let result = ProgramsResult::new(&task, &built, proofs);
    let mut warnings = built.warnings.clone();
    if loaded.job.grinding.feed_per_revolution.is_none() {
        warnings.push(Remark {
            code: "feed-by-default",
            text: format!(
                "the programs feed {} mm per revolution of the gear",
                task.technology.feed_per_revolution
            ),
            way_out: "give grinding.feed_per_revolution".into(),
        });
    }
    if execution.flanks.iter().any(|(_, f)| f.as_ref().is_some_and(|f| f.made().is_some())) {
        warnings.push(Remark {
            code: "dressing-without-program",
            text: "the worm is a table: no dressing strokes lead to it, only grinding programs are written"
                .into(),
            way_out: "take motions/dressing-lines-*.csv, or a dresser with a profile".into(),
        });
    }
    Ok(Some(RunPrograms { result, built, machine, warnings, seconds }))
}

/// Contacts of the dresser with a worm flank at v_zS = 0, nominal.
fn contacts(dresser: &DresserTool, flank: Flank) -> Vec<(Vector3<f64>, Vector3<f64>)> {
    let half = 10.0 * dresser.flanks[flank].chain.screw_parameter.abs().max(1.0);
    let nominal = DressedWorm::new(dresser, flank, &[(); 4].map(|()| Chebyshev::constant(-half, half, 0.0)));
    let range = nominal.range();
    equidistant([range.w_nf, range.w_na], CONTACTS)
        .into_iter()
        .filter_map(|w| {
            let (t, _) = nominal.start(w, 0.0);
            nominal.jet(t, 0.0).map(|jet| (jet.p, jet.n))
        })
        .collect()
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
    dressed: &[Vec<(Flank, usize)>],
    ground: &[(GrindingWork, Vec<Flank>)],
) -> Result<Sides<Option<Topography>>, RunFailure> {
    let mut flanks = Sides { left: None, right: None };
    let cutting = Cutting { feed_per_revolution: None, ..cutting };
    for (stroke, (_, of)) in read.grinding.iter().zip(ground) {
        let mut run = execution.clone();
        run.motion = stroke.motion.clone();
        run.feed_range = stroke.range;
        for (stroke, of) in read.dressing.iter().zip(dressed) {
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
