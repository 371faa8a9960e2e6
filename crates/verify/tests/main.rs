//! The reference files against the library, and the check itself against manipulated files.

mod grinding;
mod milling;
mod reference_files;
mod skiving;
