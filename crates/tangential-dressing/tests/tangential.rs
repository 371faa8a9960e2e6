//! Tangential dressing by its public functions: what holds for every gear, what is refused, what fits find again.

use contact::Measure;
use foundation::geometry::{Flank, Gear, GearData, Sides};
use nalgebra::{DMatrix, DVector};
use std::f64::consts::FRAC_PI_2;
use tangential_dressing::{
    Channel, EdgeAmounts, FitGrid, FitLimits, FitMethod, FitTask, ProfileKind, RollGrid, ShiftOffset,
    ShiftRatio, TangentialError, TangentialFlank, TangentialInput, TangentialModel, TangentialSettings,
    Variable, Weights,
};

/// The source's gear with another helix angle and profile shift.
fn work(helix_deg: f64, profile_shift: f64) -> GearData {
    GearData {
        teeth: 19,
        normal_module: 3.5,
        pressure_angle: Sides::both(17.5f64.to_radians()),
        helix_angle: helix_deg.to_radians(),
        profile_shift,
        cone_angle: 0.0,
    }
}

/// Gear, sign of the worm's hand, radii between which the flank is evaluated.
fn input(gear: GearData, hand: f64, radii: [f64; 2]) -> TangentialInput {
    let pitch_radius = 95.625;
    let lead_angle = (3.0 * gear.normal_module / (2.0 * pitch_radius)).asin();
    let worm =
        GearData { teeth: 3, helix_angle: hand * (FRAC_PI_2 - lead_angle), profile_shift: 0.0, ..gear };
    TangentialInput {
        gear: Gear::new(gear).unwrap(),
        worm: Gear::new(worm).unwrap(),
        worm_tip_radius: None,
        dresser_pitch_radius: 57.825,
        dresser_tip_radius: None,
        dresser_depth: None,
        profile: ProfileKind::Conjugate,
        radii,
        faces: [-20.0, 20.0],
        face_width: 40.0,
        shift_width: 48.1042,
        shift_ratio: ShiftRatio::Width,
        shift_offset: ShiftOffset::Given(0.0),
    }
}

/// Radii of the source.
const RADII: [f64; 2] = [38.10325, 44.26575];

fn source() -> TangentialInput {
    input(work(-35.0, 0.0), -1.0, RADII)
}

fn variable(name: &str) -> Variable {
    name.parse().unwrap()
}

fn settings(values: &[(&str, f64)]) -> TangentialSettings {
    let mut settings = TangentialSettings::default();
    for (name, value) in values {
        settings.set(&variable(name), *value);
    }
    settings
}

/// Every channel at once, mm and rad.
const ALL: [(&str, f64); 24] = [
    ("Fp1", 0.002),
    ("Fp2", 0.004),
    ("Fp4", 0.001),
    ("FpL2", 0.0015),
    ("FpR1", 0.001),
    ("Fz0", 0.1),
    ("Fz2", 0.3),
    ("Fz3", -0.05),
    ("dX1", 0.01),
    ("dX2", -0.03),
    ("dA1", 0.01),
    ("dA2", 0.02),
    ("gA0", 0.0004),
    ("gA1", 0.0001),
    ("gam0", 0.05),
    ("gam1", 0.05),
    ("dist1", -0.004),
    ("dist2", 0.003),
    ("FC1", 0.01),
    ("FC2", 0.02),
    ("FC3", 0.002),
    ("FT0", -2.0),
    ("FT2", 0.3),
    ("kap", 0.05),
];

fn ground<'m>(
    model: &'m TangentialModel,
    flank: Flank,
    settings: &TangentialSettings,
    measure: Measure,
) -> TangentialFlank<'m> {
    TangentialFlank::new(model, flank, &[flank], settings, measure)
}

