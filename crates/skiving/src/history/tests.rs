//! Histories written, read back, and every way in which they can be wrong.

use super::*;
use crate::wear::WearTrend;
use job::{JobError, MAXIMUM_BYTES, Source};
use std::fs;
use std::path::PathBuf;

fn record(tool: &str, day: u32, parts: f64, resharpened: u32) -> HistoryRecord {
    let flank = |wear: f64| RecordedFlank {
        places: vec![-0.8, 0.0, 0.8],
        track_mean_um: vec![0.1, -0.5 - wear * parts, 1.0 / 3.0],
        sigma_um: 0.05,
    };
    HistoryRecord {
        tool: tool.into(),
        time: format!("2026-03-{day:02}T09:30:00+01:00"),
        parts,
        resharpened,
        flanks: RecordedFlanks { left: flank(0.002), right: flank(0.001) },
        pitch: RecordedPitch { total_um: 8.5, largest_single_um: 3.25 },
        mounting: RecordedMounting { eccentricity_um: [8.0, -5.0], wobble_urad: [150.0, -80.0] },
        out_of_band: vec![RecordedEdge { flank: Flank::Right, tooth: 6 }],
        version: "0.1.0".into(),
    }
}

fn text_of(records: &[HistoryRecord]) -> String {
    records.iter().map(|record| serde_json::to_string(record).unwrap() + "\n").collect()
}

fn parse(text: &str) -> Result<History, JobError> {
    parse_history(Source::new("tools.jsonl", text))
}

fn file() -> (tempfile::TempDir, PathBuf) {
    let directory = tempfile::tempdir().unwrap();
    let path = directory.path().join("deep/tools.jsonl");
    (directory, path)
}

#[test]
fn records_come_back_as_they_were_written() {
    let (_directory, path) = file();
    let records =
        [record("A", 1, 0.0, 0), record("B", 1, 40.0, 2), record("A", 3, 500.0, 0), record("A", 4, 0.0, 1)];
    for (k, record) in records.iter().enumerate() {
        let history = append_history(&path, record).unwrap();
        assert_eq!(history.records(), &records[..=k]);
    }
    assert_eq!(read_history(&path).unwrap().records(), records);
    assert_eq!(fs::read_to_string(&path).unwrap(), text_of(&records));
    // Nothing else is left in the directory.
    assert_eq!(fs::read_dir(path.parent().unwrap()).unwrap().count(), 1);
}

#[test]
fn a_run_can_be_repeated() {
    let (_directory, path) = file();
    let (first, second) = (record("A", 1, 0.0, 0), record("A", 2, 300.0, 0));
    append_history(&path, &first).unwrap();
    append_history(&path, &second).unwrap();
    let before = fs::read(&path).unwrap();
    let same =
        HistoryRecord { version: "0.2.0".into(), time: "2026-03-01T08:30:00Z".into(), ..first.clone() };
    let history = append_history(&path, &same).unwrap();
    assert_eq!(fs::read(&path).unwrap(), before);
    // What came later does not count for the first.
    assert_eq!(history.cycle_until(&same), [&first]);
    assert_eq!(history.cycle_until(&second), [&first, &second]);
    let other = HistoryRecord { parts: 1.0, ..first };
    let error = append_history(&path, &other).unwrap_err();
    assert_eq!(told(&error), ("invalid-history", "time"), "{error}");
    assert_eq!(fs::read(&path).unwrap(), before);
}

#[test]
fn a_cycle_goes_from_one_resharpening_to_the_next() {
    let records = [
        record("A", 1, 0.0, 0),
        record("A", 2, 900.0, 0),
        record("B", 2, 100.0, 1),
        record("A", 3, 0.0, 1),
        record("A", 4, 400.0, 1),
        record("A", 5, 800.0, 1),
    ];
    let history = parse(&text_of(&records)).unwrap();
    let cycle = history.cycle_until(&records[5]);
    assert_eq!(cycle, [&records[3], &records[4], &records[5]]);
    let points: Vec<_> = cycle.iter().map(|record| record.wear_point(Flank::Left)).collect();
    let trend = WearTrend::fit(&points, 0.005).unwrap();
    // -0.5 um and 0.002 um a workpiece.
    assert!((trend.start - 0.5e-3).abs() < 1e-15 && (trend.rate - 2e-6).abs() < 1e-18, "{trend:?}");
    assert!((trend.forecast.unwrap().parts - 2250.0).abs() < 1e-6);
    assert_eq!(records[5].wear_point(Flank::Right).sigma, 0.05e-3);
}

