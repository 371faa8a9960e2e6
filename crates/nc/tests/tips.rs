//! Five-axis output (`docs/mathematics/programs.md#cutters`): the reference lines character for character, read-back of random programs
//! under tip control in the dialects that have it, cutter locations, damage that is found, every error, and what rounding may add.

use crate::helical_row;
use crate::programs::{B, C, Draw, WORM, X, Z, axes, direction, header, program, tips};
use nc::{
    Angles, AxisMotion, AxisWord, Block, ClCutter, Coupling, Decimals, Dialect, FeedWords, Gear, GearLeader,
    Header, NcError, Orientation, Pace, Program, ReadProblem, Targets, TipControl, TipDecimals, TipMotion,
    WriteOptions, compare, detect_dialect, read, read_cl, rounding_bound, write_checked, write_cl,
    write_cl_checked,
};
use proptest::prelude::*;

const WITH_TIPS: [Dialect; 2] = [Dialect::Siemens, Dialect::Fanuc];

/// Slides X, Y, Z, then C before A, as the reference has its words.
fn trunnion() -> Header {
    let linear = |name: &str, letter| AxisWord::letter(name, AxisMotion::Linear, letter);
    let rotary = |name: &str, letter| AxisWord::letter(name, AxisMotion::Rotary, letter);
    let axes =
        vec![linear("X1", 'X'), linear("Y1", 'Y'), linear("Z1", 'Z'), rotary("C1", 'C'), rotary("A1", 'A')];
    Header { name: "ROW".into(), axes, chord_tolerance: 1e-3 }
}

fn milling() -> WriteOptions {
    WriteOptions {
        decimals: Decimals::MILLING,
        feed_words: FeedWords::AxisBlocks,
        line_numbers: Some(10),
        ..WriteOptions::default()
    }
}

fn tool() -> Vec<Block> {
    let speed = 3000.0 * std::f64::consts::PI / 30.0;
    vec![Block::Tool { number: 5, length_offset: Some(5) }, Block::Spindle { spindle: 0, speed }]
}

/// The row with directions, the first block at the speed that was given before.
fn row_of_tips() -> Program {
    let mut blocks = tool();
    blocks.push(Block::TipControlOn(TipControl::Directions));
    blocks.push(Block::TipSpeed(20.0));
    for (k, (tip, axis)) in helical_row::tips().into_iter().enumerate() {
        let pace =
            k.checked_sub(1).map_or(Pace::Kept, |before| Pace::Speed(helical_row::SPEEDS[before] / 60.0));
        blocks.push(Block::Tip(TipMotion { tip, orientation: Orientation::Direction(axis), pace }));
    }
    blocks.extend([Block::TipControlOff, Block::End]);
    Program::new(trunnion(), blocks).unwrap()
}

/// The row as values of the machine's axes with a time for each block.
fn row_of_axes() -> Program {
    let place = |k: usize| {
        let ([x, y, z], [c, a]) = (helical_row::PLACES[k], helical_row::ANGLES[k]);
        Targets::of_first(&[x, y, z, c.to_radians(), a.to_radians()])
    };
    let mut blocks = vec![Block::Tool { number: 5, length_offset: None }];
    blocks.push(tool().remove(1));
    blocks.push(Block::Rapid(place(0)));
    let feeds = helical_row::FEEDS.iter().enumerate();
    blocks.extend(feeds.map(|(k, feed)| Block::Linear { target: place(k + 1), duration: 60.0 / feed }));
    blocks.push(Block::End);
    Program::new(trunnion(), blocks).unwrap()
}

const CL_LINES: &str = "GOTO/5.20225,73.13135,-9.83138,0.4376903,0.8846147,0.1608850\n\
    GOTO/4.08188,73.20243,-7.33138,0.4240940,0.8912128,0.1608850\n\
    GOTO/2.96055,73.25635,-4.83138,0.4103984,0.8976019,0.1608850\n";
const TRAORI_LINES: &str = "N10 G1 X5.2022 Y73.1313 Z-9.8314 A3=0.437690 B3=0.884615 C3=0.160885\n\
    N20 G1 X4.0819 Y73.2024 Z-7.3314 A3=0.424094 B3=0.891213 C3=0.160885 F1189.9\n\
    N30 G1 X2.9605 Y73.2563 Z-4.8314 A3=0.410398 B3=0.897602 C3=0.160885 F1189.9\n";
const AXIS_LINES: &str = "N10 G94 G0 X-27.7686 Y-28.7287 Z23.4326 C26.32532 A80.74173\n\
    N20 G93 G1 X-27.7686 Y-31.1961 Z23.8348 C25.44799 A80.74173 F434.175\n\
    N30 G93 G1 X-27.7686 Y-33.6635 Z24.2370 C24.57066 A80.74173 F434.175\n";

