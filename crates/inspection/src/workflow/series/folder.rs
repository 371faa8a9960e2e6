//! Which files of a folder are measurements that stand by themselves: one for each part.

use super::super::files::{LeftOutFile, MeasuredFolder, files_of_measurement, measurements_in};
use job::{Diagnostic, Problem};
use run::RunFailure;
use std::path::{Path, PathBuf};

/// What a folder holds of a series.
#[derive(Clone, Debug, Default)]
pub struct PartsOfFolder {
    /// A file for each part, by name.
    pub parts: Vec<PathBuf>,
    /// What may be meant as a part and is left out.
    pub left_out: Vec<LeftOutFile>,
}

/// Measurements in a folder, by name, without those in folders below it. Curves and values of one part count once; tables are left out,
/// since they do not tell which gear was measured.
///
/// # Errors
/// [`RunFailure`] for a folder that cannot be read, or that holds none.
pub fn measured_parts_in(directory: &Path) -> Result<PartsOfFolder, RunFailure> {
    let unreadable = |error: std::io::Error| {
        let message = format!("the folder {} cannot be read: {error}", directory.display());
        let finding = Diagnostic::new(Problem::UnreadableFile, message)
            .field("FOLDER")
            .value(directory.display())
            .way_out("name a folder that is there and may be read");
        RunFailure::bad_input(finding)
    };
    let MeasuredFolder { measurements: paths, left_out } = measurements_in(directory).map_err(unreadable)?;
    // The values of a part are read with its curves.
    let beside = |path: &PathBuf| {
        let first = files_of_measurement(path).into_iter().min();
        first.is_some_and(|first| first < *path && paths.contains(&first))
    };
    let alone: Vec<PathBuf> = paths.iter().filter(|path| !beside(path)).cloned().collect();
    if alone.is_empty() {
        let mut message = format!("the folder {} holds no measurement", directory.display());
        if let Some(first) = left_out.first() {
            message += &format!(" that can be evaluated; {}: {}", first.file, first.reason);
        }
        let finding = Diagnostic::with_code("no-measurements", message)
            .field("FOLDER")
            .value(directory.display())
            .allowed("files ending in .mka, .mew, .rexs, .rexsj, .rexsz")
            .way_out("name the folder with the files of the measuring machine");
        return Err(RunFailure::bad_input(finding));
    }
    Ok(PartsOfFolder { parts: alone, left_out })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_part_counts_once_and_folders_below_not_at_all() {
        let directory = tempfile::tempdir().unwrap();
        for name in ["a.mka", "a.mew", "b.MEW", "b.mka", "c.rexs", "series.csv", "notes.txt", "below/d.mka"] {
            job::write_atomically(&directory.path().join(name), b"x").unwrap();
        }
        let found = measured_parts_in(directory.path()).unwrap();
        let names: Vec<_> =
            found.parts.iter().map(|path| path.file_name().unwrap().to_str().unwrap()).collect();
        assert_eq!(names, ["a.mew", "b.MEW", "c.rexs"]);
        let left_out: Vec<_> = found.left_out.iter().map(|of| of.file.as_str()).collect();
        assert_eq!(left_out, ["below", "series.csv"]);
        for folder in ["below/none", "empty"] {
            let path = directory.path().join(folder);
            if folder == "empty" {
                std::fs::create_dir(&path).unwrap();
            }
            let RunFailure::BadInput(finding) = measured_parts_in(&path).unwrap_err() else {
                panic!("bad input")
            };
            assert!(finding.way_out.is_some() && finding.field.as_deref() == Some("FOLDER"));
        }
    }
}
