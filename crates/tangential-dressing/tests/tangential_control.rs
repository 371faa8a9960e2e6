//! What a control leaves on gears ground with a tangentially dressed worm: every pass through gearbox and servo with its own motion, judged
//! by rays that the worm shortens which the dresser left.

use foundation::numerics::Silent;
use job::{Source, parse_job_of};
use std::path::Path;
use tangential_dressing::job::{LoadedTangentialJob, TangentialJob};
use tangential_dressing::workflow::{TangentialResult, plan_tangential, simulate_tangential};
use verdict::Status;

/// An example on a coarse grid, with some of its text replaced.
fn job(example: &str, changes: &[(&str, &str)]) -> LoadedTangentialJob {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples/tangential");
    let mut text = std::fs::read_to_string(root.join(format!("{example}.toml"))).expect("an example");
    for (from, to) in changes {
        assert!(text.contains(from), "{from}");
        text = text.replacen(from, to, 1);
    }
    parse_job_of::<TangentialJob>(Source::new("job.toml", &text)).unwrap_or_else(|e| panic!("{e}"))
}

fn planned(changes: &[(&str, &str)]) -> TangentialResult {
    let coarse = [("profile_points = 21", "profile_points = 5"), ("helix_points = 21", "helix_points = 5")];
    let changes: Vec<_> = coarse.iter().chain(changes).copied().collect();
    plan_tangential(&job("with-control", &changes), &Silent).unwrap_or_else(|e| panic!("{e:?}")).result
}

const ONE_SENSE: (&str, &str) = ("feed_senses = \"both\"", "feed_senses = \"one\"");
const ONE_WAY: (&str, &str) = ("mode = \"no-backlash\"", "mode = \"one-way\"");

fn items(result: &TangentialResult) -> (Vec<&str>, Vec<&str>) {
    let judged = result.verdict.judged().iter().map(|one| one.item.as_str()).collect();
    (judged, result.verdict.not_judged().iter().map(|one| one.item.as_str()).collect())
}

#[test]
fn the_control_is_judged_on_every_flank() {
    let result = planned(&[ONE_SENSE]);
    assert_eq!(result.verdict.status(), Status::Met, "{:?}", result.verdict.reason());
    let (judged, left_out) = items(&result);
    for flank in ["left", "right"] {
        assert!(judged.contains(&format!("{flank} flank with gearbox and servo").as_str()), "{judged:?}");
    }
    assert_eq!(left_out, ["dressing of the worm through gearbox and servo", "programs"]);
    let control = result.control.as_ref().expect("a control");
    let turning = 4000.0 * 3.0 / 19.0;
    assert!((control.worm_speed_rpm - 4000.0).abs() < 1e-9);
    assert!((control.work_speed_rpm - turning).abs() < 1e-9);
    assert!((control.feed_mm_per_min - 0.3 * turning).abs() < 1e-9);
    for (name, f) in &control.flanks {
        // Out of balance once a turn, the threads of the worm, and the steps of encoders and scales.
        assert!((0.1..0.6).contains(&f.largest_um), "{name}: {}", f.largest_um);
        assert!(f.model_difference_um < 0.01, "{name}: {}", f.model_difference_um);
        assert_eq!((f.tooth_means_um.len(), f.topography_um.len(), f.senses_apart_um), (19, 5, None));
        let process = result.flanks[name].flank.max_deviation_um;
        assert!(f.deviation_with_control_um <= f.largest_um + process + 1e-9);
        assert!(f.deviation_with_control_um >= f.largest_um - process - 1e-9);
    }
}

#[test]
fn without_a_control_couplings_are_ideal() {
    let mut loaded = job("with-control", &[]);
    loaded.job.control = None;
    let result = plan_tangential(&loaded, &Silent).unwrap_or_else(|e| panic!("{e:?}")).result;
    assert_eq!(result.control, None);
    let (judged, left_out) = items(&result);
    assert_eq!(
        (judged, left_out),
        (vec!["left flank", "right flank"], vec!["gearbox and servo", "programs"])
    );
}

