//! Tool lengths that a control holds, work offsets and coolant: what every control is told, what its reader makes of it, what it refuses,
//! and that a manipulated text is found.

use crate::programs::{A, C, axes, header, program};
use nc::{
    Block, Coolant, Dialect, NcError, OffsetShift, ProbeMove, Program, Targets, WriteOptions, compare,
    detect_dialect, read, write_checked,
};

fn rapid(degrees: f64) -> Block {
    Block::Rapid(Targets::NONE.with(A, degrees.to_radians()))
}

fn shop(dialect: Dialect, offset: u16) -> Program {
    let blocks = vec![
        Block::WorkOffset(offset),
        Block::Tool { number: 4, length_offset: None },
        Block::LengthOffset(Some(7)),
        Block::Coolant(Coolant::Mist),
        Block::Coolant(Coolant::Flood),
        rapid(10.0),
        Block::Coolant(Coolant::Off),
        Block::LengthOffset(None),
        rapid(20.0),
    ];
    program(dialect, blocks)
}

#[test]
fn every_control_is_told_in_its_own_words() {
    for (dialect, offsets, length, none) in [
        (Dialect::LinuxCnc, [(1, "\nG54\n"), (6, "\nG59\n"), (9, "\nG59.3\n")], "\nG43 H7\n", "\nG49\n"),
        (Dialect::Siemens, [(1, "\nG54\n"), (4, "\nG57\n"), (99, "\nG599\n")], "\nD7\n", "\nD0\n"),
        (
            Dialect::Fanuc,
            [(1, "\nG54\n"), (7, "\nG54.1 P1\n"), (306, "\nG54.1 P300\n")],
            "\nG43 H7\n",
            "\nG49\n",
        ),
    ] {
        for (number, words) in offsets {
            let program = shop(dialect, number);
            let options = WriteOptions::default();
            let written = write_checked(&program, dialect, &options).unwrap().written;
            let text = &written.text;
            for wanted in [words, length, none, "\nM7\nM8\n", "\nM9\n"] {
                assert!(text.contains(wanted), "{wanted:?} in {text}");
            }
            assert_eq!(detect_dialect(text.as_bytes()), Some(dialect), "{text}");

            // Another length, another supply or another origin is another program.
            let tool = if dialect == Dialect::Siemens { "D8\n" } else { "G43 H8\n" };
            let other = if number == 1 { "\nG55\n" } else { "\nG54\n" };
            for (was, is) in
                [(&length[1..], tool), ("M7\nM8", "M8\nM7"), (words, other), ("\nM9\n", "\nM8\n")]
            {
                let changed = text.replacen(was, is, 1);
                assert_ne!(&changed, text);
                let found = read(changed.as_bytes(), dialect, &axes(dialect)).unwrap();
                let error = compare(&program, &found, &written, &options).unwrap_err();
                assert!(matches!(error, NcError::ReadBackMismatch { .. }), "{error}");
            }
        }
    }
}

#[test]
fn offsets_that_a_control_does_not_have_are_refused_with_those_that_it_has() {
    for (dialect, number, allowed) in
        [(Dialect::LinuxCnc, 10, "G59.3"), (Dialect::Siemens, 100, "G599"), (Dialect::Fanuc, 307, "P300")]
    {
        let error = write_checked(&shop(dialect, number), dialect, &WriteOptions::default()).unwrap_err();
        let NcError::NumberRange { axis, value, allowed: named, .. } = &error else { panic!("{error}") };
        assert!(
            &**axis == "work offset" && *value == f64::from(number) && named.contains(allowed),
            "{error}"
        );
    }
    let made = |blocks: Vec<Block>| Program::new(header(Dialect::Fanuc), blocks);
    for number in [0, 355] {
        assert!(matches!(
            made(vec![Block::WorkOffset(number), Block::End]),
            Err(NcError::NumberRange { .. })
        ));
    }
    let without_tool = made(vec![Block::LengthOffset(Some(1)), Block::End]);
    assert!(matches!(without_tool, Err(NcError::TipControlState { block: 1, .. })), "{without_tool:?}");
    let tool = Block::Tool { number: 1, length_offset: None };
    let none = made(vec![tool, Block::LengthOffset(Some(0)), Block::End]);
    assert!(matches!(none, Err(NcError::NumberRange { .. })), "{none:?}");
}

