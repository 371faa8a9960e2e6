//! Speed of planning five-axis milling: cutter locations with orientation and local gouge check on one core, OpenCAMLib's three-axis
//! drop cutter on the same flank and with the same cutter beside them (where `scripts/opencamlib-peer` has put it), the clearance of a
//! tooth gap, and the plans of all examples.

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use flankwright::exchange::mesh::{PatchSide, patch, stl};
use flankwright::exchange::{MillingJob, read_job_of};
use flankwright::geometry::CutterShape;
use flankwright::numerics::equidistant;
use flankwright::process::milling::{
    Column, ColumnPlane, CutterLocation, HeightRule, LocalContact, MillingPlan, OperationKind, check_path,
    plan, plan_all,
};
use flankwright::workflow::milling::{MillingBodies, prepare_milling};
use nalgebra::{Rotation3, Vector3};
use std::hint::black_box;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::Instant;

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

fn example(name: &str) -> MillingBodies {
    let path = root().join(format!("examples/milling/{name}.toml"));
    let Ok(job) = read_job_of::<MillingJob>(&path) else { panic!("{name} is a job of milling") };
    prepare_milling(&job).unwrap_or_else(|failure| panic!("{name}: {failure:?}")).bodies
}

/// Rows and columns of the flank on which locations are counted.
const ROWS: usize = 40;
const COLUMNS: usize = 50;

/// Locations at the sections of columns with a flank: the section, the axis in its plane, the tip, and whether the cutter digs in
/// around the contact. The sum of their heights keeps all of them.
fn locations(bodies: &MillingBodies, planes: &[ColumnPlane], heights: &[f64]) -> f64 {
    let flank = &bodies.parts[0].flanks[0].active;
    let cutter = &bodies.options.cutter;
    let HeightRule::Fixed(height) = bodies.options.heights else { panic!("one contact height") };
    let mut sum = 0.0;
    for plane in planes {
        let column = Column::at_heights(flank, plane, heights).expect("a column");
        for place in &column.places {
            let location = CutterLocation::new(
                &place.jet,
                plane.lead(),
                cutter.shape(),
                cutter.cutting_length(),
                height,
                bodies.options.orientation,
            )
            .expect("a location");
            LocalContact::new(&place.jet, &location, cutter.shape()).check(&place.jet).expect("no gouge");
            sum += location.tip.y;
        }
    }
    sum
}

fn kernel(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("cutter locations with local gouge check, one core");
    group.throughput(Throughput::Elements((ROWS * COLUMNS) as u64));
    for name in ["helical-module-6", "spiral-bevel-15", "automotive-gear"] {
        let bodies = example(name);
        let flank = &bodies.parts[0].flanks[0].active;
        let range = bodies.ranges().expect("a range")[0].lead;
        let plane = |u| ColumnPlane::new(flank, bodies.parts[0].lead.at(u).expect("a lead point"));
        let planes: Vec<ColumnPlane> = equidistant(range, COLUMNS).into_iter().map(plane).collect();
        let heights = equidistant(flank.height_span(), ROWS);
        group.bench_function(name, |b| b.iter(|| locations(black_box(&bodies), &planes, &heights)));
        if name == "helical-module-6" {
            beside_opencamlib(&bodies, || locations(&bodies, &planes, &heights));
        }
    }
    group.finish();
}

