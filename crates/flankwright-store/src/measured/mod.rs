//! From files of measuring machines to parts of the store. Reading and evaluation are the library's; here are the record of a part and the
//! import of many files.

mod files;
mod import;
mod record;

pub use import::{ImportSettings, KnownPart, MeasurementReport, RefusedFile};
