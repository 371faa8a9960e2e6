//! General decomposition by least squares: members of the class come back, weights and norms do what they say, directions
//! are found, bad input is refused. The reference numbers are checked by `verify` (`tests/verify.rs`).

use foundation::geometry::{Blank, Flank, Gear, GearData, Sides, WormChoice};
use foundation::modification::{EvaluationField, Modification, ModificationSpec};
use foundation::numerics::{BSpline, BSplineBasis, Jet2};
use generating::least_squares::{
    ArgumentKinks, Arguments, Candidates, DEFAULT_GRID, DiagonalCoordinates, FitNorm, FitSettings,
    FlankCoordinates, FlankFit, FunctionClass, Kinks, Objective, RollScale, Samples, SplineDecomposition,
    SplineGauge, WormFunctions, deviation_free, fit_functions, search_direction, search_ratio,
};
use generating::{DresserChoice, FlankLines, GeneratingError, GrindingSetup, SetupInput};
use proptest::prelude::*;
use serde_json::json;

const ROLL: [f64; 2] = [4.0, 22.0];
const FACE: [f64; 2] = [-20.0, 20.0];

fn grid([nw, nz]: [usize; 2], f: impl Fn(f64, f64) -> f64) -> Vec<[f64; 3]> {
    let at = |[a, b]: [f64; 2], i: usize, n: usize| a + (b - a) * i as f64 / (n - 1) as f64;
    (0..nw * nz).map(|i| (at(ROLL, i / nz, nw), at(FACE, i % nz, nz))).map(|(w, z)| [w, z, f(w, z)]).collect()
}

fn sampled(f: impl Fn(f64, f64) -> f64) -> Samples {
    Samples::of_points(&grid(DEFAULT_GRID, f)).unwrap()
}

/// The member of a class with the coefficients 0.01 mm times `numbers`, on the field.
fn member<G: FlankCoordinates>(coordinates: &G, settings: &FitSettings, numbers: &[f64]) -> WormFunctions {
    let points = grid(DEFAULT_GRID, |_, _| 0.0);
    let mut numbers = numbers.iter().cycle();
    let mut spline = |used: bool, pick: fn(Arguments) -> f64| {
        let of: Vec<f64> = points.iter().map(|p| pick(coordinates.arguments(p[0], p[1]))).collect();
        let low = of.iter().copied().fold(f64::INFINITY, f64::min);
        let high = of.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        let basis = BSplineBasis::uniform([low, high], settings.intervals, settings.degree, &[]).unwrap();
        let coefficients = (0..basis.count()).map(|_| 0.01 * numbers.next().unwrap()).collect();
        used.then(|| BSpline::new(basis, coefficients).unwrap())
    };
    let class = settings.class;
    WormFunctions {
        constant: spline(class.constant, |a| a.x),
        linear: spline(class.linear, |a| a.x),
        quadratic: spline(class.quadratic, |a| a.x),
        profile: spline(class.profile, |a| a.profile),
        kinematic: spline(class.kinematic, |a| a.path),
        scale: RollScale { middle: 13.0, half: 9.0 },
    }
}

/// The largest |a - b| over the points of the default grid and between them.
fn apart(a: impl Fn(f64, f64) -> f64, b: impl Fn(f64, f64) -> f64) -> f64 {
    let [nw, nz] = DEFAULT_GRID;
    let fine = grid([2 * nw - 1, 2 * nz - 1], |w, z| (a(w, z) - b(w, z)).abs());
    fine.iter().map(|p| p[2]).fold(0.0, f64::max)
}

