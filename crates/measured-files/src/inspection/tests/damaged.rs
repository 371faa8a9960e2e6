//! Truncated files, shuffled lines, random bytes: an answer or an error, never a panic, in bounded time.

use super::super::*;
use super::made::{Made, TEETH};
use proptest::prelude::*;

/// A file with everything the grammar has.
fn sample() -> Vec<u8> {
    let wave: Vec<f64> = (0..60).map(|i| f64::from(i).sin()).collect();
    let mut rows = String::from("rechte Zahnflanke\nZahn-Nr.  fp  Fp  Fr\n");
    for tooth in 1..=TEETH {
        rows.push_str(&format!(" {tooth} .5 -1.5 2\n"));
    }
    rows.push_str("Kopfkreisdurchmesser / Höhe : 8.5\n 48.3 48.4\n");
    rows.push_str("Teilung:\nZ-Nr. Seite PHI X Y Z\n 1 R 0.0 .1198 25.5249 87.2302\n 2 L 0.0 .1 25 87\n");
    Made::gear()
        .curve("Flankenlinie:", "Zahn-Nr.: 7 links / 60  Werte  x= 8.953", &wave)
        .curve("Profil:", "Zahn-Nr.: 7o rechts / 60  Werte / z= 16", &wave)
        .lines(&rows)
        .printing(&[(10111, "1.5"), (34610, "16.826")])
        .text()
        .replace("KS.MW", "KS.MK")
        .into_bytes()
}

/// Reads and converts; whatever is wrong must come back as a value.
fn take(bytes: &[u8]) {
    if let Ok(file) = parse_klingelnberg(bytes) {
        assert!(file.unknown_lines.len() <= MAXIMUM_UNKNOWN_LINES);
        for curve in &file.curves {
            assert!((2..=MAXIMUM_SAMPLES).contains(&curve.values.len()));
        }
        if let Ok(whole) = inspection_of(&[("damaged", &file)]) {
            for trace in &whole.traces {
                assert_eq!(trace.abscissa_mm.len(), trace.f_um.len());
                assert!(trace.abscissa_mm.windows(2).all(|pair| pair[0] < pair[1]));
            }
            assert!(serde_json::to_string(&whole).is_ok());
        }
    }
}

#[test]
fn the_sample_itself_is_understood() {
    let file = parse_klingelnberg(&sample()).unwrap();
    assert!(file.unknown_lines.is_empty() && file.warnings.is_empty(), "{:?}", file.unknown_lines);
    let whole = inspection_of(&[("sample", &file)]).unwrap();
    assert_eq!((whole.traces.len(), whole.results.len()), (2, 2));
    assert!(whole.circles.tip.is_some() && whole.run_out.is_some());
}

#[test]
fn every_truncation_gives_an_answer() {
    let bytes = sample();
    for end in 0..bytes.len() {
        take(&bytes[..end]);
    }
}

#[test]
fn a_file_of_numbers_only_ends_soon() {
    let text = format!("HEADER KS.MK.FILE\n{}", "1 2 3 4 5 6 7 8\n".repeat(900_000));
    let start = std::time::Instant::now();
    assert_eq!(parse_klingelnberg(text.as_bytes()).unwrap_err().code(), "too-many-unknown-lines");
    assert!(start.elapsed().as_secs() < 5);
    // As surplus of a trace they are told once.
    let text =
        format!("HEADER KS.MK.FILE\nZahn-Nr.: 1 links / 2 Werte z= 3\n{}", "1 2 3 4\n".repeat(900_000));
    let file = parse_klingelnberg(text.as_bytes()).unwrap();
    assert_eq!((file.curves[0].values.len(), file.warnings.len()), (2, 1));
    assert!(start.elapsed().as_secs() < 20);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(256))]

    #[test]
    fn shuffled_lines(order in Just((0..110usize).collect::<Vec<_>>()).prop_shuffle()) {
        let bytes = sample();
        let text = String::from_utf8(bytes).unwrap();
        let lines: Vec<&str> = text.lines().collect();
        let mixed: Vec<&str> = order.iter().filter_map(|&k| lines.get(k + 1).copied()).collect();
        take(format!("{}\n{}", lines[0], mixed.join("\n")).as_bytes());
    }

    #[test]
    fn changed_bytes(changes in prop::collection::vec((0usize..6000, any::<u8>()), 1..40)) {
        let mut bytes = sample();
        let length = bytes.len();
        for (at, byte) in changes {
            bytes[at % length] = byte;
        }
        take(&bytes);
    }

    #[test]
    fn random_bytes(bytes in prop::collection::vec(any::<u8>(), 0..3000)) {
        take(&bytes);
        take(&[b"HEADER KS.MK.FILE\n", &bytes[..]].concat());
    }

    #[test]
    fn random_lines_of_the_grammar(lines in prop::collection::vec(
        "(Zahn-Nr\\.: ?[0-9]{0,3}[kfuoa]? ?(/Profil:1)? ?(links|rechts) / ?[0-9]{0,4} Werte ?/? ?[xz]= ?[-0-9.]{0,6}|[ 0-9.eE+-]{0,30}|[0-9]{1,5} ?:[A-Za-z ]{0,9}:[A-Z0-9_: .+-]{0,20}|Profil: ?|Flankenlinie:|linke Zahnflanke|Zahn-Nr\\. fp Fp|Teilung:|Kopfkreisdurchmesser / H: 5)",
        0..60,
    )) {
        take(format!("HEADER KS.MK.FILE\n{}", lines.join("\n")).as_bytes());
    }
}
