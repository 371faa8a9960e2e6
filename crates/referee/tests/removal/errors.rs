//! Rays without a length and unusable input.

use super::setups::{area, dressing_cases, feeds, field, meshing};
use foundation::geometry::{Flank, Revolution};
use foundation::kinematics::{DressingMotion, MotionLaw};
use foundation::numerics::{Chebyshev, Progress, Silent, TensorSpline};
use referee::{
    ActiveThreads, Dressing, Grinding, GrindingMode, RayGrid, RemovalError, Stage, Uncut, Unmodified,
    WormArea, dress, grind,
};
use std::sync::atomic::{AtomicU64, Ordering};

#[test]
fn a_short_dressing_stroke_leaves_rays_uncut() {
    let case = &dressing_cases()[0];
    let motion = DressingMotion::constant(case.tool.flanks.left.chain, [0.0; 4]);
    let grid = RayGrid::equidistant([case.range.w_nf, case.range.w_na], 5, [-15.0, 15.0], 31).unwrap();
    let setup = Dressing {
        worm: case.worm.flank(Flank::Left),
        dresser: &case.tool.flanks.left.profile,
        motion: &motion,
        shift_range: [-5.0, 40.0],
        stock: 0.2,
    };
    let left = dress(&setup, &grid, &Silent).unwrap();
    assert!(left.rays.contains(&Err(Uncut::StrokeTooShort)));
    assert!(left.rays.iter().all(|ray| ray.is_ok_and(|r| r.f.abs() * 1e3 <= left.error_um) || ray.is_err()));
    let error = left.surface().unwrap_err();
    assert!(matches!(error, RemovalError::RayUncut { stage: Stage::Dressing, .. }), "{error}");
    assert_eq!(error.code(), "ray-uncut");
    assert!(!error.way_out().is_empty() && error.to_string().contains("dressing"));
}

#[test]
fn a_short_dresser_leaves_rays_uncut() {
    let case = &dressing_cases()[0];
    let motion = DressingMotion::constant(case.tool.flanks.left.chain, [0.0; 4]);
    let whole = &case.tool.flanks.left.profile;
    // Only the part of the profile that serves the middle of the range.
    let (from, to) = (case.range.middle() - 1.0, case.range.middle() + 1.0);
    let part = |value: &dyn Fn(f64) -> f64| Chebyshev::fit(from, to, 20, |t| Ok::<_, ()>(value(t))).unwrap();
    let at_middle = whole.at(case.range.middle());
    let mut short = Revolution::new(part(&|t| whole.at(t).r), part(&|t| whole.at(t).z), 1.0);
    if short.at(case.range.middle()).n_z * at_middle.n_z < 0.0 {
        short = Revolution::new(part(&|t| whole.at(t).r), part(&|t| whole.at(t).z), -1.0);
    }
    let grid = RayGrid::equidistant([case.range.w_nf, case.range.w_na], 15, [-5.0, 5.0], 3).unwrap();
    let setup = Dressing {
        worm: case.worm.flank(Flank::Left),
        dresser: &short,
        motion: &motion,
        shift_range: [-40.0, 40.0],
        stock: 0.2,
    };
    let left = dress(&setup, &grid, &Silent).unwrap();
    for (index, ray) in left.rays.iter().enumerate() {
        let inside = (left.grid.ray(index).0 - case.range.middle()).abs() < 0.99;
        let outside = (left.grid.ray(index).0 - case.range.middle()).abs() > 1.01;
        assert!(!inside || ray.is_ok_and(|r| r.f.abs() < 1e-9), "{index} {ray:?}");
        assert!(!outside || ray.is_err(), "{index} {ray:?}");
    }
}

