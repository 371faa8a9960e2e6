//! Programs that measure a skiving tool in its machine: written for every control, read back, followed by forward kinematics, and
//! judged by where the ideal tool switches the beam (`docs/mathematics/skiving.md`).

use crate::peer::client::{ABSENT, Client};
use crate::skiving::samples::{CROWNED, RING, STEPPED, Sample};
use foundation::geometry::{Flank, Sides};
use foundation::kinematics::Pose;
use job::machine::{LoadedMachine, read_machine};
use job::tables::Program as DialectName;
use machine::{Bed, Mount, ToolSpindle};
use nalgebra::Vector3;
use nc::{Block, Dialect};
use run::RunFailure;
use skiving::VirtualEdge;
use skiving::measuring::{Beam, FlankTracks, PoseKind, ScanAxes, Sense, measuring_poses};
use skiving::workflow::programs::{
    MeasuringWork, Retreat, ScanWork, ToolMachining, ToolProgram, measuring_programs, prove_measuring,
    prove_scan, scan_programs,
};
use std::f64::consts::TAU;
use std::io::Write as _;
use std::path::Path;

const ALL: [DialectName; 3] = [DialectName::Linuxcnc, DialectName::Siemens, DialectName::Fanuc];
/// 120 1/min.
const SPEED: f64 = 2.0 * TAU;
const REVOLUTIONS: usize = 8;

fn machine(name: &str) -> LoadedMachine {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("../../machines/{name}.toml"));
    read_machine(&path).expect("a shipped machine")
}

fn machining(machine: &LoadedMachine) -> ToolMachining<'_> {
    ToolMachining {
        machine,
        mount: Mount { reversed: false, axial: 62.5, angle: 0.3 },
        carrier: None,
        retreat: Retreat { distance: 12.0, direction: None, speed: 20.0 },
        output: 3,
        dialects: &ALL,
    }
}

fn measuring<'a>(flanks: &'a Sides<FlankTracks>, beam: &'a Beam) -> MeasuringWork<'a> {
    let (senses, revolutions) = (&Sense::BOTH, REVOLUTIONS);
    MeasuringWork { name: "tool 7", flanks, beam, senses, revolutions, speed: SPEED }
}

fn scanning<'a>(sample: &Sample, edges: &'a Sides<VirtualEdge>, stylus: &'a Beam) -> ScanWork<'a> {
    let axes = if sample.tilt == [0.0; 2] { ScanAxes::WithoutY } else { ScanAxes::All };
    let (range, places, teeth, speed) = ([-0.9, 0.9], 31, &[0, 14, 28][..], 0.5);
    ScanWork { name: "tool 7", edges, stylus, axes, range, places, teeth, speed }
}

fn refused(failure: RunFailure) -> (&'static str, String) {
    match failure {
        RunFailure::BadInput(finding) | RunFailure::NotProducible(finding) => {
            assert!(finding.way_out.is_some() && finding.field.is_some(), "{finding:?}");
            (finding.code, finding.message.to_string())
        }
    }
}

/// All samples, their programs proven, on a machine.
fn each(mut look: impl FnMut(&Sample, &MeasuringWork<'_>, &ToolMachining<'_>, &[ToolProgram])) {
    let machine = machine("skiving-light-barrier");
    for sample in [RING, STEPPED, CROWNED] {
        let (flanks, beam) = (sample.flanks(), sample.beam());
        let work = measuring(&flanks, &beam);
        let machining = machining(&machine);
        let made = measuring_programs(&work, &machining).unwrap_or_else(|e| panic!("{:?}", refused(e)));
        look(&sample, &work, &machining, &made);
    }
}

#[test]
fn every_control_gets_a_text_that_is_proven() {
    each(|_, _, _, made| {
        assert_eq!(made.len(), 3);
        for program in made {
            let proof = program.proof;
            eprintln!(
                "{}: {:.1e} um of {:.1e} um, beam {:.1e} um, {} blocks, {:.1} s",
                program.file,
                proof.difference * 1e3,
                proof.allowed * 1e3,
                proof.axis_distance * 1e3,
                program.blocks,
                program.duration
            );
            // Six decimals of mm and seven of degrees leave a nanometre; what is proven is rounding and not nothing.
            assert!(proof.allowed < 2e-6 && proof.difference > 0.0 && proof.axis_distance > 0.0, "{proof:?}");
            assert!(proof.difference <= proof.allowed && proof.axis_distance <= proof.allowed, "{proof:?}");
            assert_eq!(program.recordings.len(), 20);
            let text = &program.written.text;
            for (flank, track) in [("LEFT", 1), ("RIGHT", 5)] {
                assert!(text.contains(&format!("{flank} TRACK {track}")), "{text}");
            }
            let result = serde_json::to_value(program.result()).expect("JSON");
            assert_eq!(result["recordings"][19]["sense"], "negative");
            assert_eq!(result["recordings"][19]["track"], 5);
            assert!(result.get("scans").is_none() && result["proof_allowed_um"].as_f64() < Some(2e-3));
        }
    });
}