fn classes() -> impl Strategy<Value = FunctionClass> {
    prop::sample::select(vec![
        FunctionClass::CLK,
        FunctionClass::CLPK,
        FunctionClass::ALL,
        FunctionClass::RADIAL,
        FunctionClass::from_letters("C".chars()).unwrap(),
        FunctionClass::from_letters("CQK".chars()).unwrap(),
        FunctionClass::from_letters("LP".chars()).unwrap(),
    ])
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(60))]

    #[test]
    fn members_of_the_class_come_back(
        class in classes(),
        t in 0.05..2.5f64,
        negative in any::<bool>(),
        t_k in -1.0..1.0f64,
        rack_slope in prop::sample::select(vec![0.0, 0.0, 0.06, -0.1]),
        intervals in 3..9usize,
        degree in 1..5usize,
        numbers in prop::collection::vec(-1.0..1.0f64, 71),
    ) {
        let t = if negative { -t } else { t };
        prop_assume!((t - t_k).abs() > 0.05);
        let coordinates = DiagonalCoordinates::new(t, t_k, rack_slope).unwrap();
        let settings = FitSettings { intervals, degree, ..FitSettings::new(class) };
        let wanted = member(&coordinates, &settings, &numbers);
        let target = |w: f64, z: f64| wanted.value(w, &coordinates.arguments(w, z));
        let found = SplineDecomposition::fit(&sampled(target), coordinates, &settings).unwrap();
        // 1e-9 um.
        prop_assert!(found.report.quality().largest < 1e-12, "{:?}", found.report);
        // Between the samples too, where these leave nothing open but what adds up to zero.
        let report = &found.report;
        prop_assert!(report.rank <= report.coefficients - report.ambiguity);
        if report.rank == report.coefficients - report.ambiguity {
            let difference = apart(target, |w, z| found.value(w, z));
            prop_assert!(difference < 1e-11, "{difference}");
        }
    }

    #[test]
    fn jets_are_the_derivatives_of_the_sum(t in -2.0..2.0f64, numbers in prop::collection::vec(-1.0..1.0f64, 71)) {
        prop_assume!((t - 0.6).abs() > 0.05);
        let coordinates = DiagonalCoordinates::new(t, 0.6, 0.08).unwrap();
        let settings = FitSettings::new(FunctionClass::ALL);
        let wanted = member(&coordinates, &settings, &numbers);
        let samples = sampled(|w, z| wanted.value(w, &coordinates.arguments(w, z)));
        let found = SplineDecomposition::fit(&samples, coordinates, &settings).unwrap();
        let h = 1e-4;
        for (w, z) in [(5.3, -13.7), (12.1, 0.9), (20.7, 18.2)] {
            let jet = found.jet(w, z);
            let f = |i: f64, j: f64| found.value(w + i * h, z + j * h);
            let wanted = [
                (jet.f, f(0.0, 0.0), 1e-14),
                (jet.fu, (f(1.0, 0.0) - f(-1.0, 0.0)) / (2.0 * h), 1e-7),
                (jet.fv, (f(0.0, 1.0) - f(0.0, -1.0)) / (2.0 * h), 1e-7),
                (jet.fuu, (f(1.0, 0.0) - 2.0 * f(0.0, 0.0) + f(-1.0, 0.0)) / (h * h), 1e-4),
                (jet.fvv, (f(0.0, 1.0) - 2.0 * f(0.0, 0.0) + f(0.0, -1.0)) / (h * h), 1e-4),
                (jet.fuv, (f(1.0, 1.0) - f(1.0, -1.0) - f(-1.0, 1.0) + f(-1.0, -1.0)) / (4.0 * h * h), 1e-4),
            ];
            for (got, want, tolerance) in wanted {
                prop_assert!((got - want).abs() < tolerance, "{got} {want}");
            }
        }
    }
}

#[test]
fn the_centred_gauge_moves_straight_lines_only() {
    for (class, rack_slope) in
        [(FunctionClass::CLK, 0.0), (FunctionClass::CLPK, 0.0), (FunctionClass::ALL, 0.1)]
    {
        let coordinates = DiagonalCoordinates::new(1.4, -0.7, rack_slope).unwrap();
        let settings = FitSettings::new(class);
        let samples = sampled(|w, z| 0.01 * (0.1 * w * z).sin() - 4e-5 * z * z);
        let points = samples.points().to_vec();
        let arguments: Vec<Arguments> = points.iter().map(|p| coordinates.arguments(p[0], p[1])).collect();
        let raw =
            fit_functions(&samples, &arguments, &settings, &ArgumentKinks::default()).unwrap().functions;
        let centred = SplineDecomposition::fit(&samples, coordinates, &settings).unwrap();
        assert_eq!(centred.gauge, SplineGauge::Centred);
        let middle = coordinates.arguments(13.0, 0.0);
        let [value, slope, _] = centred.functions.kinematic_jet(middle.path);
        assert!(value.abs() < 1e-15 && slope.abs() < 1e-15, "{value} {slope}");
        let [value, slope, _] = centred.functions.profile_jet(middle.profile);
        assert!(value.abs() < 1e-15 && slope.abs() < 1e-15, "{value} {slope}");
        assert!(raw.kinematic_jet(middle.path)[0].abs() > 1e-6, "the minimum norm is centred already");
        let difference = apart(|w, z| raw.value(w, &coordinates.arguments(w, z)), |w, z| centred.value(w, z));
        assert!(difference < 1e-14, "{difference}");
    }
    // What the centred gauge would move has no place in {P, K} and {C, K}.
    for letters in ["PK", "CK"] {
        let coordinates = DiagonalCoordinates::new(1.4, -0.7, 0.0).unwrap();
        let settings = FitSettings::new(FunctionClass::from_letters(letters.chars()).unwrap());
        let found = SplineDecomposition::fit(&sampled(|w, z| 1e-3 * w * z), coordinates, &settings).unwrap();
        assert_eq!(found.gauge, SplineGauge::MinimumNorm);
    }
}

