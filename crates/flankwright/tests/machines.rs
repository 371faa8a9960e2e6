//! Machines as described in `machines/`: forward and inverse kinematics of each, its limits and its errors. The numbers of the
//! reference file are checked by `verify`.

use flankwright::exchange::Source;
use flankwright::exchange::machine::{AxisEntry, LoadedMachine, parse_machine, read_machine};
use flankwright::kinematics::{Direction, DressingPosition, GeneratingChain, GeneratingState, Point, Pose};
use flankwright::machine::{
    AxisSolutions, DressingRule, Follower, Joint, Machine, MachineError, Mount, Mounts, Positions, Role,
    Station, StationSpindle, ToolAxis, ToolSpindle,
};
use proptest::prelude::*;
use std::path::{Path, PathBuf};

fn directory() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../machines")
}

fn shipped() -> Vec<LoadedMachine> {
    let mut files: Vec<PathBuf> = std::fs::read_dir(directory())
        .expect("machines/")
        .map(|entry| entry.expect("an entry").path())
        .filter(|path| path.extension().is_some_and(|e| e == "toml"))
        .collect();
    files.sort();
    files
        .iter()
        .map(|path| read_machine(path).unwrap_or_else(|e| panic!("{}: {e}", path.display())))
        .collect()
}

fn machine(name: &str) -> Machine {
    read_machine(&directory().join(format!("{name}.toml"))).expect("a shipped machine").machine
}

/// How far two poses are apart: rotation, mm.
fn apart(a: &Pose<ToolSpindle, StationSpindle>, b: &Pose<ToolSpindle, StationSpindle>) -> [f64; 2] {
    [(a.rotation() - b.rotation()).amax(), (a.translation() - b.translation()).amax()]
}

fn exact(machine: &Machine, station: Station, at: &Positions, pose: &Pose<ToolSpindle, StationSpindle>) {
    let [rotation, length] = apart(&machine.pose(station, at).expect("finite"), pose);
    assert!(rotation < 1e-12 && length < 1e-11, "{}: {rotation:.1e}, {length:.1e} mm", machine.name());
}

fn mounts(seed: [f64; 4], reversed: [bool; 2]) -> Mounts {
    Mounts {
        tool: Mount { reversed: reversed[0], axial: seed[0], angle: seed[1] },
        counterpart: Mount { reversed: reversed[1], axial: seed[2], angle: seed[3] },
    }
}