/// The recordings of the read-back text hold every tooth's switch in every turn, at constant speed, and begin between two of them.
#[test]
fn recordings_hold_whole_turns_of_all_teeth() {
    each(|sample, work, machining, made| {
        let teeth = sample.teeth[0].unsigned_abs() as usize;
        let pitch = TAU / teeth as f64;
        for program in made {
            let spindle = machining.machine.machine.axis_named("B").expect("B");
            let word = program.words.place(spindle).expect("a word of B");
            let (mut on, mut at, mut seen, mut recorded) = (false, f64::NAN, 0, Vec::new());
            for block in &program.read {
                match block {
                    Block::Output { number: 3, on: now } => {
                        if *now {
                            recorded.push((at, at, 0.0));
                        }
                        seen += usize::from(on != *now);
                        on = *now;
                    }
                    Block::Rapid(target) => at = target.get(word).unwrap_or(at),
                    Block::Linear { target, duration } => {
                        at = target.get(word).unwrap_or(at);
                        if let (true, Some(last)) = (on, recorded.last_mut()) {
                            assert_eq!(target.iter().count(), 1, "only the spindle moves");
                            (last.1, last.2) = (at, last.2 + duration);
                        }
                    }
                    _ => {}
                }
            }
            assert_eq!((seen, recorded.len()), (40, 20));
            for (recording, (from, to, seconds)) in program.recordings.iter().zip(recorded) {
                let sense = recording.sense.sign();
                assert!((sense * (to - from) / seconds / SPEED - 1.0).abs() < 1e-6);
                // On a control that stands still to switch, the run-up is recorded as well.
                let run_up = sense * (recording.counted[0] - from);
                let run_out = sense * (to - recording.counted[1]);
                let half_turn = 0.5 * TAU - pitch - 1e-8..0.5 * TAU + 1e-8;
                match program.dialect {
                    Dialect::Fanuc => assert!(half_turn.contains(&run_up) && run_out > 0.99 * pitch),
                    _ => assert!(run_up.abs() < 1e-8 && run_out.abs() < 1e-8, "{run_up} {run_out}"),
                }
                let [first, last] = recording.counted;
                assert!((sense * (last - first) - TAU * work.revolutions as f64 - pitch).abs() < 1e-9);
                // All switches of the ideal tool lie at nominal - k pitch: half a pitch from the first place.
                let places = (first - recording.nominal) / pitch + 0.5;
                assert!((places - places.round()).abs() < 1e-7, "{places}");
            }
        }
    });
}

/// Time per measurement = flanks*tracks*(revs*60/rpm*senses + t_move), `docs/mathematics/skiving.md#light-barrier`.
#[test]
fn the_time_is_that_of_the_specification() {
    each(|sample, work, machining, made| {
        let teeth = f64::from(sample.teeth[0]);
        let turns = 2.0 * 5.0 * work.revolutions as f64 * (TAU / work.speed) * 2.0;
        let Retreat { distance, speed, .. } = machining.retreat;
        for program in made {
            let moving = (program.duration - turns) / 10.0;
            // For both senses: a run-up of half a turn less up to a pitch, a pitch at the end, the way to brake from 720 deg/s with
            // 36000 deg/s^2 or a pitch, and a pitch more where the axes stand to switch. To the beam and back.
            let pitch = TAU / teeth;
            let brake = pitch.max(7.2f64.to_radians());
            let known = 2.0 * distance / speed + 2.0 * (0.5 * TAU + brake) / work.speed;
            let stands = f64::from(u8::from(program.dialect == Dialect::Fanuc));
            let least = known + 2.0 * stands * pitch / work.speed;
            let most = least + 2.0 * pitch / work.speed;
            // Rapid ways from track to track are short: less than half a second each.
            assert!(moving > least && moving < most + 0.5, "{least} {moving} {most}");
            eprintln!(
                "{}: {:.1} s, of it {turns} s recording, t_move {moving:.2} s",
                program.file, program.duration
            );
        }
    });
}

