//! Speed of a whole plan without the referee: the twist-free example, ratio chosen, both flanks dressed, 41 x 41 points each.

use criterion::{Criterion, criterion_group, criterion_main};
use flankwright::exchange::read_job;
use flankwright::workflow::prepare;
use std::hint::black_box;
use std::path::Path;

fn plan(c: &mut Criterion) {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples/twist-free-crowning.toml");
    let loaded = read_job(&file).expect("job");
    let mut group = c.benchmark_group("plan");
    group.sample_size(20);
    group.bench_function("twist-free crowning, bodies and plan", |b| {
        b.iter(|| {
            let prepared = prepare(black_box(&loaded)).unwrap_or_else(|_| panic!("bodies"));
            prepared.task().plan().expect("plan")
        });
    });
    group.finish();
}

criterion_group!(benches, plan);
criterion_main!(benches);
