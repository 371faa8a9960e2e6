//! Speed of measuring skiving tools: an edge with its nodes, the measurement of 75 teeth on ten tracks, a thousand measurements with other
//! noise, the referee on a whole tool. What is told in brackets is the wanted limit.

use criterion::{Criterion, criterion_group, criterion_main};
use flankwright::exchange::{Loaded, SkivingJob, read_job_of};
use flankwright::geometry::Flank;
use flankwright::numerics::Silent;
use flankwright::process::skiving::VirtualEdge;
use flankwright::process::skiving::evaluation::{Repeated, evaluate, measured_tool, repeat};
use flankwright::process::skiving::measuring::{BarrierData, Noise, RealTool, Sense, readings, switches};
use flankwright::workflow::skiving::{SkivingBodies, prepare_skiving, run_skiving};
use std::hint::black_box;
use std::path::Path;

fn example(name: &str) -> (Loaded<SkivingJob>, SkivingBodies) {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("../../examples/skiving/{name}.toml"));
    let Ok(loaded) = read_job_of::<SkivingJob>(&path) else { panic!("{name} is a job of skiving") };
    let prepared = prepare_skiving(&loaded).unwrap_or_else(|failure| panic!("{name}: {failure:?}"));
    (loaded, prepared.bodies)
}

/// A tool with errors everywhere, so that no touch is where it starts.
fn worn(teeth: usize) -> RealTool {
    let mut tool = RealTool::ideal(teeth);
    tool.eccentricity = [6e-3, -4e-3];
    for (tooth, pitch) in tool.pitch.iter_mut().enumerate() {
        *pitch = 1e-5 * (tooth % 7) as f64;
    }
    for flank in Flank::BOTH {
        for edge in &mut tool.edges[flank] {
            edge.profile = vec![1e-3, 2e-3, -1e-3];
            edge.growth = vec![5e-3, 1e-3];
        }
    }
    tool
}

fn skiving(criterion: &mut Criterion) {
    // 75 teeth, ten tracks on each flank.
    let (_, bodies) = example("external-stepped");
    let wanted = bodies.edges.left.flank().clone();
    criterion.bench_function("edge of 25 nodes [1 ms]", |bencher| {
        bencher.iter(|| VirtualEdge::new(black_box(&bodies.pair), wanted.clone()).expect("an edge"));
    });
    let tool = worn(bodies.teeth());
    let ideal = BarrierData::ideal();
    criterion.bench_function(
        "75 teeth on 10 tracks of both flanks, switches to verdict [10 ms]",
        |bencher| {
            bencher.iter(|| {
                let switched =
                    switches(&bodies.flanks, &bodies.beam, &ideal, black_box(&tool)).expect("switches");
                let seen =
                    readings(&bodies.flanks, &switched, &ideal, &[Sense::Positive], 1, &mut Noise::new(1));
                let measured = measured_tool(&bodies.flanks, &seen, 0.0).expect("a tool");
                evaluate(&bodies.flanks, &measured.deviations, &bodies.options).expect("an evaluation")
            });
        },
    );
    let switched = switches(&bodies.flanks, &bodies.beam, &bodies.barrier, &tool).expect("switches");
    let repeated = Repeated {
        flanks: &bodies.flanks,
        switches: &switched,
        data: &bodies.barrier,
        senses: &Sense::BOTH,
        revolutions: 2,
        radius_offset: 0.0,
        clocking: 0.0,
        options: &bodies.options,
        settings: (&bodies.free, &bodies.setting_limits),
    };
    let mut slow = criterion.benchmark_group("whole");
    slow.sample_size(10);
    slow.bench_function("1000 measurements of 75 teeth on 10 tracks [10 s]", |bencher| {
        bencher.iter(|| repeat(&repeated, 1000, 1, &Silent).expect("a scatter"));
    });
    for name in ["internal-ring", "external-stepped", "tilted-beam"] {
        let (loaded, _) = example(name);
        slow.bench_function(format!("job {name}, referee and programs included"), |bencher| {
            bencher.iter(|| run_skiving(black_box(&loaded), &Silent).map_err(|_| ()).expect("a result"));
        });
    }
    slow.finish();
}

criterion_group!(benches, skiving);
criterion_main!(benches);
