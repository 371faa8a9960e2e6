//! How large the grid of a flank can be.

/// More lines than this of one kind are not a program any more (`docs/mathematics/milling.md#columns-and-rows`).
pub const MOST_LINES: usize = 20_000;
