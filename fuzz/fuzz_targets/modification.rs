//! Modifications and formulas.
#![no_main]

libfuzzer_sys::fuzz_target!(|data: &[u8]| flankwright_fuzz::modification(data));
