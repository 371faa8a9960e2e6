//! Histories of skiving tools: added once, in order, all or none.

use std::path::Path;

use flankwright::exchange::Source;
use flankwright::exchange::skiving_history::{History, HistoryRecord, parse_history, read_history};

use crate::place::{Place, on_both};

on_both! {
    a_history_comes_out_as_it_went_in
    a_history_grows_and_knows_what_it_has
    a_measurement_against_the_order_keeps_all_out
}

fn example() -> Vec<HistoryRecord> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples/skiving/history.jsonl");
    read_history(&path).unwrap().records().to_vec()
}

fn history(records: &[HistoryRecord]) -> History {
    let text: String = records.iter().map(|record| serde_json::to_string(record).unwrap() + "\n").collect();
    parse_history(Source::new("made.jsonl", &text)).unwrap()
}

fn other_tool(records: &[HistoryRecord]) -> Vec<HistoryRecord> {
    records.iter().map(|record| HistoryRecord { tool: "other".into(), ..record.clone() }).collect()
}

fn a_history_comes_out_as_it_went_in(place: &Place) {
    let (store, records) = (place.open(), example());
    assert!(records.len() >= 3, "an example that tells something");
    assert_eq!(store.import_history(&history(&records)).unwrap().added, records.len());
    assert_eq!(store.history(None).unwrap(), records);
    let tools = store.tools().unwrap();
    assert_eq!(
        (tools[0].tool.as_str(), tools[0].measurements),
        (records[0].tool.as_str(), records.len() as u64)
    );
}

fn a_history_grows_and_knows_what_it_has(place: &Place) {
    let (store, records) = (place.open(), example());
    store.import_history(&history(&records[..2])).unwrap();
    let newer: Vec<HistoryRecord> =
        records.iter().map(|record| HistoryRecord { version: "9.9.9".into(), ..record.clone() }).collect();
    let report = store.import_history(&history(&newer)).unwrap();
    assert_eq!((report.added, report.known), (records.len() - 2, 2));
    store.import_history(&history(&other_tool(&records))).unwrap();
    assert_eq!(store.history(Some("other")).unwrap(), other_tool(&records));
    assert_eq!(store.history(Some(&records[0].tool)).unwrap().len(), records.len());
    assert_eq!(store.history(Some("none")).unwrap(), []);
    assert_eq!(store.tools().unwrap().len(), 2);
}

fn a_measurement_against_the_order_keeps_all_out(place: &Place) {
    let (store, records) = (place.open(), example());
    store.import_history(&history(&records)).unwrap();
    let mut wrong = records.last().unwrap().clone();
    wrong.pitch.total_um += 1.0;
    let mut list = other_tool(&records);
    list.push(wrong);
    let error = store.import_history(&history(&list)).unwrap_err();
    assert_eq!(error.code(), "invalid-history", "{error}");
    assert_eq!(store.history(None).unwrap(), records);
}
