//! Tables that jobs name: grids over a flank, points of a blade, readings of a light barrier, stock, reference pulses.
#![no_main]

libfuzzer_sys::fuzz_target!(|data: &[u8]| flankwright_fuzz::table(data));
