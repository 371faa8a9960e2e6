//! `explore`: every combination of cone angle, crossing angle and diagonal ratio judged by the rule of planning, ranked. Knows
//! no user interface; refuses nothing but what is wrong for all combinations.

mod axes;
pub mod candidate;
pub mod files;
mod refused;
mod summary;
mod variant;

pub use axes::{Axes, Varied};
pub use candidate::{ExploreCandidate, FlankFigures};
pub use files::{figure_text, write_exploration};
pub use refused::Refused;

use super::equal_ratio_offers::{EqualRatioOffer, equal_ratio_offers};
use super::prepare::{Prepared, prepare, tolerance_of_job};
use crate::job::{DiagonalRatio, Explore, LoadedJob, Method, Steps};
use foundation::numerics::Progress;
use generating::PlanTask;
use job::Diagnostic;
use rayon::prelude::*;
use report::PageHead;
use run::{JobTitle, RunFailure};
use schemars::JsonSchema;
use serde::Serialize;
use variant::Variant;

/// Combinations that one study may have.
pub const MOST_COMBINATIONS: usize = 100_000;

/// The rule of the ranking, in words.
pub const RANKING: &str = "allowed before refused before failed; among allowed and among refused ones those within the \
    tolerance first, by score, then by used worm width, then by residual; the others by residual";

/// What a study found: the document of `explore.json`.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct ExploreOutcome {
    /// Head of its page.
    #[serde(skip)]
    pub head: PageHead,
    /// Name of the job.
    pub job: String,
    /// Process.
    pub process: String,
    /// Version of flankwright.
    pub version: &'static str,
    /// Tolerance of the job, the tightest of its map.
    pub tolerance_um: f64,
    /// What varies: `worm_cone_angle_deg`, `crossed_axes_angle_deg`, `diagonal_ratio`.
    pub varied: Vec<&'static str>,
    /// How the candidates are ranked.
    pub ranking: &'static str,
    /// Number of candidates that are allowed.
    pub allowed: usize,
    /// Worms with which one ratio serves both flanks; empty where nothing asks for one.
    pub levers: Vec<EqualRatioOffer>,
    /// All combinations, the best first.
    pub candidates: Vec<ExploreCandidate>,
}

impl ExploreOutcome {
    /// The best candidate if it is allowed and within the tolerance.
    pub fn best(&self) -> Option<&ExploreCandidate> {
        self.candidates.first().filter(|c| c.allowed && c.within_tolerance)
    }

    /// Whether something can be made, if only outside the tolerance.
    pub fn is_producible(&self) -> bool {
        self.candidates.iter().any(|c| c.allowed || c.is_only_inexact())
    }
}

/// Which diagonal ratios are judged for a worm.
enum Ratios {
    /// These.
    Given(Vec<f64>),
    /// The one that the job gives or its rule chooses.
    OfJob,
}

/// Judges every combination of the steps in `[explore]`; what is absent there keeps the job's value. Without `[explore]` the
/// diagonal ratio alone varies over the scan of the rule (both signs), 0, K* and what the target demands.
///
/// The same job gives the same outcome on any number of threads.
///
/// # Errors
/// [`RunFailure`]: more than [`MOST_COMBINATIONS`], parts of the job that are not carried out, and whatever is wrong with the
/// job as it stands unless one of the combinations mends it. A combination that fails is listed with its code.
pub fn explore_job(loaded: &LoadedJob, progress: &dyn Progress) -> Result<ExploreOutcome, RunFailure> {
    let explore = loaded.job.explore.clone().unwrap_or_default();
    let nothing = explore == Explore::default();
    let counts = [explore.worm_cone_angle_deg, explore.crossed_axes_angle_deg, explore.diagonal_ratio];
    check_count(
        counts.map(Steps::count_of).into_iter().fold(1, usize::saturating_mul),
        MOST_COMBINATIONS,
        "",
    )?;
    let base = with_own_ratio(loaded, nothing || explore.diagonal_ratio.is_some());
    let as_it_stands = prepare(&base);
    let tolerance = tolerance_of_job(loaded).map_err(RunFailure::bad_input)?;
    let ratios = match (explore.diagonal_ratio, fixed_ratio(&base)) {
        (Some(steps), _) => Ratios::Given(steps.values().collect()),
        (None, _) if nothing => {
            let ready = as_it_stands.as_ref().map_err(Clone::clone)?;
            let task = ready.task();
            Ratios::Given(task.worth_studying(&task.planning_grid()))
        }
        (None, Some(ratio)) => Ratios::Given(vec![ratio]),
        (None, None) => Ratios::OfJob,
    };
    let each = match &ratios {
        Ratios::Given(values) => values.len(),
        Ratios::OfJob => 1,
    };
    let variants: Vec<Variant> = Variant::all(&explore);
    progress.start("candidates", (variants.len() * each) as u64);
    let judged: Vec<(Vec<ExploreCandidate>, bool)> =
        variants.par_iter().map(|variant| judge_worm(&base, *variant, &ratios, progress)).collect();
    progress.finish();
    if let (Err(failure), false) = (&as_it_stands, judged.iter().any(|(_, stands)| *stands)) {
        return Err(failure.clone());
    }
    let mut candidates: Vec<ExploreCandidate> = judged.into_iter().flat_map(|(c, _)| c).collect();
    candidate::rank(&mut candidates);
    let mut varied = Vec::new();
    let varies = [
        ("worm_cone_angle_deg", explore.worm_cone_angle_deg.is_some()),
        ("crossed_axes_angle_deg", explore.crossed_axes_angle_deg.is_some()),
        ("diagonal_ratio", nothing || explore.diagonal_ratio.is_some()),
    ];
    varied.extend(varies.iter().filter(|(_, varies)| *varies).map(|(name, _)| *name));
    let title = JobTitle::new(&loaded.job.job, loaded.job.output.language);
    Ok(ExploreOutcome {
        head: title.head("Generating grinding, study of worm and diagonal ratio"),
        job: loaded.job.job.name.clone(),
        process: loaded.job.job.process.name().to_string(),
        version: env!("CARGO_PKG_VERSION"),
        tolerance_um: tolerance.tightest() * 1e3,
        varied,
        ranking: RANKING,
        allowed: candidates.iter().filter(|c| c.allowed).count(),
        levers: as_it_stands
            .as_ref()
            .map(|ready| equal_ratio_offers(&ready.setup, &ready.targets))
            .unwrap_or_default(),
        candidates,
    })
}

