//! The stock of a measured blank as files and in words: the table that a job reads as `stock.map`, the document, the summary.

use super::blank::BlankStock;
use erased_serde::Serialize;
use generating_grinding::stock_file::stock_table;
use run::{TaskOutcome, WriteError, json, write_set};
use std::path::{Path, PathBuf};
use verdict::Verdict;

/// The table that a job reads as `stock.map`.
pub const STOCK_TABLE: &str = "stock.csv";
const DOCUMENT: &str = "blank.json";

impl TaskOutcome for BlankStock {
    fn job(&self) -> &str {
        &self.result.job
    }

    /// Stock is neither met nor missed.
    fn verdict(&self) -> Option<&Verdict> {
        None
    }

    fn result(&self) -> &dyn Serialize {
        &self.result
    }

    fn write(&self, directory: &Path) -> Result<Vec<PathBuf>, WriteError> {
        write_blank(self, directory)
    }

    fn summary(&self, written: &[PathBuf], _: usize) -> String {
        summary(self, written)
    }
}

/// Writes the table `stock.csv` and the document `blank.json` into `directory` (made if missing); returns their paths, the table first.
///
/// # Errors
/// [`WriteError`].
pub fn write_blank(found: &BlankStock, directory: &Path) -> Result<Vec<PathBuf>, WriteError> {
    let table = stock_table(&found.flanks)?;
    let document = json(&found.result)?;
    write_set(directory, &[(STOCK_TABLE, table.text().as_bytes()), (DOCUMENT, &document)], &[])
}

/// In words, with the keys that take the table into a job.
fn summary(found: &BlankStock, written: &[PathBuf]) -> String {
    let mut text = String::new();
    for (flank, stock) in found.result.stock_um.iter() {
        let line = match stock {
            Some([least, mean, most]) => format!(
                "{flank} flank: stock {least:.1} to {most:.1} um, mean {mean:.1} um; traces of {} teeth\n",
                found.result.teeth_with_traces[flank]
            ),
            None => format!("{flank} flank: not measured\n"),
        };
        text += &line;
    }
    text += &format!("level from {}", found.result.level_from);
    text += if found.result.with_pitch { ", every tooth by its pitch\n" } else { "\n" };
    for remark in &found.result.remarks {
        text += &format!("warning: {} ({})\n", remark.text, remark.way_out);
    }
    if let Some(table) = written.first() {
        text += "\ninto the job, beside allowance_um as it stands there:\n";
        text += &format!("[stock]\nmap = \"{}\"\n", table.display());
    }
    text
}