#[test]
fn curved_lines_are_coordinates_like_any_other() {
    // X = z + 0.9 w + 0.01 w^2, as a variable ratio makes it.
    let coordinates = |w: f64, z: f64| {
        let x =
            Jet2 { f: z + 0.9 * w + 0.01 * w * w, fu: 0.9 + 0.02 * w, fv: 1.0, fuu: 0.02, ..Jet2::default() };
        let line = |a: f64, b: f64| Jet2 { f: a * w + b * z, fu: a, fv: b, ..Jet2::default() };
        [x, line(1.0, 0.0), line(-0.5, 0.8)]
    };
    let settings = FitSettings::new(FunctionClass::CLPK);
    let numbers: Vec<f64> = (0..71).map(|i| (1.9 * f64::from(i)).sin()).collect();
    let wanted = member(&coordinates, &settings, &numbers);
    let target = |w: f64, z: f64| wanted.value(w, &coordinates.arguments(w, z));
    let found = SplineDecomposition::fit(&sampled(target), coordinates, &settings).unwrap();
    assert!(found.report.quality().largest < 1e-12, "{:?}", found.report);
    assert_eq!(found.gauge, SplineGauge::MinimumNorm);
    let (w, z, h) = (9.3, -4.1, 1e-4);
    let jet = found.jet(w, z);
    let slope = (found.value(w + h, z) - found.value(w - h, z)) / (2.0 * h);
    let curvature = (found.value(w + h, z) - 2.0 * found.value(w, z) + found.value(w - h, z)) / (h * h);
    assert!((jet.fu - slope).abs() < 1e-7 && (jet.fuu - curvature).abs() < 1e-4);
}

fn relief(w: f64, z: f64) -> f64 {
    -0.03 * (1.0 + (w - 22.0) / 6.0 + (z - 20.0) / 10.0).max(0.0)
}

#[test]
fn a_weight_of_two_counts_like_four_points() {
    let coordinates = DiagonalCoordinates::new(0.9, -0.5, 0.0).unwrap();
    let settings = FitSettings::new(FunctionClass::CLPK);
    let points = grid(DEFAULT_GRID, relief);
    let heavy = |w: f64, z: f64| w > 15.0 && z < 5.0;
    let weighted = Samples::of_points(&points)
        .unwrap()
        .with_tolerance(|w, z| if heavy(w, z) { 0.5 } else { 1.0 })
        .unwrap();
    let repeated: Vec<[f64; 3]> =
        points.iter().flat_map(|p| std::iter::repeat_n(*p, if heavy(p[0], p[1]) { 4 } else { 1 })).collect();
    let repeated = Samples::of_points(&repeated).unwrap();
    let [a, b, plain] = [weighted, repeated, Samples::of_points(&points).unwrap()]
        .map(|samples| SplineDecomposition::fit(&samples, coordinates, &settings).unwrap());
    assert!(apart(|w, z| a.value(w, z), |w, z| b.value(w, z)) < 1e-12);
    assert!(apart(|w, z| a.value(w, z), |w, z| plain.value(w, z)) > 1e-5);
}

