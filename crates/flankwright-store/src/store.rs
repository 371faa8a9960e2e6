//! Opening and closing a store.

use std::io::{self, ErrorKind};
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

    /// Opens a store that is there; a file that is not there is not made.
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
        Self::connect(address, false).await
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

    /// What a statement gave, its error told with the store.
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

/// Connects once, because a pool tries again and again where nobody answers and who opens a store wants to know at once. A file of
/// another program is left as it is.
async fn reach(place: &Place, create: bool) -> Result<(), Unfit> {
    match place {
        Place::Sqlite(path) => {
            if path.is_dir() {
                return Err(Unfit::Database(io::Error::from(ErrorKind::IsADirectory).into()));
            }
            let plain =
                SqliteConnectOptions::new().filename(path).create_if_missing(create).busy_timeout(PATIENCE);
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
