//! What a job with a disc in point contact writes, taken at its word: the tables are read back from the files and driven by the
//! referee, and a gear is ground by the worm that the lines leave, scallops and all.

use foundation::geometry::{Flank, Sides};
use foundation::kinematics::{DressingPath, MotionLaw};
use foundation::numerics::{Silent, TensorSpline, equidistant, extremes};
use generating::GrindingSetup;
use generating_grinding::job::Job;
use generating_grinding::workflow::{Outcome, plan_job, write_outcome};
use job::read_job_of as read_job;
use referee::{
    ActiveThreads, Grinding, GrindingMode, LinePasses, RayGrid, WormArea, WormModification, dress_lines,
    grind,
};
use run::RunFailure;
use std::path::{Path, PathBuf};

const OUTSIDE_RADIUS: f64 = 60.0;
const TIP_RADIUS: f64 = 0.4;
/// Height of scallops of the example, um.
const SCALLOP_UM: f64 = 0.5;

fn planned(directory: &Path) -> Outcome {
    let example = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../../examples/line-dressing.toml");
    let mut loaded = read_job::<Job>(&example).unwrap();
    (loaded.job.grid.profile_points, loaded.job.grid.helix_points) = (5, 5);
    let outcome = match plan_job(&loaded, &Silent) {
        Ok(outcome) => outcome,
        Err(RunFailure::BadInput(d) | RunFailure::NotProducible(d)) => panic!("{d:?}"),
    };
    write_outcome(&loaded, &outcome, directory).unwrap();
    outcome
}

/// The rows of a table without its title.
fn rows(path: &Path) -> Vec<Vec<f64>> {
    let text = std::fs::read_to_string(path).unwrap();
    text.lines().skip(1).map(|row| row.split(',').map(|x| x.parse().unwrap()).collect()).collect()
}

/// The lines as the file has them: places (w_1, z_1) and the motion over the number of the row.
fn lines(directory: &Path, flank: Flank) -> Vec<(Vec<[f64; 2]>, DressingPath)> {
    let rows = rows(&directory.join(format!("motions/dressing-lines-{flank}.csv")));
    rows.chunk_by(|a, b| a[0] == b[0])
        .map(|line| {
            let t: Vec<f64> = (0..line.len()).map(|k| k as f64).collect();
            let law = |column: usize, unit: f64| {
                let values: Vec<f64> = line.iter().map(|row| row[column] * unit).collect();
                MotionLaw::spline(&t, &values).unwrap()
            };
            let radian = 1f64.to_radians();
            let path = DressingPath {
                domain: [0.0, (line.len() - 1) as f64],
                worm_angle: law(4, radian),
                worm_shift: law(5, 1.0),
                centre_distance: law(6, 1.0),
                crossing_angle: line[0][7] * radian,
                offset: line[0][8],
            };
            (line.iter().map(|row| [row[2], row[3]]).collect(), path)
        })
        .collect()
}

fn passes<'a>(setup: &'a GrindingSetup, flank: Flank, paths: &'a [DressingPath]) -> LinePasses<'a> {
    LinePasses {
        worm: setup.pair.worm.flank(flank),
        centre_radius: OUTSIDE_RADIUS - TIP_RADIUS,
        tip_radius: TIP_RADIUS,
        paths,
        stock: 0.1,
    }
}

/// Columns of a table at places that lie a share inside its range.
fn inside(values: impl Iterator<Item = f64> + Clone, inset: f64, count: usize) -> Vec<f64> {
    let [from, to] = extremes(values.clone());
    let room = inset * (to - from);
    let mut kept: Vec<f64> = values.filter(|x| *x > from + room && *x < to - room).collect();
    kept.sort_by(f64::total_cmp);
    kept.dedup();
    let step = (kept.len() / count).max(1);
    kept.into_iter().step_by(step).collect()
}

#[test]
fn the_files_make_the_worm_that_they_name() {
    let directory = tempfile::tempdir().unwrap();
    let outcome = planned(directory.path());
    for flank in Flank::BOTH {
        let table = rows(&directory.path().join(format!("tool-{flank}.csv")));
        let w = inside(table.iter().map(|row| row[0]), 0.1, 6);
        let z = inside(table.iter().map(|row| row[1]), 0.1, 9);
        let grid = RayGrid::new(w.clone(), z.clone()).unwrap();
        let paths: Vec<DressingPath> =
            lines(directory.path(), flank).into_iter().map(|(_, path)| path).collect();
        let cut = dress_lines(&passes(&outcome.prepared.setup, flank, &paths), &grid, &Silent).unwrap();
        let lengths = cut.lengths().unwrap();
        let mut over = Vec::new();
        for (k, f) in lengths.into_iter().enumerate() {
            let (w, z) = grid.ray(k);
            let wanted = table.iter().find(|row| row[0] == w && row[1] == z).unwrap()[2];
            over.push(f * 1e3 - wanted);
        }
        let [least, greatest] = extremes(over.iter().copied());
        println!(
            "{flank}: {} rays, {} lines, {least:.5} to {greatest:.5} um over the table",
            over.len(),
            paths.len()
        );
        // Splines of the motions hold 1e-3 um; numbers of the file are rounded.
        assert!(least > -0.005, "{flank}: {least}");
        assert!(greatest < 1.02 * SCALLOP_UM && greatest > 0.5 * SCALLOP_UM, "{flank}: {greatest}");
    }
}

