//! A run of a job with its strokes, for programs to be followed on its bodies.

use super::programs::{Rays, Strokes, flanks_of};
use crate::job::LoadedTangentialJob;
use crate::workflow::{TangentialOutcome, plan_tangential, simulate_tangential};
use foundation::numerics::Progress;
use generating_grinding::workflow::programs::FollowedBodies;
use generating_grinding::workflow::programs::follow::{Followed, follow};
use generating_grinding::workflow::programs::sought::Sought;
use generating_grinding::workflow::programs::technology::Technology;
use machine::Machine;
use motion::Tracked;
use run::RunFailure;

/// The worm is one area.
const ONE_AREA: [f64; 1] = [0.0];

/// The run of a job with its strokes, for programs to be followed on its bodies.
pub struct OnTangential {
    run: TangentialOutcome,
    strokes: Strokes,
    tolerance_um: f64,
}

impl OnTangential {
    /// Its own run, by its settings if it has some.
    ///
    /// # Errors
    /// Those of the run.
    pub fn new(loaded: &LoadedTangentialJob, progress: &dyn Progress) -> Result<Self, RunFailure> {
        let mut plain = loaded.clone();
        plain.job.machine = None;
        let run = if plain.job.settings.is_some() {
            simulate_tangential(&plain, progress)?
        } else {
            plan_tangential(&plain, progress)?
        };
        let clamped = loaded.job.machine.clone().unwrap_or_default();
        let strokes = Strokes::new(&loaded.job, &clamped, &run.prepared, &run.flanks)?;
        Ok(Self { run, strokes, tolerance_um: loaded.job.target.tolerance_um })
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
        let Self { run, strokes, tolerance_um } = self;
        let sought = Sought {
            machine,
            technology: &strokes.technology,
            indexing: &strokes.indexing,
            areas: &ONE_AREA,
            dressing: strokes.dressing.iter().collect(),
            grinding: strokes.grinding.iter().collect(),
        };
        let judge = Rays { ready: &run.prepared, runs: &run.flanks, passes: &strokes.passes };
        follow(tracked, &sought, &flanks_of(&run.flanks), *tolerance_um, &judge)
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
