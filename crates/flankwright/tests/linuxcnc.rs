//! The written programs in LinuxCNC itself (spec 80 sections 4 and 9): `rs274` interprets them, the Python module `gcode` gives
//! their targets with all digits. Without `scripts/linuxcnc-client` these tests say so and check nothing.

use crate::line_programs::{job, planned};
use crate::nc::client::{ABSENT, Client};
use crate::nc::helical_row;
use crate::nc::programs::{self, A, C, Draw, X, Z, program, random, stroke};
use flankwright::exchange::{AnyJob, read_any_job};
use flankwright::nc::{
    AxisMotion, AxisWord, Block, Decimals, Dialect, FeedWords, Header, Program, Targets, WriteOptions, read,
    split_turns, write_checked,
};
use flankwright::workflow::Outcome;
use flankwright::workflow::milling::{run_milling, write_milling};
use std::io::Write as _;
use std::path::PathBuf;

/// Half of the fourth decimal that `rs274` prints.
const PRINTED: f64 = 5.001e-5;

/// Not by `println!`, which is only shown when a test fails: what was not tested has to be seen.
fn say_absent(what: &str) {
    drop(writeln!(std::io::stderr(), "{ABSENT}: {what}"));
}

fn client(test: &str) -> Option<(Client, tempfile::TempDir)> {
    let client = Client::find();
    if client.is_none() {
        say_absent(&format!("{test} skipped; scripts/linuxcnc-client gets it"));
    }
    Some((client?, tempfile::tempdir().expect("a directory")))
}

/// A motion in mm and degrees: the nine places, and the feed of the control or none for a rapid.
#[derive(Clone, Debug)]
struct Motion {
    place: [f64; 9],
    feed: Option<f64>,
}

/// What a control is to make of a program: every motion with the feed that G93 means.
fn wanted(axes: &[AxisWord], blocks: &[Block]) -> Vec<Motion> {
    let order = |axis: usize| match axes[axis].word {
        flankwright::nc::Word::Letter(letter) => "XYZABCUVW".find(letter).expect("a letter of an axis"),
        _ => panic!("an axis without letter moves"),
    };
    let mut place = [0.0; 9];
    let mut motions = Vec::new();
    for block in blocks {
        let (target, duration) = match block {
            Block::Rapid(target) => (target, None),
            Block::Linear { target, duration } => (target, Some(*duration)),
            _ => continue,
        };
        let from = place;
        for (axis, value) in target.iter() {
            let rotary = axes[axis].motion == AxisMotion::Rotary;
            place[order(axis)] = if rotary { value.to_degrees() } else { value };
        }
        let way =
            |axes: [usize; 3]| axes.map(|axis| (place[axis] - from[axis]).powi(2)).iter().sum::<f64>().sqrt();
        let groups = [way([0, 1, 2]), way([6, 7, 8]), way([3, 4, 5])];
        let way = groups.into_iter().find(|way| *way > 1e-6).unwrap_or(0.0);
        motions.push(Motion { place, feed: duration.map(|duration| 60.0 / duration * way) });
    }
    motions
}

/// Compares; `linear` and `rotary` are the tolerances of places, `printed` that of feeds.
fn compare(wanted: &[Motion], found: &[Motion], linear: f64, rotary: f64, printed: f64) -> f64 {
    assert_eq!(wanted.len(), found.len());
    let mut worst = 0.0f64;
    for (k, (a, b)) in wanted.iter().zip(found).enumerate() {
        for axis in 0..9 {
            let tolerance = if (3..6).contains(&axis) { rotary } else { linear };
            let delta = (a.place[axis] - b.place[axis]).abs();
            assert!(delta <= tolerance + 4e-16 * a.place[axis].abs(), "motion {k} axis {axis}: {a:?} {b:?}");
            worst = worst.max(delta / tolerance);
        }
        assert_eq!(a.feed.is_some(), b.feed.is_some(), "motion {k}");
        let (Some(p), Some(q)) = (a.feed, b.feed) else { continue };
        // The way is that of rounded places; below 0.1 the interpreter takes 0.1.
        let way = p.max(0.1);
        let rounding = 1e-6 * way + if p > 0.0 { way * 4e-6 / way_of(wanted, k) } else { f64::INFINITY };
        assert!((q - way).abs() <= printed + rounding, "motion {k}: feed {q}, wanted {p}");
    }
    worst
}