#[test]
fn the_reference_lines_come_out_character_for_character() {
    let text = write_checked(&row_of_tips(), Dialect::Siemens, &milling()).unwrap().written.text;
    let head = "; ROW\nG710 G90 G17 G40 G500 G64\nG93\nT5 D0 M6\nS1=3000.000000 M1=3\nD5\nTRAORI\nORIWKS\nG94 F1200.0\n";
    assert!(text.starts_with(&[head, TRAORI_LINES].concat()), "{text}");
    assert!(text.ends_with("F1189.9\nTRAFOOF\nD0\nG94\nM1=5\nM30\n"), "{text}");
    for dialect in Dialect::ALL {
        let text = write_checked(&row_of_axes(), dialect, &milling()).unwrap().written.text;
        assert!(text.contains(AXIS_LINES), "{text}");
    }
    let cutter = ClCutter { diameter: 5.0, corner_radius: 1.0, cutting_length: 20.0 };
    let text = write_cl_checked(&row_of_tips(), Some(&cutter)).unwrap();
    let without_feeds: String =
        text.lines().filter(|line| line.starts_with("GOTO")).map(|line| format!("{line}\n")).collect();
    assert!(without_feeds.starts_with(CL_LINES), "{text}");
    let head = "PARTNO/ROW\nUNITS/MM\nTOOL/MILL,5.00000,1.00000,20.00000\nLOADTL/5,OSETNO,5\n\
        SPINDL/RPM,3000.000000,CLW\nMULTAX/ON\nFEDRAT/1200.0000,MMPM\nGOTO/";
    assert!(text.starts_with(head) && text.ends_with("\nMULTAX/OFF\nFINI\n"), "{text}");
}

#[test]
fn fanuc_is_told_tips_by_directions_and_by_angles() {
    let text = write_checked(&row_of_tips(), Dialect::Fanuc, &milling()).unwrap().written.text;
    let lines = TRAORI_LINES.replace("A3=", "I").replace("B3=", "J").replace("C3=", "K");
    let head = "T5 M6\nS3000 M3\nG43.5 H5\nG94 F1200.0\n";
    assert!(text.contains(&[head, &lines].concat()) && text.contains("\nG49\nG94\nM5\nM30\n%\n"), "{text}");

    let [c, a] = helical_row::ANGLES[0].map(f64::to_radians);
    let (tip, _) = helical_row::tips()[0];
    let orientation = Orientation::Angles(Angles::new(&[(3, c), (4, a)]).unwrap());
    let mut blocks = tool();
    blocks.push(Block::TipControlOn(TipControl::Angles));
    blocks.push(Block::Tip(TipMotion { tip, orientation, pace: Pace::Rapid }));
    blocks.push(Block::Tip(TipMotion { tip, orientation, pace: Pace::Duration(0.5) }));
    blocks.push(Block::Tip(TipMotion { tip, orientation: Orientation::Kept, pace: Pace::Speed(10.0) }));
    blocks.extend([Block::TipControlOff, Block::End]);
    let program = Program::new(trunnion(), blocks).unwrap();
    let words = "X5.2022 Y73.1313 Z-9.8314 C26.32532 A80.74173";
    let wanted =
        format!("N10 G0 {words}\nN20 G1 {words} F120.000\nN30 G94 G1 X5.2022 Y73.1313 Z-9.8314 F600.0\n");
    for (dialect, head) in [(Dialect::Fanuc, "G43.4 H5\n"), (Dialect::Siemens, "TRAORI\nORIMKS\n")] {
        let text = write_checked(&program, dialect, &milling()).unwrap().written.text;
        assert!(text.contains(&[head, &wanted].concat()), "{text}");
    }
}

#[test]
fn linuxcnc_has_no_tip_control_and_says_what_to_do() {
    let error = write_checked(&row_of_tips(), Dialect::LinuxCnc, &milling()).unwrap_err();
    assert_eq!(error, NcError::TipControlNotAvailable { block: 3 });
    assert!(error.way_out().contains("G93"), "{}", error.way_out());
    let offset = Program::new(trunnion(), [tool(), vec![Block::End]].concat()).unwrap();
    let error = write_checked(&offset, Dialect::LinuxCnc, &milling()).unwrap_err();
    assert_eq!(error.code(), "nc-block-not-available");
    let mut blocks = row_of_tips().blocks().to_vec();
    blocks[0] = Block::Tool { number: 5, length_offset: None };
    let refused = Program::new(trunnion(), blocks).unwrap_err();
    assert_eq!(refused.code(), "nc-tip-control-state", "tip control needs an offset");
    let blocks: Vec<Block> =
        row_of_tips().blocks().iter().filter(|block| !matches!(block, Block::Tool { .. })).cloned().collect();
    assert_eq!(Program::new(trunnion(), blocks).unwrap_err().code(), "nc-tip-control-state");
}

