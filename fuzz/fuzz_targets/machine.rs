//! Machine descriptions, catalogues, histories of skiving tools.
#![no_main]

libfuzzer_sys::fuzz_target!(|data: &[u8]| flankwright_fuzz::machine(data));