#[test]
fn tight_tolerances_draw_the_fit_and_are_reported() {
    let coordinates = DiagonalCoordinates::new(0.5, -0.5, 0.0).unwrap();
    let settings = FitSettings::new(FunctionClass::CLPK);
    let tip = |w: f64, z: f64| w > 18.0 && z > 12.0;
    let tolerance = |w: f64, z: f64| if tip(w, z) { 1e-5 } else { 1e-3 };
    let even = SplineDecomposition::fit(&sampled(relief), coordinates, &settings).unwrap();
    let samples = sampled(relief).with_tolerance(tolerance).unwrap();
    let drawn = SplineDecomposition::fit(&samples, coordinates, &settings).unwrap();
    let largest = |d: &SplineDecomposition<DiagonalCoordinates>| {
        let ratio = |&[w, z]: &[f64; 2]| (d.value(w, z) - relief(w, z)).abs() / tolerance(w, z);
        samples.points().iter().map(ratio).fold(0.0, f64::max)
    };
    assert!(largest(&drawn) < 0.2 * largest(&even), "{} {}", largest(&drawn), largest(&even));
    assert!((drawn.report.quality().tolerance_ratio / largest(&drawn) - 1.0).abs() < 1e-6);
}

#[test]
fn the_minimax_fit_of_a_parabola_by_a_line_is_known() {
    // F_C straight in X = z: z^2 on [-20, 20] misses the best line by half of 400 at -20, 0 and 20.
    let coordinates = DiagonalCoordinates::new(0.0, 1.0, 0.0).unwrap();
    let class = FunctionClass::from_letters("C".chars()).unwrap();
    let settings = FitSettings { intervals: 1, degree: 1, norm: FitNorm::Largest, ..FitSettings::new(class) };
    let found = SplineDecomposition::fit(&sampled(|_, z| 1e-4 * z * z), coordinates, &settings).unwrap();
    let minimax = found.report.minimax.unwrap();
    assert!((minimax.quality.largest - 0.02).abs() < 1e-10, "{minimax:?}");
    assert!((minimax.bound - 0.02).abs() < 1e-9 && minimax.bound <= minimax.quality.tolerance_ratio);
    for z in [-20.0, 3.0, 20.0] {
        assert!((found.value(10.0, z) - 0.02).abs() < 1e-10);
    }
}

#[test]
fn the_minimax_fit_is_best_in_its_norm() {
    let tolerance = |w: f64, _: f64| if w < 10.0 { 2e-3 } else { 1e-3 };
    for (t, class) in [(0.9, FunctionClass::CLK), (-1.2, FunctionClass::ALL), (2.0, FunctionClass::CLPK)] {
        let coordinates = DiagonalCoordinates::new(t, -0.5, 0.0).unwrap();
        let settings = FitSettings { norm: FitNorm::Largest, ..FitSettings::new(class) };
        let samples = sampled(relief).with_tolerance(tolerance).unwrap();
        let found = SplineDecomposition::fit(&samples, coordinates, &settings).unwrap();
        let (square, minimax) = (found.report.least_squares, found.report.minimax.unwrap());
        assert!(minimax.quality.tolerance_ratio < 0.9 * square.tolerance_ratio, "{square:?} {minimax:?}");
        assert!(minimax.quality.rms > square.rms || tolerance(5.0, 0.0) != tolerance(15.0, 0.0));
        let gap = minimax.quality.tolerance_ratio - minimax.bound;
        assert!(gap >= 0.0 && gap < 1e-6 * minimax.bound, "{minimax:?}");
        // The gauge must not spoil what the fit reached.
        let reached = samples.points().iter().map(|p| (found.value(p[0], p[1]) - relief(p[0], p[1])).abs());
        assert!((reached.fold(0.0, f64::max) - minimax.quality.largest).abs() < 1e-12);
    }
}

/// The least-squares fit goes by pivots, the start of the minimax fit by singular values.
#[test]
fn pivots_and_singular_values_agree() {
    let kinked = FitSettings {
        kinks: Kinks { lines: vec![[16.0, 10.0], [9.0, -3.0]], ..Kinks::default() },
        ..FitSettings::new(FunctionClass::CLK)
    };
    let coarse = FitSettings { intervals: 4, degree: 2, ..FitSettings::new(FunctionClass::RADIAL) };
    for settings in
        [FitSettings::new(FunctionClass::CLPK), FitSettings::new(FunctionClass::ALL), kinked, coarse]
    {
        for t in [0.9, -1.3] {
            let coordinates = DiagonalCoordinates::new(t, -0.5, 0.0).unwrap();
            let largest = FitSettings { norm: FitNorm::Largest, ..settings.clone() };
            let [pivots, values] = [&settings, &largest].map(|settings| {
                SplineDecomposition::fit(&sampled(relief), coordinates, settings).unwrap().report
            });
            assert_eq!(pivots.rank, values.rank);
            assert!((pivots.least_squares.rms / values.least_squares.rms - 1.0).abs() < 1e-9);
            assert!((pivots.least_squares.largest / values.least_squares.largest - 1.0).abs() < 1e-9);
        }
    }
}

