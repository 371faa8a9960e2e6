//! The written programs in LinuxCNC itself (`docs/mathematics/programs.md#how-it-is-verified`): `rs274` interprets them, the Python module
//! `gcode` gives their targets with all digits. Without `scripts/linuxcnc-client` these tests say so and check nothing.

use crate::helical_row;
use crate::peer::{Found, PRINTED, canonical, client, compare, events, file, say_absent, wanted};
use crate::programs::{self, A, C, Draw, X, Z, program, random, stroke};
use nc::{
    AxisMotion, AxisWord, Block, Decimals, Dialect, FeedWords, Header, Program, Targets, WriteOptions, read,
    split_turns, write_checked,
};

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

#[test]
fn written_programs_mean_in_linuxcnc_what_the_neutral_program_says() {
    let Some((client, directory)) = client("interpretation of written programs") else { return };
    let mut found = Found::default();
    for (program, options) in programs() {
        let text = write_checked(&program, Dialect::LinuxCnc, &options).unwrap().written.text;
        found.add(&client, &directory, &program, &text);
    }
    found.tell();
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
    let text = write_checked(&sample, Dialect::LinuxCnc, &stand_alone()).unwrap().written.text;
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

/// The helical row of `docs/mathematics/milling.md` as axis values with a time for each block, as a machine without tip control takes it.
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
        let text = write_checked(&row, Dialect::LinuxCnc, &options).unwrap().written.text;
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
    let text = write_checked(&program, Dialect::LinuxCnc, &WriteOptions::default()).unwrap().written.text;
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
        let mut bytes =
            write_checked(&program, Dialect::LinuxCnc, &stand_alone()).unwrap().written.text.into_bytes();
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
