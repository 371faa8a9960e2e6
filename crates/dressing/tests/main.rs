//! Tests of the crate through its public interface, in one program. Its modules are the tests, and what several of them share.

mod dressing;
mod dressing_axes;
mod dressing_bodies;
mod dressing_conditions;
mod dressing_limits;
mod dressing_range;
mod dressing_referee;
mod dressing_strokes;
