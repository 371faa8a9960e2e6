//! What cutters must not touch beside the flanks: root body, hub, backs of blades, the ring of an internal gear. Every place of a plan is
//! looked at by samples of the tool as a body of revolution against bodies that are written down here from the job's numbers.

use foundation::geometry::CutterShape;
use foundation::numerics::Silent;
use job::{Source, parse_job_of};
use milling::job::MilledBody;
use milling::job::{LoadedMillingJob, MillingJob};
use milling::workflow::{MillingBodies, prepare_milling, referee_root, run_milling};
use milling::{CutterPlace, MillingError, MillingPlan, OperationKind, plan_all};
use nalgebra::Vector3;
use run::RunFailure;
use std::f64::consts::TAU;

fn text(example: &str, changes: &[(&str, &str)]) -> String {
    let path = format!("{}/../../examples/milling/{example}.toml", env!("CARGO_MANIFEST_DIR"));
    let mut text = std::fs::read_to_string(path).unwrap();
    for (from, to) in changes {
        assert!(text.contains(from), "{example}: {from}");
        text = text.replacen(from, to, 1);
    }
    text
}

fn loaded(text: &str) -> LoadedMillingJob {
    // Points of flanks are looked for beside the job.
    let name = format!("{}/../../examples/milling/job.toml", env!("CARGO_MANIFEST_DIR"));
    match parse_job_of::<MillingJob>(Source::new(&*name, text)) {
        Ok(loaded) => loaded,
        Err(error) => panic!("{error}\n{text}"),
    }
}

fn planned(text: &str) -> (MillingBodies, Result<MillingPlan, MillingError>) {
    let bodies = prepare_milling(&loaded(text)).unwrap().bodies;
    let plan = plan_all(&bodies.parts, &bodies.options);
    (bodies, plan)
}

/// How deep a point lies in the body that teeth or blades stand on, mm; `None` outside of its ends.
fn depth_in_base(job: &MillingJob, point: &Vector3<f64>) -> Option<f64> {
    let (radius, z) = (point.xy().norm(), point.z);
    match job.body().unwrap() {
        MilledBody::Gear(gear) => {
            let drawing = &gear.drawing;
            let outwards = if drawing.teeth < 0 { -1.0 } else { 1.0 };
            // The root of a conical gear narrows towards +z.
            let (sin, cos) = drawing.cone_angle_deg.to_radians().sin_cos();
            let across = (0.5 * drawing.root_diameter - radius) * cos - z * sin;
            (z.abs() <= 0.5 * drawing.face_width).then_some(outwards * across)
        }
        MilledBody::Bevel(bevel) => {
            let outer = bevel.outer_cone_distance();
            let [root, _] = bevel.cone_angles_deg().map(f64::to_radians);
            // Along the cone and across it.
            let (along, across) =
                (radius * root.sin() + z * root.cos(), z * root.sin() - radius * root.cos());
            (outer - bevel.face_width..=outer).contains(&along).then_some(across)
        }
        MilledBody::Grid(gear) => {
            let [from, to] = gear.root.ends();
            let (radial, axial) = (to[0] - from[0], to[1] - from[1]);
            let length = radial.hypot(axial);
            let along = ((radius - from[0]) * radial + (z - from[1]) * axial) / (length * length);
            let across = ((z - from[1]) * radial - (radius - from[0]) * axial) / length;
            (0.0..=1.0).contains(&along).then_some(axial.signum() * across)
        }
        MilledBody::Blade(blade) => {
            let length = match (&blade.ruled, &blade.naca) {
                (Some(ruled), _) => ruled.length,
                (None, Some(naca)) => naca.chord[0] * naca.stagger_deg[0].to_radians().cos(),
                (None, None) => panic!("{blade:?}"),
            };
            let [from, to] = blade.hub_radius;
            let share = z / length;
            let slant = ((to - from) / length).atan().cos();
            (0.0..=1.0).contains(&share).then_some((from + (to - from) * share - radius) * slant)
        }
    }
}

