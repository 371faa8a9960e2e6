//! The folder in which a job finds the files that it names: those that were handed in with it, and the machines of the program. It lies
//! among the temporary files and is gone with the work.

use std::collections::BTreeMap;
use std::fs;
use std::io;
use std::path::{Component, Path, PathBuf};

use flankwright::exchange::{AnyJob, JobError, Source, parse_any_job};
use tempfile::TempDir;

use crate::stock;
use crate::wire::Job;

/// Files with a job.
pub const MOST_FILES: usize = 32;
/// Characters of a name.
const LONGEST_NAME: usize = 200;
/// What a job is called in messages.
pub const JOB: &str = "job";
/// Where results go.
const RESULTS: &str = ".results";

/// A folder for one piece of work.
pub struct Shelf {
    folder: TempDir,
}

/// A file that cannot be put on a shelf.
#[derive(Debug, thiserror::Error)]
pub enum ShelfError {
    /// A name that is none.
    #[error(
        "`{0}` is no name of a file: it may have folders, but no `..`, no root and no control characters"
    )]
    Name(String),
    /// Too many.
    #[error("there are {0} files; a job may bring {MOST_FILES}")]
    TooMany(usize),
    /// The disk.
    #[error("the files cannot be put down: {0}")]
    Disk(#[from] io::Error),
}

impl Shelf {
    /// A shelf with the machines that the job may name and the files that came with it.
    ///
    /// # Errors
    /// [`ShelfError`].
    pub fn new(job: &Job) -> Result<Self, ShelfError> {
        let shelf = Self { folder: tempfile::Builder::new().prefix("flankwright-").tempdir()? };
        if job.text.contains("machines/") {
            for name in stock::machines() {
                if let Some(text) = stock::machine(&name) {
                    shelf.put(&format!("machines/{name}"), text.as_bytes())?;
                }
            }
        }
        shelf.put_all(&job.files)?;
        Ok(shelf)
    }

    fn put_all(&self, files: &BTreeMap<String, String>) -> Result<(), ShelfError> {
        if files.len() > MOST_FILES {
            return Err(ShelfError::TooMany(files.len()));
        }
        files.iter().try_for_each(|(name, text)| self.put(name, text.as_bytes()))
    }

    /// Puts a file down.
    ///
    /// # Errors
    /// [`ShelfError`].
    pub fn put(&self, name: &str, bytes: &[u8]) -> Result<(), ShelfError> {
        let path = self.folder.path().join(inner(name)?);
        if let Some(folder) = path.parent() {
            fs::create_dir_all(folder)?;
        }
        Ok(fs::write(path, bytes)?)
    }

    /// Where it is.
    pub fn path(&self) -> &Path {
        self.folder.path()
    }

    /// Where results are written.
    pub fn results(&self) -> PathBuf {
        self.folder.path().join(RESULTS)
    }

    /// Reads a job whose files are here.
    ///
    /// # Errors
    /// Everything that is wrong with it.
    pub fn load(&self, text: &str) -> Result<AnyJob, JobError> {
        parse_any_job(self.source(text))
    }

    /// The text of a job whose files are here.
    pub fn source(&self, text: &str) -> Source {
        Source::on_shelf(JOB, text, self.path())
    }

    /// A text of the program without the place of the shelf, which is nobody's business.
    pub fn tell(&self, text: &str) -> String {
        let place = self.folder.path().display().to_string();
        text.replace(&format!("{place}/{RESULTS}/"), "")
            .replace(&format!("{place}/"), "")
            .replace(&place, ".")
    }

    /// All files below the results, with `/` in their names, in order.
    ///
    /// # Errors
    /// A file that cannot be read.
    pub fn written(&self) -> io::Result<Vec<(String, Vec<u8>)>> {
        let mut found = Vec::new();
        let results = self.results();
        if results.exists() {
            collect(&results, "", &mut found)?;
        }
        found.sort();
        Ok(found)
    }
}

fn collect(folder: &Path, before: &str, found: &mut Vec<(String, Vec<u8>)>) -> io::Result<()> {
    for entry in fs::read_dir(folder)? {
        let entry = entry?;
        let name = format!("{before}{}", entry.file_name().to_string_lossy());
        if entry.file_type()?.is_dir() {
            collect(&entry.path(), &format!("{name}/"), found)?;
        } else {
            found.push((name, fs::read(entry.path())?));
        }
    }
    Ok(())
}

/// A name as a path below the shelf.
fn inner(name: &str) -> Result<PathBuf, ShelfError> {
    let refused = || ShelfError::Name(name.chars().take(80).collect());
    let path = Path::new(name);
    let plain = path.components().all(|step| matches!(step, Component::Normal(_)));
    let odd = name.chars().any(|c| c.is_control() || c == '\\') || name.starts_with('.');
    if name.is_empty() || name.len() > LONGEST_NAME || !plain || odd {
        return Err(refused());
    }
    Ok(path.to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_stay_below_the_shelf() {
        for name in ["a.csv", "catalogue/worms.csv", "über.csv"] {
            assert!(inner(name).is_ok(), "{name}");
        }
        for name in ["", "../a", "/a", "a/../../b", "a\\b", ".results/x", "a\0", &"x".repeat(201)] {
            assert!(inner(name).is_err(), "{name}");
        }
    }
}
