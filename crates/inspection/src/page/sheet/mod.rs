//! The inspection sheet of a measured gear: A4 pages as SVG in millimetres, profile and helix traces with their values, pitch, run-out,
//! sizes, classes and topographies (`docs/inspection.md`). It draws finished numbers and must not know files, evaluation or tolerances.
//!
//! Pages are read without colour. No number is cut: what finds no room stands on a page of remarks.

mod book;
mod check;
mod data;
mod flank_field;
mod flank_place;
mod foot;
mod head;
mod html;
mod laid_row;
mod lanes;
mod limits;
mod middle_column;
mod ordinate;
mod pages;
mod pitch_row;
mod pitch_strip;
mod reach;
mod remarks;
mod said;
mod text_fit;
mod topography;
mod topography_net;
mod trace_row;
mod traces_data;
mod value_table;

pub use data::{
    RunOutStrip, SheetData, SheetFoot, SheetHead, SheetPitch, SheetPitchFlank, SheetSize, SheetTopography,
    SheetValue,
};
pub use html::sheet_html;
pub use limits::SheetLimits;
pub use pages::{SheetPage, sheet_pages};
pub use traces_data::{
    JudgedBy, LineLook, ScaleLine, SheetBand, SheetCharacteristic, SheetTrace, TraceField, TraceRow,
};
