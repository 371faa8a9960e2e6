//! Several programs on one store at a time.

use std::thread;

use flankwright_store::PartFilter;
use flankwright_store::blocking::Store;

use crate::made::{part, parts};
use crate::place::{Place, on_both};

on_both! {
    two_importers_give_every_part_once
    all_who_open_a_new_store_get_it
    who_reads_is_not_kept_waiting_by_who_writes
}

const PARTS: u32 = 1000;

fn two_importers_give_every_part_once(place: &Place) {
    // Nobody has made the tables yet; one goes forwards, the other backwards.
    let import = |backwards: bool| {
        let mut list = parts(0..PARTS);
        if backwards {
            list.reverse();
        }
        let address = place.address();
        move || {
            let store = Store::open(&address).unwrap();
            list.chunks(100).map(|set| store.import_parts(set).unwrap().added).sum::<usize>()
        }
    };
    let (one, other) = (thread::spawn(import(false)), thread::spawn(import(true)));
    let added = [one.join().unwrap(), other.join().unwrap()];
    assert_eq!(added.iter().sum::<usize>(), PARTS as usize, "{added:?}");
    let store = place.open();
    let mut found: Vec<u32> =
        store.parts(&PartFilter::default()).unwrap().iter().map(|part| part.part.parse().unwrap()).collect();
    found.sort_unstable();
    assert_eq!(found, (0..PARTS).collect::<Vec<_>>());
    assert_eq!(store.health().unwrap().faults, [""; 0]);
    assert_eq!(store.part(&part(500).digest).unwrap().unwrap(), part(500));
}

fn all_who_open_a_new_store_get_it(place: &Place) {
    let threads: Vec<_> = (0..6)
        .map(|_| {
            let address = place.address();
            thread::spawn(move || Store::open(&address).map(|store| store.series().unwrap().len()))
        })
        .collect();
    for thread in threads {
        assert_eq!(thread.join().unwrap().unwrap(), 0);
    }
}

fn who_reads_is_not_kept_waiting_by_who_writes(place: &Place) {
    place.open().import_parts(&parts(0..10)).unwrap();
    let address = place.address();
    let writer = thread::spawn(move || {
        let store = Store::open(&address).unwrap();
        (10..400)
            .step_by(10)
            .for_each(|from| assert_eq!(store.import_parts(&parts(from..from + 10)).unwrap().added, 10));
    });
    let reader = place.open();
    let mut before = 10;
    while !writer.is_finished() {
        let count = reader.parts(&PartFilter::default()).unwrap().len();
        // Sets of ten, whole or not there.
        assert!(count >= before && count % 10 == 0, "{before} {count}");
        before = count;
    }
    writer.join().unwrap();
    assert_eq!(reader.parts(&PartFilter::default()).unwrap().len(), 400);
}
