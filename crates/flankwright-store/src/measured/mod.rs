//! From files of measuring machines to parts of the store. Reading and evaluation are the library's; here are identity, series, the list of
//! characteristics, and the import of many files.

mod characteristics;
mod files;
mod import;
mod limits;
mod record;

pub use import::{ImportSettings, KnownPart, MeasurementReport, RefusedFile};