/// Radius of a tool's cutting part at a height above its tip, mm.
fn radius_at(shape: &CutterShape, z: f64) -> f64 {
    match *shape {
        CutterShape::Conical { radius, half_angle, corner_radius } => {
            assert_eq!(half_angle, 0.0);
            let below = (corner_radius - z).max(0.0);
            radius - corner_radius + (corner_radius * corner_radius - below * below).sqrt()
        }
        CutterShape::Barrel { radius, height, profile_radius } => {
            let off = z - height;
            (radius - profile_radius + (profile_radius * profile_radius - off * off).max(0.0).sqrt()).max(0.0)
        }
    }
}

/// Points on the lowest `length` mm of a tool at a place.
fn samples(shape: &CutterShape, at: &CutterPlace, length: f64) -> Vec<Vector3<f64>> {
    let aside = if at.axis.x.abs() < 0.5 { Vector3::x() } else { Vector3::y() }.cross(&at.axis).normalize();
    let across = at.axis.cross(&aside);
    let ring = |rho: f64, z: f64| {
        (0..24)
            .map(move |k| TAU * f64::from(k) / 24.0)
            .map(move |turn| at.tip + at.axis * z + (aside * turn.cos() + across * turn.sin()) * rho)
    };
    let side = (0..=24).map(|k| length * (f64::from(k) / 24.0).powi(2));
    let mut points: Vec<_> = side.flat_map(|z| ring(radius_at(shape, z), z)).collect();
    let end = radius_at(shape, 0.0);
    points.extend((0..6).flat_map(|k| ring(end * f64::from(k) / 6.0, 0.0)));
    points
}

/// The deepest of all samples of a plan in the base, operation by operation, mm; < 0 clear of it.
fn deepest(job: &MillingJob, bodies: &MillingBodies, plan: &MillingPlan) -> Vec<(OperationKind, f64)> {
    let of_operation = |operation: &milling::Operation| {
        let shape = bodies.options.cutter_of(operation.kind).shape();
        let mut deepest = f64::NEG_INFINITY;
        for path in &operation.paths {
            for at in &path.places {
                let reach = 1.5 * shape.radius() + radius_at(shape, shape.radius());
                for point in samples(shape, at, reach) {
                    deepest = deepest.max(depth_in_base(job, &point).unwrap_or(f64::NEG_INFINITY));
                }
            }
        }
        (operation.kind, deepest)
    };
    plan.operations.iter().map(of_operation).collect()
}

/// Rows keep what the job wants; what comes down to the root body stays on it.
fn check_clear(name: &str, text: &str) -> MillingPlan {
    let (bodies, plan) = planned(text);
    let plan = plan.unwrap_or_else(|error| panic!("{name}: {error}"));
    let job = &loaded(text).job;
    for (kind, deepest) in deepest(job, &bodies, &plan) {
        let row = matches!(kind, OperationKind::Flank(_));
        let most = if row { 1e-3 - job.milling.safety_distance } else { 0.01 };
        println!("{name} {kind}: {deepest:.4}");
        assert!(deepest <= most, "{name}, {kind}: {deepest} mm into the root body");
    }
    plan
}

#[test]
fn examples_stay_clear_of_root_and_hub() {
    let examples = format!("{}/../../examples/milling", env!("CARGO_MANIFEST_DIR"));
    let mut names: Vec<String> = std::fs::read_dir(examples)
        .unwrap()
        .map(|entry| entry.unwrap().path())
        // Beside the jobs lie files of points that they read.
        .filter(|path| path.extension().is_some_and(|extension| extension == "toml"))
        .map(|path| path.file_stem().unwrap().to_str().unwrap().to_owned())
        .collect();
    names.sort();
    assert!(names.len() >= 14);
    for name in names {
        // Few rows: those at root and tip are the same.
        let text = text(&name, &[]);
        let rows: String = text.lines().find(|line| line.starts_with("rows = ")).unwrap().into();
        let text = text.replace(&rows, "rows = 5");
        let plan = check_clear(&name, &text);
        // Heights that an example asks for are those that it gets, unless it spreads wear down to the bottom that it mills.
        let limited = plan.flanks.iter().flat_map(|flank| &flank.rows).filter(|row| row.limited).count();
        assert!(limited == 0 || text.contains("[milling.root]"), "{name}: {limited} rows");
    }
}

