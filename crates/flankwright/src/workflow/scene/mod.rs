//! Bodies and motions of a run as data for a 3D view: the web application draws them. What was planned stands here as it is, meshes and
//! poses; nothing is planned, judged or drawn, and no file and no user interface is known.

mod disc;
mod dressing;
mod finish;
mod generating;
mod grinding;
mod mill;
mod milling;
mod shape;
mod skiving;
mod skiving_mesh;
mod strokes;
mod tangential;
mod threaded;
mod toothed;
mod written;

pub use grinding::scene_of_grinding;
pub use milling::scene_of_milling;
pub use shape::{Body, BodyKind, Coordinate, Frame, Scene, Stage};
pub use skiving::scene_of_skiving;
pub use tangential::scene_of_tangential;
