//! Opening and closing a store.

use std::io::{self, ErrorKind};
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use sqlx::sqlite::SqliteConnectOptions;
use sqlx::{ConnectOptions, Connection};

use crate::address::{Place, StoreAddress};
use crate::error::StoreError;
use crate::migrations::{self, FOREIGN_FILE, Holds, Unfit};
use crate::pool::{CONNECT_PATIENCE, PATIENCE, Pool, sqlite_options};

/// A store that is open. Cheap to clone; clones share their connections.
#[derive(Clone, Debug)]
pub struct Store {
    pub(crate) pool: Pool,
    address: StoreAddress,
}

impl Store {
    /// Opens a store, and makes it where there is none: the file with its directories, or the tables on the server, whose database
    /// has to be there.
    ///
    /// # Errors
    /// `unreachable-store`, `not-a-store`, `newer-store`, `busy-store`, `store-failed`.
    pub async fn open(address: &StoreAddress) -> Result<Self, StoreError> {
        if let Place::Sqlite(path) = &address.0
            && let Some(directory) = path.parent().filter(|parent| !parent.as_os_str().is_empty())
        {
            std::fs::create_dir_all(directory).map_err(|error| StoreError::CannotOpen {
                address: address.to_string(),
                cause: format!("its directory cannot be made: {error}"),
            })?;
        }
        Self::connect(address, true).await
    }

    /// Opens a store that is there; a file that is not there is not made. Where nothing may be written, it can still be read.
    ///
    /// # Errors
    /// As [`Store::open`]; `missing-store`.
    pub async fn open_existing(address: &StoreAddress) -> Result<Self, StoreError> {
        if let Place::Sqlite(path) = &address.0
            && let Err(error) = std::fs::metadata(path)
            && error.kind() == ErrorKind::NotFound
        {
            return Err(StoreError::Missing { address: address.to_string() });
        }
        match Self::connect(address, false).await {
            Err(StoreError::CannotOpen { cause, .. }) if address.path().is_some_and(is_file) => {
                Self::connect_read_only(address, cause).await
            }
            other => other,
        }
    }

    /// Opens a file that cannot be written, or whose folder cannot; `cause` is why it could not be opened otherwise.
    async fn connect_read_only(address: &StoreAddress, cause: String) -> Result<Self, StoreError> {
        let refused = |cause: String| StoreError::CannotOpen { address: address.to_string(), cause };
        let Some(path) = address.path() else { return Err(refused(cause)) };
        // What stands in the log only would be missing.
        if std::fs::metadata(beside(path, "-wal")).is_ok_and(|log| log.len() > 0) {
            return Err(refused(format!(
                "{cause}; it cannot be read either, because a program left a log beside it"
            )));
        }
        let store = Self { pool: Pool::read_only(path), address: address.clone() };
        match migrations::version(&store.pool).await {
            Ok(Some(version)) if version == migrations::known() => Ok(store),
            Ok(_) => {
                Err(refused(format!("{cause}; its tables are of another version and cannot be brought up")))
            }
            Err(_) => Err(refused(cause)),
        }
    }

    async fn connect(address: &StoreAddress, create: bool) -> Result<Self, StoreError> {
        let store = Self { pool: Pool::lazy(&address.0, create), address: address.clone() };
        let brought_up = match reach(&address.0, create).await {
            Ok(()) => migrations::bring_up(&store.pool).await,
            Err(unfit) => Err(unfit),
        };
        let Err(unfit) = brought_up else { return Ok(store) };
        store.pool.close().await;
        Err(store.unfit(unfit))
    }

    /// Why there are no tables that can be used.
    pub(crate) fn unfit(&self, unfit: Unfit) -> StoreError {
        let address = self.address.to_string();
        match unfit {
            Unfit::Database(error) => match self.error(error) {
                StoreError::Failed { address, cause } => StoreError::CannotOpen { address, cause },
                other => other,
            },
            Unfit::Foreign(cause) => StoreError::NotAStore { address, cause },
            Unfit::Newer { found, known } => StoreError::NewerStore { address, found, known },
        }
    }

    /// Where it is.
    pub fn address(&self) -> &StoreAddress {
        &self.address
    }

    /// Ends all connections. A store that is dropped without it has lost nothing either, but a file of SQLite keeps its log beside it.
    pub async fn close(&self) {
        self.pool.close().await;
    }

    /// What a statement gave, its error with the name of the store.
    pub(crate) fn done<T>(&self, result: Result<T, sqlx::Error>) -> Result<T, StoreError> {
        result.map_err(|error| self.error(error))
    }

