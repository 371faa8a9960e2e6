//! Axes of dressing that are off, found again from the worm that they leave: dressed by rays with deviations, measured with noise, explained by
//! the exact envelope of the planned motion.

use foundation::geometry::Flank;
use foundation::numerics::{Noise, Silent, equidistant};
use generating_grinding::job::{DegreeOfFreedom, Job, LoadedJob, MeasuredWorm};
use generating_grinding::workflow::deviated::deviated;
use generating_grinding::workflow::referee::{Cutting, run};
use generating_grinding::workflow::{MeasuredWormResult, Outcome, plan_job};
use job::read_job_of;
use referee::WormModification;
use std::fmt::Write;
use std::path::Path;

fn job() -> LoadedJob {
    let file = concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples/axes-off.toml");
    let mut loaded = read_job_of::<Job>(Path::new(file)).unwrap();
    loaded.job.grid.profile_points = 9;
    loaded.job.grid.helix_points = 9;
    loaded.job.deviations = None;
    loaded
}

/// The worm that rays leave with the dressing axes off by d_phi_S, d_gamma (degrees), d_d, d_v_yA (mm), measured on a grid with noise of so
/// many micrometres.
fn measured(planned: &Outcome, off: [f64; 4], noise_um: f64) -> String {
    let mut deviations = generating_grinding::job::MachineDeviations::default();
    deviations.dressing.d_phi_s_deg = off[0];
    deviations.dressing.d_gamma_deg = off[1];
    deviations.dressing.d_d_mm = off[2];
    deviations.dressing.d_v_ya_mm = off[3];
    let execution = deviated(&planned.prepared, &planned.execution, &deviations, "deviations").unwrap();
    let cutting = Cutting { feed_per_revolution: None, strokes: None };
    let verdicts = run(&planned.prepared.setup, &execution, cutting, &Silent).unwrap();
    let mut noise = Noise::new(7);
    let mut table = String::from("flank,w_mm,z_mm,um\n");
    for flank in Flank::BOTH {
        let worm = verdicts[flank].as_ref().unwrap().dressed.as_ref().unwrap();
        let range = planned.execution.dresser.as_ref().unwrap().flanks[flank].range;
        for z in equidistant(planned.execution.occupation, 7) {
            for w in equidistant([range.w_nf, range.w_na], 11) {
                let f = worm.value(w, z) * 1e3 + noise_um * noise.normal();
                writeln!(table, "{flank},{w:.4},{z:.3},{f:.3}").unwrap();
            }
        }
    }
    table
}

fn found(table: &str, thickness: bool, held: Vec<DegreeOfFreedom>) -> MeasuredWormResult {
    let directory = tempfile::tempdir().unwrap();
    let file = directory.path().join("worm.csv");
    std::fs::write(&file, table).unwrap();
    let mut loaded = job();
    let file = file.to_str().unwrap().to_owned();
    loaded.job.measured_worm = Some(MeasuredWorm { file, noise_um: 0.1, thickness, held });
    plan_job(&loaded, &Silent).unwrap().result.measured_worm.unwrap()
}

/// Each axis within four standard uncertainties, and one per cent for what rays leave between their points.
fn agrees(of: &MeasuredWormResult, off: [f64; 4]) {
    for (axis, off) in of.axes.iter().zip(off) {
        let allowed = 4.0 * axis.uncertainty + 0.01 * off.abs();
        assert!((axis.value - off).abs() <= allowed, "{off}: {of:?}");
    }
    assert!(of.rms_left_um < 0.15 && of.rms_um > 3.0 * of.rms_left_um, "{of:?}");
}

#[test]
fn dressing_axes_are_found_from_the_worm_that_they_leave() {
    let planned = plan_job(&job(), &Silent).unwrap();
    let off = [0.01, 0.03, 0.004, 0.08];
    let of = found(&measured(&planned, off, 0.1), true, vec![]);
    assert_eq!((of.points, of.points_left_out), (154, 0));
    agrees(&of, off);
    // By the form alone the angle of the worm is not told.
    let off = [0.0, 0.03, 0.004, 0.08];
    let table = measured(&planned, off, 0.1);
    let of = found(&table, false, vec![]);
    assert_eq!(of.axes[0].uncertainty, 0.0);
    agrees(&of, off);
    // A known axis is held.
    let of_known = found(&measured(&planned, [0.0, 0.03, 0.004, 0.0], 0.1), false, vec![DegreeOfFreedom::Vy]);
    assert_eq!(of_known.axes[3].uncertainty, 0.0);
    agrees(&of_known, [0.0, 0.03, 0.004, 0.0]);
}

/// The example is the worm that these deviations leave.
#[test]
fn the_example_finds_what_was_off() {
    let file = concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples/dressing/measured-worm.toml");
    let of = plan_job(&read_job_of::<Job>(Path::new(file)).unwrap(), &Silent).unwrap().result.measured_worm;
    agrees(&of.unwrap(), [0.01, 0.03, 0.004, 0.08]);
}
