//! The store for programs without a runtime of their own, such as the command: every method of [`crate::Store`], waiting until it is done.

use std::collections::HashSet;
use std::time::Duration;

use flankwright::exchange::catalogue::Catalogue;
use flankwright::exchange::skiving_history::{History, HistoryRecord};
use flankwright::workflow::inspection::MeasurementFile;
use tokio::runtime::{Builder, Handle, Runtime};

use crate::address::StoreAddress;
use crate::content::PartContent;
use crate::error::StoreError;
use crate::filter::{CharacteristicFilter, PartFilter};
use crate::parts::StoredMeasurement;
use crate::records::{
    MeasuredCharacteristic, MeasuredPart, NewRun, PartRecord, PartSummary, PlanRecord, PlanSummary, RunEnd,
    RunFile, RunRecord, RunSummary, SeriesSummary, ToolSummary,
};
use crate::reports::{CatalogueReport, HistoryReport, ImportReport, StoreHealth};
use crate::store::Store as AsyncStore;

/// A store that is open; closed when it is dropped. Not to be used inside of a runtime: there [`crate::Store`] is at hand.
#[derive(Debug)]
pub struct Store {
    runtime: Runtime,
    store: AsyncStore,
}

impl Store {
    /// Parts of a set that large keep what is lost by an interruption, and what others wait for, below a second.
    pub const BATCH: usize = AsyncStore::BATCH;

    /// As [`crate::Store::open`].
    ///
    /// # Errors
    /// As there.
    pub fn open(address: &StoreAddress) -> Result<Self, StoreError> {
        let runtime = runtime(address)?;
        let store = runtime.block_on(AsyncStore::open(address))?;
        Ok(Self { runtime, store })
    }

    /// As [`crate::Store::open_existing`].
    ///
    /// # Errors
    /// As there.
    pub fn open_existing(address: &StoreAddress) -> Result<Self, StoreError> {
        let runtime = runtime(address)?;
        let store = runtime.block_on(AsyncStore::open_existing(address))?;
        Ok(Self { runtime, store })
    }

    /// Where it is.
    pub fn address(&self) -> &StoreAddress {
        self.store.address()
    }

    /// As [`crate::Store::files_of`].
    ///
    /// # Errors
    /// As there.
    pub fn files_of(&self, content: &PartContent) -> Result<Vec<MeasurementFile>, StoreError> {
        self.store.files_of(content)
    }
}

fn runtime(address: &StoreAddress) -> Result<Runtime, StoreError> {
    Builder::new_current_thread().enable_all().build().map_err(|error| StoreError::CannotOpen {
        address: address.to_string(),
        cause: format!("no runtime can be had: {error}"),
    })
}

impl Drop for Store {
    fn drop(&mut self) {
        // Where a runtime is running, waiting would stop it; the connections end by themselves then.
        if Handle::try_current().is_err() {
            self.runtime.block_on(self.store.close());
        }
    }
}

/// Methods that wait for those of the same name.
macro_rules! waiting {
    ($($name:ident($($argument:ident: $kind:ty),*) -> $result:ty;)*) => {
        impl Store {
            $(
                #[doc = concat!("As [`crate::Store::", stringify!($name), "`].\n\n# Errors\nAs there.")]
                pub fn $name(&self, $($argument: $kind),*) -> Result<$result, StoreError> {
                    self.runtime.block_on(self.store.$name($($argument),*))
                }
            )*
        }
    };
}

waiting! {
    import_parts(parts: &[PartRecord]) -> ImportReport;
    replace_parts(parts: &[PartRecord]) -> ImportReport;
    import_measured(parts: &[MeasuredPart], replace: bool) -> ImportReport;
    remove_part(digest: &str) -> bool;
    series() -> Vec<SeriesSummary>;
    parts(filter: &PartFilter) -> Vec<PartSummary>;
    part(digest: &str) -> Option<PartRecord>;
    known_parts(digests: &[&str]) -> HashSet<String>;
    part_named(name: &str) -> PartSummary;
    measurement(name: &str) -> StoredMeasurement;
    part_content(digest: &str) -> Option<PartContent>;
    complete_part(content: &PartContent) -> bool;
    parts_without_content(digests: &[&str]) -> HashSet<String>;
    characteristics(filter: &CharacteristicFilter) -> Vec<MeasuredCharacteristic>;
    import_catalogue(catalogue: &Catalogue, replace: bool) -> CatalogueReport;
    catalogue() -> Catalogue;
    add_plan(plan: &PlanRecord) -> bool;
    plans() -> Vec<PlanSummary>;
    plan(id: i64) -> Option<PlanRecord>;
    add_run(run: &NewRun) -> i64;
    begin_run(id: i64) -> bool;
    end_run(id: i64, end: &RunEnd) -> bool;
    beat(owner: &str, gone: &[String], silence: Duration, ended: &str) -> u64;
    leave(owner: &str, ended: &str) -> u64;
    runs(most: u32) -> Vec<RunSummary>;
    run(id: i64) -> Option<RunRecord>;
    run_summary(id: i64) -> Option<RunSummary>;
    run_input_names(id: i64) -> Vec<String>;
    run_inputs(id: i64) -> Vec<RunFile>;
    run_file(id: i64, name: &str) -> Option<RunFile>;
    remove_run(id: i64) -> bool;
    import_history(history: &History) -> HistoryReport;
    history(tool: Option<&str>) -> Vec<HistoryRecord>;
    tools() -> Vec<ToolSummary>;
    health() -> StoreHealth;
}