#[test]
fn a_text_that_was_changed_is_not_proven() {
    let machine = machine("skiving-light-barrier");
    let (flanks, beam) = (STEPPED.flanks(), STEPPED.beam());
    let (work, machining) = (measuring(&flanks, &beam), machining(&machine));
    for program in measuring_programs(&work, &machining).expect("programs") {
        let (dialect, text) = (program.dialect, &program.written.text);
        let proof = prove_measuring(&work, &machining, dialect, text).expect("its own text");
        assert_eq!(proof, program.proof);
        let lines: Vec<&str> = text.lines().collect();
        let changed = |line: usize, to: &str| {
            let mut lines = lines.clone();
            lines[line] = to;
            lines.join("\n") + "\n"
        };
        let refuse = |text: &str, what: &str| {
            let (code, message) = refused(prove_measuring(&work, &machining, dialect, text).unwrap_err());
            assert_eq!(code, "program-not-proven", "{what}: {message}");
        };
        // Ten nanometres across the beam.
        let comment = lines.iter().position(|line| line.contains("LEFT TRACK 3")).expect("a track");
        let into = (comment..).find(|&k| lines[k].contains("G1 X")).expect("into the pose");
        let x = lines[into].split_whitespace().find_map(|word| word.strip_prefix('X')).expect("X");
        let moved = format!("{:.6}", x.parse::<f64>().expect("a number") + 1e-5);
        refuse(&changed(into, &lines[into].replace(x, &moved)), "X");
        // Another speed, another output, a turn too few.
        let on = (into..).find(|&k| lines[k].contains("M62") || lines[k].ends_with("=1")).expect("on");
        let turns = (on..).filter(|&k| lines[k].contains("G1 B")).nth(usize::from(dialect == Dialect::Fanuc));
        let turns = turns.expect("turns");
        let feed = lines[turns].split('F').next_back().expect("F");
        let faster = format!("{:.6}", feed.parse::<f64>().expect("a number") * 1.01);
        refuse(&changed(turns, &lines[turns].replace(feed, &faster)), "F");
        let other = lines[on].replace("P3", "P4").replace("[3]", "[4]").replace("1103", "1104");
        refuse(&changed(on, &other), "output");
        let b = lines[turns].split_whitespace().find_map(|word| word.strip_prefix('B')).expect("B");
        let fewer = format!("{:.7}", b.parse::<f64>().expect("a number") - 360.0);
        refuse(&changed(turns, &lines[turns].replace(b, &fewer)), "B");
        refuse(
            &text.replace("M62 P3\n", "").replace("WHEN TRUE DO $A_OUT[3]=1\n", "").replace("#1103=1\n", ""),
            "on",
        );
    }
}

#[test]
fn what_the_machine_cannot_is_an_error_with_flank_track_and_axis() {
    let (flanks, beam) = (CROWNED.flanks(), CROWNED.beam());
    let work = measuring(&flanks, &beam);
    let plain = machine("skiving-light-barrier");
    let refuse =
        |machine: &LoadedMachine| refused(measuring_programs(&work, &machining(machine)).unwrap_err());
    let limited = |name: &str, limits: [f64; 2]| {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../machines/skiving-light-barrier.toml");
        let text = std::fs::read_to_string(path).expect("the machine");
        let (before, after) = text.split_once(&format!("[axes.{name}]")).expect("the axis");
        let after: Vec<String> = after
            .lines()
            .scan([false; 2], |done, line| {
                let [least, greatest] = limits;
                let key = line.split(" = ").next().unwrap_or_default();
                Some(match key {
                    "min_mm" | "min_deg" if !std::mem::replace(&mut done[0], true) => {
                        format!("{key} = {least}")
                    }
                    "max_mm" | "max_deg" if !std::mem::replace(&mut done[1], true) => {
                        format!("{key} = {greatest}")
                    }
                    _ => line.to_owned(),
                })
            })
            .collect();
        let text = format!("{before}[axes.{name}]{}\n", after.join("\n"));
        let source = job::Source::new("machine.toml", &text);
        job::machine::parse_machine(source).expect("a machine")
    };
    for (name, limits, value) in [("A", [-20.0, 20.0], "A = -24."), ("X", [-400.0, 300.0], "X = 3")] {
        let (code, message) = refuse(&limited(name, limits));
        assert_eq!(code, "axis-limit", "{message}");
        for part in ["left flank, track 1", value, &format!("{:.4} .. {:.4}", limits[0], limits[1])] {
            assert!(message.contains(part), "{message}");
        }
    }
    // A tool limb without a spindle, one that has no place for the tool.
    assert_eq!(refuse(&machine("five-axis-ac-table")).0, "missing-axis");
    // The spindle lies along Y and is not brought upright by a head that swivels 45 degrees.
    assert_eq!(refuse(&machine("eight-axis")).0, "axis-limit");

    let with = |change: &dyn Fn(&mut MeasuringWork<'_>, &mut ToolMachining<'_>)| {
        let (mut work, mut machining) = (work, machining(&plain));
        change(&mut work, &mut machining);
        refused(measuring_programs(&work, &machining).unwrap_err()).0
    };
    assert_eq!(with(&|work, _| work.speed = f64::NAN), "invalid-number");
    assert_eq!(with(&|work, _| work.speed = 60.0 * TAU), "axis-too-fast");
    assert_eq!(with(&|work, _| work.speed = 45.0 * TAU), "invalid-number");
    assert_eq!(with(&|work, _| work.revolutions = 0), "invalid-number");
    assert_eq!(with(&|work, _| work.senses = &[]), "invalid-number");
    assert_eq!(with(&|_, machining| machining.output = 0), "nc-number-range");
    assert_eq!(with(&|_, machining| machining.retreat.distance = 0.5), "beam-not-free");
    assert_eq!(with(&|_, machining| machining.retreat.speed = 0.0), "invalid-number");
    assert_eq!(with(&|_, machining| machining.retreat.direction = Some(Vector3::zeros())), "invalid-number");
    assert_eq!(with(&|_, machining| machining.mount.angle = f64::INFINITY), "invalid-number");
}

