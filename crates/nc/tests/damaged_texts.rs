//! Hostile texts for the reader: bytes, words in any order, and written programs with damage. Nothing panics, an error names a
//! place inside the text, and what is read can be written and read again. `PROPTEST_CASES` makes it run longer.

use crate::programs::{Draw, axes, header, random, tips};
use nc::{
    Dialect, NcError, Program, WriteOptions, detect_dialect, read, read_cl, write_checked, write_cl,
    write_cl_checked,
};
use proptest::prelude::*;

/// Reads a text in every dialect; true if one of them takes it.
fn attempt(text: &[u8]) -> bool {
    let _ = detect_dialect(text);
    let mut taken = false;
    for dialect in Dialect::ALL {
        let found = match read(text, dialect, &axes(dialect)) {
            Ok(found) => found,
            Err(error) => {
                let lines = text.split(|byte| *byte == b'\n').count();
                assert!((1..=lines + 1).contains(&error.line), "{error}");
                assert!((1..=513 + 1).contains(&error.column), "{error}");
                assert!(error.to_string().is_ascii() && error.word.len() < 300, "{error}");
                continue;
            }
        };
        taken = true;
        let Ok(program) = Program::new(header(dialect), found.blocks) else { continue };
        let written = write_checked(&program, dialect, &WriteOptions::default());
        let unequal = matches!(written, Err(NcError::NotReadBack(_) | NcError::ReadBackMismatch { .. }));
        assert!(!unequal, "{dialect:?} {written:?}: {}", text.escape_ascii());
    }
    taken | attempt_cl(text)
}

/// The same as cutter locations.
fn attempt_cl(text: &[u8]) -> bool {
    let found = match read_cl(text) {
        Ok(found) => found,
        Err(error) => {
            let lines = text.split(|byte| *byte == b'\n').count();
            assert!(
                (1..=lines + 1).contains(&error.line) && (1..=513 + 1).contains(&error.column),
                "{error}"
            );
            assert!(error.to_string().is_ascii() && error.word.len() < 300, "{error}");
            return false;
        }
    };
    if let Ok(program) = Program::new(header(Dialect::Siemens), found.blocks) {
        let written = write_cl_checked(&program, found.cutter.as_ref());
        let unequal = matches!(written, Err(NcError::NotReadBack(_) | NcError::ReadBackMismatch { .. }));
        assert!(!unequal, "{written:?}: {}", text.escape_ascii());
    }
    true
}

/// Pieces of all three languages.
const WORDS: [&str; 92] = [
    "G0",
    "G1",
    "G4",
    "G20",
    "G21",
    "G64",
    "G80",
    "G81",
    "G90",
    "G91",
    "G93",
    "G94",
    "G5.1",
    "G05.1",
    "G710",
    "G700",
    "M0",
    "M2",
    "M3",
    "M5",
    "M30",
    "M64",
    "S100",
    "S1=100",
    "M1=3",
    "M2=5",
    "F1",
    "F60.0",
    "F1e9",
    "X1",
    "Y-2.5",
    "Z.5",
    "A90.",
    "C720.0",
    "B-0.0",
    "X1=1",
    "C2=IC(90)",
    "C2=AC(0)",
    "B1=3",
    "V1=",
    "POLY",
    "PO[X1]=(1,2,3)",
    "PO[C2]=(1)",
    "PL=2",
    "BSPLINE",
    "SD=2",
    "CTABDEF(C2, Z1, 1, 0)",
    "CTABEND",
    "EGDEL(C2)",
    "EGDEF(C2, B1, 1, Z1, 1)",
    "EGON(C2, \"FINE\", B1, 3, 40, Z1, 1, 0)",
    "EGONSYN(C2, \"NOC\", 1, B1, 0, 3, 40, Z1, 0, 1, 2)",
    "EGOFS(C2)",
    "(",
    ")",
    "(A)",
    "; A",
    "%",
    "O12",
    "N10",
    "P0.5",
    "P4",
    "Q2.",
    "P20.",
    "T40",
    "L3",
    "$1",
    "R1=2",
    "-",
    "999999999999999999",
    "T5 M6\n",
    "T5 D3 M6\n",
    "T7",
    "D1",
    "M6",
    "TRAORI\n",
    "ORIWKS\n",
    "ORIMKS\n",
    "TRAFOOF\n",
    "G43.4 H5\n",
    "G43.5 H5\n",
    "G49",
    "G49\n",
    "A3=0.5",
    "B3=-1",
    "C3=1.0",
    "X1. Y2. Z3.",
    "I0.5",
    "J-1.",
    "K1.0",
    "H5",
    "G93 G1",
];

