//! Servers that are not there, do not answer, or do not let us in. The password is never told.

use std::net::TcpListener;
use std::time::{Duration, Instant};

use flankwright_store::{StoreAddress, StoreError, blocking::Store};

use crate::server;

fn refused(text: &str) -> StoreError {
    let begun = Instant::now();
    let error = Store::open(&text.parse::<StoreAddress>().unwrap()).unwrap_err();
    assert!(begun.elapsed() < Duration::from_secs(8), "{:?}", begun.elapsed());
    let finding = error.finding();
    assert_eq!((finding.code, finding.field.as_deref()), ("unreachable-store", Some("store")), "{error}");
    assert!(finding.way_out.as_deref().is_some_and(|text| text.contains("server")));
    error
}

#[test]
fn nobody_listens() {
    let port = TcpListener::bind("127.0.0.1:0").unwrap().local_addr().unwrap().port();
    let told = refused(&format!("postgres://shop:geheim@127.0.0.1:{port}/gears")).to_string();
    assert!(
        told.contains(&format!("postgres://shop@127.0.0.1:{port}/gears")) && !told.contains("geheim"),
        "{told}"
    );
}

#[test]
fn somebody_listens_and_never_answers() {
    let silent = TcpListener::bind("127.0.0.1:0").unwrap();
    let port = silent.local_addr().unwrap().port();
    let told = refused(&format!("postgres://shop:geheim@127.0.0.1:{port}/gears")).to_string();
    assert!(told.contains("timed out") && !told.contains("geheim"), "{told}");
}

#[test]
fn the_password_is_wrong() {
    let good = server::database();
    let at = good.rfind('@').unwrap();
    let told = refused(&format!("postgres://shop:geheim{}", &good[at..])).to_string();
    assert!(told.contains("password authentication failed") && !told.contains("geheim"), "{told}");
}

#[test]
fn the_database_is_not_there() {
    let told = refused(&format!("{}no_such_database", server::address())).to_string();
    assert!(told.contains("no_such_database"), "{told}");
    let password = server::address().split([':', '@']).nth(2).unwrap();
    assert!(password.len() > 10 && !told.contains(password), "{told}");
}

#[test]
fn a_server_that_goes_away_is_told() {
    let address = server::database();
    let store = Store::open(&address.parse().unwrap()).unwrap();
    let password = address.split([':', '@']).nth(2).unwrap();
    assert!(!format!("{store:?}").contains(password));
    let name = address.rsplit('/').next().unwrap();
    server::run(
        &format!("{}postgres", server::address()),
        &format!("SELECT pg_terminate_backend(pid) FROM pg_stat_activity WHERE datname = '{name}'"),
    );
    server::run(&format!("{}postgres", server::address()), &format!("DROP DATABASE {name} WITH (FORCE)"));
    let error = store.series().unwrap_err();
    assert!(matches!(error.code(), "store-failed" | "unreachable-store" | "busy-store"), "{error}");
    assert!(!error.to_string().contains(password) && !format!("{error:?}").contains(password));
}