#[test]
fn stroke_and_worm_must_reach_every_ray() {
    let pair = meshing(25, 2.0, 20.0, 20.0, 2, 120.0);
    let motion = pair.motion(MotionLaw::zero());
    let flank = Flank::Left;
    let grid = field(&pair.work, flank, 9, 16.0, 17);
    let feed_range = feeds(&pair, flank, &grid, &motion, 1.0);
    let whole = Grinding {
        worm: pair.worm.flank(flank),
        area: area(&pair, flank, &grid, &motion, [1.0, 4.0]),
        modification: &Unmodified,
        work: pair.work.flank(flank),
        motion: &motion,
        feed_range,
        stock: 0.1,
        threads: ActiveThreads::All,
        mode: GrindingMode::Continuous,
    };
    let ground = grind(&whole, &grid, &Silent).unwrap();
    let full: Vec<_> = ground.rays.iter().map(|ray| ray.unwrap()).collect();

    let middle = 0.5 * (feed_range[0] + feed_range[1]);
    let half = grind(&Grinding { feed_range: [feed_range[0], middle], ..whole }, &grid, &Silent).unwrap();
    // A tip that ends just short of what the first row of rays needs.
    let tip = full[0].worm_roll - 0.05;
    let narrow = WormArea { w: [whole.area.w[0], tip], ..whole.area };
    let low = grind(&Grinding { area: narrow, ..whole }, &grid, &Silent).unwrap();
    for (k, ray) in full.iter().enumerate() {
        if (ray.feed - middle).abs() > 1e-3 {
            assert_eq!(half.rays[k].is_ok(), ray.feed < middle, "{k} {:?}", half.rays[k]);
        }
        if (ray.worm_roll - tip).abs() > 1e-3 {
            assert_eq!(low.rays[k].is_ok(), ray.worm_roll < tip, "{k} {:?}", low.rays[k]);
        }
    }
    assert!(half.rays.contains(&Err(Uncut::StrokeTooShort)) && low.rays.contains(&Err(Uncut::ToolMissing)));
    let error = low.lengths().unwrap_err();
    assert!(matches!(error, RemovalError::RayUncut { stage: Stage::Grinding, .. }));

    // A worm that stands elsewhere.
    let mut apart = motion.clone();
    apart.chain.centre_distance += 5.0;
    let none = grind(&Grinding { motion: &apart, ..whole }, &grid, &Silent).unwrap();
    assert!(none.rays.iter().all(|ray| *ray == Err(Uncut::NotReached)));
    // A few hundredths closer, everything is cut deeper.
    apart.chain.centre_distance = motion.chain.centre_distance - 0.05;
    let deep = grind(&Grinding { motion: &apart, ..whole }, &grid, &Silent).unwrap();
    assert!(deep.lengths().unwrap().iter().all(|f| *f < -0.01 && *f > -0.03));
}