#[test]
fn every_shipped_machine_is_one() {
    let machines = shipped();
    let names: Vec<&str> = machines.iter().map(|m| m.machine.name()).collect();
    for name in ["eight_axis", "no_swivel", "tangential_slide", "xyzabc"] {
        assert!(names.contains(&name), "{names:?}");
    }
    assert_eq!(names.iter().filter(|name| name.starts_with("five_axis")).count(), 5, "{names:?}");
    for loaded in &machines {
        let json = serde_json::to_string(&loaded.file).expect("JSON");
        let again = parse_machine(Source::new("machine.json", &json)).expect("the same machine as JSON");
        assert_eq!(again.machine, loaded.machine);
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]

    /// Acceptance of the machines: FK(IK) <= 1e-11 mm on random poses, both jobs, every branch and rule, conical bodies included.
    #[test]
    fn inverse_and_forward_agree(
        angles in prop::array::uniform2(-7.0..7.0f64),
        lengths in prop::array::uniform3(-60.0..60.0f64),
        crossing in 5.0..175.0f64,
        distance in 60.0..300.0f64,
        cones in prop::array::uniform2(-0.2..0.2f64),
        clamped in prop::array::uniform4(-3.0..3.0f64),
        reversed in prop::array::uniform2(any::<bool>()),
        tilt in 0.2..12.0f64,
        share in -0.99..0.99f64,
    ) {
        let chain = GeneratingChain {
            centre_distance: distance,
            crossed_axes_angle: crossing.to_radians(),
            worm_cone: cones[0],
            work_cone: cones[1],
            worm_pivot: 80.0 * cones[0].abs(),
            work_pivot: 40.0 * cones[1].abs(),
        };
        let state = GeneratingState {
            worm_angle: angles[0], work_angle: angles[1], shift: lengths[0], feed: lengths[1], delta_d: 0.0, delta_gamma: 0.0,
        };
        let mounts = mounts(clamped, reversed);
        let grinding = mounts.spindles(&chain.pose(&state));
        let at = DressingPosition {
            worm_angle: angles[0],
            worm_shift: lengths[0],
            crossing_angle: tilt.to_radians() * angles[1].signum(),
            centre_distance: distance,
            offset: lengths[2] * 0.2,
        };
        let dressing = mounts.spindles(&at.pose());
        for machine in ["eight-axis", "no-swivel", "tangential-slide", "xyzabc"].map(machine) {
            let found = machine.grinding(&grinding).expect("a pose within reach");
            prop_assert_eq!(found.len(), 2);
            found.iter().for_each(|at| exact(&machine, Station::Work, at, &grinding));
            let mut rules = vec![DressingRule::Swivel(0.0)];
            if machine.role(Role::Swivel).is_some() {
                rules.push(DressingRule::Swivel(share * tilt.to_radians()));
                rules.push(DressingRule::WormAngle(angles[1]));
                rules.push(DressingRule::AxialSlide(0.0));
            }
            for rule in rules {
                let found = machine.dressing(&dressing, rule, None).expect("a pose within reach");
                let expected = if matches!(rule, DressingRule::WormAngle(_)) { 1 } else { 2 };
                prop_assert_eq!(found.len(), expected, "{:?}", rule);
                for at in &found {
                    exact(&machine, Station::Dresser, at, &dressing);
                    let slide = at[machine.role(Role::Axial).expect("an axial slide")];
                    let kept = match rule {
                        DressingRule::AxialSlide(wanted) => (slide - wanted).abs() < 1e-9,
                        DressingRule::Swivel(c) => machine.role(Role::Swivel).is_none_or(|k| at[k] == c),
                        DressingRule::WormAngle(_) => true,
                    };
                    prop_assert!(kept, "{rule:?}: {at:?}");
                }
            }
        }
    }

    /// The same for the machines of five axes: the tool's point and direction come back, both solutions.
    #[test]
    fn a_tool_axis_is_reached_by_every_five_axis_machine(
        tip in prop::array::uniform3(-120.0..120.0f64),
        tilt in 1.0..60.0f64,
        around in -180.0..180.0f64,
        length in 20.0..200.0f64,
    ) {
        let (sin, cos) = tilt.to_radians().sin_cos();
        let (s, c) = around.to_radians().sin_cos();
        let wanted = ToolAxis {
            tip: Point::new(tip[0], tip[1], tip[2]),
            axis: Direction::from_vector([sin * c, sin * s, cos].into()),
            reach: Point::new(0.0, 0.0, -length),
        };
        for name in ["ac-table", "bc-table", "head-table", "head-head", "nutating-table"] {
            let machine = machine(&format!("five-axis-{name}"));
            let AxisSolutions::Positions(found) = machine.tool_axis(Station::Work, &wanted, None).expect("in reach") else {
                panic!("no pole here");
            };
            prop_assert_eq!(found.len(), 2, "{}", name);
            for at in &found {
                let part_of_tool = machine.pose(Station::Work, at).expect("finite").inverse();
                let tip = part_of_tool.point(&wanted.reach).xyz - wanted.tip.xyz;
                let axis = part_of_tool.rotation() * nalgebra::Vector3::z() - wanted.axis.xyz;
                prop_assert!(tip.amax() < 1e-11 && axis.amax() < 1e-13, "{name}: {:.1e} {:.1e}", tip.amax(), axis.amax());
            }
        }
    }
}

/// Directions off by a milliradian and spindles off their axes change neither the number of solutions nor their exactness.
#[test]
fn measured_machines_are_solved_exactly() {
    let loaded = read_machine(&directory().join("eight-axis.toml")).expect("a shipped machine");
    let mut file = loaded.file.clone();
    for (k, axis) in file.axes.values_mut().enumerate() {
        let off =
            [1e-3 * (k as f64 + 0.3).sin(), 8e-4 * (2.0 * k as f64).cos(), 5e-4 * (3.0 * k as f64).sin()];
        let d: Vec<f64> = axis.direction.iter().zip(off).map(|(x, o)| x + o).collect();
        let norm = d.iter().map(|x| x * x).sum::<f64>().sqrt();
        axis.direction = [d[0] / norm, d[1] / norm, d[2] / norm];
        if axis.endless {
            axis.point_mm = Some([3.0 * k as f64, -2.0, 40.0]);
        }
    }
    file.chains.tool.frame.origin_mm = Some([0.5, -1.0, 41.0]);
    let measured = file.machine().expect("a machine");
    let nominal = loaded.machine;
    let at = DressingPosition {
        worm_angle: 40.0,
        worm_shift: -11.0,
        crossing_angle: 0.05,
        centre_distance: 150.0,
        offset: 1.5,
    };
    let pose = Mounts::default().spindles(&at.pose());
    for rule in [DressingRule::Swivel(0.01), DressingRule::WormAngle(0.4), DressingRule::AxialSlide(2.0)] {
        let found = measured.dressing(&pose, rule, None).expect("in reach");
        assert_eq!(found.len(), nominal.dressing(&pose, rule, None).expect("in reach").len());
        found.iter().for_each(|at| exact(&measured, Station::Dresser, at, &pose));
    }
}

