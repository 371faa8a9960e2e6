//! The measuring grid of a bevel gear as `plan` writes it, and paths that a compensation moves while the target stays.

use crate::milling_example::example;
use foundation::numerics::Silent;
use milling::job::{LoadedMillingJob, MillingCompensation};
use milling::workflow::{MillingOutcome, run_milling, write_milling};
use run::RunFailure;

fn bevel(more: &str) -> LoadedMillingJob {
    let changes = [
        ("[cutter]", more),
        ("rows = 14", "rows = 4"),
        ("columns = 15", "columns = 5"),
        ("rays_profile = 81", "rays_profile = 3"),
        ("rays_length = 31", "rays_length = 3"),
        ("contact_height = { from = 2.1, to = 3.0 }", "contact_height = 2.1"),
    ];
    example("straight-bevel-16", &changes)
}

fn planned(job: &LoadedMillingJob) -> MillingOutcome {
    match run_milling(job, &Silent) {
        Ok(outcome) => outcome,
        Err(RunFailure::BadInput(finding) | RunFailure::NotProducible(finding)) => panic!("{finding:?}"),
    }
}

#[test]
fn a_plan_writes_the_points_that_are_measured() {
    let folder = tempfile::tempdir().unwrap();
    let outcome = planned(&bevel("[measuring_grid]\nrows = 3\ncolumns = 4\n\n[cutter]"));
    write_milling(&outcome, folder.path()).unwrap();
    let text = std::fs::read_to_string(folder.path().join("measuring-grid.csv")).unwrap();
    let lines: Vec<&str> = text.lines().collect();
    assert_eq!(lines[0], "flank,row,column,roll_mm,along_mm,x_mm,y_mm,z_mm,nx,ny,nz");
    assert_eq!(lines.len(), 1 + 2 * 3 * 4);
    for (line, at) in lines[1..].iter().zip(&outcome.prepared.measuring_points) {
        let cells: Vec<&str> = line.split(',').collect();
        assert_eq!(
            (cells[0], cells[1], cells[2]),
            (at.flank.name(), &*at.row.to_string(), &*at.column.to_string())
        );
        let written: Vec<f64> = cells[5..].iter().map(|cell| cell.parse().unwrap()).collect();
        let wanted = at.point.iter().chain(at.normal.iter());
        assert!(written.iter().zip(wanted).all(|(a, b)| (a - b).abs() < 1e-6), "{line}");
    }
    // Without the table nothing is written.
    let plain = planned(&bevel("[cutter]"));
    let other = folder.path().join("plain");
    write_milling(&plain, &other).unwrap();
    assert!(!other.join("measuring-grid.csv").exists());
}

/// A table that leaves 30 um everywhere: rows stand so much farther out along the normal, points that are measured stay.
#[test]
fn a_compensation_moves_the_rows_and_not_the_target() {
    let grid = "[measuring_grid]\nrows = 3\ncolumns = 3\n\n[cutter]";
    let plain = bevel(grid);
    let mut moved = plain.clone();
    let left = serde_json::json!([{
        "kind": "grid", "flank": "both", "f_um": vec![vec![30.0; 4]; 4],
        "w_mm": [0.0, 30.0, 60.0, 100.0], "z_mm": [-50.0, -10.0, 10.0, 50.0],
    }]);
    moved.job.compensation =
        Some(MillingCompensation { modifications: serde_json::from_value(left).unwrap() });
    let [plain, moved] = [planned(&plain), planned(&moved)];
    assert_eq!(plain.prepared.measuring_points, moved.prepared.measuring_points);
    for (before, after) in plain.plan.flanks.iter().zip(&moved.plan.flanks) {
        let [low, high] = before.active.height_span();
        for share in [0.2, 0.5, 0.9] {
            let (height, length) =
                (low + share * (high - low), 0.5 * (before.active.face[0] + before.active.face[1]));
            let (a, b) =
                (before.active.surface.jet(height, length), after.active.surface.jet(height, length));
            // Transverse and normal are the same where teeth are straight.
            assert!(
                ((b.point - a.point).dot(&a.normal) - 0.03).abs() < 1e-6,
                "{}",
                (b.point - a.point).dot(&a.normal)
            );
        }
    }
}