fn options(seed: u64) -> WriteOptions {
    let mut draw = Draw::new(seed);
    WriteOptions {
        decimals: Decimals {
            mm: 3 + draw.below(7) as u8,
            deg: 3 + draw.below(7) as u8,
            feed: 3 + draw.below(7) as u8,
        },
        tip_decimals: TipDecimals { speed: 1 + draw.below(6) as u8, direction: 4 + draw.below(6) as u8 },
        feed_words: if draw.below(2) == 0 { FeedWords::OnChange } else { FeedWords::AxisBlocks },
        line_numbers: (draw.below(2) == 0).then(|| 1 + draw.below(1000) as u32),
        ..WriteOptions::default()
    }
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, cases: 200, ..ProptestConfig::default() })]

    #[test]
    fn random_programs_under_tip_control_read_back(seed in any::<u64>()) {
        let options = options(seed);
        for dialect in WITH_TIPS {
            let program = tips(dialect, seed, 60, true);
            let written = write_checked(&program, dialect, &options).unwrap().written;
            prop_assert!(written.text.is_ascii() && !written.text.lines().any(|line| line.ends_with(' ')));
            prop_assert_eq!(detect_dialect(written.text.as_bytes()), Some(dialect));
            // What was read is a program itself and writes the same text but for times, which are inverses of feeds.
            let found = read(written.text.as_bytes(), dialect, program.axes()).unwrap();
            let again = Program::new(header(dialect), found.blocks).unwrap();
            write_checked(&again, dialect, &options).unwrap();
        }
    }

    #[test]
    fn random_cutter_locations_read_back(seed in any::<u64>(), diameter in 1e-3..1e3f64, share in 0.0..=0.5f64) {
        let program = tips(Dialect::Siemens, seed, 60, false);
        let cutter = ClCutter { diameter, corner_radius: share * diameter, cutting_length: 3.0 * diameter };
        let text = write_cl_checked(&program, Some(&cutter)).unwrap();
        let found = read_cl(text.as_bytes()).unwrap();
        let again = Program::new(program.header().clone(), found.blocks).unwrap();
        prop_assert_eq!(write_cl_checked(&again, found.cutter.as_ref()).unwrap().lines().count(), text.lines().count());
        prop_assert!(write_cl_checked(&program, None).unwrap().len() < text.len());
    }

    #[test]
    fn a_changed_digit_of_a_tip_is_a_mismatch_or_refused(seed in any::<u64>(), place in any::<prop::sample::Index>(), by in 1u8..9) {
        let options = options(seed);
        for dialect in WITH_TIPS {
            let program = tips(dialect, seed, 30, true);
            let written = write_checked(&program, dialect, &options).unwrap().written;
            let mut bytes = written.text.clone().into_bytes();
            let digits = digits_of_tips(&written.text);
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

/// Places of the digits of X to K in straight blocks under tip control but the last digit of each number, whose neighbour may be as
/// near.
fn digits_of_tips(text: &str) -> Vec<usize> {
    let (mut digits, mut start, mut on) = (Vec::new(), 0, false);
    for line in text.lines() {
        on |= line.starts_with("TRAORI") || line.starts_with("G43.");
        on &= !line.starts_with("TRAFOOF") && !line.starts_with("G49");
        if on && (line.contains("G1 ") || line.contains("G0 ")) && !line.starts_with(['(', ';']) {
            let mut at = 0;
            for word in line.split_inclusive(' ') {
                let number = word.find('=').map_or(1, |equals| equals + 1);
                let end = word.trim_end().len() - 1;
                if !word.starts_with(['G', 'N', 'F']) {
                    let bytes = word.as_bytes();
                    digits
                        .extend((number..end).filter(|k| bytes[*k].is_ascii_digit()).map(|k| start + at + k));
                }
                at += word.len();
            }
        }
        start += line.len() + 1;
    }
    digits
}

#[test]
fn a_truncated_text_under_tip_control_is_refused() {
    for dialect in WITH_TIPS {
        let program = tips(dialect, 3, 30, true);
        let text = write_checked(&program, dialect, &WriteOptions::default()).unwrap().written.text;
        let whole = read(text.as_bytes(), dialect, program.axes()).unwrap();
        for length in 0..text.len() {
            if let Ok(found) = read(&text.as_bytes()[..length], dialect, program.axes()) {
                assert_eq!(found, whole, "{dialect:?} {length} of {}", text.len());
            }
        }
    }
    let text = write_cl(&row_of_tips(), None).unwrap();
    for length in 0..text.len() - 1 {
        assert!(read_cl(&text.as_bytes()[..length]).is_err(), "{length} of {}", text.len());
    }
}

#[test]
fn what_a_control_would_not_take_the_reader_refuses() {
    use ReadProblem::{BadNumber, Conflict, End, Missing, OutOfRange, UnknownWord};
    let (s, f) = (Dialect::Siemens, Dialect::Fanuc);
    let on = |dialect| if dialect == s { "G90\nT1 D1 M6\nTRAORI\n" } else { "G90\nT1 M6\nG43.5 H1\n" };
    let cases = [
        // In inverse time every block that cuts has its F.
        (s, "G93 G1 X1 Y2 Z3 A3=0 B3=0 C3=1\n", Missing),
        (s, "G93\nG1 X1 Y2 Z3 C3=1 F2\nX2\n", Missing),
        (f, "G93 G1 X1. Y2. Z3. K1.\n", Missing),
        (f, "G93\nG1 X1. Y2. Z3. K1. F2.\nX2.\n", Missing),
        // A feed per minute does not outlive another kind.
        (s, "G94 G1 X1 Y2 Z3 C3=1 F2\nG93 X2 F3\nG94 X3\n", Missing),
        (f, "G94 G1 X1. Y2. Z3. K1. F2.\nG93 X2. F3.\nG94 X3.\n", Missing),
        (s, "G94 G1 X1 Y2 Z3 C3=1\n", Missing),
        (s, "G0 X1 Y2 C3=1\n", Missing),
        (s, "X1 Y2 Z3\n", Missing),
        (s, "G0 X1 Y2 Z3 A3=0 B3=0 C3=0\n", OutOfRange),
        (s, "G0 X1 Y2 Z3 A3=NAN\n", BadNumber),
        (s, "G0 XNAN Y2 Z3\n", UnknownWord),
        (s, "G0 X1 Y2 Z3 A3=1e3\n", UnknownWord),
        (s, "G0 X1 Y2 Z3 A3=1 A3=1\n", Conflict),
        (s, "G0 X1 Y2 Z3 A3=1 C2=3\n", Conflict),
        (s, "G0 X1 Y2 Z3 A3=1\nC2=3\n", Conflict),
        (s, "G0 X1 Y2 Z3 C2=IC(3)\n", Conflict),
        (s, "G0 X1 Y2 Z3 X1=3\n", Conflict),
        (s, "G91 G0 X1 Y2 Z3\n", Conflict),
        (s, "ORIMKS\nG0 X1 Y2 Z3 A3=1\n", Conflict),
        (s, "G0 X1 Y2 Z3 TRAFOOF\n", Conflict),
        (s, "TRAFOOF G0\n", Conflict),
        (s, "T2 D1 M6\n", Conflict),
        (s, "EGDEL(C2)\n", Conflict),
        (s, "POLY PO[X1]=(1,2) F1\n", Missing),
        (f, "G0 X1 Y2. Z3.\n", BadNumber),
        (f, "G0 X1. Y2. Z3. I.\n", BadNumber),
        (f, "G0 X1. Y2. Z3. C3.\n", Conflict),
        (f, "G49 X1.\n", Conflict),
        (f, "G43.4 H1\n", Conflict),
        (f, "T2 M6\n", Conflict),
        (f, "G81 T40 L3\n", Conflict),
        (f, "G0 X1. Y2. Z3. J1. Q3.\n", Conflict),
    ];
    for (dialect, lines, problem) in cases {
        let text = [on(dialect), lines, "M30\n"].concat();
        let error = read(text.as_bytes(), dialect, &axes(dialect)).unwrap_err();
        assert_eq!(error.problem, problem, "{text}: {error}");
        assert!(error.line >= 3 && !error.code().is_empty() && !error.way_out().is_empty(), "{error}");
    }
    for (dialect, text, problem) in [
        (s, "T1\n", Missing),
        (s, "M6\n", Missing),
        (s, "T1 D1000 M6\n", OutOfRange),
        (s, "ORIWKS\n", Missing),
        (f, "G43.5 H1\n", Missing),
        (f, "T1 M6\nG43.5\n", Missing),
        (f, "T1 M6\nG43.5 H0\n", Missing),
        (f, "T1 M6\nG43.5 H1\nG49\nG43.5 H2\n", Conflict),
        (f, "T1 M6\nG43.5 H1 X1.\n", Conflict),
        (f, "G0 X1. I1.\n", UnknownWord),
        (Dialect::LinuxCnc, "T1\nM2\n", Conflict),
        (Dialect::LinuxCnc, "M6\nM2\n", Missing),
        // Where tip control has left the axes no text says.
        (s, "T1 D1 M6\nTRAORI\nTRAFOOF\nG94 G1 X1=3 F3\n", Missing),
        (s, "T1 D1 M6\nTRAORI\nTRAFOOF\nG0 C2=IC(3)\n", Missing),
        (s, "T1 D1 M6\nTRAORI\n", End),
    ] {
        let error = read(text.as_bytes(), dialect, &axes(dialect)).unwrap_err();
        assert_eq!(error.problem, problem, "{text}: {error}");
    }
}

#[test]
fn a_program_of_a_user_under_tip_control_is_read() {
    let text = "n10 g90 g94\nT=3 D=1 M6\nG0 X1=0 C2=0\ntraori\nG1 X1 Y2 Z3 A3=3 C3=4 F600\nX2 ; ON\nG0 Z4 F60\nG1 B3=-1\nF120\nX5\nTRAFOOF\nM30\n";
    let found = read(text.as_bytes(), Dialect::Siemens, &axes(Dialect::Siemens)).unwrap();
    let tip = |tip, orientation, pace| Block::Tip(TipMotion { tip, orientation, pace });
    let start = Targets::NONE.with(X, 0.0).with(C, 0.0);
    let expected = [
        Block::Tool { number: 3, length_offset: Some(1) },
        Block::LengthOffset(Some(1)),
        Block::Rapid(start),
        Block::TipControlOn(TipControl::Directions),
        tip([1.0, 2.0, 3.0], Orientation::Direction([0.6, 0.0, 0.8]), Pace::Speed(10.0)),
        Block::Comment("ON".into()),
        tip([2.0, 2.0, 3.0], Orientation::Kept, Pace::Kept),
        Block::TipSpeed(1.0),
        tip([2.0, 2.0, 4.0], Orientation::Kept, Pace::Rapid),
        tip([2.0, 2.0, 4.0], Orientation::Direction([0.0, -1.0, 0.0]), Pace::Kept),
        Block::TipSpeed(2.0),
        tip([5.0, 2.0, 4.0], Orientation::Kept, Pace::Kept),
        Block::TipControlOff,
        Block::End,
    ];
    let near = |a: &Block, b: &Block| match (a, b) {
        (Block::Tip(a), Block::Tip(b)) => {
            let directions = match (a.orientation, b.orientation) {
                (Orientation::Direction(a), Orientation::Direction(b)) => {
                    a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-15)
                }
                (a, b) => a == b,
            };
            directions && (a.tip, a.pace) == (b.tip, b.pace)
        }
        _ => a == b,
    };
    assert_eq!(found.blocks.len(), expected.len(), "{:?}", found.blocks);
    found.blocks.iter().zip(&expected).for_each(|(a, b)| assert!(near(a, b), "{a:?} {b:?}"));
}

/// The code of a program that is wrong.
fn code(dialect: Dialect, blocks: Vec<Block>) -> &'static str {
    let blocks = [blocks, vec![Block::End]].concat();
    let written = Program::new(header(dialect), blocks)
        .and_then(|program| write_checked(&program, dialect, &WriteOptions::default()));
    let error = written.unwrap_err();
    assert!(!error.to_string().is_empty() && !error.way_out().is_empty());
    error.code()
}

