//! Curves and values of measuring machines (.mka, .mew), to their evaluation.
#![no_main]

libfuzzer_sys::fuzz_target!(|data: &[u8]| flankwright_fuzz::klingelnberg(data));
