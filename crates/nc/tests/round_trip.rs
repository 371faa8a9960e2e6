//! The neutral program, its writers and its reader: read-back of random programs in three dialects, bytes that never differ,
//! damage that is found, and every error of `docs/mathematics/programs.md#limits`.

use crate::programs::{A, B, C, WORM, X, Y, Z, axes, header, program, random, stroke};
use nc::{
    AxisMotion, AxisWord, BSplineMotion, Block, Coupling, CubicMotion, CubicSpan, CurveTable, Decimals,
    Dialect, Gear, GearLeader, GearSynchronisation, HalOptions, Header, NcError, Program, ReadProblem,
    Repetition, TablePiece, Targets, ToothData, Warning, WriteOptions, compare, detect_dialect, read,
    split_turns, write, write_checked,
};
use proptest::prelude::*;
use std::io::{BufReader, Read};

fn text(program: &Program, dialect: Dialect) -> String {
    write_checked(program, dialect, &WriteOptions::default()).unwrap().written.text
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, cases: 200, ..ProptestConfig::default() })]

    #[test]
    fn random_programs_read_back_in_every_dialect(seed in any::<u64>(), mm in 3u8..=9, deg in 3u8..=9, feed in 3u8..=9) {
        for dialect in Dialect::ALL {
            let program = random(dialect, seed, 60, false);
            let options = WriteOptions { decimals: Decimals { mm, deg, feed }, ..WriteOptions::default() };
            let written = write_checked(&program, dialect, &options).unwrap().written;
            prop_assert_eq!(&written, &write(&program, dialect, &options).unwrap());
            prop_assert!(written.text.is_ascii() && written.text.ends_with('\n'));
            prop_assert!(!written.text.contains('\r') && !written.text.lines().any(|line| line.ends_with(' ')));
            prop_assert_eq!(detect_dialect(written.text.as_bytes()), Some(dialect));
            // What was read is a program itself and writes the same text.
            let found = read(written.text.as_bytes(), dialect, program.axes()).unwrap();
            prop_assert_eq!(found.name.as_deref(), Some("GRIND_1"));
            let again = Program::new(header(dialect), found.blocks).unwrap();
            prop_assert!(write_checked(&again, dialect, &options).is_ok());
        }
    }

    #[test]
    fn modulo_axes_take_steps_below_a_turn(seed in any::<u64>()) {
        let options = WriteOptions { incremental_rotary: true, ..WriteOptions::default() };
        for dialect in Dialect::ALL {
            let program = split_turns(&stroke(dialect, 40 + seed as usize % 20)).unwrap();
            write_checked(&program, dialect, &options).unwrap();
        }
    }

    #[test]
    fn a_changed_digit_is_a_mismatch_or_refused(seed in any::<u64>(), place in any::<prop::sample::Index>(), by in 1u8..9) {
        for dialect in Dialect::ALL {
            let program = random(dialect, seed, 30, false);
            let options = WriteOptions::default();
            let written = write_checked(&program, dialect, &options).unwrap().written;
            let mut bytes = written.text.clone().into_bytes();
            let digits: Vec<usize> = words_of_motions(&bytes);
            prop_assume!(!digits.is_empty());
            let at = digits[place.index(digits.len())];
            bytes[at] = b'0' + (bytes[at] - b'0' + by) % 10;
            if let Ok(found) = read(&bytes[..], dialect, program.axes()) {
                let compared = compare(&program, &found, &written, &options);
                prop_assert!(matches!(compared, Err(NcError::ReadBackMismatch { .. })),
                    "{:?} at {} of {}", dialect, at, String::from_utf8_lossy(&bytes));
            }
        }
    }
}

