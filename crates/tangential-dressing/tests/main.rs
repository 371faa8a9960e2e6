//! Tests of the crate through its public interface, in one program. Its modules are the tests, and what several of them share.

mod other_gears;
mod tangential;
mod tangential_control;
mod tangential_referee;
