//! The best pair of a catalogue, planned with all effort and programs: the plan and its referee decide, whatever the ranking went by.

use super::outcome::CatalogueOutcome;
use super::ranked;
use super::summary::PlannedPair;
use super::task::Task;
use super::variant::job_of_pair;
use crate::catalogue::LoadedCatalogue;
use crate::job::LoadedJob;
use crate::workflow::JobOutcome;
use crate::workflow::run::{Outcome, plan_job};
use foundation::numerics::Progress;
use job::Diagnostic;
use run::RunFailure;
use verdict::{Remark, Status};

/// Pairs that are planned until one meets the tolerance.
const TRIED: usize = 6;

/// Plans the first pair of the ranking whose plan meets the tolerance; if none of the first does, the one that misses it least.
///
/// # Errors
/// As [`super::rank_catalogue`].
pub fn plan_from_catalogue(
    loaded: &LoadedJob,
    catalogue: &LoadedCatalogue,
    progress: &dyn Progress,
) -> Result<PlannedPair, RunFailure> {
    let task = Task::new(loaded, catalogue)?;
    let found = ranked(loaded, catalogue, &task, progress)?;
    let ranking = CatalogueOutcome::new(loaded, &catalogue.catalogue, &task, &found);
    let bodies = &catalogue.catalogue;
    let mut passed: Vec<String> = Vec::new();
    let mut best: Option<(f64, usize, LoadedJob, Outcome)> = None;
    let mut refusal = None;
    for (k, pair) in found.worth_planning().take(TRIED).enumerate() {
        let (worm, dresser) = (&bodies.worm[pair.worm], &bodies.dresser[pair.dresser]);
        let variant = job_of_pair(loaded, &task, worm, dresser);
        match plan_job(&variant, progress) {
            Ok(outcome) => {
                let flanks = outcome.result.flanks.values();
                let miss = flanks.map(|f| f.max_deviation_um).fold(0.0, f64::max);
                let met = outcome.result.verdict.status() == Status::Met;
                if !met {
                    passed
                        .push(format!("{} with {} misses it by up to {miss:.3} um", worm.name, dresser.name));
                }
                if met || best.as_ref().is_none_or(|(least, ..)| miss < *least) {
                    best = Some((miss, k + 1, variant, outcome));
                }
                if met {
                    break;
                }
            }
            Err(RunFailure::NotProducible(finding)) => {
                passed.push(format!("{} with {}: {}", worm.name, dresser.name, finding.message));
                refusal.get_or_insert(RunFailure::NotProducible(finding));
            }
            Err(failure @ RunFailure::BadInput(_)) => return Err(failure),
        }
    }
    let planned = match best {
        Some((_, rank, variant, mut outcome)) => {
            outcome.result.warnings.insert(0, remark(&ranking, rank, passed));
            Ok(Box::new(JobOutcome { loaded: variant, outcome }))
        }
        None => Err(refusal.unwrap_or_else(|| nothing_fits(&ranking))),
    };
    Ok(PlannedPair { ranking, planned })
}

/// Which pair was taken and which were passed over.
fn remark(ranking: &CatalogueOutcome, rank: usize, mut passed: Vec<String>) -> Remark {
    let (worm, dresser) =
        ranking.pairs.get(rank - 1).map_or(("", ""), |p| (p.worm.as_str(), p.dresser.as_str()));
    passed.retain(|text| !text.starts_with(&format!("{worm} with {dresser}")));
    let others =
        if passed.is_empty() { String::new() } else { format!("; passed over: {}", passed.join("; ")) };
    let (ok, all) = (ranking.ok, ranking.pairs.len());
    let text = if ranking.is_by_plans() {
        format!(
            "worm {worm} and dresser {dresser} are number {rank} in the ranking by plans, in which {ok} of {all} pairs meet the target{others}"
        )
    } else {
        format!(
            "worm {worm} and dresser {dresser} are number {rank} of {ok} pairs that make the profile, of {all} in the catalogue{others}"
        )
    };
    Remark {
        code: "chosen-from-catalogue",
        text,
        way_out: "explore.html ranks all pairs; to plan another one, give it as [worm] and [dresser]".into(),
    }
}

/// The finding where no pair makes the profile: the reason of the first one.
fn nothing_fits(ranking: &CatalogueOutcome) -> RunFailure {
    let first = ranking.pairs.first();
    let text = match first.and_then(|pair| Some((pair, pair.refused.as_ref()?))) {
        Some((pair, refused)) => format!(
            "none of the {} pairs of the catalogue makes the {}; the nearest, worm {} with dresser {}: {}",
            ranking.pairs.len(),
            if ranking.is_by_plans() { "target" } else { "profile" },
            pair.worm,
            pair.dresser,
            refused.text
        ),
        None => "the catalogue has no pair".into(),
    };
    let advice = first.and_then(|pair| pair.refused.as_ref()).map_or("", |refused| refused.way_out.as_str());
    let finding = Diagnostic::with_code("no-pair-fits", text).field("catalogue").way_out(format!(
        "{advice}; [explore] catalogue = {{ free = .. }} shows which worms the dressers would serve"
    ));
    RunFailure::not_producible(finding)
}
