//! Tables of measured traces and fields.
#![no_main]

libfuzzer_sys::fuzz_target!(|data: &[u8]| flankwright_fuzz::measured_table(data));
