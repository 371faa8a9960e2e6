//! What goes into a series and what comes out of it, as data.

use super::super::files::LeftOutFile;
use super::super::sheet::SheetOptions;
use super::super::statements::Statements;
use super::result::InspectionSeriesResult;
use job::tables::Language;
use metrology::inspection::{CharacteristicSeries, SeriesPart};

/// What the user decides about a series.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SeriesOptions {
    /// Language of page and sheets.
    pub language: Language,
    /// Sheets of the parts; their class gives the limits of the series as well.
    pub sheet: SheetOptions,
    /// Statistics only: no sheet for each part.
    pub without_sheets: bool,
    /// What holds for all measurements.
    pub statements: Statements,
    /// What the folder holds and is no part of the series; for information only.
    pub left_out: Vec<LeftOutFile>,
}

/// A part that was evaluated before: its series, its file, its characteristics.
#[derive(Clone, Debug, PartialEq)]
pub struct StoredPart {
    /// To which parts it belongs.
    pub series: String,
    /// Its file.
    pub file: String,
    /// Label, time and values.
    pub part: SeriesPart,
}

/// A series with everything that is written of it.
#[derive(Clone, Debug)]
pub struct InspectionSeries {
    /// Language of its page.
    pub language: Language,
    /// The document of `series.json`.
    pub result: InspectionSeriesResult,
    /// Evaluated characteristics, in the order of the groups of the document.
    pub groups: Vec<Vec<CharacteristicSeries>>,
    /// Sheets: path below the directory of the series, text.
    pub sheets: Vec<(String, String)>,
}
