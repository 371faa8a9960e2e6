//! What stands on a sheet besides the traces: head, pitch, foot, topographies. Deviations in um, > 0 material.

use super::limits::SheetLimits;
use super::traces_data::TraceRow;
use foundation::geometry::{Flank, Sides};
use report::Language;
use report::data::Fact;

/// Everything on the sheet of one gear.
#[derive(Clone, Debug, PartialEq)]
pub struct SheetData {
    /// Its language; all texts are composed in English.
    pub language: Language,
    /// What the sheet is of, usually the number of the part.
    pub title: String,
    /// What made the sheet: name and version.
    pub product: String,
    /// Head of every page.
    pub head: SheetHead,
    /// Profiles of the first page.
    pub profiles: TraceRow,
    /// Helix traces of the first page.
    pub helices: TraceRow,
    /// Rows of further pages, for example those that show twist.
    pub further: Vec<TraceRow>,
    /// Pitch and run-out.
    pub pitch: SheetPitch,
    /// Sizes, classes, warnings.
    pub foot: SheetFoot,
    /// Measured fields.
    pub topographies: Vec<SheetTopography>,
}

/// The head: labels with their texts, in three columns.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct SheetHead {
    /// Part, drawing, date, machine.
    pub part: Vec<Fact>,
    /// Data of the gear.
    pub gear: Vec<Fact>,
    /// Section, filters, datum face, counting, signs, class of the tolerances.
    pub conditions: Vec<Fact>,
}

/// A value with its unit, its limits and the class that it reaches.
#[derive(Clone, Debug, PartialEq)]
pub struct SheetValue {
    /// Symbol; an underscore sets an index.
    pub symbol: String,
    /// The value; `None` if it is not known.
    pub value: Option<f64>,
    /// Its unit.
    pub unit: &'static str,
    /// Decimals to print.
    pub decimals: usize,
    /// Its limits.
    pub limits: SheetLimits,
    /// Class, or any remark of a few letters; empty for none.
    pub class: String,
}

impl SheetValue {
    /// A value without limits and class.
    pub fn new(symbol: impl Into<String>, value: Option<f64>, unit: &'static str, decimals: usize) -> Self {
        let limits = SheetLimits::default();
        Self { symbol: symbol.into(), value, unit, decimals, limits, class: String::new() }
    }
}

/// Pitch and run-out.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SheetPitch {
    /// How the teeth are counted, on which diameter; empty for nothing.
    pub words: String,
    /// Pitches; `None` if they were not measured.
    pub flanks: Sides<Option<SheetPitchFlank>>,
    /// Run-out and what belongs to both flanks.
    pub run_out: RunOutStrip,
}

/// Pitches of a flank, tooth 1 first.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SheetPitchFlank {
    /// fp, um; NaN leaves a gap.
    pub single_um: Vec<f64>,
    /// Fp, um, as many; empty if they are not known.
    pub cumulative_um: Vec<f64>,
    /// What the eccentricity makes of Fp, um; empty if it is not known.
    pub eccentric_um: Vec<f64>,
    /// The worst sector: the number of pitches in it, behind which tooth it begins (0 to teeth - 1).
    pub sector: Option<[usize; 2]>,
    /// Values.
    pub values: Vec<SheetValue>,
}

/// Run-out, space 1 first.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct RunOutStrip {
    /// Fr, um; NaN leaves a gap, no value at all is not measured.
    pub of_space_um: Vec<f64>,
    /// What the eccentricity makes of it, um; empty if it is not known.
    pub eccentric_um: Vec<f64>,
    /// Values.
    pub values: Vec<SheetValue>,
}

/// Sizes, classes, warnings.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SheetFoot {
    /// Span, balls, circles.
    pub sizes: Vec<SheetSize>,
    /// Judged quantities with their classes.
    pub results: Vec<SheetValue>,
    /// The result of the part in a few words.
    pub overall: String,
    /// Warnings, one sentence each.
    pub warnings: Vec<String>,
}

/// A size in mm with its spread over the gear.
#[derive(Clone, Debug, PartialEq)]
pub struct SheetSize {
    /// Name with its conditions; an underscore sets an index.
    pub name: String,
    /// Mean.
    pub mean_mm: Option<f64>,
    /// Smallest.
    pub least_mm: Option<f64>,
    /// Largest.
    pub largest_mm: Option<f64>,
}

/// A measured field of one flank as a grid.
#[derive(Clone, Debug, PartialEq)]
pub struct SheetTopography {
    /// Tooth.
    pub tooth: u32,
    /// Flank.
    pub flank: Flank,
    /// Lengths of roll, mm, ascending.
    pub roll_mm: Vec<f64>,
    /// Whether the tip is at the last of them; internal gears have it at the first.
    pub tip_last: bool,
    /// Places along the face, upwards, mm, ascending.
    pub face_mm: Vec<f64>,
    /// Name of the place along the face, for example the distance from the datum face.
    pub face_name: String,
    /// Deviations by place on the profile, then along the face, um; NaN leaves a gap.
    pub f_um: Vec<Vec<f64>>,
    /// Features of the surface.
    pub features: Vec<SheetValue>,
    /// What to know about it; empty for nothing.
    pub note: String,
}
