//! Programs of five-axis milling from planned spaces: helical, spur and straight bevel gears on machines of `machines/`, with and
//! without tool centre point control, for every control; read back, compared, milled by rays, and interpreted by LinuxCNC.

use crate::peer::client::{ABSENT, Client};
use foundation::geometry::{
    BevelData, BevelGear, Cutter, CutterShape, Flank, Gear, GearData, Helicoid, Sides, SphericalInvolute,
};
use foundation::numerics::Silent;
use job::machine::{LoadedMachine, read_machine};
use job::tables::Program as DialectName;
use machine::Station;
use milling::job::{CutterCoolant, EndMove, MillingMount, Rtcp};
use milling::workflow::prepare::ToolData;
use milling::workflow::programs::{
    AtPole, MillingMachining, MillingPrograms, MillingWork, StepKind, ToolWork,
};
use milling::{
    ActiveFlank, Bottom, CurveOnCone, CutDirection, HeightLimits, HeightRule, HelixOnCylinder, Lines,
    MilledSide, OperationKind, Orientation, PlanOptions, Retraction, RootDepth, RowOrder, Space, SpaceFlank,
    SpacingLaw, Traverse, plan,
};
use nalgebra::Vector3;
use nc::{Dialect, TipControl, read_cl};
use referee as removal;
use referee::{MillPath, Milling, NormalRay, Unmilled, mill};
use run::RunFailure;
use std::f64::consts::TAU;
use std::io::Write as _;
use std::path::Path;
use std::sync::Arc;

const ALL: [DialectName; 3] = [DialectName::Linuxcnc, DialectName::Siemens, DialectName::Fanuc];
/// Half of the fourth decimal that `rs274` prints, mm or degrees.
const PRINTED: f64 = 5.001e-5;
const STOCK: f64 = 5.0;
const DEPTH: f64 = 1.0;

struct Case {
    name: &'static str,
    space: Space,
    options: PlanOptions,
    retraction: Retraction,
    mount: MillingMount,
    /// Rays out of the tops of the teeth, and how far the rapid moves stay away from there, mm.
    tops: Vec<NormalRay>,
    clear: f64,
}

fn cylinder(teeth: i32, module: f64, helix_deg: f64, face: f64, form_radius: f64) -> (Space, f64) {
    let angle = 20f64.to_radians();
    let gear = Gear::new(GearData {
        teeth,
        normal_module: module,
        pressure_angle: Sides { left: angle, right: angle },
        helix_angle: helix_deg.to_radians(),
        profile_shift: 0.0,
        cone_angle: 0.0,
    })
    .unwrap();
    let left = Helicoid::new(&gear, Flank::Left);
    let (tip, root) = (left.tip_radius(1.0), left.root_radius(1.25));
    let flanks = [Flank::Left, Flank::Right].map(|side| {
        let surface = Helicoid::new(&gear, side);
        let heights = [form_radius, tip].map(|radius| surface.length_of_roll(radius).unwrap());
        let heights = HeightLimits::Constant(heights);
        let active =
            ActiveFlank { heights, face: [-face / 2.0, face / 2.0], kink: None, surface: Arc::new(surface) };
        SpaceFlank { side, active }
    });
    let lead = Arc::new(HelixOnCylinder {
        radius: root,
        turn_per_length: left.twist(),
        external_sign: left.external_sign(),
    });
    let pitch = TAU / f64::from(teeth.abs());
    (Space { flanks: flanks.to_vec(), lead, pitch, lands: vec![], other_half: vec![], walls: vec![] }, tip)
}