/// Length of a motion that its feed counts for.
fn way_of(motions: &[Motion], k: usize) -> f64 {
    let from = if k == 0 { [0.0; 9] } else { motions[k - 1].place };
    let ways: Vec<f64> = motions[k].place.iter().zip(from).map(|(a, b)| (a - b).abs()).collect();
    let group = |axes: std::ops::Range<usize>| ways[axes].iter().fold(0.0f64, |a, b| a.max(*b));
    [group(0..3), group(6..9), group(3..6)].into_iter().find(|way| *way > 1e-6).unwrap_or(1.0)
}

/// The motions in the canonical text of `rs274`.
fn canonical(text: &str) -> Vec<Motion> {
    let (mut motions, mut rate) = (Vec::new(), 0.0);
    for line in text.lines() {
        let Some((head, arguments)) = line.trim_end().trim_end_matches(')').split_once('(') else { continue };
        let numbers = || arguments.split(',').map(|number| number.trim().parse().expect("a number"));
        let place = || {
            let mut place = [0.0; 9];
            for (axis, value) in numbers().enumerate() {
                place[axis] = value;
            }
            place
        };
        match head.split_whitespace().last() {
            Some("SET_FEED_RATE") => rate = numbers().next().expect("a rate"),
            Some("STRAIGHT_FEED") => motions.push(Motion { place: place(), feed: Some(rate) }),
            Some("STRAIGHT_TRAVERSE") => motions.push(Motion { place: place(), feed: None }),
            _ => {}
        }
    }
    motions
}

/// The motions and the other events of the module `gcode`.
fn events(text: &str) -> (Vec<Motion>, Vec<String>) {
    let (mut motions, mut others, mut rate) = (Vec::new(), Vec::new(), 0.0);
    for line in text.lines() {
        let (name, rest) = line.split_once(' ').unwrap_or((line, ""));
        let numbers = || rest.split(' ').map(|number| number.parse::<f64>().expect("a number"));
        let place = || {
            let values: Vec<f64> = numbers().collect();
            std::array::from_fn(|axis| values[axis])
        };
        match name {
            "rate" => rate = numbers().next().expect("a rate"),
            "feed" => motions.push(Motion { place: place(), feed: Some(rate) }),
            "rapid" => motions.push(Motion { place: place(), feed: None }),
            _ => others.push(line.to_owned()),
        }
    }
    (motions, others)
}

fn stand_alone() -> WriteOptions {
    let mut options = WriteOptions::default();
    options.linuxcnc.stand_alone = true;
    options
}

/// Strokes with and without an end of C, random blocks of every kind, steps of modulo axes.
fn programs() -> Vec<(Program, WriteOptions)> {
    let dialect = Dialect::LinuxCnc;
    let mut programs = vec![(without_second_spindle(&stroke(dialect, 400)), stand_alone())];
    let long = (1..50).map(|k| {
        let target =
            Targets::NONE.with(Z, 30.0 * f64::from(k % 2)).with(C, 3e4 * f64::from(k) + 0.123_456_789);
        Block::Linear { target, duration: 600.0 + f64::from(k) }
    });
    programs.push((without_second_spindle(&program(dialect, long.collect())), stand_alone()));
    for seed in 0..12 {
        programs.push((without_second_spindle(&random(dialect, seed, 300, true)), stand_alone()));
    }
    let modulo = WriteOptions { incremental_rotary: true, ..stand_alone() };
    programs.push((split_turns(&without_second_spindle(&stroke(dialect, 60))).unwrap(), modulo));
    programs
}

