//! How long an import takes: 10 000 evaluated parts into SQLite and into PostgreSQL, asking for one characteristic of all of them, and files
//! with their evaluation. Prints parts per second beside the targets; `-- --test` runs a hundred parts.

#[path = "../tests/store/made.rs"]
mod made;
#[path = "../tests/store/made_file.rs"]
mod made_file;
#[path = "../tests/store/server.rs"]
#[allow(dead_code, reason = "the tests need more of it")]
mod server;

use std::time::Instant;

use flankwright::numerics::Silent;
use flankwright_store::blocking::Store;
use flankwright_store::{CharacteristicFilter, ImportSettings, PartRecord, StoreAddress};

fn main() {
    let parts = if std::env::args().any(|argument| argument == "--test") { 100 } else { 10_000 };
    let directory = tempfile::tempdir().expect("a directory");
    let records = made::parts(0..parts);
    let values: usize = records.iter().map(|part| part.characteristics.len()).sum();
    println!("{parts} parts with {values} values");
    let file = StoreAddress::file(directory.path().join("store.sqlite"));
    evaluated("SQLite", &file, &records, 20.0);
    evaluated("PostgreSQL", &server::database().parse().expect("an address"), &records, 60.0);
    files(&directory.path().join("measured"), &directory.path().join("files.sqlite"), parts / 10);
}

/// Sets of [`Store::BATCH`], each a transaction that is on the disk when it ends.
fn evaluated(name: &str, address: &StoreAddress, records: &[PartRecord], target_s: f64) {
    let store = Store::open(address).expect("a store");
    let begun = Instant::now();
    let added: usize =
        records.chunks(Store::BATCH).map(|set| store.import_parts(set).expect("an import").added).sum();
    let seconds = begun.elapsed().as_secs_f64();
    assert_eq!(added, records.len());
    let verdict = if seconds <= target_s { "met" } else { "MISSED" };
    let speed = added as f64 / seconds;
    println!("{name}: {seconds:.2} s, {speed:.0} parts/s (target for 10000: {target_s} s, {verdict})");
    let begun = Instant::now();
    let known: usize =
        records.chunks(Store::BATCH).map(|set| store.import_parts(set).expect("an import").known.len()).sum();
    println!("{name}: the same again, all {known} known: {:.2} s", begun.elapsed().as_secs_f64());
    let filter = CharacteristicFilter {
        name: Some("fHa".into()),
        statistic: Some("mean".into()),
        ..CharacteristicFilter::default()
    };
    let begun = Instant::now();
    let found = store.characteristics(&filter).expect("values").len();
    println!("{name}: {found} values of one characteristic: {:.3} s", begun.elapsed().as_secs_f64());
}

fn files(folder: &std::path::Path, store: &std::path::Path, parts: u32) {
    std::fs::create_dir(folder).expect("a folder");
    let mut bytes = 0;
    for number in 0..parts {
        let text = made_file::mka(number);
        bytes += text.len();
        std::fs::write(folder.join(format!("{number:05}.mka")), text).expect("a file");
    }
    let store = Store::open(&StoreAddress::file(store)).expect("a store");
    let begun = Instant::now();
    let report = store
        .import_measurements(&[folder.to_owned()], &ImportSettings::default(), &Silent)
        .expect("an import");
    let seconds = begun.elapsed().as_secs_f64();
    assert_eq!(report.imported.len(), parts as usize, "{:?}", report.refused.first());
    let speed = f64::from(parts) / seconds;
    println!(
        "files into SQLite, evaluation included: {parts} of {} kB: {seconds:.2} s, {speed:.0} files/s",
        bytes / 1000
    );
}
