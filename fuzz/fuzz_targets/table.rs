//! Tables of traces, fields, targets, tolerances, readings and pulses.
#![no_main]

libfuzzer_sys::fuzz_target!(|data: &[u8]| flankwright_fuzz::table(data));
