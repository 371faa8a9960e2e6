//! Axes that are off, against what geometry says they leave.

use foundation::geometry::Flank;
use foundation::numerics::Silent;
use generating_grinding::job::{Job, LoadedJob, MachineDeviations};
use generating_grinding::workflow::{DeviatedFlank, Deviation, ForwardModel, Outcome, plan_job};
use job::read_job_of;
use std::collections::BTreeMap;
use std::path::Path;

fn job(deviations: Option<MachineDeviations>) -> LoadedJob {
    let file = concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples/axes-off.toml");
    let mut loaded = read_job_of::<Job>(Path::new(file)).unwrap();
    loaded.job.grid.profile_points = 11;
    loaded.job.grid.helix_points = 11;
    loaded.job.deviations = deviations;
    loaded
}

fn planned(deviations: MachineDeviations) -> Outcome {
    plan_job(&job(Some(deviations)), &Silent).unwrap()
}

fn flanks(outcome: &Outcome) -> &BTreeMap<&'static str, DeviatedFlank> {
    &outcome.result.deviated.as_ref().unwrap().flanks
}

/// Base radius and normal pressure angle of the gear.
const BASE_RADIUS: f64 = 37.882;
const NORMAL_PRESSURE_ANGLE: f64 = 17.5;

#[test]
fn the_plan_stays_and_a_job_without_deviations_has_no_figure_of_them() {
    let plain = plan_job(&job(None), &Silent).unwrap();
    assert!(plain.result.deviated.is_none());
    let off = planned(MachineDeviations { radial_feed_um: vec![2.0], ..MachineDeviations::default() });
    assert_eq!(plain.result.settings.settings, off.result.settings.settings);
    assert_eq!(plain.result.verdict.status(), off.result.verdict.status());
}

/// A worm that stands too far away leaves Delta d sin alpha_n on both flanks, normal, and no form.
#[test]
fn a_constant_centre_distance_is_tooth_thickness() {
    let outcome = planned(MachineDeviations { radial_feed_um: vec![2.0], ..MachineDeviations::default() });
    let expected = 2.0 * NORMAL_PRESSURE_ANGLE.to_radians().sin();
    for (name, flank) in flanks(&outcome) {
        // The contact moves on the modified worm, which is of second order.
        assert!((flank.stock_um - expected).abs() < 0.01 * expected, "{name}: {}", flank.stock_um);
        assert!(flank.largest_change_um < 0.02, "{name}: {}", flank.largest_change_um);
    }
}

/// An angle that grows over the feed by 2 x 3 arcsec turns the transverse profiles by r_b Delta phi against each other: a helix slope, the left flank's with
/// the sign opposite to the right's.
#[test]
fn an_angle_that_grows_over_the_feed_is_a_helix_slope() {
    let outcome =
        planned(MachineDeviations { work_angle_arcsec: vec![0.0, 3.0], ..MachineDeviations::default() });
    let expected = BASE_RADIUS * (2.0 * 3.0 / 3600.0_f64).to_radians() * 1e3;
    let slope = |name: &str| {
        let planned = outcome.result.flanks[name].simulated_characteristics.helix_slope_um;
        flanks(&outcome)[name].characteristics.helix_slope_um - planned
    };
    let (left, right) = (slope("left"), slope("right"));
    assert!((left + right).abs() < 0.02 * expected, "{left} {right}");
    // The contact of a crowned flank runs ahead of its place: at the ends of the face by 2 % of their distance from the middle.
    assert!((1.0..1.03).contains(&(left.abs() / expected)), "{left}, expected {expected}");
}

/// Small deviations add up: together they leave the sum of what each leaves by itself.
#[test]
fn deviations_add_up() {
    let crossing = MachineDeviations { crossing_angle_deg: 0.01, ..MachineDeviations::default() };
    let mut dressing = MachineDeviations::default();
    dressing.dressing.d_gamma_deg = 0.02;
    let both = MachineDeviations { dressing: dressing.dressing, ..crossing.clone() };
    let [crossing, dressing, both] = [crossing, dressing, both].map(planned);
    for name in ["left", "right"] {
        let of = |outcome: &Outcome| flanks(outcome)[name].change_um.concat();
        let (a, b, sum) = (of(&crossing), of(&dressing), of(&both));
        let scale = sum.iter().fold(0.0, |most: f64, f| most.max(f.abs()));
        assert!(scale > 0.3, "{name}: {scale}");
        for ((a, b), sum) in a.iter().zip(&b).zip(&sum) {
            assert!((a + b - sum).abs() < 0.02 * scale + 0.005, "{name}: {a} + {b} is not {sum}");
        }
    }
}

/// Worms dressed in strokes and laws of the shift: rays leave with axes off what the exact contact says.
#[test]
fn strokes_and_laws_of_the_shift_have_axes_that_are_off() {
    for (example, dressed) in [("dressing/strokes.toml", true), ("variable-ratio.toml", false)] {
        let file = format!("{}/../../examples/{example}", env!("CARGO_MANIFEST_DIR"));
        let mut loaded = read_job_of::<Job>(Path::new(&file)).unwrap();
        (loaded.job.grid.profile_points, loaded.job.grid.helix_points) = (9, 7);
        loaded.job.grinding.feed_per_revolution = None;
        let mut off = MachineDeviations {
            work_angle_arcsec: vec![0.0, 3.0],
            crossing_angle_deg: 0.003,
            ..MachineDeviations::default()
        };
        let mut asked = vec![(Deviation::WorkAngle(1), 3.0), (Deviation::CrossingAngle, 0.003)];
        if dressed {
            off.dressing.d_gamma_deg = 0.02;
            asked.push((Deviation::Dressing(1), 0.02));
        }
        loaded.job.deviations = Some(off);
        let outcome = plan_job(&loaded, &Silent).unwrap();
        let model =
            ForwardModel::of_run(outcome.prepared.clone(), outcome.execution.clone(), [9, 7]).unwrap();
        let (with, without) = (model.flanks(&asked).unwrap(), model.flanks(&[]).unwrap());
        for (name, flank) in flanks(&outcome) {
            let side = if *name == "left" { Flank::Left } else { Flank::Right };
            let (with, without) = (with[side].as_ref().unwrap(), without[side].as_ref().unwrap());
            let change: Vec<f64> = with.iter().zip(without).map(|(a, b)| 1e3 * (a - b)).collect();
            let mean = change.iter().sum::<f64>() / change.len() as f64;
            let largest = change.iter().map(|f| (f - mean).abs()).fold(0.0, f64::max);
            assert!(largest > 0.5, "{example} {name}: {largest}");
            for (rays, contact) in flank.change_um.concat().iter().zip(&change) {
                let missed = (rays - (contact - mean)).abs();
                assert!(missed < 0.02 * largest + 0.02, "{example} {name}: {rays} and {}", contact - mean);
            }
        }
    }
}