#[test]
fn large_clouds_have_the_minimax_fit_of_all_their_points() {
    let coordinates = DiagonalCoordinates::new(0.9, -0.5, 0.0).unwrap();
    let settings = FitSettings { norm: FitNorm::Largest, ..FitSettings::new(FunctionClass::CLK) };
    let samples = Samples::of_points(&grid([100, 120], relief)).unwrap();
    let found = SplineDecomposition::fit(&samples, coordinates, &settings).unwrap();
    let minimax = found.report.minimax.unwrap();
    let gap = minimax.quality.tolerance_ratio - minimax.bound;
    assert!(gap >= 0.0 && gap < 1e-6 * minimax.bound, "{minimax:?}");
    assert!(minimax.quality.largest < found.report.least_squares.largest);
}

fn setup() -> GrindingSetup {
    let gear = Gear::new(GearData {
        teeth: 19,
        normal_module: 3.5,
        pressure_angle: Sides { left: 17.5f64.to_radians(), right: 21f64.to_radians() },
        helix_angle: -(35f64.to_radians()),
        profile_shift: 0.0,
        cone_angle: 0.0,
    })
    .unwrap();
    GrindingSetup::new(SetupInput {
        gear,
        blank: Blank {
            face_width: 40.0,
            tip_diameter: 88.5315,
            root_diameter: 72.4315,
            tip_form_diameter: 88.5315,
            form_diameter: 77.0,
            rack_addendum: None,
        },
        evaluation: [77.0, 88.5315, -20.0, 20.0],
        worm: WormChoice {
            threads: 3,
            hand: -1.0,
            pitch_diameter: None,
            tip_diameter: Some(200.0),
            pressure_angle: None,
            profile_shift: 0.0,
            cone_angle: 0.0,
        },
        worm_width: Some(100.0),
        dresser: Some(DresserChoice {
            tip_diameter: 123.0,
            pitch_diameter: Some(115.65),
            designed_for: None,
        }),
        tool_direction: None,
        root_clearance: None,
        gear_root: None,
    })
    .unwrap()
}

/// A relief along the lines of `ratio` that begins at the middle of the field: kinked, exact at that ratio only.
fn relief_along(lines: &FlankLines, field: &EvaluationField, ratio: f64) -> (Samples, [f64; 2]) {
    let t = lines.work_direction(ratio);
    let start = [field.roll_middle(), field.face_middle() + 3.0];
    let at = |[a, b]: [f64; 2], i: usize, n: usize| a + (b - a) * i as f64 / (n - 1) as f64;
    let points: Vec<[f64; 3]> = (0..25 * 31)
        .map(|i| (at(field.roll(), i / 31, 25), at(field.face(), i % 31, 31)))
        .map(|(w, z)| [w, z, -1e-3 * (t * (w - start[0]) + z - start[1]).max(0.0)])
        .collect();
    (Samples::of_points(&points).unwrap(), start)
}

fn kinked(start: [f64; 2]) -> FitSettings {
    let mut settings = FitSettings::new(FunctionClass::CLK);
    settings.kinks.lines.push(start);
    settings
}

