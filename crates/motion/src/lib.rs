//! Motions of a machine's axes: strokes of bodies driven by a machine, their speed under the limits of every axis, their neutral
//! program, and the bodies' motions read back from a program. Knows machines and neutral programs; knows no dialect, no file, no flank
//! but the sizes by which a deviation of the axes shows on it.

mod axes;
mod course;
mod drive;
mod error;
mod layout;
mod line_course;
pub mod milling;
mod path;
mod read_back;
mod s_curve;
mod speed;
mod trace;
mod waypoint;

pub use axes::{AxisWords, axis_words};
pub use course::{Course, DressingCourse, GrindingCourse, beyond, dresser_contacts};
pub use error::MotionError;
pub use layout::{
    Coupling, Layout, LayoutOptions, LinePass, Pass, PassReport, WorkGear, in_words, lay_out, lay_out_lines,
};
pub use line_course::{BesideLine, LineContact, LineCourse};
pub use path::AxisPath;
pub use read_back::{DressingPlace, ReadStroke, Tracked, track};
pub use s_curve::SCurve;
pub use speed::{Braked, PathLimits};
pub use trace::{AxisTrace, TraceRow};
pub use waypoint::{BodyPlace, Waypoint};
