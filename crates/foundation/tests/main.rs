//! Shapes, motions, splines and modifications through the public interface of the crate.

mod dressing_machine;
mod geometry;
mod kinematics;
mod modification;
mod splines;
mod surfaces;
