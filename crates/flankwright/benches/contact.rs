//! Speed of the forward model: the twist-free reference case on 41 x 41 points of both flanks, one thread. And of the
//! search for a cone angle with equal diagonal ratios: the asymmetric gear of the reference.

use criterion::{Criterion, criterion_group, criterion_main};
use flankwright::contact::{DiagonalLine, ExactContact, ModifiedThread, Pair};
use flankwright::geometry::{Flank, Gear, GearData, Sides, WormChoice};
use flankwright::kinematics::MotionLaw;
use flankwright::numerics::Polynomial2;
use flankwright::process::generating::{EqualRatioSearch, Lever, generatrix};
use std::hint::black_box;

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

/// f_n1 in um about (w_1, z_1) = (94.6, 0): twist-free crowning and profile crowning of the reference case.
fn thread_function(flank: Flank) -> Polynomial2 {
    let s = flank.sign();
    let terms = [
        (0, 0, 0.000174),
        (0, 1, s * 0.002814),
        (0, 2, 0.011402),
        (1, 0, 0.000883),
        (1, 1, s * 0.007159),
        (2, 0, 0.357577),
    ];
    Polynomial2::from_terms(terms.map(|(i, j, a)| (i, j, a * 1e-3))).shifted(-94.6005211351641, 0.0)
}

fn evenly(from: f64, to: f64, n: usize) -> Vec<f64> {
    (0..n).map(|k| from + (to - from) * k as f64 / (n - 1) as f64).collect()
}

fn forward(c: &mut Criterion) {
    let pair = pair();
    let motion = pair.motion(MotionLaw::polynomial(0.0, vec![0.0, -1.916]));
    let functions = Sides::from_fn(thread_function);
    let (w, z) = (evenly(4.105029757822621, 22.90087840700895, 41), evenly(-20.0, 20.0, 41));
    c.bench_function("exact contact, 41 x 41 x 2", |b| {
        b.iter(|| {
            for flank in Flank::BOTH {
                let thread = ModifiedThread::new(pair.flanks[flank].worm, &functions[flank]);
                let exact = ExactContact::new(&pair, flank, &motion, &thread);
                black_box(exact.solve_grid(black_box(&w), &z).expect("flank"));
            }
        });
    });
}

fn equal_ratio(c: &mut Criterion) {
    let work = Gear::new(GearData {
        teeth: 31,
        normal_module: 2.5,
        pressure_angle: Sides { left: 25f64.to_radians(), right: 18f64.to_radians() },
        helix_angle: 20f64.to_radians(),
        profile_shift: 0.15,
        cone_angle: 0.0,
    })
    .expect("gear");
    let worm = WormChoice {
        threads: 2,
        hand: 1.0,
        pitch_diameter: Some(240.0),
        tip_diameter: None,
        pressure_angle: None,
        profile_shift: 0.0,
        cone_angle: 0.0,
    };
    let line = |deg: f64| DiagonalLine { rho: deg.to_radians() };
    let work_lines = Sides { left: line(30.0), right: line(-30.0) };
    let search = EqualRatioSearch { work: &work, worm, work_lines, worm_line: &generatrix };
    let limit = 12f64.to_radians();
    c.bench_function("equal diagonal ratio, cone angle", |b| {
        b.iter(|| black_box(&search).search(Lever::ConeAngle, [-limit, limit]).expect("search"));
    });
}

criterion_group!(benches, forward, equal_ratio);
criterion_main!(benches);
