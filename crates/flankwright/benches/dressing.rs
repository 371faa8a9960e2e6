//! Speed of dressing: profile with derivatives, conditions solved exactly and by compensation, the range of crownings, and the
//! limits of one worm under one dresser.

use criterion::{Criterion, criterion_group, criterion_main};
use flankwright::geometry::{Flank, Gear, GearData, Sides};
use flankwright::kinematics::DressingChain;
use flankwright::process::dressing::{
    Compensation, Condition, ConditionSolver, CrowningLimits, CrowningRows, DressedProfile, DresserSection,
    DresserTool, GeometricRange, SoftCondition, ThreadSpace, WormFlank,
};
use std::hint::black_box;

const REFERENCE_RADIUS: f64 = 50.0;

/// A worm of 5 threads.
fn worm(reference_radius: f64) -> Gear {
    Gear::new(GearData {
        teeth: 5,
        normal_module: 3.5,
        pressure_angle: Sides::both(17.5f64.to_radians()),
        helix_angle: (2.5 * 3.5 / reference_radius).acos(),
        profile_shift: 0.0,
        cone_angle: 0.0,
    })
    .expect("worm")
}

/// The worm of 100 mm reference diameter with a dresser of 123 mm.
fn tool() -> DresserTool {
    let worm = worm(REFERENCE_RADIUS);
    let screw_parameter = worm.screw_parameter(Flank::Left);
    let chain = DressingChain {
        worm_angle: -std::f64::consts::FRAC_PI_2,
        crossing_angle: -(screw_parameter / REFERENCE_RADIUS).atan(),
        centre_distance: 107.21575507631842,
        offset: 0.0,
        screw_parameter,
    };
    let range = GeometricRange { w_nf: 40.51228112588766, w_na: 47.38820666623544 };
    DresserTool::conjugate(&worm, Sides::both(chain), Sides::both(range)).expect("dresser")
}

fn dressing(c: &mut Criterion) {
    let tool = tool();
    let range = tool.flanks.left.range;
    let rolls: Vec<f64> = (0..7).map(|k| range.w_nf + range.length() * f64::from(k) / 6.0).collect();
    let dk = [0.1f64.to_radians(), -(0.8f64.to_radians()), -0.05, 1.5];
    c.bench_function("f and Jacobian at 7 points", |b| {
        let profile = DressedProfile::new(&tool, Flank::Left, dk);
        b.iter(|| profile.at_rolls(black_box(&rolls)).expect("profile"));
    });
    let point = |w, f| Condition::Point { flank: Flank::Left, w, f };
    let rows = [
        point(range.w_nf, 0.0),
        point(range.middle(), -0.0016742),
        point(range.w_na, 0.0),
        Condition::Map { flank: Flank::Left, t: range.w_na, w: range.w_na },
    ];
    let solver = ConditionSolver::new(&tool, REFERENCE_RADIUS);
    let crownings = CrowningRows::new(&tool.flanks.left, REFERENCE_RADIUS, 0.58);
    c.bench_function("range of profile crownings, both ways", |b| {
        b.iter(|| crownings.range(black_box(&CrowningLimits::default())).expect("range"));
    });
    let soft: Vec<SoftCondition> = rolls
        .iter()
        .map(|&w| SoftCondition {
            condition: point(w, 5e-4 * ((w - range.middle()) / range.length()).powi(3)),
            weight: 1.0,
        })
        .collect();
    let compensation = Compensation::new(&tool, REFERENCE_RADIUS, soft, vec![rows[3]]);
    c.bench_function("compensation of 7 points with a hard map", |b| {
        b.iter(|| compensation.solve(black_box(&[0.0; 4])).expect("correction"));
    });
    c.bench_function("3-point solve, 2 um profile crowning", |b| {
        b.iter(|| solver.solve(black_box(&rows), &[0.0; 4]).expect("correction"));
    });
}

/// What a catalogue search asks of every worm and dresser.
fn limits(c: &mut Criterion) {
    let tool = tool();
    let section = DresserSection::new(&tool, Flank::Left, 61.5).expect("section");
    // A profile crowning of 10 um: the opposite flank collides with a land of 1 mm.
    let dk =
        [-(3.4911511956285777f64.to_radians()), -(6.194639376234722f64.to_radians()), -2.72154, 11.75636];
    c.bench_function("section of a dresser", |b| {
        b.iter(|| DresserSection::new(black_box(&tool), Flank::Left, 61.5).expect("section"));
    });
    c.bench_function("clearance of the opposite flank", |b| {
        b.iter(|| {
            section.counter_flank_clearance(black_box(&dk), 1.0, ThreadSpace::default()).expect("seat")
        });
    });
    c.bench_function("largest tip land", |b| {
        b.iter(|| section.largest_tip_land(black_box(&dk), 0.0, ThreadSpace::default()).expect("seat"));
    });
    let smaller = worm(46.0);
    let flanks = smaller.flanks().map(|_, &flank| WormFlank {
        flank,
        range: GeometricRange {
            w_nf: flank.length_of_roll(43.0).expect("roll"),
            w_na: flank.length_of_roll(49.0).expect("roll"),
        },
    });
    c.bench_function("undermining of a smaller worm in 3 planes", |b| {
        b.iter(|| section.undermining(black_box(&dk), 1.0, &flanks, &[-50.0, 0.0, 50.0]).expect("seat"));
    });
}

criterion_group!(benches, dressing, limits);
criterion_main!(benches);