fn options(shape: CutterShape, [rows, columns]: [usize; 2], height: f64, rough: CutterShape) -> PlanOptions {
    let cutter = |shape| Cutter::new(shape, 30.0, vec![]).unwrap();
    PlanOptions {
        cutter: cutter(shape),
        bottom_cutter: Some(cutter(rough)),
        roughing_cutter: Some(cutter(rough)),
        lines: Lines::Counted { rows, columns },
        spacing: SpacingLaw::Arc,
        orientation: Orientation::default(),
        tilt_at_tip: None,
        heights: HeightRule::Fixed(height),
        overrun: 3.5,
        safety: 0.2,
        traverse: Traverse::Zigzag(CutDirection::Climb),
        order: RowOrder::TipToRoot,
        root: Some((RootDepth::Bottom(0.0), true)),
        bottom: Some(Bottom::Level(0.0)),
        roughing: None,
        leads: [None; 2],
        sides: vec![Flank::Left, Flank::Right],
    }
}

fn tops_of_cylinder(radius: f64, face: f64) -> Vec<NormalRay> {
    let ray = |k: usize| {
        let azimuth = TAU / 4.0 + 0.6 * (k as f64 / 40.0 - 0.5);
        let normal = Vector3::new(azimuth.cos(), azimuth.sin(), 0.0);
        NormalRay { point: normal * radius + Vector3::z() * (face * ((k % 7) as f64 / 6.0 - 0.5)), normal }
    };
    (0..=40).map(ray).collect()
}

fn spur() -> Case {
    let (space, tip) = cylinder(20, 8.0, 0.0, 60.0, 76.0);
    Case {
        name: "spur",
        space,
        options: options(CutterShape::end_mill(3.0, 1.5), [5, 7], 6.16, CutterShape::end_mill(2.0, 1.5)),
        retraction: Retraction::Outside(tip + 2.0),
        mount: MillingMount { height: 40.0, ..MillingMount::default() },
        tops: tops_of_cylinder(tip, 60.0),
        clear: 2.0,
    }
}

fn helical() -> Case {
    let (space, tip) = cylinder(23, 6.0, 25.0, 50.0, 71.5);
    Case {
        name: "helical",
        space,
        options: options(CutterShape::end_mill(2.5, 1.0), [5, 21], 2.91, CutterShape::end_mill(1.5, 1.0)),
        retraction: Retraction::Outside(tip + 2.0),
        mount: MillingMount { height: 60.0, ..MillingMount::default() },
        tops: tops_of_cylinder(tip, 50.0),
        clear: 2.0,
    }
}

fn bevel() -> Case {
    let data = BevelData::new(5.0, 16, 33.690067525979785f64.to_radians(), 20f64.to_radians(), 20.0);
    let gear = BevelGear::new(data).unwrap();
    let flanks = [Flank::Left, Flank::Right].map(|side| {
        let surface = Arc::new(SphericalInvolute::new(&gear, side));
        let heights = HeightLimits::Constant(gear.heights());
        SpaceFlank { side, active: ActiveFlank { heights, face: gear.face(), kink: None, surface } }
    });
    let lead = Arc::new(CurveOnCone { cone_angle: gear.root_angle(), line: gear.line().clone() });
    let (half_angle, distance) = (37.7f64.to_radians(), 2.0);
    let (sin, cos) = half_angle.sin_cos();
    let ray = |k: usize| {
        let azimuth = TAU / 4.0 + 0.9 * (k as f64 / 40.0 - 0.5);
        let along = 52.0 + 20.0 * (k % 7) as f64 / 6.0;
        let around = Vector3::new(azimuth.cos(), azimuth.sin(), 0.0);
        NormalRay {
            point: around * (along * sin) + Vector3::z() * (along * cos),
            normal: around * cos - Vector3::z() * sin,
        }
    };
    Case {
        name: "straight bevel",
        space: Space {
            flanks: flanks.to_vec(),
            lead,
            pitch: TAU / 16.0,
            lands: vec![],
            other_half: vec![],
            walls: vec![],
        },
        options: options(CutterShape::end_mill(1.2, 0.5), [5, 7], 3.0, CutterShape::end_mill(0.6, 0.5)),
        retraction: Retraction::OutsideCone { half_angle, distance, apex: 0.0 },
        mount: MillingMount { turned_over: true, height: 90.0, ..MillingMount::default() },
        tops: (0..=40).map(ray).collect(),
        clear: distance,
    }
}

