//! Puts measured parts into the store, a set whole or not at all.

use std::collections::HashMap;

use super::content;
use super::rows;
use super::values::{self, ValueRow};
use crate::check;
use crate::content::PartContent;
use crate::error::StoreError;
use crate::pool::{Writing, on_writing};
use crate::records::{Characteristic, MeasuredPart, PartRecord};
use crate::reports::ImportReport;
use crate::store::Store;
use crate::words::flank_word;

/// A part on its way into the store.
#[derive(Clone, Copy)]
struct Going<'a> {
    record: &'a PartRecord,
    content: Option<&'a PartContent>,
}

impl Store {
    /// Parts of a set that large keep what is lost by an interruption, and what others wait for, below a second.
    pub const BATCH: usize = 250;

    /// Imports a set of parts: all of them are there when this returns, or none was added. A part whose digest is there already is left as
    /// it is. Many parts are imported in sets of [`Store::BATCH`].
    ///
    /// # Errors
    /// `invalid-record` with the place of the part in the list; those of the database.
    pub async fn import_parts(&self, parts: &[PartRecord]) -> Result<ImportReport, StoreError> {
        self.import_checked(&without_content(parts), false).await
    }

    /// As [`Store::import_parts`], but a part whose digest is there already takes the place of the stored one: the same file after another
    /// evaluation.
    ///
    /// # Errors
    /// As [`Store::import_parts`].
    pub async fn replace_parts(&self, parts: &[PartRecord]) -> Result<ImportReport, StoreError> {
        self.import_checked(&without_content(parts), true).await
    }

    /// As [`Store::import_parts`], or with `replace` as [`Store::replace_parts`], of parts with the files that they were measured by, from
    /// which more can be made later.
    ///
    /// # Errors
    /// As there.
    pub async fn import_measured(
        &self,
        parts: &[MeasuredPart],
        replace: bool,
    ) -> Result<ImportReport, StoreError> {
        let parts: Vec<Going<'_>> = parts
            .iter()
            .map(|MeasuredPart { record, content }| Going { record, content: Some(content) })
            .collect();
        self.import_checked(&parts, replace).await
    }

    async fn import_checked(&self, parts: &[Going<'_>], replace: bool) -> Result<ImportReport, StoreError> {
        for (place, part) in parts.iter().enumerate() {
            check::part(place, part.record)?;
            if let Some(content) = part.content {
                check::content(&format!("parts[{place}].content"), content, &part.record.digest)?;
            }
        }
        self.import_set(parts, replace).await.map_err(|error| self.error(error))
    }

    async fn import_set(&self, parts: &[Going<'_>], replace: bool) -> Result<ImportReport, sqlx::Error> {
        let mut writing = self.pool.write().await?;
        let mut characteristics = Characteristics::load(&mut writing).await?;
        let digests: Vec<&str> = parts.iter().map(|part| part.record.digest.as_str()).collect();
        let mut known = rows::known_while_writing(&mut writing, &digests).await?;
        let (mut report, mut new) = (ImportReport::default(), Vec::new());
        if replace {
            report.replaced = known.len();
            for digest in known.drain() {
                rows::remove(&mut writing, &digest).await?;
            }
        }
        for (place, part) in parts.iter().enumerate() {
            if known.insert(part.record.digest.clone()) {
                new.push(*part);
            } else {
                report.known.push(place);
            }
        }
        report.added = new.len();
        let records: Vec<&PartRecord> = new.iter().map(|part| part.record).collect();
        let numbers = rows::insert(&mut writing, &records).await?;
        let mut values = Vec::new();
        for part in new {
            let number = *numbers.get(&part.record.digest).ok_or(sqlx::Error::RowNotFound)?;
            if let Some(content) = part.content {
                content::insert(&mut writing, number, content).await?;
            }
            for (place, entry) in part.record.characteristics.iter().enumerate() {
                values.push(ValueRow {
                    part: number,
                    characteristic: characteristics.id(&mut writing, entry.characteristic()).await?,
                    place: place as i64,
                    value: entry.value,
                    lower: entry.lower_limit,
                    upper: entry.upper_limit,
                });
            }
        }
        values::insert(&mut writing, &values).await?;
        writing.commit().await?;
        Ok(report)
    }

    /// Takes a part out, e.g. to import it again after another evaluation. `false` if there is none with this digest.
    ///
    /// # Errors
    /// Those of the database.
    pub async fn remove_part(&self, digest: &str) -> Result<bool, StoreError> {
        let removed = async {
            let mut writing = self.pool.write().await?;
            let removed = rows::remove(&mut writing, digest).await?;
            writing.commit().await?;
            Ok(removed)
        };
        removed.await.map_err(|error| self.error(error))
    }
}

fn without_content(parts: &[PartRecord]) -> Vec<Going<'_>> {
    parts.iter().map(|record| Going { record, content: None }).collect()
}

/// Numbers of the characteristics that the store knows.
struct Characteristics(HashMap<Characteristic, i64>);

impl Characteristics {
    async fn load(writing: &mut Writing) -> Result<Self, sqlx::Error> {
        let rows: Vec<values::CharacteristicRow> = on_writing!(writing, connection => {
            sqlx::query_as("SELECT name, flank, tooth, statistic, unit, id FROM characteristic")
                .fetch_all(connection)
                .await?
        });
        rows.into_iter().map(values::characteristic).collect::<Result<_, _>>().map(Self)
    }

    async fn id(&mut self, writing: &mut Writing, wanted: Characteristic) -> Result<i64, sqlx::Error> {
        if let Some(id) = self.0.get(&wanted) {
            return Ok(*id);
        }
        let id: i64 = on_writing!(writing, connection => {
            sqlx::query_scalar(
                "INSERT INTO characteristic (name, flank, tooth, statistic, unit) VALUES ($1, $2, $3, $4, $5) RETURNING id",
            )
            .bind(&wanted.name)
            .bind(wanted.flank.map(flank_word))
            .bind(wanted.tooth.map(i64::from))
            .bind(&wanted.statistic)
            .bind(&wanted.unit)
            .fetch_one(connection)
            .await?
        });
        self.0.insert(wanted, id);
        Ok(id)
    }
}
