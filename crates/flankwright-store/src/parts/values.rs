//! The rows of measured values: many at once, in the way that is fastest for each database.

use std::fmt::Write;

use sqlx::AssertSqlSafe;

use crate::pool::Writing;
use crate::records::Characteristic;
use crate::words::flank_of;

/// A row of `measured_value`.
#[derive(Clone, Copy, Debug)]
pub(super) struct ValueRow {
    pub part: i64,
    pub characteristic: i64,
    pub place: i64,
    pub value: f64,
    pub lower: Option<f64>,
    pub upper: Option<f64>,
}

/// A row of `characteristic`: name, flank, tooth, statistic, unit, and one number beside them.
pub(super) type CharacteristicRow = (String, Option<String>, Option<i64>, String, String, i64);

/// A characteristic and the number beside it.
pub(super) fn characteristic(row: CharacteristicRow) -> Result<(Characteristic, i64), sqlx::Error> {
    let (name, flank, tooth, statistic, unit, number) = row;
    let tooth = tooth.map(u32::try_from).transpose().map_err(|error| sqlx::Error::Decode(error.into()))?;
    Ok((Characteristic { name, flank: flank.as_deref().map(flank_of), tooth, statistic, unit }, number))
}

const INSERT: &str =
    "INSERT INTO measured_value (part, characteristic, place, value, lower_limit, upper_limit) ";

/// Rows of one statement of SQLite: six parameters each, of 32 766 that a statement may have. More make it no faster.
const SQLITE_ROWS: usize = 400;

/// Rows of one statement of PostgreSQL: some hundred kilobytes on the way at a time.
const POSTGRES_ROWS: usize = 10_000;

/// Inserts rows.
pub(super) async fn insert(writing: &mut Writing, rows: &[ValueRow]) -> Result<(), sqlx::Error> {
    match writing {
        Writing::Sqlite(transaction) => {
            let full = with_places(SQLITE_ROWS);
            for rows in rows.chunks(SQLITE_ROWS) {
                let is_full = rows.len() == SQLITE_ROWS;
                let text = if is_full { full.clone() } else { with_places(rows.len()) };
                let mut query = sqlx::query(AssertSqlSafe(text)).persistent(is_full);
                for row in rows {
                    query = query.bind(row.part).bind(row.characteristic).bind(row.place);
                    query = query.bind(row.value).bind(row.lower).bind(row.upper);
                }
                query.execute(&mut **transaction).await?;
            }
        }
        Writing::Postgres(transaction) => {
            let text = format!(
                "{INSERT} SELECT * FROM unnest($1::bigint[], $2::bigint[], $3::bigint[], $4::float8[], $5::float8[], $6::float8[])"
            );
            for rows in rows.chunks(POSTGRES_ROWS) {
                sqlx::query(AssertSqlSafe(text.clone()))
                    .bind(column(rows, |row| row.part))
                    .bind(column(rows, |row| row.characteristic))
                    .bind(column(rows, |row| row.place))
                    .bind(column(rows, |row| row.value))
                    .bind(column(rows, |row| row.lower))
                    .bind(column(rows, |row| row.upper))
                    .execute(&mut **transaction)
                    .await?;
            }
        }
    }
    Ok(())
}

fn column<T>(rows: &[ValueRow], of: impl Fn(&ValueRow) -> T) -> Vec<T> {
    rows.iter().map(of).collect()
}

/// The statement for a number of rows.
fn with_places(rows: usize) -> String {
    let mut text = format!("{INSERT} VALUES ");
    for i in 0..rows {
        // Writing to a text cannot fail.
        let _ = write!(text, "{}(?, ?, ?, ?, ?, ?)", if i == 0 { "" } else { ", " });
    }
    text
}
