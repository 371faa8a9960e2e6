//! Klingelnberg files: .mka with curves, .mew with values, in all dialects of `docs/inspection.md`. Reads tolerantly and within bounds,
//! tells every line it did not understand, and turns what it understood into the model of this room.

mod block;
pub mod convert;
mod header;
mod limits;
mod number;
pub mod read;
mod reader;
mod settings;
mod tables;

use super::tables::ProbePosition;
pub use convert::inspection_of;
pub use header::{HeaderEntry, PreambleEntry};
pub use limits::{MAXIMUM_FILE_BYTES, MAXIMUM_SAMPLES, MAXIMUM_TRACES, MAXIMUM_UNKNOWN_LINES};
pub use read::{parse_klingelnberg, read_klingelnberg};

use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

use super::{Encoding, InspectionWarning, TraceKind, undefined};
use foundation::geometry::{Flank, Sides};

/// What a file holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum FileKind {
    /// Curves and tables: .mka.
    Curves,
    /// Printed values: .mew.
    Values,
}

/// A curve as the file has it: values turn in one fixed sense, their places follow from the header.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Curve {
    /// Along profile or face width.
    pub kind: TraceKind,
    /// Number of the tooth.
    pub tooth: u32,
    /// Letters behind the number.
    pub tag: String,
    /// The flank.
    pub flank: Flank,
    /// Where it lies: length of roll of a helix, height in the file of a profile, mm.
    pub position_mm: f64,
    /// Values of the file, um; NaN = undefined.
    #[serde(with = "undefined")]
    pub values: Vec<f64>,
    /// Line of the file, from 1.
    pub line: usize,
}

/// A row of a table of pitches, um; NaN = undefined or no such column.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct PitchRow {
    /// Number of the tooth.
    pub tooth: u32,
    /// Single pitch deviation.
    #[serde(with = "undefined::number")]
    pub fp: f64,
    /// Cumulative pitch deviation.
    #[serde(with = "undefined::number")]
    pub cumulative: f64,
    /// Radial run-out.
    #[serde(with = "undefined::number")]
    pub run_out: f64,
}

/// Diameters of a circle at a height of the file.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Circles {
    /// Tip circle, else root circle.
    pub tip: bool,
    /// Height in the file, mm.
    pub height_mm: f64,
    /// Diameters, mm.
    #[serde(with = "undefined")]
    pub diameters_mm: Vec<f64>,
}

/// A line that was not understood.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct UnknownLine {
    /// Number of the line, from 1.
    pub line: usize,
    /// Its first 80 characters.
    pub text: String,
}

/// Everything that was understood of a file, in its own signs and coordinates, and what was not.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct KlingelnbergFile {
    /// Curves or values.
    pub kind: FileKind,
    /// Encoding.
    pub encoding: Encoding,
    /// Lines before the first code.
    pub preamble: Vec<PreambleEntry>,
    /// Lines of the header by code.
    pub header: BTreeMap<u16, HeaderEntry>,
    /// Curves in the order of the file.
    pub curves: Vec<Curve>,
    /// Circles in the order of the file.
    pub circles: Vec<Circles>,
    /// Tables of pitches.
    pub pitch: Sides<Vec<PitchRow>>,
    /// Positions of the probe.
    pub positions: Vec<ProbePosition>,
    /// Printed values by code; `None` if not measured or not available.
    pub results: BTreeMap<u32, Option<f64>>,
    /// Doubts.
    pub warnings: Vec<InspectionWarning>,
    /// Lines that were not understood.
    pub unknown_lines: Vec<UnknownLine>,
}
