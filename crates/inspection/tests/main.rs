//! Tests of the crate through its public interface, in one program. Its modules are the tests, and what several of them share.

mod axes;
mod bevel;
mod blanks;
mod inspection_series;
mod inspection_sheet;
mod inspection_statements;
mod inspection_verdict;
mod measured_parts;
mod milled;
