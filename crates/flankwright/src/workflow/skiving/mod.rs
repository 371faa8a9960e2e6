//! Power skiving: what command, server and Python call for it.

pub mod programs;