#[test]
fn every_wrong_program_under_tip_control_gives_its_error() {
    let (s, state, range) = (Dialect::Siemens, "nc-tip-control-state", "nc-number-range");
    let under = |control, blocks: Vec<Block>| {
        [tool(), vec![Block::TipControlOn(control)], blocks, vec![Block::TipControlOff]].concat()
    };
    let motion = |tip, orientation, pace| vec![Block::Tip(TipMotion { tip, orientation, pace })];
    let up = Orientation::Direction([0.0, 0.0, 1.0]);
    let angles = |words: &[(usize, f64)]| Orientation::Angles(Angles::new(words).unwrap());
    let (by_directions, by_angles) = (TipControl::Directions, TipControl::Angles);
    let wrong = |tip, orientation, pace| code(s, under(by_directions, motion(tip, orientation, pace)));
    for bad in [f64::NAN, f64::INFINITY, 1e6] {
        assert_eq!(wrong([0.0, bad, 0.0], up, Pace::Rapid), range);
        assert_eq!(wrong([0.0; 3], Orientation::Direction([bad, 0.0, 0.0]), Pace::Rapid), range);
        assert_eq!(
            code(s, under(by_angles, motion([0.0; 3], angles(&[(C, 1e3 * bad)]), Pace::Rapid))),
            range
        );
    }
    assert_eq!(wrong([0.0; 3], Orientation::Direction([0.0; 3]), Pace::Rapid), range);
    assert_eq!(wrong([0.0; 3], Orientation::Direction([0.0, 0.0, 1.01]), Pace::Rapid), range);
    for bad in [0.0, -1.0, 1e-3, 1e6, f64::NAN] {
        assert_eq!(wrong([0.0; 3], up, Pace::Speed(bad)), range);
        assert_eq!(code(s, under(by_directions, vec![Block::TipSpeed(bad)])), range);
    }
    for bad in [0.0, -1.0, f64::NAN, 1e-9] {
        assert_eq!(wrong([0.0; 3], up, Pace::Duration(bad)), "nc-feed-range");
    }
    assert_eq!(wrong([0.0; 3], up, Pace::Kept), state);
    assert_eq!(wrong([0.0; 3], Orientation::Kept, Pace::Rapid), state);
    assert_eq!(wrong([0.0; 3], angles(&[(C, 0.0)]), Pace::Rapid), state);
    let lost = [motion([0.0; 3], up, Pace::Speed(1.0)), motion([0.0; 3], up, Pace::Duration(1.0))].concat();
    let lost = [lost, motion([0.0; 3], up, Pace::Kept)].concat();
    assert_eq!(code(s, under(by_directions, lost)), state);
    let by = |orientation| code(s, under(by_angles, motion([0.0; 3], orientation, Pace::Rapid)));
    assert_eq!(by(up), state);
    assert_eq!(by(angles(&[(X, 0.0)])), state);
    assert_eq!(by(angles(&[(9, 0.0)])), "nc-unknown-axis");
    assert_eq!(by(angles(&[(WORM + 1, 0.0)])), "nc-not-movable");
    // The order of the blocks.
    let target = Targets::NONE.with(X, 1.0);
    for block in [
        Block::Rapid(target),
        Block::Linear { target, duration: 1.0 },
        Block::Tool { number: 1, length_offset: None },
        Block::GearOff { follower: C },
        Block::TipControlOn(by_angles),
    ] {
        assert_eq!(code(s, under(by_directions, vec![block])), state);
    }
    assert_eq!(code(s, vec![Block::TipControlOff]), state);
    assert_eq!(code(s, vec![Block::TipSpeed(1.0)]), state);
    assert_eq!(code(s, motion([0.0; 3], up, Pace::Rapid)), state);
    assert_eq!(code(s, [tool(), vec![Block::TipControlOn(by_angles)]].concat()), state);
    assert_eq!(code(s, vec![Block::TipControlOn(by_angles)]), state);
    for (number, length_offset) in [(0, None), (100_000_000, None), (1, Some(0)), (1, Some(1000))] {
        assert_eq!(code(s, vec![Block::Tool { number, length_offset }]), range);
    }
    // Under a gear; a Siemens program of one is refused by the reader too.
    let leaders = vec![GearLeader { axis: Z, coupling: Coupling::Ratio { num: 1.0, den: 2.0 } }];
    let gear = Gear { follower: C, leaders, teeth: None };
    let on = [Block::GearDefine(Box::new(gear)), Block::GearOn { follower: C, synchronisation: None }];
    assert_eq!(code(s, [on.to_vec(), under(by_directions, vec![])].concat()), state);
    let text = "T1 D1 M6\nEGDEF(C2, Z1, 1)\nEGON(C2, \"FINE\", Z1, 1, 2)\nTRAORI\nM30\n";
    assert_eq!(read(text.as_bytes(), s, &axes(s)).unwrap_err().problem, ReadProblem::Conflict);
    // Words that are directions under tip control.
    let mut named = header(s);
    named.axes[B] = AxisWord::named("C3", AxisMotion::Rotary);
    let blocks = [under(by_directions, vec![]), vec![Block::End]].concat();
    let program = Program::new(named, blocks).unwrap();
    let refused = write_checked(&program, s, &WriteOptions::default()).unwrap_err();
    assert_eq!(refused.code(), "nc-axis-not-available");
    // Options out of range, and what tip control cannot do with modulo axes.
    let row = tips(s, 1, 30, true);
    for change in [
        |o: &mut WriteOptions| o.tip_decimals.direction = 3,
        |o: &mut WriteOptions| o.tip_decimals.speed = 0,
        |o: &mut WriteOptions| o.line_numbers = Some(0),
        |o: &mut WriteOptions| o.decimals.feed = 2,
    ] {
        let mut options = WriteOptions::default();
        change(&mut options);
        assert_eq!(write_checked(&row, s, &options).unwrap_err().code(), "nc-bad-header");
    }
    let modulo = WriteOptions { incremental_rotary: true, ..WriteOptions::default() };
    let turned = under(by_angles, motion([0.0; 3], angles(&[(C, 0.0)]), Pace::Rapid));
    let refused = write_checked(&program_of(s, turned), s, &modulo).unwrap_err();
    assert_eq!(refused.code(), "nc-block-not-available");
    write_checked(&program_of(s, under(by_directions, motion([0.0; 3], up, Pace::Rapid))), s, &modulo)
        .unwrap();
    let numbered = WriteOptions { line_numbers: Some(1000), ..WriteOptions::default() };
    let many = vec![Block::Rapid(target); 100_000];
    assert_eq!(write_checked(&program_of(s, many), s, &numbered).unwrap_err().code(), range);
}

