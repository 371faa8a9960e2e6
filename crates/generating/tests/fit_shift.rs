//! Diagonal ratios that vary, fitted to targets: a ratio that made a target is found again where no constant one would do, a
//! constant one stays constant, bad input is refused.

use crate::cylindrical_pair::{lines, pair};
use contact::Pair;
use foundation::geometry::{Flank, Gear, GearData, Sides, WormChoice, worm_for_gear};
use foundation::kinematics::MotionLaw;
use foundation::modification::EvaluationField;
use generating::least_squares::{DEFAULT_GRID, FitSettings, FlankFit, FunctionClass, Samples};
use generating::{
    AllowedLever, DEFAULT_NODES, FlankDemand, FlankLines, GeneratingError, Lever, LeverSearch, fit_shift,
};

/// Amplitude of the targets, mm.
const AMPLITUDE: f64 = 0.01;

/// A wave over the lines of a flank under a law: none of the few functions makes it along other lines.
fn wave(lines: &FlankLines, law: &MotionLaw) -> Samples {
    let [nw, nz] = DEFAULT_GRID;
    let at = |[a, b]: [f64; 2], i: usize, n: usize| a + (b - a) * i as f64 / (n - 1) as f64;
    let points: Vec<[f64; 3]> = (0..nw * nz)
        .map(|i| (at(lines.roll, i / nz, nw), at(lines.face, i % nz, nz)))
        .map(|(w, z)| {
            let x = lines.line_coordinate(law, w, z).f;
            let u = (w - lines.w_m) / 10.0;
            [w, z, AMPLITUDE * ((0.25 * x).sin() + 0.3 * u * (0.17 * x).cos())]
        })
        .collect();
    Samples::of_points(&points).unwrap()
}

fn settings() -> FitSettings {
    FitSettings { intervals: 14, ..FitSettings::new(FunctionClass::CLPK) }
}

/// F' = -0.7 (1 + 0.4 sin) over the feeds: no broken line.
fn varying() -> MotionLaw {
    let feeds: Vec<f64> = (0..=400).map(|k| -50.0 + 0.25 * f64::from(k)).collect();
    let shifts: Vec<f64> = feeds.iter().map(|v| -0.7 * (v - 0.4 * 12.0 * (v / 12.0).cos())).collect();
    MotionLaw::spline(&feeds, &shifts).unwrap()
}

fn flanks(pair: &Pair) -> Sides<FlankLines> {
    Sides::from_fn(|flank| lines(pair, flank))
}

#[test]
fn a_varying_ratio_is_recovered_from_what_it_made() {
    let lines = flanks(&pair(20.0));
    let (law, settings) = (varying(), settings());
    let samples = lines.map(|_, lines| wave(lines, &law));
    let fits = Sides::from_fn(|flank| {
        Some(FlankFit {
            lines: &lines[flank],
            samples: &samples[flank],
            settings: &settings,
            rack_slope: 0.0,
        })
    });
    for one in [false, true] {
        let fits = Sides { left: fits.left, right: fits.right.filter(|_| !one) };
        let found = fit_shift(&fits, -1.0, 9).unwrap();
        assert!(found.settled, "{found:?}");
        assert!(found.objective < 1e-3 * AMPLITUDE, "{}", found.objective);
        assert!(found.constant.objective > 10.0 * found.objective, "{}", found.constant.objective);
        assert!(found.constant.objective > 5e-3 * AMPLITUDE, "{}", found.constant.objective);
        for fit in [&fits.left, &fits.right].into_iter().flatten() {
            let flank = fit.lines.flank();
            let reached = found.flanks[flank].as_ref().unwrap();
            let constant = found.constant.flanks[flank].as_ref().unwrap();
            let (reached, constant) = (reached.report.quality(), constant.report.quality());
            assert!(reached.largest < 0.1 * constant.largest, "{reached:?} {constant:?}");
        }
        // The ratio itself, but for its course between nodes; the lines of one flank alone see less of it.
        let near = if one { 0.15 } else { 0.05 };
        for [feed, ratio] in &found.nodes[1..8] {
            assert!((ratio / law.jet(*feed)[1] - 1.0).abs() < near, "{feed} {ratio}");
        }
        let [from, to] = found.shift.domain();
        let smooth = found.shift.law();
        for k in 0..=100 {
            let v = from + (to - from) * f64::from(k) / 100.0;
            assert!((smooth.value(v) - found.parabolas.value(v)).abs() < 1e-4);
        }
    }
}

