//! Measurements of gears as files bring them: one data model, the Klingelnberg formats .mka and .mew, tables of traces. Says exactly what
//! it did not understand. Knows neither evaluation nor tolerances.
//!
//! Deviations are stored with the sign of the material, f > 0 standing, in the section of the file; positions along the face count from its
//! middle towards +z, positions along the profile are lengths of roll.

pub mod conditions;
pub mod date;
mod encoding;
pub mod error;
mod field_table;
pub mod gear;
mod grid_table;
#[expect(clippy::module_inception, reason = "the inspection is the model that this room is about")]
pub mod inspection;
pub mod klingelnberg;
pub mod measured_table;
mod other_end;
pub mod result;
pub mod tables;
pub mod trace;
pub mod trace_table;
mod undefined;
pub mod warning;

pub use conditions::{
    Conditions, CountingDirection, DatumFace, FlankConditions, LeadPositions, ProfilePositions, Section,
    SlopeReference,
};
pub use date::{SORTABLE_DATE, is_sortable_date, measured_at, sortable_date};
pub use encoding::Encoding;
pub use error::InspectionError;
pub use field_table::topography_table;
pub use gear::InspectedGear;
pub use grid_table::{GridReading, GridSize, Touched, parse_grid_table, read_grid_table};
pub use inspection::Inspection;
pub use klingelnberg::{
    Circles as CircleTable, Curve, FileKind, HeaderEntry, KlingelnbergFile, MAXIMUM_FILE_BYTES,
    MAXIMUM_SAMPLES, MAXIMUM_TRACES, MAXIMUM_UNKNOWN_LINES, PitchRow, PreambleEntry, UnknownLine,
    inspection_of, parse_klingelnberg, read_klingelnberg,
};
pub use measured_table::{MeasuredTable, parse_measured_table, read_measured_table};
pub use result::{Characteristic, Position, Quantity, ResultCode, Statistic, Unit};
pub use tables::{Circle, Circles, FlankPitch, Pitch, ProbePosition, RunOut, Size, Thickness};
pub use trace::{Topography, Trace, TraceKind, Zero};
pub use trace_table::trace_table;
pub use warning::{InspectionWarning, WarningKind};

#[cfg(test)]
mod tests;
