//! NC programs of three controls, netlists, cutter locations.
#![no_main]

libfuzzer_sys::fuzz_target!(|data: &[u8]| flankwright_fuzz::program(data));
