//! One store over two kinds of databases: connections, and the transaction in which alone anything is written. A statement is
//! written once; `on_pool!` and `on_writing!` run it on whichever database is there.

use std::path::Path;
use std::time::Duration;

use sqlx::pool::PoolOptions;
use sqlx::postgres::PgConnectOptions;
use sqlx::sqlite::{SqliteConnectOptions, SqliteJournalMode, SqliteSynchronous};
use sqlx::{ConnectOptions, PgPool, Postgres, Sqlite, SqlitePool, Transaction};

use crate::address::Place;

/// How long a writer waits for others. An import of a batch takes well below a second.
pub(crate) const PATIENCE: Duration = Duration::from_secs(60);

/// How long a server may take to answer when a store is opened.
pub(crate) const CONNECT_PATIENCE: Duration = Duration::from_secs(5);

/// Connections at a time: few stations and a server that reads beside them.
const CONNECTIONS: u32 = 8;

/// The schema of PostgreSQL that holds the tables, so that a store may share a database with others.
pub(crate) const SCHEMA: &str = "flankwright";

/// What writers of PostgreSQL hold while they write, as SQLite has one writer at a time: the letters `flankwrt`.
const WRITERS: i64 = i64::from_be_bytes(*b"flankwrt");

/// Connections to one database.
#[derive(Clone, Debug)]
pub(crate) enum Pool {
    /// SQLite.
    Sqlite(SqlitePool),
    /// PostgreSQL.
    Postgres(PgPool),
}

/// A transaction that writes; dropped before [`Writing::commit`], it leaves nothing.
pub(crate) enum Writing {
    /// SQLite.
    Sqlite(Transaction<'static, Sqlite>),
    /// PostgreSQL.
    Postgres(Transaction<'static, Postgres>),
}

/// Runs an expression with the pool of either kind.
macro_rules! on_pool {
    ($pool:expr, $connections:ident => $run:expr) => {
        match $pool {
            $crate::pool::Pool::Sqlite($connections) => $run,
            $crate::pool::Pool::Postgres($connections) => $run,
        }
    };
}

/// Runs an expression with the connection of a transaction of either kind.
macro_rules! on_writing {
    ($writing:expr, $connection:ident => $run:expr) => {
        match $writing {
            $crate::pool::Writing::Sqlite(transaction) => {
                let $connection = &mut **transaction;
                $run
            }
            $crate::pool::Writing::Postgres(transaction) => {
                let $connection = &mut **transaction;
                $run
            }
        }
    };
}

pub(crate) use {on_pool, on_writing};

impl Pool {
    /// Connections that are made when they are needed.
    pub fn lazy(place: &Place, create: bool) -> Self {
        match place {
            Place::Sqlite(path) => Self::Sqlite(settings().connect_lazy_with(sqlite_options(path, create))),
            Place::Postgres { options, .. } => {
                let options = PgConnectOptions::clone(options)
                    .application_name("flankwright")
                    .options([("search_path", SCHEMA)])
                    .disable_statement_logging();
                Self::Postgres(settings().connect_lazy_with(options))
            }
        }
    }

    /// Connections to a file that is only read and not changed.
    pub fn read_only(path: &Path) -> Self {
        let options = SqliteConnectOptions::new()
            .filename(path)
            .read_only(true)
            .immutable(true)
            .disable_statement_logging();
        Self::Sqlite(settings().connect_lazy_with(options))
    }

    /// Begins to write, as soon as no other process does.
    pub async fn write(&self) -> Result<Writing, sqlx::Error> {
        match self {
            // A transaction that begins by reading would fail, not wait, where another one writes in between.
            Self::Sqlite(pool) => pool.begin_with("BEGIN IMMEDIATE").await.map(Writing::Sqlite),
            Self::Postgres(pool) => {
                let mut transaction = pool.begin().await?;
                let patience = format!("SET LOCAL lock_timeout = {}", PATIENCE.as_millis());
                sqlx::query(sqlx::AssertSqlSafe(patience)).execute(&mut *transaction).await?;
                sqlx::query("SELECT pg_advisory_xact_lock($1)")
                    .bind(WRITERS)
                    .execute(&mut *transaction)
                    .await?;
                Ok(Writing::Postgres(transaction))
            }
        }
    }

    /// Ends all connections; SQLite puts its log into the file.
    pub async fn close(&self) {
        on_pool!(self, pool => pool.close().await);
    }
}

/// How a file of SQLite is opened.
pub(crate) fn sqlite_options(path: &Path, create: bool) -> SqliteConnectOptions {
    SqliteConnectOptions::new()
        .filename(path)
        .create_if_missing(create)
        .journal_mode(SqliteJournalMode::Wal)
        // A commit is on the disk when it is told: with less, the write-ahead log may lose the last ones when the power fails.
        .synchronous(SqliteSynchronous::Full)
        .foreign_keys(true)
        .busy_timeout(PATIENCE)
        .disable_statement_logging()
}

fn settings<D: sqlx::Database>() -> PoolOptions<D> {
    PoolOptions::new().max_connections(CONNECTIONS).acquire_timeout(PATIENCE)
}

impl Writing {
    /// Makes everything that was written last; until then none of it is visible.
    pub async fn commit(self) -> Result<(), sqlx::Error> {
        match self {
            Self::Sqlite(transaction) => transaction.commit().await,
            Self::Postgres(transaction) => transaction.commit().await,
        }
    }
}
