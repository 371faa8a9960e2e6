//! What each crate may know. Cargo refuses circles by itself; this table says which way is up, and a dependency that is not in it is a
//! decision to be made here first.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use toml_edit::DocumentMut;

/// Each crate with the crates of this project that its sources depend on. The referee shares no formula with what it judges: it stands
/// on the foundation alone, and neither contact nor a process knows it. `finding` holds no formula, only how an error gives its code and
/// its way out: it is open to every crate but those that depend on none of ours.
const CRATES: [(&str, &[&str]); 36] = [
    ("electronic-gearbox", &[]),
    ("finding-derive", &[]),
    ("nc", &[]),
    ("verdict", &[]),
    ("words", &[]),
    ("workspace-features", &[]),
    ("electronic-gearbox-c", &["electronic-gearbox"]),
    ("finding", &["finding-derive"]),
    ("foundation", &["finding", "workspace-features"]),
    ("contact", &["finding", "foundation"]),
    ("machine", &["finding", "foundation"]),
    ("metrology", &["finding", "foundation"]),
    ("referee", &["finding", "foundation"]),
    ("dressing", &["contact", "finding", "foundation"]),
    ("job", &["finding", "foundation", "machine"]),
    ("measured-files", &["finding", "foundation", "job"]),
    ("report", &["finding", "foundation", "verdict"]),
    ("scene", &["finding", "foundation", "job"]),
    ("control", &["contact", "electronic-gearbox", "finding", "foundation"]),
    ("generating", &["contact", "dressing", "finding", "foundation"]),
    ("motion", &["finding", "foundation", "machine", "nc"]),
    ("grinding-technology", &["contact", "finding", "foundation", "motion"]),
    (
        "run",
        &[
            "control",
            "electronic-gearbox",
            "foundation",
            "job",
            "machine",
            "metrology",
            "motion",
            "nc",
            "referee",
            "report",
            "scene",
            "verdict",
        ],
    ),
    ("gearbox", &["control", "electronic-gearbox", "foundation", "job", "report", "run", "verdict"]),
    (
        "skiving",
        &[
            "finding",
            "foundation",
            "job",
            "machine",
            "metrology",
            "motion",
            "nc",
            "referee",
            "report",
            "run",
            "scene",
            "verdict",
        ],
    ),
    (
        "milling",
        &[
            "contact",
            "finding",
            "foundation",
            "job",
            "machine",
            "metrology",
            "motion",
            "nc",
            "referee",
            "report",
            "run",
            "scene",
            "verdict",
        ],
    ),
    (
        "generating-grinding",
        &[
            "contact",
            "control",
            "dressing",
            "electronic-gearbox",
            "foundation",
            "generating",
            "grinding-technology",
            "job",
            "machine",
            "metrology",
            "motion",
            "nc",
            "referee",
            "report",
            "run",
            "scene",
            "verdict",
        ],
    ),
    (
        "inspection",
        &[
            "contact",
            "dressing",
            "foundation",
            "generating",
            "generating-grinding",
            "job",
            "measured-files",
            "metrology",
            "milling",
            "referee",
            "report",
            "run",
            "verdict",
        ],
    ),
    (
        "tangential-dressing",
        &[
            "contact",
            "control",
            "dressing",
            "finding",
            "foundation",
            "generating",
            "generating-grinding",
            "job",
            "machine",
            "metrology",
            "motion",
            "nc",
            "referee",
            "report",
            "run",
            "scene",
            "verdict",
        ],
    ),
    (
        "flankwright",
        &[
            "contact",
            "control",
            "dressing",
            "electronic-gearbox",
            "foundation",
            "gearbox",
            "generating",
            "generating-grinding",
            "inspection",
            "job",
            "machine",
            "measured-files",
            "metrology",
            "milling",
            "motion",
            "nc",
            "referee",
            "report",
            "run",
            "scene",
            "skiving",
            "tangential-dressing",
            "verdict",
            "workspace-features",
        ],
    ),
    ("flankwright-store", &["finding", "flankwright"]),
    ("flankwright-server", &["flankwright", "flankwright-store"]),
    (
        "verify",
        &[
            "contact",
            "control",
            "dressing",
            "electronic-gearbox",
            "finding",
            "flankwright",
            "foundation",
            "generating",
            "grinding-technology",
            "job",
            "machine",
            "measured-files",
            "metrology",
            "milling",
            "motion",
            "nc",
            "referee",
            "skiving",
            "tangential-dressing",
        ],
    ),
    ("flankwright-py", &["electronic-gearbox", "flankwright", "verify"]),
    ("flankwright-cli", &["flankwright", "flankwright-server", "flankwright-store", "verify"]),
    ("sample-process", &["flankwright", "flankwright-cli"]),
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
