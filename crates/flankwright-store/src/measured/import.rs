//! Imports the files of many measurements: evaluates them on all cores, stores them set by set, tells what became of each.

use std::path::{Path, PathBuf};

use flankwright::exchange::Diagnostic;
use flankwright::numerics::Progress;
use flankwright::workflow::inspection::{LeftOutFile, Statements, inspect_gear};
use flankwright::workflow::{JobFailure, RunFailure};
use rayon::prelude::*;
use schemars::JsonSchema;
use serde::Serialize;
use serde_json::json;

use super::files::{FoundParts, content_of_files, digest_of_files, parts_of};
use super::refused_file::RefusedFile;
use crate::blocking::Store;
use crate::check;
use crate::error::StoreError;
use crate::records::{MeasuredPart, PartRecord, PartSummary};

/// What holds for all files of an import.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ImportSettings {
    /// Series of the parts, instead of drawing, name or body of each.
    pub series: Option<String>,
    /// Class of ISO 1328-1 whose tolerances are the limits; none means no limits.
    pub class: Option<i32>,
    /// What the files do not tell.
    pub statements: Statements,
    /// Evaluates what is known once more and puts it in the place of what is stored.
    pub again: bool,
}

/// What became of the files.
#[derive(Clone, Debug, Default, PartialEq, Serialize, JsonSchema)]
pub struct MeasurementReport {
    /// New parts, and those that were evaluated again, in the order of the files.
    pub imported: Vec<PartSummary>,
    /// How many of them took the place of stored ones.
    pub replaced: usize,
    /// Parts whose files have the content of a part that is there, or of one before them.
    pub known: Vec<KnownPart>,
    /// Parts among the known ones whose files were put beside their values; earlier imports had not kept them.
    pub completed: usize,
    /// What could not be imported, and why.
    pub refused: Vec<RefusedFile>,
    /// What lies beside measurements in folders.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub left_out: Vec<LeftOutFile>,
}

/// A part that was there already.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct KnownPart {
    /// Its first file.
    pub file: String,
    /// The digest by which it is known.
    pub digest: String,
}

/// What became of one part before it is stored.
enum Looked {
    Refused(RefusedFile),
    New(Box<MeasuredPart>, String),
}

impl Store {
    /// Imports measurements: files, or folders with files. A file that is refused does not keep the others out. What is known is not
    /// evaluated again, so that an import that was interrupted is completed by doing the same once more.
    ///
    /// # Errors
    /// Those of the database; the sets before are in the store.
    pub fn import_measurements(
        &self,
        paths: &[PathBuf],
        settings: &ImportSettings,
        progress: &dyn Progress,
    ) -> Result<MeasurementReport, StoreError> {
        let FoundParts { parts, refused, left_out } = parts_of(paths);
        let mut report = MeasurementReport { refused, left_out, ..MeasurementReport::default() };
        progress.start("measurements", parts.len() as u64);
        for set in parts.chunks(Self::BATCH) {
            self.import_set(set, settings, &mut report)?;
            progress.advance(set.len() as u64);
        }
        progress.finish();
        Ok(report)
    }

    fn import_set(
        &self,
        set: &[Vec<PathBuf>],
        settings: &ImportSettings,
        report: &mut MeasurementReport,
    ) -> Result<(), StoreError> {
        let mut unknown: Vec<(&Vec<PathBuf>, String)> = Vec::with_capacity(set.len());
        let digests: Vec<Result<String, Diagnostic>> =
            set.par_iter().map(|files| digest_of_files(files)).collect();
        let found: Vec<&str> = digests.iter().flatten().map(String::as_str).collect();
        let there = self.known_parts(&found)?;
        let bare = self.parts_without_content(&found)?;
        for (files, digest) in set.iter().zip(digests) {
            match digest {
                Err(finding) => report.refused.push(RefusedFile::new(&files[0], finding)),
                Ok(digest) if there.contains(&digest) && !settings.again => {
                    if bare.contains(&digest) {
                        report.completed += usize::from(self.complete(files, &digest, settings)?);
                    }
                    report.known.push(known(files, digest));
                }
                Ok(digest) => unknown.push((files, digest)),
            }
        }
        let looked: Vec<Looked> =
            unknown.into_par_iter().map(|(files, digest)| look(files, digest, settings)).collect();
        let (mut parts, mut names) = (Vec::new(), Vec::new());
        for one in looked {
            match one {
                Looked::Refused(file) => report.refused.push(file),
                Looked::New(part, file) => {
                    parts.push(*part);
                    names.push(file);
                }
            }
        }
        let stored = self.import_measured(&parts, settings.again)?;
        report.replaced += stored.replaced;
        for (place, (part, file)) in parts.into_iter().zip(names).enumerate() {
            if stored.known.contains(&place) {
                // The same bytes twice in this set, or another program was faster.
                report.known.push(KnownPart { file, digest: part.record.digest });
            } else {
                report.imported.push(part.into_summary());
            }
        }
        Ok(())
    }

    /// Puts the files of a part beside its values. What is stated about them now must be what the part was evaluated with: with anything
    /// else the stored values would not be those of the files.
    fn complete(
        &self,
        files: &[PathBuf],
        digest: &str,
        settings: &ImportSettings,
    ) -> Result<bool, StoreError> {
        let Some(part) = self.part(digest)? else { return Ok(false) };
        let stated = part.document.get("stated").cloned().unwrap_or_else(|| json!([]));
        if stated != json!(settings.statements.words()) {
            return Ok(false);
        }
        match content_of_files(files, digest, &settings.statements) {
            Ok(content) => self.complete_part(&content),
            // It is known all the same; the next import tries again.
            Err(_) => Ok(false),
        }
    }
}

fn known(files: &[PathBuf], digest: String) -> KnownPart {
    KnownPart { file: files[0].display().to_string(), digest }
}

fn look(files: &[PathBuf], digest: String, settings: &ImportSettings) -> Looked {
    let file: &Path = &files[0];
    let part = inspect_gear(file, &settings.statements, None).map_err(first_finding).and_then(|found| {
        // Without class and job a reason says that nothing could be evaluated.
        if let Some(reason) = found.result.verdict.reason() {
            let finding = Diagnostic::with_code(reason.code, reason.text.clone());
            return Err(finding.field("FILE").value(file.display()).way_out(reason.way_out.clone()));
        }
        let content = content_of_files(files, &digest, &settings.statements)?;
        let mut record =
            PartRecord::of_inspection(&found, digest, settings.class).map_err(|error| error.finding())?;
        if let Some(series) = &settings.series {
            record.series.clone_from(series);
        }
        check::part(0, &record)?;
        Ok(MeasuredPart { record, content })
    });
    match part {
        Ok(part) => Looked::New(Box::new(part), file.display().to_string()),
        Err(finding) => Looked::Refused(RefusedFile::new(file, finding)),
    }
}

fn first_finding(failure: JobFailure) -> Diagnostic {
    match failure {
        JobFailure::Job(RunFailure::BadInput(finding) | RunFailure::NotProducible(finding)) => *finding,
        JobFailure::File(error) => {
            let told = error.to_string();
            error.diagnostics.into_iter().next().unwrap_or_else(|| Diagnostic::with_code("bad-input", told))
        }
    }
}