fn machine(name: &str) -> LoadedMachine {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("../../machines/{name}.toml"));
    read_machine(&path).unwrap_or_else(|error| panic!("{name}: {error}"))
}

impl Case {
    fn work(&self, spaces: usize) -> MillingWork<'_> {
        let planned = plan(&self.space, &self.options).unwrap();
        let tool = |operation: milling::Operation| ToolWork {
            kind: operation.kind,
            cutter: self.options.cutter_of(operation.kind).clone(),
            tool: tool_data(if operation.kind == OperationKind::Bottom { 2 } else { 1 }),
            paths: operation.paths,
        };
        MillingWork {
            name: self.name,
            tools: planned.operations.into_iter().map(tool).collect(),
            spaces,
            pitch: self.space.pitch,
            retraction: self.retraction,
        }
    }

    /// Rays on both flanks, all over the face.
    fn rays(&self) -> Vec<NormalRay> {
        let mut rays = Vec::new();
        for flank in &self.space.flanks {
            let [low, high] = flank.active.height_span();
            let [from, to] = flank.active.face;
            for k in 0..60 {
                let share = |part: usize, parts: usize| (part as f64 + 0.5) / parts as f64;
                let height = low + (high - low) * share(k / 6, 10);
                let jet = flank.active.surface.jet(height, from + (to - from) * share(k % 6, 6));
                rays.push(NormalRay { point: jet.point, normal: jet.normal });
            }
        }
        rays
    }
}

/// The planned paths alone, without any motion of a machine.
fn planned_lengths(work: &MillingWork<'_>, rays: &[NormalRay]) -> Vec<Option<f64>> {
    let cutters: Vec<Cutter> = work.tools.iter().map(|tool| tool.cutter.clone()).collect();
    let place = |at: &milling::CutterPlace| removal::CutterPlace { tip: at.tip, axis: at.axis };
    let paths = work.tools.iter().enumerate().flat_map(|(cutter, tool)| {
        tool.paths
            .iter()
            .map(move |path| MillPath { cutter, places: path.places.iter().map(place).collect() })
    });
    let paths: Vec<MillPath> = paths.collect();
    let setup = Milling { cutters: &cutters, paths: &paths, stock: STOCK, depth: DEPTH };
    let milled = mill(&setup, rays, &Silent).unwrap();
    milled.rays.iter().map(|ray| ray.ok().map(|ray| ray.length)).collect()
}

/// A tool of 100 mm.
fn tool_data(number: u32) -> ToolData {
    ToolData {
        number,
        length_offset: None,
        edges: None,
        length: 100.0,
        spindle_rpm: 8000.0,
        feed: 1200.0,
        plunge_feed: 400.0,
        coolant: CutterCoolant::Off,
    }
}

fn machining<'a>(machine: &'a LoadedMachine, case: &Case, rtcp: Rtcp) -> MillingMachining<'a> {
    mounted(machine, case.mount, rtcp, AtPole::default())
}

fn mounted(
    machine: &LoadedMachine,
    mount: MillingMount,
    rtcp: Rtcp,
    at_pole: AtPole,
) -> MillingMachining<'_> {
    MillingMachining {
        machine,
        mount,
        held_clocking: None,
        work_offset: None,
        holds_lengths: false,
        spindle_dwell: 0.0,
        end_position: &[],
        rtcp,
        tip_control: TipControl::Directions,
        position_tolerance: 0.5e-3,
        at_pole,
        dialects: &ALL,
    }
}

