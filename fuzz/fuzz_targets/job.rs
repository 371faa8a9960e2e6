//! Job files of every process, TOML and JSON.
#![no_main]

libfuzzer_sys::fuzz_target!(|data: &[u8]| flankwright_fuzz::job(data));
