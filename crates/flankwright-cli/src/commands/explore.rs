//! `flankwright explore`: diagonal ratios and worms side by side, ranked.

use std::fmt::Write;
use std::path::PathBuf;

use clap::Args;
use flankwright::exchange::LoadedJob;
use flankwright::workflow::{
    ExploreCandidate, ExploreOutcome, explore_job, study_dressing, write_dressing_study, write_exploration,
};

use super::catalogue;
use super::outcome::unwritten;
use crate::arguments::CommonArguments;
use crate::exit::Exit;
use crate::failure::Failure;
use crate::output;
use crate::progress::Bars;

/// Arguments of `explore`.
#[derive(Args, Debug)]
#[command(
    after_help = "Example:\n  flankwright explore examples/twist-free-crowning.toml --top 5 -o study\n\n\
    What varies stands in the table [explore] of the job, e.g. diagonal_ratio = { from = -3.0, to = 3.0, count = 61 };\n\
    without it the diagonal ratio runs over both signs. A job with a [catalogue] has all its pairs of worm and dresser ranked. Writes explore.json, explore.csv and explore.html.\n\
    Exit status 3: what can be made misses the tolerance; 4: nothing can be made with these bodies."
)]
pub struct ExploreArguments {
    /// The job file (TOML or JSON); `-` reads standard input
    #[arg(value_name = "JOB")]
    pub job: PathBuf,
    /// Rows of the ranking to print; the files hold all
    #[arg(long, value_name = "N", default_value_t = 20)]
    pub top: usize,
    /// Arguments that every command has.
    #[command(flatten)]
    pub common: CommonArguments,
}

/// Judges every combination, writes the files and prints the head of the ranking.
///
/// # Errors
/// Everything that is wrong with the job for all combinations, files that cannot be written.
pub fn run(arguments: &ExploreArguments) -> Result<Exit, Failure> {
    let common = &arguments.common;
    let loaded = output::load_grinding_job(&arguments.job, "explore")?;
    if let Some(found) = catalogue::of_job(&loaded)? {
        return catalogue::explore(&loaded, &found, arguments.top, common);
    }
    if loaded.job.explore.as_ref().is_some_and(|explore| explore.dressing.is_some()) {
        return dressing(&loaded, common);
    }
    let bars = Bars::new(common.quiet);
    let explored = explore_job(&loaded, &bars);
    bars.finish();
    let outcome = explored.map_err(|failure| Failure::of_run(&loaded, failure))?;
    let written = write_exploration(&outcome, &output::directory(common, &loaded, &loaded.job.job))
        .map_err(unwritten)?;
    if common.json {
        output::print_json(&outcome)?;
    } else if !common.quiet {
        output::print(&summary(&outcome, arguments.top, &written))?;
    }
    if outcome.best().is_some() {
        return Ok(Exit::Done);
    }
    if common.quiet
        && let Some(refused) = outcome.candidates.first().and_then(|c| c.refused.as_ref())
    {
        // That nothing fits is reported even when all else is quiet.
        eprintln!("{}: no combination is allowed: {}; {}", outcome.job, refused.text, refused.way_out);
    }
    Ok(if outcome.is_producible() { Exit::TargetMissed } else { Exit::NotProducible })
}

/// Carries out a study of dressing, writes the files and names the page.
fn dressing(loaded: &LoadedJob, common: &CommonArguments) -> Result<Exit, Failure> {
    let bars = Bars::new(common.quiet);
    let studied = study_dressing(loaded, &bars);
    bars.finish();
    let outcome = studied.map_err(|failure| Failure::of_run(loaded, failure))?;
    let written = write_dressing_study(&outcome, &output::directory(common, loaded, &loaded.job.job))
        .map_err(unwritten)?;
    if common.json {
        output::print_json(&outcome)?;
    } else if !common.quiet {
        let mut text = outcome.summary();
        if let Some(page) = written.last() {
            let _ = writeln!(text, "  report: {}", page.display());
        }
        output::print(&text)?;
    }
    Ok(if outcome.is_producible() { Exit::Done } else { Exit::NotProducible })
}

/// Columns of the printed table: heading and width.
const COLUMNS: [(&str, usize); 8] = [
    ("rank", 5),
    ("cone deg", 10),
    ("cross deg", 11),
    ("ratio", 11),
    ("residual um", 12),
    ("score", 9),
    ("worm mm", 9),
    ("|Kl-Kr|", 9),
];

fn summary(outcome: &ExploreOutcome, top: usize, written: &[PathBuf]) -> String {
    let mut text = String::new();
    // Writing to a text cannot fail.
    let _ = writeln!(
        text,
        "{}: {} of {} combinations are allowed (tolerance {} um)",
        outcome.job,
        outcome.allowed,
        outcome.candidates.len(),
        outcome.tolerance_um
    );
    if top > 0 {
        for (heading, width) in COLUMNS {
            let _ = write!(text, "{heading:>width$}");
        }
        text += "  verdict\n";
    }
    for candidate in outcome.candidates.iter().take(top) {
        row(&mut text, candidate);
    }
    let more = outcome.candidates.len().saturating_sub(top);
    if more > 0 {
        let _ = writeln!(text, "  and {more} more in explore.csv");
    }
    let _ = writeln!(text, "  ranked: {}", outcome.ranking);
    if outcome.best().is_none()
        && let Some(refused) = outcome.candidates.first().and_then(|c| c.refused.as_ref())
    {
        let _ = writeln!(text, "  {}: {}", refused.code, refused.text);
        let _ = writeln!(text, "  remedy: {}", refused.way_out);
    }
    for offer in &outcome.levers {
        let keys: Vec<String> = offer.keys.iter().map(|(key, value)| format!("{key} = {value}")).collect();
        let _ = writeln!(
            text,
            "  one ratio for both flanks: {} at K = {}",
            keys.join(", "),
            offer.diagonal_ratio
        );
    }
    if let Some(page) = written.last() {
        let _ = writeln!(text, "  report: {}", page.display());
    }
    text
}

fn row(text: &mut String, c: &ExploreCandidate) {
    let fixed = |x: Option<f64>, decimals: usize| x.map_or_else(|| "-".into(), |x| format!("{x:.decimals$}"));
    let cells = [
        c.rank.to_string(),
        fixed(Some(c.worm_cone_angle_deg), 4),
        fixed(c.crossed_axes_angle_deg, 4),
        fixed(c.diagonal_ratio, 5),
        fixed(c.residual_um, 4),
        fixed(c.score, 4),
        fixed(c.worm_occupation_mm, 2),
        fixed(c.demanded_ratio_difference, 5),
    ];
    for (cell, (_, width)) in cells.iter().zip(COLUMNS) {
        let _ = write!(text, "{cell:>width$}");
    }
    let verdict = c.refused.as_ref().map_or("allowed", |refused| refused.code);
    let _ = writeln!(text, "  {verdict}");
}