#[test]
fn two_flanks_with_one_exact_ratio_are_found_without_deviation() {
    let setup = setup();
    for exact in [0.83, -0.61] {
        let targets = Sides::from_fn(|flank| relief_along(&setup.lines[flank], &setup.fields[flank], exact));
        let settings = Sides::from_fn(|flank| kinked(targets[flank].1));
        let fits = Sides::from_fn(|flank| {
            Some(FlankFit {
                lines: &setup.lines[flank],
                samples: &targets[flank].0,
                settings: &settings[flank],
                rack_slope: 0.0,
            })
        });
        let candidates = Candidates::both_signs([0.2, 3.0], 25).unwrap();
        let scanned = search_ratio(&fits, &candidates, Objective::Rms).unwrap();
        assert!((scanned.ratio - exact).abs() < 1e-6, "{}", scanned.ratio);
        assert!(scanned.objective < 1e-8, "{}", scanned.objective);
        assert_eq!(scanned.tried.len(), 50);
        // The exact ratio of each flank follows from its direction; here they are one.
        let ratios = setup.lines.map(|_, lines| lines.ratio_of_direction(lines.work_direction(exact)));
        assert!(deviation_free(ratios.left, ratios.right) && !deviation_free(1.0, 1.0 + 2e-9));
        let between = Candidates::between(ratios.left, ratios.right, 3).unwrap();
        for objective in [Objective::Rms, Objective::ToleranceRatio] {
            let best = search_ratio(&fits, &between, objective).unwrap();
            assert!(best.objective < 1e-12, "{}", best.objective);
            let largest = |flank: Flank| best.flanks[flank].as_ref().unwrap().report.quality().largest;
            assert!(largest(Flank::Left) < 1e-12 && largest(Flank::Right) < 1e-12);
        }
    }
}

#[test]
fn one_flank_alone_takes_its_own_direction() {
    let setup = setup();
    let flank = Flank::Left;
    let lines = &setup.lines[flank];
    let (samples, start) = relief_along(lines, &setup.fields[flank], 0.9);
    let settings = kinked(start);
    let fit = FlankFit { lines, samples: &samples, settings: &settings, rack_slope: 0.0 };
    let rho = lines.work_direction(0.9).atan();
    let candidates = Candidates::directions([-1.3, 1.3], 60).unwrap();
    let found = search_direction(&fit, &candidates, Objective::Rms).unwrap();
    assert!((found.direction - rho).abs() < 1e-6, "{} {rho}", found.direction);
    let by_ratio = search_ratio(
        &Sides { left: Some(fit), right: None },
        &Candidates::both_signs([0.3, 2.0], 20).unwrap(),
        Objective::ToleranceRatio,
    )
    .unwrap();
    assert!((by_ratio.ratio - 0.9).abs() < 1e-6 && by_ratio.flanks.right.is_none());
    // Ratio 0 and the direction of the contact path are refused, unless nothing depends on X.
    assert_eq!(fit.at_ratio(0.0).unwrap_err().code(), "degenerate-direction");
    assert_eq!(fit.at_direction(lines.t_k + 1e-7).unwrap_err().code(), "degenerate-direction");
    let radial = FitSettings::new(FunctionClass::RADIAL);
    assert!(FlankFit { settings: &radial, ..fit }.at_ratio(0.0).is_ok());
    let none = search_ratio(&Sides::both(None), &candidates, Objective::Rms);
    assert_eq!(none.unwrap_err(), GeneratingError::NoFlank);
    let zero = Candidates::ratios(&[0.0]).unwrap();
    let refused = search_ratio(&Sides { left: Some(fit), right: None }, &zero, Objective::Rms).unwrap_err();
    assert_eq!(refused.code(), "degenerate-direction");
}

#[test]
fn results_do_not_depend_on_the_threads() {
    let setup = setup();
    let targets = Sides::from_fn(|flank| relief_along(&setup.lines[flank], &setup.fields[flank], 0.83).0);
    let settings = FitSettings::new(FunctionClass::ALL);
    let run = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        let fits = Sides::from_fn(|flank| {
            let (lines, samples) = (&setup.lines[flank], &targets[flank]);
            Some(FlankFit { lines, samples, settings: &settings, rack_slope: 0.0 })
        });
        let candidates = Candidates::both_signs([0.3, 2.0], 5).unwrap();
        pool.install(|| search_ratio(&fits, &candidates, Objective::Rms).unwrap())
    };
    assert_eq!(run(1), run(4));
}

