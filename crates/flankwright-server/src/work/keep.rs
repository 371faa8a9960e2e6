//! Puts measured parts into the store, where trends are followed.

use std::path::{Path, PathBuf};

use flankwright::numerics::Progress;
use flankwright::workflow::inspection::Statements;
use flankwright_store::blocking::Store;
use flankwright_store::{ImportSettings, StoreAddress, StoreError};

use crate::wire::{Failure, Finding, InspectOptions};

/// Imports what was handed in. Parts that are known stay as they are.
pub(super) fn keep(
    folder: &Path,
    options: &InspectOptions,
    statements: Statements,
    place: &StoreAddress,
    progress: &dyn Progress,
) -> Result<(), Failure> {
    let settings = ImportSettings {
        series: options.series.clone().filter(|series| !series.trim().is_empty()),
        class: options.class,
        statements,
        again: false,
    };
    let folder: PathBuf = folder.to_owned();
    let imported =
        Store::open(place).and_then(|store| store.import_measurements(&[folder], &settings, progress));
    imported.map(|_| ()).map_err(|error| refused(&error))
}

fn refused(error: &StoreError) -> Failure {
    Failure { exit: 1, ..Failure::single(Finding::new(error.code(), error.to_string(), error.way_out())) }
}