#[test]
fn the_unmodified_flank_is_exact_for_all_hands_and_gears() {
    let bodies = [
        ("right on right", work(35.0, 0.0), 1.0, RADII),
        ("right on left", work(-35.0, 0.0), 1.0, RADII),
        ("left on right", work(35.0, 0.0), -1.0, RADII),
        ("left on left", work(-35.0, 0.0), -1.0, RADII),
        ("spur", work(0.0, 0.0), 1.0, [32.0, 36.75]),
        ("12 deg", work(12.0, 0.0), -1.0, [32.7, 37.5]),
        ("profile shift", work(-35.0, 0.3), -1.0, [38.5, 45.2]),
    ];
    for (name, gear, hand, radii) in bodies {
        let model = TangentialModel::new(input(gear, hand, radii)).unwrap();
        assert_eq!(model.neutral_ratio().is_none(), name == "spur");
        for flank in Flank::BOTH {
            for measure in [Measure::Arc, Measure::Ray] {
                let plain = ground(&model, flank, &TangentialSettings::default(), measure);
                for point in plain.solve(&FitGrid::Radii(7).of(&model, flank)).unwrap() {
                    assert!(point.deviation.abs() < 1e-9, "{name} {flank} {point:?}");
                    assert!((point.determinant_ratio - 1.0).abs() < 1e-6, "{name} {flank} {point:?}");
                }
            }
        }
    }
}

/// The settings whose right flank is the left one of `settings` turned by half a turn about the common perpendicular.
fn mirrored(settings: &TangentialSettings) -> TangentialSettings {
    let mut mirrored = TangentialSettings::default();
    for (variable, value) in settings.values() {
        let name = variable.to_string();
        let even = name.ends_with(['0', '2', '4']);
        let (channel, turned) = match variable.channel {
            Channel::Profile(side) => (Channel::Profile(side.map(Flank::other)), false),
            Channel::ShiftRatio => (variable.channel, false),
            Channel::TangentialShift | Channel::AxialOffset | Channel::WorkTurn | Channel::ToolShift => {
                (variable.channel, even)
            }
            _ => (variable.channel, !even),
        };
        let turned_variable = Variable { channel, shape: variable.shape.clone() };
        mirrored.set(&turned_variable, if turned { -value } else { *value });
    }
    mirrored
}

#[test]
fn both_flanks_are_mirror_images() {
    let model = TangentialModel::new(source()).unwrap();
    let settings = settings(&ALL);
    let mirrored = mirrored(&settings);
    for measure in [Measure::Arc, Measure::Ray] {
        let grid = FitGrid::Radii(5).of(&model, Flank::Left);
        let n = grid.z.len();
        let left = ground(&model, Flank::Left, &settings, measure).deviations(&grid).unwrap();
        let right = ground(&model, Flank::Right, &mirrored, measure).deviations(&grid).unwrap();
        assert!(left.iter().any(|m| m.abs() > 0.01));
        for (k, m) in left.iter().enumerate() {
            let across = right[k / n * n + n - 1 - k % n];
            assert!((m - across).abs() < 1e-9, "{k}: {m} {across}");
        }
    }
}

#[test]
fn sensitivities_are_derivatives() {
    let model = TangentialModel::new(source()).unwrap();
    let at = settings(&ALL);
    let mut variables: Vec<Variable> = ALL.iter().map(|(name, _)| variable(name)).collect();
    // A spline's functions are variables as any other.
    let range = model.spline_range(Channel::AxialOffset, &[Flank::Left]);
    variables.extend(Variable::spline(Channel::AxialOffset, 4, range).unwrap().into_iter().skip(2).take(2));
    for flank in Flank::BOTH {
        for measure in [Measure::Arc, Measure::Ray] {
            let grid = FitGrid::Graded(4).of(&model, flank);
            let (_, by) = ground(&model, flank, &at, measure).linearised(&grid, &variables).unwrap();
            for (j, variable) in variables.iter().enumerate() {
                let value = at.value(variable);
                let moved = |step: f64| -> Vec<f64> {
                    let moved = at.with(std::slice::from_ref(variable), &[value + step]);
                    ground(&model, flank, &moved, measure)
                        .solve_beyond_tool(&grid)
                        .unwrap()
                        .iter()
                        .map(|p| p.deviation)
                        .collect()
                };
                // Angles act on a lever of some hundred millimetres.
                let h = if variable.channel == Channel::DressingAngle { 1e-6 } else { 3e-5 };
                let slope = |h: f64| -> Vec<f64> {
                    let (above, below) = (moved(h), moved(-h));
                    above.iter().zip(below).map(|(a, b)| (a - b) / (2.0 * h)).collect()
                };
                let (near, far) = (slope(h), slope(2.0 * h));
                for (i, (near, far)) in near.iter().zip(far).enumerate() {
                    let (expected, found) = ((4.0 * near - far) / 3.0, by[(i, j)]);
                    let apart = (expected - found).abs();
                    assert!(apart < 2e-7 * (1.0 + found.abs()), "{variable} at {i}: {expected} {found}");
                }
            }
        }
    }
}

