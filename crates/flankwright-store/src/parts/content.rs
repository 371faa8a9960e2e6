//! The files that parts were measured by: in with the part, or later for a part of an earlier import; out by its digest.

use std::collections::HashSet;

use flankwright::workflow::inspection::{MeasurementFile, Statements};
use serde::Deserialize;
use serde_json::Value;
use sqlx::types::Json;

use super::rows;
use crate::check;
use crate::content::{PackedFile, PartContent};
use crate::error::StoreError;
use crate::pool::{Writing, on_pool, on_writing};
use crate::store::Store;

/// Files of a part that are read at once, by part and place.
const FILES: &str = "SELECT name, digest, size, packed FROM part_file WHERE part = $1 ORDER BY place";

type FileRow = (String, String, i64, Vec<u8>);

fn file((name, digest, size, packed): FileRow) -> PackedFile {
    PackedFile { name, digest, size: size.unsigned_abs(), packed }
}

impl Store {
    /// What a part was measured by; `None` if there is no such part, or if it was stored without its files.
    ///
    /// # Errors
    /// `damaged-store`; those of the database.
    pub async fn part_content(&self, digest: &str) -> Result<Option<PartContent>, StoreError> {
        let head: Result<Option<(i64, Json<Statements>)>, _> = on_pool!(&self.pool, pool => {
            sqlx::query_as("SELECT c.part, c.stated FROM part_content c JOIN part p ON p.id = c.part WHERE p.digest = $1")
                .bind(digest)
                .fetch_optional(pool)
                .await
        });
        let Some((part, Json(statements))) = self.done(head)? else { return Ok(None) };
        let files: Result<Vec<FileRow>, _> =
            on_pool!(&self.pool, pool => sqlx::query_as(FILES).bind(part).fetch_all(pool).await);
        let files: Vec<PackedFile> = self.done(files)?.into_iter().map(file).collect();
        Ok(Some(PartContent::of_packed(files, statements)))
    }

    /// The files of a part as they were.
    ///
    /// # Errors
    /// `damaged-store`.
    pub fn files_of(&self, content: &PartContent) -> Result<Vec<MeasurementFile>, StoreError> {
        content.files().map_err(|cause| StoreError::Damaged {
            address: self.address().to_string(),
            what: "a measurement",
            cause,
        })
    }

    /// Gives a part of an earlier import, which has no files, those that it was measured by. `false` if there is no such part, or if it has
    /// its files.
    ///
    /// # Errors
    /// Those of the database.
    pub async fn complete_part(&self, content: &PartContent) -> Result<bool, StoreError> {
        check::content("content", content, &content.digest())?;
        let completed = async {
            let mut writing = self.pool.write().await?;
            let part: Option<i64> = on_writing!(&mut writing, connection => {
                sqlx::query_scalar("SELECT id FROM part WHERE digest = $1 AND id NOT IN (SELECT part FROM part_content)")
                    .bind(content.digest())
                    .fetch_optional(connection)
                    .await?
            });
            let Some(part) = part else { return Ok(false) };
            insert(&mut writing, part, content).await?;
            writing.commit().await?;
            Ok(true)
        };
        self.done(completed.await)
    }

    /// Which of the digests are those of parts that were stored without their files.
    ///
    /// # Errors
    /// Those of the database.
    pub async fn parts_without_content(&self, digests: &[&str]) -> Result<HashSet<String>, StoreError> {
        let without = "id NOT IN (SELECT part FROM part_content)";
        self.done(rows::known_where(&self.pool, digests, without).await)
    }

    /// What the files of all parts take, packed, in bytes.
    pub(crate) async fn content_bytes(&self) -> Result<u64, StoreError> {
        let text = "SELECT CAST(coalesce(sum(length(packed)), 0) AS BIGINT) FROM part_file";
        let bytes: Result<i64, _> =
            on_pool!(&self.pool, pool => sqlx::query_scalar(text).fetch_one(pool).await);
        Ok(self.done(bytes)?.unsigned_abs())
    }

    /// Parts with files, and what is wrong with those: too few of them, bytes that are not those of their digest.
    pub(crate) async fn content_faults(&self, most: usize) -> Result<(u64, Vec<String>), StoreError> {
        type Row = (i64, String, String, i64, Json<Value>);
        let parts: Result<Vec<Row>, _> = on_pool!(&self.pool, pool => {
            sqlx::query_as("SELECT c.part, p.name, p.digest, c.files, c.stated FROM part_content c JOIN part p ON p.id = c.part ORDER BY c.part")
                .fetch_all(pool)
                .await
        });
        let parts = self.done(parts)?;
        let mut faults = Vec::new();
        // One part after the other: all files of a store need not fit into the memory.
        for (part, name, digest, count, Json(stated)) in &parts {
            let files: Result<Vec<FileRow>, _> =
                on_pool!(&self.pool, pool => sqlx::query_as(FILES).bind(part).fetch_all(pool).await);
            let files: Vec<PackedFile> = self.done(files)?.into_iter().map(file).collect();
            let complete = files.len() as i64 == *count;
            let content = PartContent::of_packed(files, Statements::default());
            let fault = match content.files() {
                _ if Statements::deserialize(stated).is_err() => {
                    Some(format!("what was stated about the measurement of part {name} cannot be read"))
                }
                Err(cause) => Some(format!("the measurement of part {name} cannot be read: {cause}")),
                Ok(_) if !complete => Some(format!("part {name} has not all files of its measurement")),
                Ok(_) if content.digest() != *digest => {
                    Some(format!("the measurement of part {name} is that of another part"))
                }
                Ok(_) => None,
            };
            faults.extend(fault);
            if faults.len() >= most {
                break;
            }
        }
        Ok((parts.len() as u64, faults))
    }
}

/// Puts the files of a part in.
pub(super) async fn insert(
    writing: &mut Writing,
    part: i64,
    content: &PartContent,
) -> Result<(), sqlx::Error> {
    let files = content.packed();
    on_writing!(&mut *writing, connection => {
        sqlx::query("INSERT INTO part_content (part, files, stated) VALUES ($1, $2, $3)")
            .bind(part)
            .bind(files.len() as i64)
            .bind(Json(content.statements()))
            .execute(connection)
            .await?
            .rows_affected()
    });
    for (place, file) in files.iter().enumerate() {
        on_writing!(&mut *writing, connection => {
            sqlx::query("INSERT INTO part_file (part, place, name, digest, size, packed) VALUES ($1, $2, $3, $4, $5, $6)")
                .bind(part)
                .bind(place as i64)
                .bind(&file.name)
                .bind(&file.digest)
                .bind(file.size as i64)
                .bind(&file.packed)
                .execute(connection)
                .await?
                .rows_affected()
        });
    }
    Ok(())
}