/// Places of the digits in G0 and G1 lines but the last of each number, whose neighbour may be as near, and of an F its first two:
/// times are told apart to a millionth only. Lines of a table are left out, whose F is not compared.
fn words_of_motions(bytes: &[u8]) -> Vec<usize> {
    let mut digits = Vec::new();
    let (mut start, mut table) = (0, false);
    for line in bytes.split(|byte| *byte == b'\n') {
        if !table && (line.starts_with(b"G1 ") || line.starts_with(b"G0 ")) {
            let mut at = 2;
            for word in line[2..].split_inclusive(|byte| *byte == b' ') {
                let number = word.iter().position(|byte| *byte == b'=').map_or(1, |equals| equals + 1);
                // An F is told apart to a millionth only.
                let length = if word[0] == b'F' {
                    word.len().min(number + 3)
                } else {
                    word.trim_ascii_end().len().saturating_sub(1)
                };
                let numbers = (number..length).filter(|k| word[*k].is_ascii_digit());
                digits.extend(numbers.map(|k| start + at + k));
                at += word.len();
            }
        }
        table = line.starts_with(b"CTABDEF");
        start += line.len() + 1;
    }
    digits
}

#[test]
fn the_sample_of_the_specification_is_written_digit_by_digit() {
    let degrees = |value: f64| value.to_radians();
    let start = Targets::of_first(&[120.0, -15.0, -25.0, degrees(20.0), 0.0]);
    let target =
        Targets::of_first(&[119.999602, -14.85, -24.75, degrees(20.0), degrees(72.122_476_942_006_4)]);
    let program =
        program(Dialect::LinuxCnc, vec![Block::Rapid(start), Block::Linear { target, duration: 0.05 }]);
    let text = text(&program, Dialect::LinuxCnc);
    let expected = "(GRIND_1)\n\
        G21 G90 G17 G40 G49 G80 G64 P0.000050\n\
        G93\n\
        G0 X120.000000 Y-15.000000 Z-25.000000 A20.0000000 C0.0000000\n\
        G1 X119.999602 Y-14.850000 Z-24.750000 A20.0000000 C72.1224769 F1200.000000\n\
        G94\nM5\nM2\n";
    assert_eq!(text, expected);
}

/// The gear of `docs/mathematics/programs.md#the-independent-reader`: B1 by threads/teeth, Z by the lead, V by a shift.
fn three_leaders() -> Gear {
    let (teeth, threads, module, helix) = (40, 3, 2.0, 20f64.to_radians());
    let leaders = vec![
        GearLeader { axis: WORM, coupling: Coupling::Ratio { num: threads.into(), den: teeth.into() } },
        GearLeader {
            axis: Z,
            coupling: Coupling::Ratio { num: 2.0 * helix.sin(), den: module * f64::from(teeth) },
        },
        GearLeader { axis: Y, coupling: Coupling::Ratio { num: 0.01, den: 1.0 } },
    ];
    let teeth = Some(ToothData { teeth, threads, normal_module: module, helix_angle: helix });
    Gear { follower: C, leaders, teeth }
}

/// Definition, switching on, one stroke, switching off.
fn geared(gear: Gear, synchronisation: Option<GearSynchronisation>) -> Vec<Block> {
    vec![
        Block::GearDefine(Box::new(gear)),
        Block::Spindle { spindle: 0, speed: 10.0 * std::f64::consts::PI },
        Block::GearOn { follower: C, synchronisation: synchronisation.map(Box::new) },
        Block::Linear { target: Targets::NONE.with(Z, 30.0), duration: 2.0 },
        Block::GearOff { follower: C },
    ]
}

#[test]
fn a_gearbox_of_siemens_is_written_as_its_manual_shows() {
    let at = GearSynchronisation { follower: 0.5, leaders: vec![0.0, -25.0, 1.0] };
    let text = text(&program(Dialect::Siemens, geared(three_leaders(), Some(at))), Dialect::Siemens);
    let lead = 2.0 * 20f64.to_radians().sin() * 180.0 / std::f64::consts::PI;
    let expected = format!(
        "; GRIND_1\nG710 G90 G17 G40 G500 G64\nG93\nEGDEL(C2)\nEGDEF(C2, B1, 1, Z1, 1, V1, 1)\nS1=300.000000 M1=3\n\
         EGONSYN(C2, \"FINE\", 28.6478898, B1, 0.0000000, 3, 40, Z1, -25.000000, {lead:.13}, 80, V1, 1.000000, \
         0.572957795130823, 1)\nG1 Z1=30.000000 F30.000000\nEGOFS(C2)\nEGDEL(C2)\nG94\nM1=5\nM30\n"
    );
    assert_eq!(text, expected);
}

