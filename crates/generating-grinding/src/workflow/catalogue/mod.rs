//! A catalogue of worms and dressers for the target of a job: all pairs ranked, the best one planned, and the search backwards
//! (`docs/mathematics/dressing.md`). Knows no user interface.

mod bodies;
pub mod files;
pub mod free;
pub mod free_files;
pub mod outcome;
pub mod plan;
mod summary;
pub mod task;
mod variant;

pub use files::write_catalogue;
pub use free::{FreeOutcome, FreePair, FreePoint, FreeRange, study_free_worm};
pub use free_files::write_free_study;
pub use outcome::{
    CatalogueLimits, CatalogueOutcome, CataloguePair, LifeCurve, LifePoint, PAIR_RANKING, PairFlank, PairLife,
};
pub use plan::plan_from_catalogue;
pub use summary::PlannedPair;
pub use task::MOST_PAIRS;

use crate::catalogue::LoadedCatalogue;
use crate::job::LoadedJob;
use dressing::catalogue::{CatalogueSearch, RankedPair};
use foundation::numerics::Progress;
use rayon::prelude::*;
use run::RunFailure;
use std::collections::BTreeMap;
use task::Task;

/// Pairs whose whole life is shown.
const LIVES: usize = 3;
/// Diameters of a life.
const LIFE_ROWS: usize = 17;

/// Ranks all pairs of a catalogue for the profile crowning that the job's target asks for.
///
/// The same job and catalogue give the same outcome on any number of threads.
///
/// # Errors
/// [`RunFailure`]: an impossible gear or target, more than [`MOST_PAIRS`]. Pairs that do not make the profile are listed with their
/// reason.
pub fn rank_catalogue(
    loaded: &LoadedJob,
    catalogue: &LoadedCatalogue,
    progress: &dyn Progress,
) -> Result<CatalogueOutcome, RunFailure> {
    let task = Task::new(loaded, catalogue)?;
    let (ranked, lives) = ranked(&task, progress);
    Ok(CatalogueOutcome::new(loaded, &catalogue.catalogue, &task, &ranked, lives))
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

/// The ranking, and the life of its first pairs.
fn ranked(task: &Task, progress: &dyn Progress) -> (Vec<RankedPair>, Vec<LifeCurve>) {
    let search = task.search();
    let ranked = search.run(progress);
    let best: Vec<&RankedPair> = ranked.iter().filter(|pair| pair.is_ok()).take(LIVES).collect();
    let lives = best.par_iter().filter_map(|pair| life(task, &search, pair)).collect();
    (ranked, lives)
}

/// The life of a pair; nothing where the worm does not shrink.
fn life(task: &Task, search: &CatalogueSearch<'_>, pair: &RankedPair) -> Option<LifeCurve> {
    let (worm, dresser) = (&task.worms[pair.worm], &task.dressers[pair.dresser]);
    let designed = dresser.designed(&task.workshop, worm.choice.hand).ok()?;
    let rows = search.of(pair.worm, pair.dresser, &designed).life(LIFE_ROWS).ok()?;
    let points: Vec<LifePoint> = rows.iter().map(LifePoint::from).collect();
    (points.len() > 1).then(|| LifeCurve { worm: worm.name.clone(), dresser: dresser.name.clone(), points })
}
