//! Bodies as triangles and stages as frames of poses: data for a view in space and for mesh files. Knows no process.

pub mod mesh;
pub mod shape;
mod threaded;
pub mod toothed;
mod toothed_mesh;

pub use shape::{Body, BodyKind, Coordinate, Frame, Scene, Stage, numbers, place};
pub use threaded::threaded;
