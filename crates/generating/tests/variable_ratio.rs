//! Diagonal ratios that vary over the feed: a wanted curve makes a tool shift and the tool shift makes the curve again, on
//! either flank and hand; derivatives; every refusal. The reference numbers are checked by `verify`.

use crate::cylindrical_pair::{lines, pair};
use contact::{ExactContact, ModifiedThread, ThreadFunction};
use foundation::geometry::Flank;
use foundation::kinematics::{InverseLaw, MotionLaw};
use generating::{
    CurveLaw, FlankLines, GeneratingError, LineFunctions, LineWorm, VariableRatio, WantedCurve,
};
use proptest::prelude::*;

fn sine(slope: f64) -> WantedCurve {
    let law = CurveLaw::LineSine { slope, origin: 13.6, amplitude: 2.0, phase_length: 4.0 };
    WantedCurve { law, line: 3.0, roll: [-60.0, 80.0] }
}

fn blend(slope: f64) -> WantedCurve {
    let law = CurveLaw::LineBlend { slope, turn: 13.0, half_length: 4.0, level: 9.0 * slope.signum() };
    WantedCurve { law, line: -2.0, roll: [-60.0, 80.0] }
}

/// The same curve as a spline through a table.
fn tabulated(curve: &WantedCurve) -> WantedCurve {
    let w: Vec<f64> = (0..=280).map(|k| -60.0 + 0.5 * f64::from(k)).collect();
    let z: Vec<f64> = w.iter().map(|&w| curve.law.jet(w)[0]).collect();
    WantedCurve { law: CurveLaw::Law(MotionLaw::spline(&w, &z).unwrap()), ..curve.clone() }
}

/// Curves that cross the contact paths of the flank in one sense.
fn wanted(lines: &FlankLines) -> Vec<WantedCurve> {
    let side = lines.t_k.signum();
    vec![sine(1.2 * side), blend(1.2 * side), tabulated(&sine(1.1 * side))]
}

fn cases() -> Vec<(FlankLines, WantedCurve)> {
    let mut cases = Vec::new();
    for helix in [20.0, -20.0] {
        let pair = pair(helix);
        for flank in Flank::BOTH {
            let lines = lines(&pair, flank);
            cases.extend(wanted(&lines).into_iter().map(|curve| (lines, curve)));
        }
    }
    cases
}

fn rolls(lines: &FlankLines) -> impl Iterator<Item = f64> + use<> {
    let [from, to] = lines.roll;
    (0..=60).map(move |k| from + (to - from) * f64::from(k) / 60.0)
}

#[test]
fn a_curve_makes_a_shift_that_makes_the_curve() {
    let mut worst: f64 = 0.0;
    for (lines, curve) in cases() {
        let shift = curve.shift(&lines).unwrap();
        let ratio = VariableRatio::new(&lines, &shift);
        for w in rolls(&lines) {
            let ([z, slope, _], [found, along, _]) = (curve.law.jet(w), ratio.curve(w, curve.line).unwrap());
            worst = worst.max((found - z).abs());
            assert!((found - z).abs() < 1e-6, "{curve:?} at {w}: {found} for {z}");
            assert!((along - slope).abs() < 1e-6, "{curve:?} at {w}");
            assert!((ratio.line_coordinate(w, z) - curve.line).abs() < 1e-6);
            assert!((ratio.local_direction(w, z) + slope).abs() < 1e-6);
            let closed = lines.big_t1 / (lines.cos_b2 * (lines.t_k + slope));
            assert!((ratio.local_ratio(w, z) / closed - 1.0).abs() < 1e-6);
            let (w_1, z_1) = ratio.worm_point(w, z);
            assert!((lines.worm_line(w_1, z_1) - curve.line).abs() < 1e-6);
        }
    }
    // Cubics with exact slopes: far below the micrometre of a table without them.
    assert!(worst < 1e-8, "{worst}");
}

#[test]
fn other_lines_lie_along_the_contact_path() {
    for (lines, curve) in cases() {
        let shift = curve.shift(&lines).unwrap();
        let ratio = VariableRatio::new(&lines, &shift);
        for difference in [-4.0, 1.5] {
            let [dw, dz] = lines.curve_displacement(difference).unwrap();
            assert!((dz + lines.t_k * dw).abs() < 1e-14);
            let mut inside = 0;
            for w in rolls(&lines) {
                let here = ratio.curve(w, curve.line).unwrap()[0];
                let Ok([moved, ..]) = ratio.curve(w + dw, curve.line + difference) else { continue };
                assert!((moved - here - dz).abs() < 1e-9, "{curve:?} at {w}");
                inside += 1;
            }
            assert!(inside > 30);
        }
    }
}

