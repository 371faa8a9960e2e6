//! Errors of a store. Messages name the store without its password.

use finding::Finding;
use flankwright::exchange::{Diagnostic, JobError};
use thiserror::Error;

/// Why a store could not be opened, read or written. What was begun is undone.
#[derive(Debug, Error, Finding)]
pub enum StoreError {
    /// The text is no address.
    #[error("`{address}` is no address of a store: {reason}")]
    #[finding(code = "invalid-store-address")]
    #[way_out("give `sqlite:PATH`, a path, or `postgres://USER:PASSWORD@HOST:PORT/DATABASE`")]
    InvalidAddress {
        /// The text without secrets.
        address: String,
        /// What is wrong with it.
        reason: String,
    },
    /// Nothing tells where the user's data are.
    #[error("there is no directory for the store: neither XDG_DATA_HOME nor HOME is set to an absolute path")]
    #[finding(code = "no-data-directory")]
    #[way_out("name the store, e.g. `--store store.sqlite`")]
    NoDataDirectory,
    /// There is nothing at the address, and nothing shall be made there.
    #[error("there is no store at `{address}`")]
    #[finding(code = "missing-store")]
    #[way_out("check the address; what is stored first makes the store")]
    Missing {
        /// The store.
        address: String,
    },
    /// The file or the server cannot be reached.
    #[error("the store `{address}` cannot be opened: {cause}")]
    #[finding(code = "unreachable-store")]
    #[way_out(
        "check path and permissions of the file, or address, user and password of the server and that it runs"
    )]
    CannotOpen {
        /// The store.
        address: String,
        /// What file system or server said.
        cause: String,
    },
    /// Something else is there.
    #[error("`{address}` is no store of flankwright: {cause}")]
    #[finding(code = "not-a-store")]
    #[way_out("check the address, or name a file that is not there yet")]
    NotAStore {
        /// The store.
        address: String,
        /// How that shows.
        cause: String,
    },
    /// A newer version made or changed the tables.
    #[error(
        "the store `{address}` has the tables of version {found}; this program knows them up to version {known}"
    )]
    #[finding(code = "newer-store")]
    #[way_out("take the newer version of flankwright; tables are never changed back")]
    NewerStore {
        /// The store.
        address: String,
        /// Version of its tables.
        found: i64,
        /// Version of the tables of this program.
        known: i64,
    },
    /// Others have been writing for too long.
    #[error("the store `{address}` is busy: {cause}")]
    #[finding(code = "busy-store")]
    #[way_out("try again when the others have finished")]
    Busy {
        /// The store.
        address: String,
        /// What the database said.
        cause: String,
    },
    /// The database refused or failed.
    #[error("the store `{address}` failed: {cause}")]
    #[finding(code = "store-failed")]
    #[way_out("check free space, permissions and the connection, then do the same again")]
    Failed {
        /// The store.
        address: String,
        /// What the database said.
        cause: String,
    },
    /// What stands in the store cannot be read as what it should be.
    #[error("the store `{address}` holds {what} that cannot be read: {cause}")]
    #[finding(code = "damaged-store")]
    #[way_out("bring back a copy of the store, or report this if it was not changed by hand")]
    Damaged {
        /// The store.
        address: String,
        /// A record of what kind.
        what: &'static str,
        /// What is wrong.
        cause: String,
    },
    /// A record that cannot be stored.
    #[error("{0}")]
    #[finding(code = _0.code)]
    #[way_out(with = _0.way_out.as_deref().unwrap_or("correct the record").to_owned())]
    InvalidRecord(Box<Diagnostic>),
    /// A catalogue or a history that contradicts itself or what is there.
    #[error("{0}")]
    #[finding(code = _0.diagnostics.first().map_or("invalid-record", |first| first.code))]
    #[way_out(with = first_way_out(_0))]
    Contradiction(Box<JobError>),
}

impl StoreError {
    /// The error as a finding with code, field, value and way out; fields of a store are its address.
    pub fn finding(&self) -> Diagnostic {
        let address = match self {
            Self::InvalidRecord(finding) => return Diagnostic::clone(finding),
            Self::Contradiction(error) if !error.diagnostics.is_empty() => {
                return error.diagnostics[0].clone();
            }
            Self::Contradiction(_) | Self::NoDataDirectory => None,
            Self::InvalidAddress { address, .. }
            | Self::Missing { address }
            | Self::CannotOpen { address, .. }
            | Self::NotAStore { address, .. }
            | Self::NewerStore { address, .. }
            | Self::Busy { address, .. }
            | Self::Failed { address, .. }
            | Self::Damaged { address, .. } => Some(address),
        };
        let finding = Diagnostic::of(self).field("store");
        match (address, self) {
            (Some(address), Self::NewerStore { known, .. }) => {
                finding.value(address).allowed(format!("tables up to version {known}"))
            }
            (Some(address), _) => finding.value(address),
            (None, _) => finding,
        }
    }
}

/// What the first finding about a file says to do.
fn first_way_out(error: &JobError) -> String {
    let first = error.diagnostics.first();
    first.and_then(|finding| finding.way_out.as_deref()).unwrap_or("correct the file").to_owned()
}

impl From<Diagnostic> for StoreError {
    fn from(finding: Diagnostic) -> Self {
        Self::InvalidRecord(Box::new(finding))
    }
}

impl From<JobError> for StoreError {
    fn from(error: JobError) -> Self {
        Self::Contradiction(Box::new(error))
    }
}