/// Without any table of the root.
fn spur_without_root(height: &str) -> String {
    let full = text("spur-module-8", &[("{ from = 5.0, to = 15.0 }", height)]);
    let (head, tail) = full.split_once("[milling.root]").unwrap();
    let (_, tail) = tail.split_once("[simulation]").unwrap();
    let (head, cutters) = head.split_once("[bottom_cutter]").unwrap();
    let (_, milling) = cutters.split_once("[milling]").unwrap();
    format!("{head}[milling]{milling}[simulation]{tail}")
}

#[test]
fn contact_heights_are_limited_by_a_root_that_is_not_milled() {
    let plan = check_clear("spur 15", &spur_without_root("15.0"));
    for flank in &plan.flanks {
        assert!(flank.rows[0].limited && flank.rows[0].contact_height < 7.0);
    }
    // A height that fits stays as it is.
    let plan = check_clear("spur 4", &spur_without_root("4.0"));
    for row in plan.flanks.iter().flat_map(|flank| &flank.rows) {
        assert!(!row.limited && row.contact_height == 4.0);
    }
    // Not even the least height fits where the flank begins on the root.
    let (_, refused) =
        planned(&spur_without_root("15.0").replace("root_diameter = 140.0", "root_diameter = 151.8"));
    match refused {
        Err(MillingError::ToolGap { from: "root body", clearance, wanted, .. }) => {
            assert!(clearance < wanted, "{clearance} {wanted}");
        }
        other => panic!("{other:?}"),
    }
}

#[test]
fn cutters_without_a_straight_side_are_refused_where_they_reach_the_root() {
    let barrel = text(
        "helical-on-bc-table",
        &[
            (
                "shape = \"end-mill\"\ndiameter = 5.0\ncorner_radius = 1.0",
                "shape = \"barrel\"\ndiameter = 5.0\nprofile_radius = 40.0\nlargest_diameter_height = 8.0",
            ),
            ("contact_height = 2.8\n", ""),
        ],
    );
    let hub = text("blade-on-head-head", &[("active_height = [", "active_height = [0.0, 1.0] # [")]);
    for (text, body) in [(barrel, "root body"), (hub, "hub")] {
        match planned(&text).1 {
            Err(error @ MillingError::ToolGap { from, .. }) => {
                assert_eq!(from, body, "{error}");
                assert!(error.way_out().contains("begin the active flank higher"));
            }
            other => panic!("{body}: {:?}", other.map(|plan| plan.flanks.len())),
        }
    }
}

/// The example with the drawn root of a straight piece of 0.8 mm, which ends 4 mm above the root body.
#[test]
fn rows_stay_above_the_root_that_is_drawn() {
    let text = text("spur-module-8", &[("bottom = 0.0", "straight = 0.8"), ("rows = 14", "rows = 6")]);
    let (head, tail) = text.split_once("[milling.roughing]").unwrap();
    let (_, tail) = tail.split_once("[simulation]").unwrap();
    let text = format!("{head}[simulation]{tail}");
    let (bodies, plan) = planned(&text);
    let plan = plan.unwrap();
    assert!(plan.flanks.iter().all(|flank| flank.rows[0].limited));
    let root = referee_root(&bodies, &plan, 5, &Silent).unwrap();
    assert!(root.iter().map(|part| part.points.len()).sum::<usize>() > 200);
    for part in &root {
        assert_eq!((part.gouged(), part.name()), (0, part.name()));
    }
    // The same rows at the heights that were asked for dig in, and the rays tell so.
    let mut deep = plan;
    let cutter = bodies.options.cutter.shape().radius();
    for operation in &mut deep.operations {
        for place in operation.paths.iter_mut().flat_map(|path| &mut path.places) {
            place.tip -= place.axis * cutter;
        }
    }
    let root = referee_root(&bodies, &deep, 5, &Silent).unwrap();
    assert!(root.iter().map(|part| part.gouged()).sum::<usize>() > 100);
}

