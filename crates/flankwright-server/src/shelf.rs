//! The folder in which a job finds the files that it names: those that were uploaded with it, and the machines of the program. It lies
//! in the folder of the server and is gone with the work.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::io;
use std::path::{Component, Path, PathBuf};

use flankwright::exchange::{AnyJob, JobError, Source, parse_any_job};
use tempfile::TempDir;

use crate::scratch::Scratch;
use crate::stock;

/// Files with a job.
pub const MOST_FILES: usize = 32;
/// Bytes of a name.
const LONGEST_NAME: usize = 200;
/// What a job is called in messages.
pub const JOB: &str = "job";
/// Where results go, and where measurements lie; uploaded names do not begin with a dot.
const RESULTS: &str = ".results";
const MEASURED: &str = ".measured";

/// A folder for one piece of work.
pub struct Shelf {
    folder: TempDir,
}

/// A file that cannot be put on a shelf.
#[derive(Debug, thiserror::Error)]
pub enum ShelfError {
    /// A name that is none.
    #[error(
        "`{0}` is no name of a file: it may have folders, but no `..`, no root, no control characters and no hidden files, and at most \
         {LONGEST_NAME} bytes"
    )]
    Name(String),
    /// A name that is the folder of another.
    #[error("`{0}` is a file and the folder of another one")]
    Folder(String),
    /// Too many.
    #[error("there are {0} files; a job may bring {MOST_FILES}")]
    TooMany(usize),
    /// The disk of the server.
    #[error("the server cannot put the files down: {}", .0.kind())]
    Disk(#[from] io::Error),
}

/// Whether files can be put on a shelf.
///
/// # Errors
/// [`ShelfError`], all but `Disk`.
pub fn fit(files: &BTreeMap<String, String>) -> Result<(), ShelfError> {
    if files.len() > MOST_FILES {
        return Err(ShelfError::TooMany(files.len()));
    }
    files.keys().try_for_each(|name| inner(name).map(drop))?;
    let machines: BTreeSet<String> =
        stock::machines().iter().map(|name| format!("machines/{name}")).collect();
    let names = || files.keys().chain(&machines);
    let mut folders = names().flat_map(|name| name.match_indices('/').map(|(end, _)| &name[..end]));
    match folders.find(|folder| files.contains_key(*folder) || machines.contains(*folder)) {
        Some(folder) => Err(ShelfError::Folder(shown(folder))),
        None => Ok(()),
    }
}

impl Shelf {
    /// A shelf for a job of this text with its files.
    ///
    /// # Errors
    /// [`ShelfError`].
    pub fn of_job(
        scratch: &Scratch,
        text: &str,
        files: &BTreeMap<String, String>,
    ) -> Result<Self, ShelfError> {
        Self::new(scratch, files, text.contains("machines/"))
    }

    /// A shelf with files and, where they may be named, the machines of the program.
    ///
    /// # Errors
    /// [`ShelfError`].
    pub fn new(
        scratch: &Scratch,
        files: &BTreeMap<String, String>,
        machines: bool,
    ) -> Result<Self, ShelfError> {
        fit(files)?;
        let shelf = Self { folder: scratch.folder()? };
        if machines {
            for name in stock::machines() {
                if let Some(text) = stock::machine(&name) {
                    shelf.put(&format!("machines/{name}"), text.as_bytes())?;
                }
            }
        }
        files.iter().try_for_each(|(name, text)| shelf.put(name, text.as_bytes()))?;
        Ok(shelf)
    }

    fn put(&self, name: &str, bytes: &[u8]) -> Result<(), ShelfError> {
        let path = self.folder.path().join(inner(name)?);
        if let Some(folder) = path.parent() {
            fs::create_dir_all(folder)?;
        }
        Ok(fs::write(path, bytes)?)
    }

    /// Where results are written.
    pub fn results(&self) -> PathBuf {
        self.folder.path().join(RESULTS)
    }

    /// Where measurements lie.
    pub fn measured(&self) -> PathBuf {
        self.folder.path().join(MEASURED)
    }

    /// Reads a job whose files are here.
    ///
    /// # Errors
    /// Everything that is wrong with it.
    pub fn load(&self, text: &str) -> Result<AnyJob, JobError> {
        // Refused as a file of the same content would be.
        parse_any_job(Source::from_bytes(JOB, text.as_bytes())?.confined_to(self.folder.path()))
    }

    /// The text of a job whose files are here.
    pub fn source(&self, text: &str) -> Source {
        Source::new(JOB, text).confined_to(self.folder.path())
    }

    /// A text of the program without the path of the folder, which the client must not see.
    pub fn tell(&self, text: &str) -> String {
        let place = self.folder.path().display().to_string();
        [format!("{place}/{RESULTS}/"), format!("{place}/{MEASURED}/"), format!("{place}/")]
            .iter()
            .fold(text.to_owned(), |text, inner| text.replace(inner, ""))
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
    let path = Path::new(name);
    let plain = path.components().all(|step| matches!(step, Component::Normal(_)));
    let odd = name.chars().any(|c| c.is_control() || c == '\\')
        || name.split('/').any(|step| step.is_empty() || step.starts_with('.'));
    if name.is_empty() || name.len() > LONGEST_NAME || !plain || odd {
        return Err(ShelfError::Name(shown(name)));
    }
    Ok(path.to_owned())
}

/// The beginning of a name, marked where it was longer.
fn shown(name: &str) -> String {
    let mut letters = name.chars();
    let beginning: String = letters.by_ref().take(80).collect();
    if letters.next().is_some() { beginning + "..." } else { beginning }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_stay_below_the_shelf() {
        for name in ["a.csv", "catalogue/worms.csv", "über.csv"] {
            assert!(inner(name).is_ok(), "{name}");
        }
        for name in [
            "",
            "../a",
            "/a",
            "a/../../b",
            "a\\b",
            ".results/x",
            "a/.b",
            "a//b",
            "a/",
            "a\0",
            &"x".repeat(201),
        ] {
            assert!(inner(name).is_err(), "{name}");
        }
        assert_eq!(shown(&"x".repeat(81)).len(), 83);
    }

    #[test]
    fn no_file_is_the_folder_of_another() {
        let files = |names: &[&str]| names.iter().map(|name| ((*name).to_owned(), String::new())).collect();
        assert!(fit(&files(&["a/b/c", "a/d", "ab"])).is_ok());
        assert!(matches!(fit(&files(&["a/b/c", "a/b"])), Err(ShelfError::Folder(name)) if name == "a/b"));
        // The machines of the program are there as well, and may be replaced.
        for (name, ok) in
            [("machines", false), ("machines/eight-axis.toml/x", false), ("machines/eight-axis.toml", true)]
        {
            assert_eq!(fit(&files(&[name])).is_ok(), ok, "{name}");
        }
    }
}
