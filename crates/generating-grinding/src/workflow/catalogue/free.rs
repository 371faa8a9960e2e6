//! The search backwards: with which diameters, profile angles or numbers of threads does each dresser make the target?

use super::outcome::{CatalogueLimits, PairFlank, flanks, wanted_um};
use super::task::Task;
use crate::catalogue::LoadedCatalogue;
use crate::job::{FreeQuantity as Free, FreeWorm, LoadedJob};
use crate::workflow::explore::Refused;
use dressing::catalogue::{BackwardsSearch, FreeQuantity, FreeValue, WorkingRange};
use foundation::numerics::Progress;
use job::{Diagnostic, Problem};
use rayon::prelude::*;
use report::PageHead;
use run::{JobTitle, RunFailure};
use schemars::JsonSchema;
use serde::Serialize;
use std::collections::BTreeMap;

/// One value of the free quantity.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct FreePoint {
    /// mm, degrees or number.
    pub value: f64,
    /// max |DK_j/limit_j|.
    pub largest_share_of_limit: Option<f64>,
    /// Figures per flank that is ground.
    pub flanks: BTreeMap<&'static str, PairFlank>,
    /// Why the target is not made there, if so.
    pub refused: Option<Refused>,
}

/// Values that make the target.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct FreeRange {
    /// First value.
    pub from: f64,
    /// Last value.
    pub to: f64,
    /// The one of the least share of a limit.
    pub best: FreePoint,
}

/// A worm with its free quantity under a dresser.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct FreePair {
    /// Name of the worm of which all else is taken.
    pub worm: String,
    /// Name of the dresser.
    pub dresser: String,
    /// Where the target is made.
    pub ranges: Vec<FreeRange>,
    /// Values looked at, ascending.
    pub points: Vec<FreePoint>,
    /// Why nothing could be looked at, if so.
    pub refused: Option<Refused>,
}

impl FreePair {
    /// The best value of all ranges.
    pub fn best(&self) -> Option<&FreePoint> {
        let share = |p: &FreePoint| p.largest_share_of_limit.unwrap_or(f64::INFINITY);
        self.ranges.iter().map(|r| &r.best).min_by(|a, b| share(a).total_cmp(&share(b)))
    }
}

/// The document of `explore.json` of such a study.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct FreeOutcome {
    /// Head of its page.
    #[serde(skip)]
    pub head: PageHead,
    /// Name of the job.
    pub job: String,
    /// Process.
    pub process: String,
    /// Version of flankwright.
    pub version: &'static str,
    /// Tolerance of the job, normal.
    pub tolerance_um: f64,
    /// Profile crowning that the target asks for, per flank, transverse.
    pub wanted_profile_crowning_um: BTreeMap<&'static str, f64>,
    /// Limits.
    pub limits: CatalogueLimits,
    /// What is free: `pitch-diameter` (mm), `pressure-angle` (degrees) or `threads`.
    pub free: &'static str,
    /// Values from, to.
    pub range: [f64; 2],
    /// All pairs; those with a working range first, by the least share of a limit.
    pub pairs: Vec<FreePair>,
}

impl FreeOutcome {
    /// Pairs that have a working range.
    pub fn working(&self) -> usize {
        self.pairs.iter().filter(|pair| !pair.ranges.is_empty()).count()
    }
}

/// Pairs that one study may have: each takes some forty searches.
const MOST: usize = 5_000;

