//! Traces of a sheet: a row of two fields, one for each flank, with its scale and the table below. Deviations in um, > 0 material.

use super::limits::SheetLimits;
use foundation::geometry::Sides;

/// A row of the sheet: traces of one line of both flanks.
#[derive(Clone, Debug, PartialEq)]
pub struct TraceRow {
    /// What it shows, for example `Profile`.
    pub name: String,
    /// Symbol of the coordinate along the traces.
    pub coordinate: String,
    /// Whether the coordinate grows upwards.
    pub rising: bool,
    /// What is at the upper end, for example `tip`.
    pub top: String,
    /// What is at the lower end.
    pub bottom: String,
    /// Symbol and unit of the labels of the lines.
    pub scale: String,
    /// How slopes are counted: sign and reference length.
    pub slope_words: String,
    /// Traces of the flanks.
    pub flanks: Sides<TraceField>,
}

/// Traces of one flank; without any it is not measured.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct TraceField {
    /// Traces in any order; they are drawn by tooth.
    pub traces: Vec<SheetTrace>,
    /// Lines across the field.
    pub lines: Vec<ScaleLine>,
    /// What is evaluated, in the order of the values of the traces.
    pub characteristics: Vec<SheetCharacteristic>,
}

/// One trace.
#[derive(Clone, Debug, PartialEq)]
pub struct SheetTrace {
    /// Tooth.
    pub tooth: u32,
    /// Places of the samples, mm, ascending.
    pub abscissa_mm: Vec<f64>,
    /// Deviations, um; NaN leaves a gap.
    pub f_um: Vec<f64>,
    /// Ends of the mean line [mm, um].
    pub mean_line: Option<[[f64; 2]; 2]>,
    /// Limits around it.
    pub band: Option<SheetBand>,
    /// Values of the characteristics in their order; missing ones at the end are not known.
    pub values: Vec<Option<f64>>,
}

/// A K-band.
#[derive(Clone, Debug, PartialEq)]
pub struct SheetBand {
    /// Corners [mm, lower um, upper um].
    pub corners: Vec<[f64; 3]>,
    /// What is added to the trace before it is compared, um.
    pub shift_um: f64,
    /// Whether it lies within.
    pub passed: bool,
}

/// A line across a field at a place of the coordinate.
#[derive(Clone, Debug, PartialEq)]
pub struct ScaleLine {
    /// The place, mm.
    pub at_mm: f64,
    /// Symbol of the place; an underscore sets an index.
    pub name: String,
    /// Its value on the scale, for example the diameter there.
    pub value: f64,
    /// How it is drawn.
    pub look: LineLook,
}

/// How a line across a field is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LineLook {
    /// End of the measurement: thin.
    End,
    /// End of the evaluation: full.
    Limit,
    /// End of a zone of relief: dashed.
    Relief,
}

/// A characteristic of the traces of a flank.
#[derive(Clone, Debug, PartialEq)]
pub struct SheetCharacteristic {
    /// Symbol; an underscore sets an index.
    pub symbol: String,
    /// Unit of all its values.
    pub unit: &'static str,
    /// Mean over the teeth.
    pub mean: Option<f64>,
    /// Greatest less least.
    pub range: Option<f64>,
    /// Limits.
    pub limits: SheetLimits,
    /// What is compared with the limits.
    pub judged: JudgedBy,
}

/// What of a characteristic is compared with its limits.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum JudgedBy {
    /// The mean over the teeth.
    Mean,
    /// The value of each tooth.
    Each,
}
