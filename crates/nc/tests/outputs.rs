//! Digital outputs in programs: how every control is told, what its reader refuses, and that a manipulated one is found.

use crate::programs::{A, axes, header, program};
use nc::{
    Block, Dialect, NcError, Program, Targets, WriteOptions, compare, detect_dialect, read, write_checked,
};

fn turn(degrees: f64) -> Block {
    Block::Linear { target: Targets::NONE.with(A, degrees.to_radians()), duration: 2.0 }
}

/// Output 3 is on while A turns.
fn recording(dialect: Dialect) -> Program {
    let output = |on| Block::Output { number: 3, on };
    program(dialect, vec![turn(10.0), output(true), turn(20.0), output(false), turn(0.0)])
}

#[test]
fn every_control_is_told_in_its_own_words() {
    for (dialect, on, off) in [
        (Dialect::LinuxCnc, "\nM62 P3\nG1 A20.", "\nM63 P3\nG1 A0."),
        (Dialect::Siemens, "\nWHEN TRUE DO $A_OUT[3]=1\nG1 A20.", "\nWHEN TRUE DO $A_OUT[3]=0\nG1 A0."),
        (Dialect::Fanuc, "\nG53\n#1103=1\nG1 A20.", "\nG53\n#1103=0\nG1 A0."),
    ] {
        let program = recording(dialect);
        let options = WriteOptions::default();
        let written = write_checked(&program, dialect, &options).unwrap().written;
        let text = &written.text;
        assert!(text.contains(on) && text.contains(off), "{text}");
        assert_eq!(detect_dialect(text.as_bytes()), Some(dialect));

        // Another output, or the other state, is another program.
        let (was, other) = [("P3", "P4"), ("OUT[3]", "OUT[4]"), ("#1103", "#1104")][dialect as usize];
        let (state, opposite) = [("M62", "M63"), ("=1", "=0"), ("=1", "=0")][dialect as usize];
        for changed in [text.replacen(was, other, 1), text.replacen(state, opposite, 1)] {
            assert_ne!(&changed, text);
            let found = read(changed.as_bytes(), dialect, &axes(dialect)).unwrap();
            let error = compare(&program, &found, &written, &options).unwrap_err();
            let NcError::ReadBackMismatch { block: 2, axis, .. } = &error else { panic!("{error}") };
            assert_eq!(&**axis, "digital output");
        }
    }
}

#[test]
fn malformed_outputs_are_refused_with_their_place() {
    let cases: &[(Dialect, &str, &str)] = &[
        (Dialect::LinuxCnc, "G21\nM62\nM2\n", "nc-read-out-of-range"),
        (Dialect::LinuxCnc, "G21\nM62 P16\nM2\n", "nc-read-out-of-range"),
        (Dialect::LinuxCnc, "G21\nM63 P0\nM2\n", "nc-read-out-of-range"),
        (Dialect::LinuxCnc, "G21\nM62 P1.5\nM2\n", "nc-read-out-of-range"),
        (Dialect::LinuxCnc, "G21\nM66 P1\nM2\n", "nc-read-unknown-word"),
        (Dialect::LinuxCnc, "G21\n#1103=1\nM2\n", "nc-read-unknown-word"),
        (Dialect::Siemens, "G710\nWHEN TRUE DO $A_OUT[16]=1\nM30\n", "nc-read-out-of-range"),
        (Dialect::Siemens, "G710\nWHEN TRUE DO $A_OUT[3]=2\nM30\n", "nc-read-out-of-range"),
        (Dialect::Siemens, "G710\nWHEN TRUE DO $A_OUT[3]\nM30\n", "nc-read-missing"),
        (Dialect::Siemens, "G710\nWHEN TRUE DO $A_OUT 3=1\nM30\n", "nc-read-missing"),
        (Dialect::Siemens, "G710\nWHEN TRUE DO $A_OUT[]=1\nM30\n", "nc-read-bad-number"),
        (Dialect::Siemens, "G710\nWHEN TRUE DO $A_OUTA[3]=1\nM30\n", "nc-read-bad-number"),
        (Dialect::Siemens, "G710\nWHEN FALSE DO $A_OUT[3]=1\nM30\n", "nc-read-unknown-word"),
        (Dialect::Siemens, "G710\nWHEN\nM30\n", "nc-read-unknown-word"),
        (Dialect::Siemens, "G710\nWHEN TRUE DO $A_OUT[3]=1 G0 A1\nM30\n", "nc-read-conflict"),
        (Dialect::Siemens, "G710\nG0 A1 WHEN TRUE DO $A_OUT[3]=1\nM30\n", "nc-read-conflict"),
        (Dialect::Siemens, "G710\n$A_OUT[3]=1\nM30\n", "nc-read-unknown-word"),
        (Dialect::Fanuc, "G21\n#1103=1\nM30\n", "nc-read-missing"),
        (Dialect::Fanuc, "G21\nG53\nG90\n#1103=1\nM30\n", "nc-read-missing"),
        (Dialect::Fanuc, "G21\nG53\n#1116=1\nM30\n", "nc-read-out-of-range"),
        (Dialect::Fanuc, "G21\nG53\n#1100=1\nM30\n", "nc-read-out-of-range"),
        (Dialect::Fanuc, "G21\nG53\n#500=1\nM30\n", "nc-read-out-of-range"),
        (Dialect::Fanuc, "G21\nG53\n#1103=0.5\nM30\n", "nc-read-out-of-range"),
        (Dialect::Fanuc, "G21\nG53\n#1103\nM30\n", "nc-read-missing"),
        (Dialect::Fanuc, "G21\nG53\n#=1\nM30\n", "nc-read-bad-number"),
        (Dialect::Fanuc, "G21\nG53\n#1103=1 G0 A1.\nM30\n", "nc-read-conflict"),
        (Dialect::Fanuc, "G21\nG53 G0 A1.\nM30\n", "nc-read-conflict"),
        (Dialect::Fanuc, "G21\nG53\n#1103=1 #1104=1\nM30\n", "nc-read-unknown-word"),
    ];
    for (dialect, text, code) in cases {
        let error = read(text.as_bytes(), *dialect, &axes(*dialect)).unwrap_err();
        assert_eq!(error.code(), *code, "{text}: {error}");
        assert!(error.line >= 2 && !error.allowed.is_empty(), "{text}: {error}");
    }
}

#[test]
fn an_output_needs_a_number_that_all_controls_have_and_a_motion_after_it() {
    let refused = |blocks: &[Block]| {
        let blocks = blocks.iter().cloned().chain([Block::End]).collect();
        Program::new(header(Dialect::Fanuc), blocks).unwrap_err()
    };
    let on = |number| Block::Output { number, on: true };
    for number in [0, 16, 255] {
        let error = refused(&[on(number), turn(1.0)]);
        assert!(matches!(error, NcError::NumberRange { block: 1, .. }), "{error}");
    }
    for blocks in [&[turn(1.0), on(1)][..], &[on(1), Block::Dwell(1.0), on(1), turn(1.0)]] {
        let error = refused(blocks);
        assert_eq!(error.code(), "nc-output-state", "{error}");
        assert!(error.way_out().contains("motion"));
    }
    // Two outputs may go with one motion.
    Program::new(header(Dialect::Fanuc), vec![on(1), on(2), turn(1.0), Block::End]).unwrap();
}
