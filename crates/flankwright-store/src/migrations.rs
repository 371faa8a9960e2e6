//! The tables and their versions. They only go forward; a migration that was ever released is never changed.

use std::borrow::Cow;

use sqlx::migrate::{MigrateError, Migration, MigrationType, Migrator};
use sqlx::{SqlSafeStr, SqlStr, SqliteConnection};

use crate::pool::{Pool, SCHEMA, Writing, on_writing};

/// Description and text of each version, from 1; for SQLite and for PostgreSQL.
const VERSIONS: [(&str, &str, &str); 3] = [
    (
        "first",
        include_str!("../migrations/sqlite/0001_first.sql"),
        include_str!("../migrations/postgres/0001_first.sql"),
    ),
    (
        "runs",
        include_str!("../migrations/sqlite/0002_runs.sql"),
        include_str!("../migrations/postgres/0002_runs.sql"),
    ),
    (
        "measurements",
        include_str!("../migrations/sqlite/0003_measurements.sql"),
        include_str!("../migrations/postgres/0003_measurements.sql"),
    ),
];

/// The number that marks a file of SQLite as a store, in its header: the letters `fwst`.
const APPLICATION: i32 = i32::from_be_bytes(*b"fwst");

/// How a file of SQLite shows that it is no store.
pub(crate) const FOREIGN_FILE: &str = "the file is the database of another program";

/// What is in a file of SQLite.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Holds {
    /// No table.
    Nothing,
    /// A store.
    Store,
    /// Tables of another program.
    OtherThings,
}

/// What is in a file of SQLite; changes nothing.
pub(crate) async fn holds(connection: &mut SqliteConnection) -> Result<Holds, sqlx::Error> {
    // Tables first: who makes a store at this moment writes mark and tables at once, so that tables are never seen without their mark.
    let tables: i64 =
        sqlx::query_scalar("SELECT count(*) FROM sqlite_master").fetch_one(&mut *connection).await?;
    let mark: i32 = sqlx::query_scalar("PRAGMA application_id").fetch_one(connection).await?;
    Ok(match (mark, tables) {
        (0, 0) => Holds::Nothing,
        (APPLICATION, _) => Holds::Store,
        _ => Holds::OtherThings,
    })
}

/// Why there is no store with the tables of this program.
pub(crate) enum Unfit {
    /// The database failed.
    Database(sqlx::Error),
    /// Something else is there.
    Foreign(String),
    /// A newer version.
    Newer { found: i64, known: i64 },
}

impl From<sqlx::Error> for Unfit {
    fn from(error: sqlx::Error) -> Self {
        Self::Database(error)
    }
}

impl From<MigrateError> for Unfit {
    fn from(error: MigrateError) -> Self {
        match error {
            MigrateError::Execute(error) | MigrateError::ExecuteMigration(error, _) => Self::Database(error),
            other => Self::Foreign(other.to_string()),
        }
    }
}

/// The version of the tables that this program knows.
pub(crate) fn known() -> i64 {
    VERSIONS.len() as i64
}

/// Brings the tables of a database to the version of this program, in one transaction.
pub(crate) async fn bring_up(pool: &Pool) -> Result<(), Unfit> {
    let known = known();
    if version(pool).await? == Some(known) {
        return Ok(());
    }
    let mut writing = pool.write().await?;
    // Another program may have been faster.
    let found = prepared(&mut writing).await?;
    if found > known {
        return Err(Unfit::Newer { found, known });
    }
    let migrator = migrator(pool);
    // The transaction keeps others out.
    on_writing!(&mut writing, connection => migrator.run_direct(None, connection, false).await)?;
    writing.commit().await?;
    Ok(())
}

/// The version of the tables that are there, without taking anybody's turn; `None` where it has to be looked at closer.
pub(crate) async fn version(pool: &Pool) -> Result<Option<i64>, Unfit> {
    let there: bool = match pool {
        Pool::Sqlite(pool) => {
            sqlx::query_scalar("SELECT count(*) > 0 FROM sqlite_master WHERE name = '_sqlx_migrations'")
                .fetch_one(pool)
                .await?
        }
        Pool::Postgres(pool) => {
            sqlx::query_scalar("SELECT to_regclass($1) IS NOT NULL")
                .bind(format!("{SCHEMA}._sqlx_migrations"))
                .fetch_one(pool)
                .await?
        }
    };
    if !there {
        return Ok(None);
    }
    match pool {
        Pool::Sqlite(pool) => Ok(sqlx::query_scalar(HIGHEST).fetch_one(pool).await?),
        Pool::Postgres(pool) => Ok(sqlx::query_scalar(HIGHEST).fetch_one(pool).await?),
    }
}

const HIGHEST: &str = "SELECT max(version) FROM _sqlx_migrations WHERE success";

/// Makes sure that tables may be made here; the version of those that are there, 0 for none.
async fn prepared(writing: &mut Writing) -> Result<i64, Unfit> {
    match writing {
        Writing::Sqlite(transaction) => {
            let connection = &mut **transaction;
            match holds(connection).await? {
                Holds::Nothing => {
                    let mark = format!("PRAGMA application_id = {APPLICATION}");
                    sqlx::query(sqlx::AssertSqlSafe(mark)).execute(connection).await?;
                    Ok(0)
                }
                Holds::Store => Ok(sqlx::query_scalar::<_, Option<i64>>(HIGHEST)
                    .fetch_one(connection)
                    .await?
                    .unwrap_or(0)),
                Holds::OtherThings => Err(Unfit::Foreign(FOREIGN_FILE.to_owned())),
            }
        }
        Writing::Postgres(transaction) => {
            let connection = &mut **transaction;
            let made: bool = sqlx::query_scalar("SELECT to_regnamespace($1) IS NOT NULL")
                .bind(SCHEMA)
                .fetch_one(&mut *connection)
                .await?;
            if !made {
                let make = format!("CREATE SCHEMA {SCHEMA}");
                sqlx::query(sqlx::AssertSqlSafe(make)).execute(&mut *connection).await?;
            }
            let tables: bool = sqlx::query_scalar("SELECT to_regclass($1) IS NOT NULL")
                .bind(format!("{SCHEMA}._sqlx_migrations"))
                .fetch_one(&mut *connection)
                .await?;
            if !tables {
                return Ok(0);
            }
            Ok(sqlx::query_scalar::<_, Option<i64>>(HIGHEST).fetch_one(connection).await?.unwrap_or(0))
        }
    }
}

fn migrator(pool: &Pool) -> Migrator {
    let text = |(_, sqlite, postgres): &(&str, &'static str, &'static str)| match pool {
        Pool::Sqlite(_) => *sqlite,
        Pool::Postgres(_) => *postgres,
    };
    let migrations = VERSIONS.iter().enumerate().map(|(i, entry)| {
        let sql: SqlStr = text(entry).into_sql_str();
        Migration::new(i as i64 + 1, Cow::Borrowed(entry.0), MigrationType::Simple, sql, false)
    });
    let mut migrator = Migrator::with_migrations(migrations.collect());
    migrator.set_locking(false);
    migrator
}
