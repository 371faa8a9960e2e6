//! All tests of the crate through its public interface, in one program: a program for each file would link the crate some seventy times.
//! Its modules are the tests, and what several of them share.

mod clamping;
mod crates;
mod example_pages;
mod german_help;
mod german_reports;
mod hostile_files;
mod line_programs;
mod linuxcnc;
mod machines;
#[path = "../../inspection/tests/measured_parts/mod.rs"]
mod measured_parts;
#[path = "../../milling/tests/milling_example.rs"]
mod milling_example;
#[path = "../../nc/tests/peer/mod.rs"]
mod peer;
mod plain_names;
mod programs;
mod refusals;
mod scene;
mod tampering;
mod tampering_grinding;
mod templates;