/// What holds of every program: travels, times, rapid moves, rays.
fn check(machine: &LoadedMachine, case: &Case, work: &MillingWork<'_>, made: &MillingPrograms) {
    assert_eq!(made.programs.len(), 3);
    let cutters: Vec<Cutter> = work.tools.iter().map(|tool| tool.cutter.clone()).collect();
    for program in &made.programs {
        let axes = machine.machine.axes_at(Station::Work).unwrap();
        let motion = &program.motion;
        let steps = || motion.tools.iter().flat_map(|run| &run.steps);
        for step in steps() {
            assert!(axes.iter().all(|&axis| machine.machine.axes()[axis].admits(step.at[axis])));
            assert!(step.seconds > 0.0 || step.kind == StepKind::Position);
        }
        let sum: f64 = steps().map(|step| step.seconds).sum();
        let operations: f64 = motion.operations.iter().map(|operation| operation.seconds()).sum();
        assert!(motion.cycle_time > 0.0 && (motion.cycle_time - sum).abs() < 1e-9 * sum);
        assert!((motion.cycle_time - operations).abs() < 1e-9 * sum);
        assert!(
            motion.operations.iter().all(|operation| operation.cutting > 0.0 && !operation.rows.is_empty())
        );
        let time = program.first_space();
        assert!(time.windows(2).all(|pair| pair[0].0 <= pair[1].0));
        assert!(program.read_difference[0] <= program.rounding.distance + 1e-9);

        let paths = program.first_space_rapid_paths();
        let rapid = Milling { cutters: &cutters, paths: &paths, stock: case.clear - 0.01, depth: DEPTH };
        for rays in [&case.tops, &case.rays()] {
            let met = mill(&rapid, rays, &Silent).unwrap();
            assert!(met.rays.iter().all(|ray| ray.err() == Some(Unmilled::NotReached)), "{}", case.name);
        }
    }
    let rays = case.rays();
    let planned = planned_lengths(work, &rays);
    assert!(planned.iter().filter(|length| length.is_some()).count() > rays.len() / 2);
    let proofs = made
        .prove(work, &rays, &planned, [STOCK, DEPTH], &Silent)
        .unwrap_or_else(|failure| panic!("{failure:?}"));
    for proof in &proofs {
        println!(
            "    {}: rays within {:.4} um of {:.4}",
            proof.dialect.name(),
            proof.difference_um,
            proof.allowed_um
        );
        assert!(proof.difference_um <= proof.allowed_um);
    }
    // The proof is no formality: a ray planned differently by a little more than is allowed is found.
    let mut shifted = planned.clone();
    let place = shifted.iter().position(Option::is_some).unwrap();
    shifted[place] = shifted[place].map(|length| length + 3e-3 * proofs[0].allowed_um.max(1.0));
    let refused = made.prove(work, &rays, &shifted, [STOCK, DEPTH], &Silent);
    let Err(RunFailure::NotProducible(finding)) = refused else { panic!("a shifted ray is proven") };
    assert_eq!(finding.code, "program-not-proven");
}

fn run(machine_name: &str, case: &Case, spaces: usize) {
    let machine = machine(machine_name);
    let work = case.work(spaces);
    for rtcp in [Rtcp::On, Rtcp::Off, Rtcp::Rows] {
        let begun = std::time::Instant::now();
        let made = machining(&machine, case, rtcp)
            .build(&work)
            .unwrap_or_else(|failure| panic!("{} on {machine_name}, {rtcp:?}: {failure:?}", case.name));
        let taken = begun.elapsed().as_secs_f64();
        let blocks: usize = made.programs.iter().map(|program| program.blocks).sum();
        println!("{} on {machine_name}, rtcp {rtcp:?}: {:.0} blocks/s", case.name, blocks as f64 / taken);
        for program in &made.programs {
            let motion = &program.motion;
            println!(
                "  {}: {} blocks, {:.1} s of which {:.1} s rapid, straight {:.3} um, rounding {:.3} um",
                program.file,
                program.blocks,
                motion.cycle_time,
                motion.operations.iter().map(|operation| operation.rapid).sum::<f64>(),
                motion.straight.tip * 1e3,
                program.rounding.distance * 1e3
            );
        }
        check(&machine, case, &work, &made);
    }
}

#[test]
fn spur_gears_on_three_machines() {
    run("five-axis-ac-table", &spur(), 20);
    run("five-axis-head-table", &spur(), 2);
}

