//! Descriptions of machines, TOML and JSON.
#![no_main]

libfuzzer_sys::fuzz_target!(|data: &[u8]| flankwright_fuzz::machine(data));
