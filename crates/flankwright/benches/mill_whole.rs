//! Speed of the proof of a whole milled gear: the text of `examples/milling/spur-on-ac-table.toml` (20 teeth) on all of its spaces, rapid
//! moves included. The job is planned once, outside of the measured time.

use criterion::{Criterion, criterion_group, criterion_main};
use flankwright::exchange::machine::read_machine;
use flankwright::exchange::{MillingJob, Source, parse_job_of};
use flankwright::nc::Dialect;
use flankwright::numerics::Silent;
use flankwright::workflow::milling::{MillingCheck, run_milling};
use std::hint::black_box;
use std::path::Path;

fn whole_gear(c: &mut Criterion) {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let machines = root.join("machines");
    let text = std::fs::read_to_string(root.join("examples/milling/spur-on-ac-table.toml")).expect("a job");
    let text = text.replace("../../machines", machines.to_str().expect("a path"));
    let Ok(loaded) = parse_job_of::<MillingJob>(Source::new("job.toml", &text)) else {
        panic!("no milling job")
    };
    let machine = read_machine(&machines.join("five-axis-ac-table.toml")).expect("a machine");
    let outcome = run_milling(&loaded, &Silent).expect("a plan");
    let programs = outcome.texts.programs.expect("programs").programs;
    let check = MillingCheck::new(&loaded, &machine, &Silent).expect("a check");
    let mut group = c.benchmark_group("milled gear, 20 teeth");
    group.sample_size(10);
    for program in programs.iter().filter(|program| program.dialect != Dialect::Fanuc) {
        group.bench_function(program.dialect.name(), |b| {
            b.iter(|| {
                let text = black_box(program.written.text.as_bytes());
                check.check(text, program.dialect, &Silent).expect("a program")
            });
        });
    }
    group.finish();
}

criterion_group!(benches, whole_gear);
criterion_main!(benches);
