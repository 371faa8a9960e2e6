//! A store that was damaged is found out.

use flankwright_store::StoreAddress;
use flankwright_store::blocking::Store;

use crate::made::{part, parts};
use crate::place::{Place, on_both};

on_both! {
    a_sound_store_has_no_faults
    a_part_without_all_of_its_values_is_found
    a_body_that_cannot_be_read_is_found
}

fn a_sound_store_has_no_faults(place: &Place) {
    let store = place.open();
    store.import_parts(&parts(0..3)).unwrap();
    let health = store.health().unwrap();
    assert_eq!((health.parts, health.plans, health.bodies, health.tool_measurements), (3, 0, 0, 0));
    assert_eq!((health.values, health.faults), (3 * part(0).characteristics.len() as u64, vec![]));
}

fn a_part_without_all_of_its_values_is_found(place: &Place) {
    let store = place.open();
    store.import_parts(&parts(0..3)).unwrap();
    place.run("DELETE FROM flankwright.measured_value WHERE place = 3 AND part = (SELECT max(part) FROM flankwright.measured_value)");
    assert_eq!(store.health().unwrap().faults, ["1 parts have not all of their values"]);
}

fn a_body_that_cannot_be_read_is_found(place: &Place) {
    let store = place.open();
    place.run(
        "INSERT INTO flankwright.body (kind, name, place, entry) VALUES ('worm', 'W', 0, '{\"name\": 7}')",
    );
    let faults = store.health().unwrap().faults;
    assert!(faults.len() == 1 && faults[0].starts_with("worm cannot be read"), "{faults:?}");
    let error = store.catalogue().unwrap_err();
    assert_eq!(error.code(), "damaged-store", "{error}");
}

#[test]
fn broken_pages_are_found() {
    let place = Place::sqlite();
    place.open().import_parts(&parts(0..50)).unwrap();
    let mut bytes = std::fs::read(&place.text).unwrap();
    // The header stays; every later page has a hole.
    for page in bytes.chunks_mut(4096).skip(3) {
        page[..64].fill(0x5a);
    }
    std::fs::write(&place.text, bytes).unwrap();
    let health = Store::open(&StoreAddress::file(&place.text)).and_then(|store| store.health());
    match health {
        Ok(health) => assert!(!health.faults.is_empty()),
        Err(error) => assert_eq!(error.code(), "damaged-store", "{error}"),
    }
}
