//! Recomputes every expected number of a reference file and compares (`README.md#references-exit-status`). Knows the schemas of the
//! files and the library's public functions; contains no formula of its own beyond units and file conventions.
//!
//! ```no_run
//! use verify::{VerifyOptions, VerifySummary, verify_file};
//!
//! let report = verify_file("tests/reference/10-gears.json".as_ref(), &VerifyOptions::default())?;
//! let summary = VerifySummary::new(vec![report]);
//! assert_eq!(summary.exit_code(), 0);
//! # Ok::<(), verify::VerifyError>(())
//! ```

mod areas;
mod bodies;
mod contact;
mod decompositions;
mod dressing;
mod equal_ratio;
mod error;
mod expected;
mod gear_sets;
mod gearbox;
mod gears;
mod given;
mod ground_flank;
mod ground_modifications;
mod inspection;
mod least_squares;
mod ledger;
mod machines;
mod milling;
mod modifications;
mod planning;
mod reference;
mod report;
mod schema;
mod skiving;
mod step_simulation;
mod tangential;
mod technology;
mod terms;
mod variable_ratio;

pub use error::VerifyError;
pub use ledger::{Failure, NotRun, Worst};
pub use report::{FileReport, VerifySummary};
pub use schema::Schema;

use job::{Diagnostic, Problem, Source};
use ledger::Ledger;
use reference::Reference;
use serde_json::Value;
use std::path::{Path, PathBuf};

/// How reference files are checked.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct VerifyOptions {
    /// Directories in which data files named by a case are looked for, after the file's own directory and
    /// `../measurements/` beside it.
    pub data_directories: Vec<PathBuf>,
}

/// Checks one reference file; its schema is recognised from the content.
///
/// # Errors
/// [`VerifyError::Unreadable`], [`VerifyError::NotJson`], [`VerifyError::UnknownSchema`]. Numbers that disagree, unknown
/// quantities and cases that cannot be computed are no errors but failures in the report.
pub fn verify_file(path: &Path, options: &VerifyOptions) -> Result<FileReport, VerifyError> {
    let file = path.display().to_string();
    let source = Source::read(path).map_err(|error| {
        let none = || Diagnostic::new(Problem::UnreadableFile, format!("the file `{file}` cannot be read"));
        let finding = Box::new(error.diagnostics.into_iter().next().unwrap_or_else(none));
        VerifyError::Unreadable { file: file.clone(), finding }
    })?;
    let root: Value = serde_json::from_str(source.text()).map_err(|e| VerifyError::NotJson {
        file: file.clone(),
        line: e.line(),
        cause: e.to_string(),
    })?;
    let beside = path.parent().unwrap_or(Path::new("."));
    let mut data_directories = vec![beside.to_path_buf(), beside.join("../measurements")];
    data_directories.extend(options.data_directories.iter().cloned());
    verify_value(&file, &root, &VerifyOptions { data_directories })
}

/// Checks reference content that is already parsed; `file` is the name under which it is reported.
///
/// # Errors
/// [`VerifyError::UnknownSchema`].
pub fn verify_value(file: &str, root: &Value, options: &VerifyOptions) -> Result<FileReport, VerifyError> {
    let schema = Schema::recognise(root).ok_or_else(|| VerifyError::UnknownSchema {
        file: file.into(),
        found: schema::top_level_keys(root),
    })?;
    let mut ledger = Ledger::default();
    schema.check(&Reference::new(root, options), &mut ledger);
    Ok(FileReport::new(file, schema, ledger))
}
