//! Which store a program uses.

use flankwright_store::StoreAddress;

#[test]
fn a_given_address_counts_before_all_else() {
    assert_eq!(StoreAddress::chosen(Some("given.sqlite")).unwrap().to_string(), "given.sqlite");
    assert_eq!(
        StoreAddress::chosen(Some("mysql://shop:geheim@host/gears")).unwrap_err().code(),
        "invalid-store-address"
    );
}

#[test]
fn an_address_that_is_none_is_a_finding() {
    let error = StoreAddress::chosen(Some("mysql://shop:geheim@host/gears")).unwrap_err();
    let finding = error.finding();
    assert_eq!(finding.value.as_deref(), Some("mysql://shop@host/gears"));
    assert!(finding.way_out.as_deref().is_some_and(|text| text.contains("postgres://")));
}
