//! Jobs beyond the cylinder with its dressed worm: reliefs on lines, areas, laws of the shift, cones, tools without a dresser.
//! Every plan is held against the referee, and its settings, written and read again, give the same flank.

use foundation::geometry::Flank;
use foundation::numerics::Silent;
use generating_grinding::job::LoadedJob;
use generating_grinding::job::RootAlong;
use generating_grinding::workflow::{Outcome, plan_job, simulate_job};
use job::read_job_of as read_job;
use run::RunFailure;
use std::path::PathBuf;
use verdict::Status;

fn load(name: &str) -> LoadedJob {
    read_job(&PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../../examples").join(name)).unwrap()
}

fn planned(job: &LoadedJob) -> Outcome {
    match plan_job(job, &Silent) {
        Ok(outcome) => outcome,
        Err(RunFailure::BadInput(d) | RunFailure::NotProducible(d)) => panic!("{d:?}"),
    }
}

/// Plans an example: met, and the referee agrees within `agreement` um. Returns the outcome.
fn held(name: &str, agreement: f64) -> Outcome {
    let outcome = planned(&load(name));
    assert_eq!(outcome.result.verdict.status(), Status::Met, "{name}: {:?}", outcome.result.verdict.reason());
    for (flank, f) in &outcome.result.flanks {
        assert!(f.model_difference_um <= agreement, "{name} {flank}: {} um", f.model_difference_um);
        assert!(f.model_difference_um <= 2.0 * f.referee_error_um, "{name} {flank}");
    }
    outcome
}

/// The settings of an outcome, run as `simulate` runs them, leave the flank that was planned.
fn settings_go_round(name: &str, outcome: &Outcome) {
    let mut job = load(name);
    let text = serde_json::to_string(&outcome.execution.settings()).unwrap();
    job.job.settings = Some(serde_json::from_str(&text).unwrap());
    let again = match simulate_job(&job, &Silent) {
        Ok(outcome) => outcome,
        Err(RunFailure::BadInput(d) | RunFailure::NotProducible(d)) => panic!("{name}: {d:?}"),
    };
    for (flank, f) in &again.result.flanks {
        let before = &outcome.result.flanks[flank];
        for (a, b) in f.planned_um.iter().flatten().zip(before.planned_um.iter().flatten()) {
            // Numbers of some 100 um written in decimal.
            assert!((a - b).abs() < 1e-7, "{name} {flank}: {a} {b}");
        }
    }
}

#[test]
fn end_reliefs_and_crowning_share_the_lines_of_one_ratio() {
    let outcome = held("triangular-end-relief.toml", 0.05);
    let s = &outcome.result.settings;
    let demanded = s.demanded_ratios.as_ref().unwrap();
    assert!((s.settings.diagonal_ratio - demanded.left[0]).abs() < 1e-12);
    assert!((demanded.left[0] - demanded.right[0]).abs() < 1e-9);
    settings_go_round("triangular-end-relief.toml", &outcome);
}

#[test]
fn each_region_of_a_flank_gets_its_own_ratio() {
    let outcome = held("two-end-reliefs.toml", 0.05);
    let demanded = outcome.result.settings.demanded_ratios.clone().unwrap().left;
    let shift = &outcome.execution.motion.shift;
    let [from, to] = outcome.prepared.setup.feed_range(shift, &[Flank::Left]);
    // The ratio at both ends of the feed is that of the region ground there.
    for v in [from + 0.5, to - 0.5] {
        let slope = shift.jet(v)[1];
        assert!(demanded.iter().any(|k| (k - slope).abs() < 1e-9), "{slope}: {demanded:?}");
    }
    let partition = outcome.result.settings.partition.as_ref().unwrap();
    assert_eq!((partition.areas, partition.roughing_areas, partition.shifts_mm.len()), (1, 1, 2));
    assert!(partition.areas_that_fit.unwrap() >= 1);
    settings_go_round("two-end-reliefs.toml", &outcome);
}

#[test]
fn waves_run_along_the_lines_of_the_worm() {
    let outcome = held("waviness.toml", 0.05);
    assert!(outcome.result.flanks["left"].max_deviation_um < 0.1);
}

#[test]
fn a_bent_relief_follows_a_ratio_that_changes() {
    let outcome = held("variable-ratio.toml", 0.1);
    let shift = &outcome.execution.motion.shift;
    let [from, to] = outcome.prepared.setup.feed_range(shift, &[Flank::Right]);
    assert!(shift.jet(from + 1.0)[1] > 2.0 * shift.jet(to - 1.0)[1], "the ratio changes");
    settings_go_round("variable-ratio.toml", &outcome);
}

#[test]
fn a_conical_worm_lays_its_lines_onto_both_flanks_of_an_asymmetric_gear() {
    let outcome = held("asymmetric-conical-worm.toml", 0.05);
    let demanded = outcome.result.settings.demanded_ratios.clone().unwrap();
    assert!((demanded.left[0] - demanded.right[0]).abs() <= 1e-9);
    assert!((demanded.left[0] - 4.688_453_926_842_810_5).abs() < 1e-8);
    settings_go_round("asymmetric-conical-worm.toml", &outcome);
}

#[test]
fn beveloids_are_ground_by_cylinder_and_cone() {
    for name in ["beveloid-cylindrical-worm.toml", "beveloid-conical-worm.toml"] {
        let outcome = held(name, 0.05);
        assert!(outcome.result.flanks.values().all(|f| f.max_deviation_um < 0.05), "{name}");
        settings_go_round(name, &outcome);
    }
}

#[test]
fn a_left_out_thread_halves_the_feed() {
    let outcome = held("left-out-thread.toml", 0.05);
    let strokes = outcome.result.settings.index_strokes.as_ref().unwrap();
    assert_eq!((strokes.strokes_per_pass, strokes.index_pitches.as_slice()), (1, &[0][..]));
    assert!((strokes.feed_factor - 0.5).abs() < 1e-15);
    // With every thread the same feed leaves marks of a quarter of the height.
    let mut job = load("left-out-thread.toml");
    job.job.grinding.active_threads = None;
    let whole = planned(&job);
    for flank in ["left", "right"] {
        let height = |o: &Outcome| o.result.flanks[flank].feed_mark_um.unwrap();
        let ratio = height(&outcome) / height(&whole);
        assert!((3.0..5.0).contains(&ratio), "{flank}: {ratio}");
    }
}

#[test]
fn tools_without_a_dresser_are_made_or_given() {
    let plated = held("plated-worm.toml", 0.05);
    assert!(plated.execution.flanks.left.as_ref().unwrap().made().is_some());
    settings_go_round("plated-worm.toml", &plated);
    let hob = held("hob.toml", 0.05);
    settings_go_round("hob.toml", &hob);
    // The hob cannot make a twist: the plan says what is missing.
    let mut job = load("hob.toml");
    let twist = serde_json::json!([{ "kind": "twist", "amount_um": 20.0 }]);
    job.job.target.modifications = serde_json::from_value(twist).unwrap();
    let missed = planned(&job).result;
    assert_eq!(missed.verdict.status(), Status::Missed);
    assert!(missed.flanks["left"].max_deviation_um > 3.0);
}

#[test]
fn a_target_outside_the_polynomials_is_decomposed_by_least_squares() {
    let mut job = load("left-out-thread.toml");
    job.job.grinding.active_threads = None;
    job.job.grinding.feed_per_revolution = None;
    let arcs = serde_json::json!([
        { "kind": "helix_crowning_two_arc", "apex_z_mm": 0.0, "amount_I_um": 6.0, "amount_II_um": 14.0 },
        { "kind": "end_relief_I", "amount_um": 5.0, "length_mm": 6.0, "exponent": 2 },
    ]);
    job.job.target.modifications = serde_json::from_value(arcs).unwrap();
    let outcome = planned(&job);
    assert_eq!(outcome.result.verdict.status(), Status::Met, "{:?}", outcome.result.verdict.reason());
    for f in outcome.result.flanks.values() {
        assert!(f.max_deviation_um < 0.1 && f.model_difference_um < 0.05, "{}", f.max_deviation_um);
    }
}

#[test]
fn gauges_leave_the_flank() {
    use generating_grinding::job::{DiagonalRatio, Gauge, GaugeRule, GivenGauge};
    let gauges = [
        Gauge::Rule(GaugeRule::Centred),
        Gauge::Rule(GaugeRule::EqualSwivel),
        Gauge::Given(GivenGauge { k_10: 2e-4, k_20: 0.0, k_k0: 1e-3 }),
    ];
    let mut delta_d = Vec::new();
    for gauge in gauges {
        let mut job = load("triangular-end-relief.toml");
        if gauge != Gauge::Rule(GaugeRule::EqualSwivel) {
            job.job.grinding.diagonal_ratio = Some(DiagonalRatio::Number(-1.2));
        }
        // Equal twist on both flanks is no half turn: only one ratio swivels alike.
        let target = serde_json::json!([
            { "kind": "helix_crowning", "amount_um": 10.0 },
            { "kind": "profile_crowning", "amount_um": 4.0 },
            { "kind": "twist", "amount_um": 6.0 },
        ]);
        job.job.target.modifications = serde_json::from_value(target).unwrap();
        job.job.grinding.gauge = gauge;
        let outcome = planned(&job);
        assert_eq!(outcome.result.verdict.status(), Status::Met, "{gauge:?}");
        assert!(outcome.result.flanks.values().all(|f| f.max_deviation_um < 0.05), "{gauge:?}");
        delta_d.push(outcome.execution.motion.delta_d.value(0.0));
    }
    assert!((delta_d[0] - delta_d[2]).abs() > 1e-4, "another gauge, another motion: {delta_d:?}");
}

#[test]
fn a_tolerance_map_judges_place_by_place() {
    let mut job = load("radial-feed-crowning.toml");
    let table = |corner: f64| {
        serde_json::json!({
            "w_mm": [4.1, 12.0, 30.0], "z_mm": [-20.0, 0.0, 20.0],
            "tolerance_um": [[corner, 50.0, corner], [50.0, 5.0, 50.0], [50.0, 50.0, 50.0]],
        })
    };
    // The natural twist is largest in the corners, where the map allows it.
    job.job.target.tolerance_map = serde_json::from_value(table(50.0)).unwrap();
    let outcome = planned(&job);
    let f = &outcome.result.flanks["left"];
    assert!(f.max_deviation_um > 13.0 && f.tolerance_share < 1.0, "{}", f.tolerance_share);
    assert_eq!(outcome.result.verdict.status(), Status::Met);
    job.job.target.tolerance_map = serde_json::from_value(table(5.0)).unwrap();
    assert_eq!(planned(&job).result.verdict.status(), Status::Missed);
}

#[test]
fn one_motion_dresses_both_flanks() {
    let outcome = held("dressing/two-flanks.toml", 0.005);
    let of = |flank: Flank| outcome.execution.flanks[flank].as_ref().unwrap().dressing().unwrap();
    let (left, right) = (of(Flank::Left), of(Flank::Right));
    assert_eq!(left.corrections, right.corrections);
    assert_eq!(left.motion, right.motion);
    assert!(outcome.result.flanks.values().all(|f| f.max_deviation_um < 0.25));
    settings_go_round("dressing/two-flanks.toml", &outcome);
}

#[test]
fn the_worms_tip_follows_the_distance_so_that_the_root_stays() {
    let name = "dressing/gear-root.toml";
    let outcome = held(name, 1e-3);
    let root = outcome.result.gear_root.as_ref().unwrap();
    let spread = |range: [f64; 2]| range[1] - range[0];
    // The distance changes by 7.6 um over the face: twice that on a diameter.
    assert!(
        spread(root.root_diameter_mm) < 1e-4 && (root.root_diameter_mm[1] - 72.4315).abs() < 1e-6,
        "{root:?}"
    );
    assert!((spread(root.worm_tip_diameter_mm) - 0.0153).abs() < 5e-4, "{:?}", root.worm_tip_diameter_mm);
    for (flank, fillet) in root.flanks.iter() {
        let fillet = fillet.as_ref().unwrap();
        assert!(fillet.model_difference_um < 1e-3, "{flank}: {}", fillet.model_difference_um);
        assert!(fillet.form_diameter_mm < 76.2065 && fillet.least_radius_mm > 0.8);
        assert!(fillet.sections.len() == 5 && fillet.sections.iter().all(|s| s.points_mm.len() == 41));
    }
    settings_go_round(name, &outcome);
    // A cylindrical tip leaves the change of the distance in the root.
    let mut job = load(name);
    job.job.dressing.gear_root.as_mut().unwrap().along = RootAlong::Follows;
    let follows = planned(&job).result.gear_root.unwrap();
    assert!(spread(follows.worm_tip_diameter_mm) == 0.0);
    assert!((spread(follows.root_diameter_mm) - 0.0153).abs() < 5e-4, "{:?}", follows.root_diameter_mm);
}

#[test]
fn a_conical_worm_is_dressed_with_the_lead_of_each_flank() {
    let outcome = held("dressing/conical-worm.toml", 1e-6);
    let lead = |flank: Flank| {
        let flank = outcome.execution.flanks[flank].as_ref().unwrap();
        flank.dressing().unwrap().motion.chain.screw_parameter
    };
    assert!((lead(Flank::Left) - lead(Flank::Right)).abs() > 1e-3);
    assert!(outcome.result.flanks.values().all(|f| f.max_deviation_um < 0.01));
    settings_go_round("dressing/conical-worm.toml", &outcome);
}
