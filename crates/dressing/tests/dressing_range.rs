//! Range of profile crownings: ends against closed statements and neighbours, paths against the rows they solve, limits.

use crate::dressing_bodies::{Bodies, CASE_A, bodies, flanks};
use dressing::{
    ConditionSolver, CrowningLimits, CrowningRange, CrowningRows, DressedProfile, DresserTool, DressingError,
    PathReason, TiltChart, stretch, three_points_with_map,
};
use foundation::geometry::{Flank, Sides};
use foundation::kinematics::{DressingChain, DressingCorrection};
use proptest::prelude::*;

const GEAR_BASE_HELIX: f64 = 0.57;

fn rows<'a>(bodies: &Bodies, tool: &'a DresserTool, flank: Flank) -> CrowningRows<'a> {
    CrowningRows::new(&tool.flanks[flank], bodies.radius(), GEAR_BASE_HELIX)
}

fn whole(bodies: &Bodies, tool: &DresserTool, flank: Flank) -> CrowningRange {
    rows(bodies, tool, flank).range(&CrowningLimits::default()).unwrap()
}

/// What every range must be: its path solves the rows in both charts, ascends and has no jumps.
fn holds(bodies: &Bodies, tool: &DresserTool, flank: Flank, range: &CrowningRange) {
    let dresser = &tool.flanks[flank];
    let chain = &dresser.chain;
    let used = dresser.range;
    assert!(range.smallest.crowning < 0.0 && range.largest.crowning > 0.0, "{range:?}");
    assert!(range.path[0].crowning >= range.smallest.crowning);
    assert!(range.path[range.path.len() - 1].crowning <= range.largest.crowning);
    for pair in range.path.windows(2) {
        assert!(pair[1].crowning > pair[0].crowning, "{:?} {:?} of {:?}", pair[0], pair[1], range.smallest);
        // The K chart changes fast near its pole, never by leaps: less than half a turn, and the same sign of gamma.
        assert!((pair[1].dk[0] - pair[0].dk[0]).abs() < 2.0, "{:?} {:?}", pair[0], pair[1]);
        assert!((chain.crossing_angle + pair[1].dk[1]) * chain.crossing_angle > 0.0);
    }
    for at in range.path.iter().step_by(5) {
        let profile = DressedProfile::tilted(dresser, &at.chart);
        let middle = -at.crowning * GEAR_BASE_HELIX.cos();
        for (w, f) in [(used.w_nf, 0.0), (used.middle(), middle), (used.w_na, 0.0)] {
            let (tilted, plain) =
                (profile.at_roll(w).unwrap(), DressedProfile::new(tool, flank, at.dk).at_roll(w).unwrap());
            // A corrector that stalls below 1e-7 of its scaled unknowns has converged (`docs/mathematics/dressing.md#conditions`).
            assert!((tilted.f - f).abs() < 1e-8, "{at:?}: {} {f}", tilted.f);
            assert!((tilted.f - plain.f).abs() < 1e-8 && (tilted.t - plain.t).abs() < 1e-5, "{at:?}");
        }
        // Near the loss of contact the dressed roll changes ever faster with everything: what a stalled corrector leaves of the
        // unknowns shows in it several times over.
        let steep = 1.0 + profile.roll_slope(used.w_na).unwrap();
        assert!((profile.at_parameter(used.w_na).unwrap().w - used.w_na).abs() < 1e-7 * steep);
        assert!((stretch(tool, flank, at.dk).unwrap() - at.stretch).abs() < 1e-6);
    }
    // What a fold ends, no correction exceeds; what a lost contact ends, ends at a circle that touches in one last point.
    for (end, way) in [(range.smallest, -1.0), (range.largest, 1.0)] {
        let last = if way < 0.0 { range.path[0] } else { range.path[range.path.len() - 1] };
        let profile = DressedProfile::tilted(dresser, &last.chart);
        match end.reason {
            PathReason::Fold => {
                let beyond = end.crowning * 1.02;
                let wish = three_points_with_map(dresser, [0.0, -beyond * GEAR_BASE_HELIX.cos(), 0.0]);
                let near = range.path[if way < 0.0 { 1 } else { range.path.len() - 2 }];
                assert!(ConditionSolver::new(tool, bodies.radius()).solve(&wish, &near.dk).is_err());
            }
            // The path itself may end before, where the circle t_Nf has lost the worm.
            PathReason::ContactLost if last.crowning != end.crowning => {}
            PathReason::ContactLost => {
                let slack = (0..=20).map(|k| profile.slack(used.w_nf + used.length() * f64::from(k) / 20.0));
                assert!(slack.fold(f64::INFINITY, f64::min) < 1e-3);
            }
            PathReason::OutOfDresser if last.crowning != end.crowning => {}
            PathReason::OutOfDresser => {
                let (from, to) = profile.interval();
                let reach = [used.w_nf, used.middle(), used.w_na].map(|w| profile.at_roll(w).unwrap().t);
                let near = reach.iter().any(|t| (t - from).min(to - t) < 0.01 * (to - from));
                assert!(near || reach.iter().any(|&t| profile.roll_slope(t).unwrap() < 0.1), "{reach:?}");
            }
            other => panic!("{other:?} at {last:?}"),
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    #[test]
    fn ranges_of_random_worms_hold(bodies in bodies(), flank in flanks()) {
        let Ok(tool) = bodies.tool() else { return Ok(()) };
        let range = whole(&bodies, &tool, flank);
        holds(&bodies, &tool, flank, &range);
    }
}

#[test]
fn hands_and_flanks_have_the_same_range() {
    let tool = CASE_A.tool().unwrap();
    let range = whole(&CASE_A, &tool, Flank::Left);
    holds(&CASE_A, &tool, Flank::Left, &range);
    let right = whole(&CASE_A, &tool, Flank::Right);
    let mirror = Bodies { hand: -1.0, ..CASE_A };
    let mirrored = whole(&mirror, &mirror.tool().unwrap(), Flank::Right);
    for other in [right, mirrored] {
        for (a, b) in [(range.smallest, other.smallest), (range.largest, other.largest)] {
            assert_eq!(a.reason, b.reason);
            assert!((a.crowning - b.crowning).abs() < 1e-6 * a.crowning.abs(), "{a:?} {b:?}");
        }
    }
}

#[test]
fn limits_end_the_range_where_they_stand() {
    let tool = CASE_A.tool().unwrap();
    let rows = rows(&CASE_A, &tool, Flank::Left);
    let free = 1e6;
    let mut axes = [[-free, free]; 4];
    axes[1] = [-0.02, 0.01];
    let range = rows.range(&CrowningLimits { axes: Some(axes), margin: None }).unwrap();
    for (end, k, limit) in
        [(range.smallest, 0, axes[1][1]), (range.largest, range.path.len() - 1, axes[1][0])]
    {
        assert_eq!(end.reason, PathReason::AxisLimit(1));
        let at = range.path[k].dk[1];
        assert!((at - limit).abs() < 1e-5 && (-0.02..=0.01).contains(&at), "{at} {limit}");
    }
    // A margin of the caller; the axis that comes first counts.
    let above = |dk: &DressingCorrection| 1.0 - dk[3];
    let range = rows.range(&CrowningLimits { axes: Some(axes), margin: Some(&above) }).unwrap();
    assert_eq!((range.smallest.reason, range.largest.reason), (PathReason::AxisLimit(1), PathReason::Limit));
    assert!((range.path[range.path.len() - 1].dk[3] - 1.0).abs() < 1e-4);
}

#[test]
fn the_range_goes_on_from_another_start() {
    let tool = CASE_A.tool().unwrap();
    let plain = whole(&CASE_A, &tool, Flank::Left);
    let shift = 0.002;
    let base = [0.0, -shift * GEAR_BASE_HELIX.cos(), 0.0];
    let dk = ConditionSolver::new(&tool, 50.0)
        .solve(&three_points_with_map(&tool.flanks.left, base), &[0.0; 4])
        .unwrap();
    let moved =
        rows(&CASE_A, &tool, Flank::Left).from_start(dk, base).range(&CrowningLimits::default()).unwrap();
    assert!((moved.smallest.crowning + shift - plain.smallest.crowning).abs() < 1e-8);
    assert!((moved.largest.crowning + shift - plain.largest.crowning).abs() < 1e-6);
}

fn says(error: &DressingError, code: &str, parts: &[&str]) {
    assert_eq!(error.code(), code);
    let text = error.to_string();
    assert!(parts.iter().all(|part| text.contains(part)), "{text}");
    assert!(!error.way_out().is_empty());
}

#[test]
fn impossible_ranges_are_refused() {
    let tool = CASE_A.tool().unwrap();
    let rows = rows(&CASE_A, &tool, Flank::Left);
    let none = CrowningLimits::default();
    let collides = |_: &DressingCorrection| -0.1;
    let error = rows.range(&CrowningLimits { axes: None, margin: Some(&collides) }).unwrap_err();
    says(&error, "no-zero", &["left", "0.0 percent", "limit"]);
    let nan = |_: &DressingCorrection| f64::NAN;
    let error = rows.range(&CrowningLimits { axes: None, margin: Some(&nan) }).unwrap_err();
    says(&error, "no-zero", &["limit"]);
    let axes = Some([[1.0, -1.0], [0.0, 1.0], [0.0, 1.0], [0.0, 1.0]]);
    says(&rows.range(&CrowningLimits { axes, margin: None }).unwrap_err(), "invalid-number", &["axis limit"]);
    let error = rows.from_start([0.0, f64::NAN, 0.0, 0.0], [0.0; 3]).range(&none).unwrap_err();
    says(&error, "invalid-number", &["start correction", "NaN"]);
    let error = rows.from_start([0.0; 4], [0.0, f64::INFINITY, 0.0]).range(&none).unwrap_err();
    says(&error, "invalid-number", &["modification at the start", "inf"]);
    let error = CrowningRows::new(&tool.flanks.left, -3.0, 0.5).range(&none).unwrap_err();
    says(&error, "invalid-number", &["reference radius", "-3"]);
    let error = CrowningRows::new(&tool.flanks.left, 50.0, 2.0).range(&none).unwrap_err();
    says(&error, "invalid-number", &["base helix"]);
    // A profile that the start cannot make.
    let error = rows.from_start([0.0; 4], [0.0, 5.0, 0.0]).range(&none).unwrap_err();
    says(&error, "no-zero", &["0.0 percent"]);
    // Parallel axes: the K chart has its pole in the start.
    let parallel = Sides::both(DressingChain { crossing_angle: 0.0, ..CASE_A.chains().left });
    let tool = DresserTool::conjugate(&CASE_A.worm(), parallel, CASE_A.ranges()).unwrap();
    let error = CrowningRows::new(&tool.flanks.left, 50.0, 0.5).range(&none).unwrap_err();
    says(&error, "pole-of-chart", &["crossing angle 0"]);
    let chart = TiltChart::from_kinematics([0.0, 0.0, 100.0, 0.0], 8.9);
    says(&chart.to_kinematics_along(8.9, &[0.0, -0.1, 100.0, 0.0]).unwrap_err(), "pole-of-chart", &[]);
}
