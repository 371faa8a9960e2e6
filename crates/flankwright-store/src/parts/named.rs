//! One part by what people call it: its number, or the beginning of its digest; with the measurement that it came from.

use flankwright::exchange::{Diagnostic, Problem};

use crate::content::PartContent;
use crate::error::StoreError;
use crate::filter::PartFilter;
use crate::pool::on_pool;
use crate::records::PartSummary;
use crate::store::Store;

/// Shortest beginning of a digest that names a part.
pub const SHORTEST_DIGEST: usize = 8;
/// Digits of a digest that lists show.
const SHOWN: usize = 12;
/// Parts of one name that a message lists.
const LISTED: usize = 5;

/// A part with what it was measured by.
#[derive(Clone, Debug, PartialEq)]
pub struct StoredMeasurement {
    /// The part.
    pub part: PartSummary,
    /// Its files, and what was stated about them.
    pub content: PartContent,
}

impl Store {
    /// The only part of this number, or of a digest that begins so.
    ///
    /// # Errors
    /// `unknown-value` for none and for several; those of the database.
    pub async fn part_named(&self, name: &str) -> Result<PartSummary, StoreError> {
        let of_number = PartFilter { part: Some(name.to_owned()), ..PartFilter::default() };
        let mut found = self.parts(&of_number).await?;
        for digest in self.digests_beginning(name).await? {
            if found.iter().all(|part| part.digest != digest) {
                found.extend(self.part_of_digest(&digest).await?);
            }
        }
        if found.len() > 1 {
            return Err(several(name, &found).into());
        }
        found.pop().ok_or_else(|| none(name).into())
    }

    /// As [`Store::part_named`], with the measurement that the part came from.
    ///
    /// # Errors
    /// As there; `part-without-measurement` for a part of an earlier import.
    pub async fn measurement(&self, name: &str) -> Result<StoredMeasurement, StoreError> {
        let part = self.part_named(name).await?;
        match self.part_content(&part.digest).await? {
            Some(content) => Ok(StoredMeasurement { part, content }),
            None => Err(without_measurement(&part).into()),
        }
    }

    /// Digests that begin so, where the beginning is long enough to name a part.
    async fn digests_beginning(&self, beginning: &str) -> Result<Vec<String>, StoreError> {
        if !(SHORTEST_DIGEST..=64).contains(&beginning.len()) {
            return Ok(Vec::new());
        }
        let most = LISTED + 1;
        let text = format!(
            "SELECT digest FROM part WHERE substr(digest, 1, {}) = $1 ORDER BY digest LIMIT {most}",
            beginning.chars().count()
        );
        let digests = on_pool!(&self.pool, pool => {
            sqlx::query_scalar(sqlx::AssertSqlSafe(text)).bind(beginning).fetch_all(pool).await
        });
        self.done(digests)
    }
}

fn listed(parts: &[PartSummary]) -> String {
    let one =
        |part: &PartSummary| format!("{} of {}", &part.digest[..SHOWN.min(part.digest.len())], part.series);
    let shown: Vec<String> = parts.iter().take(LISTED).map(one).collect();
    let more = if parts.len() > LISTED { ", and more" } else { "" };
    shown.join(", ") + more
}

fn several(name: &str, parts: &[PartSummary]) -> Diagnostic {
    Diagnostic::new(Problem::UnknownValue, format!("{} parts of the store are called `{name}`", parts.len()))
        .field("part")
        .value(name)
        .allowed(format!("the digest of one of them: {}", listed(parts)))
        .way_out("name the part by the beginning of its digest")
}

fn none(name: &str) -> Diagnostic {
    Diagnostic::new(Problem::UnknownValue, "the store has no such part")
        .field("part")
        .value(name)
        .allowed(format!(
            "the number of a part, or the beginning of its digest, {SHORTEST_DIGEST} digits or more"
        ))
        .way_out("list the parts: `flankwright store parts`")
}

fn without_measurement(part: &PartSummary) -> Diagnostic {
    let PartSummary { part: number, series, source, digest, .. } = part;
    let message = format!(
        "part {number} of {series} was stored by an earlier version, without its measurement: only evaluated values of `{source}` are there"
    );
    Diagnostic::with_code("part-without-measurement", message)
        .field("part")
        .value(&digest[..SHOWN.min(digest.len())])
        .allowed("a part that was imported with its files")
        .way_out(format!(
            "import its file again, `flankwright store import {source}`, or inspect the file itself"
        ))
}
