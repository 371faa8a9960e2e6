//! The folder of a server among the temporary files. Its name is the name under which the server owns runs; a lock tells others that it
//! is in use, so that what a killed server has left is taken out by the next one of the same store, which learns from it who is gone.

use std::fs::{self, File, TryLockError};
use std::io;
use std::path::{Path, PathBuf};
use std::time::Duration;

use tempfile::TempDir;

/// How folders of servers begin.
const PREFIX: &str = "flankwright-serve-";
/// How they begin until they are locked.
const NEW: &str = "flankwright-serve-new-";
/// The file that is locked as long as the server lives.
const LOCK: &str = "lock";
/// The file that names the store.
const STORE: &str = "store";
/// A folder of another store is left for so long to a server of that store.
const LEFT_ALONE: Duration = Duration::from_secs(3600);
/// Letters behind the prefix: enough that no other folder has them by chance.
const LETTERS: usize = 24;

/// The folder of this server.
#[derive(Debug)]
pub struct Scratch {
    path: PathBuf,
    owner: String,
    store: String,
    _lock: File,
}

impl Scratch {
    /// A folder for a new server with a store of this name.
    ///
    /// # Errors
    /// What the system says.
    pub fn new(store: String) -> io::Result<Self> {
        Self::within(&std::env::temp_dir(), store)
    }

    fn within(among: &Path, store: String) -> io::Result<Self> {
        // It gets the name by which others look for it when it is locked.
        let made = tempfile::Builder::new().prefix(NEW).rand_bytes(LETTERS).tempdir_in(among)?;
        let lock = File::create(made.path().join(LOCK))?;
        lock.lock()?;
        fs::write(made.path().join(STORE), &store)?;
        let name = made.path().file_name().map(|name| name.to_string_lossy().into_owned());
        let owner = name.unwrap_or_default().replace(NEW, "");
        let path = among.join(format!("{PREFIX}{owner}"));
        fs::rename(made.keep(), &path)?;
        Ok(Self { path, owner, store, _lock: lock })
    }

    /// The name of the server.
    pub fn owner(&self) -> &str {
        &self.owner
    }

    /// A folder for one piece of work; gone when it is dropped.
    ///
    /// # Errors
    /// What the system says.
    pub fn folder(&self) -> io::Result<TempDir> {
        // Whoever tidies the temporary files may have taken it.
        fs::create_dir_all(&self.path)?;
        tempfile::tempdir_in(&self.path)
    }

    /// A text without the place of the folder.
    pub fn tell(&self, text: &str) -> String {
        text.replace(&self.path.display().to_string(), "")
    }

    /// Takes out what servers have left that are gone; the names of those that had the same store.
    pub fn tidy(&self) -> Vec<String> {
        let among = self.path.parent().and_then(|among| fs::read_dir(among).ok());
        let folders = among.into_iter().flatten().flatten();
        folders.filter_map(|entry| self.left(&entry)).collect()
    }

    /// The name of a server that has left this folder; it is taken out.
    fn left(&self, entry: &fs::DirEntry) -> Option<String> {
        let owner = entry.file_name().to_str()?.strip_prefix(PREFIX)?.to_owned();
        if !entry.file_type().ok()?.is_dir() {
            return None;
        }
        let own = fs::read_to_string(entry.path().join(STORE)).is_ok_and(|store| store == self.store);
        let age = entry.metadata().and_then(|of| of.modified()).ok()?.elapsed().unwrap_or_default();
        if !own && age < LEFT_ALONE {
            return None;
        }
        let lock = match File::options().write(true).open(entry.path().join(LOCK)) {
            Ok(lock) => Some(lock),
            // Whoever tidies the temporary files, or was killed while it did, has left a part of it.
            Err(error) if error.kind() == io::ErrorKind::NotFound && age >= LEFT_ALONE => None,
            Err(_) => return None,
        };
        match lock.map_or(Ok(()), |lock| lock.try_lock()) {
            Ok(()) => fs::remove_dir_all(entry.path()).ok().map(|()| owner),
            Err(TryLockError::WouldBlock | TryLockError::Error(_)) => None,
        }
    }

    /// Takes the folder out, with what unfinished work has left.
    pub fn close(&self) {
        // What cannot be taken out now is taken out by the next server.
        drop(fs::remove_dir_all(&self.path));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_a_dead_server_has_left_is_taken_out() {
        let among = tempfile::tempdir().unwrap();
        let new = |store: &str| Scratch::within(among.path(), store.to_owned()).unwrap();
        let (first, second, other) = (new("a"), new("a"), new("b"));
        assert_ne!(first.owner(), second.owner());
        let work = first.folder().unwrap();
        assert!(second.tidy().is_empty() && work.path().exists(), "it lives");
        let (owner, path) = (first.owner().to_owned(), first.path.clone());
        let _left = work.keep();
        drop(first);
        assert!(other.tidy().is_empty() && path.exists(), "that of another store");
        assert_eq!(second.tidy(), [owner]);
        assert!(!path.exists());
        other.close();
        second.close();
        assert_eq!(fs::read_dir(among.path()).unwrap().count(), 0);
        // The folder comes back where somebody has taken it.
        assert!(second.folder().unwrap().path().exists());
    }
}