/// The stand-alone interpreter has one spindle, so that the map may not have two.
fn without_second_spindle(program: &Program) -> Program {
    let mut header = program.header().clone();
    header.axes.pop();
    Program::new(header, program.blocks().to_vec()).unwrap()
}

fn file(directory: &tempfile::TempDir, text: &str) -> PathBuf {
    let path = directory.path().join("program.ngc");
    std::fs::write(&path, text).expect("a file");
    path
}

#[test]
fn written_programs_mean_in_linuxcnc_what_the_neutral_program_says() {
    let Some((client, directory)) = client("interpretation of written programs") else { return };
    let mut found = Found::default();
    for (program, options) in programs() {
        let text = write_checked(&program, Dialect::LinuxCnc, &options).unwrap().text;
        found.add(&client, &directory, &program, &text);
    }
    found.tell();
}

/// What the client made of programs.
#[derive(Default)]
struct Found {
    motions: usize,
    worst: [f64; 2],
}

impl Found {
    /// Has the client interpret a text and compares with the program that it is of.
    fn add(&mut self, client: &Client, directory: &tempfile::TempDir, program: &Program, text: &str) {
        let path = file(directory, text);
        let wanted = wanted(program.axes(), program.blocks());
        self.motions += wanted.len();

        let output = client.interpret(&path, directory.path());
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        let found = canonical(&String::from_utf8_lossy(&output.stdout));
        let half = PRINTED + 5e-7;
        self.worst[0] = self.worst[0].max(half * compare(&wanted, &found, half, half, 1e-4));

        let Some(parsed) = client.parse(&path, directory.path()) else {
            return say_absent("its module gcode finds no Python of its version; that part skipped");
        };
        let (found, others) = events(&parsed.expect("the module takes the program"));
        self.worst[1] = self.worst[1].max(compare(&wanted, &found, 5.1e-7, 5.1e-8, 1e-6));
        let expected: Vec<f64> = program
            .blocks()
            .iter()
            .filter_map(|block| if let Block::Dwell(seconds) = block { Some(*seconds) } else { None })
            .collect();
        let dwells: Vec<f64> =
            others.iter().filter_map(|line| line.strip_prefix("dwell ")?.parse().ok()).collect();
        assert_eq!(dwells.len(), expected.len());
        assert!(dwells.iter().zip(&expected).all(|(a, b)| (a - b).abs() < 5.1e-7));
        let comments = others.iter().filter(|line| line.starts_with("comment")).count();
        let written = program.blocks().iter().filter(|block| matches!(block, Block::Comment(_))).count();
        assert_eq!(comments, written + 1, "the name is a comment as well");
    }

    /// Every LinuxCNC program of a run of generating grinding; the number of motions.
    fn add_run(&mut self, client: &Client, directory: &tempfile::TempDir, outcome: &Outcome) -> usize {
        let before = self.motions;
        let programs = &outcome.programs.as_ref().expect("programs").built.programs;
        for made in programs.iter().filter(|made| made.dialect == Dialect::LinuxCnc) {
            self.add(client, directory, &made.layout.program, &made.written.text);
        }
        self.motions - before
    }

    fn tell(&self) {
        println!(
            "{} motions: rs274 within {:.3e}, gcode within {:.4} of half a digit",
            self.motions, self.worst[0], self.worst[1]
        );
    }
}

/// Every LinuxCNC program that the examples with a machine give.
#[test]
fn the_programs_of_the_examples_mean_the_same_in_linuxcnc() {
    let Some((client, directory)) = client("programs of the examples") else { return };
    let mut found = Found::default();
    for example in ["twist-free-crowning", "automotive-bias", "radial-feed-crowning"] {
        let path = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join(format!("../../examples/{example}.toml"));
        let loaded = flankwright::exchange::read_job(&path).expect("an example");
        let outcome = flankwright::workflow::plan_job(&loaded, &flankwright::numerics::Silent);
        assert!(found.add_run(&client, &directory, &outcome.expect("a plan")) > 10, "{example}");
    }
    found.tell();
}

