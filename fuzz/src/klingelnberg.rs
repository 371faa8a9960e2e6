//! Files of curves and values, one or two of a part, as far as their evaluation.

use flankwright::exchange::inspection::{
    Inspection, KlingelnbergFile, MAXIMUM_SAMPLES, MAXIMUM_TRACES, MAXIMUM_UNKNOWN_LINES, inspection_of,
    parse_klingelnberg,
};
use flankwright::geometry::Flank;
use flankwright::workflow::inspection::{Design, evaluate_inspection};

use crate::complaints::told_in_full;
use crate::two_files;

/// Reads, joins, converts and evaluates.
pub fn klingelnberg(data: &[u8]) {
    let (first, second) = two_files(data);
    let Some(first) = read(first) else { return };
    whole(&[("first", &first)]);
    if let Some(second) = second.and_then(read) {
        whole(&[("first", &first), ("second", &second)]);
    }
}

fn read(bytes: &[u8]) -> Option<KlingelnbergFile> {
    let file = match parse_klingelnberg(bytes) {
        Ok(file) => file,
        Err(error) => {
            told_in_full(error.code(), &error.to_string(), &error.way_out());
            return None;
        }
    };
    assert!(file.unknown_lines.len() <= MAXIMUM_UNKNOWN_LINES && file.curves.len() <= MAXIMUM_TRACES);
    for curve in &file.curves {
        assert!((2..=MAXIMUM_SAMPLES).contains(&curve.values.len()));
        assert!(curve.position_mm.is_finite() && curve.values.iter().all(|v| !v.is_infinite()));
    }
    let numbers = file.positions.iter().flat_map(|position| position.centre_mm);
    assert!(numbers.chain(file.results.values().flatten().copied()).all(f64::is_finite));
    assert!(file.warnings.iter().all(|warning| !warning.message.is_empty()) && file.warnings.len() <= 2001);
    // One of three comparisons, for speed; which one changes with every byte that is put in or taken away.
    match bytes.len() % 3 {
        0 => written_and_read(&file),
        1 => kept_before_a_cut(bytes, &file),
        _ => found_behind(bytes, &file),
    }
    Some(file)
}

/// A trace that follows is found whatever stands before it.
fn found_behind(bytes: &[u8], file: &KlingelnbergFile) {
    if file.curves.len() == MAXIMUM_TRACES {
        return;
    }
    let trace = "\nProfil:\nZahn-Nr.: 3 links / 2 Werte z= 1\n 1234.5 -0.25\n";
    let longer =
        parse_klingelnberg(&[bytes, trace.as_bytes()].concat()).expect("the file with one more trace");
    assert_eq!(longer.curves.len(), file.curves.len() + 1);
    let last = &longer.curves[file.curves.len()];
    assert_eq!((last.tooth, last.flank, last.values.len()), (3, Flank::Left, 2), "{last:?}");
}

fn written_and_read(file: &KlingelnbergFile) {
    let text = serde_json::to_string(file).expect("a file as JSON");
    let back: KlingelnbergFile = serde_json::from_str(&text).expect("the same file again");
    assert_eq!(serde_json::to_string(&back).expect("JSON"), text);
}

/// What was complete in the first half of the lines is there without the second half.
fn kept_before_a_cut(bytes: &[u8], file: &KlingelnbergFile) {
    let Some(end) = bytes[..bytes.len() / 2].iter().rposition(|b| *b == b'\n') else { return };
    let Ok(part) = parse_klingelnberg(&bytes[..=end]) else { return };
    // Where only the second half tells the encoding, the first half reads otherwise.
    if part.encoding != file.encoding {
        return;
    }
    let same =
        |a: &dyn std::fmt::Debug, b: &dyn std::fmt::Debug| assert_eq!(format!("{a:?}"), format!("{b:?}"));
    assert!(part.curves.len() <= file.curves.len() && part.positions.len() <= file.positions.len());
    same(&part.curves, &&file.curves[..part.curves.len()]);
    same(&part.positions, &&file.positions[..part.positions.len()]);
    for flank in Flank::BOTH {
        assert!(part.pitch[flank].len() <= file.pitch[flank].len());
        same(&part.pitch[flank], &&file.pitch[flank][..part.pitch[flank].len()]);
    }
    assert!(part.results.keys().all(|code| file.results.contains_key(code)));
    assert!(part.header.keys().all(|code| file.header.contains_key(code)));
    assert!(part.unknown_lines.iter().zip(&file.unknown_lines).all(|(a, b)| a == b));
}

fn whole(files: &[(&str, &KlingelnbergFile)]) {
    let inspection = match inspection_of(files) {
        Ok(inspection) => inspection,
        Err(error) => return told_in_full(error.code(), &error.to_string(), &error.way_out()),
    };
    for trace in &inspection.traces {
        assert_eq!(trace.abscissa_mm.len(), trace.f_um.len());
        assert!(trace.position_mm.is_finite() && trace.abscissa_mm.iter().all(|v| v.is_finite()));
        assert!(trace.abscissa_mm.windows(2).all(|pair| pair[0] < pair[1]), "abscissas that do not ascend");
        assert!(trace.f_um.iter().all(|v| !v.is_infinite()));
    }
    let text = serde_json::to_string(&inspection).expect("an inspection as JSON");
    let back: Inspection = serde_json::from_str(&text).expect("the same inspection again");
    assert_eq!(serde_json::to_string(&back).expect("JSON"), text);
    evaluated(&inspection, None);
    evaluated(&inspection, Some(&|_, w, z| 1e-3 * (1.0 - 0.01 * (w * w + z * z))));
}

fn evaluated(inspection: &Inspection, design: Option<Design<'_>>) {
    let found = match evaluate_inspection(inspection, design) {
        Ok(found) => found,
        Err(error) => return told_in_full(error.code(), &error.to_string(), &error.way_out()),
    };
    for (what, error) in &found.left_out.0 {
        assert!(!what.is_empty());
        told_in_full(error.code(), &error.to_string(), &error.way_out());
    }
    assert!(found.traces.len() <= inspection.traces.len());
    for judged in &found.judged {
        assert!(judged.value.is_finite(), "{judged:?}");
    }
    let numbers = format!("{:?}", (&found.traces, &found.pitch, &found.thickness));
    assert!(!numbers.contains("NaN") && !numbers.contains("inf"), "{numbers}");
}
