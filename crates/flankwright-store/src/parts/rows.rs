//! The rows of parts: which digests are there, and new ones in, in as few statements as each database needs.

use std::collections::{HashMap, HashSet};

use sqlx::AssertSqlSafe;
use sqlx::types::Json;

use crate::pool::{Pool, Writing, on_writing};
use crate::records::PartRecord;

/// SQLite is in this process; a list of digests goes in as one text all the same.
const KNOWN_SQLITE: &str = "SELECT digest FROM part WHERE digest IN (SELECT value FROM json_each($1))";
const KNOWN_POSTGRES: &str = "SELECT digest FROM part WHERE digest = ANY($1)";

const COLUMNS: &str = "digest, series, name, drawing, measured, machine, source, document, characteristics";

/// Which of the digests are there, seen from outside.
pub(super) async fn known(pool: &Pool, digests: &[&str]) -> Result<HashSet<String>, sqlx::Error> {
    known_where(pool, digests, "TRUE").await
}

/// Which of the digests are those of parts of which a condition holds.
pub(super) async fn known_where(
    pool: &Pool,
    digests: &[&str],
    condition: &str,
) -> Result<HashSet<String>, sqlx::Error> {
    let text = |known: &str| AssertSqlSafe(format!("{known} AND {condition}"));
    let found: Vec<String> = match pool {
        Pool::Sqlite(pool) => {
            sqlx::query_scalar(text(KNOWN_SQLITE)).bind(Json(digests)).fetch_all(pool).await?
        }
        Pool::Postgres(pool) => {
            sqlx::query_scalar(text(KNOWN_POSTGRES)).bind(digests).fetch_all(pool).await?
        }
    };
    Ok(found.into_iter().collect())
}

/// Which of the digests are there, while no other process writes.
pub(super) async fn known_while_writing(
    writing: &mut Writing,
    digests: &[&str],
) -> Result<HashSet<String>, sqlx::Error> {
    let found: Vec<String> = match writing {
        Writing::Sqlite(transaction) => {
            sqlx::query_scalar(KNOWN_SQLITE).bind(Json(digests)).fetch_all(&mut **transaction).await?
        }
        Writing::Postgres(transaction) => {
            sqlx::query_scalar(KNOWN_POSTGRES).bind(digests).fetch_all(&mut **transaction).await?
        }
    };
    Ok(found.into_iter().collect())
}

/// Takes a part with its values out; whether it was there.
pub(super) async fn remove(writing: &mut Writing, digest: &str) -> Result<bool, sqlx::Error> {
    let removed = on_writing!(writing, connection => {
        sqlx::query("DELETE FROM part WHERE digest = $1").bind(digest).execute(connection).await?.rows_affected()
    });
    Ok(removed > 0)
}

/// Inserts parts that are not there; their numbers by digest.
pub(super) async fn insert(
    writing: &mut Writing,
    parts: &[&PartRecord],
) -> Result<HashMap<String, i64>, sqlx::Error> {
    let mut numbers = HashMap::with_capacity(parts.len());
    match writing {
        Writing::Sqlite(transaction) => {
            let text =
                format!("INSERT INTO part ({COLUMNS}) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?) RETURNING id");
            for part in parts {
                let number: i64 = sqlx::query_scalar(AssertSqlSafe(text.clone()))
                    .bind(&part.digest)
                    .bind(&part.series)
                    .bind(&part.part)
                    .bind(&part.drawing)
                    .bind(&part.date)
                    .bind(&part.machine)
                    .bind(&part.source)
                    .bind(Json(&part.document))
                    .bind(part.characteristics.len() as i64)
                    .fetch_one(&mut **transaction)
                    .await?;
                numbers.insert(part.digest.clone(), number);
            }
        }
        Writing::Postgres(transaction) => {
            // One way there and back for all. `WITH ORDINALITY` keeps the order of the list, by which numbers are given.
            let text = format!(
                "INSERT INTO part ({COLUMNS}) SELECT d, s, n, w, m, k, f, j::json, c FROM unnest($1::text[], $2::text[], $3::text[], \
                 $4::text[], $5::text[], $6::text[], $7::text[], $8::text[], $9::bigint[]) \
                 WITH ORDINALITY AS t(d, s, n, w, m, k, f, j, c, place) ORDER BY place RETURNING digest, id"
            );
            let rows: Vec<(String, i64)> = sqlx::query_as(AssertSqlSafe(text))
                .bind(column(parts, |part| part.digest.as_str()))
                .bind(column(parts, |part| part.series.as_str()))
                .bind(column(parts, |part| part.part.as_str()))
                .bind(column(parts, |part| part.drawing.as_deref()))
                .bind(column(parts, |part| part.date.as_deref()))
                .bind(column(parts, |part| part.machine.as_deref()))
                .bind(column(parts, |part| part.source.as_str()))
                .bind(column(parts, |part| part.document.to_string()))
                .bind(column(parts, |part| part.characteristics.len() as i64))
                .fetch_all(&mut **transaction)
                .await?;
            numbers.extend(rows);
        }
    }
    Ok(numbers)
}

fn column<'a, T>(parts: &[&'a PartRecord], of: impl Fn(&'a PartRecord) -> T) -> Vec<T> {
    parts.iter().map(|part| of(part)).collect()
}