#[test]
fn a_gear_of_fanuc_is_told_by_its_bodies_and_its_rounding_is_reported() {
    let mut gear = three_leaders();
    gear.leaders.pop();
    let exact = 20.00004f64.to_radians();
    gear.leaders[1].coupling = Coupling::Ratio { num: 2.0 * exact.sin(), den: 80.0 };
    gear.teeth = Some(ToothData { teeth: 40, threads: 3, normal_module: 2.0, helix_angle: exact });
    let written =
        write_checked(&program(Dialect::Fanuc, geared(gear, None)), Dialect::Fanuc, &WriteOptions::default())
            .unwrap()
            .written;
    let expected = "%\nO0001 (GRIND 1)\nG21 G90 G17 G40 G49 G80\nG93\nS300 M3\nG81 T40 L3 Q2.00000 P20.0000\n\
        G1 Z30.000000 F30.000000\nG80\nG94\nM5\nM30\n%\n";
    assert_eq!(written.text, expected);
    // 4e-5 deg of helix angle: 2 cos(20 deg)/80 rad/mm per rad.
    let expected = 2.0 * 20f64.to_radians().cos() / 80.0 * 4e-5f64.to_radians();
    assert!((written.rounding.lead_ratio / expected - 1.0).abs() < 1e-5, "{:?}", written.rounding);
}

#[test]
fn a_gear_of_linuxcnc_is_a_netlist_beside_the_program() {
    let at = GearSynchronisation { follower: 0.5, leaders: vec![0.0, -25.0, 1.0] };
    let program = program(Dialect::LinuxCnc, geared(three_leaders(), Some(at)));
    let mut options = WriteOptions::default();
    options.linuxcnc.hal = Some(HalOptions { following_error: 0.01f64.to_radians() });
    let written = write_checked(&program, Dialect::LinuxCnc, &options).unwrap().written;
    assert!(written.text.contains("M64 P4\nG1 Z30.000000 F30.000000\nM65 P4\n"), "{}", written.text);
    let hal = written.hal.clone().unwrap();
    // 3/40 of a revolution of the spindle is 27 deg of C.
    assert!(hal.contains("setp gear-c-scale-0.gain 27.0\n"), "{hal}");
    assert!(!hal.contains("encoder_ratio") && hal.contains("wcomp"), "{hal}");
    // A gain, an offset or a wire that is damaged is found.
    let found = read(written.text.as_bytes(), Dialect::LinuxCnc, program.axes()).unwrap();
    for (from, to) in
        [("gain 27.0", "gain 27.1"), ("offset", "offset 1"), ("=> gear-c-sum-0.in1", "=> gear-c-sum-0.in2")]
    {
        assert!(hal.contains(from), "{hal}");
        let mut damaged = written.clone();
        damaged.hal = Some(hal.replacen(from, to, 1));
        assert!(matches!(
            compare(&program, &found, &damaged, &options),
            Err(NcError::ReadBackMismatch { .. })
        ));
    }
}

#[test]
fn a_polynomial_follows_the_formula_of_the_specification() {
    // From X10, PO[X]=(0,-10) is 10 - 10 p^2.
    let text = b"G710 G90\nG93\nG0 X1=10\nPOLY PO[X1]=(0,-10) F60\nM30\n";
    let found = read(&text[..], Dialect::Siemens, &axes(Dialect::Siemens)).unwrap();
    let Block::Cubic(motion) = &found.blocks[1] else { panic!("{:?}", found.blocks) };
    for u in [0.0, 0.3, 1.0] {
        assert!((motion.spans[0].1.value(10.0, u) - (10.0 - 10.0 * u * u)).abs() < 1e-14);
    }
}

