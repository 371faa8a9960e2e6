//! Speed of the writers and of the reader on straight blocks of six axes, and of LinuxCNC's own reader on the same file in the
//! same run, where `scripts/linuxcnc-client` has put it.

#[allow(dead_code, reason = "the tests need more of it")]
#[path = "../tests/peer/client.rs"]
mod client;
#[allow(dead_code, reason = "the tests need more of it")]
#[path = "../tests/programs.rs"]
mod programs;

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use nc::{Dialect, WriteOptions, read, write, write_checked};
use std::hint::black_box;
use std::time::Instant;

const BLOCKS: usize = 200_000;

fn benchmark(criterion: &mut Criterion) {
    let options = WriteOptions::default();
    for dialect in Dialect::ALL {
        let program = programs::stroke(dialect, BLOCKS);
        let text = write_checked(&program, dialect, &options).expect("a program").written.text;
        let mut group = criterion.benchmark_group(dialect.name());
        group.throughput(Throughput::Elements(BLOCKS as u64));
        group.sample_size(10);
        group.bench_function("write", |b| b.iter(|| write(black_box(&program), dialect, &options)));
        group
            .bench_function("read", |b| b.iter(|| read(black_box(text.as_bytes()), dialect, program.axes())));
        group.bench_function("write_checked", |b| {
            b.iter(|| write_checked(black_box(&program), dialect, &options))
        });
        group.finish();
        if dialect == Dialect::LinuxCnc {
            against_linuxcnc(&text, || {
                drop(black_box(read(text.as_bytes(), dialect, program.axes())));
            });
        }
    }
}

/// The median time of five runs each, one after the other.
fn against_linuxcnc(text: &str, own: impl Fn()) {
    let Some(client) = client::Client::find() else {
        println!("{}: comparison skipped", client::ABSENT);
        return;
    };
    let directory = tempfile::tempdir().expect("a directory");
    let file = directory.path().join("stroke.ngc");
    std::fs::write(&file, text).expect("a file");
    let median = |mut times: Vec<f64>| {
        times.sort_by(f64::total_cmp);
        times[times.len() / 2]
    };
    let mut times = [Vec::new(), Vec::new()];
    for _ in 0..5 {
        let start = Instant::now();
        own();
        times[0].push(start.elapsed().as_secs_f64());
        times[1].push(client.parse_time(&file, directory.path()).expect("the module gcode"));
    }
    let [own, peer] = times.map(median);
    println!("reader {own:.4} s, gcode module {peer:.4} s for {BLOCKS} blocks: ratio {:.2}", peer / own);
}

criterion_group!(benches, benchmark);
criterion_main!(benches);
