//! Puts measured parts into the store, where trends are followed.

use std::path::{Path, PathBuf};

use flankwright::numerics::Progress;
use flankwright::workflow::inspection::Statements;
use flankwright_store::blocking::Store;
use flankwright_store::{ImportSettings, MeasurementReport, StoreAddress};

use crate::wire::{Failure, InspectOptions};

/// Imports what was uploaded: which parts are new, which are known and stay as they are, which are refused.
pub(super) fn keep(
    folder: &Path,
    options: &InspectOptions,
    statements: Statements,
    place: &StoreAddress,
    progress: &dyn Progress,
) -> Result<MeasurementReport, Failure> {
    let settings = ImportSettings {
        series: options.series.clone().filter(|series| !series.trim().is_empty()),
        class: options.class,
        statements,
        again: false,
    };
    let folder: PathBuf = folder.to_owned();
    let imported =
        Store::open(place).and_then(|store| store.import_measurements(&[folder], &settings, progress));
    imported.map_err(|error| Failure::store(&error))
}