/// The coefficients of spline functions that make a function of their abscissa.
fn spline_values(functions: &[Variable], [from, to]: [f64; 2], f: impl Fn(f64) -> f64) -> Vec<f64> {
    let samples = 4 * functions.len();
    let x: Vec<f64> = (0..samples).map(|i| from + (to - from) * (i as f64 + 0.5) / samples as f64).collect();
    let a = DMatrix::from_fn(samples, functions.len(), |i, j| functions[j].shape.value(x[i]));
    let b = DVector::from_fn(samples, |i, _| f(x[i]));
    a.svd(true, true).solve(&b, 1e-14).unwrap().as_slice().to_vec()
}

#[test]
fn splines_grind_what_the_polynomials_that_they_repeat_do() {
    let model = TangentialModel::new(source()).unwrap();
    let flank = Flank::Right;
    let powers = settings(&[
        ("Fp1", 0.002),
        ("Fp3", 0.004),
        ("FpR2", 0.003),
        ("Fz2", 0.3),
        ("dX2", -0.03),
        ("dX4", 0.001),
        ("dA1", 0.01),
        ("gA2", 0.0002),
        ("gam1", 0.05),
        ("dist2", 0.003),
        ("FC2", 0.02),
        ("FC3", 0.002),
        ("FT2", 0.3),
    ]);
    let mut splines = TangentialSettings::default();
    for channel in Channel::ALL.into_iter().filter(|&channel| channel != Channel::ShiftRatio) {
        let own: Vec<_> = powers.values().iter().filter(|(v, _)| v.channel == channel).collect();
        let range = model.spline_range(channel, &[flank]);
        let functions = Variable::spline(channel, 6, range).unwrap();
        let value = |x: f64| own.iter().map(|(v, c)| c * v.shape.value(x)).sum();
        for (function, c) in functions.iter().zip(spline_values(&functions, range, value)) {
            splines.set(function, c);
        }
    }
    let grid = FitGrid::Radii(5).of(&model, flank);
    let by_powers = ground(&model, flank, &powers, Measure::Ray).deviations(&grid).unwrap();
    let by_splines = ground(&model, flank, &splines, Measure::Ray).deviations(&grid).unwrap();
    assert!(by_powers.iter().any(|m| m.abs() > 0.01));
    for (a, b) in by_powers.iter().zip(by_splines) {
        assert!((a - b).abs() < 1e-9, "{a} {b}");
    }
}

/// A task on one flank of the source's gear.
fn task<'a>(
    model: &'a TangentialModel,
    pass: &'a [Flank],
    wanted: &'a (dyn Fn(Flank, f64, f64) -> f64 + Sync),
) -> FitTask<'a> {
    FitTask {
        model,
        pass,
        wanted,
        fixed: TangentialSettings::default(),
        measure: Measure::Ray,
        grid: FitGrid::Graded(7),
        weights: Weights::Uniform,
        limits: FitLimits::SOURCE,
    }
}