/// A chain of four rotary and two linear axes has no closed form: the iteration finds the positions it is asked for.
#[test]
fn chains_without_closed_form_are_iterated() {
    let mut file = read_machine(&directory().join("no-swivel.toml")).expect("a shipped machine").file;
    let swing = AxisEntry {
        point_mm: Some([0.0, -300.0, 40.0]),
        direction: [1.0, 0.0, 0.0],
        ..file.axes["A1"].clone()
    };
    file.axes.insert("Z1".into(), swing);
    file.roles.axial = None;
    let machine = file.machine().expect("a machine");
    let mut wanted = Positions::default();
    for (k, value) in [-140.0, 0.1, 0.3, 20.0, 1.0, -2.0].into_iter().enumerate() {
        wanted[k] = value;
    }
    let pose = machine.pose(Station::Work, &wanted).expect("finite");
    let found = machine.grinding(&pose).expect("positions");
    found.iter().for_each(|at| exact(&machine, Station::Work, at, &pose));
    let near = |at: &&Positions| (0..6).all(|k| (at[k] - wanted[k]).abs() < 1e-8);
    assert!(found.iter().any(|at| near(&at)), "{found:?}");
    // One axis less does not determine a pose.
    file.chains.tool.axes.retain(|name| name != "Z1");
    file.axes.remove("Z1");
    let error = file.machine().expect("a machine").grinding(&pose).expect_err("five axes");
    assert_eq!(error.code(), "axes-not-determined");
}

#[test]
fn a_limit_names_the_axis_the_excess_and_a_way_out() {
    let machine = machine("eight-axis");
    let chain = GeneratingChain {
        centre_distance: 500.0,
        crossed_axes_angle: 60f64.to_radians(),
        worm_cone: 0.0,
        work_cone: 0.0,
        worm_pivot: 0.0,
        work_pivot: 0.0,
    };
    let state = GeneratingState {
        worm_angle: 0.0,
        work_angle: 0.0,
        shift: 0.0,
        feed: 0.0,
        delta_d: 0.0,
        delta_gamma: 0.0,
    };
    let found = machine.grinding(&Mounts::default().spindles(&chain.pose(&state))).expect("a pose");
    let error =
        Follower::new(&machine, Station::Work, [1.0; 2]).next(found, [0.0; 2]).expect_err("X1 ends at -420");
    assert!(
        matches!(&error, MachineError::AxisLimit { axis, excess, .. } if axis == "X1" && (excess - 80.0).abs() < 1e-9),
        "{error}"
    );
    assert_eq!(error.code(), "axis-limit");
    assert!(error.way_out().contains("X1"), "{}", error.way_out());
}

/// Full turns are kept over a stroke of thousands of degrees in few steps.
#[test]
fn endless_axes_keep_their_turns() {
    let machine = machine("no-swivel");
    let mounts = mounts([0.0, 0.3, 2.0, 0.7], [false, false]);
    let mut follower = Follower::new(&machine, Station::Work, [1.0, 1.0]);
    let (worm, work) = (machine.role(Role::Worm).expect("worm"), machine.role(Role::Work).expect("work"));
    let chain = GeneratingChain {
        centre_distance: 150.0,
        crossed_axes_angle: 110f64.to_radians(),
        worm_cone: 0.0,
        work_cone: 0.0,
        worm_pivot: 0.0,
        work_pivot: 0.0,
    };
    let mut rows = Vec::new();
    for k in 0..5 {
        let angles = [200.0 * f64::from(k), -31.0 * f64::from(k)];
        let state = GeneratingState {
            worm_angle: angles[0],
            work_angle: angles[1],
            shift: 0.0,
            feed: f64::from(k),
            delta_d: 0.0,
            delta_gamma: 0.0,
        };
        let found = machine.grinding(&mounts.spindles(&chain.pose(&state))).expect("a pose");
        rows.push(follower.next(found, angles).expect("within travel"));
    }
    for (k, row) in rows.iter().enumerate() {
        assert!((row[worm] - rows[0][worm] - 200.0 * k as f64).abs() < 1e-9, "{row:?}");
        assert!((row[work] - rows[0][work] + 31.0 * k as f64).abs() < 1e-9, "{row:?}");
    }
}

