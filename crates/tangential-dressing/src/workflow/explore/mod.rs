//! `explore` of tangential dressing: every combination of shift ratio, worm and dresser planned as `plan` would, ranked. The figures are those
//! of the exact contact; the referee judges what is planned in the end.

mod candidate;
mod files;
mod summary;
mod variant;

pub use candidate::{ExploredFlank, TangentialCandidate};
pub use files::page;

use super::plan::{plan_pass, task_of};
use super::prepare::prepare_tangential;
use crate::job::{LoadedTangentialJob, TangentialExplore};
use crate::{FitLimits, TangentialError, TangentialFlank};
use contact::Measure;
use foundation::geometry::Flank;
use foundation::numerics::{Progress, Silent};
use generating_grinding::job::Steps;
use generating_grinding::workflow::explore::{Refused, check_count};
use rayon::prelude::*;
use report::PageHead;
use run::{JobTitle, RunFailure};
use schemars::JsonSchema;
use serde::Serialize;
use std::collections::BTreeMap;
use variant::Variant;

/// Combinations that one study may have: each is planned.
pub const MOST_COMBINATIONS: usize = 2000;

/// The rule of the ranking, in words.
pub const RANKING: &str = "those within the tolerance first, by worm length, then by deviation; then the others by deviation; last those \
    that cannot be made";

/// Ratios of a study that names nothing: so many, from no shift to this multiple of the neutral ratio, and on a spur gear, which has none, to
/// this ratio.
const UNNAMED: (usize, f64, f64) = (13, 1.5, 3.0);

/// What a study found: the document of `explore.json`.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct TangentialExploration {
    /// Head of its page.
    #[serde(skip)]
    pub head: PageHead,
    /// Name of the job.
    pub job: String,
    /// Process.
    pub process: String,
    /// Version of flankwright.
    pub version: &'static str,
    /// Tolerance of the job.
    pub tolerance_um: f64,
    /// What varies: `shift_ratio`, `worm_tip_diameter`, `dresser_tip_diameter`, `worm_threads`.
    pub varied: Vec<&'static str>,
    /// How the candidates are ranked.
    pub ranking: &'static str,
    /// Number of candidates within the tolerance.
    pub met: usize,
    /// All combinations, the best first.
    pub candidates: Vec<TangentialCandidate>,
}

/// Plans every combination of `[explore]`; what is absent there keeps the job's value. Without `[explore]` the shift ratio alone varies. The
/// same job gives the same outcome on any number of threads.
///
/// # Errors
/// [`RunFailure`]: more than [`MOST_COMBINATIONS`], and whatever is wrong with the job as it stands if no combination can be made.
pub fn explore_tangential(
    loaded: &LoadedTangentialJob,
    progress: &dyn Progress,
) -> Result<TangentialExploration, RunFailure> {
    let explore = match &loaded.job.explore {
        Some(explore) => explore.clone(),
        None => unnamed(loaded)?,
    };
    check_count(variant::count(&explore), MOST_COMBINATIONS, ", each of which is planned")?;
    let variants = Variant::all(&explore);
    progress.start("candidates", variants.len() as u64);
    let judged: Vec<Result<TangentialCandidate, (Variant, RunFailure)>> = variants
        .par_iter()
        .map(|&variant| {
            let candidate = planned(&variant.job(loaded)).map_err(|failure| (variant, failure));
            progress.advance(1);
            candidate
        })
        .collect();
    progress.finish();
    if judged.iter().all(Result::is_err)
        && let Some(Err((_, failure))) = judged.first()
        && let RunFailure::BadInput(_) = failure
    {
        return Err(failure.clone());
    }
    let job = &loaded.job;
    let mut candidates: Vec<TangentialCandidate> = judged
        .into_iter()
        .map(|judged| {
            judged.unwrap_or_else(|(variant, failure)| {
                TangentialCandidate::failed(&variant.job(loaded).job, Refused::from(failure))
            })
        })
        .collect();
    candidate::rank(&mut candidates);
    let varies = [
        ("shift_ratio", explore.shift_ratio.is_some()),
        ("worm_tip_diameter", explore.worm_tip_diameter.is_some()),
        ("dresser_tip_diameter", explore.dresser_tip_diameter.is_some()),
        ("worm_threads", !explore.worm_threads.is_empty()),
    ];
    Ok(TangentialExploration {
        head: JobTitle::new(&job.job, job.output.language)
            .head("Tangential dressing, study of worm and shift"),
        job: job.job.name.clone(),
        process: job.job.process.name().to_string(),
        version: env!("CARGO_PKG_VERSION"),
        tolerance_um: job.target.tolerance_um,
        varied: varies.into_iter().filter(|(_, varies)| *varies).map(|(name, _)| name).collect(),
        ranking: RANKING,
        met: candidates.iter().filter(|c| c.met).count(),
        candidates,
    })
}

fn unnamed(loaded: &LoadedTangentialJob) -> Result<TangentialExplore, RunFailure> {
    let model = prepare_tangential(loaded)?.model;
    let (count, of_neutral, of_spur) = UNNAMED;
    let neutral = Flank::BOTH.into_iter().filter_map(|flank| model.neutral_ratios[flank]).reduce(f64::max);
    let to = neutral.map_or(of_spur, |neutral| of_neutral * neutral);
    let (from, to) = if to < 0.0 { (to, 0.0) } else { (0.0, to) };
    Ok(TangentialExplore { shift_ratio: Some(Steps { from, to, count }), ..Default::default() })
}

/// A combination as planned.
fn planned(loaded: &LoadedTangentialJob) -> Result<TangentialCandidate, RunFailure> {
    let ready = prepare_tangential(loaded)?;
    let mut flanks = BTreeMap::new();
    let (mut variables, mut length) = (0, 0.0);
    for pass in &ready.passes {
        let plan = plan_pass(&ready, pass, &Silent)?;
        let wanted = |flank: Flank, w: f64, z: f64| ready.wanted(flank, w, z);
        let task = task_of(&ready, pass, &wanted, FitLimits::STEADY);
        let judged = task
            .judge(&plan.settings, ready.rules.judged_on)
            .map_err(|error: TangentialError| RunFailure::from(&error))?;
        variables += plan.free.len();
        let mut used = [f64::INFINITY, f64::NEG_INFINITY];
        for of in &judged {
            let ground = TangentialFlank::new(&ready.model, of.flank, pass, &plan.settings, Measure::Ray);
            let strokes = ground.strokes(&of.points);
            used = [used[0].min(strokes.worm_faces[0]), used[1].max(strokes.worm_faces[1])];
            let figures = ExploredFlank {
                max_deviation_um: of.largest() * 1e3,
                least_determinant_ratio: of.least_ratio(),
                worm_modification_um: strokes.worm_modification * 1e3,
            };
            flanks.insert(of.flank.name(), figures);
        }
        length = f64::max(length, used[1] - used[0]);
    }
    Ok(TangentialCandidate::planned(&ready, flanks, variables, length))
}
