//! Descriptions of machines, catalogues of bodies as TOML, JSON and tables, histories of skiving tools.

use flankwright::exchange::Source;
use flankwright::exchange::catalogue::{parse_catalogue, parse_catalogue_tables};
use flankwright::exchange::machine::parse_machine;
use flankwright::exchange::skiving_history::parse_history;

use crate::complaints::of_text;
use crate::two_files;

/// Every one of these readers takes the text or says why not; two tables of a catalogue stand on both sides of the separator.
pub fn machine(data: &[u8]) {
    let (first, second) = two_files(data);
    let source = match Source::from_bytes("file", first) {
        Ok(source) => source,
        Err(error) => return of_text(&error),
    };
    if let Some(second) = second {
        match Source::from_bytes("dressers.csv", second)
            .and_then(|second| parse_catalogue_tables(source, second))
        {
            Ok(found) => assert!(serde_json::to_string(&found.catalogue).is_ok()),
            Err(error) => of_text(&error),
        }
        return;
    }
    match parse_machine(source.clone()) {
        Ok(found) => {
            let text = serde_json::to_string(&found.file).expect("a machine as JSON");
            let back = parse_machine(Source::new("machine.json", &text));
            let back = back.unwrap_or_else(|error| panic!("{error}\n{text}"));
            assert_eq!(back.file, found.file);
        }
        Err(error) => of_text(&error),
    }
    match parse_catalogue(source.clone()) {
        Ok(found) => {
            let text = serde_json::to_string(&found.catalogue).expect("a catalogue as JSON");
            let back = parse_catalogue(Source::new("catalogue.json", &text));
            let back = back.unwrap_or_else(|error| panic!("{error}\n{text}"));
            assert_eq!(back.catalogue, found.catalogue);
        }
        Err(error) => of_text(&error),
    }
    match parse_history(source) {
        Ok(found) => {
            let lines = found.records().iter().map(|record| serde_json::to_string(record).expect("a record"));
            let text = lines.map(|line| line + "\n").collect::<String>();
            let back = parse_history(Source::new("history.jsonl", &text));
            let back = back.unwrap_or_else(|error| panic!("{error}\n{text}"));
            assert_eq!(back.records(), found.records());
        }
        Err(error) => of_text(&error),
    }
}
