//! What a terminal shows of a study, and how it ended.

use super::files::write_exploration;
use super::{TangentialCandidate, TangentialExploration};
use erased_serde::Serialize;
use run::{Conclusion, TaskOutcome, WriteError};
use std::fmt::Write;
use std::path::{Path, PathBuf};
use verdict::Verdict;

impl TaskOutcome for TangentialExploration {
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
        match self.candidates.first() {
            Some(best) if best.met => Conclusion::Done,
            Some(best) if best.refused.is_none() => Conclusion::Missed,
            _ => Conclusion::NotProducible,
        }
    }

    fn complaint(&self) -> Option<String> {
        let refused = self.candidates.first().and_then(|c| c.refused.as_ref())?;
        Some(format!("{}: no combination can be made: {}; {}", self.job, refused.text, refused.way_out))
    }
}

/// Columns of the printed table: heading and width.
const COLUMNS: [(&str, usize); 8] = [
    ("rank", 5),
    ("threads", 8),
    ("worm mm", 10),
    ("dresser mm", 11),
    ("ratio", 10),
    ("deviation um", 13),
    ("variables", 10),
    ("used mm", 9),
];

fn summary(outcome: &TangentialExploration, top: usize, written: &[PathBuf]) -> String {
    let mut text = String::new();
    // Writing to a text cannot fail.
    let _ = writeln!(
        text,
        "{}: {} of {} combinations are within the tolerance of {} um",
        outcome.job,
        outcome.met,
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
    if let Some(page) = written.last() {
        let _ = writeln!(text, "  report: {}", page.display());
    }
    text
}

fn row(text: &mut String, c: &TangentialCandidate) {
    let fixed = |x: Option<f64>, decimals: usize| x.map_or_else(|| "-".into(), |x| format!("{x:.decimals$}"));
    let cells = [
        c.rank.to_string(),
        c.worm_threads.to_string(),
        fixed(c.worm_tip_diameter_mm, 3),
        fixed(Some(c.dresser_tip_diameter_mm), 3),
        fixed(c.shift_ratio, 4),
        fixed(c.max_deviation_um, 4),
        c.variables.map_or_else(|| "-".into(), |n| n.to_string()),
        fixed(c.worm_length_mm, 2),
    ];
    for (cell, (_, width)) in cells.iter().zip(COLUMNS) {
        let _ = write!(text, "{cell:>width$}");
    }
    let _ = writeln!(text, "  {}", c.verdict());
}