/// The wanted worm with a patch of the written one.
struct Patched<'a> {
    wanted: &'a TensorSpline,
    written: &'a TensorSpline,
}

impl WormModification for Patched<'_> {
    fn jet(&self, w: f64, z: f64) -> [f64; 3] {
        let [w_s, z_s] = self.written.domain();
        let on_patch = w > w_s[0] && w < w_s[1] && z > z_s[0] && z < z_s[1];
        WormModification::jet(if on_patch { self.written } else { self.wanted }, w, z)
    }

    fn domain(&self) -> [[f64; 2]; 2] {
        self.wanted.domain()
    }
}

/// Half widths of the patch of the worm over w_1 and z_1, mm, and its rays a side.
const PATCH: f64 = 0.12;
const PATCH_RAYS: usize = 121;

#[test]
fn a_gear_ground_by_the_written_worm_is_off_by_no_more_than_the_scallops() {
    let directory = tempfile::tempdir().unwrap();
    let outcome = planned(directory.path());
    let (setup, execution) = (&outcome.prepared.setup, &outcome.execution);
    let flank = Flank::Left;
    let executed = execution.flanks[flank].as_ref().unwrap();
    let made = executed.made().unwrap();
    // A gear point of the relief, and the worm point that the referee sees grinding it.
    let (w_2, z_2) = (executed.target.w[3], executed.target.z[3]);
    let gear =
        RayGrid::new(equidistant([w_2 - 0.02, w_2 + 0.02], 5), equidistant([z_2 - 0.02, z_2 + 0.02], 5))
            .unwrap();
    let ground = |modification: &dyn WormModification, [w, z]: [[f64; 2]; 2]| {
        let setup = Grinding {
            worm: setup.pair.worm.flank(flank),
            area: WormArea { w, z },
            modification,
            work: setup.pair.work.flank(flank),
            motion: &execution.motion,
            feed_range: execution.feed_range,
            stock: 0.1,
            threads: ActiveThreads::All,
            mode: GrindingMode::Continuous,
        };
        grind(&setup, &gear, &Silent).unwrap()
    };
    let wanted = ground(&made.spline, made.spline.domain());
    let middle = wanted.rays[12].as_ref().unwrap();
    let (w_1, z_1) = (middle.worm_roll, middle.worm_z);
    let near: Vec<DressingPath> = lines(directory.path(), flank)
        .into_iter()
        .filter(|(places, _)| {
            let tool = setup.tool_direction[flank].atan();
            let x = |[w, z]: [f64; 2]| w * tool.sin() + z * tool.cos();
            (x(places[0]) - x([w_1, z_1])).abs() < 2.0 * PATCH
        })
        .map(|(_, path)| path)
        .collect();
    let axis = |middle: f64| equidistant([middle - PATCH, middle + PATCH], PATCH_RAYS);
    let (w, z) = (axis(w_1), axis(z_1));
    let grid = RayGrid::new(w.clone(), z.clone()).unwrap();
    let cut = dress_lines(&passes(setup, flank, &near), &grid, &Silent).unwrap().lengths().unwrap();
    let rows: Vec<Vec<f64>> = cut.chunks(z.len()).map(<[f64]>::to_vec).collect();
    let written = TensorSpline::new(&w, &z, &rows).unwrap();

    let patched = Patched { wanted: &made.spline, written: &written };
    let left = ground(&patched, made.spline.domain());
    let (wanted, left) = (wanted.lengths().unwrap(), left.lengths().unwrap());
    let deeper: Vec<f64> = wanted.iter().zip(&left).map(|(a, b)| (a - b) * 1e3).collect();
    let [least, greatest] = extremes(deeper.iter().copied());
    println!("{} lines on the patch; the gear is ground {least:.4} to {greatest:.4} um deeper", near.len());
    // Material that stays on the worm takes as much off the gear at most.
    assert!(least > -0.01 && greatest < 1.05 * SCALLOP_UM, "{deeper:?}");
    assert!(greatest > 0.5 * SCALLOP_UM, "{deeper:?}");
}

#[test]
fn both_flanks_share_one_ratio_with_the_lines_laid() {
    let directory = tempfile::tempdir().unwrap();
    let outcome = planned(directory.path());
    let s = &outcome.result.settings;
    let Sides { left, right } = s.demanded_ratios.as_ref().unwrap();
    assert!((left[0] - right[0]).abs() < 1e-9, "{left:?} {right:?}");
    assert!((s.settings.diagonal_ratio - left[0]).abs() < 1e-9);
}