#[test]
fn a_plain_program_of_a_user_is_read() {
    let degrees = std::f64::consts::PI / 180.0;
    let cases = [
        (
            Dialect::LinuxCnc,
            "%\nN10 g21 g90 g94 (setup)\nn20 g0x1y2\ng1 x4 y6 f300 ; 5 mm\n x5\nG20 G91 X1 C90\nM30\n%\n",
        ),
        (
            Dialect::Fanuc,
            "%\nO0012\nN10 G21 G90 G94 (SETUP)\nN20 G0X1.Y2.\nG1 X4. Y6. F300\nX5.\nG20 G91 X1. C90.\nM30\n%",
        ),
        (
            Dialect::Siemens,
            "n10 g710 g90 g94 ; setup\r\nG0 X1=1 V1=2\nG1 X1=4 V1=6 F300\nX1=5\nG700 G91 X1=1 C2=IC(90)\nM2",
        ),
    ];
    for (dialect, text) in cases {
        let found = read(text.as_bytes(), dialect, &axes(dialect)).unwrap();
        let motions: Vec<Block> =
            found.blocks.into_iter().filter(|block| !matches!(block, Block::Comment(_))).collect();
        let xy = |x: f64, y: f64| Targets::NONE.with(X, x).with(Y, y);
        let expected = vec![
            Block::Rapid(xy(1.0, 2.0)),
            Block::Linear { target: xy(4.0, 6.0), duration: 1.0 },
            Block::Linear { target: Targets::NONE.with(X, 5.0), duration: 0.2 },
            Block::Linear {
                target: Targets::NONE.with(X, 30.4).with(C, 90.0 * degrees),
                duration: 60.0 * 25.4 / 300.0,
            },
            Block::End,
        ];
        assert_eq!(motions.len(), expected.len(), "{dialect:?} {motions:?}");
        for (a, b) in motions.iter().zip(&expected) {
            match (a, b) {
                (Block::Linear { target: p, duration: s }, Block::Linear { target: q, duration: t }) => {
                    assert!((s - t).abs() < 1e-12, "{a:?}");
                    assert_eq!(p.mask(), q.mask());
                    assert!(p.iter().zip(q.iter()).all(|(a, b)| (a.1 - b.1).abs() < 1e-12));
                }
                _ => assert_eq!(a, b),
            }
        }
    }
}

#[test]
fn what_no_writer_emits_is_refused_with_its_place() {
    use ReadProblem::{
        BadCharacter, BadNumber, Conflict, DegreeNotSupported, End, LineTooLong, Missing, UnknownWord,
    };
    let (l, s, f) = (Dialect::LinuxCnc, Dialect::Siemens, Dialect::Fanuc);
    let long = format!("G1 X1.{}", "0".repeat(600));
    let cases: &[(Dialect, &str, ReadProblem, usize)] = &[
        (l, "G2 X1 Y1 I1 J0", UnknownWord, 1),
        (l, "G1 X1e3 F1", UnknownWord, 6),
        (l, "G93\nG1 X1", Missing, 1),
        (l, "G1 X1 U2 F1", UnknownWord, 7),
        (l, "G43.4", UnknownWord, 1),
        (l, "X1", Missing, 1),
        (l, "G0 G1 X1 F1", Conflict, 4),
        (l, "G0 X1 X2", Conflict, 7),
        (l, "G4 P1 X2", Conflict, 7),
        (l, "G90 Q3", UnknownWord, 5),
        (l, "G90 P3", Conflict, 5),
        (l, "G0 X1 (a (b) c)", Conflict, 7),
        (l, "G0 X1 (a", Missing, 7),
        (l, "G0 X1 \u{e9}", BadCharacter, 7),
        (l, "M3", Missing, 1),
        (l, "#1=3", UnknownWord, 1),
        (l, "M2\nG0 X1", End, 1),
        (l, "G0 X1", End, 1),
        (l, &long, LineTooLong, 257),
        (f, "G0 X1", BadNumber, 4),
        (f, "G81 T40 L3 Q2.", Missing, 1),
        (f, "G81 T0 L3", ReadProblem::OutOfRange, 1),
        (f, "G81 T40 L3\nG81 T40 L3", Conflict, 1),
        (f, "g0 X1.", UnknownWord, 1),
        (f, "G43.4 H1", Missing, 1),
        (s, "G1 X1=1 Q2=3 F1", UnknownWord, 9),
        (s, "TRAORI", End, 1),
        (s, "TRAORI\nTRAORI", Conflict, 1),
        (s, "G1 A3=1 F1", UnknownWord, 4),
        (s, "EGON(C2, \"FINE\", B1, 3, 40)", Conflict, 1),
        (s, "EGDEF(C2, B1, 1", Missing, 1),
        (s, "EGDEF(C2, C2, 1)", ReadProblem::OutOfRange, 1),
        (s, "G93\nG0 X1=0\nPOLY PO[X1]=(1,2,3,4) F1", DegreeNotSupported, 6),
        (s, "G93\nG0 X1=0\nBSPLINE X1=1 SD=4 F1", DegreeNotSupported, 1),
        (s, "G1 X1=1 X1=2 F1", Conflict, 9),
        (s, "PO[X1]=(1)", Conflict, 1),
        (s, "CTABEND", Conflict, 1),
        (s, "CTABDEF(C2, Z1, 1, 0)\nM30", Conflict, 1),
        (s, "R1=3", UnknownWord, 1),
        (s, "WHILE TRUE", UnknownWord, 1),
        (s, &long, LineTooLong, 513),
    ];
    for (dialect, text, problem, column) in cases {
        let error = read(text.as_bytes(), *dialect, &axes(*dialect)).unwrap_err();
        assert_eq!((error.problem, error.column), (*problem, *column), "{text}: {error}");
        assert!(error.line >= 1 && !error.code().is_empty() && !error.way_out().is_empty());
    }
}

