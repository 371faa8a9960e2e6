//! What a terminal shows of a ranking of pairs and of the plan of the best, and how it ended.

use super::{CatalogueOutcome, CataloguePair, FreeOutcome, PairFlank, write_catalogue, write_free_study};
use crate::workflow::JobOutcome;
use erased_serde::Serialize;
use run::{Conclusion, FlankMaps, RunFailure, TaskOutcome, WriteError};
use scene::Scene;
use std::fmt::Write;
use std::path::{Path, PathBuf};
use verdict::Verdict;

/// The plan of the best pair of a catalogue, with the ranking of all.
pub struct PlannedPair {
    /// The plan, with the job that has this pair; or why no pair makes the target.
    pub planned: Result<Box<JobOutcome>, RunFailure>,
    /// All pairs.
    pub ranking: CatalogueOutcome,
}

impl PlannedPair {
    /// What there is to show: the plan, or the ranking.
    fn shown(&self) -> &dyn TaskOutcome {
        match &self.planned {
            Ok(planned) => planned.as_ref(),
            Err(_) => &self.ranking,
        }
    }
}

impl TaskOutcome for PlannedPair {
    fn job(&self) -> &str {
        self.shown().job()
    }

    fn verdict(&self) -> Option<&Verdict> {
        self.shown().verdict()
    }

    fn result(&self) -> &dyn Serialize {
        self.shown().result()
    }

    fn scene(&self) -> Option<Result<Scene, RunFailure>> {
        self.shown().scene()
    }

    fn flanks(&self) -> Vec<FlankMaps<'_>> {
        self.planned.as_ref().map_or_else(|_| Vec::new(), |planned| planned.flanks())
    }

    fn write(&self, directory: &Path) -> Result<Vec<PathBuf>, WriteError> {
        let mut written = write_catalogue(&self.ranking, directory)?;
        if let Ok(planned) = &self.planned {
            written.extend(planned.write(directory)?);
        }
        Ok(written)
    }

    fn summary(&self, written: &[PathBuf], rows: usize) -> String {
        self.shown().summary(written, rows)
    }

    fn conclusion(&self) -> Conclusion {
        self.shown().conclusion()
    }

    fn complaint(&self) -> Option<String> {
        self.shown().complaint()
    }

    fn refusal(&self) -> Option<&RunFailure> {
        self.planned.as_ref().err()
    }
}

impl TaskOutcome for CatalogueOutcome {
    fn job(&self) -> &str {
        &self.job
    }

    fn verdict(&self) -> Option<&Verdict> {
        None
    }

    fn result(&self) -> &dyn Serialize {
        self
    }

    fn write(&self, directory: &Path) -> Result<Vec<PathBuf>, WriteError> {
        write_catalogue(self, directory)
    }

    fn summary(&self, written: &[PathBuf], rows: usize) -> String {
        ranking(self, rows, written)
    }

    fn conclusion(&self) -> Conclusion {
        match (self.best(), self.pairs.iter().any(|pair| pair.plan.is_some())) {
            (Some(_), _) => Conclusion::Done,
            (None, true) => Conclusion::Missed,
            (None, false) => Conclusion::NotProducible,
        }
    }

    fn complaint(&self) -> Option<String> {
        let refused =
            self.pairs.first().and_then(|pair| pair.refused.as_ref()).filter(|_| self.best().is_none())?;
        let no_pair = if self.is_by_plans() { "meets the target" } else { "makes the profile" };
        Some(format!("{}: no pair {no_pair}: {}; {}", self.job, refused.text, refused.way_out))
    }
}

impl TaskOutcome for FreeOutcome {
    fn job(&self) -> &str {
        &self.job
    }

    fn verdict(&self) -> Option<&Verdict> {
        None
    }

    fn result(&self) -> &dyn Serialize {
        self
    }

    fn write(&self, directory: &Path) -> Result<Vec<PathBuf>, WriteError> {
        write_free_study(self, directory)
    }

    fn summary(&self, written: &[PathBuf], rows: usize) -> String {
        working(self, rows, written)
    }

    fn conclusion(&self) -> Conclusion {
        if self.working() > 0 { Conclusion::Done } else { Conclusion::NotProducible }
    }

    fn complaint(&self) -> Option<String> {
        let [from, to] = self.range;
        (self.working() == 0)
            .then(|| format!("{}: no dresser makes the profile with {} {from} to {to}", self.job, self.free))
    }
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
fn largest(pair: &CataloguePair, of: impl Fn(&PairFlank) -> Option<f64>) -> Option<f64> {
    pair.flanks.values().filter_map(of).max_by(|a, b| a.abs().total_cmp(&b.abs()))
}

fn ranking(outcome: &CatalogueOutcome, top: usize, written: &[PathBuf]) -> String {
    let mut text = String::new();
    let wanted: Vec<String> =
        outcome.wanted_profile_crowning_um.iter().map(|(flank, um)| format!("{flank} {um:.3} um")).collect();
    // Writing to a text cannot fail.
    let _ = writeln!(
        text,
        "{}: {} of {} pairs {} ({})",
        outcome.job,
        outcome.ok,
        outcome.pairs.len(),
        if outcome.is_by_plans() {
            "meet the target, profile crowning on average"
        } else {
            "make the profile crowning"
        },
        wanted.join(", ")
    );
    if outcome.is_by_plans() {
        by_plans(&mut text, outcome, top);
    } else {
        by_profile(&mut text, outcome, top);
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

/// Rows of a ranking by plans.
fn by_plans(text: &mut String, outcome: &CatalogueOutcome, top: usize) {
    for (flank, wanted) in &outcome.wanted_over_width {
        let at = |c: &super::CrowningAt| format!("{:.3} um at {} mm", c.wanted_um, c.z_mm);
        let _ =
            writeln!(text, "  {flank}: crowning {}", wanted.iter().map(at).collect::<Vec<_>>().join(", "));
    }
    if top > 0 {
        let _ = writeln!(
            text,
            "{:>5}{:>10}{:>9}{:>10}  worm / dresser / verdict",
            "rank", "left um", "share %", "K"
        );
    }
    for pair in outcome.pairs.iter().take(top) {
        let plan = pair.plan.as_ref();
        let _ = write!(
            text,
            "{:>5}{:>10}{:>9}{:>10}  ",
            pair.rank,
            fixed(plan.map(|plan| plan.deviation_um), 3),
            fixed(pair.largest_share_of_limit.map(|s| 100.0 * s), 1),
            fixed(plan.map(|plan| plan.diagonal_ratio), 4)
        );
        let verdict = pair.refused.as_ref().map_or("meets it", |refused| refused.code);
        let _ = writeln!(text, "{} / {} / {verdict}", pair.worm, pair.dresser);
    }
}

/// Rows of a ranking by profiles.
fn by_profile(text: &mut String, outcome: &CatalogueOutcome, top: usize) {
    if top > 0 {
        for (heading, width) in COLUMNS {
            let _ = write!(text, "{heading:>width$}");
        }
        text.push_str("worm / dresser / verdict\n");
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
