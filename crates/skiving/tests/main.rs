//! Tests of the crate through its public interface, in one program. Its modules are the tests, and what several of them share.

#[expect(dead_code, reason = "the tests of the controls use the rest")]
#[path = "../../nc/tests/peer/mod.rs"]
mod peer;
mod skiving;
mod skiving_calibration;
mod skiving_carriers;
mod skiving_machining;
mod skiving_programs;
mod skiving_report;
mod skiving_verdict;
