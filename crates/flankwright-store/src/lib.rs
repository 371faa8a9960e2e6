//! The store of what outlives one run of flankwright: measured parts, the catalogue of worms and dressers, plans, histories of skiving tools. In a file
//! of SQLite, or on a PostgreSQL server that several stations share. Computes nothing about gears.
//!
//! ```
//! use flankwright_store::{CharacteristicFilter, CharacteristicValue, PartRecord, StoreAddress, blocking::Store, digest_of};
//!
//! # let directory = tempfile::tempdir()?;
//! # let path = directory.path().join("store.sqlite");
//! let address: StoreAddress = format!("sqlite:{}", path.display()).parse()?;
//! let store = Store::open(&address)?;
//! let part = PartRecord {
//!     series: "pinion 95911".into(),
//!     part: "17".into(),
//!     drawing: None,
//!     date: Some("2026-03-14T09:30:00".into()),
//!     machine: None,
//!     source: "pinion-17.mka".into(),
//!     digest: digest_of(b"the bytes of the file"),
//!     document: serde_json::json!({ "class": 5 }),
//!     characteristics: vec![CharacteristicValue {
//!         name: "Fp".into(),
//!         flank: None,
//!         tooth: None,
//!         statistic: "single".into(),
//!         value: 12.5,
//!         unit: "um".into(),
//!         lower_limit: None,
//!         upper_limit: Some(25.0),
//!     }],
//! };
//! assert_eq!(store.import_parts(std::slice::from_ref(&part))?.added, 1);
//! // The same file again is no second part.
//! assert_eq!(store.import_parts(&[part.clone()])?.known, [0]);
//! let filter = CharacteristicFilter { name: Some("Fp".into()), ..CharacteristicFilter::default() };
//! let values = store.characteristics(&filter)?;
//! assert_eq!((values[0].characteristic.key().as_str(), values[0].value), ("Fp.single", 12.5));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! Everything is written in transactions that are whole or not there, one writer at a time: what a method has returned is on the disk,
//! and a program that is killed leaves nothing half. [`Store`] is for programs with a runtime (tokio), [`blocking::Store`] for others.

mod address;
pub mod blocking;
mod catalogue;
mod check;
mod content;
mod digest;
mod error;
mod filter;
mod health;
mod history;
mod measured;
mod migrations;
mod parts;
mod plans;
mod pool;
mod records;
mod reports;
mod run_servers;
mod runs;
mod store;
mod words;

pub use address::StoreAddress;
pub use content::PartContent;
pub use digest::digest_of;
pub use error::StoreError;
pub use filter::{CharacteristicFilter, PartFilter};
pub use measured::{ImportSettings, KnownPart, MeasurementReport, RefusedFile};
pub use parts::{SHORTEST_DIGEST, StoredMeasurement};
pub use records::{
    Characteristic, CharacteristicValue, MeasuredCharacteristic, MeasuredPart, NewRun, PartRecord,
    PartSummary, PlanRecord, PlanSummary, RunEnd, RunFile, RunFileSummary, RunRecord, RunState, RunSummary,
    SeriesSummary, ToolSummary,
};
pub use reports::{CatalogueReport, HistoryReport, ImportReport, StoreHealth};
pub use store::Store;
