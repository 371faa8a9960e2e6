//! The referee against exact solutions, reference numbers and itself.

mod combinations;
mod dressing;
mod errors;
mod feed_marks;
mod fit;
mod grinding;
mod left_out_threads;
mod setups;
mod threads;
