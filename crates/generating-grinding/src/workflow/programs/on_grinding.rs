//! A program followed on the bodies of a run: any text against the job.

use super::follow::{Followed, follow};
use super::lines::follow_lines;
use super::of_grinding::{Referee, Strokes, flanks_of};
use super::sought::Sought;
use super::technology::Technology;
use crate::job::LoadedJob;
use crate::workflow::referee::Cutting;
use crate::workflow::removal::put_on_stock;
use crate::workflow::run::{Outcome, run_without_programs};
use foundation::geometry::{Flank, Sides};
use foundation::numerics::Progress;
use machine::{Machine, Role, Station};
use motion::Tracked;
use run::RunFailure;
use run::program_check::refused;

/// The run of a job with its strokes, for programs to be followed on its bodies.
pub struct OnGrinding {
    run: Outcome,
    strokes: Strokes,
}

impl OnGrinding {
    /// Its own run, by its settings if it has some.
    ///
    /// # Errors
    /// Those of the run.
    pub fn new(loaded: &LoadedJob, progress: &dyn Progress) -> Result<Self, RunFailure> {
        let run = run_without_programs(loaded, progress)?;
        // Strokes that a rule chooses depend on the machine.
        let mut prepared = run.prepared.on_machine(loaded)?;
        put_on_stock(&mut prepared, &run.execution)?;
        let run = Outcome { prepared, ..run };
        let strokes = Strokes::new(&run.prepared, &run.execution)?;
        Ok(Self { run, strokes })
    }

    /// How the job clamps its bodies.
    pub fn technology(&self) -> &Technology {
        &self.strokes.technology
    }

    /// Follows a program and says what it makes of the flanks.
    ///
    /// # Errors
    /// Those of [`follow`].
    pub fn follow(&self, machine: &Machine, tracked: &Tracked) -> Result<Followed, RunFailure> {
        let Self { run, strokes } = self;
        let (prepared, execution) = (&run.prepared, &run.execution);
        let cutting =
            Cutting { feed_per_revolution: None, strokes: run.result.settings.index_strokes.as_ref() };
        let areas_apart = strokes.areas_apart();
        let sought = Sought {
            machine,
            technology: &strokes.technology,
            indexing: &strokes.indexing,
            areas: &areas_apart,
            dressing: strokes.dressing.iter().map(|(work, _)| work).collect(),
            grinding: strokes.grinding.iter().map(|(work, _)| work).collect(),
        };
        let judge = Referee { prepared, execution, cutting, strokes };
        let tolerance_um = prepared.tolerance.tightest() * 1e3;
        let lines = strokes.lines(&run.written);
        let turns = machine.role(Role::Work).and_then(|axis| tracked.ranges[axis]);
        if !lines.is_empty() && turns.is_none_or(|[from, to]| to <= from) {
            let deviation = Sides::from_fn(|flank: Flank| {
                run.result.flanks.get(flank.name()).map_or(0.0, |flank| flank.max_deviation_um)
            });
            let on = (machine, &strokes.technology, &strokes.indexing);
            let mut followed = follow_lines(tracked, on, &lines, &deviation, tolerance_um)?;
            followed.faults.extend(sought.too_fast(tracked, Station::Dresser));
            return Ok(followed);
        }
        let flanks = flanks_of(execution, &run.verdicts);
        let mut followed = follow(tracked, &sought, &flanks, tolerance_um, &judge)?;
        if let Some((areas, driven)) = &strokes.areas {
            let off = if followed.kind == "grinding" {
                areas.ground(&sought, tracked, None).map(|(_, faults)| faults)
            } else {
                areas.undressed(&sought, tracked, driven)
            };
            followed.faults.extend(off.map_err(|error| refused(&error))?);
        }
        Ok(followed)
    }
}
