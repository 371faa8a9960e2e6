//! Inactive threads: which tooth spaces stay uncut, and how far apart the marks of a real feed lie.

use super::setups::{area, feeds, meshing};
use contact::Pair;
use foundation::geometry::Flank;
use foundation::kinematics::{GeneratingMotion, MotionLaw};
use foundation::numerics::Silent;
use referee::{
    ActiveThreads, Grinding, GrindingMode, GroundFlank, RayGrid, RemovalError, Uncut, Unmodified, grind,
};

const FLANK: Flank = Flank::Left;

struct Bench {
    pair: Pair,
    motion: GeneratingMotion,
    grid: RayGrid,
}

impl Bench {
    /// A gear with a two-thread worm and one row of rays over one or two marks, close enough to find their heights to 3 percent.
    fn new(teeth: i32) -> Self {
        let pair = meshing(teeth, 2.0, 20.0, 20.0, 2, 120.0);
        let motion = pair.motion(MotionLaw::zero());
        let f = pair.work.flank(FLANK);
        let w = f.length_of_roll(pair.work.pitch_radius()).unwrap();
        let z = (0..141).map(|k| -0.7 + 0.01 * f64::from(k)).collect();
        Self { grid: RayGrid::new(vec![w], z).unwrap(), pair, motion }
    }

    fn ground(&self, threads: ActiveThreads<'_>, mode: GrindingMode) -> Result<GroundFlank, RemovalError> {
        let setup = Grinding {
            worm: self.pair.worm.flank(FLANK),
            area: area(&self.pair, FLANK, &self.grid, &self.motion, [4.0, 12.0]),
            modification: &Unmodified,
            work: self.pair.work.flank(FLANK),
            motion: &self.motion,
            feed_range: feeds(&self.pair, FLANK, &self.grid, &self.motion, 6.0),
            stock: 0.1,
            threads,
            mode,
        };
        grind(&setup, &self.grid, &Silent)
    }

    fn marks(&self, threads: ActiveThreads<'_>, feed: f64, start: f64) -> Vec<f64> {
        let mode = GrindingMode::FeedMarks { feed_per_revolution: feed, start };
        self.ground(threads, mode).unwrap().lengths().unwrap()
    }
}

fn only<'a>(threads: &'a [u32], strokes: &'a [u32]) -> ActiveThreads<'a> {
    ActiveThreads::Only { threads, strokes }
}

fn highest(f: &[f64]) -> f64 {
    f.iter().copied().fold(0.0, f64::max)
}

#[test]
fn odd_teeth_with_one_of_two_threads_are_ground_at_half_the_feed() {
    let bench = Bench::new(25);
    let feed = 0.6;
    let all = bench.marks(ActiveThreads::All, feed, 0.1);
    let first = bench.marks(only(&[0], &[0]), 0.5 * feed, 0.1);
    let second = bench.marks(only(&[1], &[0]), 0.5 * feed, 0.1);
    // Every second pass of half the feed: the marks lie as far apart as those of all threads at the whole feed.
    for f in [&first, &second] {
        assert!((highest(f) / highest(&all) - 1.0).abs() < 0.05, "{} {}", highest(f), highest(&all));
    }
    // At the same feed they lie twice as far apart and are four times as high.
    let coarse = bench.marks(only(&[0], &[0]), feed, 0.1);
    assert!((highest(&coarse) / highest(&all) - 4.0).abs() < 0.2, "{} {}", highest(&coarse), highest(&all));
    // Both threads together are the lower of the two, ray by ray.
    let both = bench.marks(only(&[0, 1], &[0]), 0.5 * feed, 0.1);
    let every = bench.marks(ActiveThreads::All, 0.5 * feed, 0.1);
    for k in 0..both.len() {
        assert!((both[k] - first[k].min(second[k])).abs() < 1e-10, "{k}");
        assert_eq!(both[k], every[k]);
    }
    assert!((0..both.len()).any(|k| (first[k] - second[k]).abs() > 0.1 * highest(&first)));
    // One thread moves on by one turn of the workpiece: its passes are those of the other, a feed later.
    let later = bench.marks(only(&[1], &[0]), 0.5 * feed, 0.1 - 0.5 * feed);
    for k in 0..first.len() {
        assert!((later[k] - first[k]).abs() < 1e-10, "{k}: {} {}", later[k], first[k]);
    }
    // The other thread in a second stroke, indexed by a pitch, is as good as both in one.
    let indexed = bench.marks(only(&[0], &[0, 1]), 0.5 * feed, 0.1);
    assert_eq!(indexed, every);
}