#[test]
fn fits_find_the_settings_that_a_flank_was_made_with() {
    let model = TangentialModel::new(source()).unwrap();
    let made = [
        ("Fp1", -0.0022),
        ("Fp2", 0.0054),
        ("Fp3", 0.0038),
        ("dist0", -0.0002),
        ("dX2", -0.0065),
        ("dA1", 0.003),
        ("FC2", 0.0047),
        ("FC3", 0.0002),
    ];
    let free: Vec<Variable> = made.iter().map(|(name, _)| variable(name)).collect();
    for flank in Flank::BOTH {
        let target = ground(&model, flank, &settings(&made), Measure::Ray);
        let wanted = |_: Flank, w: f64, z: f64| {
            target.deviations(&RollGrid { w: vec![w], z: vec![z] }).map_or(f64::NAN, |m| m[0])
        };
        let pass = [flank];
        let task = task(&model, &pass, &wanted);
        for method in FitMethod::ALL {
            for steps in [1, 3] {
                let fit = task.fit_in_steps(&free, &[0.0; 8], method, steps).unwrap();
                let fit = fit.require_convergence().unwrap();
                assert_eq!(fit.steps, steps);
                // Damping slows the last rounds down, and the loop ends where its residual changes by a millionth.
                for ((name, value), found) in made.iter().zip(&fit.values) {
                    assert!((value - found).abs() < 1e-7, "{} {name}: {value} {found}", method.name());
                }
                assert!(fit.largest < 1e-8, "{} {}", method.name(), fit.largest);
            }
        }
    }
}

#[test]
fn bodies_that_cannot_be_are_refused_by_name() {
    let refused = |input: TangentialInput, expected: &str| {
        let error = TangentialModel::new(input).unwrap_err();
        assert!(error.is_bad_input() && !error.way_out().is_empty(), "{error}");
        assert_eq!(error.code(), "invalid-number");
        match &error {
            TangentialError::InvalidNumber { field, .. } => assert_eq!(*field, expected, "{error}"),
            other => panic!("{expected}: {other}"),
        }
    };
    let good = source();
    let gear = |data: GearData| TangentialInput { gear: Gear::new(data).unwrap(), ..good };
    let worm = |data: GearData| TangentialInput { worm: Gear::new(data).unwrap(), ..good };
    let (work, thread) = (*good.gear.data(), *good.worm.data());
    let angle = |deg: f64| Sides::both(f64::to_radians(deg));
    refused(gear(GearData { teeth: -60, ..work }), "teeth");
    refused(worm(GearData { cone_angle: 0.01, ..thread }), "cone angle of the worm");
    refused(gear(GearData { pressure_angle: angle(46.0), ..work }), "normal_pressure_angle");
    refused(worm(GearData { helix_angle: 0.0, ..thread }), "pitch diameter of the worm");
    // A worm of 16 mm has its base circle above its root.
    let steep = -(FRAC_PI_2 - (3.0f64 * 3.5 / 16.0).asin());
    refused(worm(GearData { helix_angle: steep, ..thread }), "pitch radius of the worm");
    refused(TangentialInput { radii: [37.88, 44.0], ..good }, "start radius");
    refused(TangentialInput { radii: [44.0, 39.0], ..good }, "end radius");
    refused(TangentialInput { faces: [20.0, -20.0], ..good }, "end of the face");
    for value in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        refused(TangentialInput { face_width: value, ..good }, "face_width");
        refused(TangentialInput { shift_width: value, ..good }, "shift_width");
        refused(TangentialInput { dresser_pitch_radius: value, ..good }, "pitch radius of the dresser");
    }
    for value in [f64::NAN, f64::INFINITY] {
        refused(TangentialInput { shift_ratio: ShiftRatio::Given(value), ..good }, "shift_ratio");
        refused(TangentialInput { shift_offset: ShiftOffset::Given(value), ..good }, "shift_offset");
    }
    let spur = input(self::work(0.0, 0.0), 1.0, [32.0, 36.75]);
    refused(TangentialInput { shift_ratio: ShiftRatio::Neutral(Sides::both(true)), ..spur }, "shift_ratio");
    // A module that is none stops at the body itself.
    let error = TangentialError::from(Gear::new(GearData { normal_module: 0.0, ..work }).unwrap_err());
    assert!(error.is_bad_input());
}

