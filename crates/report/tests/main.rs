//! Tests of the crate through its public interface, in one program. Its modules are the tests, and what several of them share.

mod report;
mod report_sample;