#[test]
fn a_ratio_within_the_nodes_is_found_to_rounding() {
    let lines = flanks(&pair(-20.0));
    // Straight between two nodes: F' from 0.5 to 1.1 over the feeds of the left flank.
    let one = &lines.left;
    let feeds = one.corners().map(|(w, z)| one.path_feed(w, z));
    let [from, to] = [feeds.into_iter().fold(f64::MAX, f64::min), feeds.into_iter().fold(f64::MIN, f64::max)];
    let law = MotionLaw::polynomial(from, vec![0.0, 0.5, 0.3 / (to - from)]);
    let settings = FitSettings { intervals: 30, degree: 5, ..FitSettings::new(FunctionClass::CLPK) };
    let samples = wave(one, &law);
    let fit = FlankFit { lines: one, samples: &samples, settings: &settings, rack_slope: 0.0 };
    let found = fit_shift(&Sides { left: Some(fit), right: None }, 0.8, 2).unwrap();
    assert!(found.settled && found.objective < 1e-6 * AMPLITUDE, "{}", found.objective);
    assert!(
        (found.nodes[0][1] - 0.5).abs() < 1e-4 && (found.nodes[1][1] - 1.1).abs() < 1e-4,
        "{:?}",
        found.nodes
    );
}

#[test]
fn a_constant_ratio_stays_constant() {
    for ratio in [0.9, -0.6] {
        let lines = flanks(&pair(20.0));
        let law = MotionLaw::polynomial(0.0, vec![0.0, ratio]);
        let samples = lines.map(|_, lines| wave(lines, &law));
        // Enough intervals for the wave: the ratio is what is in question here.
        let settings = FitSettings { intervals: 20, degree: 4, ..settings() };
        let fits = Sides::from_fn(|flank| {
            Some(FlankFit {
                lines: &lines[flank],
                samples: &samples[flank],
                settings: &settings,
                rack_slope: 0.0,
            })
        });
        let found = fit_shift(&fits, 1.2 * ratio, DEFAULT_NODES).unwrap();
        assert_eq!(found.nodes.len(), 6);
        for [_, got] in &found.nodes {
            assert!((got / ratio - 1.0).abs() < 2e-3, "{:?}", found.nodes);
        }
        assert!((found.constant.ratio / ratio - 1.0).abs() < 1e-4, "{}", found.constant.ratio);
        assert!(found.objective <= found.constant.objective * (1.0 + 1e-6) + 1e-15);
    }
}

#[test]
fn results_do_not_depend_on_the_threads() {
    let lines = flanks(&pair(20.0));
    let (law, settings) = (varying(), settings());
    let samples = wave(&lines.left, &law);
    let fit = FlankFit { lines: &lines.left, samples: &samples, settings: &settings, rack_slope: 0.0 };
    let run = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| fit_shift(&Sides { left: Some(fit), right: None }, -0.7, 4).unwrap())
    };
    assert_eq!(run(1), run(3));
}

#[test]
fn refusals_have_codes_and_ways_out() {
    let lines = lines(&pair(20.0), Flank::Left);
    let settings = settings();
    let samples = wave(&lines, &varying());
    let error = |lines: &FlankLines, ratio: f64, nodes: usize| {
        let fit = FlankFit { lines, samples: &samples, settings: &settings, rack_slope: 0.0 };
        let error: GeneratingError =
            fit_shift(&Sides { left: Some(fit), right: None }, ratio, nodes).unwrap_err();
        assert!(!error.way_out().is_empty() && error.is_bad_input(), "{error}");
        error.code()
    };
    for ratio in [0.0, f64::NAN, f64::INFINITY] {
        assert_eq!(error(&lines, ratio, 6), "invalid-number");
    }
    for nodes in [0, 1, 257, usize::MAX] {
        assert_eq!(error(&lines, 1.0, nodes), "invalid-number");
    }
    let conical = FlankLines { roll_feeds: [0.0, 0.1], ..lines };
    assert_eq!(error(&conical, 1.0, 6), "cylindrical-only");
    let parallel = FlankLines { big_t1: 0.0, ..lines };
    assert_eq!(error(&parallel, 1.0, 6), "worm-direction-degenerate");
    let none = fit_shift(&Sides::both(None), 1.0, 6).unwrap_err();
    assert_eq!(none, GeneratingError::NoFlank);
    let few =
        Samples::of_points(&samples.points()[..9].iter().map(|p| [p[0], p[1], 0.0]).collect::<Vec<_>>());
    let few = few.unwrap();
    let fit = FlankFit { lines: &lines, samples: &few, settings: &settings, rack_slope: 0.0 };
    let error = fit_shift(&Sides { left: Some(fit), right: None }, 1.0, 6).unwrap_err();
    assert_eq!(error.code(), "too-few-points");
}