/// The least time of five runs of each, one after the other: other programs can only add to it.
fn beside_opencamlib(bodies: &MillingBodies, own: impl Fn() -> f64) {
    let target = std::env::var_os("CARGO_TARGET_DIR").map_or_else(|| root().join("target"), PathBuf::from);
    let python = target.join("opencamlib/bin/python");
    if !python.exists() {
        println!("OpenCAMLib is not in {}: comparison skipped", target.display());
        return;
    }
    let CutterShape::Conical { radius, corner_radius, .. } = *bodies.options.cutter.shape() else {
        panic!("an end mill")
    };
    let directory = tempfile::tempdir().expect("a directory");
    let file = directory.path().join("flank.stl");
    std::fs::write(&file, mesh(bodies)).expect("a file");
    let mut least = [f64::INFINITY; 2];
    for _ in 0..5 {
        let begin = Instant::now();
        black_box(own());
        least[0] = least[0].min(begin.elapsed().as_secs_f64());
        let peer = Command::new(&python)
            .arg(root().join("crates/flankwright/benches/opencamlib_drop_cutter.py"))
            .arg(&file)
            .args([2.0 * radius, corner_radius, 20.0 * radius].map(|mm| mm.to_string()))
            .arg((ROWS * COLUMNS).to_string())
            .output()
            .expect("Python");
        let seconds = String::from_utf8_lossy(&peer.stdout).trim().parse::<f64>();
        let seconds = seconds.unwrap_or_else(|_| panic!("{}", String::from_utf8_lossy(&peer.stderr)));
        least[1] = least[1].min(seconds);
    }
    let [own, peer] = least.map(|seconds| (ROWS * COLUMNS) as f64 / seconds);
    println!(
        "{own:.0} locations/s, OpenCAMLib's drop cutter {peer:.0}/s, one core each: ratio {:.0}",
        own / peer
    );
}

/// A flank with two triangles for every location, with +y of the workpiece upwards.
fn mesh(bodies: &MillingBodies) -> Vec<u8> {
    let flank = &bodies.parts[0].flanks[0].active;
    let upwards = Rotation3::from_axis_angle(&Vector3::x_axis(), std::f64::consts::FRAC_PI_2);
    let points: Vec<Vector3<f64>> = equidistant(flank.height_span(), ROWS + 1)
        .into_iter()
        .flat_map(|a| equidistant(flank.face, COLUMNS + 1).into_iter().map(move |b| (a, b)))
        .map(|(a, b)| upwards * flank.surface.point(a, b))
        .collect();
    let mesh = patch(&points, COLUMNS + 1, PatchSide::RowsTimesColumns).expect("a mesh");
    stl(&mesh).expect("a file")
}

/// All places of the finish of one flank, and the blocks between them, against opposite flank, neighbouring teeth and lands; contact
/// heights that keep root and opposite flank are the plan's.
fn clear(bodies: &MillingBodies, plan: &MillingPlan) -> usize {
    let side = bodies.options.sides[0];
    let obstacles = bodies.parts[0].obstacles(Some(side), bodies.options.safety);
    let mut places = 0;
    for operation in plan
        .operations
        .iter()
        .filter(|made| matches!(made.kind, OperationKind::Flank(on) if on.flank == side))
    {
        for path in &operation.paths {
            check_path(bodies.options.cutter_of(operation.kind), &path.places, &obstacles).expect("clear");
            places += path.places.len();
        }
    }
    places
}

fn gap(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("clearance of a tooth gap, one core");
    group.sample_size(10);
    for name in ["spur-module-8", "helical-module-6"] {
        let bodies = example(name);
        let made = plan(&bodies.parts[0], &bodies.options).expect("a plan");
        group.throughput(Throughput::Elements(clear(&bodies, &made) as u64));
        group.bench_function(name, |b| b.iter(|| clear(black_box(&bodies), &made)));
    }
    group.finish();
}

fn plans(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("plan");
    group.sample_size(10);
    for name in [
        "automotive-gear",
        "blisk-blade",
        "double-helical",
        "helical-module-6",
        "internal-ring",
        "spiral-bevel-15",
        "spiral-bevel-35",
        "spur-module-8",
        "straight-bevel-16",
        "straight-bevel-24",
    ] {
        let bodies = example(name);
        group.bench_function(name, |b| {
            b.iter(|| plan_all(black_box(&bodies.parts), &bodies.options).expect("a plan"));
        });
    }
    group.finish();
}

criterion_group!(benches, kernel, gap, plans);
criterion_main!(benches);