#[test]
fn helical_gears_on_tables() {
    run("five-axis-ac-table", &helical(), 3);
    run("five-axis-head-table", &helical(), 1);
}

#[test]
fn straight_bevels_turned_over() {
    run("five-axis-ac-table", &bevel(), 2);
    run("five-axis-head-table", &bevel(), 1);
    run("five-axis-nutating-table", &bevel(), 2);
}

#[test]
fn a_screw_row_is_one_block_without_tip_control() {
    let case = spur();
    let work = case.work(1);
    let machine = machine("five-axis-ac-table");
    let rows = machining(&machine, &case, Rtcp::Rows).build(&work).unwrap();
    for program in &rows.programs {
        let cuts =
            program.motion.tools.iter().flat_map(|run| &run.steps).filter(|step| step.kind == StepKind::Cut);
        let paths: usize = work.tools.iter().map(|tool| tool.paths.len()).sum();
        assert_eq!(cuts.count(), paths, "{}", program.file);
        assert!(!program.written.text.contains("TRAORI") && !program.written.text.contains("G43.5"));
    }
    let on = machining(&machine, &case, Rtcp::On).build(&work).unwrap();
    let text = |dialect| &on.programs.iter().find(|program| program.dialect == dialect).unwrap().written.text;
    assert!(text(Dialect::Siemens).contains("TRAORI") && text(Dialect::Fanuc).contains("G43.5"));
    let angles = MillingMachining { tip_control: TipControl::Angles, ..machining(&machine, &case, Rtcp::On) };
    let made = angles.build(&work).unwrap();
    let fanuc = made.programs.iter().find(|program| program.dialect == Dialect::Fanuc).unwrap();
    assert!(fanuc.written.text.contains("G43.4"));
}

#[test]
fn programs_end_where_the_job_wants_the_axes() {
    let case = spur();
    let work = case.work(2);
    let ac = machine("five-axis-ac-table");
    let to = |axis: &str, position| EndMove { axis: axis.into(), position };
    let end = [to("Z", 390.0), to("A", -5.0), to("C", 90.0)];
    for rtcp in [Rtcp::On, Rtcp::Off, Rtcp::Rows] {
        let plain = machining(&ac, &case, rtcp).build(&work).unwrap();
        let made =
            MillingMachining { end_position: &end, ..machining(&ac, &case, rtcp) }.build(&work).unwrap();
        for (program, plain) in made.programs.iter().zip(&plain.programs) {
            // What the text says, read back: one axis after the other, all before them as without an end position.
            let moves: Vec<_> = program.moves().iter().map(|made| made.at).collect();
            let (before, after) = moves.split_at(moves.len() - end.len());
            let mut last =
                before.last().unwrap().unwrap_or(plain.motion.tools.last().unwrap().steps.last().unwrap().at);
            for (wanted, at) in end.iter().zip(after) {
                let at = at.unwrap();
                let axis = ac.machine.axis_named(&wanted.axis).unwrap();
                let shown = ac.machine.axes()[axis].joint.shown(at[axis]);
                let turns = (shown - wanted.position) / 360.0;
                let turn = if wanted.axis == "C" { turns.round() } else { 0.0 };
                assert!((shown - wanted.position - 360.0 * turn).abs() < 1e-4, "{}: {shown}", wanted.axis);
                assert!(wanted.axis != "C" || (at[axis] - last[axis]).abs() <= 0.5 * TAU + 1e-9);
                for other in (0..ac.machine.axes().len()).filter(|other| *other != axis) {
                    assert!((at[other] - last[other]).abs() < 1e-4, "{} moves beside {}", other, wanted.axis);
                }
                last = at;
            }
            assert!(program.motion.cycle_time > plain.motion.cycle_time + 0.1);
            assert_eq!(program.first_space().len(), plain.first_space().len());
            assert_eq!(program.rounding, plain.rounding);
        }
    }
    let refused = |moves: &[EndMove]| {
        let made = MillingMachining { end_position: moves, ..machining(&ac, &case, Rtcp::On) }.build(&work);
        let Err(RunFailure::BadInput(finding)) = made else { panic!("{moves:?} is taken") };
        assert!(finding.value.is_some() && finding.allowed.is_some() && finding.way_out.is_some());
        (finding.code, finding.field.unwrap(), finding.allowed.unwrap())
    };
    let (code, field, allowed) = refused(&[to("Z", 0.0), to("W", 0.0)]);
    assert_eq!((code, &*field), ("unknown-value", "machine.end_position[1].axis"));
    assert!(allowed.contains('Z') && allowed.contains('C'), "{allowed}");
    let (code, field, allowed) = refused(&[to("A", 31.0)]);
    assert_eq!((code, &*field), ("axis-limit", "machine.end_position[0].position"));
    assert_eq!(&*allowed, "-120 to 30 deg");
}