#[test]
fn modifications_are_sampled_over_their_field() {
    let field = EvaluationField::new(ROLL, FACE, 38.0, 0.3).unwrap();
    let spec = ModificationSpec::from_json(&json!({"kind": "helix_crowning", "amount_um": 10.0})).unwrap();
    let crowning = Modification::build(&spec, &field).unwrap();
    let samples = Samples::of_modification(&crowning, DEFAULT_GRID).unwrap();
    assert_eq!(samples.count(), 775);
    assert_eq!((samples.points()[0], samples.points()[774]), ([4.0, -20.0], [22.0, 20.0]));
    assert!((samples.values()[0] + 0.01).abs() < 1e-17 && samples.values()[15] == 0.0);
    // A helix crowning without twist is a polynomial of second degree: in {C, L, K} at any direction.
    for t in [-1.7, 0.4, 3.0] {
        let coordinates = DiagonalCoordinates::new(t, -0.6, 0.0).unwrap();
        let settings = FitSettings::new(FunctionClass::CLK);
        let found = SplineDecomposition::fit(&samples, coordinates, &settings).unwrap();
        assert!(found.report.quality().largest < 1e-13);
        assert_eq!(found.report.rank, found.report.coefficients - found.report.ambiguity);
    }
    let arc = json!({"kind": "profile_crowning_arc", "amount_um": 10.0});
    let arc = Modification::build(&ModificationSpec::from_json(&arc).unwrap(), &field).unwrap();
    assert!(Samples::of_modification(&arc, DEFAULT_GRID).is_ok());
}

#[test]
fn bad_input_is_refused_with_its_data() {
    let coordinates = DiagonalCoordinates::new(0.9, -0.5, 0.0).unwrap();
    let settings = FitSettings::new(FunctionClass::CLK);
    let fit = |samples: &Samples, settings: &FitSettings| {
        SplineDecomposition::fit(samples, coordinates, settings).map(|d| d.report.rank).unwrap_err()
    };
    let refused = [
        (
            Samples::of_points(&[[1.0, 2.0, f64::NAN]]).unwrap_err(),
            GeneratingError::AmountNotFinite { w: 1.0, z: 2.0 },
            "amount-not-finite",
        ),
        (
            sampled(relief).with_tolerance(|_, z| if z > 19.0 { 0.0 } else { 1.0 }).unwrap_err(),
            GeneratingError::ToleranceNotPositive { w: 4.0, z: 20.0, value: 0.0 },
            "tolerance-not-positive",
        ),
        // Three cubic splines of ten intervals: 39 coefficients, two of them a matter of gauge.
        (
            fit(&Samples::of_points(&grid([6, 6], relief)).unwrap(), &settings),
            GeneratingError::TooFewPoints { points: 36, needed: 37 },
            "too-few-points",
        ),
        (
            fit(&Samples::of_points(&[]).unwrap(), &settings),
            GeneratingError::TooFewPoints { points: 0, needed: 37 },
            "too-few-points",
        ),
        (
            DiagonalCoordinates::new(-0.5 + 5e-7, -0.5, 0.0).unwrap_err(),
            GeneratingError::DirectionAlongPath { t: -0.5 + 5e-7, t_k: -0.5 },
            "degenerate-direction",
        ),
        (
            fit(
                &Samples::of_points(&vec![[5.0, 6.0, 0.1]; 80]).unwrap(),
                &FitSettings::new(FunctionClass::from_letters("P".chars()).unwrap()),
            ),
            GeneratingError::NoExtent { coordinate: "w", value: 5.0 },
            "no-extent",
        ),
    ];
    for (got, want, code) in refused {
        assert_eq!(got, want);
        assert_eq!(got.code(), code);
        assert!(got.is_bad_input() && got.way_out().len() > 20 && !got.to_string().is_empty());
    }
    let absurd = FitSettings { intervals: usize::MAX, ..settings.clone() };
    assert_eq!(fit(&sampled(relief), &absurd).code(), "too-few-points");
    let none = FitSettings { intervals: 0, ..settings.clone() };
    assert_eq!(fit(&sampled(relief), &none).code(), "invalid-spline");
    let mut kink = settings.clone();
    kink.kinks.lines.push([f64::NAN, 0.0]);
    assert_eq!(fit(&sampled(relief), &kink).code(), "invalid-spline");
    let nowhere = |_: f64, _: f64| [Jet2::constant(f64::NAN); 3];
    let error = SplineDecomposition::fit(&sampled(relief), nowhere, &settings).map(|_| ()).unwrap_err();
    assert_eq!(error.code(), "coordinate-not-finite");
    let steep = sampled(relief).with_tolerance(|w, _| if w > 10.0 { 1e-300 } else { 1e300 }).unwrap();
    match SplineDecomposition::fit(&steep, coordinates, &settings) {
        Ok(found) => assert!(found.value(20.0, 10.0).is_finite() && found.report.quality().rms.is_finite()),
        Err(error) => assert_eq!(error.code(), "fit-not-solved"),
    }
}