#[test]
fn a_siemens_edge_serves_tip_control_or_axis_values() {
    let found = |text: &str| {
        let read = read(text.as_bytes(), Dialect::Siemens, &axes(Dialect::Siemens));
        read.map(|read| read.blocks)
    };
    let tool = |length_offset| Block::Tool { number: 2, length_offset };
    // Behind the tool it lengthens axis values at once; before TRAORI alone it belongs to the tip.
    assert_eq!(found("T2 D1 M6\nM30\n").unwrap()[..2], [tool(Some(1)), Block::LengthOffset(Some(1))]);
    let guided = found("T2 D0 M6\nD1\nTRAORI\nTRAFOOF\nD0\nM30\n").unwrap();
    assert!(
        guided[0] == tool(Some(1)) && !guided.iter().any(|block| matches!(block, Block::LengthOffset(_)))
    );
    for wrong in
        ["T2 M6\nD1 G0\nM30\n", "T2 M6\nD1000\nM30\n", "T2\nM30\n", "G54\nG500\nM30\n", "M7 M8\nM30\n"]
    {
        assert!(found(wrong).is_err(), "{wrong}");
    }
}

#[test]
fn malformed_lines_are_refused() {
    let cases = [
        (Dialect::LinuxCnc, "G43 H1\nM2\n"),
        (Dialect::LinuxCnc, "T1 M6\nG43\nM2\n"),
        (Dialect::LinuxCnc, "T1 M6\nG43 H0\nM2\n"),
        (Dialect::LinuxCnc, "G59.4\nM2\n"),
        (Dialect::LinuxCnc, "M8 M9\nM2\n"),
        (Dialect::Fanuc, "G54.1\nM30\n"),
        (Dialect::Fanuc, "G54.1 P301\nM30\n"),
        (Dialect::Fanuc, "G59.1\nM30\n"),
    ];
    for (dialect, text) in cases {
        let error = read(text.as_bytes(), dialect, &axes(dialect)).unwrap_err();
        assert!(!error.code().is_empty() && !error.way_out().is_empty(), "{text}: {error}");
    }
}

/// C is probed on both sides of 40 degrees, and the work offset follows from it.
fn cycle(dialect: Dialect, number: u16) -> Program {
    let speed = 2f64.to_radians();
    let probe =
        |degrees: f64, slot| Block::Probe(ProbeMove { axis: C, to: degrees.to_radians(), speed, slot });
    let to = |degrees: f64| Block::Rapid(Targets::NONE.with(C, degrees.to_radians()));
    let middle = 40.125f64.to_radians();
    let blocks = vec![
        Block::WorkOffset(number),
        to(40.0),
        probe(47.0, 1),
        to(40.0),
        probe(33.0, 2),
        to(40.0),
        Block::ShiftOffset(OffsetShift { number, axis: C, slots: [1, 2], middle }),
    ];
    program(dialect, blocks)
}

