//! One part of a series: read, evaluated, its characteristics, its sheet; or why not.

use super::super::characteristics::{PartIdentity, part_characteristics};
use super::super::run::inspect_gear;
use super::super::sheet::inspection_sheet;
use super::characteristics::series_values;
use super::{RefusedFile, SeriesOptions, StoredPart};
use job::Diagnostic;
use metrology::inspection::SeriesPart;
use run::{JobFailure, RunFailure};
use std::path::Path;
use verdict::{Remark, Verdict};

/// A part that was evaluated.
pub(super) struct ReadPart {
    /// To which parts it belongs: those of one drawing, else of one name, else of one body.
    pub group: String,
    /// Its file.
    pub file: String,
    /// Label, time and values.
    pub part: SeriesPart,
    /// Class that it reaches.
    pub class: Option<i32>,
    /// Doubts of reading and evaluation.
    pub warnings: Vec<Remark>,
    /// What was judged by the class; nothing of a part that was evaluated before.
    pub verdict: Verdict,
    /// Its sheet; none where none was asked for.
    pub sheet: Option<String>,
}

impl ReadPart {
    /// A part without its sheet.
    pub fn of_stored(of: StoredPart) -> Self {
        let StoredPart { series, file, part } = of;
        Self {
            group: series,
            file,
            part,
            class: None,
            warnings: Vec::new(),
            verdict: Verdict::new(),
            sheet: None,
        }
    }
}

/// Reads and evaluates a part.
pub(super) fn read_part(path: &Path, options: &SeriesOptions) -> Result<ReadPart, RefusedFile> {
    let file = path
        .file_name()
        .map_or_else(|| path.to_string_lossy(), std::ffi::OsStr::to_string_lossy)
        .into_owned();
    let mut found = inspect_gear(path, &options.statements, options.sheet.tolerance_class)
        .map_err(|failure| refused(path, &file, &failure))?;
    found.language = options.language;
    let sheet = match options.without_sheets {
        true => None,
        false => Some(inspection_sheet(&found, &options.sheet).map_err(|error| RefusedFile {
            file: file.clone(),
            code: "sheet-not-drawn".into(),
            message: format!("its sheet cannot be drawn: {error}"),
            way_out: "look at the numbers of the file".into(),
        })?),
    };
    let PartIdentity { series, part, time } = PartIdentity::of(&found);
    let values = series_values(&part_characteristics(&found, options.sheet.tolerance_class));
    Ok(ReadPart {
        group: series,
        part: SeriesPart { label: part, time, values },
        class: found.result.class,
        file,
        sheet,
        warnings: found.result.warnings,
        verdict: found.result.verdict,
    })
}

fn refused(path: &Path, file: &str, failure: &JobFailure) -> RefusedFile {
    // The file is named beside its message.
    let named = format!("{}: ", path.display());
    let of = |finding: &Diagnostic| RefusedFile {
        file: file.into(),
        code: finding.code.into(),
        message: finding.message.strip_prefix(&named).unwrap_or(&finding.message).into(),
        way_out: finding.way_out.as_deref().unwrap_or_default().into(),
    };
    match failure {
        JobFailure::Job(RunFailure::BadInput(finding) | RunFailure::NotProducible(finding)) => of(finding),
        JobFailure::File(error) => error.diagnostics.first().map_or_else(
            || RefusedFile {
                file: file.into(),
                code: "unreadable-file".into(),
                message: "the file cannot be read".into(),
                way_out: "look at the file".into(),
            },
            of,
        ),
    }
}
