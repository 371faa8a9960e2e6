//! Speed of the referee of milling: 81 x 61 rays of a helical flank against an end mill in 14 x 48, 12 x 199 and 25 x 199 blocks.
//!
//! Elements are rays. `RAYON_NUM_THREADS=1` gives the figure of one core.

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use foundation::geometry::{Cutter, CutterShape, ShankStep};
use foundation::numerics::Silent;
use nalgebra::Vector3;
use referee::{CutterPlace, MillPath, Milling, NormalRay, mill};
use std::hint::black_box;

const FACE: [f64; 2] = [-25.0, 25.0];
const ROLL: [f64; 2] = [11.0, 41.9];
const BASE_RADIUS: f64 = 70.648_821_212_984_7;
/// tan(beta_b) / r_b of a gear with 25 deg of helix, rad/mm.
const TWIST: f64 = 0.006_125;

/// Directions at a flank point: e_r, u, n, and the generator of the screw involute.
fn flank(w: f64, z: f64) -> [Vector3<f64>; 4] {
    let phi = w / BASE_RADIUS + 0.05 - TWIST * z;
    let (e_r, u) = (Vector3::new(phi.sin(), phi.cos(), 0.0), Vector3::new(phi.cos(), -phi.sin(), 0.0));
    let helix = (TWIST * BASE_RADIUS).atan();
    let normal = -(u * helix.cos() + Vector3::z() * helix.sin());
    [e_r * BASE_RADIUS - u * w + Vector3::z() * z, e_r, normal, u]
}

fn spread([from, to]: [f64; 2], count: usize) -> impl Iterator<Item = f64> {
    (0..count).map(move |i| from + (to - from) * i as f64 / (count - 1) as f64)
}

fn rays() -> Vec<NormalRay> {
    let mut rays = Vec::new();
    for w in spread(ROLL, 81) {
        for z in spread(FACE, 61) {
            let [point, _, normal, _] = flank(w, z);
            rays.push(NormalRay { point, normal });
        }
    }
    rays
}

/// Rows of an end mill of 2.5 mm whose side touches the flank 2.91 mm above the tip, the axis along e_r.
fn paths(rows: usize, columns: usize) -> Vec<MillPath> {
    let row = |w: f64| {
        let place = |z: f64| {
            let [point, axis, normal, _] = flank(w, z);
            CutterPlace { tip: point + normal * 2.5 - axis * 2.91, axis }
        };
        MillPath { cutter: 0, places: spread([FACE[0] - 3.5, FACE[1] + 3.5], columns).map(place).collect() }
    };
    spread(ROLL, rows).map(row).collect()
}

fn referee(c: &mut Criterion) {
    let rays = rays();
    let shank = vec![ShankStep { radius: 4.0, from: 40.0 }];
    let cutter = Cutter::new(CutterShape::end_mill(2.5, 1.0), 12.0, shank).expect("cutter");
    let mut group = c.benchmark_group("mill removal");
    group.sample_size(10);
    group.throughput(Throughput::Elements(rays.len() as u64));
    for (rows, columns) in [(14, 49), (12, 200), (25, 200)] {
        let paths = paths(rows, columns);
        let setup = Milling { cutters: std::slice::from_ref(&cutter), paths: &paths, stock: 0.5, depth: 0.5 };
        let milled = mill(&setup, &rays, &Silent).expect("milled");
        let lengths = milled.lengths().expect("every ray is reached");
        assert!(lengths.iter().all(|l| (-1e-3..0.02).contains(l)), "{lengths:?}");
        println!("{:?}", milled.statistics);
        group.bench_function(format!("{} rays, {rows} x {} blocks", rays.len(), columns - 1), |b| {
            b.iter(|| mill(black_box(&setup), &rays, &Silent).expect("milled"));
        });
    }
    group.finish();
}

criterion_group!(benches, referee);
criterion_main!(benches);
