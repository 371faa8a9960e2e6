//! The programs of a generating-grinding run: its strokes as work for a machine, and its referee asked with motions from a text.

use super::areas::ProgramAreas;
use super::beyond_travel::BeyondTravel;
use super::clearance;
use super::indexing::Indexing;
use super::judge::{Judge, ReadBack, RunFlank};
use super::lines::LineWork;
use super::proof::THREAD_GRID;
use super::run_programs::RunPrograms;
use super::task::ProgramTask;
use super::technology::Technology;
use super::work::{DressingWork, GrindingWork, levers_of};
use crate::workflow::execution::{ExecutedTool, Execution};
use crate::workflow::line_dressing::WrittenFlank;
use crate::workflow::prepare::Prepared;
use crate::workflow::referee::{self, Cutting, Verdict};
use contact::ToolSurface;
use dressing::{DressedWorm, DresserTool};
use foundation::geometry::{Flank, Sides};
use foundation::kinematics::{DressingMotion, Point, Pose, Worm};
use foundation::numerics::{Chebyshev, Silent, equidistant};
use job::machine::LoadedMachine;
use job::tables::Program as DialectName;
use machine::GearCoupling;
use metrology::Topography;
use motion::ReadStroke;
use nalgebra::Vector3;
use run::RunFailure;
use run::program_check::dialects;
use verdict::Remark;

/// Contacts looked at along the line in which the dresser touches a flank.
const CONTACTS: usize = 5;
/// Where along a stroke they are looked at, as shares of it.
const PLACES: [f64; 3] = [0.1, 0.5, 0.9];

/// The strokes of a run with the bodies that they move.
pub(super) struct Strokes {
    pub technology: Technology,
    pub coupling: GearCoupling,
    pub indexing: Indexing,
    /// Dressing strokes, each with the flanks and their strokes that it makes.
    pub dressing: Vec<(DressingWork, Vec<(Flank, usize)>)>,
    /// Grinding strokes, each with the flanks that it makes.
    pub grinding: Vec<(GrindingWork, Vec<Flank>)>,
    /// The areas of the worm, if passes use more than one, and the worm positions that the plan dresses.
    pub areas: Option<(ProgramAreas, Vec<[f64; 2]>)>,
}

impl Strokes {
    pub fn new(prepared: &Prepared, execution: &Execution) -> Result<Self, RunFailure> {
        let setup = &prepared.setup;
        let worm = &setup.pair.worm;
        let any = &setup.pair.flanks.left;
        let data = setup.pair.work.data();
        let areas = ProgramAreas::of_execution(prepared, execution)?;
        let indexed = prepared.cycle.strokes.as_ref();
        let mut strokes = Self {
            technology: prepared.technology.clone(),
            coupling: GearCoupling {
                threads: worm.data().teeth.unsigned_abs(),
                teeth: data.teeth,
                shift: any.shift_coupling,
                feed: any.feed_coupling,
                crossed_axes_angle: setup.pair.chain.crossed_axes_angle,
            },
            indexing: Indexing::new(worm.data().teeth.unsigned_abs(), data.teeth, indexed),
            dressing: dressing_work(prepared, execution, prepared.dressing.two_flanks),
            grinding: grinding_work(prepared, execution),
            areas: None,
        };
        if let Some(areas) = areas {
            strokes.place(areas, prepared, execution)?;
        }
        Ok(strokes)
    }

    /// What was read from a text as if its areas lay where the plan has them; `None` without areas.
    fn as_planned(&self, read: &ReadBack, area: f64) -> Option<ReadBack> {
        self.areas.as_ref().map(|(areas, _)| areas.as_planned(read, area))
    }