/// Line dressing goes from line to line with many short motions, and stops between two threads.
#[test]
fn programs_of_line_dressing_mean_the_same_in_linuxcnc() {
    let Some((client, directory)) = client("programs of line dressing") else { return };
    let mut found = Found::default();
    let outcome = planned(&job(&[("\"siemens\"", "\"linuxcnc\"")], ""));
    assert!(found.add_run(&client, &directory, &outcome) > 100);
    found.tell();
}

/// The LinuxCNC program that `plan` writes for each milling example with a machine: every motion goes where the axes were planned
/// to be, and the feeds are those of the text.
#[test]
fn the_programs_of_milling_examples_mean_the_same_in_linuxcnc() {
    let Some((client, directory)) = client("programs of the milling examples") else { return };
    let examples =
        ["spur-on-ac-table", "helical-on-bc-table", "spiral-bevel-on-head-table", "blade-on-head-head"];
    for example in examples {
        let path =
            PathBuf::from(env!("CARGO_MANIFEST_DIR")).join(format!("../../examples/milling/{example}.toml"));
        let Ok(AnyJob::Milling(loaded)) = read_any_job(&path) else { panic!("{example} is no milling job") };
        let outcome = run_milling(&loaded, &flankwright::numerics::Silent).expect("a plan");
        let written = directory.path().join(example);
        write_milling(&loaded.job, &outcome, &written).expect("files");
        let programs = outcome.texts.programs.expect("programs");
        let made =
            programs.programs.iter().find(|made| made.dialect == Dialect::LinuxCnc).expect("a program");
        let text = std::fs::read_to_string(written.join(&made.file)).expect("a text");
        let tools = "T1 P1 Z0\nT2 P2 Z0\n";
        let output = client.interpret_with_tools(&written.join(&made.file), directory.path(), tools);
        assert!(output.status.success(), "{example}: {}", String::from_utf8_lossy(&output.stderr));
        let found = canonical(&String::from_utf8_lossy(&output.stdout));
        let axes = made.program.axes();
        let planned = wanted(axes, made.program.blocks());
        assert!(planned.len() > 50, "{example}");
        assert_eq!(planned.len(), found.len(), "{example}");
        let mut worst = [0.0f64; 2];
        for (planned, found) in planned.iter().zip(&found) {
            for axis in 0..9 {
                let off = (planned.place[axis] - found.place[axis]).abs();
                let kind = usize::from((3..6).contains(&axis));
                worst[kind] = worst[kind].max(off);
            }
        }
        // What the text rounds, 4 decimals of mm and 5 of degrees, and what is printed.
        assert!(worst[0] <= PRINTED + 5.001e-5 && worst[1] <= PRINTED + 5.001e-6, "{example}: {worst:?}");
        println!("{example}: {} motions, {worst:?} mm and deg off", found.len());
        // What the text says is at hand, so that only the printing is left, of the feeds as well.
        let read = read(text.as_bytes(), Dialect::LinuxCnc, axes).expect("a program").blocks;
        compare(&wanted(axes, &read), &found, PRINTED, PRINTED, 1e-4);
    }
}

#[test]
fn the_sample_of_the_specification_gives_its_values() {
    let Some((client, directory)) = client("sample of the specification") else { return };
    let start = Targets::of_first(&[120.0, -15.0, -25.0, 20f64.to_radians(), 0.0]);
    let z = -24.75;
    let angle = 360.0 * 40.0 / 200.0 + 0.489907768025508 * (z + 25.0);
    let target = Targets::NONE.with(X, 119.999602).with(1, -14.85).with(Z, z).with(A, 20f64.to_radians());
    let target = target.with(C, angle.to_radians());
    let blocks = vec![Block::Rapid(start), Block::Linear { target, duration: 0.05 }];
    let sample = without_second_spindle(&program(Dialect::LinuxCnc, blocks));
    let text = write_checked(&sample, Dialect::LinuxCnc, &stand_alone()).unwrap().text;
    assert!(
        text.contains("G1 X119.999602 Y-14.850000 Z-24.750000 A20.0000000 C72.1224769 F1200.000000\n"),
        "{text}"
    );
    let output = client.interpret(&file(&directory, &text), directory.path());
    let canonical = String::from_utf8_lossy(&output.stdout);
    assert!(output.status.success());
    assert!(
        canonical.contains("STRAIGHT_FEED(119.9996, -14.8500, -24.7500, 20.0000, 0.0000, 72.1225)"),
        "{canonical}"
    );
    assert!(canonical.contains("SET_FEED_RATE(349.8574)"), "{canonical}");
}

