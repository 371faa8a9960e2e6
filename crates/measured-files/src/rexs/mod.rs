//! REXS 2.0 in and out: gears with their modifications and measured deviations, as XML, JSON or a packed file. Every structure that is read
//! is checked; what the format cannot hold is reported. Knows neither plans nor evaluation.
//!
//! The schema states neither signs nor the origin of coordinates. Decided here: amounts of modifications > 0 removed, deviations > 0
//! material, coordinates along the face count from the datum face, lists run point by point, coordinate outside, diameter inside.

mod attribute_structure;
mod attributes;
mod coded;
mod deviations;
pub mod document;
mod draft;
pub mod error;
mod flank;
mod flank_field;
pub mod from_gear;
pub mod gear;
mod job;
mod json_read;
mod json_write;
mod load_spectrum;
mod modification_read;
mod modification_write;
pub mod package;
mod signs;
mod thickness;
mod topography;
mod values;
pub mod warning;
mod xml_read;
mod xml_write;

pub use document::{
    Attribute, Component, ComponentRef, Content, Opaque, Relation, RexsDocument, RexsFormat, Value,
};
pub use error::RexsError;
pub use flank_field::FlankField;
pub use from_gear::{Author, document_of};
pub use gear::RexsGear;
pub use package::{MAXIMUM_FILE_BYTES, parse_rexs, read_rexs, rexs_bytes};
pub use thickness::{RexsMeasure, RexsThickness};
pub use to_gear::{gear_ids, gear_of};
pub use warning::{RexsWarning, RexsWarningKind};

#[cfg(test)]
mod tests;
mod to_gear;
mod xml_place;