    /// The flanks that are dressed line by line; none where passes use more than one area, which the lines of the plan do not reach.
    pub fn lines<'a>(&self, written: &'a Sides<Option<WrittenFlank>>) -> Vec<LineWork<'a>> {
        if self.areas.is_some() { Vec::new() } else { LineWork::of_run(written) }
    }

    /// The strokes as work for a machine.
    fn task<'a>(
        &self,
        job: &'a str,
        (machine, dialects): (&'a LoadedMachine, &'a [DialectName]),
        written: &'a Sides<Option<WrittenFlank>>,
    ) -> ProgramTask<'a> {
        ProgramTask {
            job,
            machine,
            dialects,
            technology: self.technology.clone(),
            dressing: self.dressing.iter().map(|(work, _)| work.clone()).collect(),
            lines: self.lines(written),
            grinding: self.grinding.iter().map(|(work, _)| work.clone()).collect(),
            indexing: self.indexing.clone(),
            coupling: self.coupling,
            areas: self.areas_apart(),
        }
    }

    /// z_V1 of every finishing area less that of the first, mm.
    pub fn areas_apart(&self) -> Vec<f64> {
        self.areas.as_ref().map_or(vec![0.0], |(areas, _)| areas.apart())
    }

    /// Lays the strokes into the areas of the worm.
    fn place(
        &mut self,
        areas: ProgramAreas,
        prepared: &Prepared,
        execution: &Execution,
    ) -> Result<(), RunFailure> {
        let driven = self.dressing.iter().map(|(work, _)| work.interval).collect();
        self.technology.roughing = areas.roughing_passes();
        for (work, of) in &mut self.dressing {
            let flanks: Vec<Flank> = of.iter().map(|(flank, _)| *flank).collect();
            if let Some(tool) = dresser_of(prepared, execution, of) {
                let planned = (&execution.motion.shift, execution.ratio);
                areas.placed_dressing(work, (tool, &flanks), planned)?;
            }
        }
        for (work, _) in &mut self.grinding {
            areas.placed_grinding(work);
        }
        self.areas = Some((areas, driven));
        Ok(())
    }
}

/// The flanks of a run.
pub(super) fn flanks_of(execution: &Execution, verdicts: &Sides<Option<Verdict>>) -> Sides<Option<RunFlank>> {
    Sides::from_fn(|flank| {
        let (executed, verdict) = (execution.flanks[flank].as_ref()?, verdicts[flank].as_ref()?);
        let rays = verdict.simulated.clone();
        Some(RunFlank { deviation: rays.minus(&executed.target), rays })
    })
}

/// The referee of a run.
pub(super) struct Referee<'a> {
    pub prepared: &'a Prepared,
    pub execution: &'a Execution,
    pub cutting: Cutting<'a>,
    pub strokes: &'a Strokes,
}

