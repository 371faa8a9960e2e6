//! A series of measured parts: many files at once, read and evaluated side by side, brought into order, statistics per characteristic,
//! a sheet for each part. A refused file is reported and keeps no other from being evaluated.

mod characteristics;
mod document;
mod figures;
mod folder;
mod read;
mod result;
mod summary;
mod tables;
mod write;

pub use characteristics::{is_followed, series_values};
pub use folder::{PartsOfFolder, measured_parts_in};
pub use result::{
    InspectionSeriesResult, RefusedFile, SeriesCapability, SeriesCharacteristic, SeriesFigures,
    SeriesFinding, SeriesGroupResult, SeriesPartResult, SeriesTrend,
};
pub use summary::series_summary;
pub use write::write_inspection_series;

use super::files::LeftOutFile;
use super::judgement::check_class;
use super::sheet::SheetOptions;
use super::statements::Statements;
use job::Diagnostic;
use metrology::inspection::{CharacteristicSeries, SeriesPart};
use rayon::prelude::*;
use run::RunFailure;
use std::path::PathBuf;

/// What the user decides about a series.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SeriesOptions {
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

/// The series of parts that were evaluated before; the limits are those of the parts.
pub fn series_of_stored(parts: Vec<StoredPart>) -> InspectionSeries {
    document::series_of(parts.into_iter().map(|part| Ok(read::ReadPart::of_stored(part))).collect(), None)
}

/// A series with everything that is written of it.
#[derive(Clone, Debug)]
pub struct InspectionSeries {
    /// The document of `series.json`.
    pub result: InspectionSeriesResult,
    /// Evaluated characteristics, in the order of the groups of the document.
    pub groups: Vec<Vec<CharacteristicSeries>>,
    /// Sheets: path below the directory of the series, text.
    pub sheets: Vec<(String, String)>,
}

/// Reads and evaluates every part. The result does not depend on the number of threads, nor on the order of the paths beyond parts
/// that are equal in time and name.
///
/// # Errors
/// [`RunFailure`] for a class outside ISO 1328-1, or without any file. What is wrong with a file stands in the result.
pub fn inspect_series(paths: &[PathBuf], options: &SeriesOptions) -> Result<InspectionSeries, RunFailure> {
    if paths.is_empty() {
        let finding = Diagnostic::with_code("no-measurements", "there is no measurement to evaluate")
            .field("FOLDER")
            .way_out("name a folder with .mka, .mew or REXS files");
        return Err(RunFailure::bad_input(finding));
    }
    check_class(options.sheet.tolerance_class)?;
    let read: Vec<_> = paths.par_iter().map(|path| read::read_part(path, options)).collect();
    let mut series = document::series_of(read, options.sheet.tolerance_class);
    series.result.left_out.clone_from(&options.left_out);
    series.result.stated = options.statements.words();
    Ok(series)
}