/// A control that counts the other way and modulo a turn, a tool upside down in its spindle, poses along the flank.
#[test]
fn other_machines_and_poses_are_proven_as_well() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../machines/skiving-light-barrier.toml");
    let text = std::fs::read_to_string(path).expect("the machine");
    let text = text.replace("letter = \"B\"", "letter = \"B\"\nnc_sign = -1");
    let text = text.replace("letter = \"A\"", "letter = \"A\"\nnc_sign = -1");
    let text = text.replace("[controls.siemens]", "[controls.siemens]\nmodulo = true");
    let text = text.replace("[controls.fanuc]", "[controls.fanuc]\ndecimals = { mm = 4, deg = 5, feed = 6 }");
    let source = job::Source::new("machine.toml", &text);
    let machine = job::machine::parse_machine(source).expect("a machine");
    let (edges, beam) = (STEPPED.edges(), STEPPED.beam());
    let flanks = STEPPED.flanks().map(|flank, of| FlankTracks {
        edge: edges[flank].clone(),
        tracks: of
            .tracks
            .iter()
            .enumerate()
            .map(|(k, (track, _))| {
                (*track, measuring_poses(track, &beam, PoseKind::AlongFlank, (flank, k)).expect("poses")[0])
            })
            .collect(),
    });
    let work = MeasuringWork { senses: &[Sense::Negative], ..measuring(&flanks, &beam) };
    let machining =
        ToolMachining { mount: Mount { reversed: false, axial: -40.0, angle: 1.1 }, ..machining(&machine) };
    let made = measuring_programs(&work, &machining).unwrap_or_else(|e| panic!("{:?}", refused(e)));
    for program in &made {
        let coarse = program.dialect == Dialect::Fanuc;
        assert!((program.proof.allowed > 5e-5) == coarse, "{:?}", program.proof);
        assert_eq!(program.recordings.len(), 10);
        // The control counts B the other way.
        let [from, to] = ["from_deg", "to_deg"].map(|key| {
            serde_json::to_value(program.result()).expect("JSON")["recordings"][0][key]
                .as_f64()
                .expect("a number")
        });
        assert!(to > from);
    }
    assert!(made[1].blocks > made[0].blocks, "turns are split");
}

/// Inverse and forward kinematics of the tool's limb agree for any pose that it reaches, and say so for others.
#[test]
fn the_tool_limb_alone_is_placed() {
    let machine = machine("skiving-light-barrier").machine;
    let (turning, sense) = machine.tool_turning().expect("a spindle");
    assert_eq!((machine.axes()[turning].name.as_str(), sense), ("B", 1.0));
    for k in 0..60 {
        let angle = |scale: f64| (f64::from(k) * scale).sin();
        let turn =
            Pose::<Bed, Bed>::rx(0.7 * angle(1.3)).then(&Pose::<Bed, ToolSpindle>::rz(3.0 * angle(2.1)));
        // At A = 0 head and work spindle are parallel, which is no matter here.
        let turn = if k == 0 { Pose::<Bed, ToolSpindle>::rz(1.0) } else { turn };
        let wanted =
            Pose::rigid(*turn.rotation(), Vector3::new(300.0 * angle(0.7), 90.0 * angle(3.1), 200.0));
        let found = machine.tool_placed(&wanted).expect("a place");
        assert_eq!(found.len(), 1);
        let back = machine.tool_spindle(&found[0]).expect("finite");
        let apart = (back.translation() - wanted.translation()).amax();
        assert!((back.rotation() - wanted.rotation()).amax() < 1e-14 && apart < 1e-12);
    }
    let leaning = Pose::<Bed, ToolSpindle>::ry(0.1);
    assert_eq!(machine.tool_placed(&leaning).unwrap_err().code(), "unreachable");
}

