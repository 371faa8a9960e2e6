//! Speed of the general decomposition: one ratio, a scan over ratios, growing numbers of samples and intervals, both norms.

use criterion::{BenchmarkId, Criterion, criterion_group, criterion_main};
use flankwright::exchange::read_job;
use flankwright::geometry::Sides;
use flankwright::process::generating::least_squares::{
    Candidates, DiagonalCoordinates, FitNorm, FitSettings, FlankFit, FunctionClass, Objective, Samples,
    SplineDecomposition, search_ratio,
};
use flankwright::workflow::prepare;
use std::hint::black_box;
use std::path::Path;

/// Reliefs of two directions on a field of 18 mm x 40 mm.
fn samples([nw, nz]: [usize; 2]) -> Samples {
    let relief = |w: f64, z: f64| {
        -0.03 * (1.0 + (w - 22.0) / 6.0 + (z - 20.0) / 10.0).max(0.0)
            - 0.02 * (1.0 - (w - 4.0) / 5.0 - (z + 20.0) / 5.0).max(0.0)
    };
    let points: Vec<[f64; 3]> = (0..nw * nz)
        .map(|i| (4.0 + 18.0 * (i / nz) as f64 / (nw - 1) as f64, (i % nz) as f64 / (nz - 1) as f64))
        .map(|(w, v)| [w, 40.0 * v - 20.0, relief(w, 40.0 * v - 20.0)])
        .collect();
    Samples::of_points(&points).expect("finite")
}

fn one_ratio(c: &mut Criterion) {
    let coordinates = DiagonalCoordinates::new(1.4, -0.6, 0.0).expect("directions");
    let mut group = c.benchmark_group("least squares");
    group.sample_size(20);
    let grid = samples([25, 31]);
    for norm in [FitNorm::LeastSquares, FitNorm::Largest] {
        let settings = FitSettings { norm, ..FitSettings::new(FunctionClass::ALL) };
        group.bench_function(format!("one ratio, 25 x 31, {norm:?}"), |b| {
            b.iter(|| SplineDecomposition::fit(black_box(&grid), coordinates, &settings).expect("fit"));
        });
    }
    for intervals in [5, 10, 20, 40] {
        let settings = FitSettings { intervals, ..FitSettings::new(FunctionClass::ALL) };
        group.bench_function(BenchmarkId::new("intervals", intervals), |b| {
            b.iter(|| SplineDecomposition::fit(black_box(&grid), coordinates, &settings).expect("fit"));
        });
    }
    group.sample_size(10);
    for size in [[25, 40], [80, 125], [250, 400], [800, 1250]] {
        let cloud = samples(size);
        let settings = FitSettings::new(FunctionClass::ALL);
        group.bench_function(BenchmarkId::new("samples", cloud.count()), |b| {
            b.iter(|| SplineDecomposition::fit(black_box(&cloud), coordinates, &settings).expect("fit"));
        });
    }
    group.finish();
}

fn scan(c: &mut Criterion) {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples/twist-free-crowning.toml");
    let loaded = read_job(&file).expect("job");
    let prepared = prepare(&loaded).unwrap_or_else(|_| panic!("bodies"));
    let task = prepared.task();
    let target = samples([25, 31]);
    let settings = FitSettings::new(FunctionClass::ALL);
    let lines = &task.setup.lines;
    let fits = Sides::from_fn(|flank| {
        Some(FlankFit { lines: &lines[flank], samples: &target, settings: &settings, rack_slope: 0.0 })
    });
    let mut group = c.benchmark_group("least squares");
    group.sample_size(10);
    let candidates = Candidates::both_signs([0.2, 3.0], 100).expect("range");
    group.bench_function("scan of 200 ratios, both flanks, and refinement", |b| {
        b.iter(|| search_ratio(black_box(&fits), &candidates, Objective::Rms).expect("search"));
    });
    group.bench_function("scan of 200 ratios, both flanks", |b| {
        b.iter(|| {
            let at = |&ratio: &f64| {
                let left = fits.left.as_ref().map(|f| f.at_ratio(ratio).expect("fit").report.quality().rms);
                let right = fits.right.as_ref().map(|f| f.at_ratio(ratio).expect("fit").report.quality().rms);
                (left, right)
            };
            use rayon::prelude::*;
            black_box(candidates.values().par_iter().map(at).collect::<Vec<_>>())
        });
    });
    group.finish();
}

criterion_group!(benches, one_ratio, scan);
criterion_main!(benches);
