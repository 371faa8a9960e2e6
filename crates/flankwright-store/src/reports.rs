//! What was done with a store, and how it is, in figures.

use serde::Serialize;

/// What an import did.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize)]
pub struct ImportReport {
    /// Parts that were put in: new ones, and those that took the place of stored ones.
    pub added: usize,
    /// How many of them took the place of stored ones.
    pub replaced: usize,
    /// Places, in the given list, of parts whose digest was there already; the stored ones stay as they are.
    pub known: Vec<usize>,
}

/// What an import of a catalogue did, in bodies.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
pub struct CatalogueReport {
    /// New ones.
    pub added: usize,
    /// Of the same name, with other data than before.
    pub changed: usize,
    /// The same as before.
    pub unchanged: usize,
    /// Taken out, because the new catalogue replaced the old one.
    pub removed: usize,
}

/// What an import of a history did.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
pub struct HistoryReport {
    /// New measurements.
    pub added: usize,
    /// Measurements that were there already.
    pub known: usize,
}

/// What a check of a store found.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct StoreHealth {
    /// Where it is.
    pub store: String,
    /// `sqlite` or `postgresql`.
    pub kind: &'static str,
    /// Version of its tables.
    pub tables: i64,
    /// Parts.
    pub parts: u64,
    /// Parts whose files are there too.
    pub parts_with_files: u64,
    /// What those files take, packed, in bytes.
    pub file_bytes: u64,
    /// Values of characteristics.
    pub values: u64,
    /// Worms and dressers.
    pub bodies: u64,
    /// Plans.
    pub plans: u64,
    /// Measurements of skiving tools.
    pub tool_measurements: u64,
    /// What is wrong with it; empty for a sound store.
    pub faults: Vec<String>,
}