#[test]
fn backs_of_blades_are_kept_from_or_said_to_be_unknown() {
    let thickness = |with: &str| {
        text("blade-on-head-head", &[("count = 9", "count = 27"), ("thickness = [4.0, 2.0]\n", with)])
    };
    let (bodies, free) = planned(&thickness(""));
    free.unwrap();
    assert_eq!(
        bodies.unknown.iter().map(|remark| remark.code).collect::<Vec<_>>(),
        ["blade-back-not-judged"]
    );
    let (bodies, met) = planned(&thickness("thickness = [3.0, 3.0]\n"));
    assert!(bodies.unknown.is_empty());
    match met {
        Err(MillingError::Collides { collision, .. }) => {
            assert_eq!(collision.name, "back of the neighbouring blade", "{collision:?}");
        }
        other => panic!("{:?}", other.map(|plan| plan.flanks.len())),
    }
}

#[test]
fn clearing_is_refused_with_a_blade() {
    let roughing = "[milling.roughing]\nallowance = 0.3\nstep_down = 3.0\nstep_over = 2.0\n\n[simulation]";
    let text = text("blisk-blade", &[("[simulation]", roughing)]);
    let error = parse_job_of::<MillingJob>(Source::new("job.toml", &text)).unwrap_err();
    let found = error.diagnostics.iter().find(|found| found.field.as_deref() == Some("milling.roughing"));
    assert!(found.is_some_and(|found| found.way_out.is_some()), "{error}");
}

const RING_MACHINE: &str = "\n[machine]\nfile = \"none.toml\"\ntool_length = 100.0\n";

fn ring(tilt: &str, more: &str) -> String {
    text(
        "internal-ring",
        &[("rows = 30", "rows = 4"), ("columns = 11", "columns = 4"), ("tilt_deg = 14.0", tilt)],
    ) + more
}

#[test]
fn spindles_are_kept_from_the_whole_ring() {
    // The nose stands inside the bore, what is behind it goes through the teeth on the other side.
    for length in ["100.0", "250.0"] {
        let (bodies, plan) = planned(&ring("tilt_deg = 14.0", &RING_MACHINE.replace("100.0", length)));
        assert!(bodies.unknown.is_empty());
        assert!(
            matches!(plan, Err(MillingError::RingMet { from: "teeth of the ring" | "end of the ring", .. })),
            "{length}: {plan:?}"
        );
    }
    // Leant out of the ring a spindle has room, unless it is very thick.
    let leant = "tilt_deg = 14.0\nlead_angle_deg = 60.0";
    let thin = RING_MACHINE.to_owned() + "spindle_diameter = 40.0\n";
    let (bodies, plan) = planned(&ring(leant, &thin));
    let plan = plan.unwrap_or_else(|error| panic!("{error}"));
    // The whole spindle, sampled: nothing of it lies in the ring between bore and rim.
    for at in plan.operations.iter().flat_map(|operation| &operation.paths).flat_map(|path| &path.places) {
        let aside = at.axis.cross(&Vector3::z()).normalize();
        let across = at.axis.cross(&aside);
        for (k, z) in (0..24).flat_map(|k| (0..40).map(move |n| (k, 100.0 + 5.0 * f64::from(n)))) {
            let turn = TAU * f64::from(k) / 24.0;
            let point = at.tip + at.axis * z + (aside * turn.cos() + across * turn.sin()) * 20.0;
            let in_ring = point.z.abs() <= 15.0 && (116.0..141.0).contains(&point.xy().norm());
            assert!(!in_ring, "{point}");
        }
    }
    assert!(bodies.unknown.is_empty());
    let wide = RING_MACHINE.to_owned() + "spindle_diameter = 300.0\n";
    assert!(matches!(planned(&ring(leant, &wide)).1, Err(MillingError::RingMet { .. })));
    // Without machine and shank nobody knows what holds the cutter.
    let (bodies, plan) = planned(&ring("tilt_deg = 14.0", ""));
    assert!(plan.is_ok());
    assert_eq!(bodies.unknown.iter().map(|remark| remark.code).collect::<Vec<_>>(), ["holder-not-judged"]);
}

