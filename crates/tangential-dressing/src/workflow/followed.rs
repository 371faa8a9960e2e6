//! A run of a job with its strokes, for programs to be followed on its bodies.

use super::prepare::{given_settings, prepare_tangential};
use super::programs::{Rays, Strokes, flanks_of};
use super::run::{plan_prepared, simulate_prepared};
use crate::job::LoadedTangentialJob;
use crate::workflow::TangentialOutcome;
use foundation::numerics::Progress;
use generating_grinding::workflow::programs::FollowedBodies;
use generating_grinding::workflow::programs::follow::{Followed, follow};
use generating_grinding::workflow::programs::sought::Sought;
use generating_grinding::workflow::programs::technology::Technology;
use machine::Machine;
use motion::Tracked;
use run::RunFailure;
use std::time::Instant;

/// The worm is one area.
const ONE_AREA: [f64; 1] = [0.0];

/// The run of a job with its strokes, for programs to be followed on its bodies.
pub struct OnTangential {
    run: TangentialOutcome,
    strokes: Strokes,
}

impl OnTangential {
    /// Its own run, by its settings if it has some.
    ///
    /// # Errors
    /// Those of the run.
    pub fn new(loaded: &LoadedTangentialJob, progress: &dyn Progress) -> Result<Self, RunFailure> {
        // Not on the machine of the job: no programs of its own.
        let ready = prepare_tangential(loaded)?;
        let begun = Instant::now();
        let run = if loaded.job.settings.is_some() {
            let settings = given_settings(loaded, &ready)?;
            simulate_prepared(ready, settings, begun, progress)?
        } else {
            plan_prepared(ready, begun, progress)?
        };
        let strokes = Strokes::new(&run.prepared, &run.flanks)?;
        Ok(Self { run, strokes })
    }

    /// How the job clamps its bodies.
    pub fn technology(&self) -> &Technology {
        &self.run.prepared.technology
    }

    /// Follows a program and says what it makes of the flanks.
    ///
    /// # Errors
    /// Those of [`follow`].
    pub fn follow(&self, machine: &Machine, tracked: &Tracked) -> Result<Followed, RunFailure> {
        let Self { run, strokes } = self;
        let sought = Sought {
            machine,
            technology: &run.prepared.technology,
            indexing: &strokes.indexing,
            areas: &ONE_AREA,
            dressing: strokes.dressing.iter().collect(),
            grinding: strokes.grinding.iter().collect(),
        };
        let judge = Rays { ready: &run.prepared, runs: &run.flanks, passes: &strokes.passes };
        follow(tracked, &sought, &flanks_of(&run.flanks), run.prepared.tolerance_um, &judge)
    }
}

impl FollowedBodies for OnTangential {
    fn follow(&self, machine: &Machine, tracked: &Tracked) -> Result<Followed, RunFailure> {
        OnTangential::follow(self, machine, tracked)
    }

    fn technology(&self) -> &Technology {
        OnTangential::technology(self)
    }
}
