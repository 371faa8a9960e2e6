//! What is known of measured parts: the list of series, the parts of one, the values of a characteristic over them.

use serde_json::Value;
use sqlx::types::Json;

use super::values::{self, CharacteristicRow};
use crate::error::StoreError;
use crate::pool::on_pool;
use crate::records::{Characteristic, CharacteristicValue, PartRecord, PartSummary, SeriesSummary, SeriesValue};
use crate::store::Store;
use crate::words::{flank_of, flank_word};

impl Store {
    /// All series in the order of their names.
    ///
    /// # Errors
    /// Those of the database.
    pub async fn series(&self) -> Result<Vec<SeriesSummary>, StoreError> {
        let rows: Result<Vec<(String, i64, Option<String>, Option<String>)>, _> = on_pool!(&self.pool, pool => {
            sqlx::query_as("SELECT series, count(*), min(measured), max(measured) FROM part GROUP BY series ORDER BY series")
                .fetch_all(pool)
                .await
        });
        let summary = |(series, parts, first, last): (String, i64, _, _)| SeriesSummary {
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

    /// The parts of a series in the order in which they were measured: by date, those of one date as they were imported, those without
    /// a date last.
    ///
    /// # Errors
    /// Those of the database.
    pub async fn parts(&self, series: &str) -> Result<Vec<PartSummary>, StoreError> {
        type Row = (String, Option<String>, Option<String>, Option<String>, String, String);
        let rows: Result<Vec<Row>, _> = on_pool!(&self.pool, pool => {
            sqlx::query_as(
                "SELECT name, drawing, measured, machine, source, digest FROM part WHERE series = $1 \
                 ORDER BY measured NULLS LAST, id",
            )
            .bind(series)
            .fetch_all(pool)
            .await
        });
        let summary =
            |(part, drawing, date, machine, source, digest)| PartSummary { part, drawing, date, machine, source, digest };
        Ok(self.done(rows)?.into_iter().map(summary).collect())
    }

    /// A part with everything; `None` if there is none with this digest.
    ///
    /// # Errors
    /// Those of the database.
    pub async fn part(&self, digest: &str) -> Result<Option<PartRecord>, StoreError> {
        type Head = (i64, String, String, Option<String>, Option<String>, Option<String>, String, Json<Value>);
        let head: Result<Option<Head>, _> = on_pool!(&self.pool, pool => {
            sqlx::query_as("SELECT id, series, name, drawing, measured, machine, source, document FROM part WHERE digest = $1")
                .bind(digest)
                .fetch_optional(pool)
                .await
        });
        let Some((id, series, part, drawing, date, machine, source, document)) = self.done(head)? else { return Ok(None) };
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
        let value = |(name, flank, tooth, statistic, unit, value, lower_limit, upper_limit): Row| CharacteristicValue {
            name,
            flank: flank.as_deref().map(flank_of),
            tooth: tooth.and_then(|tooth| u32::try_from(tooth).ok()),
            statistic,
            value,
            unit,
            lower_limit,
            upper_limit,
        };
        let characteristics = self.done(rows)?.into_iter().map(value).collect();
        let digest = digest.to_owned();
        let Json(document) = document;
        Ok(Some(PartRecord { series, part, drawing, date, machine, source, digest, document, characteristics }))
    }

    /// What was measured on the parts of a series and on how many of them, in the order in which it became known.
    ///
    /// # Errors
    /// Those of the database.
    pub async fn characteristics(&self, series: &str) -> Result<Vec<(Characteristic, u64)>, StoreError> {
        let rows: Result<Vec<CharacteristicRow>, _> = on_pool!(&self.pool, pool => {
            sqlx::query_as(
                "SELECT c.name, c.flank, c.tooth, c.statistic, c.unit, n.parts FROM characteristic c JOIN \
                 (SELECT v.characteristic, count(*) AS parts FROM part p JOIN measured_value v ON v.part = p.id \
                  WHERE p.series = $1 GROUP BY v.characteristic) n ON n.characteristic = c.id ORDER BY c.id",
            )
            .bind(series)
            .fetch_all(pool)
            .await
        });
        let counted = rows.and_then(|rows| {
            let of_row = |row| values::characteristic(row).map(|(what, parts)| (what, parts.unsigned_abs()));
            rows.into_iter().map(of_row).collect()
        });
        self.done(counted)
    }

    /// The values of one characteristic over the parts of a series, in the order of [`Store::parts`]; parts without it are left out. What
    /// `flankwright::metrology::inspection::evaluate_series` takes.
    ///
    /// # Errors
    /// Those of the database.
    pub async fn values(&self, series: &str, characteristic: &Characteristic) -> Result<Vec<SeriesValue>, StoreError> {
        type Row = (String, String, Option<String>, f64, Option<f64>, Option<f64>);
        let rows: Result<Vec<Row>, _> = on_pool!(&self.pool, pool => {
            sqlx::query_as(
                "SELECT p.digest, p.name, p.measured, v.value, v.lower_limit, v.upper_limit \
                 FROM part p JOIN measured_value v ON v.part = p.id \
                 WHERE p.series = $1 AND v.characteristic = (SELECT id FROM characteristic WHERE name = $2 \
                   AND coalesce(flank, '') = $3 AND coalesce(tooth, -1) = $4 AND statistic = $5 AND unit = $6) \
                 ORDER BY p.measured NULLS LAST, p.id",
            )
            .bind(series)
            .bind(&characteristic.name)
            .bind(characteristic.flank.map_or("", flank_word))
            .bind(characteristic.tooth.map_or(-1, i64::from))
            .bind(&characteristic.statistic)
            .bind(&characteristic.unit)
            .fetch_all(pool)
            .await
        });
        let value = |(digest, part, date, value, lower_limit, upper_limit)| SeriesValue {
            digest,
            part,
            date,
            value,
            lower_limit,
            upper_limit,
        };
        Ok(self.done(rows)?.into_iter().map(value).collect())
    }
}
