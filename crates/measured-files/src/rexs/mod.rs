//! REXS 2.0 in and out: gears with their modifications and measured deviations, as XML, JSON or a packed file. Every structure that is read
//! is checked; what the format cannot hold is reported. Knows neither plans nor evaluation.
//!
//! The schema states neither signs nor the origin of coordinates. Decided here: amounts of modifications > 0 removed, deviations > 0
//! material, coordinates along the face count from the datum face, lists run point by point, coordinate outside, diameter inside.

mod attributes;
mod coded;
mod deviations;
pub mod document;
pub mod error;
mod flank;
pub mod from_gear;
pub mod gear;
mod job;
mod json_read;
mod json_write;
mod load_spectrum;
mod modification_read;
mod modification_write;
pub mod package;
mod topography;
mod values;
pub mod warning;
mod xml_read;
mod xml_write;

pub use document::{
    Attribute, Component, ComponentRef, Content, Opaque, Relation, RexsDocument, RexsFormat, Value,
};
pub use error::RexsError;
pub use from_gear::{Author, document_of};
pub use gear::{FlankField, RexsGear, gear_ids, gear_of};
pub use package::{MAXIMUM_FILE_BYTES, parse_rexs, read_rexs, rexs_bytes};
pub use warning::{RexsWarning, RexsWarningKind};

#[cfg(test)]
mod tests;
