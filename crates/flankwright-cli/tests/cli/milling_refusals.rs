//! Cutters that do not fit a flank, as a user meets them: refused with a code, a key and a way out.

use crate::command::{example, run, write_job};

/// Example, changes, exit status, code, field.
type Case = (&'static str, &'static [(&'static str, &'static str)], i32, &'static str, &'static str);

const CASES: &[Case] = &[
    (
        "milling/internal-ring.toml",
        &[
            ("shape = \"ball\"", "shape = \"end-mill\""),
            ("tilt_deg = 14.0", "contact_height = 4.0"),
            ("cutting_length = 12.0", "cutting_length = 12.0\ncorner_radius = 0.5"),
        ],
        4,
        "gouge-local",
        "cutter",
    ),
    (
        "milling/internal-ring.toml",
        &[("diameter = 3.0", "diameter = 8.0"), ("cutting_length = 12.0", "cutting_length = 14.0")],
        4,
        "tool-gap",
        "cutter",
    ),
    (
        "milling/spiral-bevel-15.toml",
        &[("cutter_radius = 63.0", "cutter_radius = 12.0")],
        2,
        "flank-line-out-of-reach",
        "bevel",
    ),
    ("milling/straight-bevel-16.toml", &[("teeth = 24", "teeth = 25")], 2, "invalid-job", "mate.teeth"),
];

#[test]
fn a_cutter_that_does_not_fit_is_refused() {
    for (name, changes, exit, code, field) in CASES {
        let directory = tempfile::tempdir().unwrap();
        let path = write_job(directory.path(), example(name), changes);
        let output = directory.path().join("out");
        let run = run(&["plan", &path, "-o", output.to_str().unwrap(), "--json"]);
        assert_eq!(run.exit, Some(*exit), "{name} {changes:?}: {run:?}");
        let error = &run.json()["error"];
        assert_eq!((error["code"].as_str(), error["field"].as_str()), (Some(*code), Some(*field)), "{error}");
        assert!(!error["way_out"].as_str().unwrap().is_empty() && error["line"].is_u64(), "{error}");
    }
}