#[test]
fn what_worm_or_dresser_do_not_reach_is_refused_with_its_place() {
    let plain = TangentialSettings::default();
    // The unmodified flank uses the dresser from -3.764 to 2.988 mm.
    let cases = [
        (Some(95.625 + 3.5), None, RADII[0], -3.5),
        (None, Some(57.825 + 2.5), RADII[1], 2.5),
        (Some(100.0), Some(61.5), f64::NAN, f64::NAN),
    ];
    for (worm_tip_radius, dresser_tip_radius, expected, end) in cases {
        let model = TangentialModel::new(TangentialInput { worm_tip_radius, dresser_tip_radius, ..source() })
            .unwrap();
        let flank = ground(&model, Flank::Left, &plain, Measure::Ray);
        let grid = FitGrid::Radii(5).of(&model, Flank::Left);
        assert_eq!(flank.solve_beyond_tool(&grid).unwrap().len(), 25);
        match flank.solve(&grid) {
            Ok(_) => assert!(expected.is_nan()),
            Err(error @ TangentialError::OutsideTool { radius, s, from, to, .. }) => {
                assert!((radius - expected).abs() < 1e-9 && (s < from || s > to), "{error}");
                assert!((from - end).abs() < 1e-9 || (to - end).abs() < 1e-9, "{error}");
                assert_eq!((error.code(), error.is_bad_input()), ("outside-tool", false));
                assert_eq!(flank.deviations(&grid).unwrap_err(), error);
            }
            Err(other) => panic!("{other}"),
        }
    }
}

#[test]
fn a_dresser_may_reach_below_the_tip_of_the_worm() {
    let short = TangentialInput { worm_tip_radius: Some(95.625 + 3.5), ..source() };
    let solved = |input: TangentialInput| {
        let model = TangentialModel::new(input)?;
        let grid = FitGrid::Radii(5).of(&model, Flank::Left);
        ground(&model, Flank::Left, &TangentialSettings::default(), Measure::Ray).solve(&grid).map(|_| ())
    };
    let refused = solved(short).unwrap_err();
    // The refusal names the depth that suffices for all places, -3.764 mm.
    assert!(refused.way_out().contains("3.77 mm below its pitch circle"), "{}", refused.way_out());
    assert_eq!(solved(TangentialInput { dresser_depth: Some(3.77), ..short }), Ok(()));
    for depth in [0.0, -1.0, 10.0, f64::NAN] {
        let error = solved(TangentialInput { dresser_depth: Some(depth), ..short }).unwrap_err();
        assert!(error.is_bad_input() && error.to_string().contains("1.75 normal modules"), "{error}");
    }
}

#[test]
fn an_envelope_that_folds_is_undercut_and_no_number() {
    let model = TangentialModel::new(source()).unwrap();
    let flank = Flank::Right;
    let undercut = |found: Result<Vec<f64>, TangentialError>, place: (f64, f64)| match found {
        Err(
            error @ (TangentialError::Undercut { radius, z, ratio, .. }
            | TangentialError::NotSettled { radius, z, ratio, .. }),
        ) => {
            assert!((radius - place.0).abs() < 1e-9 && (z - place.1).abs() < 1e-9, "{error}");
            assert!((0.0..0.5).contains(&ratio), "{error}");
            // What ends above the limit of a fold is not called one.
            let code = if ratio < 0.3 { "undercut" } else { "contact-not-found" };
            assert_eq!((error.code(), error.is_bad_input()), (code, false));
        }
        other => panic!("{other:?}"),
    };
    let thinned = settings(&[("Fp3", -0.05)]);
    let start = model.rolls(flank)[0];
    for measure in [Measure::Arc, Measure::Ray] {
        let thinned = ground(&model, flank, &thinned, measure);
        for z in [-20.0, -10.0, 0.0, 10.0, 20.0] {
            undercut(thinned.deviations(&RollGrid { w: vec![start], z: vec![z] }), (RADII[0], z));
        }
        let radial = |crowning| model.radial_feed(flank, crowning, measure, FitGrid::Radii(5));
        undercut(radial(0.05).map(|r| r.deviations), (RADII[0], -20.0));
        let small = radial(0.01).unwrap();
        assert!((small.closed_twist + 24.5651e-3).abs() < 1e-7 && small.twist < small.closed_twist);
    }
}