/// Polar angle on the first of two straight bevel gears on axes at 90 degrees, 20 degrees of pressure angle, where the tip of the second
/// one engages: by points of the great circle of action, from the pitch point towards the root.
fn engaged_by_the_tip(teeth: [f64; 2], module: f64) -> f64 {
    let pitch = (teeth[0] / teeth[1]).atan();
    let distance = 0.5 * module * teeth[0].hypot(teeth[1]);
    let tip = TAU / 4.0 - pitch + (module / distance).atan();
    let (own, other) = (Vector3::z(), Vector3::x());
    let point = Vector3::new(pitch.sin(), 0.0, pitch.cos());
    // In the tangent plane of the sphere the line of action leans by the pressure angle against the circle of the pitch cones.
    let towards_axis = Vector3::new(-pitch.cos(), 0.0, pitch.sin());
    let (sin, cos) = 20.0_f64.to_radians().sin_cos();
    let along = Vector3::y() * cos + towards_axis * sin;
    let at = |turn: f64| point * turn.cos() + along * turn.sin();
    let beyond = |turn: f64| at(turn).dot(&other) - tip.cos();
    let (mut low, mut high) = (0.0, 0.3);
    assert!(beyond(low) > 0.0 && beyond(high) < 0.0);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if beyond(middle) > 0.0 { low = middle } else { high = middle }
    }
    at(low).dot(&own).acos()
}

#[test]
fn the_flank_reaches_as_far_as_the_mate_needs_it() {
    let quick = [("rays_profile = 81", "rays_profile = 5"), ("rays_length = 31", "rays_length = 3")];
    let outcome = |changes: &[(&str, &str)]| {
        let all: Vec<_> = quick.into_iter().chain(changes.iter().copied()).collect();
        match run_milling(&loaded(&text("straight-bevel-16", &all)), &Silent) {
            Ok(outcome) => outcome.result,
            Err(RunFailure::BadInput(finding) | RunFailure::NotProducible(finding)) => panic!("{finding:?}"),
        }
    };
    let told = |result: &milling::workflow::MillingResult| {
        result.warnings.iter().any(|remark| remark.code == "mate-needs-more-flank")
    };
    let result = outcome(&[]);
    let start = result.mate.as_ref().unwrap().start_of_flank;
    let needed = start.needed_deg.unwrap().to_radians();
    let found = engaged_by_the_tip([16.0, 24.0], 5.0);
    assert!((needed - found).abs() < 1e-9, "{needed} {found}");
    // By default the flank would begin 12 % of the way up, far above it.
    assert!(needed < 32.0_f64.to_radians());
    assert!(start.covered && !told(&result));
    assert!(start.active_deg.unwrap() <= start.needed_deg.unwrap() + 1e-7);
    let short = outcome(&[("face_width = 20.0", "face_width = 20.0\nstart_polar_angle_deg = 32.2")]);
    assert!(!short.mate.as_ref().unwrap().start_of_flank.covered && told(&short));
}