#[test]
fn scans_are_proven_and_state_what_lies_between_their_places() {
    let machine = machine("skiving-light-barrier");
    for sample in [RING, STEPPED, CROWNED] {
        let (edges, stylus) = (sample.edges(), sample.beam());
        let work = scanning(&sample, &edges, &stylus);
        // With the tool's datum face at the swivel's axis, so that axes that the poses hold stand.
        let machining =
            ToolMachining { mount: Mount { angle: 0.3, ..Mount::default() }, ..machining(&machine) };
        let made = scan_programs(&work, &machining).unwrap_or_else(|e| panic!("{:?}", refused(e)));
        for program in &made {
            let proof = program.proof;
            let between = proof.between_places.expect("a scan");
            eprintln!(
                "{}: {:.1e} um of {:.1e} um, between {:.4} um, {:.1} s",
                program.file,
                proof.difference * 1e3,
                proof.allowed * 1e3,
                between * 1e3,
                program.duration
            );
            assert!(proof.difference > 0.0 && proof.allowed < 2e-6 && between < 1e-3, "{proof:?}");
            assert_eq!(program.scanned.len(), 6);
            let scan = program.scanned.iter().find(|of| (of.flank, of.tooth) == (Flank::Right, 28));
            assert_eq!(scan.expect("tooth 28").places.len(), 31);
            assert_eq!(
                prove_scan(&work, &machining, program.dialect, &program.written.text).expect("proven"),
                proof
            );
            let text = &program.written.text;
            // With the stylus upright neither Y nor Z moves; tilted all axes do.
            let line = text.lines().skip_while(|line| !line.contains("SCAN LEFT")).nth(8).expect("a place");
            let upright = sample.tilt == [0.0; 2];
            assert_eq!(line.contains(" Z"), !upright, "{line}");
            assert!(line.contains(" A") && line.contains(" B") && line.contains(" X"), "{line}");
            // A place moved by ten nanometres is no place of the scan.
            let x = line.split_whitespace().find_map(|word| word.strip_prefix('X')).expect("X");
            let moved = format!("{:.6}", x.parse::<f64>().expect("a number") + 1e-5);
            let text = text.replace(line, &line.replace(x, &moved));
            let failure = prove_scan(&work, &machining, program.dialect, &text).unwrap_err();
            assert_eq!(refused(failure).0, "program-not-proven");
        }
        let few = ScanWork { teeth: &[0, 1], ..work };
        assert_eq!(refused(scan_programs(&few, &machining).unwrap_err()).0, "invalid-number");
        let beyond = ScanWork { teeth: &[0, 1, 500], ..work };
        assert_eq!(refused(scan_programs(&beyond, &machining).unwrap_err()).0, "invalid-number");
    }
}

/// LinuxCNC's own interpreter makes the same motions of the text, and switches the output where it says.
#[test]
fn linuxcnc_interprets_the_program() {
    let Some(client) = Client::find() else {
        drop(writeln!(
            std::io::stderr(),
            "{ABSENT}: measuring programs skipped; scripts/linuxcnc-client gets it"
        ));
        return;
    };
    let directory = tempfile::tempdir().expect("a directory");
    each(|_, _, _, made| {
        let program = &made[0];
        let path = directory.path().join("measuring.ngc");
        std::fs::write(&path, &program.written.text).expect("a file");
        let output = client.interpret(&path, directory.path());
        let text = String::from_utf8_lossy(&output.stdout).into_owned();
        assert!(output.status.success(), "{text}{}", String::from_utf8_lossy(&output.stderr));
        let count = |what: &str| text.lines().filter(|line| line.contains(what)).count();
        assert_eq!(
            [count("SET_MOTION_OUTPUT_BIT(3)"), count("CLEAR_MOTION_OUTPUT_BIT(3)")],
            [20, 20],
            "{text}"
        );
        let moves = program.blocks;
        assert_eq!(count("STRAIGHT_FEED(") + count("STRAIGHT_TRAVERSE("), moves);
    });
}