/// Programs of a run whose job names a machine; `None` for one that names none.
///
/// # Errors
/// [`RunFailure`]: a machine that is none or cannot do it; programs that are not proven.
pub fn programs_of_grinding(
    prepared: &Prepared,
    execution: &Execution,
    verdicts: &Sides<Option<Verdict>>,
    (cutting, written): (Cutting<'_>, &Sides<Option<WrittenFlank>>),
) -> Result<Option<RunPrograms>, RunFailure> {
    let Some(machine) = &prepared.machine else { return Ok(None) };
    let strokes = Strokes::new(prepared, execution)?;
    let dialects = dialects(&prepared.output.programs, machine);
    let task = strokes.task(&prepared.info.name, (machine, &dialects), written);
    let flanks = flanks_of(execution, verdicts);
    let judge = Referee { prepared, execution, cutting, strokes: &strokes };
    let feed_given =
        prepared.cycle.feed_per_revolution.is_some() || prepared.technology.finishing().contact.is_some();
    let mut programs = RunPrograms::new(&task, feed_given, &flanks, &judge)?;
    if let Some((areas, driven)) = &strokes.areas {
        programs.result.worm_use = areas.check(&task, &programs.built, driven)?;
    }
    programs.result.clearance = clearance::check(&task, &programs.built)?;
    if task.lines.is_empty()
        && execution.flanks.iter().any(|(_, f)| f.as_ref().is_some_and(|f| f.made().is_some()))
    {
        programs.warnings.push(Remark {
            code: "dressing-without-program",
            text: "the worm is a table: no dressing strokes lead to it, only grinding programs are written"
                .into(),
            way_out: "take motions/dressing-lines-*.csv, or a dresser with a profile".into(),
        });
    }
    Ok(Some(programs))
}

/// The axes that the programs of a job would drive beyond the travel of its machine; none without a machine, and none for flanks of the
/// worm that are dressed line by line.
pub fn beyond_travel_of_grinding(prepared: &Prepared, execution: &Execution) -> Vec<BeyondTravel> {
    let found = || {
        let machine = prepared.machine.as_ref()?;
        let strokes = Strokes::new(prepared, execution).ok()?;
        let dialects = dialects(&prepared.output.programs, machine);
        let written = Sides::both(None);
        Some(strokes.task(&prepared.info.name, (machine, &dialects), &written).beyond_travel())
    };
    found().unwrap_or_default()
}

/// Contacts of the dresser with a worm flank along a stroke, each carried back along the thread to v_zS = 0.
fn contacts(
    dresser: &DresserTool,
    flank: Flank,
    corrections: &[Chebyshev; 4],
) -> Vec<(Vector3<f64>, Vector3<f64>)> {
    let worm = DressedWorm::new(dresser, flank, corrections);
    let (range, (from, to)) = (worm.range(), corrections[0].interval());
    let screw = dresser.flanks[flank].chain.screw_parameter;
    let mut contacts = Vec::with_capacity(CONTACTS * PLACES.len());
    for v in PLACES.map(|share| from + share * (to - from)) {
        let back = Pose::<Worm, Worm>::tz(v).then(&Pose::<Worm, Worm>::rz(v / screw));
        for w in equidistant([range.w_nf, range.w_na], CONTACTS) {
            let (t, _) = worm.start(w, 0.0);
            if let Some(jet) = worm.jet(t, v) {
                contacts.push((back.point(&Point::from_vector(jet.p)).xyz, back.rotation() * jet.n));
            }
        }
    }
    contacts
}

/// The dresser of a stroke, by the flanks and their strokes that it makes.
fn dresser_of<'a>(
    prepared: &'a Prepared,
    execution: &'a Execution,
    of: &[(Flank, usize)],
) -> Option<&'a DresserTool> {
    let &(flank, number) = of.first()?;
    match &execution.flanks[flank].as_ref()?.tool {
        ExecutedTool::Stroked(strokes) => {
            prepared.setup.strokes.as_ref()?.dressers.get(strokes.strokes.get(number)?.place.dresser)
        }
        _ => execution.dresser.as_ref(),
    }
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
                    contacts: flanks
                        .iter()
                        .flat_map(|&flank| contacts(dresser, flank, &dressing.corrections))
                        .collect(),
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
                        contacts: contacts(dresser, flank, &stroke.corrections),
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
    let groups: Vec<Vec<Flank>> = if execution.grinds_both_at_once() {
        vec![ground]
    } else {
        ground.into_iter().map(|f| vec![f]).collect()
    };
    groups
        .into_iter()
        .filter(|flanks| !flanks.is_empty())
        .map(|flanks| {
            let name = match flanks.as_slice() {
                [only] => format!("GRINDING {} FLANK", only.name().to_uppercase()),
                _ => "GRINDING BOTH FLANKS".to_owned(),
            };
            let work = GrindingWork {
                name,
                motion: execution.motion.clone(),
                phase: phase[flanks[0]],
                feeds: execution.feed_range,
                levers: levers_of(setup, &flanks),
            };
            (work, flanks)
        })
        .collect()
}