#[test]
fn unusable_input_is_refused() {
    let pair = meshing(25, 2.0, 20.0, 20.0, 2, 120.0);
    let motion = pair.motion(MotionLaw::zero());
    let grid = field(&pair.work, Flank::Left, 3, 10.0, 3);
    let good = Grinding {
        worm: pair.worm.flank(Flank::Left),
        area: area(&pair, Flank::Left, &grid, &motion, [1.0, 4.0]),
        modification: &Unmodified,
        work: pair.work.flank(Flank::Left),
        motion: &motion,
        feed_range: [-20.0, 20.0],
        stock: 0.1,
        threads: ActiveThreads::All,
        mode: GrindingMode::Continuous,
    };
    let code = |setup: Grinding<'_>| grind(&setup, &grid, &Silent).unwrap_err().code();
    assert_eq!(code(Grinding { feed_range: [1.0, 1.0], ..good }), "invalid-number");
    assert_eq!(code(Grinding { feed_range: [f64::NAN, 1.0], ..good }), "invalid-number");
    assert_eq!(code(Grinding { feed_range: [-1e9, 1e9], ..good }), "invalid-number");
    assert_eq!(code(Grinding { stock: 0.0, ..good }), "invalid-number");
    assert_eq!(code(Grinding { stock: 5.0, ..good }), "invalid-number");
    assert_eq!(code(Grinding { worm: pair.worm.flank(Flank::Right), ..good }), "flanks-differ");
    let standing = GrindingMode::FeedMarks { feed_per_revolution: 0.0, start: 0.0 };
    assert_eq!(code(Grinding { mode: standing, ..good }), "invalid-number");
    let lost = GrindingMode::FeedMarks { feed_per_revolution: 0.5, start: f64::NAN };
    assert_eq!(code(Grinding { mode: lost, ..good }), "invalid-number");
    let mut internal = *pair.work.flank(Flank::Left);
    internal.external_sign = -1.0;
    assert_eq!(code(Grinding { work: &internal, ..good }), "internal-unsupported");
    // A worm function that is known somewhere else.
    let axis = [0.0, 1.0, 2.0, 3.0];
    let elsewhere = TensorSpline::new(&axis, &axis, &vec![vec![0.0; 4]; 4]).unwrap();
    assert_eq!(code(Grinding { modification: &elsewhere, ..good }), "invalid-number");

    for (w, z) in [
        (vec![], vec![0.0]),
        (vec![1.0], vec![]),
        (vec![0.0, 1.0], vec![0.0]),
        (vec![2.0, 1.0], vec![0.0]),
        (vec![1.0], vec![f64::NAN]),
    ] {
        assert_eq!(RayGrid::new(w, z).unwrap_err().code(), "invalid-ray-grid");
    }
    assert_eq!(RayGrid::spaced([1.0, 2.0], 0.0, [0.0, 1.0], 1.0).unwrap_err().code(), "invalid-number");

    let case = &dressing_cases()[0];
    let dressing_motion = DressingMotion::constant(case.tool.flanks.left.chain, [0.0; 4]);
    let rays = RayGrid::equidistant([41.0, 47.0], 4, [-1.0, 1.0], 3).unwrap();
    let folded = Revolution::new(
        Chebyshev::interpolate(0.0, 1.0, &[50.0, 51.0, 50.0]),
        Chebyshev::interpolate(0.0, 1.0, &[0.0, 1.0, 2.0]),
        1.0,
    );
    let good = Dressing {
        worm: case.worm.flank(Flank::Left),
        dresser: &case.tool.flanks.left.profile,
        motion: &dressing_motion,
        shift_range: [-30.0, 30.0],
        stock: 0.1,
    };
    let code = |setup: Dressing<'_>| dress(&setup, &rays, &Silent).unwrap_err().code();
    assert_eq!(code(Dressing { shift_range: [3.0, -3.0], ..good }), "invalid-number");
    assert_eq!(code(Dressing { shift_range: [0.0, 1e9], ..good }), "invalid-number");
    assert_eq!(code(Dressing { stock: f64::NAN, ..good }), "invalid-number");
    assert_eq!(code(Dressing { dresser: &folded, ..good }), "dresser-profile-folds");
    // Three rays in z make no cubic spline.
    assert_eq!(dress(&good, &rays, &Silent).unwrap().surface().unwrap_err().code(), "no-worm-surface");
}

/// Counts what it is told.
#[derive(Default)]
struct Counter {
    total: AtomicU64,
    done: AtomicU64,
    finished: AtomicU64,
}

impl Progress for Counter {
    fn start(&self, _: &str, total: u64) {
        self.total.fetch_add(total, Ordering::Relaxed);
    }
    fn advance(&self, n: u64) {
        self.done.fetch_add(n, Ordering::Relaxed);
    }
    fn finish(&self) {
        self.finished.fetch_add(1, Ordering::Relaxed);
    }
}

#[test]
fn progress_adds_up() {
    let case = &dressing_cases()[1];
    let motion = DressingMotion::constant(case.tool.flanks.left.chain, [0.0; 4]);
    let grid = RayGrid::equidistant([case.range.w_nf, case.range.w_na], 8, [-10.0, 10.0], 20).unwrap();
    let setup = Dressing {
        worm: case.worm.flank(Flank::Left),
        dresser: &case.tool.flanks.left.profile,
        motion: &motion,
        shift_range: [-30.0, 30.0],
        stock: 0.1,
    };
    let counter = Counter::default();
    let left = dress(&setup, &grid, &counter).unwrap();
    assert_eq!(counter.total.load(Ordering::Relaxed), left.statistics.rays);
    assert_eq!(counter.done.load(Ordering::Relaxed), left.statistics.rays);
    assert_eq!(counter.finished.load(Ordering::Relaxed), 1);
    assert_eq!(left.statistics.pairs(), left.statistics.rays * left.statistics.poses);
}