/// An asymmetric gear on a worm with these levers.
fn bodies(values: &[(Lever, f64)]) -> Result<Sides<FlankLines>, GeneratingError> {
    let gear = Gear::new(GearData {
        teeth: 31,
        normal_module: 2.5,
        pressure_angle: Sides { left: 25f64.to_radians(), right: 18f64.to_radians() },
        helix_angle: 20f64.to_radians(),
        profile_shift: 0.15,
        cone_angle: 0.0,
    })?;
    let mut worm = WormChoice {
        threads: 2,
        hand: 1.0,
        pitch_diameter: Some(240.0),
        tip_diameter: None,
        pressure_angle: None,
        profile_shift: 0.0,
        cone_angle: 0.0,
    };
    for &(lever, value) in values {
        match lever {
            Lever::ConeAngle => worm.cone_angle = value,
            Lever::ProfileAngle => worm.pressure_angle = Some(value),
            Lever::CrossingAngle => unreachable!("no test moves it"),
        }
    }
    let made = worm_for_gear(&gear, &worm)?;
    let pair = Pair::without_backlash(made.worm, gear, made.crossed_axes_angle)?;
    Sides::try_from_fn(|flank| {
        let work = gear.flank(flank);
        let field =
            EvaluationField::new([9.0, 22.0], [-15.0, 15.0], work.base_radius, work.base_helix_angle)?;
        // Lines of axial sections turn with the rack so that its angle hardly matters; fixed ones do not.
        let turned = values.iter().all(|(lever, _)| *lever == Lever::ConeAngle);
        let line = pair.flanks[flank].axial_section_line(field.roll_middle());
        Ok(FlankLines::new(&pair.flanks[flank], &field, if turned { line.rho.tan() } else { 0.5 }))
    })
}

/// A wave along straight lines.
fn straight(lines: &FlankLines, t: f64) -> Samples {
    let [nw, nz] = [17, 21];
    let points: Vec<[f64; 3]> = (0..nw * nz)
        .map(|i| [9.0 + 13.0 * (i / nz) as f64 / 16.0, -15.0 + 30.0 * (i % nz) as f64 / 20.0])
        .map(|[w, z]| [w, z, AMPLITUDE * (0.4 * (t * (w - lines.w_m) + z) / t.hypot(1.0)).sin()])
        .collect();
    Samples::of_points(&points).unwrap()
}

#[test]
fn levers_give_both_flanks_one_ratio() {
    // F_C alone: it feels directions most.
    let class = FunctionClass::from_letters("C".chars()).unwrap();
    let settings = FitSettings { intervals: 20, degree: 4, ..FitSettings::new(class) };
    for (lever, wanted, start, range, nodes) in [
        (Lever::ConeAngle, 4f64, 0f64, [-8f64, 8f64], None),
        (Lever::ProfileAngle, 26.0, 24.5, [23.5, 28.0], None),
    ] {
        let made = bodies(&[(lever, wanted.to_radians())]).unwrap();
        let samples = made.map(|_, lines| straight(lines, lines.work_direction(0.9)));
        let demands = Sides::from_fn(|f| Some(FlankDemand { samples: &samples[f], settings: &settings }));
        let search = LeverSearch { demands, bodies: &bodies, ratio: 0.8, nodes };
        let allowed = AllowedLever { lever, start: start.to_radians(), range: range.map(f64::to_radians) };
        let found = search.search(&[allowed]).unwrap();
        let start = found.start.clone().unwrap();
        assert!(found.objective < 0.1 * start, "{lever:?}: {} from {start}", found.objective);
        let value = found.levers[0].1.to_degrees();
        assert!((value - wanted).abs() < 0.1, "{lever:?}: {value} for {wanted}");
        assert!((found.constant.ratio / 0.9 - 1.0).abs() < 0.01, "{}", found.constant.ratio);
        assert!(found.shift.is_none() && found.lines == bodies(&found.levers).unwrap());
    }
}

#[test]
fn without_levers_the_shift_alone_is_fitted() {
    let lines = bodies(&[]).unwrap();
    let settings = settings();
    let samples = wave(&lines.left, &varying());
    let demand = FlankDemand { samples: &samples, settings: &settings };
    let demands = Sides { left: Some(demand), right: None };
    let search = LeverSearch { demands, bodies: &bodies, ratio: -0.7, nodes: Some(4) };
    let found = search.search(&[]).unwrap();
    let fit = FlankFit {
        lines: &lines.left,
        samples: &samples,
        settings: &settings,
        rack_slope: lines.left.profile_slope(),
    };
    assert_eq!(found.shift.unwrap(), fit_shift(&Sides { left: Some(fit), right: None }, -0.7, 4).unwrap());
    assert!(found.objective < 0.2 * found.constant.objective);
    // Refusals.
    let allowed = AllowedLever { lever: Lever::ConeAngle, start: 0.0, range: [-0.1, 0.1] };
    assert_eq!(search.search(&[allowed]).unwrap_err().code(), "cylindrical-only");
    let constant = LeverSearch { nodes: None, ..search };
    for (start, range) in
        [(0.2, [-0.1, 0.1]), (f64::NAN, [-0.1, 0.1]), (0.0, [0.1, -0.1]), (0.0, [f64::NAN, 0.1])]
    {
        let error = constant.search(&[AllowedLever { start, range, ..allowed }]).unwrap_err();
        assert_eq!(error.code(), "invalid-number");
    }
    let no_bodies = LeverSearch { bodies: &|_| Err(GeneratingError::NotDressed), ..constant };
    assert_eq!(no_bodies.search(&[allowed]).unwrap_err(), GeneratingError::NotDressed);
}
