//! Which files make one part, the digest of their bytes, and the bytes themselves.

use std::collections::BTreeSet;
use std::fs::File;
use std::io::{self, Read};
use std::path::{Path, PathBuf};

use flankwright::exchange::rexs::MAXIMUM_FILE_BYTES;
use flankwright::exchange::{Diagnostic, open_regular};
use flankwright::workflow::inspection::{
    LeftOutFile, MeasuredFolder, MeasurementFile, Statements, files_of_measurement, measurements_in,
};

use super::refused_file::RefusedFile;
use crate::content::PartContent;
use crate::digest::{digest_of_reader, joined};

/// What paths name.
#[derive(Default)]
pub(super) struct FoundParts {
    /// The files of every part.
    pub parts: Vec<Vec<PathBuf>>,
    /// Paths that name nothing.
    pub refused: Vec<RefusedFile>,
    /// What folders hold beside measurements.
    pub left_out: Vec<LeftOutFile>,
}

/// The files of every part that the paths name, each part once: files, or folders with the measurements that lie in them, in the order of
/// their names. What names nothing is refused.
pub(super) fn parts_of(paths: &[PathBuf]) -> FoundParts {
    let FoundParts { mut parts, mut refused, mut left_out } = FoundParts::default();
    let mut seen = BTreeSet::new();
    for path in paths {
        let files = match path.is_dir().then(|| folder(path)) {
            None => vec![path.clone()],
            Some(Ok(of)) => {
                left_out.extend(of.left_out);
                of.measurements.into_iter().collect()
            }
            Some(Err(finding)) => {
                refused.push(RefusedFile::new(path, finding));
                continue;
            }
        };
        for file in files {
            let mut part = files_of_measurement(&file);
            // Curves before values, whichever was named.
            part.sort_by(|a, b| b.cmp(a));
            if seen.insert(part.clone()) {
                parts.push(part);
            }
        }
    }
    FoundParts { parts, refused, left_out }
}

fn folder(path: &Path) -> Result<MeasuredFolder, Diagnostic> {
    let found = measurements_in(path).map_err(|error| unreadable(path, &error))?;
    if found.measurements.is_empty() {
        return Err(Diagnostic::with_code("no-measurement", "the folder has no measurement")
            .field("FILE")
            .value(path.display())
            .allowed("a folder with .mka, .mew, .rexs, .rexsj or .rexsz files")
            .way_out("name the folder in which the files lie; folders inside of it are not searched"));
    }
    Ok(found)
}

fn unreadable(path: &Path, error: &io::Error) -> Diagnostic {
    Diagnostic::with_code("unreadable-file", format!("{} cannot be read: {error}", path.display()))
        .field("FILE")
        .value(path.display())
        .way_out("check the path and the permissions of the file")
}

/// The identity of a part: the digest of its file, of several that of their digests.
pub(super) fn digest_of_files(files: &[PathBuf]) -> Result<String, Diagnostic> {
    let digest = |path: &PathBuf| {
        // Readers take no more than this; whether a file is too large they say.
        let bounded = |file: File| digest_of_reader(file.take(MAXIMUM_FILE_BYTES as u64 + 1));
        open_regular(path).and_then(bounded).map_err(|error| unreadable(path, &error))
    };
    let digests = files.iter().map(digest).collect::<Result<Vec<String>, _>>()?;
    Ok(joined(&digests.iter().map(String::as_str).collect::<Vec<_>>()))
}

/// The files of a part as they go into the store.
///
/// # Errors
/// A file that cannot be read, or that is not any more what `digest` was made of.
pub(super) fn content_of_files(
    files: &[PathBuf],
    digest: &str,
    statements: &Statements,
) -> Result<PartContent, Diagnostic> {
    let read = |path: &PathBuf| {
        let whole = |file: File| {
            let mut bytes = Vec::new();
            file.take(MAXIMUM_FILE_BYTES as u64 + 1).read_to_end(&mut bytes).map(|_| bytes)
        };
        let bytes = open_regular(path).and_then(whole).map_err(|error| unreadable(path, &error))?;
        let name = path.file_name().map_or_else(|| "part".into(), |name| name.to_string_lossy().into_owned());
        Ok(MeasurementFile { name, bytes })
    };
    let files = files.iter().map(read).collect::<Result<Vec<MeasurementFile>, Diagnostic>>()?;
    let content = PartContent::new(&files, statements.clone());
    if content.digest() == digest {
        return Ok(content);
    }
    let first = files.first().map_or("", |file| file.name.as_str());
    Err(Diagnostic::with_code("file-changed", format!("{first} was changed while it was imported"))
        .field("FILE")
        .value(first)
        .allowed("a file that stays as it is")
        .way_out("import it again when the measuring machine has finished it"))
}
