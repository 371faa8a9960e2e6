//! The catalogue of worms and dressers: merged or replaced, whole or not at all, in its order.

use std::path::Path;

use flankwright::exchange::catalogue::{Catalogue, read_catalogue};
use flankwright_store::CatalogueReport;

use crate::place::{Place, on_both};

on_both! {
    a_catalogue_comes_out_as_it_went_in
    bodies_are_merged_by_name
    a_catalogue_takes_the_place_of_another
    a_catalogue_that_contradicts_itself_is_refused
}

fn example() -> Catalogue {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples/catalogue/bodies.toml");
    read_catalogue(&path).unwrap().catalogue
}

fn report(added: usize, changed: usize, unchanged: usize, removed: usize) -> CatalogueReport {
    CatalogueReport { added, changed, unchanged, removed }
}

fn a_catalogue_comes_out_as_it_went_in(place: &Place) {
    let (store, example) = (place.open(), example());
    let count = example.worm.len() + example.dresser.len();
    assert_eq!(store.import_catalogue(&example, false).unwrap(), report(count, 0, 0, 0));
    assert_eq!(store.catalogue().unwrap(), example);
    assert_eq!(store.import_catalogue(&example, true).unwrap(), report(0, 0, count, 0));
    assert_eq!(place.open().catalogue().unwrap(), example);
}

fn bodies_are_merged_by_name(place: &Place) {
    let (store, example) = (place.open(), example());
    store.import_catalogue(&example, false).unwrap();
    let mut some = Catalogue { worm: example.worm[1..3].to_vec(), dresser: example.dresser[..1].to_vec() };
    some.worm[0].width += 1.0;
    some.worm[1].name = "new".into();
    assert_eq!(store.import_catalogue(&some, false).unwrap(), report(1, 1, 1, 0));
    let mut expected = example;
    expected.worm[1] = some.worm[0].clone();
    expected.worm.push(some.worm[1].clone());
    assert_eq!(store.catalogue().unwrap(), expected);
}

fn a_catalogue_takes_the_place_of_another(place: &Place) {
    let (store, example) = (place.open(), example());
    store.import_catalogue(&example, false).unwrap();
    let mut some = Catalogue { worm: example.worm[1..3].to_vec(), dresser: example.dresser[..1].to_vec() };
    some.worm.reverse();
    let gone = example.worm.len() + example.dresser.len() - 3;
    assert_eq!(store.import_catalogue(&some, true).unwrap(), report(0, 0, 3, gone));
    assert_eq!(store.catalogue().unwrap(), some);
}

fn a_catalogue_that_contradicts_itself_is_refused(place: &Place) {
    let (store, example) = (place.open(), example());
    store.import_catalogue(&example, false).unwrap();
    let mut twice = example.clone();
    twice.worm[3].name = twice.worm[2].name.clone();
    let error = store.import_catalogue(&twice, true).unwrap_err();
    assert_eq!(error.code(), "invalid-catalogue", "{error}");
    assert_eq!(store.catalogue().unwrap(), example);
}