#[test]
fn fits_without_effect_and_targets_that_are_no_numbers_are_refused() {
    let model = TangentialModel::new(source()).unwrap();
    let amounts = EdgeAmounts { lead_crowning: 0.01, ..EdgeAmounts::default() };
    let wanted = |flank: Flank, w: f64, z: f64| amounts.value(&model, flank, w, z);
    let pass = [Flank::Right];
    let task = task(&model, &pass, &wanted);
    // The other side of the dresser; angle and shift, which crossed involutes do not feel.
    for names in [&[][..], &["FpL1", "FpL2"], &["gam0"], &["FT1", "kap"]] {
        let free: Vec<Variable> = names.iter().map(|name| variable(name)).collect();
        for method in FitMethod::ALL {
            let error = task.fit(&free, &vec![0.0; free.len()], method).unwrap_err();
            assert_eq!(error, TangentialError::NoLiveVariable { count: free.len() }, "{names:?}");
            assert_eq!((error.code(), error.is_bad_input()), ("no-live-variable", true));
        }
    }
    for value in [f64::NAN, f64::INFINITY] {
        let wanted = |_: Flank, w: f64, _: f64| if w > 20.0 { value } else { 0.0 };
        let task = FitTask { wanted: &wanted, ..task.clone() };
        for method in FitMethod::ALL {
            let error = task.fit(&[variable("dX2")], &[0.0], method).unwrap_err();
            assert!(matches!(error, TangentialError::InvalidNumber { field: "target", .. }), "{error}");
            assert!(error.is_bad_input());
        }
    }
}

#[test]
fn a_fit_that_runs_out_of_rounds_says_so_with_its_best_values() {
    let model = TangentialModel::new(source()).unwrap();
    let amounts = EdgeAmounts { profile_crowning: 0.005, lead_crowning: 0.1, ..EdgeAmounts::default() };
    let wanted = |flank: Flank, w: f64, z: f64| amounts.value(&model, flank, w, z);
    let pass = [Flank::Right];
    let limits = FitLimits { rounds: 2, ..FitLimits::SOURCE };
    let task = FitTask { limits, ..task(&model, &pass, &wanted) };
    let free: Vec<Variable> = ["Fp1", "Fp2", "Fp3", "dist0", "dX2", "FC2"].map(variable).to_vec();
    for method in FitMethod::ALL {
        let fit = task.fit(&free, &[0.0; 6], method).unwrap();
        assert!(!fit.converged, "{}", method.name());
        let best = fit.values.clone();
        match fit.require_convergence() {
            Err(ref error @ TangentialError::NotConverged { rounds, rms_um, best: ref listed }) => {
                assert_eq!((rounds, listed), (2, &best), "{}", method.name());
                // The flank without any of them is off by 48 um.
                assert!(rms_um > 0.0 && rms_um < 48.0, "{rms_um}");
                assert_eq!((error.code(), error.is_bad_input()), ("not-converged", false));
                let settings = task.fixed.with(&free, listed);
                assert!(task.judge_beyond_tool(&settings, FitGrid::Radii(5)).is_ok());
            }
            other => panic!("{other:?}"),
        }
    }
}
