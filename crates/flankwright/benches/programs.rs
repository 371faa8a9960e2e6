//! From settings to programs: inverse kinematics, the whole of a two-flank job in three dialects, written and read back.

use criterion::{Criterion, criterion_group, criterion_main};
use flankwright::exchange::machine::read_machine;
use flankwright::exchange::read_job;
use flankwright::geometry::Flank;
use flankwright::kinematics::{DressingPosition, GeneratingChain, GeneratingState};
use flankwright::machine::{DressingRule, Mounts, Station};
use flankwright::motion::{
    Coupling, Course, DressingCourse, GrindingCourse, LayoutOptions, Pass, axis_words, dresser_contacts,
    lay_out,
};
use flankwright::nc::{Dialect, WriteOptions, write_checked};
use flankwright::numerics::{Silent, equidistant};
use flankwright::workflow::plan_job;
use std::hint::black_box;
use std::path::Path;
use std::time::Duration;

fn root() -> std::path::PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

fn inverse(c: &mut Criterion) {
    let machine = read_machine(&root().join("machines/eight-axis.toml")).expect("a machine").machine;
    let chain = GeneratingChain {
        centre_distance: 136.2,
        crossed_axes_angle: 121.85f64.to_radians(),
        worm_cone: 0.0,
        work_cone: 0.0,
        worm_pivot: 0.0,
        work_pivot: 0.0,
    };
    let state = GeneratingState {
        worm_angle: 77.0,
        work_angle: -31.5,
        shift: -14.2,
        feed: 8.75,
        delta_d: 0.01,
        delta_gamma: 0.0,
    };
    let mounts = Mounts::default();
    let grinding = mounts.spindles(&chain.pose(&state));
    c.bench_function("inverse/grinding, both branches", |b| {
        b.iter(|| machine.grinding(black_box(&grinding)))
    });
    let position = DressingPosition {
        worm_angle: 40.0,
        worm_shift: -11.0,
        crossing_angle: 0.055,
        centre_distance: 153.0,
        offset: 0.4,
    };
    let dressing = mounts.spindles(&position.pose());
    let mut by = |name: &str, rule: DressingRule| {
        c.bench_function(name, |b| b.iter(|| machine.dressing(black_box(&dressing), rule, None)));
    };
    by("inverse/dressing, swivel given, both branches", DressingRule::Swivel(0.01));
    by("inverse/dressing, slide given", DressingRule::AxialSlide(2.0));
}

/// The strokes of the first example on a machine, as the workflow lays them out.
fn two_flank_job(c: &mut Criterion) {
    let loaded = read_job(&root().join("examples/twist-free-crowning.toml")).expect("an example");
    let machine = read_machine(&root().join("machines/no-swivel.toml")).expect("a machine");
    let outcome = plan_job(&loaded, &Silent).expect("a plan");
    let (setup, execution) = (&outcome.prepared.setup, &outcome.execution);
    let mounts = Mounts::default();
    let dressing: Vec<Pass> = Flank::BOTH
        .into_iter()
        .map(|flank| {
            let executed =
                execution.flanks[flank].as_ref().and_then(|f| f.dressing()).expect("a dressed flank");
            let dresser = &execution.dresser.as_ref().expect("a dresser").flanks[flank];
            let rolls = equidistant([dresser.range.w_nf, dresser.range.w_na], 5);
            let course = DressingCourse {
                motion: executed.motion.clone(),
                interval: executed.driven,
                mounts,
                contacts: dresser_contacts(&dresser.worm, dresser.chain.worm_angle, &rolls),
            };
            pass(Course::Dressing(course), executed.driven, 33.0)
        })
        .collect();
    let work = setup.pair.work.flank(Flank::Left);
    let course = GrindingCourse {
        motion: execution.motion.clone(),
        phase: execution.motion.phase.left,
        feeds: execution.feed_range,
        turning: 130.0,
        mounts,
        per_turn: work.base_radius * work.base_helix_angle.cos(),
        per_distance: 0.3,
    };
    let grinding = vec![pass(Course::Grinding(course), execution.feed_range, 3.8)];
    c.bench_function("programs/two-flank job, three dialects, written and read back", |b| {
        b.iter(|| {
            let mut bytes = 0;
            for dialect in Dialect::ALL {
                for (station, passes) in [(Station::Dresser, &dressing), (Station::Work, &grinding)] {
                    let axes = machine.machine.axes_at(station).expect("axes");
                    let word = |name: &str| match name {
                        "B1" => Some("B"),
                        name => machine.file.axes[name].letter.as_deref(),
                    };
                    let words = axis_words(&machine.machine, &axes, word).expect("words");
                    let layout = lay_out(&machine.machine, &words, passes, &options()).expect("a layout");
                    let checked = write_checked(&layout.program, dialect, &WriteOptions::default());
                    bytes += checked.expect("a program").written.text.len();
                }
            }
            bytes
        });
    });
}

fn pass(course: Course, range: [f64; 2], speed: f64) -> Pass {
    Pass { name: "STROKE".into(), course, range, room: [5.0, 5.0], speed, clearance: 15.0, dwell: 0.0 }
}

fn options() -> LayoutOptions {
    LayoutOptions {
        name: "BENCH".into(),
        comments: Vec::new(),
        tolerance: 5e-6,
        swivel: 0.0,
        coupling: Coupling::Blocks,
        dresser_speed: 4000.0 * std::f64::consts::TAU / 60.0,
        half_unit: [5e-7, 8.7e-10],
    }
}

/// The proof of a job's programs for one thread of the worm and for three: further threads stand under a coarser grid of rays, so that
/// three take at most 1.5 times as long.
fn proof(c: &mut Criterion) {
    let mut group = c.benchmark_group("programs/proof");
    group.sample_size(10);
    for threads in [1, 3] {
        let mut loaded = read_job(&root().join("examples/twist-free-crowning.toml")).expect("an example");
        loaded.job.worm.threads = threads;
        group.bench_function(format!("{threads} threads"), |b| {
            // The run itself measures its proof apart from the plan and the texts.
            b.iter_custom(|times| {
                let once =
                    || plan_job(&loaded, &Silent).expect("a plan").programs.expect("programs").seconds[1];
                Duration::from_secs_f64((0..times).map(|_| once()).sum())
            });
        });
    }
    group.finish();
}

criterion_group!(benches, inverse, two_flank_job, proof);
criterion_main!(benches);
