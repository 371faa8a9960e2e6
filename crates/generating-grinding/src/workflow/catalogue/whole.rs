//! The ranking of a catalogue by plans: pairs whose dressing could serve the target are planned for the whole of it and judged by the
//! referee. Knows neither files nor page.

use super::task::Task;
use super::variant::job_of_pair;
use super::width::{CrowningAt, CrowningOverWidth, PairRange, ranges};
use crate::catalogue::Catalogue;
use crate::job::LoadedJob;
use crate::workflow::execution::Execution;
use crate::workflow::explore::Refused;
use crate::workflow::run::{Outcome, plan_as_trial};
use dressing::DressingError;
use dressing::catalogue::{DesignedDresser, RankedPair, Refusal};
use foundation::geometry::{Flank, Sides};
use foundation::numerics::{Progress, Silent, equidistant};
use rayon::prelude::*;
use run::RunFailure;
use schemars::JsonSchema;
use serde::Serialize;
use std::cmp::Ordering;
use std::collections::BTreeMap;
use verdict::{Remark, Status};

/// Pairs that are planned unless the job says otherwise.
const PLANS: u32 = 12;
/// Places of a dressing stroke at which the share of the limits is looked at.
const PLACES: usize = 65;

/// What a plan of the whole target with a pair leaves.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct PairPlan {
    /// Whether the target is met.
    pub status: Status,
    /// Why it is not met.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub reason: Option<Remark>,
    /// Largest deviation from the target by the referee, normal, of the flank that has more.
    pub deviation_um: f64,
    /// Largest deviation over the tolerance at its place.
    pub tolerance_share: f64,
    /// Diagonal ratio.
    pub diagonal_ratio: f64,
    /// Length of the worm that is used.
    pub used_width_mm: f64,
    /// max |DK_j/limit_j| over the dressing stroke, of the flank that has more.
    pub largest_share_of_limit: f64,
    /// Profile crowning over the width, wanted and made, by flank.
    pub crowning: BTreeMap<&'static str, Vec<CrowningAt>>,
}

/// A pair beside its figures: the crownings that it can make, and its plan.
#[derive(Clone, Debug, Default)]
pub struct WholePair {
    /// Crownings by flank, where the pair can be dressed at all.
    pub ranges: Sides<Option<PairRange>>,
    /// The plan; nothing for a pair that was not planned.
    pub plan: Option<Result<PairPlan, Refused>>,
}

impl WholePair {
    /// Whether the pair meets the target.
    pub fn is_met(&self) -> bool {
        matches!(&self.plan, Some(Ok(plan)) if plan.status == Status::Met)
    }

    /// Whether there is a plan, met or missed.
    pub fn is_planned(&self) -> bool {
        matches!(self.plan, Some(Ok(_)))
    }

    /// Whether the crownings of all flanks that are ground reach from the least to the largest one that is wanted.
    fn serves(&self) -> bool {
        let known: Vec<&PairRange> = self.ranges.iter().filter_map(|(_, range)| range.as_ref()).collect();
        !known.is_empty() && known.into_iter().all(|range| range.serves_the_width)
    }
}

/// Whether a plan may come to something: what does not stand together or lacks length is refused for any target.
fn may_serve(pair: &RankedPair) -> bool {
    match &pair.refusal {
        None => true,
        Some(
            Refusal::AxisLimit { .. }
            | Refusal::ProfileError { .. }
            | Refusal::Dressing(DressingError::NoZero { .. } | DressingError::OutOfDresser { .. }),
        ) => true,
        Some(_) => false,
    }
}

