//! Descriptions of machines; catalogues of bodies as TOML, JSON and tables; histories of skiving tools.

use flankwright::exchange::catalogue::{LoadedCatalogue, parse_catalogue, parse_catalogue_tables};
use flankwright::exchange::machine::parse_machine;
use flankwright::exchange::skiving_history::parse_history;
use flankwright::exchange::{JobError, Source};

use crate::complaints::taken;
use crate::two_files;

/// The description of a machine.
pub fn machine(data: &[u8]) {
    let Some(found) = taken(Source::from_bytes("machine", data).and_then(parse_machine)) else { return };
    let text = serde_json::to_string(&found.file).expect("a machine as JSON");
    assert_eq!(again("machine.json", &text, parse_machine).file, found.file);
}

/// A catalogue, or its two tables on both sides of the separator.
pub fn catalogue(data: &[u8]) {
    let (first, second) = two_files(data);
    let Some(source) = taken(Source::from_bytes("catalogue", first)) else { return };
    let found = match second {
        None => taken(parse_catalogue(source)),
        Some(second) => {
            let dressers = Source::from_bytes("dressers.csv", second);
            taken(dressers.and_then(|dressers| parse_catalogue_tables(source, dressers)))
        }
    };
    let Some(LoadedCatalogue { catalogue, .. }) = found else { return };
    let text = serde_json::to_string(&catalogue).expect("a catalogue as JSON");
    assert_eq!(again("catalogue.json", &text, parse_catalogue).catalogue, catalogue);
}

/// Measurements of a tool, one a line: as many records as lines.
pub fn history(data: &[u8]) {
    let Some(source) = taken(Source::from_bytes("history.jsonl", data)) else { return };
    let lines = source.text().lines().filter(|line| !line.trim().is_empty()).count();
    let Some(found) = taken(parse_history(source)) else { return };
    assert_eq!(found.records().len(), lines);
    let lines = found.records().iter().map(|record| serde_json::to_string(record).expect("a record"));
    let text = lines.map(|line| line + "\n").collect::<String>();
    assert_eq!(again("history.jsonl", &text, parse_history).records(), found.records());
}

fn again<T>(name: &str, text: &str, parse: impl Fn(Source) -> Result<T, JobError>) -> T {
    parse(Source::new(name, text)).unwrap_or_else(|error| panic!("{error}\n{text}"))
}
