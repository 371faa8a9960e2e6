//! What `plan`, `explore` and `check` do with a job that names a catalogue.

use std::fmt::Write;
use std::path::PathBuf;

use flankwright::exchange::LoadedJob;
use flankwright::exchange::catalogue::{LoadedCatalogue, catalogue_of_job};
use flankwright::workflow::{
    CatalogueOutcome, CataloguePair, FreeOutcome, plan_from_catalogue, rank_catalogue, study_free_worm,
    write_catalogue, write_free_study,
};

use super::outcome::{self, unwritten};
use crate::arguments::CommonArguments;
use crate::exit::Exit;
use crate::failure::Failure;
use crate::output;
use crate::progress::Bars;

/// The catalogue that a job names.
///
/// # Errors
/// Everything that is wrong with its files.
pub fn of_job(loaded: &LoadedJob) -> Result<Option<LoadedCatalogue>, Failure> {
    Ok(catalogue_of_job(loaded)?)
}

/// Plans the best pair; the ranking is written beside the plan.
///
/// # Errors
/// As for a job with fixed bodies.
pub fn plan(
    loaded: &LoadedJob,
    catalogue: &LoadedCatalogue,
    common: &CommonArguments,
) -> Result<Exit, Failure> {
    let bars = Bars::new(common.quiet);
    let planned = plan_from_catalogue(loaded, catalogue, &bars);
    bars.finish();
    let plan = planned.map_err(|failure| Failure::of_run(loaded, failure))?;
    let directory = output::own_directory(common, loaded, &loaded.job.job)?;
    write_catalogue(&plan.ranking, &directory).map_err(unwritten)?;
    match plan.planned {
        Ok((variant, planned)) => outcome::deliver(common, &variant, Ok(*planned)),
        Err(failure) => outcome::deliver(common, loaded, Err(failure)),
    }
}

/// Ranks all pairs, or looks where each dresser makes the target.
///
/// # Errors
/// Everything that is wrong with the job for all pairs, files that cannot be written.
pub fn explore(
    loaded: &LoadedJob,
    catalogue: &LoadedCatalogue,
    top: usize,
    common: &CommonArguments,
) -> Result<Exit, Failure> {
    if loaded.job.explore.is_some() {
        return free(loaded, catalogue, top, common);
    }
    let bars = Bars::new(common.quiet);
    let ranked = rank_catalogue(loaded, catalogue, &bars);
    bars.finish();
    let outcome = ranked.map_err(|failure| Failure::of_run(loaded, failure))?;
    let written =
        write_catalogue(&outcome, &output::directory(common, loaded, &loaded.job.job)).map_err(unwritten)?;
    if common.json {
        output::print_json(&outcome)?;
    } else if !common.quiet {
        output::print(&ranking(&outcome, top, &written))?;
    }
    if outcome.best().is_some() {
        return Ok(Exit::Done);
    }
    if common.quiet
        && let Some(refused) = outcome.pairs.first().and_then(|pair| pair.refused.as_ref())
    {
        // That nothing fits is reported even when all else is quiet.
        eprintln!("{}: no pair makes the profile: {}; {}", outcome.job, refused.text, refused.way_out);
    }
    Ok(Exit::NotProducible)
}

fn free(
    loaded: &LoadedJob,
    catalogue: &LoadedCatalogue,
    top: usize,
    common: &CommonArguments,
) -> Result<Exit, Failure> {
    let bars = Bars::new(common.quiet);
    let studied = study_free_worm(loaded, catalogue, &bars);
    bars.finish();
    let outcome = studied.map_err(|failure| Failure::of_run(loaded, failure))?;
    let written =
        write_free_study(&outcome, &output::directory(common, loaded, &loaded.job.job)).map_err(unwritten)?;
    if common.json {
        output::print_json(&outcome)?;
    } else if !common.quiet {
        output::print(&working(&outcome, top, &written))?;
    }
    if outcome.working() > 0 {
        return Ok(Exit::Done);
    }
    if common.quiet {
        let range = outcome.range;
        eprintln!(
            "{}: no dresser makes the profile with {} {} to {}",
            outcome.job, outcome.free, range[0], range[1]
        );
    }
    Ok(Exit::NotProducible)
}

