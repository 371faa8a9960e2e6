//! A place for a store that nobody else uses, on either database, and tests that run on both.

use flankwright_store::StoreAddress;
use flankwright_store::blocking::Store;
use sqlx::{AssertSqlSafe, Connection, SqliteConnection};
use tempfile::TempDir;

use crate::server;

/// Where a test has its store.
pub struct Place {
    /// The address as a user gives it.
    pub text: String,
    /// The directory of a file.
    directory: Option<TempDir>,
}

impl Place {
    /// A file in a new directory.
    pub fn sqlite() -> Self {
        let directory = tempfile::tempdir().expect("a directory");
        let text = directory.path().join("store.sqlite").to_str().expect("a path of UTF-8").to_owned();
        Self { text, directory: Some(directory) }
    }

    /// A new database of the server.
    pub fn postgres() -> Self {
        Self { text: server::database(), directory: None }
    }

    pub fn address(&self) -> StoreAddress {
        self.text.parse().expect("an address")
    }

    pub fn open(&self) -> Store {
        Store::open(&self.address()).expect("a store")
    }

    /// Runs a statement beside the store, as somebody with another program does.
    pub fn run(&self, statement: &str) {
        if self.directory.is_none() {
            return server::run(&self.text, statement);
        }
        server::block_on(async {
            let mut connection =
                SqliteConnection::connect(&format!("sqlite:{}", self.text)).await.expect("the file");
            let statement = statement.replace("flankwright.", "");
            sqlx::query(AssertSqlSafe(statement)).execute(&mut connection).await.expect("it runs");
            connection.close().await.expect("an end");
        });
    }
}

/// Makes a test on each database of every function that takes a [`Place`].
macro_rules! on_both {
    ($($name:ident)*) => {
        mod sqlite {
            $(#[test] fn $name() { super::$name(&crate::place::Place::sqlite()); })*
        }
        mod postgres {
            $(#[test] fn $name() { super::$name(&crate::place::Place::postgres()); })*
        }
    };
}

pub(crate) use on_both;
