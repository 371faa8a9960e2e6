//! Catalogues of worms and dressers: TOML, JSON, two tables.
#![no_main]

libfuzzer_sys::fuzz_target!(|data: &[u8]| flankwright_fuzz::catalogue(data));
