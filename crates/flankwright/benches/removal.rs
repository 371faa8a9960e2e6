//! Speed of the referee: both stages on the twist-free reference gear, 41 x 41 rays of both flanks, all threads.
//!
//! Elements are pairs of ray and pose that the scan decides; the exact minimisation of every ray is part of the time.
//! `RAYON_NUM_THREADS=1` gives the figure of one core.

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use flankwright::contact::Pair;
use flankwright::geometry::{Flank, Gear, GearData, Sides};
use flankwright::kinematics::{DressingChain, DressingMotion, GeneratingMotion, MotionLaw};
use flankwright::numerics::{Chebyshev, Silent};
use flankwright::process::dressing::{DresserTool, GeometricRange};
use flankwright::removal::{
    ActiveThreads, DressedFlank, DressedSurface, Dressing, Grinding, GrindingMode, RayGrid, WormArea, dress,
    grind,
};
use std::f64::consts::PI;
use std::hint::black_box;

const DIAGONAL_RATIO: f64 = -1.916;
const STROKE: [f64; 2] = [-60.0, 60.0];
const FEEDS: [f64; 2] = [-35.0, 35.0];
const WORM_LENGTH: [f64; 2] = [-42.0, 42.0];

/// The gear of the twist-free crowning example with its left-handed worm.
fn pair() -> Pair {
    let work = GearData {
        teeth: 19,
        normal_module: 3.5,
        pressure_angle: Sides::both(17.5f64.to_radians()),
        helix_angle: -(35f64.to_radians()),
        profile_shift: 0.0,
        cone_angle: 0.0,
    };
    let worm = GearData { teeth: 3, helix_angle: -(86.85276692942432f64.to_radians()), ..work };
    let gamma = -(worm.helix_angle + work.helix_angle);
    Pair::without_backlash(Gear::new(worm).expect("worm"), Gear::new(work).expect("gear"), gamma)
        .expect("pair")
}

struct Case {
    pair: Pair,
    tool: DresserTool,
    range: GeometricRange,
    dressing: DressingMotion,
    grinding: GeneratingMotion,
    rays: RayGrid,
}

/// Dressing with corrections as series of 17 terms, the size that planning makes: a worm crowned along its length.
fn case() -> Case {
    let pair = pair();
    let rays = RayGrid::equidistant([4.105, 22.9], 41, [-20.0, 20.0], 41).expect("rays");
    let rolls = [rays.w()[0], rays.w()[40]].map(|w_2| pair.flanks.left.worm_roll(w_2, 0.0, 0.0));
    let range = GeometricRange { w_nf: rolls[0].min(rolls[1]), w_na: rolls[0].max(rolls[1]) };
    let worm = &pair.worm;
    let screw_parameter = worm.screw_parameter(Flank::Left);
    let chain = DressingChain {
        worm_angle: -0.5 * PI,
        crossing_angle: -(screw_parameter / worm.pitch_radius()).atan(),
        centre_distance: worm.pitch_radius() - 1.25 * 3.5 + 61.5,
        offset: 0.0,
        screw_parameter,
    };
    let tool = DresserTool::conjugate(worm, Sides::both(chain), Sides::both(range)).expect("dresser");
    let law = |curvature: f64| {
        let series = Chebyshev::fit(STROKE[0], STROKE[1], 17, |v| Ok::<_, ()>(curvature * v * v));
        MotionLaw::series(series.expect("law"))
    };
    let dressing = DressingMotion { chain, correction: [law(1e-7), law(1e-9), law(1e-6), law(1e-6)] };
    let grinding = pair.motion(MotionLaw::polynomial(0.0, vec![0.0, DIAGONAL_RATIO]));
    Case { pair, tool, range, dressing, grinding, rays }
}

fn dressed(case: &Case, flank: Flank) -> DressedFlank {
    let setup = Dressing {
        worm: case.pair.worm.flank(flank),
        dresser: &case.tool.flanks[flank].profile,
        motion: &case.dressing,
        shift_range: STROKE,
        stock: 0.2,
    };
    let w = [case.range.w_nf - 0.5, case.range.w_na + 0.5];
    let grid = RayGrid::spaced(w, 0.5, WORM_LENGTH, 1.0).expect("worm rays");
    dress(&setup, &grid, &Silent).expect("dressed")
}

fn ground(case: &Case, flank: Flank, surface: &DressedSurface, mode: GrindingMode) -> u64 {
    let w = [case.range.w_nf - 0.5, case.range.w_na + 0.5];
    let setup = Grinding {
        worm: case.pair.worm.flank(flank),
        area: WormArea { w, z: WORM_LENGTH },
        modification: surface,
        work: case.pair.work.flank(flank),
        motion: &case.grinding,
        feed_range: FEEDS,
        stock: 0.2,
        threads: ActiveThreads::All,
        mode,
    };
    let left = grind(&setup, &case.rays, &Silent).expect("ground");
    assert!(left.error_um < 0.005, "{}", left.error_um);
    black_box(left.lengths().expect("every ray is reached"));
    left.statistics.pairs()
}

fn referee(c: &mut Criterion) {
    let case = case();
    let surfaces = Sides::from_fn(|flank| dressed(&case, flank).surface().expect("surface"));
    let marks = GrindingMode::FeedMarks { feed_per_revolution: 0.5, start: 0.1 };

    let mut group = c.benchmark_group("referee");
    group.sample_size(10);
    let pairs: u64 = Flank::BOTH.map(|flank| dressed(&case, flank).statistics.pairs()).iter().sum();
    group.throughput(Throughput::Elements(pairs));
    group.bench_function("dresser against worm, both flanks", |b| {
        b.iter(|| Flank::BOTH.map(|flank| dressed(black_box(&case), flank).surface().expect("surface")));
    });
    for (name, mode) in [("envelope", GrindingMode::Continuous), ("feed marks", marks)] {
        let pairs = Flank::BOTH.map(|flank| ground(&case, flank, &surfaces[flank], mode)).iter().sum();
        group.throughput(Throughput::Elements(pairs));
        group.bench_function(format!("worm against workpiece, 41 x 41 x 2, {name}"), |b| {
            b.iter(|| Flank::BOTH.map(|flank| ground(black_box(&case), flank, &surfaces[flank], mode)));
        });
    }
    group.finish();
}

criterion_group!(benches, referee);
criterion_main!(benches);