/// The helical row of spec 50 as axis values with a time for each block, as a machine without tip control takes it.
#[test]
fn a_milled_row_of_axis_values_means_the_same_in_linuxcnc() {
    let Some((client, directory)) = client("milled row") else { return };
    let linear = |name: &str, letter| AxisWord::letter(name, AxisMotion::Linear, letter);
    let rotary = |name: &str, letter| AxisWord::letter(name, AxisMotion::Rotary, letter);
    let axes =
        vec![linear("X1", 'X'), linear("Y1", 'Y'), linear("Z1", 'Z'), rotary("C1", 'C'), rotary("A1", 'A')];
    let place = |k: usize| {
        let ([x, y, z], [c, a]) = (helical_row::PLACES[k], helical_row::ANGLES[k]);
        Targets::of_first(&[x, y, z, c.to_radians(), a.to_radians()])
    };
    let spindle = Block::Spindle { spindle: 0, speed: 3000.0 * std::f64::consts::PI / 30.0 };
    let mut blocks = vec![Block::Tool { number: 5, length_offset: None }, spindle, Block::Rapid(place(0))];
    let feeds = helical_row::FEEDS.iter().enumerate();
    blocks.extend(feeds.map(|(k, feed)| Block::Linear { target: place(k + 1), duration: 60.0 / feed }));
    blocks.push(Block::End);
    let header = Header { name: "ROW".into(), axes, chord_tolerance: 1e-3 };
    let row = Program::new(header, blocks).unwrap();
    let milling = WriteOptions {
        decimals: Decimals::MILLING,
        feed_words: FeedWords::AxisBlocks,
        line_numbers: Some(10),
        ..stand_alone()
    };
    for options in [stand_alone(), milling] {
        let text = write_checked(&row, Dialect::LinuxCnc, &options).unwrap().text;
        let path = file(&directory, &text);
        let output = client.interpret_with_tools(&path, directory.path(), "T5 P5 Z0\n");
        let canonical_text = String::from_utf8_lossy(&output.stdout);
        assert!(output.status.success(), "{}{text}", String::from_utf8_lossy(&output.stderr));
        assert!(canonical_text.contains("SELECT_TOOL(5)"), "{canonical_text}");
        assert!(canonical_text.contains("START_SPINDLE_CLOCKWISE(0)"), "{canonical_text}");
        // What the text says is at hand, so that only the printing is left.
        let found = read(text.as_bytes(), Dialect::LinuxCnc, row.axes()).unwrap();
        let motions = canonical(&canonical_text);
        compare(&wanted(row.axes(), &found.blocks), &motions, PRINTED, PRINTED, 1e-4);
        // Without its F a block in inverse time is refused by both.
        let at = text.rfind(" F434").expect("a feed");
        let end = at + text[at..].find('\n').expect("a line end");
        let lacking = [&text[..at], &text[end..]].concat();
        assert!(read(lacking.as_bytes(), Dialect::LinuxCnc, row.axes()).is_err());
        let output = client.interpret_with_tools(&file(&directory, &lacking), directory.path(), "T5 P5 Z0\n");
        assert!(!output.status.success(), "rs274 takes {lacking}");
    }
}