/// The run with the dressing motions of a text in place of its own.
fn dressed_by(
    execution: &Execution,
    dressing: &[ReadStroke<DressingMotion>],
    strokes: &Strokes,
) -> Execution {
    let mut run = execution.clone();
    for (stroke, (_, of)) in dressing.iter().zip(&strokes.dressing) {
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
    run
}

impl Judge for Referee<'_> {
    fn flanks(&self, read: &ReadBack, area: f64) -> Result<Sides<Option<Topography>>, RunFailure> {
        let mut flanks = Sides { left: None, right: None };
        let cutting = Cutting { feed_per_revolution: None, ..self.cutting };
        let planned = self.strokes.as_planned(read, area);
        let read = planned.as_ref().unwrap_or(read);
        let dressed = dressed_by(self.execution, &read.dressing, self.strokes);
        for (stroke, (_, of)) in read.grinding.iter().zip(&self.strokes.grinding) {
            let mut run = dressed.clone();
            run.motion = stroke.motion.clone();
            run.feed_range = stroke.range;
            for flank in Flank::BOTH.into_iter().filter(|flank| !of.contains(flank)) {
                run.flanks[flank] = None;
            }
            let verdicts = referee::run(&self.prepared.setup, &run, cutting, &Silent)
                .map_err(|e| RunFailure::of_removal(&e, "machine"))?;
            for &flank in of {
                flanks[flank] = verdicts[flank].as_ref().map(|v| v.simulated.clone());
            }
        }
        Ok(flanks)
    }

    fn thread(
        &self,
        dressing: &[ReadStroke<DressingMotion>],
        area: f64,
    ) -> Result<Sides<Option<Vec<f64>>>, RunFailure> {
        let read = ReadBack { dressing: dressing.to_vec(), grinding: Vec::new() };
        let planned = self.strokes.as_planned(&read, area);
        let dressing = planned.as_ref().map_or(dressing, |read| &read.dressing);
        let run = dressed_by(self.execution, dressing, self.strokes);
        referee::worm_rays(&self.prepared.setup, &run, THREAD_GRID)
            .map_err(|e| RunFailure::of_removal(&e, "machine"))
    }
}

#[cfg(test)]
mod tests {
    use super::super::proof::proofs;
    use super::*;
    use crate::workflow::run::run_without_programs;
    use job::read_job_of;
    use machine::{Role, Station};
    use nc::Block;
    use run::program_check::machine_of_job;
    use std::path::Path;

    /// A text that says something else than the plan is not written, however small the difference.
    #[test]
    fn programs_that_differ_from_the_plan_are_not_proven() {
        let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
        let mut loaded =
            read_job_of::<crate::job::Job>(&root.join("examples/twist-free-crowning.toml")).unwrap();
        (loaded.job.grid.profile_points, loaded.job.grid.helix_points) = (5, 5);
        let file = &loaded.job.machine.as_ref().unwrap().file;
        let machine = machine_of_job(&loaded.document, file).unwrap();
        let run = run_without_programs(&loaded, &Silent).unwrap();
        let strokes = Strokes::new(&run.prepared, &run.execution).unwrap();
        let task = ProgramTask {
            job: "TEST",
            machine: &machine,
            dialects: &dialects(&[], &machine)[..1],
            technology: strokes.technology.clone(),
            dressing: strokes.dressing.iter().map(|(work, _)| work.clone()).collect(),
            lines: Vec::new(),
            grinding: strokes.grinding.iter().map(|(work, _)| work.clone()).collect(),
            indexing: strokes.indexing.clone(),
            coupling: strokes.coupling,
            areas: strokes.areas_apart(),
        };
        let built = task.build().unwrap();
        let flanks = flanks_of(&run.execution, &run.verdicts);
        let cutting = Cutting { feed_per_revolution: None, strokes: None };
        let judge =
            Referee { prepared: &run.prepared, execution: &run.execution, cutting, strokes: &strokes };
        let prove = |built: &crate::workflow::programs::build::Built| proofs(&task, built, &flanks, &judge);
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
