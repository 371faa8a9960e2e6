//! Truncated files, exchanged lines, random bytes: an answer or an error, never a panic, in bounded time.

use super::super::*;
use super::gear::{author, full};
use crate::inspection::DatumFace;
use foundation::modification::NoFiles;
use proptest::prelude::*;

fn sample(format: RexsFormat, packed: bool) -> Vec<u8> {
    let (document, _) = document_of(&full(DatumFace::PlusZ), &NoFiles, &author()).unwrap();
    rexs_bytes(&document, format, packed).unwrap().0
}

/// Reads and writes again; whatever is wrong must come back as a value.
fn take(bytes: &[u8]) {
    let Ok(document) = parse_rexs(bytes) else { return };
    for id in gear_ids(&document) {
        if let Ok((gear, _)) = gear_of(&document, id) {
            let _ = document_of(&gear, &NoFiles, &author());
        }
    }
    for format in [RexsFormat::Xml, RexsFormat::Json] {
        assert!(rexs_bytes(&document, format, false).is_ok());
    }
}

#[test]
fn truncations_give_an_answer() {
    for (format, packed) in [(RexsFormat::Xml, false), (RexsFormat::Json, false), (RexsFormat::Xml, true)] {
        let bytes = sample(format, packed);
        for end in (0..bytes.len()).step_by(37) {
            take(&bytes[..end]);
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(128))]

    #[test]
    fn changed_bytes(changes in prop::collection::vec((0usize..60_000, 32u8..127), 1..12), which in 0..3) {
        let mut bytes = sample([RexsFormat::Xml, RexsFormat::Json, RexsFormat::Xml][which as usize], which == 2);
        let length = bytes.len();
        for (at, byte) in changes {
            bytes[at % length] = byte;
        }
        take(&bytes);
    }

    #[test]
    fn exchanged_lines(pairs in prop::collection::vec((0usize..2000, 0usize..2000), 1..8), json in any::<bool>()) {
        let bytes = sample(if json { RexsFormat::Json } else { RexsFormat::Xml }, false);
        let text = String::from_utf8(bytes).unwrap();
        let mut lines: Vec<&str> = text.lines().collect();
        let count = lines.len();
        for (a, b) in pairs {
            lines.swap(a % count, b % count);
        }
        take(lines.join("\n").as_bytes());
    }

    #[test]
    fn changed_numbers(values in prop::collection::vec(prop_oneof![Just(0.0), Just(-1.0), Just(1e308), Just(1e-300), any::<f64>()], 1..30), step in 1usize..40) {
        let text = String::from_utf8(sample(RexsFormat::Xml, false)).unwrap();
        let mut numbers = values.iter().cycle();
        let lines: Vec<String> = text.lines().enumerate().map(|(k, line)| {
            let (Some(from), Some(to)) = (line.find("\">"), line.rfind("</attribute>")) else { return line.into() };
            if k % step != 0 || line.contains("<array>") { return line.into() }
            format!("{}{}{}", &line[..from + 2], numbers.next().unwrap(), &line[to..])
        }).collect();
        take(lines.join("\n").as_bytes());
    }

    #[test]
    fn random_bytes(bytes in prop::collection::vec(any::<u8>(), 0..2000)) {
        take(&bytes);
        take(&[b"PK\x03\x04", &bytes[..]].concat());
        take(&[b"<model ", &bytes[..]].concat());
    }
}
