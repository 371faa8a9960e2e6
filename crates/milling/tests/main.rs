//! Tests of the crate through its public interface, in one program. Its modules are the tests, and what several of them share.

mod milled_jobs;
mod milling_bevel;
mod milling_clamping;
mod milling_clearance;
mod milling_conical;
mod milling_ends;
mod milling_errors;
mod milling_example;
mod milling_grid;
mod milling_keys;
mod milling_mate;
mod milling_obstacles;
mod milling_points;
mod milling_programs;
mod milling_report;
mod milling_shop;
mod milling_verdict;
#[expect(dead_code, reason = "the tests of the controls use the rest")]
#[path = "../../nc/tests/peer/mod.rs"]
mod peer;
#[expect(dead_code, reason = "the tests of the shapes use the rest")]
#[path = "../../foundation/tests/surfaces/cases.rs"]
mod surface_cases;
