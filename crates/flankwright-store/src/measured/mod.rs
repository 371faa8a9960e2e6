//! From files of measuring machines to parts of the store. Reading and evaluation are the library's; here are the record of a part and the
//! import of many files.

mod files;
mod import;
mod record;
mod refused_file;

pub use import::{ImportSettings, KnownPart, MeasurementReport};
pub use refused_file::RefusedFile;
