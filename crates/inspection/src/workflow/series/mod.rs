//! A series of measured parts: many files at once, read and evaluated side by side, brought into order, statistics per characteristic,
//! a sheet for each part. A refused file is reported and keeps no other from being evaluated.

mod characteristics;
mod data;
mod document;
mod figures;
mod folder;
mod read;
mod result;
mod summary;
mod tables;
mod write;

pub use characteristics::{is_followed, series_values};
pub use data::{InspectionSeries, SeriesOptions, StoredPart};
pub use folder::{PartsOfFolder, measured_parts_in};
pub use result::{
    InspectionSeriesResult, RefusedFile, SeriesCapability, SeriesCharacteristic, SeriesFigures,
    SeriesFinding, SeriesGroupResult, SeriesPartResult, SeriesTrend,
};
pub use summary::series_summary;
pub use write::write_inspection_series;

use super::judgement::check_class;
use job::Diagnostic;
use rayon::prelude::*;
use run::RunFailure;
use std::path::PathBuf;

/// The series of parts that were evaluated before; the limits are those of the parts.
pub fn series_of_stored(parts: Vec<StoredPart>) -> InspectionSeries {
    document::series_of(parts.into_iter().map(|part| Ok(read::ReadPart::of_stored(part))).collect(), None)
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
    series.language = options.language;
    series.result.left_out.clone_from(&options.left_out);
    series.result.stated = options.statements.words();
    Ok(series)
}
