//! Distances of neighbouring points, each beside its limit.

use super::shown_flank::ShownFlank;
use crate::{DenseGrid, DistanceLimits, Lines, NeighbourDistances};
use report::charts::{format_fixed, format_significant};
use report::{Block, Column, Table};

/// A figure of one direction: the end of its key, its words, its distance and its limit, mm.
type Distance =
    (&'static str, &'static str, fn(&NeighbourDistances) -> f64, fn(&DistanceLimits) -> Option<f64>);

/// The figures of a direction.
const DISTANCES: [Distance; 4] = [
    ("max", "greatest", |found| found.greatest, |limit| limit.greatest),
    ("min", "least", |found| found.least, |limit| limit.least),
    ("max_mean", "greatest mean", |found| found.greatest_mean, |limit| limit.greatest_mean),
    ("min_mean", "least mean", |found| found.least_mean, |limit| limit.least_mean),
];

/// The eight figures of every flank.
pub(super) fn blocks(lines: &Lines, flanks: &[ShownFlank<'_>]) -> Vec<Block> {
    if flanks.is_empty() {
        return Vec::new();
    }
    let limits = match lines {
        Lines::Limited { limits, .. } => [limits.row, limits.column],
        Lines::Counted { .. } => [DistanceLimits::default(); 2],
    };
    let mut columns = vec![Column::text("Distance of neighbours"), Column::number("Limit", "mm")];
    for flank in flanks {
        columns.push(Column::number(flank.name(), "mm"));
        columns.push(Column::text("Kept"));
    }
    let mut rows = Vec::new();
    for (k, key) in ["row", "column"].into_iter().enumerate() {
        for (end, words, distance, limit) in DISTANCES {
            let limit = limit(&limits[k]);
            let mut cells = vec![
                format!("along {key}s, {words}"),
                limit.map_or_else(|| "–".into(), |mm| format_significant(mm, 4)),
            ];
            for flank in flanks {
                let dense = &flank.plan.lines.dense;
                let found = [&dense.along_rows, &dense.along_columns][k];
                cells.push(format_fixed(distance(found), 4));
                cells.push(kept(dense, &format!("{key}_{end}"), limit).into());
            }
            rows.push(cells);
        }
    }
    let note = "Along rows: from column to column; along columns: from row to row. A mean is that of one line. Overrun not counted.";
    vec![Block::Table(Table { caption: String::new(), columns, rows, note: note.into() })]
}

/// Whether a limit is kept; nothing where there is none.
fn kept(dense: &DenseGrid, name: &str, limit: Option<f64>) -> &'static str {
    if dense.violated.iter().any(|violated| violated.name == name) {
        return "NO";
    }
    if limit.is_some() { "yes" } else { "" }
}
