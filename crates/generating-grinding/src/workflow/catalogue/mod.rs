//! A catalogue of worms and dressers for the target of a job: all pairs ranked, the best one planned, and the search backwards
//! (`docs/mathematics/dressing.md`). Knows no user interface.

mod bodies;
pub mod files;
pub mod free;
pub mod free_files;
pub mod outcome;
pub mod plan;
mod plans_page;
mod summary;
pub mod task;
mod variant;
mod whole;
mod width;

pub use files::write_catalogue;
pub use free::{FreeOutcome, FreePair, FreePoint, FreeRange, study_free_worm};
pub use free_files::write_free_study;
pub use outcome::{
    CatalogueLimits, CatalogueOutcome, CataloguePair, LifeCurve, LifePoint, PAIR_RANKING, PairFlank, PairLife,
};
pub use plan::plan_from_catalogue;
pub use summary::PlannedPair;
pub use task::MOST_PAIRS;
pub use whole::PairPlan;
pub use width::{CrowningAt, PairRange};

use crate::catalogue::LoadedCatalogue;
use crate::job::LoadedJob;
use dressing::catalogue::{CatalogueSearch, RankedPair};
use foundation::numerics::Progress;
use rayon::prelude::*;
use run::RunFailure;
use std::collections::BTreeMap;
use task::Task;
use whole::{WholePair, rank_by_plans};

/// Pairs whose whole life is shown.
const LIVES: usize = 3;
/// Diameters of a life.
const LIFE_ROWS: usize = 17;

/// Ranks all pairs of a catalogue for the profile crowning that the job's target asks for, or, if the job says so, by what plans of the
/// whole target leave.
///
/// The same job and catalogue give the same outcome on any number of threads.
///
/// # Errors
/// [`RunFailure`]: an impossible gear or target, more than [`MOST_PAIRS`], what is wrong with a plan for every pair. Pairs that do not make the profile are listed with their
/// reason.
pub fn rank_catalogue(
    loaded: &LoadedJob,
    catalogue: &LoadedCatalogue,
    progress: &dyn Progress,
) -> Result<CatalogueOutcome, RunFailure> {
    let task = Task::new(loaded, catalogue)?;
    let ranked = ranked(loaded, catalogue, &task, progress)?;
    Ok(CatalogueOutcome::new(loaded, &catalogue.catalogue, &task, &ranked))
}

/// Profile crowning that the job asks of the pairs of its catalogue, um from form to tip diameter by flank: what can be said
/// without looking at a pair.
///
/// # Errors
/// As [`rank_catalogue`].
pub fn wanted_of_catalogue(
    loaded: &LoadedJob,
    catalogue: &LoadedCatalogue,
) -> Result<BTreeMap<&'static str, f64>, RunFailure> {
    Ok(outcome::wanted_um(&Task::new(loaded, catalogue)?))
}

/// Pairs in their order, each with what was found beside its figures, and the life of the first ones.
struct Ranking {
    pairs: Vec<(RankedPair, WholePair)>,
    lives: Vec<LifeCurve>,
    /// Whether plans decide.
    by_plans: bool,
}

impl Ranking {
    /// Whether a pair makes what the ranking goes by.
    fn is_ok(&self, (pair, whole): &(RankedPair, WholePair)) -> bool {
        if self.by_plans { whole.is_met() } else { pair.is_ok() }
    }

    /// Pairs of which a plan with all effort may come to something, the best first.
    fn worth_planning(&self) -> impl Iterator<Item = &RankedPair> {
        let worth = |(pair, whole): &&(RankedPair, WholePair)| {
            if self.by_plans { whole.is_planned() } else { pair.is_ok() }
        };
        self.pairs.iter().take_while(worth).map(|(pair, _)| pair)
    }
}

/// The ranking, and the life of its first pairs.
fn ranked(
    loaded: &LoadedJob,
    catalogue: &LoadedCatalogue,
    task: &Task,
    progress: &dyn Progress,
) -> Result<Ranking, RunFailure> {
    let search = task.search();
    let by_profile = search.run(progress);
    let pairs = match &task.whole {
        Some(over) => rank_by_plans(loaded, &catalogue.catalogue, (task, over), by_profile, progress)?,
        None => by_profile.into_iter().map(|pair| (pair, WholePair::default())).collect(),
    };
    let mut ranking = Ranking { pairs, lives: Vec::new(), by_plans: task.whole.is_some() };
    let ok = ranking.pairs.iter().filter(|pair| ranking.is_ok(pair) && pair.0.is_ok());
    let best: Vec<&RankedPair> = ok.take(LIVES).map(|(pair, _)| pair).collect();
    ranking.lives = best.par_iter().filter_map(|pair| life(task, &search, pair)).collect();
    Ok(ranking)
}

/// The life of a pair; nothing where the worm does not shrink.
fn life(task: &Task, search: &CatalogueSearch<'_>, pair: &RankedPair) -> Option<LifeCurve> {
    let (worm, dresser) = (&task.worms[pair.worm], &task.dressers[pair.dresser]);
    let designed = dresser.designed(&task.workshop, worm.choice.hand).ok()?;
    let rows = search.of(pair.worm, pair.dresser, &designed).life(LIFE_ROWS).ok()?;
    let points: Vec<LifePoint> = rows.iter().map(LifePoint::from).collect();
    (points.len() > 1).then(|| LifeCurve { worm: worm.name.clone(), dresser: dresser.name.clone(), points })
}