/// Records of cutter locations.
const RECORDS: [&str; 18] = [
    "PARTNO/A",
    "UNITS/MM",
    "UNITS/MM\nMULTAX/ON",
    "TOOL/MILL,5,1,20",
    "LOADTL/5",
    "LOADTL/5,OSETNO,3",
    "SPINDL/RPM,3000,CLW",
    "SPINDL/OFF",
    "FEDRAT/100.5,MMPM",
    "FEDRAT/30,INVERS",
    "MULTAX/OFF",
    "RAPID",
    "GOTO/1.5,-2,3,0.6,0,0.8",
    "GOTO/1,2,3",
    "DELAY/0.5",
    "PPRINT/A B",
    "STOP",
    "999999999999999999",
];

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn bytes(text in prop::collection::vec(any::<u8>(), 0..400)) {
        attempt(&text);
    }

    #[test]
    fn characters_of_programs(text in "[GMXYZABCFSPNQTL0-9=\\[\\](),.;%$ \\-\n\"]{0,300}") {
        attempt(text.as_bytes());
    }

    #[test]
    fn records_in_any_order(records in prop::collection::vec((0..RECORDS.len(), 0u8..5), 0..40)) {
        let mut text = String::new();
        for (record, separator) in records {
            text.push_str(RECORDS[record]);
            text.push_str(["\n", "\n", "\n", ",", " "][usize::from(separator)]);
        }
        text.push_str("\nFINI\n");
        attempt_cl(text.as_bytes());
    }

    #[test]
    fn words_in_any_order(words in prop::collection::vec((0..WORDS.len(), 0u8..4), 0..60)) {
        let mut text = String::new();
        for (word, separator) in words {
            text.push_str(WORDS[word]);
            text.push_str([" ", "\n", "\n", ""][usize::from(separator)]);
        }
        text.push_str("\nM30\n");
        attempt(text.as_bytes());
    }
}

#[test]
fn written_programs_with_damage() {
    let cases = std::env::var("PROPTEST_CASES").ok().and_then(|cases| cases.parse().ok()).unwrap_or(256u64);
    let mut draw = Draw::new(11);
    let mut taken = 0;
    for case in 0..cases {
        let dialect = Dialect::ALL[case as usize % 3];
        // Tips in every other case of the dialects that have them, cutter locations where the third has none.
        let text = match (dialect, case / 3 % 2) {
            (_, 0) => write_checked(&random(dialect, case, 12, false), dialect, &WriteOptions::default())
                .map(|checked| checked.written.text),
            (Dialect::LinuxCnc, _) => write_cl(&tips(Dialect::Siemens, case, 12, false), None),
            _ => write_checked(&tips(dialect, case, 12, true), dialect, &WriteOptions::default())
                .map(|checked| checked.written.text),
        };
        let text = text.unwrap_or_else(|error| panic!("{case}: {error}"));
        for _ in 0..40 {
            let mut bytes = text.clone().into_bytes();
            for _ in 0..=draw.below(4) {
                let from = draw.below(bytes.len() as u64) as usize;
                let to = (from + draw.below(30) as usize).min(bytes.len());
                match draw.below(5) {
                    0 => drop(bytes.drain(from..to)),
                    1 => bytes.extend_from_within(from..to),
                    2 => bytes[from] = draw.next() as u8,
                    3 => bytes[from] = b"0123456789.-+GXF\n"[draw.below(17) as usize],
                    _ => bytes.insert(from, b"0123456789.-+GXF \n"[draw.below(18) as usize]),
                }
                if bytes.is_empty() {
                    bytes.push(b'%');
                }
            }
            taken += u64::from(attempt(&bytes));
        }
    }
    assert!(taken > cases, "{taken} of {} damaged programs were read", 40 * cases);
}