#[test]
fn even_teeth_meet_the_same_thread_for_ever() {
    let bench = Bench::new(24);
    let feed = 0.6;
    for mode in [GrindingMode::Continuous, GrindingMode::FeedMarks { feed_per_revolution: feed, start: 0.1 }]
    {
        let all = bench.ground(ActiveThreads::All, mode).unwrap();
        // Tooth space 0 meets thread 0 only.
        assert_eq!(bench.ground(only(&[0], &[0]), mode).unwrap().rays, all.rays);
        let uncut = bench.ground(only(&[1], &[0]), mode).unwrap();
        assert!(uncut.rays.iter().all(|ray| *ray == Err(Uncut::NoActiveThread)), "{:?}", uncut.rays[0]);
        let error = uncut.lengths().unwrap_err();
        assert_eq!(error.code(), "ray-uncut");
        assert!(error.way_out().contains("index") && error.to_string().contains("thread"));
        // A second stroke one pitch on brings thread 1 to it.
        assert_eq!(bench.ground(only(&[1], &[0, 1]), mode).unwrap().rays, all.rays);
        assert_eq!(bench.ground(only(&[1], &[0, 2]), mode).unwrap().rays, uncut.rays);
    }
}

#[test]
fn in_the_envelope_odd_teeth_miss_nothing() {
    let bench = Bench::new(25);
    let all = bench.ground(ActiveThreads::All, GrindingMode::Continuous).unwrap();
    for kept in [0, 1] {
        assert_eq!(bench.ground(only(&[kept], &[0]), GrindingMode::Continuous).unwrap().rays, all.rays);
    }
}

#[test]
fn impossible_choices_of_threads_are_refused() {
    let bench = Bench::new(25);
    let code = |threads| bench.ground(threads, GrindingMode::Continuous).unwrap_err().code();
    assert_eq!(code(only(&[], &[0])), "no-active-thread");
    assert_eq!(code(only(&[2], &[0])), "invalid-number");
    assert_eq!(code(only(&[0], &[])), "invalid-number");
    let error = bench.ground(only(&[], &[0]), GrindingMode::Continuous).unwrap_err();
    assert!(error.to_string().contains('2') && !error.way_out().is_empty());
}

/// Along a tooth so long that it winds round its gear more than once, the marks of one thread keep their distance: no pass
/// changes its thread where the angle of the cut goes through a whole turn.
#[test]
fn marks_keep_their_distance_round_the_whole_gear() {
    let mut bench = Bench::new(25);
    let feed = 0.6;
    let work = *bench.pair.work.flank(FLANK);
    let along = feed / (1.0 - feed * work.twist_per_length() / (2.0 * std::f64::consts::PI));
    let w = bench.grid.w().to_vec();
    for phase in [0.0, 0.31, 0.77] {
        let z: Vec<f64> = (0..61).map(|k| -240.0 + along * (phase + 2.0 * 7.0 * f64::from(k))).collect();
        assert!((z[60] - z[0]) * work.twist_per_length() > 2.0 * std::f64::consts::PI);
        bench.grid = RayGrid::new(w.clone(), z).unwrap();
        let one = bench.marks(only(&[0], &[0]), feed, 0.1);
        let height = 4.0 * 2.1e-4;
        for f in &one {
            assert!((f - one[0]).abs() < 1e-6 * height, "{phase}: {f} {}", one[0]);
        }
    }
}
