//! Bodies and motions of a run as data for a 3D view: the web application draws them. What was planned stands here as it is, meshes and
//! poses; nothing is planned, judged or drawn, and no file and no user interface is known.

pub mod disc;
pub mod dressing;
pub mod generating;
pub mod grinding;
mod strokes;
mod written;

pub use grinding::scene_of_grinding;
