//! What is known of measured parts: the list of series, parts by filter, one part with everything.

use std::collections::HashSet;

use serde_json::Value;
use sqlx::AssertSqlSafe;
use sqlx::types::Json;

use super::rows;
use crate::error::StoreError;
use crate::filter::{Condition, PartFilter};
use crate::pool::on_pool;
use crate::records::{CharacteristicValue, PartRecord, PartSummary, SeriesSummary};
use crate::store::Store;
use crate::words::flank_of;

const SUMMARY: &str = "SELECT p.series, p.name, p.drawing, p.measured, p.machine, p.source, p.digest, \
    EXISTS (SELECT 1 FROM part_content c WHERE c.part = p.id) FROM part p";

type SummaryRow = (String, String, Option<String>, Option<String>, Option<String>, String, String, bool);

fn summary(row: SummaryRow) -> PartSummary {
    let (series, part, drawing, date, machine, source, digest, has_files) = row;
    PartSummary { series, part, drawing, date, machine, source, digest, has_files }
}

impl Store {
    /// All series in the order of their names.
    ///
    /// # Errors
    /// Those of the database.
    pub async fn series(&self) -> Result<Vec<SeriesSummary>, StoreError> {
        type Row = (String, i64, Option<String>, Option<String>);
        let rows: Result<Vec<Row>, _> = on_pool!(&self.pool, pool => {
            sqlx::query_as("SELECT series, count(*), min(measured), max(measured) FROM part GROUP BY series ORDER BY series")
                .fetch_all(pool)
                .await
        });
        let summary = |(series, parts, first, last): Row| SeriesSummary {
            series,
            parts: parts.unsigned_abs(),
            first,
            last,
        };
        let mut series: Vec<SeriesSummary> = self.done(rows)?.into_iter().map(summary).collect();
        // Databases sort texts by rules of their own.
        series.sort_by(|a, b| a.series.cmp(&b.series));
        Ok(series)
    }

    /// Parts in the order in which they were measured: by date, those of one date as they were imported, those without a date last.
    ///
    /// # Errors
    /// `invalid-filter`; those of the database.
    pub async fn parts(&self, filter: &PartFilter) -> Result<Vec<PartSummary>, StoreError> {
        let condition = Condition::of_parts(filter)?;
        let text = format!("{SUMMARY}{} ORDER BY p.measured NULLS LAST, p.id", condition.text);
        let rows: Result<Vec<SummaryRow>, _> = on_pool!(&self.pool, pool => {
            let query = sqlx::query_as(AssertSqlSafe(text));
            condition.values.iter().fold(query, |query, value| query.bind(value)).fetch_all(pool).await
        });
        Ok(self.done(rows)?.into_iter().map(summary).collect())
    }

    /// What lists show of a part; `None` if there is none with this digest.
    pub(super) async fn part_of_digest(&self, digest: &str) -> Result<Option<PartSummary>, StoreError> {
        let text = format!("{SUMMARY} WHERE p.digest = $1");
        let row: Result<Option<SummaryRow>, _> = on_pool!(&self.pool, pool => {
            sqlx::query_as(AssertSqlSafe(text)).bind(digest).fetch_optional(pool).await
        });
        Ok(self.done(row)?.map(summary))
    }

    /// A part with everything; `None` if there is none with this digest.
    ///
    /// # Errors
    /// Those of the database.
    pub async fn part(&self, digest: &str) -> Result<Option<PartRecord>, StoreError> {
        type Head =
            (i64, String, String, Option<String>, Option<String>, Option<String>, String, Json<Value>);
        let head: Result<Option<Head>, _> = on_pool!(&self.pool, pool => {
            sqlx::query_as("SELECT id, series, name, drawing, measured, machine, source, document FROM part WHERE digest = $1")
                .bind(digest)
                .fetch_optional(pool)
                .await
        });
        let Some((id, series, part, drawing, date, machine, source, document)) = self.done(head)? else {
            return Ok(None);
        };
        type Row = (String, Option<String>, Option<i64>, String, String, f64, Option<f64>, Option<f64>);
        let rows: Result<Vec<Row>, _> = on_pool!(&self.pool, pool => {
            sqlx::query_as(
                "SELECT c.name, c.flank, c.tooth, c.statistic, c.unit, v.value, v.lower_limit, v.upper_limit \
                 FROM measured_value v JOIN characteristic c ON c.id = v.characteristic WHERE v.part = $1 ORDER BY v.place",
            )
            .bind(id)
            .fetch_all(pool)
            .await
        });
        let value = |(name, flank, tooth, statistic, unit, value, lower_limit, upper_limit): Row| {
            CharacteristicValue {
                name,
                flank: flank.as_deref().map(flank_of),
                tooth: tooth.and_then(|tooth| u32::try_from(tooth).ok()),
                statistic,
                value,
                unit,
                lower_limit,
                upper_limit,
            }
        };
        let characteristics = self.done(rows)?.into_iter().map(value).collect();
        let digest = digest.to_owned();
        let Json(document) = document;
        Ok(Some(PartRecord {
            series,
            part,
            drawing,
            date,
            machine,
            source,
            digest,
            document,
            characteristics,
        }))
    }

    /// Which of the digests are those of parts that are there.
    ///
    /// # Errors
    /// Those of the database.
    pub async fn known_parts(&self, digests: &[&str]) -> Result<HashSet<String>, StoreError> {
        self.done(rows::known(&self.pool, digests).await)
    }
}
