//! The files of measured parts: they come out as they went in, older parts get theirs later, damage to them is found.

use std::fs;
use std::path::Path;

use flankwright::numerics::Silent;
use flankwright::workflow::inspection::{MeasurementFile, Statements};
use flankwright_store::blocking::Store;
use flankwright_store::{
    ImportSettings, MeasuredPart, MeasurementReport, PartContent, PartFilter, PartRecord, StoreError,
    digest_of,
};

use crate::made::part;
use crate::made_file::mka;
use crate::place::{Place, on_both};

on_both! {
    files_come_out_as_they_went_in
    files_of_another_part_are_refused
    a_part_is_found_by_number_and_by_digest
    a_part_of_an_earlier_version_says_what_to_do
    an_earlier_part_gets_its_files
    damaged_files_are_found
}

/// A measurement of two files with statements.
fn measured(number: u32) -> MeasuredPart {
    let file = |ending: &str, bytes: &[u8]| MeasurementFile {
        name: format!("part ü {number}.{ending}"),
        bytes: bytes.to_vec(),
    };
    let files = [file("mka", mka(number).as_bytes()), file("mew", &[0, 159, 146, 150, number as u8])];
    let statements = Statements { other_end: true, ..Statements::default() };
    let content = PartContent::new(&files, statements);
    let record = PartRecord { digest: content.digest(), part: number.to_string(), ..part(number) };
    MeasuredPart { record, content }
}

fn files_come_out_as_they_went_in(place: &Place) {
    let store = place.open();
    let parts = [measured(1), measured(2)];
    assert_eq!(store.import_measured(&parts, false).unwrap().added, 2);
    store.import_parts(&[part(3)]).unwrap();
    drop(store);
    let store = place.open();
    for one in &parts {
        let found = store.part_content(&one.record.digest).unwrap().unwrap();
        assert_eq!(found, one.content);
        assert_eq!(found.files().unwrap(), one.content.files().unwrap());
        assert!(found.statements().other_end);
        assert_eq!(store.part(&one.record.digest).unwrap().unwrap(), one.record);
    }
    let has_files: Vec<bool> =
        store.parts(&PartFilter::default()).unwrap().iter().map(|part| part.has_files).collect();
    assert_eq!(has_files.iter().filter(|has| **has).count(), 2);
    assert_eq!(store.part_content(&part(3).digest).unwrap(), None);
    let health = store.health().unwrap();
    assert_eq!((health.parts, health.parts_with_files, health.faults.len()), (3, 2, 0));
    assert!(health.file_bytes > 500 && health.file_bytes < 2 * mka(1).len() as u64, "{}", health.file_bytes);
    // The same part again, evaluated otherwise, has its files once.
    let mut again = measured(1);
    again.record.series = "another".into();
    assert_eq!(store.import_measured(&[again], true).unwrap().replaced, 1);
    // What is taken out leaves nothing.
    for one in &parts {
        assert!(store.remove_part(&one.record.digest).unwrap());
    }
    let health = store.health().unwrap();
    assert_eq!((health.parts_with_files, health.file_bytes, health.faults.len()), (0, 0, 0));
}

fn files_of_another_part_are_refused(place: &Place) {
    let store = place.open();
    let refused = |change: fn(&mut MeasuredPart), field: &str| {
        let mut parts = [measured(1), measured(2)];
        change(&mut parts[1]);
        let error = store.import_measured(&parts, false).unwrap_err();
        let finding = error.finding();
        assert_eq!((finding.code, finding.field.as_deref()), ("invalid-record", Some(field)), "{error}");
        assert!(finding.value.is_some() && finding.allowed.is_some() && finding.way_out.is_some());
    };
    refused(|part| part.content = measured(7).content, "parts[1].content");
    refused(
        |part| {
            part.content = PartContent::new(&[], Statements::default());
            part.record.digest = part.content.digest();
        },
        "parts[1].content",
    );
    refused(
        |part| {
            let file = MeasurementFile { name: "a\nb.mka".into(), bytes: vec![1] };
            part.content = PartContent::new(&[file], Statements::default());
            part.record.digest = part.content.digest();
        },
        "parts[1].content.files[0].name",
    );
    assert_eq!(store.health().unwrap().parts, 0, "all or none");
}

