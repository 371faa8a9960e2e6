//! A gear whose flanks are given by points: milled within its tolerance, and tables that are none of a space refused with what to change.

use foundation::numerics::Silent;
use job::{Source, parse_job_of};
use milling::job::MillingJob;
use milling::workflow::{MillingOutcome, run_milling};
use run::RunFailure;
use std::fmt::Write;
use std::path::PathBuf;

type Points = Vec<[f64; 3]>;

const COUNTS: [usize; 2] = [7, 13];

fn examples() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../../examples/milling")
}

fn points(side: &str) -> Points {
    let text = std::fs::read_to_string(examples().join(format!("hypoid-{side}.csv"))).unwrap();
    let number = |cell: &str| cell.parse::<f64>().ok();
    text.lines()
        .filter_map(|line| {
            let cells: Option<Vec<f64>> = line.split(',').map(number).collect();
            cells?.try_into().ok()
        })
        .collect()
}

/// Runs the example with these tables and changes of its text, with few rows and rays.
fn run(name: &str, tables: [&Points; 2], changes: &[(&str, &str)]) -> Result<MillingOutcome, RunFailure> {
    let held = tempfile::tempdir().unwrap();
    let folder = held.path();
    for (side, points) in ["left", "right"].iter().zip(tables) {
        let mut text = "x_mm,y_mm,z_mm\n".to_owned();
        for [x, y, z] in points {
            writeln!(text, "{x},{y},{z}").unwrap();
        }
        std::fs::write(folder.join(format!("hypoid-{side}.csv")), text).unwrap();
    }
    let mut text = std::fs::read_to_string(examples().join("hypoid-wheel.toml")).unwrap();
    let few = [
        ("columns = 49", "columns = 25"),
        ("rows = 44", "rows = 24"),
        ("rays_profile = 81", "rays_profile = 31"),
        ("rays_length = 31", "rays_length = 7"),
    ];
    for (from, to) in few.iter().chain(changes) {
        assert!(text.contains(from), "{from}");
        text = text.replace(from, to);
    }
    let path = folder.join("job.toml");
    let source = Source::new(path.to_str().unwrap(), &text);
    let loaded = parse_job_of::<MillingJob>(source).unwrap_or_else(|error| panic!("{name}: {error}"));
    run_milling(&loaded, &Silent)
}

fn refused(name: &str, tables: [&Points; 2], changes: &[(&str, &str)]) -> (String, String) {
    match run(name, tables, changes) {
        Ok(_) => panic!("{name}: not refused"),
        Err(RunFailure::BadInput(finding)) => {
            assert!(finding.way_out.is_some(), "{finding}");
            (finding.field.as_deref().unwrap_or_default().to_owned(), finding.message.to_string())
        }
        Err(other) => panic!("{name}: {other:?}"),
    }
}

#[test]
fn flanks_by_points_are_milled() {
    let (left, right) = (points("left"), points("right"));
    assert_eq!(left.len(), COUNTS[0] * COUNTS[1]);
    let outcome = run("sound", [&left, &right], &[]).unwrap();
    for side in ["left", "right"] {
        let flank = &outcome.result.flanks[side];
        // Twenty-five columns: their straight blocks leave more than the forty-nine of the example.
        assert!(flank.max_deviation_um < 25.0, "{side}: {}", flank.max_deviation_um);
        assert!(flank.unmilled.is_empty(), "{side}: {:?}", flank.unmilled);
    }
    // The other keys count.
    let changes = [
        ("teeth = 41", "teeth = 40"),
        ("[66.5788, 92.8056]", "[66.0, 92.2]"),
        ("[68.7804, 95.6757]", "[69.0, 95.9]"),
    ];
    let other = run("other", [&left, &right], &changes).unwrap();
    assert_eq!(other.result.spaces[0], 40);
    let [bodies, before] = [&other, &outcome].map(|outcome| &outcome.prepared.bodies);
    assert!(bodies.floor != before.floor && bodies.blank != before.blank);
}

#[test]
fn tables_that_are_no_space_are_refused() {
    let (left, right) = (points("left"), points("right"));
    let swapped = refused("swapped", [&right, &left], &[]);
    assert!(swapped.0 == "grid_gear.left.file" && swapped.1.contains("left flank"), "{swapped:?}");
    let turned: Points = left.iter().rev().copied().collect();
    let rows = refused("rows", [&turned, &right], &[]);
    assert!(rows.0 == "grid_gear.right.file" && rows.1.contains("same way"), "{rows:?}");
    let upside_down =
        |points: &Points| -> Points { points.chunks(COUNTS[1]).rev().flatten().copied().collect() };
    let down = refused("down", [&upside_down(&left), &upside_down(&right)], &[]);
    assert!(down.1.contains("ascend"), "{down:?}");
    let rotate = |points: &Points| -> Points {
        let (sin, cos) = 0.1f64.sin_cos();
        points.iter().map(|[x, y, z]| [cos * x - sin * y, sin * x + cos * y, *z]).collect()
    };
    let beside = refused("beside", [&rotate(&left), &rotate(&right)], &[]);
    assert!(beside.0 == "grid_gear.left.file" && beside.1.contains("beside +y"), "{beside:?}");
    let high = refused("high", [&left, &right], &[("[66.5788, 92.8056]", "[70.5788, 96.8056]")]);
    assert!(high.1.contains("inside of the root body"), "{high:?}");
    let counts = refused(
        "counts",
        [&left, &right],
        &[("rows = 7, columns = 13 }\nright", "rows = 8, columns = 13 }\nright")],
    );
    assert!(counts.0 == "grid_gear.left.file" && counts.1.contains("91"), "{counts:?}");
}