#[test]
fn the_same_shift_has_its_own_curves_on_the_other_flank() {
    let pair = pair(20.0);
    let (left, right) = (lines(&pair, Flank::Left), lines(&pair, Flank::Right));
    let shift = sine(1.2).shift(&left).unwrap();
    let other = VariableRatio::new(&right, &shift);
    let x_1 = other.line_coordinate(right.w_m, 0.0);
    let mut bent = 0.0;
    for w in rolls(&right) {
        // A curve may leave the feeds that the left flank asked for.
        let Ok([z, slope, bend]) = other.curve(w, x_1) else { continue };
        assert!((other.line_coordinate(w, z) - x_1).abs() < 1e-9);
        assert!((other.local_direction(w, z) + slope).abs() < 1e-9);
        bent += bend.abs();
    }
    assert!(bent > 0.1, "the sine of the left flank is seen on the right one: {bent}");
}

#[test]
fn derivatives_are_those_of_the_functions() {
    for (lines, curve) in cases() {
        let shift = curve.shift(&lines).unwrap();
        let ratio = VariableRatio::new(&lines, &shift);
        let h = 1e-4;
        for (w, z) in [(8.1, -7.3), (12.7, 1.9), (19.2, 8.8)] {
            let f = |w: f64, z: f64| lines.line_coordinate(shift.law(), w, z);
            let at = f(w, z);
            let [pw, mw, pz, mz] = [f(w + h, z), f(w - h, z), f(w, z + h), f(w, z - h)];
            for (exact, difference) in [
                (at.fu, (pw.f - mw.f) / (2.0 * h)),
                (at.fv, (pz.f - mz.f) / (2.0 * h)),
                (at.fuu, (pw.fu - mw.fu) / (2.0 * h)),
                (at.fuv, (pw.fv - mw.fv) / (2.0 * h)),
                (at.fvv, (pz.fv - mz.fv) / (2.0 * h)),
            ] {
                assert!((exact - difference).abs() < 1e-5 * (1.0 + exact.abs()), "{exact} {difference}");
            }
            let x_1 = at.f;
            let z_at = |w: f64| ratio.curve(w, x_1).unwrap();
            let bend = (z_at(w + h)[1] - z_at(w - h)[1]) / (2.0 * h);
            assert!((z_at(w)[2] - bend).abs() < 1e-4 * (1.0 + bend.abs()));
        }
    }
}

#[test]
fn a_constant_ratio_is_the_straight_case() {
    let lines = lines(&pair(20.0), Flank::Left);
    let law = MotionLaw::polynomial(0.0, vec![2.0, 0.8]);
    let shift = InverseLaw::new(law, [-40.0, 40.0]).unwrap();
    let ratio = VariableRatio::new(&lines, &shift);
    let x_1 = ratio.line_coordinate(lines.w_m, 1.0);
    for w in rolls(&lines) {
        let [z, slope, bend] = ratio.curve(w, x_1).unwrap();
        assert!((slope + lines.work_direction(0.8)).abs() < 1e-12 && bend == 0.0);
        let (w_1, z_1) = ratio.worm_point(w, z);
        let [back_w, back_z] = lines.work_point(w_1, z_1, &MotionLaw::polynomial(0.0, vec![2.0, 0.8]));
        assert!((back_w.f - w).abs() < 1e-11 && (back_z.f - z).abs() < 1e-11);
    }
}

#[test]
fn three_values_make_the_functions_of_a_line() {
    let lines = lines(&pair(-20.0), Flank::Right);
    let shift = blend(1.2).shift(&lines).unwrap();
    let ratio = VariableRatio::new(&lines, &shift);
    // A parabola over w along every curve, of an amount that depends on the line.
    let f = |w: f64, z: f64| {
        let x_1 = ratio.line_coordinate(w, z);
        1e-3 * (x_1 + 0.2 * w - 0.015 * w * w)
    };
    for x_1 in [-3.0, 0.0, 2.0] {
        let functions = LineFunctions::of_flank(&ratio, &lines, x_1, |w, z| Ok(f(w, z))).unwrap();
        let [c, l, q] = functions.raw();
        for w in rolls(&lines) {
            let z = ratio.curve(w, x_1).unwrap()[0];
            let w_1 = lines.worm_roll(w);
            let wanted = -lines.cos_b2 / lines.cos_b1 * f(w, z);
            assert!((functions.value(w_1) - wanted).abs() < 1e-12);
            // Raw powers cancel: some 1e-16 of terms some hundred times larger.
            assert!((c + w_1 * (l + w_1 * q) - wanted).abs() < 1e-10);
        }
    }
    let same = LineFunctions::through(&lines, [8.0, 8.0, 9.0], [0.0, 1.0, 2.0]);
    assert_eq!(same.unwrap_err().code(), "invalid-number");
    let far = LineFunctions::of_flank(&ratio, &lines, 1e4, |w, z| Ok(f(w, z)));
    assert_eq!(far.unwrap_err().code(), "law-outside-range");
}