/// Carries out the study of a catalogue with a free quantity.
///
/// # Errors
/// [`RunFailure`]: a job without such a study, an impossible gear or target, more than 5000 pairs.
pub fn study_free_worm(
    loaded: &LoadedJob,
    catalogue: &LoadedCatalogue,
    progress: &dyn Progress,
) -> Result<FreeOutcome, RunFailure> {
    let study = loaded.job.explore.as_ref().and_then(|explore| explore.catalogue).ok_or_else(|| {
        let finding = Diagnostic::new(Problem::MissingKey, "the job has no study of a catalogue")
            .field("explore.catalogue")
            .way_out("add `catalogue = { free = \"pitch-diameter\", from = .., to = .. }` to `[explore]`");
        RunFailure::bad_input(finding)
    })?;
    let task = Task::new(loaded, catalogue)?;
    let (worms, dressers) = (task.worms.len(), task.dressers.len());
    if worms * dressers > MOST {
        let text = format!("the study looks at {} pairs", worms * dressers);
        let finding = Diagnostic::with_code("too-many-combinations", text)
            .field("explore.catalogue")
            .value(worms * dressers)
            .allowed(format!("up to {MOST}"))
            .way_out("leave all but a few worms out: only what is not free of them counts");
        return Err(RunFailure::bad_input(finding));
    }
    progress.start("pairs", (worms * dressers) as u64);
    let places: Vec<(usize, usize)> = (0..worms).flat_map(|w| (0..dressers).map(move |d| (w, d))).collect();
    let mut pairs: Vec<FreePair> = places
        .par_iter()
        .map(|&(w, d)| {
            let found = pair(&task, &study, w, d);
            progress.advance(1);
            found
        })
        .collect();
    progress.finish();
    let share =
        |pair: &FreePair| pair.best().and_then(|best| best.largest_share_of_limit).unwrap_or(f64::INFINITY);
    pairs.sort_by(|a, b| share(a).total_cmp(&share(b)));
    let info = &loaded.job.job;
    let title = JobTitle::new(info, loaded.job.output.language);
    Ok(FreeOutcome {
        head: title.head(&format!(
            "Generating grinding, dressers of the catalogue with a free {}",
            study.free.words()
        )),
        job: info.name.clone(),
        process: info.process.name().to_string(),
        version: env!("CARGO_PKG_VERSION"),
        tolerance_um: task.tolerance_um,
        wanted_profile_crowning_um: wanted_um(&task),
        limits: CatalogueLimits::of(&task),
        free: study.free.name(),
        range: [study.from, study.to],
        pairs,
    })
}

/// Unit of the free quantity in files over the one in the library.
fn unit(free: Free) -> f64 {
    match free {
        Free::PressureAngle => 180.0 / std::f64::consts::PI,
        Free::PitchDiameter | Free::Threads => 1.0,
    }
}

fn pair(task: &Task, study: &FreeWorm, w: usize, d: usize) -> FreePair {
    let search = BackwardsSearch {
        workshop: &task.workshop,
        worm: &task.worms[w],
        dresser: &task.dressers[d],
        wanted: task.wanted,
        limits: task.limits,
        collisions: true,
    };
    let unit = unit(study.free);
    let ends = [study.from / unit, study.to / unit];
    let quantity = match study.free {
        Free::PitchDiameter => FreeQuantity::PitchDiameter(ends),
        Free::PressureAngle => FreeQuantity::ProfileAngle(ends),
        // The check of the job has seen that they are whole and few.
        Free::Threads => FreeQuantity::Threads(ends.map(|n| n as i32)),
    };
    let point = |at: &FreeValue| FreePoint {
        value: at.value * unit,
        largest_share_of_limit: at.figures.as_ref().ok().map(|f| f.cost),
        flanks: at.figures.as_ref().map(flanks).unwrap_or_default(),
        refused: match &at.figures {
            Ok(figures) => figures.refusal.as_ref().map(Refused::from),
            Err(refusal) => Some(Refused::from(refusal)),
        },
    };
    let range = |r: &WorkingRange| FreeRange { from: r.from * unit, to: r.to * unit, best: point(&r.best) };
    let found = search.run(quantity);
    FreePair {
        worm: task.worms[w].name.clone(),
        dresser: task.dressers[d].name.clone(),
        ranges: found.as_ref().map(|b| b.ranges.iter().map(range).collect()).unwrap_or_default(),
        points: found.as_ref().map(|b| b.looked_at.iter().map(point).collect()).unwrap_or_default(),
        refused: found.as_ref().err().map(Refused::from),
    }
}
