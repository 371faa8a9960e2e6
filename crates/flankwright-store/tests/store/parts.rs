//! Measured parts: what goes in comes out, once, whole, in order, and filtered.

use flankwright::geometry::Flank;
use flankwright_store::blocking::Store;
use flankwright_store::{CharacteristicFilter, ImportReport, PartFilter, PartRecord, digest_of};
use proptest::prelude::*;
use serde_json::json;

use crate::made::{part, parts};
use crate::place::{Place, on_both};

on_both! {
    a_part_comes_out_as_it_went_in
    the_same_content_is_one_part
    a_part_that_is_refused_keeps_all_out
    parts_are_listed_in_the_order_of_their_dates
    values_of_a_characteristic_over_the_parts
    a_part_can_be_taken_out
}

fn a_part_comes_out_as_it_went_in(place: &Place) {
    let mut odd = part(1);
    odd.series = "Größe Ø 3/4 '\"; DROP TABLE part; --".into();
    odd.drawing = None;
    odd.date = None;
    odd.machine = None;
    odd.document = json!({ "numbers": [0.1, 1e-300, -1.7976931348623157e308, 5e-324, 9007199254740993i64], "a": { "": null } });
    let values = [0.1 + 0.2, f64::MIN_POSITIVE, -f64::MAX, 5e-324, 3.0];
    for (entry, value) in odd.characteristics.iter_mut().zip(values) {
        entry.value = value;
    }
    let store = place.open();
    assert_eq!(store.import_parts(std::slice::from_ref(&odd)).unwrap().added, 1);
    drop(store);
    let store = place.open();
    let found = store.part(&odd.digest).unwrap().unwrap();
    assert_eq!(found, odd);
    assert!(
        found
            .characteristics
            .iter()
            .zip(values)
            .all(|(entry, value)| entry.value.to_bits() == value.to_bits())
    );
    let (digest, other) = (odd.digest.clone(), digest_of(b"none"));
    assert_eq!(store.known_parts(&[&other, &digest]).unwrap().into_iter().collect::<Vec<_>>(), [digest]);
    assert!(store.known_parts(&[]).unwrap().is_empty());
    assert_eq!(store.part(&digest_of(b"none")).unwrap(), None);
}

fn the_same_content_is_one_part(place: &Place) {
    let store = place.open();
    assert_eq!(
        store.import_parts(&parts(0..5)).unwrap(),
        ImportReport { added: 5, replaced: 0, known: vec![] }
    );
    let mut again = parts(3..8);
    again.push(part(7));
    again[0].series = "another".into();
    assert_eq!(
        store.import_parts(&again).unwrap(),
        ImportReport { added: 3, replaced: 0, known: vec![0, 1, 5] }
    );
    assert_eq!(
        store.series().unwrap().iter().map(|s| (s.series.as_str(), s.parts)).collect::<Vec<_>>(),
        [("Z-17", 8)]
    );
    // The same files after another evaluation.
    let mut changed = parts(6..9);
    changed.push(part(8));
    changed.iter_mut().for_each(|part| part.series = "another".into());
    changed[0].characteristics.truncate(1);
    assert_eq!(
        store.replace_parts(&changed).unwrap(),
        ImportReport { added: 3, replaced: 2, known: vec![3] }
    );
    assert_eq!(
        store.series().unwrap().iter().map(|s| (s.series.as_str(), s.parts)).collect::<Vec<_>>(),
        [("Z-17", 6), ("another", 3)]
    );
    assert_eq!(store.part(&changed[0].digest).unwrap().unwrap(), changed[0]);
    assert!(store.health().unwrap().faults.is_empty());
}

