//! Programs written and read back in every dialect, and LinuxCNC as the peer of its dialect.

mod damaged_texts;
mod helical_row;
mod linuxcnc;
mod outputs;
mod peer;
mod programs;
mod round_trip;
mod shop;
mod tips;