fn program_of(dialect: Dialect, blocks: Vec<Block>) -> Program {
    program(dialect, blocks)
}

#[test]
fn cutter_locations_hold_tips_and_directions_only() {
    let code = |program: &Program| write_cl(program, None).unwrap_err().code();
    assert_eq!(code(&row_of_axes()), "nc-block-not-available");
    let s = Dialect::Siemens;
    let angles = [tool(), vec![Block::TipControlOn(TipControl::Angles), Block::TipControlOff]].concat();
    assert_eq!(code(&program_of(s, angles)), "nc-block-not-available");
    assert_eq!(
        code(&program_of(s, vec![Block::Spindle { spindle: 1, speed: 1.0 }])),
        "nc-block-not-available"
    );
    assert_eq!(code(&program_of(s, vec![Block::Comment("1 $ OR 2".into())])), "nc-bad-text");
    for (diameter, corner_radius, cutting_length) in [(0.0, 0.0, 1.0), (1.0, 0.6, 1.0), (1.0, 0.1, f64::NAN)]
    {
        let cutter = ClCutter { diameter, corner_radius, cutting_length };
        assert_eq!(write_cl(&row_of_tips(), Some(&cutter)).unwrap_err().code(), "nc-number-range");
    }
}

#[test]
fn cutter_locations_of_others_are_read_or_refused_with_their_place() {
    use ReadProblem::{
        BadCharacter, BadNumber, Conflict, End, LineTooLong, Missing, OutOfRange, UnknownWord,
    };
    let text = "$$ MADE BY HAND\npartno ROW 7\nUNITS / MM\r\nLOADTL/3\nSPINDL/ RPM, 100, CCLW\nMULTAX/ON\nFEDRAT/MMPM, 60\n\
        GOTO/ 1, 2, 3, 0, 0, 2 $$ HOLDER UP\nRAPID\nGOTO/1,2,4\nGOTO/1,2,5\nFEDRAT/30,INVERS\nGOTO/1.,2,6\nMULTAX/OFF\nSTOP\nFINI\n\n";
    let found = read_cl(text.as_bytes()).unwrap();
    assert_eq!(found.name.as_deref(), Some("ROW_7"));
    let tip = |z, orientation, pace| Block::Tip(TipMotion { tip: [1.0, 2.0, z], orientation, pace });
    let (kept, speed) = (Orientation::Kept, Pace::Speed(1.0));
    let expected = [
        Block::Tool { number: 3, length_offset: None },
        Block::Spindle { spindle: 0, speed: -100.0 * std::f64::consts::PI / 30.0 },
        Block::TipControlOn(TipControl::Directions),
        tip(3.0, Orientation::Direction([0.0, 0.0, 1.0]), speed),
        tip(4.0, kept, Pace::Rapid),
        tip(5.0, kept, speed),
        tip(6.0, kept, Pace::Duration(2.0)),
        Block::TipControlOff,
        Block::Stop,
        Block::End,
    ];
    assert_eq!(found.blocks, expected);
    let head = "UNITS/MM\nMULTAX/ON\nRAPID\n";
    let long = format!("GOTO/{}", "1,".repeat(300));
    for (line, problem) in [
        ("GOTO/NAN,2,3,0,0,1", UnknownWord),
        ("GOTO/1,,3,0,0,1", BadNumber),
        ("GOTO/1e3,2,3,0,0,1", Conflict),
        ("GOTO/1,2,3", Missing),
        ("GOTO/1,2,3,0,0", Missing),
        ("GOTO/1,2,3,0,0,0", OutOfRange),
        ("GOTO/1,2,3,0,0,1,2", Conflict),
        ("GOTO/1,2,3,0,0,1\nGOTO/1,2,3,0,0,1", Missing),
        ("FEDRAT/30,INVERS\nGOTO/1,2,3,0,0,1\nGOTO/1,2,3\nGOTO/1,2,3", Missing),
        ("GOTO/1;2", Conflict),
        ("GOTO", UnknownWord),
        ("CIRCLE/1,2,3", UnknownWord),
        ("UNITS/INCHES", OutOfRange),
        ("FEDRAT/0,MMPM", OutOfRange),
        ("FEDRAT/10", Missing),
        ("MULTAX/ON", Conflict),
        ("LOADTL/1", Conflict),
        ("SPINDL/100", Missing),
        ("TOOL/MILL,5,3,10", OutOfRange),
        ("DELAY/0", OutOfRange),
        ("FINI\nSTOP", End),
        ("GOTO/1,2,\u{e9}", BadCharacter),
        (&long, LineTooLong),
    ] {
        let text = [head, line, "\nFINI\n"].concat();
        let error = read_cl(text.as_bytes()).unwrap_err();
        assert_eq!(error.problem, problem, "{line}: {error}");
        assert!(error.line >= 4, "{error}");
    }
    for text in ["", "FINI\nFINI", "GOTO/1,2,3,0,0,1\nFINI", "MULTAX/ON\nRAPID\nGOTO/1,2,3,0,0,1\nFINI"] {
        assert!(read_cl(text.as_bytes()).is_err(), "{text}");
    }
}

