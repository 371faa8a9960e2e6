//! What each crate may know. Cargo refuses circles by itself; this table says which way is up, and a dependency that is not in it is a
//! decision to be made here first.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use toml_edit::DocumentMut;

/// Each crate with the crates of this project that its sources depend on. The referee shares no formula with what it judges: it stands
/// on the foundation alone, and neither contact nor a process knows it.
const CRATES: [(&str, &[&str]); 24] = [
    ("electronic-gearbox", &[]),
    ("nc", &[]),
    ("verdict", &[]),
    ("words", &[]),
    ("workspace-features", &[]),
    ("foundation", &["workspace-features"]),
    ("contact", &["foundation"]),
    ("referee", &["foundation"]),
    ("metrology", &["foundation"]),
    ("machine", &["foundation"]),
    ("motion", &["foundation", "machine", "nc"]),
    ("control", &["contact", "electronic-gearbox", "foundation"]),
    ("grinding", &["contact", "foundation"]),
    ("milling", &["foundation"]),
    ("skiving", &["foundation"]),
    ("report", &["foundation", "verdict"]),
    ("job", &["foundation", "machine", "skiving"]),
    ("measured-files", &["foundation", "job"]),
    (
        "flankwright",
        &[
            "contact",
            "control",
            "electronic-gearbox",
            "foundation",
            "grinding",
            "job",
            "machine",
            "measured-files",
            "metrology",
            "milling",
            "motion",
            "nc",
            "referee",
            "report",
            "skiving",
            "verdict",
            "workspace-features",
        ],
    ),
    (
        "verify",
        &[
            "contact",
            "control",
            "electronic-gearbox",
            "flankwright",
            "foundation",
            "grinding",
            "job",
            "machine",
            "measured-files",
            "metrology",
            "milling",
            "motion",
            "nc",
            "referee",
            "skiving",
        ],
    ),
    ("flankwright-store", &["flankwright"]),
    ("flankwright-server", &["flankwright", "flankwright-store"]),
    ("flankwright-cli", &["flankwright", "flankwright-server", "flankwright-store", "verify"]),
    ("flankwright-py", &["electronic-gearbox", "flankwright", "verify"]),
];

#[test]
fn crates_depend_on_what_this_table_allows() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let mut found = BTreeMap::new();
    for entry in fs::read_dir(&folder).expect("the crates") {
        let path = entry.expect("an entry").path().join("Cargo.toml");
        let text = fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
        let manifest: DocumentMut =
            text.parse().unwrap_or_else(|error| panic!("{}: {error}", path.display()));
        let name = path.parent().and_then(Path::file_name).expect("a name").to_string_lossy().into_owned();
        found.insert(name, own_dependencies(&manifest));
    }
    let allowed: BTreeMap<String, Vec<String>> = CRATES
        .iter()
        .map(|(name, own)| ((*name).to_owned(), own.iter().map(|own| (*own).to_owned()).collect()))
        .collect();
    assert_eq!(found, allowed);
}

/// Names of folders of the crates that a manifest names for its sources.
fn own_dependencies(manifest: &DocumentMut) -> Vec<String> {
    // Nothing of this project is for one platform only.
    assert!(manifest.get("target").is_none(), "dependencies of a platform are not looked at here");
    let mut own: Vec<String> = ["dependencies", "build-dependencies"]
        .iter()
        .filter_map(|kind| manifest.get(kind)?.as_table_like())
        .flat_map(|table| table.iter().map(|(name, _)| name.replace('_', "-")))
        .filter(|name| CRATES.iter().any(|(own, _)| own == name))
        .collect();
    own.sort();
    own
}