/// Columns of the printed ranking: heading and width.
const COLUMNS: [(&str, usize); 7] = [
    ("rank", 5),
    ("share %", 9),
    ("P %", 8),
    ("error um", 10),
    ("tip land", 10),
    ("life to mm", 12),
    ("", 2),
];

fn fixed(x: Option<f64>, decimals: usize) -> String {
    x.map_or_else(|| "-".into(), |x| format!("{x:.decimals$}"))
}

/// The value of largest magnitude of the flanks.
fn largest(
    pair: &CataloguePair,
    of: impl Fn(&flankwright::workflow::PairFlank) -> Option<f64>,
) -> Option<f64> {
    pair.flanks.values().filter_map(of).max_by(|a, b| a.abs().total_cmp(&b.abs()))
}

fn ranking(outcome: &CatalogueOutcome, top: usize, written: &[PathBuf]) -> String {
    let mut text = String::new();
    let wanted: Vec<String> =
        outcome.wanted_profile_crowning_um.iter().map(|(flank, um)| format!("{flank} {um:.3} um")).collect();
    // Writing to a text cannot fail.
    let _ = writeln!(
        text,
        "{}: {} of {} pairs make the profile crowning ({})",
        outcome.job,
        outcome.ok,
        outcome.pairs.len(),
        wanted.join(", ")
    );
    if top > 0 {
        for (heading, width) in COLUMNS {
            let _ = write!(text, "{heading:>width$}");
        }
        text += "worm / dresser / verdict\n";
    }
    for pair in outcome.pairs.iter().take(top) {
        let land = pair.flanks.values().filter_map(|f| f.largest_tip_land_mm).reduce(f64::min);
        let cells = [
            pair.rank.to_string(),
            fixed(pair.largest_share_of_limit.map(|s| 100.0 * s), 1),
            fixed(largest(pair, |f| Some(100.0 * f.stretch)), 3),
            fixed(largest(pair, |f| Some(f.profile_error_um)), 3),
            fixed(land, 3),
            fixed(pair.life.as_ref().map(|life| life.to_mm), 2),
            String::new(),
        ];
        for (cell, (_, width)) in cells.iter().zip(COLUMNS) {
            let _ = write!(text, "{cell:>width$}");
        }
        let verdict = pair.refused.as_ref().map_or("makes it", |refused| refused.code);
        let _ = writeln!(text, "{} / {} / {verdict}", pair.worm, pair.dresser);
    }
    let more = outcome.pairs.len().saturating_sub(top);
    if more > 0 {
        let _ = writeln!(text, "  and {more} more in explore.csv");
    }
    let _ = writeln!(text, "  ranked: {}", outcome.ranking);
    if outcome.ok == 0
        && let Some(refused) = outcome.pairs.first().and_then(|pair| pair.refused.as_ref())
    {
        let _ = writeln!(text, "  {}: {}", refused.code, refused.text);
        let _ = writeln!(text, "  remedy: {}", refused.way_out);
    }
    if let Some(page) = written.last() {
        let _ = writeln!(text, "  report: {}", page.display());
    }
    text
}

fn working(outcome: &FreeOutcome, top: usize, written: &[PathBuf]) -> String {
    let mut text = String::new();
    let _ = writeln!(
        text,
        "{}: {} of {} pairs have a {} from {} to {} that makes the profile",
        outcome.job,
        outcome.working(),
        outcome.pairs.len(),
        outcome.free,
        outcome.range[0],
        outcome.range[1]
    );
    for pair in outcome.pairs.iter().filter(|pair| !pair.ranges.is_empty()).take(top) {
        for range in &pair.ranges {
            let _ = writeln!(
                text,
                "  {} on {}: {:.3} to {:.3}, best {:.3} ({} % of a limit)",
                pair.dresser,
                pair.worm,
                range.from,
                range.to,
                range.best.value,
                fixed(range.best.largest_share_of_limit.map(|s| 100.0 * s), 1)
            );
        }
    }
    if let Some(page) = written.last() {
        let _ = writeln!(text, "  report: {}", page.display());
    }
    text
}