/// Rotation about x or z.
fn turned(axis: usize, angle: f64, [x, y, z]: [f64; 3]) -> [f64; 3] {
    let (sin, cos) = angle.sin_cos();
    if axis == 0 {
        [x, cos * y - sin * z, sin * y + cos * z]
    } else {
        [cos * x - sin * y, sin * x + cos * y, z]
    }
}

fn distance(a: [f64; 3], b: [f64; 3]) -> f64 {
    a.iter().zip(b).map(|(a, b)| (a - b) * (a - b)).sum::<f64>().sqrt()
}

/// The tip on the workpiece of a trunnion A that carries C, whose axes meet the point q:
/// `docs/mathematics/milling.md#positions-of-five-axes` backwards.
fn on_workpiece(place: &Targets, q: [f64; 3]) -> [f64; 3] {
    let [x, y, z, c, a] = [0, 1, 2, 3, 4].map(|axis| place.get(axis).unwrap());
    let from_q = [x - q[0], y - q[1], z - q[2]];
    let [x, y, z] = turned(0, -a, from_q);
    turned(2, -c, [x + q[0], y + q[1], z + q[2]])
}

#[test]
fn rounding_adds_no_more_than_is_stated_for_axis_values() {
    let mut draw = Draw::new(21);
    let q = [0.0, 0.0, -50.0];
    let (mut share, options) = (0.0f64, milling());
    for _ in 0..40 {
        let mut blocks = Vec::new();
        let mut reach = 0.0f64;
        for _ in 0..500 {
            let place: [f64; 5] =
                std::array::from_fn(|k| draw.between(-1.0, 1.0) * if k < 3 { 90.0 } else { 3.0 });
            let target = Targets::of_first(&place);
            let on = on_workpiece(&target, q);
            reach = reach.max((on[0] * on[0] + on[1] * on[1]).sqrt());
            reach = reach.max((place[1] * place[1] + (place[2] + 50.0) * (place[2] + 50.0)).sqrt());
            blocks.push(Block::Linear { target, duration: 1.0 });
        }
        blocks.push(Block::End);
        let program = Program::new(trunnion(), blocks).unwrap();
        let bound = rounding_bound(&program, &options, reach, 0.0).unwrap();
        let text = write_checked(&program, Dialect::Siemens, &options).unwrap().written.text;
        let found = read(text.as_bytes(), Dialect::Siemens, program.axes()).unwrap();
        let mut places = Targets::NONE;
        for (wanted, found) in program.blocks().iter().zip(&found.blocks) {
            let (Block::Linear { target: a, .. }, Block::Linear { target: b, .. }) = (wanted, found) else {
                break;
            };
            places.update(b);
            let off = distance(on_workpiece(a, q), on_workpiece(&places, q));
            assert!(off <= bound.distance, "{off} {bound:?}");
            share = share.max(off / bound.distance);
        }
    }
    assert!(share > 0.5, "a bound that is never nearly met states too much: {share}");
}