/// A text that repeats for ever.
struct Endless<'a> {
    pattern: &'a [u8],
    at: usize,
}

impl Read for Endless<'_> {
    fn read(&mut self, buffer: &mut [u8]) -> std::io::Result<usize> {
        let count = buffer.len().min(self.pattern.len() - self.at);
        buffer[..count].copy_from_slice(&self.pattern[self.at..self.at + count]);
        self.at = (self.at + count) % self.pattern.len();
        Ok(count)
    }
}

#[test]
fn a_text_without_end_is_refused_early() {
    // Far more than memory would hold: one line, and lines of blanks.
    let blanks = [" ".repeat(500), "\n".to_owned()].concat();
    for (pattern, problem) in [("7", ReadProblem::LineTooLong), (&blanks, ReadProblem::TextTooLong)] {
        let endless = BufReader::new(Endless { pattern: pattern.as_bytes(), at: 0 });
        let error = read(endless, Dialect::Siemens, &axes(Dialect::Siemens)).unwrap_err();
        assert_eq!(error.problem, problem);
    }
    let zeros = format!("G0 X{}\nM2\n", "0".repeat(100));
    let error = read(zeros.as_bytes(), Dialect::LinuxCnc, &axes(Dialect::LinuxCnc)).unwrap_err();
    assert_eq!(error.problem, ReadProblem::NumberTooLong);
}

#[test]
fn a_truncated_text_is_refused_or_lacks_its_last_line_end_only() {
    for dialect in Dialect::ALL {
        let program = random(dialect, 7, 40, false);
        let text = text(&program, dialect);
        let whole = read(text.as_bytes(), dialect, program.axes()).unwrap();
        for length in 0..text.len() {
            if let Ok(found) = read(&text.as_bytes()[..length], dialect, program.axes()) {
                assert_eq!(found, whole, "{dialect:?} {length} of {}", text.len());
            }
        }
    }
}

#[test]
fn a_long_block_keeps_its_time() {
    for duration in [119.0, 121.0, 7_200.0, 599_999.0, 6.1e-8] {
        let target = Targets::NONE.with(Z, 1.0);
        let program = program(Dialect::LinuxCnc, vec![Block::Linear { target, duration }]);
        text(&program, Dialect::LinuxCnc);
    }
}

#[test]
fn blocks_that_linuxcnc_cannot_keep_in_time_are_warned_of() {
    // `docs/mathematics/programs.md#the-independent-reader`: a = 5000 deg/s^2, 2.68 deg of way: 81.8 deg/s at most.
    let degrees = |value: f64| Targets::NONE.with(C, value.to_radians());
    let run = |speed: f64| {
        let blocks =
            (0..5).map(|k| Block::Linear { target: degrees(2.68 * f64::from(k)), duration: 2.68 / speed });
        let program = program(Dialect::LinuxCnc, blocks.collect());
        let mut options = WriteOptions::default();
        options.linuxcnc.accelerations = vec![1e5, 1e5, 1e5, 90.0, 5000f64.to_radians(), 90.0];
        write_checked(&program, Dialect::LinuxCnc, &options).unwrap().written.warnings
    };
    assert_eq!(run(81.0), []);
    let warnings = run(83.0);
    let [Warning::TimeNotKept { count: 4, least, .. }] = &warnings[..] else { panic!("{warnings:?}") };
    assert!((2.68 / least - 81.85).abs() < 0.05, "{least}");
    assert!(!warnings[0].to_string().is_empty());
}