/// Code and key of the first finding, which has a value, what is allowed and a way out.
fn told(error: &JobError) -> (&'static str, &str) {
    let finding = &error.diagnostics[0];
    assert!(finding.way_out.is_some() && finding.allowed.is_some() && finding.value.is_some(), "{error}");
    (finding.code, finding.field.as_deref().unwrap_or(""))
}

#[test]
fn what_is_wrong_with_a_line_is_told_with_its_place() {
    let good = text_of(&[record("A", 1, 0.0, 0)]);
    let line = good.trim_end();
    let changed = |from: &str, to: &str| {
        assert!(line.contains(from), "{from}");
        line.replacen(from, to, 1)
    };
    let cases = [
        (changed("\"parts\":0.0", "\"parts\":-1"), "invalid-number", "parts"),
        (changed("\"parts\":0.0", "\"parts\":1e999"), "invalid-number", "parts"),
        (changed("\"parts\":0.0", "\"parts\":\"12\""), "wrong-type", "parts"),
        (changed("\"resharpened\":0", "\"resharpened\":0.5"), "wrong-type", "resharpened"),
        (changed("\"resharpened\":0", "\"resharpened\":-1"), "invalid-number", "resharpened"),
        (changed("\"sigma_um\":0.05", "\"sigma_um\":0"), "invalid-number", "flanks.left.sigma_um"),
        (changed("[-0.8,0.0,0.8]", "[-0.8,0.0,1.8]"), "invalid-number", "flanks.left.places[2]"),
        (changed("[-0.8,0.0,0.8]", "[-0.8,0.8]"), "invalid-list", "flanks.left.track_mean_um"),
        (changed("[-0.8,0.0,0.8]", "[]"), "invalid-list", "flanks.left.places"),
        (changed("\"right\",\"tooth\"", "\"rihgt\",\"tooth\""), "unknown-value", "out_of_band[0].flank"),
        (changed("\"pitch\"", "\"pich\":1,\"pitch\""), "unknown-key", "pich"),
        (changed("{\"total_um\":8.5,", "{\"total_um\":8.5,\"x\":1,"), "unknown-key", "pitch.x"),
        (changed("2026-03-01T09:30:00+01:00", "2026-02-30T09:30:00+01:00"), "unknown-value", "time"),
        (changed("\"tool\":\"A\"", "\"tool\":\"\""), "unknown-value", "tool"),
        ("[1, 2]".into(), "wrong-type", ""),
        (line[..line.len() / 2].into(), "invalid-json", ""),
        (format!("{line},"), "invalid-json", ""),
        (changed("\"tool\":\"A\"", "\"tool\":\"A\",\"tool\":\"B\""), "duplicate-key", ""),
    ];
    for (wrong, code, field) in cases {
        let later = text_of(&[record("A", 2, 0.0, 0)]);
        let error = parse(&format!("{good}\n{wrong}\n{later}")).unwrap_err();
        assert_eq!(told(&error), (code, field), "{wrong}: {error}");
        assert!(error.to_string().starts_with("tools.jsonl:3:"), "{error}");
    }
    // Missing keys have no value to be told.
    let error =
        parse(&changed("\"version\":\"0.1.0\"", "\"pitch\":1").replace(",\"pitch\":1", "")).unwrap_err();
    let finding = &error.diagnostics[0];
    assert_eq!((finding.code, finding.field.as_deref()), ("missing-key", Some("version")), "{error}");
    assert!(error.to_string().starts_with("tools.jsonl:1:1: "), "{error}");
}