#[test]
fn rounding_adds_no_more_than_is_stated_for_tips() {
    let mut draw = Draw::new(22);
    let lever = 30.0;
    let point = |tip: [f64; 3], axis: [f64; 3]| {
        let length = distance(axis, [0.0; 3]);
        [0, 1, 2].map(|k| tip[k] + lever * axis[k] / length)
    };
    let of_angles = |angles: &Angles| {
        let [c, a] = [3, 4].map(|axis| angles.get(axis).unwrap());
        [a.sin() * c.sin(), a.sin() * c.cos(), a.cos()]
    };
    let options = milling();
    for control in [TipControl::Directions, TipControl::Angles] {
        let mut share = 0.0f64;
        let mut blocks = [tool(), vec![Block::TipControlOn(control)]].concat();
        for _ in 0..20_000 {
            let tip = std::array::from_fn(|_| draw.between(-90.0, 90.0));
            let orientation = match control {
                TipControl::Directions => Orientation::Direction(direction(&mut draw)),
                TipControl::Angles => {
                    let words = [(3, draw.between(-3.0, 3.0)), (4, draw.between(-3.0, 3.0))];
                    Orientation::Angles(Angles::new(&words).unwrap())
                }
            };
            blocks.push(Block::Tip(TipMotion { tip, orientation, pace: Pace::Rapid }));
        }
        blocks.extend([Block::TipControlOff, Block::End]);
        let program = Program::new(trunnion(), blocks).unwrap();
        let bound = rounding_bound(&program, &options, 0.0, lever).unwrap();
        let text = write_checked(&program, Dialect::Fanuc, &options).unwrap().written.text;
        let found = read(text.as_bytes(), Dialect::Fanuc, program.axes()).unwrap();
        for (wanted, found) in program.blocks().iter().zip(&found.blocks) {
            let (Block::Tip(a), Block::Tip(b)) = (wanted, found) else { continue };
            let axis = |motion: &TipMotion| match motion.orientation {
                Orientation::Direction(direction) => direction,
                Orientation::Angles(angles) => of_angles(&angles),
                Orientation::Kept => panic!("every block has a direction"),
            };
            let off = distance(point(a.tip, axis(a)), point(b.tip, axis(b)));
            assert!(off <= bound.distance, "{off} {bound:?}");
            share = share.max(off / bound.distance);
        }
        assert!(share > 0.5, "{control:?}: {share}");
    }
}

