//! Jobs with laws of the shift, areas, cones and tools without a dresser that cannot be: code, key, status, way out.

use crate::command::{Run, example, repository, run};

/// `plan --json` of an example with one text replaced.
fn changed(name: &str, from: &str, to: &str) -> Run {
    let text = example(name);
    assert!(text.contains(from), "{name} has no {from}");
    let directory = tempfile::tempdir().unwrap();
    let path = directory.path().join("job.toml");
    std::fs::write(&path, text.replace(from, to)).unwrap();
    std::fs::copy(
        repository().join("examples/variable-ratio.csv"),
        directory.path().join("variable-ratio.csv"),
    )
    .unwrap();
    let out = directory.path().join("out");
    run(&["plan", "--json", path.to_str().unwrap(), "-o", out.to_str().unwrap()])
}

const CURVE: &str = r#"curve = { kind = "line_blend", slope = 1.2, w_t_mm = 13.0, h_mm = 4.0, z_e_mm = 9.0, flank = "right" }"#;

/// Example, text, its replacement, exit status, code, key, a part of the way out.
const CASES: &[(&str, &str, &str, i32, &str, &str, &str)] = &[
    (
        "two-end-reliefs.toml",
        "length_z_mm = 9.0",
        "length_z_mm = 24.0",
        4,
        "areas-overlap",
        "grinding.diagonal_ratio",
        "shorten the regions",
    ),
    (
        "two-end-reliefs.toml",
        "roughing_areas = 1",
        "free_ratio = 0.6",
        4,
        "worm-lines-shared",
        "grinding.diagonal_ratio",
        "keep its sign",
    ),
    (
        "two-end-reliefs.toml",
        "width = 160.0",
        "width = 40.0",
        4,
        "worm-too-short",
        "worm.width",
        "wider worm",
    ),
    (
        "two-end-reliefs.toml",
        "roughing_areas = 1",
        "areas = 9",
        4,
        "worm-too-short",
        "grinding.areas",
        "fewer areas",
    ),
    (
        "waviness.toml",
        "diagonal_ratio = \"auto\"",
        "diagonal_ratio = \"areas\"",
        2,
        "no-region",
        "grinding.diagonal_ratio",
        "\"auto\"",
    ),
    (
        "variable-ratio.toml",
        "slope = 1.2",
        "slope = -0.3394",
        2,
        "curve-not-a-function",
        "grinding.diagonal_ratio.curve",
        "crosses the contact paths",
    ),
    (
        "variable-ratio.toml",
        CURVE,
        "table = { z_v2_mm = [-5.0, 0.0, 5.0, 9.0], z_v1_mm = [-5.0, 0.0, 5.0, 7.0] }",
        2,
        "range-not-covered",
        "grinding.diagonal_ratio.table",
        "reach over the feed",
    ),
    (
        "variable-ratio.toml",
        CURVE,
        "table = { z_v2_mm = [-30.0, -10.0, 10.0, 30.0], z_v1_mm = [-5.0, 15.0, 5.0, 27.0] }",
        2,
        "law-not-monotone",
        "grinding.diagonal_ratio.table",
        "rises or falls everywhere",
    ),
    (
        "beveloid-conical-worm.toml",
        "diagonal_ratio = -1.0",
        "diagonal_ratio = \"areas\"",
        2,
        "cylindrical-only",
        "grinding.diagonal_ratio",
        "table",
    ),
    (
        "beveloid-cylindrical-worm.toml",
        "width = 120.0",
        "cone_angle_deg = 2.0",
        2,
        "conical-worm-without-width",
        "worm.width",
        "worm.width, in mm",
    ),
    ("hob.toml", "width = 120.0\n", "", 2, "missing-key", "worm.width", "give worm.width"),
];

#[test]
fn impossible_shifts_and_tools_are_named_with_a_way_out() {
    for (name, from, to, exit, code, field, way_out) in CASES {
        let run = changed(name, from, to);
        assert_eq!(run.exit, Some(*exit), "{name} {code}: {run:?}");
        let error = &run.json()["error"];
        assert_eq!(error["code"], *code, "{name}: {error}");
        assert_eq!(error["field"], *field, "{name} {code}: {error}");
        let said = error["way_out"].as_str().unwrap();
        assert!(!said.is_empty() && said.contains(way_out), "{name} {code}: {said}");
    }
}
