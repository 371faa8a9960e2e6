//! Tests of the crate through its public interface, in one program. Its modules are the tests, and what several of them share.

mod catalogue;
mod closed_loop;
mod cylindrical_pair;
mod equal_ratio;
mod fit_shift;
mod generating;
mod least_squares;
mod line_dressing;
mod spared_worms;
mod variable_ratio;
