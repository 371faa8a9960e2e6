//! What may stand under a name instead of a file.

use std::fs::{self, File};
use std::time::{Duration, Instant};

use super::readers::all;

/// Longest time in which a file is refused that is not read.
const MOMENT: Duration = Duration::from_secs(2);

#[test]
fn the_samples_are_taken() {
    for reader in all() {
        let found = reader.take(&reader.sample);
        assert!(matches!(found, Ok(1..)), "{}: {found:?}", reader.name);
    }
}

#[test]
fn absent_files_and_directories_are_named() {
    let directory = tempfile::tempdir().unwrap();
    for reader in all() {
        for path in [directory.path().join("absent"), directory.path().to_owned()] {
            let error = reader.answer(&path).unwrap_err();
            assert_eq!(error.code, "unreadable-file", "{}", reader.name);
            assert!(error.message.contains(path.to_str().unwrap()), "{}: {error:?}", reader.name);
        }
    }
}

#[cfg(unix)]
#[test]
fn pipes_and_devices_are_not_waited_for() {
    let directory = tempfile::tempdir().unwrap();
    let pipe = directory.path().join("pipe");
    assert!(std::process::Command::new("mkfifo").arg(&pipe).status().unwrap().success());
    for reader in all() {
        for path in [pipe.as_path(), std::path::Path::new("/dev/zero")] {
            let start = Instant::now();
            let error = reader.answer(path).unwrap_err();
            assert_eq!(error.code, "unreadable-file", "{}", reader.name);
            assert!(error.message.contains("pipe or a device"), "{}: {error:?}", reader.name);
            assert!(start.elapsed() < MOMENT, "{}", reader.name);
        }
    }
}

#[test]
fn a_file_of_one_gigabyte_is_refused_within_a_moment() {
    let directory = tempfile::tempdir().unwrap();
    for reader in all() {
        let path = directory.path().join(format!("sparse.{}", reader.ending));
        // It begins as a right file does.
        fs::write(&path, &reader.sample).unwrap();
        File::options().write(true).open(&path).unwrap().set_len(1 << 30).unwrap();
        let start = Instant::now();
        let error = reader.answer(&path).unwrap_err();
        assert_eq!(error.code, "file-too-large", "{}", reader.name);
        assert!(start.elapsed() < MOMENT, "{}", reader.name);
    }
}