#[test]
fn records_against_their_order_are_told() {
    let first = record("A", 5, 500.0, 1);
    for (second, field) in [
        (record("A", 5, 600.0, 1), "time"),
        (record("A", 4, 600.0, 1), "time"),
        (record("A", 6, 600.0, 0), "resharpened"),
        (record("A", 6, 499.0, 1), "parts"),
    ] {
        let between = record("B", 1, 0.0, 0);
        let error = parse(&text_of(&[first.clone(), between, second.clone()])).unwrap_err();
        assert_eq!(told(&error), ("invalid-history", field), "{error}");
        assert!(error.to_string().starts_with("tools.jsonl:3:"), "{error}");
        let (_directory, path) = file();
        append_history(&path, &first).unwrap();
        let before = fs::read(&path).unwrap();
        let error = append_history(&path, &second).unwrap_err();
        assert_eq!(told(&error), ("invalid-history", field), "{error}");
        // A line that is not in the file has no place there.
        assert_eq!(error.diagnostics[0].span, None);
        assert_eq!(fs::read(&path).unwrap(), before);
    }
    // Resharpened, it begins anew; as many parts as before may be measured once more.
    assert!(parse(&text_of(&[first.clone(), record("A", 6, 500.0, 1), record("A", 7, 0.0, 2)])).is_ok());
}

#[test]
fn a_wrong_record_is_not_added() {
    let (_directory, path) = file();
    let good = record("A", 1, 0.0, 0);
    let mut wrong = good.clone();
    wrong.flanks.right.track_mean_um[1] = f64::NAN;
    assert_eq!(
        told(&append_history(&path, &wrong).unwrap_err()),
        ("invalid-number", "flanks.right.track_mean_um[1]")
    );
    let wrong = HistoryRecord { time: "yesterday, some time ago".into(), ..good.clone() };
    assert_eq!(told(&append_history(&path, &wrong).unwrap_err()), ("unknown-value", "time"));
    let wrong = HistoryRecord { parts: -3.0, ..good.clone() };
    assert_eq!(told(&append_history(&path, &wrong).unwrap_err()), ("invalid-number", "parts"));
    assert!(!path.exists());
    // A history that is wrong already is not made longer.
    fs::create_dir_all(path.parent().unwrap()).unwrap();
    fs::write(&path, "{\n").unwrap();
    let error = append_history(&path, &good).unwrap_err();
    assert_eq!(told(&error), ("invalid-json", ""));
    assert!(error.diagnostics[0].span.is_some());
    assert_eq!(fs::read_to_string(&path).unwrap(), "{\n");
}

#[test]
fn files_at_their_limits() {
    let (_directory, path) = file();
    let missing = read_history(&path).unwrap_err();
    assert_eq!(missing.diagnostics[0].code, "unreadable-file");
    assert!(missing.diagnostics[0].way_out.as_deref().unwrap().contains("the first measurement"));
    fs::create_dir_all(&path).unwrap();
    assert_eq!(
        append_history(&path, &record("A", 1, 0.0, 0)).unwrap_err().diagnostics[0].code,
        "unreadable-file"
    );
    fs::remove_dir(&path).unwrap();
    assert_eq!(parse("").unwrap().records(), []);
    // A last line without an end, and blank lines up to the limit.
    let line = text_of(&[record("A", 1, 0.0, 0)]);
    fs::write(&path, line.trim_end()).unwrap();
    assert_eq!(append_history(&path, &record("A", 2, 0.0, 0)).unwrap().records().len(), 2);
    let full = format!("{line}{}", "\n".repeat(MAXIMUM_BYTES - line.len()));
    fs::write(&path, &full).unwrap();
    let error = append_history(&path, &record("A", 2, 0.0, 0)).unwrap_err();
    assert_eq!(told(&error), ("file-too-large", ""));
    assert_eq!(fs::read_to_string(&path).unwrap().len(), full.len());
}