#[test]
fn nine_letters_are_read_by_the_running_control() {
    let Some((client, directory)) = client("nine axes") else { return };
    let axes = "XYZABCUVW".chars().map(|letter| {
        let motion = if "ABC".contains(letter) { AxisMotion::Rotary } else { AxisMotion::Linear };
        AxisWord::letter(&format!("{letter}1"), motion, letter)
    });
    let header = Header { name: "NINE".into(), axes: axes.collect(), chord_tolerance: 1e-4 };
    let mut draw = Draw::new(9);
    let mut blocks: Vec<Block> = (0..2000)
        .map(|_| {
            let values: [f64; 9] = std::array::from_fn(|_| draw.between(-200.0, 200.0));
            Block::Linear { target: Targets::of_first(&values), duration: draw.between(0.01, 3.0) }
        })
        .collect();
    blocks.push(Block::End);
    let program = Program::new(header, blocks).unwrap();
    let text = write_checked(&program, Dialect::LinuxCnc, &WriteOptions::default()).unwrap().text;
    let path = file(&directory, &text);
    assert!(!client.interpret(&path, directory.path()).status.success(), "rs274 has six letters");
    let Some(parsed) = client.parse(&path, directory.path()) else {
        return say_absent("its module gcode finds no Python of its version; nine axes skipped");
    };
    let (found, _) = events(&parsed.expect("the module takes nine axes"));
    compare(&wanted(program.axes(), program.blocks()), &found, 5.1e-7, 5.1e-8, 1e-6);
}

#[test]
fn what_linuxcnc_refuses_the_reader_refuses_too() {
    let Some((client, directory)) = client("words that are refused") else { return };
    let axes = programs::axes(Dialect::LinuxCnc);
    let long = format!("({})\nM2", "A".repeat(251));
    let refused = [
        "G1 X1e3 F1\nM2",
        "G93\nG1 X1\nM2",
        "G0 U1\nM2",
        "G43.4\nM2",
        "G54.4 P1\nM2",
        "G81 T40 L3 Q2. P20.\nM2",
        "G81.4 T40 L3\nM2",
        "G06.2 P4 K0. X1. R1.\nM2",
        "G05.1 Q1\nM2",
        "G0 X1",
        "G0 X1\n%\nG0 X2\nM2",
        "G0 X1 X2\nM2",
        "G0 G1 X1 F1\nM2",
        "X1\nM2",
        "G4 P1 X1\nM2",
        "G0 X1 (A\nM2",
        &long,
    ];
    for text in refused {
        let output = client.interpret(&file(&directory, text), directory.path());
        assert!(!output.status.success(), "rs274 takes {text:?}");
        assert!(read(text.as_bytes(), Dialect::LinuxCnc, &axes).is_err(), "the reader takes {text:?}");
    }
}

/// One character of a program changed, and whatever the reader still takes: LinuxCNC takes it too and goes to the same places.
#[test]
fn what_the_reader_takes_of_a_damaged_program_linuxcnc_takes_too() {
    let Some((client, directory)) = client("damaged programs") else { return };
    let axes = programs::axes(Dialect::LinuxCnc);
    let mut draw = Draw::new(5);
    let mut taken = 0;
    for seed in 0..150 {
        let program = without_second_spindle(&random(Dialect::LinuxCnc, seed, 15, true));
        let mut bytes = write_checked(&program, Dialect::LinuxCnc, &stand_alone()).unwrap().text.into_bytes();
        let alphabet = b"0123456789.-+ GMXYZABCFPS()%;\nxg/";
        let place = draw.below(bytes.len() as u64) as usize;
        bytes[place] = alphabet[draw.below(alphabet.len() as u64) as usize];
        let text = String::from_utf8(bytes).unwrap();
        let Ok(found) = read(text.as_bytes(), Dialect::LinuxCnc, &axes) else { continue };
        taken += 1;
        let output = client.interpret(&file(&directory, &text), directory.path());
        assert!(output.status.success(), "rs274 refuses {text}{output:?}");
        let canonical = canonical(&String::from_utf8_lossy(&output.stdout));
        // What the text says is at hand here, so that only the printing is left.
        compare(&wanted(&axes, &found.blocks), &canonical, PRINTED, PRINTED, f64::INFINITY);
    }
    assert!(taken > 20, "{taken} of 150 damaged programs were read");
}
