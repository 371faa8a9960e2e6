//! What may be at an address: nothing, a store, a newer one, something else. What is not ours stays as it is.

use std::fs;

use flankwright_store::{StoreAddress, blocking::Store};
use sqlx::{Connection, Row, SqliteConnection};

use crate::made::{part, parts};
use crate::place::{Place, on_both};
use crate::server::block_on;

on_both! {
    a_newer_store_is_left_alone
    tables_that_were_changed_by_hand_are_no_store
    a_store_is_opened_again
}

fn a_newer_store_is_left_alone(place: &Place) {
    drop(place.open());
    place.run(
        "INSERT INTO flankwright._sqlx_migrations (version, description, success, checksum, execution_time) \
         SELECT 4, 'newer', success, checksum, 0 FROM flankwright._sqlx_migrations WHERE version = 3",
    );
    let error = Store::open(&place.address()).unwrap_err();
    let finding = error.finding();
    assert_eq!((finding.code, finding.field.as_deref()), ("newer-store", Some("store")));
    assert!(error.to_string().contains("version 4") && error.to_string().contains("version 3"), "{error}");
    assert_eq!(Store::open_existing(&place.address()).unwrap_err().code(), "newer-store");
}

fn tables_that_were_changed_by_hand_are_no_store(place: &Place) {
    drop(place.open());
    place.run("UPDATE flankwright._sqlx_migrations SET version = -version");
    let error = Store::open(&place.address()).unwrap_err();
    assert_eq!(error.code(), "not-a-store", "{error}");
}

fn a_store_is_opened_again(place: &Place) {
    place.open().import_parts(&parts(0..2)).unwrap();
    for _ in 0..3 {
        let store = Store::open_existing(&place.address()).unwrap();
        assert_eq!(store.part(&part(1).digest).unwrap().unwrap(), part(1));
        assert_eq!(store.health().unwrap().tables, 3);
    }
}

fn code(text: &str) -> String {
    let error = Store::open(&text.parse::<StoreAddress>().unwrap()).unwrap_err();
    assert!(error.to_string().contains(text), "{error}");
    error.code().to_owned()
}

#[test]
fn a_file_is_made_with_its_directories_and_keeps_a_log() {
    let directory = tempfile::tempdir().unwrap();
    let path = directory.path().join("a/b ü/store.sqlite");
    let address = StoreAddress::file(&path);
    assert_eq!(Store::open_existing(&address).unwrap_err().code(), "missing-store");
    assert!(!path.exists());
    let store = Store::open(&address).unwrap();
    store.import_parts(&parts(0..2)).unwrap();
    assert!(path.with_extension("sqlite-wal").exists(), "no write-ahead log");
    drop(store);
    assert!(!path.with_extension("sqlite-wal").exists(), "closing leaves one file");
    let mode = block_on(async {
        let mut connection = SqliteConnection::connect(&format!("sqlite:{}", path.display())).await.unwrap();
        let row = sqlx::query("PRAGMA journal_mode").fetch_one(&mut connection).await.unwrap();
        row.get::<String, _>(0)
    });
    assert_eq!(mode, "wal");
}

#[test]
fn what_is_no_store_stays_as_it_is() {
    let directory = tempfile::tempdir().unwrap();
    let text = directory.path().join("text");
    fs::write(&text, "no database, but long enough to be taken for one".repeat(100)).unwrap();
    let before = fs::read(&text).unwrap();
    assert_eq!(code(text.to_str().unwrap()), "not-a-store");
    assert_eq!(fs::read(&text).unwrap(), before);

    let other = directory.path().join("other.sqlite");
    block_on(async {
        let address = format!("sqlite:{}?mode=rwc", other.display());
        let mut connection = SqliteConnection::connect(&address).await.unwrap();
        sqlx::query("CREATE TABLE part (id INTEGER)").execute(&mut connection).await.unwrap();
        connection.close().await.unwrap();
    });
    let before = fs::read(&other).unwrap();
    assert_eq!(code(other.to_str().unwrap()), "not-a-store");
    assert_eq!(fs::read(&other).unwrap(), before);

    assert_eq!(code(directory.path().to_str().unwrap()), "unreachable-store");
    // A directory cannot be made where a file is.
    assert_eq!(code(text.join("store.sqlite").to_str().unwrap()), "unreachable-store");
}

#[cfg(unix)]
#[test]
fn a_file_that_may_not_be_written_is_told() {
    use std::os::unix::fs::PermissionsExt;
    let directory = tempfile::tempdir().unwrap();
    let path = directory.path().join("store.sqlite");
    drop(Store::open(&StoreAddress::file(&path)).unwrap());
    fs::set_permissions(&path, fs::Permissions::from_mode(0o444)).unwrap();
    fs::set_permissions(directory.path(), fs::Permissions::from_mode(0o555)).unwrap();
    let opened =
        Store::open(&StoreAddress::file(&path)).and_then(|store| store.import_parts(&parts(0..1)).map(drop));
    // Whoever is root may write everything.
    let may = fs::write(directory.path().join("probe"), "").is_ok();
    match opened {
        Ok(()) => assert!(may, "a file was written that may not be"),
        Err(error) => {
            assert!(!may && matches!(error.code(), "unreachable-store" | "store-failed"), "{error}");
            assert!(error.to_string().contains("store.sqlite"), "{error}");
        }
    }
    fs::set_permissions(directory.path(), fs::Permissions::from_mode(0o755)).unwrap();
}
