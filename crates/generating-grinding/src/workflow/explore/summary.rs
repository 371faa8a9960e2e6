//! What a terminal shows of an exploration, and how it ended.

use super::{ExploreCandidate, ExploreOutcome, write_exploration};
use erased_serde::Serialize;
use run::{Conclusion, TaskOutcome, WriteError};
use std::fmt::Write;
use std::path::{Path, PathBuf};
use verdict::Verdict;

impl TaskOutcome for ExploreOutcome {
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
        write_exploration(self, directory)
    }

    fn summary(&self, written: &[PathBuf], rows: usize) -> String {
        summary(self, rows, written)
    }

    fn conclusion(&self) -> Conclusion {
        match (self.best(), self.is_producible()) {
            (Some(_), _) => Conclusion::Done,
            (None, true) => Conclusion::Missed,
            (None, false) => Conclusion::NotProducible,
        }
    }

    fn complaint(&self) -> Option<String> {
        let refused =
            self.candidates.first().and_then(|c| c.refused.as_ref()).filter(|_| self.best().is_none())?;
        Some(format!("{}: no combination is allowed: {}; {}", self.job, refused.text, refused.way_out))
    }
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
