//! The files of a run as one set: a reader finds the old set, the new one, or a folder without its document, which is then
//! incomplete. Two runs on one folder follow one another. A disk that is full leaves the old set.

use super::write_error::WriteError;
use std::fs::{self, File, TryLockError};
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

/// How long a run waits for another one that writes into the same folder: writing takes a fraction of a second.
const PATIENCE: Duration = Duration::from_secs(30);

/// End of the names under which new files lie beside the old ones until all are there.
const PARTIAL: &str = ".flankwright-partial";

/// A file below the folder: its path, with `/` between folders, and its bytes.
pub type SetFile<'a> = (&'a str, &'a [u8]);

/// Writes the files of a run into `directory` (made if missing), the document first among `files`; of the names in `known` those that
/// this run does not write are removed. Returns the paths in the order of `files`.
///
/// All bytes are on the disk under other names before the first old file goes. Then the old document is removed, the files take
/// their names, and the new document takes its own last: a folder that has one is whole.
pub fn write_set(
    directory: &Path,
    files: &[SetFile<'_>],
    known: &[&str],
) -> Result<Vec<PathBuf>, WriteError> {
    let failed = |path: &Path| {
        let path = path.to_owned();
        move |source| WriteError::Io { path, source }
    };
    if directory.is_file() {
        let is_file = io::Error::new(io::ErrorKind::NotADirectory, "it is a file, not a directory");
        return Err(failed(directory)(is_file));
    }
    fs::create_dir_all(directory).map_err(failed(directory))?;
    let _lock = lock(directory)?;
    let paths: Vec<PathBuf> = files.iter().map(|(name, _)| directory.join(name)).collect();
    let mut set = Partial { paths: Vec::with_capacity(files.len()) };
    for ((_, bytes), path) in files.iter().zip(&paths) {
        let partial = partial_name(path);
        let written = (|| {
            fs::create_dir_all(path.parent().unwrap_or(directory))?;
            let mut file = File::create(&partial)?;
            set.paths.push(partial.clone());
            file.write_all(bytes)
        })();
        written.map_err(failed(path))?;
        if path.is_dir() {
            return Err(failed(path)(io::Error::from(io::ErrorKind::IsADirectory)));
        }
    }
    if let Some(document) = paths.first() {
        remove(document)?;
    }
    let stale = known.iter().filter(|name| !files.iter().any(|(written, _)| written == *name));
    for name in stale {
        remove(&directory.join(name))?;
    }
    for path in paths.iter().skip(1).chain(paths.first()) {
        fs::rename(partial_name(path), path).map_err(failed(path))?;
    }
    set.paths.clear();
    Ok(paths)
}

/// New files beside the old ones; whatever is left of them when the writing ends goes.
struct Partial {
    paths: Vec<PathBuf>,
}

impl Drop for Partial {
    fn drop(&mut self) {
        for path in &self.paths {
            // Those that have taken their names are not there any more.
            let _ = fs::remove_file(path);
        }
    }
}

/// The same name for every run, so that what a killed run leaves is overwritten by the next.
fn partial_name(path: &Path) -> PathBuf {
    let mut name = std::ffi::OsString::from(".");
    name.push(path.file_name().unwrap_or_default());
    name.push(PARTIAL);
    path.with_file_name(name)
}

fn remove(path: &Path) -> Result<(), WriteError> {
    match fs::remove_file(path) {
        Err(source) if source.kind() != io::ErrorKind::NotFound => {
            Err(WriteError::Io { path: path.to_owned(), source })
        }
        _ => Ok(()),
    }
}

/// Holds the folder until dropped; the system lets go of it when a program dies.
fn lock(directory: &Path) -> Result<File, WriteError> {
    let (path, handle) = lockable(directory);
    let file = handle.map_err(|source| WriteError::Io { path: path.clone(), source })?;
    let begun = Instant::now();
    loop {
        match file.try_lock() {
            Ok(()) => return Ok(file),
            Err(TryLockError::WouldBlock) if begun.elapsed() < PATIENCE => {
                std::thread::sleep(Duration::from_millis(20));
            }
            Err(TryLockError::WouldBlock) => return Err(WriteError::Busy { path: directory.to_owned() }),
            // File systems without locks: the set is still written as a whole, nobody else is kept out.
            Err(TryLockError::Error(error)) if error.kind() == io::ErrorKind::Unsupported => return Ok(file),
            Err(TryLockError::Error(source)) => return Err(WriteError::Io { path, source }),
        }
    }
}

/// What is locked: the folder itself, where the system can, so that no file of ours stays in it.
#[cfg(unix)]
fn lockable(directory: &Path) -> (PathBuf, io::Result<File>) {
    (directory.to_owned(), File::open(directory))
}

#[cfg(not(unix))]
fn lockable(directory: &Path) -> (PathBuf, io::Result<File>) {
    let path = directory.join(".flankwright-lock");
    let file = fs::OpenOptions::new().create(true).truncate(false).write(true).open(&path);
    (path, file)
}

#[cfg(test)]
mod tests {
    use super::*;

    const KNOWN: [&str; 3] = ["result.json", "report.html", "programs/a.ngc"];

    fn write(directory: &Path, mark: &str, names: &[&str]) -> Result<Vec<PathBuf>, WriteError> {
        let bytes = mark.as_bytes().repeat(2000);
        let files: Vec<SetFile<'_>> = names.iter().map(|name| (*name, &bytes[..])).collect();
        write_set(directory, &files, &KNOWN)
    }

    /// First bytes of all files in a folder and its folders, by path.
    fn found(directory: &Path) -> Vec<(String, String)> {
        let mut found = Vec::new();
        let mut folders = vec![directory.to_owned()];
        while let Some(folder) = folders.pop() {
            for entry in fs::read_dir(folder).unwrap() {
                let path = entry.unwrap().path();
                if path.is_dir() {
                    folders.push(path);
                } else {
                    let name = path.strip_prefix(directory).unwrap().display().to_string();
                    found.push((name, fs::read_to_string(&path).unwrap()[..3].to_owned()));
                }
            }
        }
        found.sort();
        found
    }

    #[test]
    fn a_set_replaces_the_one_before() {
        let directory = tempfile::tempdir().unwrap();
        let out = directory.path().join("deep/out");
        let paths = write(&out, "one", &["result.json", "programs/a.ngc", "report.html"]).unwrap();
        assert_eq!(paths.last().unwrap(), &out.join("report.html"));
        fs::write(out.join("own.txt"), "own").unwrap();
        write(&out, "two", &["result.json", "report.html"]).unwrap();
        let of = |name: &str, mark: &str| (name.to_owned(), mark.to_owned());
        assert_eq!(found(&out), [of("own.txt", "own"), of("report.html", "two"), of("result.json", "two")]);
    }

    #[test]
    fn what_cannot_be_written_leaves_the_old_set() {
        let directory = tempfile::tempdir().unwrap();
        write(directory.path(), "one", &["result.json", "report.html"]).unwrap();
        let before = found(directory.path());
        // A folder of that name is in the way, as late as possible.
        fs::create_dir(directory.path().join("topography.csv")).unwrap();
        let error =
            write(directory.path(), "two", &["result.json", "report.html", "topography.csv"]).unwrap_err();
        assert!(error.to_string().contains("topography.csv"), "{error}");
        assert_eq!(found(directory.path()), before);
    }

    #[test]
    fn two_runs_at_once_do_not_mix() {
        let directory = tempfile::tempdir().unwrap();
        let names = ["result.json", "report.html", "programs/a.ngc"];
        std::thread::scope(|scope| {
            for mark in ["one", "two", "six"] {
                let out = directory.path();
                scope.spawn(move || (0..20).for_each(|_| drop(write(out, mark, &names).unwrap())));
            }
        });
        let found = found(directory.path());
        assert_eq!(found.len(), 3);
        assert!(found.iter().all(|(_, mark)| *mark == found[0].1), "{found:?}");
    }
}