/// The table of a machine can only turn so far: the cutter goes out where it ends, and comes back after the table has turned back.
#[test]
fn a_table_with_an_end_is_turned_back_outside() {
    let case = spur();
    let mut work = case.work(20);
    work.tools.truncate(1);
    work.tools[0].paths.truncate(1);
    let mut limited = machine("five-axis-ac-table");
    let axis = limited.file.axes.get_mut("C").unwrap();
    (axis.endless, axis.min_deg, axis.max_deg) = (false, Some(-100.0), Some(290.0));
    limited.machine = limited.file.machine().unwrap();
    for rtcp in [Rtcp::On, Rtcp::Off] {
        let made =
            machining(&limited, &case, rtcp).build(&work).unwrap_or_else(|failure| panic!("{failure:?}"));
        for program in &made.programs {
            assert_eq!(program.motion.operations[0].rewinds, 1, "{}", program.file);
            let unwinds = program.motion.tools[0].steps.iter().filter(|step| step.kind == StepKind::Unwind);
            assert!(unwinds.count() >= 2);
        }
    }
}

/// A path of a ball on a nearly flat workpiece: its axis passes the pole of a table A-C, clamped upside down, at 0.02 of the height,
/// as the path of `docs/mathematics/milling.md#positions-of-five-axes` does.
fn near_the_pole(shape: CutterShape) -> MillingWork<'static> {
    let cutter = Cutter::new(shape, 30.0, vec![]).unwrap();
    let radius = if let CutterShape::Conical { radius, .. } = shape { radius } else { 0.0 };
    let place = |k: u32| {
        let along = f64::from(k) / 12.0 - 0.5;
        let axis = Vector3::new(0.02, 0.6 * along, -1.0).normalize();
        let contact = Vector3::new(0.0, 60.0 + 20.0 * along, 1.0);
        // The centre of the ball stands above the contact, whichever way the axis points.
        let centre = contact - Vector3::z() * radius;
        milling::CutterPlace { tip: centre - axis * radius, axis, contact: Some(contact) }
    };
    MillingWork {
        name: "pole",
        tools: vec![ToolWork {
            kind: OperationKind::Flank(MilledSide { flank: Flank::Left, half: None }),
            cutter,
            tool: tool_data(1),
            paths: vec![milling::CutterPath { places: (0..=12).map(place).collect() }],
        }],
        spaces: 2,
        pitch: TAU / 40.0,
        retraction: Retraction::OutsideCone { half_angle: 80f64.to_radians(), distance: 15.0, apex: 0.0 },
    }
}

/// Rays below the path, up to its sides.
fn rays_near_the_pole() -> Vec<NormalRay> {
    let ray = |k: usize| NormalRay {
        point: Vector3::new(0.1 * (k % 5) as f64 - 0.2, 51.0 + 18.0 * (k as f64) / 40.0, 1.0),
        normal: -Vector3::z(),
    };
    (0..=40).map(ray).collect()
}