#[test]
fn a_probing_cycle_is_written_and_read_in_the_words_of_every_control() {
    for (dialect, number, words) in [
        (
            Dialect::LinuxCnc,
            2,
            [
                "G94 G38.2 C47.0000000 F120.000\n#101=#5066\n",
                "G10 L2 P2 C[#5246+[#101+#102]/2-[40.1250000]]\n",
            ],
        ),
        (
            Dialect::Siemens,
            6,
            ["STOPRE\nIF $AC_MEA[1]==0\nSETAL(65000)\nENDIF\nR101=$AA_MW[", "+(R101+R102)/2-(40.1250000)\n"],
        ),
        (Dialect::Fanuc, 1, ["G94 G31 C47.0000000 F120.000\n", "]/2.-[40.1250000]]\n"]),
        (Dialect::Fanuc, 9, ["#101=#506", "G90 G10 L20 P3 C["]),
    ] {
        let program = cycle(dialect, number);
        let options = WriteOptions::default();
        let written = write_checked(&program, dialect, &options)
            .unwrap_or_else(|error| panic!("{dialect:?}: {error}"))
            .written;
        let text = &written.text;
        assert!(words.iter().all(|wanted| text.contains(wanted)), "{text}");
        for (was, is) in
            [("40.1250000", "40.1260000"), ("#102", "#103"), ("R102", "R103"), ("F120.000", "F121.000")]
        {
            let changed = text.replace(was, is);
            if changed == *text {
                continue;
            }
            let found = read(changed.as_bytes(), dialect, &axes(dialect)).unwrap();
            let error = compare(&program, &found, &written, &options).unwrap_err();
            assert!(matches!(error, NcError::ReadBackMismatch { .. }), "{error}");
        }
    }
}

#[test]
fn broken_probing_cycles_are_refused() {
    let cases = [
        (Dialect::LinuxCnc, "G0 C1\n#101=#5066\nM2\n"),
        (Dialect::LinuxCnc, "G94 G38.2 C47.0 F120.0\n#101=#5061\nM2\n"),
        (Dialect::LinuxCnc, "G94 G38.2 C47.0 F120.0\n#201=#5066\nM2\n"),
        (Dialect::LinuxCnc, "G94 G38.2 C47.0 F0.0\nM2\n"),
        (Dialect::LinuxCnc, "G10 L2 P2 C[#5226+[#101+#102]/2-[40.0]]\nM2\n"),
        (Dialect::LinuxCnc, "G10 L2 P10 C[#5406+[#101+#102]/2-[40.0]]\nM2\n"),
        (Dialect::LinuxCnc, "G94 G38.2 C47.0 F120.0\nG0 C1\nM2\n"),
        (Dialect::Siemens, "G94 MEAS=1 G1 C2=47.0 F120.0\nM30\n"),
        (Dialect::Siemens, "STOPRE\nM30\n"),
        (Dialect::Siemens, "SETAL(65000)\nM30\n"),
        (Dialect::Siemens, "$P_UIFR[1,C2,TR]=$P_UIFR[2,C2,TR]+(R101+R102)/2-(3.0)\nM30\n"),
        (Dialect::Fanuc, "G90 G10 L2 P7 C[#5345+[#101+#102]/2.-[40.]]\nM30\n"),
    ];
    for (dialect, text) in cases {
        let error = read(text.as_bytes(), dialect, &axes(dialect)).unwrap_err();
        assert!(!error.code().is_empty(), "{text}: {error}");
    }
    let made = |blocks: Vec<Block>| Program::new(header(Dialect::Fanuc), blocks);
    let probe = ProbeMove { axis: C, to: 1.0, speed: 0.1, slot: 1 };
    let stand = Block::Rapid(Targets::NONE.with(C, 0.0));
    let shift = OffsetShift { number: 1, axis: C, slots: [1, 2], middle: 0.0 };
    assert!(made(vec![stand.clone(), Block::Probe(probe), Block::End]).is_ok());
    for wrong in [
        vec![Block::Probe(probe), Block::End],
        vec![stand.clone(), Block::Probe(ProbeMove { slot: 10, ..probe }), Block::End],
        vec![stand.clone(), Block::Probe(ProbeMove { speed: f64::NAN, ..probe }), Block::End],
        vec![stand.clone(), Block::Probe(ProbeMove { to: f64::INFINITY, ..probe }), Block::End],
        vec![stand, Block::Probe(probe), Block::ShiftOffset(shift), Block::End],
    ] {
        assert!(made(wrong).is_err());
    }
}
