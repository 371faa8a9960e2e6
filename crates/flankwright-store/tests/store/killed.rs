//! An importer is killed with SIGKILL in the middle: what it said to be stored is there, nothing is half, doing it again completes it.

use std::io::{BufRead, BufReader, Write};
use std::process::{Command, Stdio};
use std::time::Duration;

use flankwright_store::blocking::Store;
use flankwright_store::{PartFilter, StoreAddress};

use crate::made::{part, parts};
use crate::place::{Place, on_both};

on_both! { an_importer_that_is_killed_leaves_whole_parts }

const VARIABLE: &str = "FLANKWRIGHT_STORE_TEST_IMPORT_INTO";
const PARTS: u32 = 2000;
const SET: usize = 50;

/// The child: imports set by set, and says after each how many parts are stored.
#[test]
#[ignore = "is run as a child process by the tests of this file"]
fn importer() {
    let Ok(address) = std::env::var(VARIABLE) else { return };
    let store = Store::open(&address.parse::<StoreAddress>().unwrap()).unwrap();
    let (mut stored, list) = (0, parts(0..PARTS));
    let mut output = std::io::stdout().lock();
    for set in list.chunks(SET) {
        store.import_parts(set).unwrap();
        stored += set.len();
        writeln!(output, "\nstored {stored}").unwrap();
        output.flush().unwrap();
    }
}

/// Kills an importer some time after it has said to have stored so many parts; what it said last.
fn killed(place: &Place, after: u64, wait: Duration) -> u64 {
    let mut child = Command::new(std::env::current_exe().unwrap())
        .args(["--exact", "killed::importer", "--ignored", "--nocapture"])
        .env(VARIABLE, &place.text)
        .stdout(Stdio::piped())
        .spawn()
        .unwrap();
    let mut lines = BufReader::new(child.stdout.take().unwrap()).lines();
    let mut said = 0;
    let mut next =
        || Some(lines.next()?.unwrap().strip_prefix("stored ").map(|number| number.parse::<u64>().unwrap()));
    while said < after {
        said = next().expect("a line").unwrap_or(said);
    }
    std::thread::sleep(wait);
    child.kill().unwrap();
    child.wait().unwrap();
    // What it still said before it was killed.
    while let Some(line) = next() {
        said = line.unwrap_or(said);
    }
    said
}

fn an_importer_that_is_killed_leaves_whole_parts(place: &Place) {
    let set = SET as u64;
    let mut before = 0;
    for (round, wait_us) in [(1, 0), (4, 700), (9, 1900), (15, 3300), (22, 5100)] {
        let said = killed(place, round * set, Duration::from_micros(wait_us));
        assert!(said < u64::from(PARTS), "it was killed too late to prove anything");
        let store = place.open();
        let health = store.health().unwrap();
        assert_eq!(health.faults, [""; 0]);
        // At most the set whose end it could not tell any more is there beyond.
        assert!(
            health.parts >= said.max(before) && health.parts <= said.max(before) + set,
            "{health:?} {said} {before}"
        );
        assert_eq!(health.parts % set, 0);
        assert_eq!(health.values, health.parts * part(0).characteristics.len() as u64);
        before = health.parts;
    }
    let store = place.open();
    let added: usize = parts(0..PARTS).chunks(SET).map(|set| store.import_parts(set).unwrap().added).sum();
    assert_eq!(added as u64 + before, u64::from(PARTS));
    let stored = store.parts(&PartFilter::default()).unwrap();
    assert_eq!(stored.len(), PARTS as usize);
    for number in (0..PARTS).step_by(7) {
        assert_eq!(store.part(&part(number).digest).unwrap().unwrap(), part(number));
    }
}
