//! Where the seeds of a target stand.

use flankwright::processes;
use std::fs;
use std::path::{Path, PathBuf};

/// The folder of the package.
pub fn package() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// Sorted names of a folder's entries.
pub fn names_in(folder: &Path) -> Vec<String> {
    let entries = fs::read_dir(folder).unwrap_or_else(|error| panic!("{}: {error}", folder.display()));
    let mut names: Vec<_> =
        entries.map(|entry| entry.expect("an entry").file_name().to_string_lossy().into_owned()).collect();
    names.sort();
    names
}

/// Seeds of `target`: its own, and the files of the project that its reader is for.
pub fn of_target(target: &str) -> Vec<Vec<u8>> {
    let root = package().parent().expect("the project");
    let own = package().join("seeds").join(target);
    let mut folders = Vec::from_iter(own.is_dir().then_some(own));
    folders.extend(match target {
        "job" => vec![root.join("examples")],
        "machine" => vec![root.join("machines")],
        "catalogue" => vec![root.join("examples/catalogue")],
        _ => vec![],
    });
    let mut seeds: Vec<_> = folders.iter().flat_map(|folder| files_in(folder)).collect();
    if target == "job" {
        seeds
            .extend(processes().formats().formats().iter().map(|format| format.template.as_bytes().to_vec()));
    }
    assert!(!seeds.is_empty(), "no seed for {target}");
    seeds
}

/// Every file of a folder in the order of the names; whole folders of examples count as well, results beside them do not.
fn files_in(folder: &Path) -> Vec<Vec<u8>> {
    let mut found = Vec::new();
    for name in names_in(folder).iter().filter(|name| !name.ends_with(".out")) {
        let path: PathBuf = folder.join(name);
        if path.is_dir() {
            found.extend(files_in(&path));
        } else {
            found.push(fs::read(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display())));
        }
    }
    found
}