/// Between two lines of the scale one-way interpolation leaves all but one of its pulses at a reversal: on the flank sin(beta_b) of them.
#[test]
fn both_senses_keep_what_is_left_of_a_reversal() {
    let results =
        [&[ONE_SENSE, ONE_WAY][..], &[], &[ONE_WAY]].map(|changes| planned(changes).control.expect("one"));
    let [one, taken_back, left] = &results;
    let (alpha, beta) = (17.5f64.to_radians(), 35f64.to_radians());
    let interval = 4.0 * beta.sin() * alpha.cos() * 63.0 / 64.0;
    for name in ["left", "right"] {
        let apart = |of: &generating_grinding::workflow::ControlResult| of.flanks[name].senses_apart_um;
        assert_eq!(apart(one), None);
        let (taken_back, left) = (apart(taken_back).expect("both"), apart(left).expect("both"));
        assert!(taken_back < 0.1, "{name}: {taken_back}");
        assert!((left - interval).abs() < 0.1, "{name}: {left} of {interval}");
    }
    // The stroke there is the same, so that the deeper of both leaves no more at any place.
    for (name, f) in &left.flanks {
        let rows = f.topography_um.iter().flatten().zip(one.flanks[name].topography_um.iter().flatten());
        for (both, there) in rows {
            assert!(*both < there + 0.01, "{name}: {both} of both, {there} of one");
        }
    }
    // Back stands off by the same turn on both flanks: into the one, away from the other.
    let mut largest: Vec<f64> = left.flanks.values().map(|f| f.largest_um).collect();
    largest.sort_by(f64::total_cmp);
    assert!(largest[0] < 0.6 && largest[1] > 0.9 * interval, "{largest:?}");
}

/// Flanks with motions of their own have strokes of their own; flanks of one pass share the stroke that both need.
#[test]
fn a_pass_is_one_stroke() {
    let settings = "[settings]\nboth = { values = { Fp2 = 0.0057 } }\n[dressing]";
    let ends = |passes: &str| {
        let passes = format!("passes = \"{passes}\"");
        let changes = [
            ONE_SENSE,
            ("passes = \"each\"", passes.as_str()),
            ("[dressing]", settings),
            ("profile_points = 21", "profile_points = 5"),
            ("helix_points = 21", "helix_points = 5"),
        ];
        let loaded = job("with-control", &changes);
        let result = simulate_tangential(&loaded, &Silent).unwrap_or_else(|e| panic!("{e:?}")).result;
        let control = result.control.expect("a control");
        ["left", "right"].map(|name| {
            let feed = &control.flanks[name].error.feed_mm;
            ([feed[0], feed[feed.len() - 1]], result.flanks[name].feed_stroke_mm)
        })
    };
    let near = |a: [f64; 2], b: [f64; 2]| a.iter().zip(b).all(|(a, b)| (a - b).abs() < 0.1);
    for (driven, needed) in ends("each") {
        assert!(near(driven, needed), "{driven:?} {needed:?}");
    }
    let [(left, needed_left), (right, needed_right)] = ends("one");
    assert_eq!(left, right);
    let needed = [needed_left[0].min(needed_right[0]), needed_left[1].max(needed_right[1])];
    assert!(near(left, needed), "{left:?} {needed:?}");
    assert!(!near(needed_left, needed_right), "{needed_left:?} {needed_right:?}");
}

/// The automotive gear: dresser and grinding each turn the flank by more than a tenth of a millimetre, against each other, and thereby move
/// its contacts by millimetres of feed. Closed form and rays find the same error only where both know it.
#[test]
fn corrections_that_cancel_each_other_do_not_disturb_the_rays() {
    let control = r#"
[control]
feed = { pulses_per_metre = 250000, clock_hz = 10e6, pulses_per_interval = 64 }
worm = { pulses_per_revolution = 2097152 }
workpiece = { pulses_per_revolution = 9000000 }
worm_speed_rpm = 3000.0
servo = { inertia_kg_m2 = 0.3, torque_limit_n_m = 200.0, bandwidth_hz = 40.0, disturbances = [{ kind = "order", torque_n_m = 3.0, axis = "workpiece", order = 1.0 }] }
[grid]
profile_points = 5
helix_points = 5
"#;
    let changes = [
        ("shift_ratio = 1.5", "shift_ratio = 1.5\nfeed_per_revolution = 0.3"),
        ("[machine]\nfile = \"../../machines/xyzabc.toml\"\n", control),
    ];
    let result =
        plan_tangential(&job("automotive", &changes), &Silent).unwrap_or_else(|e| panic!("{e:?}")).result;
    let turned = |pass: &tangential_dressing::workflow::PassResult| {
        pass.variables.iter().find(|v| v.name == "FC1").map_or(0.0, |v| v.value.abs())
    };
    assert!(result.passes.iter().all(|pass| turned(pass) > 0.1), "{:?}", result.passes);
    let control = result.control.expect("a control");
    for (name, f) in &control.flanks {
        assert!(f.largest_um > 0.9, "{name}: {}", f.largest_um);
        // What the curvature of the modifications changes of the gap's is left out.
        assert!(f.model_difference_um < 0.03, "{name}: {} of {}", f.model_difference_um, f.largest_um);
    }
}