/// One program that is wrong, and what it must give.
fn code(dialect: Dialect, blocks: Vec<Block>) -> &'static str {
    let mut blocks = blocks;
    blocks.push(Block::End);
    let written = Program::new(header(dialect), blocks)
        .and_then(|program| write_checked(&program, dialect, &WriteOptions::default()));
    let error = written.unwrap_err();
    assert!(!error.to_string().is_empty() && !error.way_out().is_empty());
    error.code()
}

#[test]
fn every_condition_of_section_7_gives_its_error() {
    let (l, s, f) = (Dialect::LinuxCnc, Dialect::Siemens, Dialect::Fanuc);
    let linear =
        |axis, value, duration| vec![Block::Linear { target: Targets::NONE.with(axis, value), duration }];
    for value in [f64::NAN, f64::INFINITY, 1e6, -1e6] {
        assert_eq!(code(l, linear(X, value, 1.0)), "nc-number-range");
    }
    assert_eq!(code(l, linear(C, 1e8f64.to_radians(), 1.0)), "nc-number-range");
    for duration in [0.0, -1.0, f64::NAN, 1e-8, 6.1e5] {
        assert_eq!(code(l, linear(X, 1.0, duration)), "nc-feed-range");
    }
    for seconds in [0.0, 1e-7, -1.0, f64::NAN, 1e6] {
        assert_eq!(code(l, vec![Block::Dwell(seconds)]), "nc-number-range");
    }
    assert_eq!(code(l, linear(WORM, 1.0, 1.0)), "nc-not-movable");
    assert_eq!(code(l, linear(9, 1.0, 1.0)), "nc-unknown-axis");
    assert_eq!(code(l, vec![Block::Rapid(Targets::NONE)]), "nc-empty-motion");
    assert_eq!(code(l, vec![Block::End]), "nc-end-misplaced");
    assert_eq!(code(l, vec![Block::Spindle { spindle: 8, speed: 1.0 }]), "nc-number-range");
    assert_eq!(code(l, vec![Block::Spindle { spindle: 0, speed: f64::NAN }]), "nc-number-range");
    assert_eq!(code(f, vec![Block::Spindle { spindle: 0, speed: 1.0 }]), "nc-number-range");
    for text in ["", "a(b", "a\u{e9}", "a\nb", " a", "a;b", "a%"] {
        assert_eq!(code(l, vec![Block::Comment(text.into())]), "nc-bad-text", "{text:?}");
    }
    assert_eq!(code(l, vec![Block::Comment("MSG, hello".into())]), "nc-bad-text");
    assert_eq!(code(f, vec![Block::Comment("a + b".into())]), "nc-bad-text");

    // Couplings.
    let two = || {
        let mut gear = three_leaders();
        gear.leaders.pop();
        gear
    };
    let with = |change: &dyn Fn(&mut Gear)| {
        let mut gear = two();
        change(&mut gear);
        geared(gear, None)
    };
    assert_eq!(code(l, with(&|_| {})), "nc-unsupported-coupling");
    assert_eq!(code(f, geared(three_leaders(), None)), "nc-unsupported-coupling");
    assert_eq!(code(f, with(&|gear| gear.teeth = None)), "nc-unsupported-coupling");
    assert_eq!(
        code(f, with(&|gear| gear.leaders[0].coupling = Coupling::Ratio { num: 2.0, den: 40.0 })),
        "nc-unsupported-coupling"
    );
    let bodies = |gear: &mut Gear, teeth: u32, threads: i32, module: f64| {
        let helix = 20f64.to_radians();
        gear.teeth = Some(ToothData { teeth, threads, normal_module: module, helix_angle: helix });
        gear.leaders[0].coupling = Coupling::Ratio { num: threads.into(), den: teeth.into() };
        gear.leaders[1].coupling = Coupling::Ratio { num: 2.0 * helix.sin(), den: module * f64::from(teeth) };
    };
    for (teeth, threads, module) in
        [(1001, 3, 2.0), (40, 22, 2.0), (40, -22, 2.0), (40, 3, 0.05), (40, 3, 26.0)]
    {
        assert_eq!(code(f, with(&|gear| bodies(gear, teeth, threads, module))), "nc-ratio-range");
    }
    assert_eq!(
        code(s, with(&|gear| gear.leaders[0].coupling = Coupling::Ratio { num: 3.0, den: 0.0 })),
        "nc-ratio-range"
    );
    let six = |gear: &mut Gear| {
        let coupling = Coupling::Ratio { num: 1.0, den: 1.0 };
        gear.leaders = [X, Y, Z, A, B, WORM].map(|axis| GearLeader { axis, coupling }).to_vec();
    };
    assert_eq!(code(s, with(&six)), "nc-unsupported-coupling");
    let mut stopped = with(&|_| {});
    stopped.remove(1);
    assert_eq!(code(f, stopped), "nc-spindle-stopped");
    assert_eq!(code(s, vec![Block::GearOn { follower: C, synchronisation: None }]), "nc-gear-state");
    assert_eq!(code(s, vec![Block::GearOff { follower: C }]), "nc-gear-state");
    assert_eq!(code(s, with(&|_| {})[..3].to_vec()), "nc-gear-state");

    // Tables.
    let piece =
        |leader, end| TablePiece { leader, follower: CubicSpan { end, start_slope: 0.0, end_slope: 0.0 } };
    let table = |pieces, repetition| {
        vec![Block::Table(Box::new(CurveTable {
            id: 1,
            follower: C,
            leader: Z,
            start: [0.0; 2],
            pieces,
            repetition,
        }))]
    };
    for pieces in [vec![piece(1.0, 0.0), piece(0.5, 0.0)], vec![piece(0.0, 0.0)], vec![]] {
        assert_eq!(code(s, table(pieces, Repetition::Held)), "nc-bad-table");
    }
    assert_eq!(code(s, table(vec![piece(1.0, 0.1)], Repetition::Leader)), "nc-bad-table");
    assert_eq!(code(s, with(&|gear| gear.leaders[1].coupling = Coupling::Table(9))), "nc-bad-table");
    for dialect in [l, f] {
        assert_eq!(code(dialect, table(vec![piece(1.0, 0.0)], Repetition::Held)), "nc-unsupported-coupling");
    }

    // Curves.
    let start = Block::Rapid(Targets::NONE.with(X, 0.0));
    let point = Targets::NONE.with(X, 1.0);
    let spline = |degree: usize, points: usize, knots: Vec<f64>| {
        let motion = BSplineMotion { degree, points: vec![point; points], knots, duration: 1.0 };
        vec![start.clone(), Block::BSpline(Box::new(motion))]
    };
    assert_eq!(code(s, spline(4, 4, [[0.0; 5], [1.0; 5]].concat())), "nc-degree-not-supported");
    assert_eq!(code(s, spline(3, 3, [[0.0; 4], [0.0; 4]].concat())), "nc-bad-spline");
    assert_eq!(code(s, spline(3, 3, vec![0.0; 3])), "nc-bad-spline");
    assert_eq!(code(l, spline(3, 3, [[0.0; 4], [1.0; 4]].concat())), "nc-block-not-available");
    let span = CubicSpan { end: 1.0, start_slope: 0.0, end_slope: 0.0 };
    let cubic = |axis| Block::Cubic(Box::new(CubicMotion { spans: vec![(axis, span)], duration: 1.0 }));
    assert_eq!(code(f, vec![start.clone(), cubic(X)]), "nc-block-not-available");
    assert_eq!(code(s, vec![start, cubic(Y)]), "nc-unknown-start");
}