    /// What an error of the database means.
    pub(crate) fn error(&self, error: sqlx::Error) -> StoreError {
        let address = self.address.to_string();
        let cause = match &error {
            sqlx::Error::Database(error) => error.message().to_owned(),
            other => other.to_string(),
        };
        let code = error.as_database_error().and_then(|error| error.code());
        // SQLite gives extended codes, whose last byte is the kind; PostgreSQL gives five characters.
        let kind = code.as_deref().and_then(|code| match self.pool {
            Pool::Sqlite(_) => code.parse::<u32>().ok().map(|code| code & 0xff),
            Pool::Postgres(_) => None,
        });
        match (kind, code.as_deref(), &error) {
            (Some(5 | 6), ..) | (None, Some("55P03" | "40P01" | "57014"), _) => {
                StoreError::Busy { address, cause }
            }
            (_, _, sqlx::Error::PoolTimedOut) => StoreError::Busy { address, cause },
            (Some(26), ..) => StoreError::NotAStore { address, cause },
            (Some(11), ..) => StoreError::Damaged { address, what: "pages", cause },
            (Some(14), ..) => StoreError::CannotOpen { address, cause },
            (_, _, sqlx::Error::ColumnDecode { .. } | sqlx::Error::Decode(_)) => {
                StoreError::Damaged { address, what: "a record", cause }
            }
            _ => StoreError::Failed { address, cause },
        }
    }
}

/// Connects once, because a pool tries again and again where no server answers, while opening a store must fail at once. A file of
/// another program is left as it is.
async fn reach(place: &Place, create: bool) -> Result<(), Unfit> {
    match place {
        Place::Sqlite(path) => {
            if path.is_dir() {
                return Err(Unfit::Database(io::Error::from(ErrorKind::IsADirectory).into()));
            }
            let plain =
                SqliteConnectOptions::new().filename(path).create_if_missing(create).busy_timeout(PATIENCE);
            if path.exists() && is_empty_for_long(path).await {
                return Err(Unfit::Foreign(EMPTY_FILE.to_owned()));
            }
            let mut connection = plain.disable_statement_logging().connect().await?;
            let holds = migrations::holds(&mut connection).await?;
            connection.close().await?;
            if holds == Holds::OtherThings {
                return Err(Unfit::Foreign(FOREIGN_FILE.to_owned()));
            }
            write_ahead(&sqlite_options(path, create)).await?;
        }
        Place::Postgres { options, .. } => {
            let connecting = async { options.connect().await?.close().await };
            let silent = |_| Err(io::Error::from(ErrorKind::TimedOut).into());
            tokio::time::timeout(CONNECT_PATIENCE, connecting).await.unwrap_or_else(silent)?;
        }
    }
    Ok(())
}

/// What an empty file is reported as: a store that was cut off must not become a new one.
const EMPTY_FILE: &str = "the file is empty; if a store stood there, bring back a copy, else remove the file";

/// Whether a file stays empty: one that another program is making has something in it at once.
async fn is_empty_for_long(path: &Path) -> bool {
    let begin = Instant::now();
    loop {
        if std::fs::metadata(path).map_or(true, |file| file.len() > 0) {
            return false;
        }
        if begin.elapsed() > Duration::from_secs(1) {
            return true;
        }
        tokio::time::sleep(Duration::from_millis(20)).await;
    }
}

fn is_file(path: &Path) -> bool {
    path.is_file()
}

/// The file of this ending beside another.
fn beside(path: &Path, ending: &str) -> PathBuf {
    let mut name = path.as_os_str().to_owned();
    name.push(ending);
    PathBuf::from(name)
}

/// Puts a file into the mode of the write-ahead log, which stays in it. SQLite does not wait for others while it changes the mode.
async fn write_ahead(options: &SqliteConnectOptions) -> Result<(), sqlx::Error> {
    let begin = Instant::now();
    loop {
        match options.connect().await {
            Ok(connection) => return connection.close().await,
            Err(error) if is_busy(&error) && begin.elapsed() < PATIENCE => {
                tokio::time::sleep(Duration::from_millis(20)).await;
            }
            Err(error) => return Err(error),
        }
    }
}

fn is_busy(error: &sqlx::Error) -> bool {
    let code = error.as_database_error().and_then(|error| error.code());
    code.and_then(|code| code.parse::<u32>().ok()).is_some_and(|code| matches!(code & 0xff, 5 | 6))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::PartFilter;

    #[test]
    fn a_store_that_cannot_be_written_can_be_read() {
        let runtime = tokio::runtime::Builder::new_current_thread().enable_all().build().unwrap();
        runtime.block_on(written_and_read());
    }

    async fn written_and_read() {
        let directory = tempfile::tempdir().unwrap();
        let address = StoreAddress::file(directory.path().join("store.sqlite"));
        Store::open(&address).await.unwrap().close().await;
        let store = Store::connect_read_only(&address, "read-only".to_owned()).await.unwrap();
        assert!(store.parts(&PartFilter::default()).await.unwrap().is_empty());
        assert!(store.health().await.unwrap().faults.is_empty());
        // Where nothing can be written a transaction begins as one that reads: the statement itself is refused.
        let error = store.remove_run(1).await.unwrap_err();
        assert_eq!(error.code(), "store-failed");
        assert!(error.to_string().contains("readonly"), "{error}");
        store.close().await;
        // What stands in a log only would be missing.
        std::fs::write(directory.path().join("store.sqlite-wal"), "log").unwrap();
        let refused = Store::connect_read_only(&address, "read-only".to_owned()).await.unwrap_err();
        assert_eq!(refused.code(), "unreachable-store");
    }
}
