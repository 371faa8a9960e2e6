//! Packed REXS.
#![no_main]

libfuzzer_sys::fuzz_target!(|data: &[u8]| flankwright_fuzz::rexs_packed(data));