#[test]
fn the_pole_of_a_table_is_told_and_can_be_held() {
    let machine = machine("five-axis-ac-table");
    let wanted = ToolAxis {
        tip: Point::new(10.0, 0.0, 5.0),
        axis: Direction::from_vector([0.0, 0.0, 1.0].into()),
        reach: Point::new(0.0, 0.0, -100.0),
    };
    let c = machine.axis_named("C").expect("C");
    match machine.tool_axis(Station::Work, &wanted, None) {
        Ok(AxisSolutions::Pole { free, .. }) => assert_eq!(free, c),
        other => panic!("{other:?}"),
    }
    let held = machine.tool_axis(Station::Work, &wanted, Some(1.2)).expect("held");
    let AxisSolutions::Positions(found) = held else { panic!("held") };
    assert_eq!(found.len(), 1);
    assert!((found[0][c] - 1.2).abs() < 1e-12);
}

#[test]
fn a_direction_out_of_reach_says_so() {
    let machine = machine("five-axis-nutating-table");
    let wanted = ToolAxis {
        tip: Point::new(0.0, 0.0, 0.0),
        axis: Direction::from_vector([0.0, 0.6, -0.8].into()),
        reach: Point::new(0.0, 0.0, -100.0),
    };
    let error = machine.tool_axis(Station::Work, &wanted, None).expect_err("beyond 90 degrees");
    assert_eq!(error.code(), "unreachable", "{error}");
}

/// Every contradiction of a description is told with its key.
#[test]
fn descriptions_that_are_no_machines() {
    let text = std::fs::read_to_string(directory().join("no-swivel.toml")).expect("a shipped machine");
    let cases = [
        ("direction = [0, 1, 0]", "direction = [0, 1.1, 0]", "invalid-machine", "direction"),
        ("direction = [0, 1, 0]", "direction = [0, 1]", "", "direction"),
        ("min_mm = -420", "min_mm = -10", "invalid-machine", "axes.X1.max_mm"),
        ("min_mm = -420\n", "", "invalid-machine", "axes.X1.min_mm"),
        ("min_mm = -420", "min_deg = -420", "invalid-machine", "axes.X1"),
        ("worm = \"B1\"", "worm = \"B9\"", "invalid-machine", "roles.worm"),
        ("worm = \"B1\"", "worm = \"X1\"", "invalid-machine", "roles.worm"),
        ("axes = [\"C2\"]", "axes = [\"C2\", \"B1\"]", "invalid-machine", "axes.B1"),
        ("axes = [\"C2\"]", "axes = [\"C9\"]", "invalid-machine", "chains.work.axes[0]"),
        ("axes = [\"C2\"]", "axes = []", "invalid-machine", "axes.C2"),
        ("type = \"rotary\"", "type = \"turning\"", "unknown-value", "type"),
        ("x = [1, 0, 0], z = [0, 1, 0]", "x = [0, 1, 0], z = [0, 1, 0]", "invalid-machine", "frame.x"),
        ("endless = true", "endless = true\nmax_deg = 5", "invalid-machine", "endless"),
        ("resolution = 0.0001", "resolution = -1", "invalid-number", "resolution"),
        ("max_velocity = 250", "speed = 250", "unknown-key", "speed"),
    ];
    for (from, to, code, field) in cases {
        let changed = text.replacen(from, to, 1);
        assert_ne!(changed, text, "{from}");
        let error = parse_machine(Source::new("machine.toml", &changed)).expect_err(to);
        let first = &error.diagnostics[0];
        assert!(code.is_empty() || first.code == code, "{to}: {error}");
        assert!(first.field.as_deref().is_some_and(|f| f.contains(field)), "{to}: {:?} {error}", first.field);
        assert!(first.span.is_some() && first.way_out.is_some(), "{to}: {first:?}");
    }
}

/// What an axis leaves on the flank, against central differences of the forward kinematics.
#[test]
fn influence_agrees_with_differences() {
    let machine = machine("eight-axis");
    let mut at = Positions::default();
    for (k, axis) in machine.axes().iter().enumerate() {
        at[k] = if axis.joint == Joint::Rotary { 0.2 + 0.05 * k as f64 } else { -80.0 + 9.0 * k as f64 };
    }
    let (point, normal) =
        (Point::new(25.0, 88.0, -6.0), Direction::from_vector([0.895, 0.229, -0.382].into()));
    for station in [Station::Work, Station::Dresser] {
        let here = machine.pose(station, &at).expect("finite");
        let body = here.inverse().point(&point);
        for (axis, left) in machine.influence(station, &at, &point, &normal).expect("axes") {
            let moved = |by: f64| {
                let mut at = at;
                at[axis] += by;
                machine.pose(station, &at).expect("finite").point(&body).xyz
            };
            let step = 1e-5;
            let rate = (moved(step) - moved(-step)).dot(&normal.xyz) / (2.0 * step);
            assert!(
                (rate - left).abs() < 1e-6 * (1.0 + left.abs()),
                "{}: {rate} {left}",
                machine.axes()[axis].name
            );
        }
    }
}