#[test]
fn the_statement_of_rounding_is_that_of_the_specification() {
    // Three slides of four decimals: 0.087 um; one rotary axis of five: 0.087e-3 um for each mm.
    let blocks = vec![
        Block::Rapid(Targets::of_first(&[1.0, 2.0])),
        Block::Linear { target: Targets::NONE.with(2, 3.0).with(3, 1.0), duration: 1.0 },
        Block::End,
    ];
    let program = Program::new(trunnion(), blocks).unwrap();
    let bound = rounding_bound(&program, &milling(), 76.0, 0.0).unwrap();
    assert_eq!(bound.block, 2);
    assert!((bound.places - 0.0866e-3).abs() < 1e-7, "{bound:?}");
    assert!((bound.angles - 76.0 * 0.0873e-6).abs() < 76.0 * 1e-10, "{bound:?}");
    assert_eq!(bound.distance, bound.places + bound.angles);
    for wrong in [f64::NAN, -1.0, f64::INFINITY] {
        assert_eq!(rounding_bound(&program, &milling(), wrong, 0.0).unwrap_err().code(), "nc-bad-header");
        assert_eq!(rounding_bound(&program, &milling(), 0.0, wrong).unwrap_err().code(), "nc-bad-header");
    }
    let still = Program::new(trunnion(), vec![Block::End]).unwrap();
    assert_eq!(rounding_bound(&still, &milling(), 1.0, 1.0).unwrap().block, 0);
}
