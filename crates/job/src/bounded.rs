//! The bytes of a file within a limit: what is too large is refused by its size before it is read, what may have no end is never
//! opened. Knows no format.

use std::fs::{self, File};
use std::io::{self, Read};
use std::path::Path;

/// Why a file was not read.
#[derive(Debug)]
pub enum Unread {
    /// The system's error, or that of [`open_regular`].
    System(io::Error),
    /// It holds more than allowed; how many bytes at least.
    TooLarge(usize),
}

/// Opens a file for reading. A pipe or a device is not opened: reading one may wait for an end that never comes.
///
/// # Errors
/// Those of the file system; [`io::ErrorKind::IsADirectory`]; [`io::ErrorKind::Unsupported`] for a pipe or a device.
pub fn open_regular(path: &Path) -> io::Result<File> {
    // Tested before opening, since opening a pipe waits for its writer.
    let kind = fs::metadata(path)?.file_type();
    if kind.is_dir() {
        return Err(io::Error::new(io::ErrorKind::IsADirectory, "it is a directory"));
    }
    if !kind.is_file() {
        let message = "it is a pipe or a device; save what it gives as a file";
        return Err(io::Error::new(io::ErrorKind::Unsupported, message));
    }
    File::open(path)
}

/// All bytes of a file that has at most `most`.
pub fn read_bounded(path: &Path, most: usize) -> Result<Vec<u8>, Unread> {
    let file = open_regular(path).map_err(Unread::System)?;
    let size = file.metadata().map_err(Unread::System)?.len();
    let size = usize::try_from(size).unwrap_or(usize::MAX);
    if size > most {
        return Err(Unread::TooLarge(size));
    }
    let mut bytes = Vec::with_capacity(size);
    // The size is only what the system says: the file may grow meanwhile.
    file.take(most as u64 + 1).read_to_end(&mut bytes).map_err(Unread::System)?;
    if bytes.len() > most { Err(Unread::TooLarge(bytes.len())) } else { Ok(bytes) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn size_decides_before_anything_is_read() {
        let directory = tempfile::tempdir().unwrap();
        let path = directory.path().join("sparse");
        File::create(&path).unwrap().set_len(1 << 40).unwrap();
        let start = std::time::Instant::now();
        assert!(matches!(read_bounded(&path, 10), Err(Unread::TooLarge(size)) if size == 1 << 40));
        assert!(start.elapsed().as_millis() < 500);
        fs::write(&path, b"0123456789").unwrap();
        assert_eq!(read_bounded(&path, 10).unwrap(), b"0123456789");
        assert!(matches!(read_bounded(&path, 9), Err(Unread::TooLarge(10))));
    }

    #[test]
    fn directories_and_absent_files_are_the_systems_errors() {
        let directory = tempfile::tempdir().unwrap();
        let kind = |path: &Path| open_regular(path).unwrap_err().kind();
        assert_eq!(kind(directory.path()), io::ErrorKind::IsADirectory);
        assert_eq!(kind(&directory.path().join("none")), io::ErrorKind::NotFound);
    }

    #[cfg(unix)]
    #[test]
    fn what_may_have_no_end_is_not_opened() {
        let directory = tempfile::tempdir().unwrap();
        let pipe = directory.path().join("pipe");
        assert!(std::process::Command::new("mkfifo").arg(&pipe).status().unwrap().success());
        let link = directory.path().join("link");
        std::os::unix::fs::symlink("/dev/zero", &link).unwrap();
        for path in [pipe.as_path(), Path::new("/dev/zero"), &link] {
            let error = open_regular(path).unwrap_err();
            assert_eq!(error.kind(), io::ErrorKind::Unsupported, "{path:?}");
            assert!(error.to_string().contains("pipe or a device"), "{error}");
        }
    }
}
