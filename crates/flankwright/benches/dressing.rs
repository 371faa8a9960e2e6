//! Speed of dressing: profile with derivatives, and one set of conditions solved.

use criterion::{Criterion, criterion_group, criterion_main};
use flankwright::geometry::{Flank, Gear, GearData, Sides};
use flankwright::kinematics::DressingChain;
use flankwright::process::dressing::{
    Condition, ConditionSolver, DressedProfile, DresserTool, GeometricRange,
};
use std::hint::black_box;

const REFERENCE_RADIUS: f64 = 50.0;

/// A worm of 5 threads and 100 mm reference diameter with a dresser of 123 mm.
fn tool() -> DresserTool {
    let worm = Gear::new(GearData {
        teeth: 5,
        normal_module: 3.5,
        pressure_angle: Sides::both(17.5f64.to_radians()),
        helix_angle: 0.175f64.acos(),
        profile_shift: 0.0,
        cone_angle: 0.0,
    })
    .expect("worm");
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
    c.bench_function("3-point solve, 2 um profile crowning", |b| {
        b.iter(|| solver.solve(black_box(&rows), &[0.0; 4]).expect("correction"));
    });
}

criterion_group!(benches, dressing);
criterion_main!(benches);