#[test]
fn each_way_past_the_pole_has_its_effect() {
    let work = near_the_pole(CutterShape::ball(3.0));
    let machine = machine("five-axis-ac-table");
    let mount = MillingMount { turned_over: true, height: 40.0, ..MillingMount::default() };
    let built = |at_pole: AtPole, rtcp: Rtcp| {
        let machining = mounted(&machine, mount, rtcp, at_pole);
        machining.build(&work).unwrap_or_else(|failure| panic!("{at_pole:?}: {failure:?}"))
    };
    let rays = rays_near_the_pole();
    let planned = planned_lengths(&work, &rays);
    assert!(planned.iter().all(Option::is_some));
    let cap = 6f64.to_radians();
    for rtcp in [Rtcp::On, Rtcp::Off] {
        let [slow, hold, mount] =
            [AtPole::Slow { cap }, AtPole::Hold { cap }, AtPole::Mount { cap }].map(|way| built(way, rtcp));
        for made in [&slow, &hold, &mount] {
            let proven = made.prove(&work, &rays, &planned, [STOCK, DEPTH], &Silent);
            let proofs = proven.unwrap_or_else(|failure| panic!("{failure:?}"));
            println!(
                "{rtcp:?}: {:?}",
                proofs.iter().map(|p| [p.difference_um, p.allowed_um]).collect::<Vec<_>>()
            );
        }
        let figures = |made: &MillingPrograms| made.programs[1].motion.operations[0].clone();
        let turn = |made: &MillingPrograms| figures(made).rows[0].smoothness.rotary[0].travel.to_degrees();
        println!("{rtcp:?}: C turns {} {} {} deg", turn(&slow), turn(&hold), turn(&mount));
        // The geometry stays, C swings around, and the whole part has the feed of its slowest block.
        assert!((turn(&slow) - 172.4).abs() < 0.1);
        let (_, section) = &figures(&slow).passages[0];
        assert!(section.feed < 600.0 && section.limit.name() != "feed", "{section:?}");
        // C stands still near the pole; the axis is off by the cap at most.
        let (places, off) = figures(&hold).held;
        assert!(places >= 2 && off > 0.0 && off <= cap + 1e-12, "{places} {off}");
        assert!(turn(&hold) < turn(&slow));
        assert!(figures(&hold).cutting < figures(&slow).cutting);
        // Nothing comes near the pole, and the workpiece is tilted by less than the cap and what the path misses the pole by.
        let tilt = mount.tilt.expect("a tilt");
        assert!(figures(&mount).passages.is_empty());
        assert!(tilt.angle < 2.0 * cap && tilt.least >= cap - 1e-9, "{tilt:?}");
        assert!(mount.programs.iter().all(|program| program.written.text.contains("WORKPIECE TILTED")));
        assert!(slow.tilt.is_none() && hold.tilt.is_none());
    }
    // An end mill would cut otherwise while its axis is held.
    let sharp = near_the_pole(CutterShape::end_mill(3.0, 1.0));
    let machining = mounted(&machine, mount, Rtcp::On, AtPole::Hold { cap });
    let Err(RunFailure::BadInput(finding)) = machining.build(&sharp) else { panic!("an end mill is held") };
    assert_eq!((finding.code, finding.field.as_deref()), ("hold-needs-ball", Some("machine.pole")));
}