fn a_part_is_found_by_number_and_by_digest(place: &Place) {
    let store = place.open();
    let (one, mut twin) = (measured(1), measured(2));
    twin.record.part = "1".into();
    store.import_measured(&[one.clone(), twin.clone(), measured(3)], false).unwrap();
    assert_eq!(store.part_named("3").unwrap().digest, measured(3).record.digest);
    for length in [8, 12, 64] {
        let found = store.measurement(&one.record.digest[..length]).unwrap();
        assert_eq!((&found.part.digest, &found.content), (&one.record.digest, &one.content));
    }
    let told = |name: &str| match store.measurement(name).unwrap_err() {
        StoreError::InvalidRecord(finding) => {
            assert_eq!((finding.code, finding.field.as_deref()), ("unknown-value", Some("part")), "{name}");
            assert_eq!(finding.value.as_deref(), Some(name));
            (finding.message.to_string(), finding.allowed.unwrap_or_default().to_string())
        }
        other => panic!("{other}"),
    };
    let (message, allowed) = told("1");
    assert!(
        message.starts_with("2 parts") && allowed.contains(&one.record.digest[..12]),
        "{message} {allowed}"
    );
    for name in ["4", &one.record.digest[..7], "' OR 1=1 --", "%%%%%%%%", "ü1234567", ""] {
        assert!(told(name).0.contains("no such part"), "{name}");
    }
}

/// As version 2 of the tables had it.
fn of_an_earlier_version(place: &Place) {
    for statement in [
        "DROP TABLE flankwright.part_file",
        "DROP TABLE flankwright.part_content",
        "DELETE FROM flankwright._sqlx_migrations WHERE version = 3",
    ] {
        place.run(statement);
    }
}

fn a_part_of_an_earlier_version_says_what_to_do(place: &Place) {
    place.open().import_measured(&[measured(5)], false).unwrap();
    of_an_earlier_version(place);
    let store = Store::open_existing(&place.address()).unwrap();
    let health = store.health().unwrap();
    assert_eq!((health.tables, health.parts, health.parts_with_files), (3, 1, 0));
    assert!(health.faults.is_empty(), "{:?}", health.faults);
    let error = store.measurement("5").unwrap_err();
    let finding = error.finding();
    assert_eq!((error.code(), finding.field.as_deref()), ("part-without-measurement", Some("part")));
    let way_out = finding.way_out.unwrap_or_default();
    assert!(
        way_out.contains("store import") && finding.message.contains("part 5 of Z-17"),
        "{error} {way_out}"
    );
    // It can be given its files, once.
    assert!(store.complete_part(&measured(5).content).unwrap());
    assert!(!store.complete_part(&measured(5).content).unwrap());
    assert!(!store.complete_part(&measured(6).content).unwrap(), "there is no such part");
    assert_eq!(store.measurement("5").unwrap().content, measured(5).content);
}

fn import(store: &Store, folder: &Path, statements: Statements) -> MeasurementReport {
    let settings = ImportSettings { statements, ..ImportSettings::default() };
    store.import_measurements(&[folder.to_owned()], &settings, &Silent).unwrap()
}

fn an_earlier_part_gets_its_files(place: &Place) {
    let folder = tempfile::tempdir().unwrap();
    for number in 1..=2 {
        fs::write(folder.path().join(format!("part-{number}.mka")), mka(number)).unwrap();
    }
    let first = import(&place.open(), folder.path(), Statements::default());
    assert_eq!((first.imported.len(), first.completed), (2, 0));
    assert!(first.imported.iter().all(|part| part.has_files));
    let content = place.open().measurement("1").unwrap().content;
    assert_eq!(content.files().unwrap()[0].bytes, mka(1).as_bytes());
    assert_eq!(content.digest(), digest_of(mka(1).as_bytes()));
    of_an_earlier_version(place);
    let store = place.open();
    // Stated otherwise the stored values are not those of the files.
    let otherwise = Statements { other_end: true, ..Statements::default() };
    let report = import(&store, folder.path(), otherwise);
    assert_eq!((report.known.len(), report.completed), (2, 0));
    let report = import(&store, folder.path(), Statements::default());
    assert_eq!((report.imported.len(), report.known.len(), report.completed), (0, 2, 2));
    assert_eq!(store.measurement("1").unwrap().content, content);
    assert_eq!(import(&store, folder.path(), Statements::default()).completed, 0);
    assert!(store.health().unwrap().faults.is_empty());
}

fn damaged_files_are_found(place: &Place) {
    let store = place.open();
    store.import_measured(&[measured(1), measured(2), measured(3), measured(4)], false).unwrap();
    for statement in [
        "UPDATE flankwright.part_file SET packed = (SELECT packed FROM flankwright.part_file WHERE part = 2 AND place = 1) \
         WHERE part = 1 AND place = 0",
        "DELETE FROM flankwright.part_file WHERE part = 2 AND place = 1",
        "UPDATE flankwright.part_content SET stated = '{\"other_end\": 7}' WHERE part = 3",
    ] {
        place.run(statement);
    }
    let health = store.health().unwrap();
    assert_eq!((health.parts_with_files, health.faults.len()), (4, 3), "{:?}", health.faults);
    for (fault, word) in health.faults.iter().zip(["part 1 cannot be read", "part 2 has not all", "stated"]) {
        assert!(fault.contains(word), "{fault}");
    }
    assert_eq!(store.part_content(&measured(3).record.digest).unwrap_err().code(), "damaged-store");
    assert!(store.measurement("1").unwrap().content.files().is_err());
}