/// Plans the pairs of a ranking by profiles that come first and ranks all anew: those that meet the target by the share of the axis
/// limits, those that miss it by what they leave, then those that were not planned, then those that cannot be made.
///
/// # Errors
/// [`RunFailure`]: what is wrong with the job for every pair.
pub fn rank_by_plans(
    loaded: &LoadedJob,
    catalogue: &Catalogue,
    (task, over): (&Task, &CrowningOverWidth),
    ranked: Vec<RankedPair>,
    progress: &dyn Progress,
) -> Result<Vec<(RankedPair, WholePair)>, RunFailure> {
    let plans = loaded.job.catalogue.as_ref().and_then(|source| source.plans).unwrap_or(PLANS) as usize;
    let designed = |pair: &RankedPair| -> Option<DesignedDresser> {
        let hand = task.worms[pair.worm].choice.hand;
        task.dressers[pair.dresser].designed(&task.workshop, hand).ok()
    };
    let mut pairs: Vec<(RankedPair, WholePair)> = ranked
        .into_par_iter()
        .map(|pair| {
            let ranges = pair.figures.as_ref().and_then(|figures| {
                Some(ranges(task, over, (pair.worm, pair.dresser), &designed(&pair)?, figures))
            });
            let whole = WholePair { ranges: ranges.unwrap_or_default(), plan: None };
            (pair, whole)
        })
        .collect();
    // Stable: the order by profiles stays within those that serve the width and those that do not.
    pairs.sort_by_key(|(pair, whole)| (!may_serve(pair), !whole.serves()));
    let planned = pairs.iter().take_while(|(pair, _)| may_serve(pair)).count().min(plans);
    progress.start("plans", planned as u64);
    let found: Vec<Result<PairPlan, RunFailure>> = pairs[..planned]
        .par_iter()
        .map(|(pair, _)| {
            let (worm, dresser) = (&catalogue.worm[pair.worm], &catalogue.dresser[pair.dresser]);
            let planned = plan_as_trial(&job_of_pair(loaded, task, worm, dresser), &Silent);
            progress.advance(1);
            planned.map(|outcome| of_outcome(task, over, &outcome))
        })
        .collect();
    progress.finish();
    for ((_, whole), plan) in pairs.iter_mut().zip(found) {
        whole.plan = Some(match plan {
            Ok(plan) => Ok(plan),
            Err(failure @ RunFailure::NotProducible(_)) => Err(Refused::from(failure)),
            Err(failure) => return Err(failure),
        });
    }
    pairs.sort_by(|(a, of_a), (b, of_b)| place(a, of_a).cmp(&place(b, of_b)).then(within(of_a, of_b)));
    Ok(pairs)
}

/// The class of a pair in the ranking.
fn place(pair: &RankedPair, whole: &WholePair) -> u8 {
    match &whole.plan {
        Some(Ok(plan)) if plan.status == Status::Met => 0,
        Some(Ok(_)) => 1,
        None if may_serve(pair) => 2,
        Some(Err(_)) => 3,
        None => 4,
    }
}

/// The order of two plans of one class.
fn within(a: &WholePair, b: &WholePair) -> Ordering {
    match (&a.plan, &b.plan) {
        (Some(Ok(a)), Some(Ok(b))) if a.status == Status::Met => {
            a.largest_share_of_limit.total_cmp(&b.largest_share_of_limit)
        }
        (Some(Ok(a)), Some(Ok(b))) => a.tolerance_share.total_cmp(&b.tolerance_share),
        _ => Ordering::Equal,
    }
}

fn of_outcome(task: &Task, over: &CrowningOverWidth, outcome: &Outcome) -> PairPlan {
    let (result, execution) = (&outcome.result, &outcome.execution);
    let largest = |of: fn(&crate::workflow::result::FlankResult) -> f64| {
        result.flanks.values().map(of).fold(0.0, f64::max)
    };
    let crowning = Flank::BOTH.into_iter().filter_map(|flank| {
        let made = result.flanks.get(flank.name())?;
        let cos = task.wanted.cos_base_helix[flank];
        Some((flank.name(), over.made(flank, made, cos, task.involute[flank])))
    });
    PairPlan {
        status: result.verdict.status(),
        reason: result.verdict.reason().cloned(),
        deviation_um: largest(|flank| flank.max_deviation_um),
        tolerance_share: largest(|flank| flank.tolerance_share),
        diagonal_ratio: execution.ratio,
        used_width_mm: result.settings.worm_length_mm,
        largest_share_of_limit: share_of_limits(execution, &task.limits.correction),
        crowning: crowning.collect(),
    }
}

/// max |DK_j/limit_j| over the dressing strokes; 0 where no disc in line contact dresses in one stroke.
fn share_of_limits(execution: &Execution, limits: &[f64; 4]) -> f64 {
    let mut share = 0.0_f64;
    for flank in Flank::BOTH {
        let Some(dressing) = execution.flanks[flank].as_ref().and_then(|flank| flank.dressing()) else {
            continue;
        };
        for v in equidistant(dressing.driven, PLACES) {
            for (law, limit) in dressing.corrections.iter().zip(limits) {
                share = share.max(law.value(v).abs() / limit);
            }
        }
    }
    share
}