#[test]
fn what_a_machine_cannot_do_names_a_key_of_the_job() {
    let case = spur();
    let work = case.work(1);
    let ac = machine("five-axis-ac-table");
    let finding = |machining: &MillingMachining<'_>, work: &MillingWork<'_>| match machining.build(work) {
        Err(RunFailure::BadInput(finding) | RunFailure::NotProducible(finding)) => *finding,
        Ok(_) => panic!("it is built"),
    };
    let field = |finding: &job::Diagnostic| finding.field.as_deref().unwrap_or("").to_owned();

    let high = MillingMachining {
        mount: MillingMount { height: 900.0, ..case.mount },
        ..machining(&ac, &case, Rtcp::Off)
    };
    let found = finding(&high, &work);
    assert_eq!((found.code, field(&found).as_str()), ("axis-limit", "machine.mount"));

    let none = MillingMachining { position_tolerance: 0.0, ..machining(&ac, &case, Rtcp::Off) };
    assert_eq!(field(&finding(&none, &work)), "machine.position_tolerance_um");

    let mut silent = ac.clone();
    silent.file.controls.fanuc = None;
    let found = finding(&machining(&silent, &case, Rtcp::On), &work);
    assert_eq!(field(&found), "output.programs");

    let mut still = work.clone();
    still.tools[0].tool.feed = 0.0;
    assert_eq!(field(&finding(&machining(&ac, &case, Rtcp::On), &still)), "milling.feed_mm_per_min");

    // No way along the axis leads out of a cylinder without end.
    let mut closed = work.clone();
    closed.retraction = Retraction::Outside(f64::INFINITY);
    assert_eq!(field(&finding(&machining(&ac, &case, Rtcp::On), &closed)), "milling");

    let mut wrong = ac.clone();
    wrong.file.axes.get_mut("C").unwrap().letter = None;
    let found = finding(&machining(&wrong, &case, Rtcp::On), &work);
    assert_eq!((found.code, field(&found).as_str()), ("axis-not-available", "machine.file"));
}

#[test]
fn cutter_locations_need_no_machine() {
    for case in [spur(), helical(), bevel()] {
        let work = case.work(2);
        let text = work.cutter_locations().unwrap_or_else(|failure| panic!("{failure:?}"));
        let found = read_cl(text.text.as_bytes()).unwrap();
        let locations = found.blocks.iter().filter(|block| matches!(block, nc::Block::Tip(_)));
        assert_eq!(locations.count(), text.locations);
        let places: usize =
            work.tools.iter().flat_map(|tool| &tool.paths).map(|path| path.places.len()).sum();
        assert!(text.locations > 2 * places);
    }
}

#[test]
fn linuxcnc_takes_the_programs() {
    let Some(client) = Client::find() else {
        let what = "programs of milling jobs skipped; scripts/linuxcnc-client gets it";
        return drop(writeln!(std::io::stderr(), "{ABSENT}: {what}"));
    };
    let directory = tempfile::tempdir().unwrap();
    let ac = machine("five-axis-ac-table");
    for case in [spur(), helical(), bevel()] {
        let work = case.work(2);
        let made = machining(&ac, &case, Rtcp::Off).build(&work).unwrap();
        let program = made.programs.iter().find(|program| program.dialect == Dialect::LinuxCnc).unwrap();
        let path = directory.path().join("program.ngc");
        std::fs::write(&path, &program.written.text).unwrap();
        let output = client.interpret_with_tools(&path, directory.path(), "T1 P1 Z0\nT2 P2 Z0\n");
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        let canonical = String::from_utf8_lossy(&output.stdout);
        let last = |name: &str| {
            let line = canonical.lines().rev().find(|line| line.contains(name)).unwrap();
            let (_, arguments) = line.trim_end().trim_end_matches(')').split_once('(').unwrap();
            arguments.split(',').map(|number| number.trim().parse().unwrap()).collect::<Vec<f64>>()
        };
        let feeds = canonical.lines().filter(|line| line.contains("STRAIGHT_FEED(")).count();
        let straight = |block: &&nc::Block| matches!(block, nc::Block::Linear { .. });
        assert_eq!(feeds, program.read.iter().filter(straight).count(), "{}", case.name);
        // The last motion is a retraction: where the control ends is where the plan does.
        let step = program.motion.tools.last().unwrap().steps.last().unwrap();
        assert_eq!(step.kind, StepKind::Retract);
        let found = last("STRAIGHT_FEED");
        for (letter, axis) in ["X", "Y", "Z", "A", "", "C"].iter().zip(0..) {
            let Some(number) = ac.machine.axis_named(letter) else { continue };
            let described = &ac.machine.axes()[number];
            let wanted = described.nc_sign * described.joint.shown(step.at[number]);
            assert!((found[axis] - wanted).abs() < PRINTED + 1e-4, "{letter}: {} {wanted}", found[axis]);
        }
    }
}