/// A C2 worm: what it leaves on the flank is its functions to first order, and their slope squared is the error.
#[test]
fn a_worm_of_line_functions_leaves_them_on_the_flank() {
    let pair = pair(20.0);
    let lines = lines(&pair, Flank::Left);
    let shift = sine(1.2).shift(&lines).unwrap();
    let ratio = VariableRatio::new(&lines, &shift);
    let centre = lines.worm_roll(lines.w_m);
    let law = |c: f64| {
        let x: Vec<f64> = (0..60).map(|k| f64::from(k) * 2.0 - 60.0).collect();
        let y: Vec<f64> = x.iter().map(|x| c * (0.1 * x).sin()).collect();
        MotionLaw::spline(&x, &y).unwrap()
    };
    let worm = LineWorm { lines, centre, functions: [law(2e-3), law(1e-5), law(1e-7)] };
    let h = 1e-3;
    let f = |w: f64, z: f64| ThreadFunction::jet(&worm, w, z).unwrap();
    let (w_1, z_1) = ratio.worm_point(lines.w_m, 2.0);
    let at = f(w_1, z_1);
    let by_w = (f(w_1 + h, z_1).f - f(w_1 - h, z_1).f) / (2.0 * h);
    let by_z = (f(w_1, z_1 + h).fu - f(w_1, z_1 - h).fu) / (2.0 * h);
    assert!((at.fu - by_w).abs() < 1e-9 && (at.fuv - by_z).abs() < 1e-9, "{at:?} {by_w} {by_z}");

    let motion = pair.motion(shift.law().clone());
    let thread = ModifiedThread::new(pair.flanks.left.worm, &worm);
    let exact = ExactContact::new(&pair, Flank::Left, &motion, &thread);
    for (w, z) in [(8.0, -9.0), (13.0, 0.5), (19.0, 7.0)] {
        let (w_1, z_1) = ratio.worm_point(w, z);
        let first = -f(w_1, z_1).f;
        let ground = exact.solve(w, z).unwrap().f_n;
        assert!(first.abs() > 1e-4 && (ground - first).abs() < 0.05e-3, "{ground} {first}");
    }
}

#[test]
fn refusals_have_codes_and_ways_out() {
    let lines = lines(&pair(20.0), Flank::Left);
    let error = |curve: WantedCurve, lines: &FlankLines| {
        let error = curve.shift(lines).unwrap_err();
        assert!(!error.way_out().is_empty() && !error.to_string().is_empty(), "{error}");
        assert!(error.is_bad_input(), "{error}");
        error.code()
    };
    let short = WantedCurve { roll: [5.0, 21.0], ..sine(1.2) };
    assert_eq!(error(short, &lines), "range-not-covered");
    // Against the contact path (t_K = 0.34) and along it.
    assert_eq!(error(sine(-0.1), &lines), "curve-not-a-function");
    let along = CurveLaw::Law(MotionLaw::polynomial(0.0, vec![0.0, -lines.t_k]));
    assert_eq!(error(WantedCurve { law: along, ..sine(1.0) }, &lines), "curve-not-a-function");
    let blow_up = CurveLaw::Law(MotionLaw::polynomial(0.0, vec![0.0, 1.0, 1e308]));
    assert_eq!(error(WantedCurve { law: blow_up, ..sine(1.0) }, &lines), "curve-not-a-function");
    let parallel = FlankLines { big_t1: 0.0, ..lines };
    assert_eq!(error(sine(1.2), &parallel), "worm-direction-degenerate");
    assert!(matches!(
        parallel.curve_displacement(1.0).unwrap_err(),
        GeneratingError::WormDirectionDegenerate { flank: Flank::Left, .. }
    ));
    for curve in [
        WantedCurve { line: f64::NAN, ..sine(1.2) },
        WantedCurve { roll: [80.0, -60.0], ..sine(1.2) },
        WantedCurve { roll: [f64::NEG_INFINITY, 60.0], ..sine(1.2) },
        WantedCurve {
            law: CurveLaw::LineSine { slope: 1.2, origin: 0.0, amplitude: 2.0, phase_length: 0.0 },
            ..sine(1.2)
        },
        WantedCurve {
            law: CurveLaw::LineBlend { slope: 1.2, turn: 13.0, half_length: 0.0, level: 9.0 },
            ..sine(1.2)
        },
        WantedCurve {
            law: CurveLaw::LineBlend { slope: f64::NAN, turn: 13.0, half_length: 1.0, level: 9.0 },
            ..sine(1.2)
        },
    ] {
        assert_eq!(error(curve, &lines), "invalid-number");
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    /// Any sine over any line steeper than its swing, on either hand and flank.
    #[test]
    fn any_curve_comes_back(
        left_hand: bool, left: bool, slope in 1.0..3.0f64, amplitude in -2.0..2.0f64, phase in 4.0..9.0f64,
        line in -10.0..10.0f64, share in 0.0..1.0f64,
    ) {
        let pair = pair(if left_hand { -20.0 } else { 20.0 });
        let lines = lines(&pair, if left { Flank::Left } else { Flank::Right });
        let law = CurveLaw::LineSine {
            slope: slope * lines.t_k.signum(), origin: 13.0, amplitude, phase_length: phase,
        };
        let curve = WantedCurve { law, line, roll: [-60.0, 90.0] };
        let shift = curve.shift(&lines).unwrap();
        let w = lines.roll[0] + share * (lines.roll[1] - lines.roll[0]);
        let [z, ..] = VariableRatio::new(&lines, &shift).curve(w, line).unwrap();
        prop_assert!((z - curve.law.jet(w)[0]).abs() < 1e-6);
    }
}