/// Refuses steps of `[explore]` that make more than `most` combinations, each of which costs what `cost` says.
///
/// # Errors
/// `too-many-combinations`.
pub fn check_count(combinations: usize, most: usize, cost: &str) -> Result<(), RunFailure> {
    if combinations <= most {
        return Ok(());
    }
    let finding = Diagnostic::with_code(
        "too-many-combinations",
        format!("the steps of [explore] make {combinations} combinations{cost}"),
    );
    Err(RunFailure::bad_input(
        finding
            .field("explore")
            .value(combinations)
            .allowed(format!("up to {most}"))
            .way_out("reduce a `count`; a coarse study first, then a fine one around its best"),
    ))
}

/// The job with its diagonal ratio free, where the study gives the ratios itself.
fn with_own_ratio(loaded: &LoadedJob, ratio_varies: bool) -> LoadedJob {
    let mut base = loaded.clone();
    base.job.explore = None;
    if ratio_varies {
        base.job.grinding.method = Method::Diagonal;
        base.job.grinding.diagonal_ratio = None;
    }
    base
}

/// The ratio that stands in the job as a number.
fn fixed_ratio(loaded: &LoadedJob) -> Option<f64> {
    match (&loaded.job.grinding.method, &loaded.job.grinding.diagonal_ratio) {
        (Method::Diagonal, Some(DiagonalRatio::Number(k))) => Some(*k),
        _ => None,
    }
}

/// All candidates of one worm, and whether its bodies stand.
fn judge_worm(
    base: &LoadedJob,
    variant: Variant,
    ratios: &Ratios,
    progress: &dyn Progress,
) -> (Vec<ExploreCandidate>, bool) {
    let failed = |refusal: Refused, ratio: Option<f64>| {
        progress.advance(1);
        ExploreCandidate::failed(&base.job, variant, ratio, refusal)
    };
    let made = variant.job(base).and_then(|changed| prepare(&changed).map_err(Refused::from));
    let ready = match made {
        Ok(made) => made,
        Err(refusal) => {
            let all = match ratios {
                Ratios::OfJob => vec![failed(refusal, None)],
                Ratios::Given(values) => values.iter().map(|&k| failed(refusal.clone(), Some(k))).collect(),
            };
            return (all, false);
        }
    };
    let task: PlanTask<'_> = ready.task();
    let grid = task.planning_grid();
    let demanded = task.demanded(&grid);
    let row = |ready: &Prepared, ratio: Option<f64>| {
        let candidate = match ratio {
            Some(ratio) => task.judge(&grid, ratio),
            None => task.choose(&grid).and_then(|choice| {
                let chosen = choice
                    .candidates
                    .iter()
                    .find(|c| c.ratio == choice.ratio && c.place == choice.place)
                    .cloned();
                // A rule that names a ratio has judged it.
                chosen.ok_or(generating::GeneratingError::NoFlank)
            }),
        };
        progress.advance(1);
        let judged = candidate.map_err(|e| Refused::from(&e));
        ExploreCandidate::judged(ready, &demanded, ratio, judged)
    };
    let all = match ratios {
        Ratios::OfJob => vec![row(&ready, None)],
        Ratios::Given(values) => values.par_iter().map(|&ratio| row(&ready, Some(ratio))).collect(),
    };
    (all, true)
}
