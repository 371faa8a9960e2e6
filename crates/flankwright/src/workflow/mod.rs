//! The rooms' meeting place: what command line, server and Python call. Knows every layer below, and no user interface.

pub mod verify;
