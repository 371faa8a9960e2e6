//! Measured parts: 68 files of about 105 kB read and evaluated with their sheets, and written as a series.

#[allow(dead_code, reason = "the tests need more of it")]
#[path = "../../inspection/tests/measured_parts/mod.rs"]
mod measured_parts;

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use flankwright::workflow::inspection::series::{
    SeriesOptions, inspect_series, measured_parts_in, write_inspection_series,
};
use flankwright::workflow::inspection::{SheetOptions, Statements, inspect_gear, inspection_sheet};
use measured_parts::MadePart;
use std::hint::black_box;
use std::path::Path;
use std::time::Instant;

/// Files of the series.
const FILES: u32 = 68;
/// Runs of which the best one is told: others may share the machine.
const RUNS: usize = 7;

/// Writes the files; returns the bytes of all.
fn make(folder: &Path) -> usize {
    let made = (0..FILES).map(|k| {
        let mut part = MadePart::new(&format!("part {k}"), u64::from(k));
        part.teeth = 99;
        part.time = format!("{:02}:{:02}:00 / 23:00:00", 6 + k / 60, k % 60);
        let text = part.text();
        std::fs::write(folder.join(format!("part-{k:03}.mka")), &text).expect("a file");
        text.len()
    });
    made.sum()
}

fn series(c: &mut Criterion) {
    let folder = tempfile::tempdir().expect("a directory");
    let bytes = make(folder.path());
    let paths = measured_parts_in(folder.path()).expect("parts").parts;
    let sheet = SheetOptions { tolerance_class: Some(6), ..SheetOptions::default() };
    let options = SeriesOptions { sheet: sheet.clone(), ..SeriesOptions::default() };
    let best = |run: &dyn Fn()| {
        let of = |_| {
            let begun = Instant::now();
            run();
            begun.elapsed().as_secs_f64()
        };
        (0..RUNS).map(of).fold(f64::INFINITY, f64::min)
    };
    let out = tempfile::tempdir().expect("a directory");
    let evaluated = || {
        black_box(inspect_series(&paths, &options).expect("a series"));
    };
    let written = || {
        let found = inspect_series(&paths, &options).expect("a series");
        black_box(write_inspection_series(&found, out.path()).expect("files"));
    };
    for (what, seconds) in
        [("with sheets", best(&evaluated)), ("with sheets, all files written", best(&written))]
    {
        println!(
            "{FILES} files of {:.0} kB {what}: {seconds:.3} s, {:.0} files/s, {:.1} MB/s on {} threads (best of {RUNS})",
            bytes as f64 / f64::from(FILES) / 1e3,
            f64::from(FILES) / seconds,
            bytes as f64 / seconds / 1e6,
            rayon::current_num_threads(),
        );
    }
    let mut group = c.benchmark_group("inspection");
    group.sample_size(10);
    group.throughput(Throughput::Bytes(bytes as u64));
    group.bench_function("68 files with sheets", |b| b.iter(evaluated));
    group.throughput(Throughput::Bytes(bytes as u64 / u64::from(FILES)));
    group.bench_function("one file read and evaluated", |b| {
        b.iter(|| inspect_gear(black_box(&paths[0]), &Statements::default(), None).expect("a part"));
    });
    let found = inspect_gear(&paths[0], &Statements::default(), None).expect("a part");
    group.bench_function("one sheet", |b| {
        b.iter(|| inspection_sheet(black_box(&found), &sheet).expect("a sheet"))
    });
    group.finish();
}

criterion_group!(benches, series);
criterion_main!(benches);