#[test]
fn words_lines_and_headers_beyond_a_control_are_refused() {
    let blocks = || vec![Block::Rapid(Targets::of_first(&[1.0; 6])), Block::End];
    let written = |axes: Vec<AxisWord>, dialect, options: &WriteOptions| {
        let header = Header { name: "A".into(), axes, chord_tolerance: 1e-4 };
        Program::new(header, blocks()).and_then(|program| write_checked(&program, dialect, options))
    };
    let letters = |letters: &str| -> Vec<AxisWord> {
        letters
            .chars()
            .map(|letter| AxisWord::letter(&format!("{letter}1"), AxisMotion::Linear, letter))
            .collect()
    };
    let mut stand_alone = WriteOptions::default();
    stand_alone.linuxcnc.stand_alone = true;
    let plain = WriteOptions::default();
    assert!(written(letters("XYZUVW"), Dialect::LinuxCnc, &plain).is_ok());
    assert_eq!(
        written(letters("XYZUVW"), Dialect::LinuxCnc, &stand_alone).unwrap_err().code(),
        "nc-axis-not-available"
    );
    for dialect in [Dialect::LinuxCnc, Dialect::Fanuc] {
        assert_eq!(
            written(axes(Dialect::Siemens), dialect, &plain).unwrap_err().code(),
            "nc-axis-not-available"
        );
    }
    assert_eq!(written(letters("XYZUVX"), Dialect::LinuxCnc, &plain).unwrap_err().code(), "nc-bad-header");
    assert_eq!(written(letters("XYZUVQ"), Dialect::LinuxCnc, &plain).unwrap_err().code(), "nc-bad-header");
    for address in ["R1", "S1", "ABC", "X1234", "A"] {
        let mut axes = axes(Dialect::Siemens);
        axes[0] = AxisWord::named(address, AxisMotion::Linear);
        assert_eq!(written(axes, Dialect::Siemens, &plain).unwrap_err().code(), "nc-bad-header", "{address}");
    }
    let wrong = WriteOptions { decimals: Decimals { mm: 2, deg: 7, feed: 6 }, ..WriteOptions::default() };
    assert_eq!(written(letters("XYZABC"), Dialect::LinuxCnc, &wrong).unwrap_err().code(), "nc-bad-header");

    // Sixteen axes of the greatest numbers do not fit in one line of a cubic.
    let axes: Vec<AxisWord> =
        (0..16).map(|k| AxisWord::named(&format!("AXIS{k}"), AxisMotion::Linear)).collect();
    let header = Header { name: "LONG".into(), axes, chord_tolerance: 1e-4 };
    let span = CubicSpan { end: -123_456.0, start_slope: 1.0, end_slope: 1.0 };
    let motion = CubicMotion { spans: (0..16).map(|axis| (axis, span)).collect(), duration: 1.0 };
    let blocks =
        vec![Block::Rapid(Targets::of_first(&[1.0; 16])), Block::Cubic(Box::new(motion)), Block::End];
    let program = Program::new(header.clone(), blocks).unwrap();
    let error = write_checked(&program, Dialect::Siemens, &plain).unwrap_err();
    assert!(matches!(error, NcError::BlockTooLong { block: 2, limit: 512, .. }), "{error}");

    for (name, tolerance, code) in
        [("a", 1e-4, "nc-bad-text"), ("", 1e-4, "nc-bad-text"), ("A", 0.0, "nc-bad-header")]
    {
        let header = Header { name: name.into(), chord_tolerance: tolerance, ..header.clone() };
        assert_eq!(Program::new(header, vec![Block::End]).unwrap_err().code(), code);
    }
    let seven = split_turns(&stroke(Dialect::LinuxCnc, 3)).unwrap();
    assert_eq!(seven.blocks().len(), 5);
    let modulo = WriteOptions { incremental_rotary: true, ..WriteOptions::default() };
    let far = vec![Block::Rapid(Targets::NONE.with(C, 0.0)), Block::Rapid(Targets::NONE.with(C, 7.0))];
    let far = crate::programs::program(Dialect::Siemens, far);
    assert_eq!(write_checked(&far, Dialect::Siemens, &modulo).unwrap_err().code(), "nc-number-range");
    let near = split_turns(&far).unwrap();
    assert!(write_checked(&near, Dialect::Siemens, &modulo).unwrap().written.text.contains("C2=IC("));
}
