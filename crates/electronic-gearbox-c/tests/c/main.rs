//! The C interface as a program in C sees it.

mod archive;
mod header;
mod linuxcnc;
mod programs;
