//! Which store a command uses, and how its errors are reported.

use std::path::Path;

use clap::Args;
use flankwright_store::blocking::Store;
use flankwright_store::{StoreAddress, StoreError};
use serde::Serialize;

use crate::common_arguments::CommonArguments;
use crate::exit::Exit;
use crate::failure::{Failure, unreadable};
use crate::output;

/// Arguments that every action has.
#[derive(Args, Debug)]
pub struct PlaceArguments {
    /// The store: a path, sqlite:PATH or postgres://...; default FLANKWRIGHT_STORE, else a file among the user's data
    #[arg(long, value_name = "ADDRESS")]
    pub store: Option<String>,
    /// Arguments that every command has.
    #[command(flatten)]
    pub common: CommonArguments,
}

impl PlaceArguments {
    /// Opens the store, and makes it where there is none.
    pub fn open(&self) -> Result<Store, Failure> {
        self.address().and_then(|address| Store::open(&address)).map_err(failed)
    }

    /// Opens a store that is there.
    pub fn open_existing(&self) -> Result<Store, Failure> {
        self.address().and_then(|address| Store::open_existing(&address)).map_err(failed)
    }

    /// Where the store is.
    ///
    /// # Errors
    /// An address that is none.
    pub fn address(&self) -> Result<StoreAddress, StoreError> {
        StoreAddress::chosen(self.store.as_deref())
    }

    /// Prints the document for programs, or the text for people.
    pub fn print(&self, document: &impl Serialize, text: impl FnOnce() -> String) -> Result<(), Failure> {
        if self.common.json {
            return output::print_json(document);
        }
        if self.common.quiet { Ok(()) } else { output::print(&text()) }
    }
}

/// What a command says when the store refuses.
pub fn failed(error: StoreError) -> Failure {
    match error {
        StoreError::Contradiction(error) => Failure::from(*error),
        other => Failure::new(Exit::BadInput, other.finding()),
    }
}

/// The bytes of a file.
pub fn bytes_of(path: &Path) -> Result<Vec<u8>, Failure> {
    let told =
        |error| Failure::new(Exit::BadInput, unreadable(&path.display().to_string(), &error).field("FILE"));
    std::fs::read(path).map_err(told)
}
