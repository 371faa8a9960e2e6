//! The electronic gearbox for programs in C: `include/electronic_gearbox.h` is its description, `archive/` makes the static library.
//!
//! Nothing is allocated: the caller owns the storage of every part of the gearbox, as structures of fixed size. Nothing aborts: every
//! function gives a status, also for a null pointer, for storage that was never set up, and for a number that names no choice. What
//! cannot be checked is a pointer to something else.

#![no_std]
#![expect(
    unsafe_code,
    reason = "names for a linker of C, storage that C owns (`slot`), arrays that C owns (`array`); tests/ calls all of it from C"
)]

mod array;
mod curves;
mod engagement;
mod gear;
mod gearbox;
mod pulses;
mod slot;
mod status;

pub use curves::*;
pub use engagement::*;
pub use gear::*;
pub use gearbox::*;
pub use pulses::*;
pub use slot::{Slot, Stored};
pub use status::*;