/// What is wrong with a part.
type Wrong = (&'static str, fn(&mut PartRecord));

fn a_part_that_is_refused_keeps_all_out(place: &Place) {
    let store = place.open();
    let wrong: [Wrong; 8] = [
        ("parts[1].characteristics[2].value", |p| p.characteristics[2].value = f64::NAN),
        ("parts[1].characteristics[2].upper_limit", |p| {
            p.characteristics[2].upper_limit = Some(f64::INFINITY)
        }),
        ("parts[1].characteristics[2]", |p| p.characteristics[2] = p.characteristics[1].clone()),
        ("parts[1].digest", |p| p.digest = "ABC".into()),
        ("parts[1].date", |p| p.date = Some("1.2.26".into())),
        ("parts[1].series", |p| p.series = " ".into()),
        ("parts[1].part", |p| p.part = "a\0b".into()),
        ("parts[1].document", |p| p.document = json!({ "a": [{ "b": "\0" }] })),
    ];
    for (field, change) in wrong {
        let mut list = parts(0..3);
        change(&mut list[1]);
        let error = store.import_parts(&list).unwrap_err();
        let finding = error.finding();
        assert_eq!((finding.code, finding.field.as_deref()), ("invalid-record", Some(field)), "{error}");
        assert!(
            finding.value.is_some() && finding.allowed.is_some() && finding.way_out.is_some(),
            "{finding:?}"
        );
    }
    assert_eq!(store.parts(&PartFilter::default()).unwrap(), []);
    assert_eq!(store.health().unwrap().values, 0);
}

fn numbers(store: &Store, filter: &PartFilter) -> Vec<String> {
    store.parts(filter).unwrap().into_iter().map(|part| part.part).collect()
}

fn parts_are_listed_in_the_order_of_their_dates(place: &Place) {
    let store = place.open();
    let mut list = parts(0..6);
    let dates =
        ["2026-03-14T09:30:00", "2026-03-13", "", "2026-03-14T08:00:00", "2025-12-31T23:59:59", "2026-03-14"];
    for (part, date) in list.iter_mut().zip(dates) {
        part.date = Some(date.to_owned()).filter(|date| !date.is_empty());
    }
    list[4].machine = None;
    list[5].series = "other".into();
    store.import_parts(&list).unwrap();
    let all = PartFilter::default();
    assert_eq!(numbers(&store, &all), ["4", "1", "5", "3", "0", "2"]);
    let with = |change: fn(&mut PartFilter)| {
        let mut filter = PartFilter::default();
        change(&mut filter);
        numbers(&store, &filter)
    };
    assert_eq!(with(|f| f.series = Some("other".into())), ["5"]);
    assert_eq!(with(|f| f.machine = Some("P40".into())), ["1", "5", "3", "0", "2"]);
    assert_eq!(
        with(|f| (f.from, f.to) = (Some("2026-03-13".into()), Some("2026-03-14".into()))),
        ["1", "5", "3", "0"]
    );
    assert_eq!(with(|f| f.to = Some("2026-03-14T08:30:00".into())), ["4", "1", "5", "3"]);
    assert_eq!(with(|f| f.part = Some("' OR 1=1 --".into())), [""; 0]);
    // The newest of those that agree, in the order of all.
    assert_eq!(with(|f| f.newest = Some(2)), ["3", "0"]);
    assert_eq!(with(|f| f.newest = Some(100)), ["4", "1", "5", "3", "0", "2"]);
    assert_eq!(with(|f| (f.newest, f.to) = (Some(1), Some("2026-03-13".into()))), ["1"]);
    let newest = PartFilter { newest: Some(2), ..PartFilter::default() };
    let filter = CharacteristicFilter { parts: newest, ..CharacteristicFilter::default() };
    let values = store.characteristics(&filter).unwrap();
    assert!(!values.is_empty() && values.iter().all(|value| ["3", "0"].contains(&value.part.as_str())));
    let wrong = PartFilter { to: Some("today".into()), ..all };
    assert_eq!(store.parts(&wrong).unwrap_err().code(), "invalid-filter");
    let series = store.series().unwrap();
    assert_eq!(series[0].first.as_deref(), Some("2025-12-31T23:59:59"));
    assert_eq!(series[1].last.as_deref(), Some("2026-03-14"));
}

fn values_of_a_characteristic_over_the_parts(place: &Place) {
    let store = place.open();
    let list = parts(0..300);
    store.import_parts(&list).unwrap();
    let filter = CharacteristicFilter {
        name: Some("fHa".into()),
        flank: Some(Flank::Right),
        statistic: Some("mean".into()),
        ..CharacteristicFilter::default()
    };
    let found = store.characteristics(&filter).unwrap();
    assert_eq!(found.len(), 300);
    for (one, part) in found.iter().zip(&list) {
        let entry =
            part.characteristics.iter().find(|entry| entry.characteristic() == one.characteristic).unwrap();
        assert_eq!((&one.digest, &one.part, &one.date), (&part.digest, &part.part, &part.date));
        assert_eq!((one.value, one.lower_limit, one.upper_limit), (entry.value, Some(-6.5), Some(6.5)));
        assert_eq!(one.characteristic.key(), "fHa.right.mean");
    }
    let parts = PartFilter { part: Some("17".into()), ..PartFilter::default() };
    let of_one =
        store.characteristics(&CharacteristicFilter { parts, ..CharacteristicFilter::default() }).unwrap();
    let expected: Vec<String> =
        list[17].characteristics.iter().map(|entry| entry.characteristic().key()).collect();
    assert_eq!(of_one.iter().map(|one| one.characteristic.key()).collect::<Vec<_>>(), expected);
    assert!(
        expected.contains(&"Fr.single".to_owned())
            && expected.contains(&"ffb.left.tooth-18.single".to_owned())
    );
}

fn a_part_can_be_taken_out(place: &Place) {
    let store = place.open();
    store.import_parts(&parts(0..3)).unwrap();
    assert!(store.remove_part(&part(1).digest).unwrap());
    assert!(!store.remove_part(&part(1).digest).unwrap());
    let health = store.health().unwrap();
    assert_eq!((health.parts, health.faults.len()), (2, 0));
    assert_eq!(health.values, 2 * part(0).characteristics.len() as u64);
    assert_eq!(store.import_parts(&[part(1)]).unwrap().added, 1);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]
    #[test]
    fn any_text_and_any_finite_number_come_out_unchanged(
        texts in prop::collection::vec("[^\\p{Cc}]{0,20}[^\\p{Cc}\\s][^\\p{Cc}]{0,20}", 5),
        values in prop::collection::vec(any::<f64>().prop_filter("finite", |x| x.is_finite()), 5),
    ) {
        let place = Place::sqlite();
        let mut made = part(1);
        made.series.clone_from(&texts[0]);
        made.part.clone_from(&texts[1]);
        made.document = json!({ texts[2].as_str(): texts[3], "values": values });
        for (entry, (text, value)) in made.characteristics.iter_mut().zip(texts.iter().zip(&values)) {
            (entry.statistic, entry.value) = (text.clone(), *value);
        }
        let store = place.open();
        store.import_parts(std::slice::from_ref(&made)).unwrap();
        prop_assert_eq!(store.part(&made.digest).unwrap().unwrap(), made);
    }
}
