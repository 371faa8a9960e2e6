//! The page of five-axis milling: figures of the flanks, drawings of the space with cutter and paths, deviations, rows, wear, density,
//! root, contact with a mate, operations, orientation and programs. Finished numbers in, a page out.

mod compose;
mod data;
mod deviations;
mod mate;
mod orientation;
mod programs;
mod rows;
mod tables;

pub use data::{
    DensityRow, FlankFigures, FlankView, MillingReport, OperationRow, RowView, SpaceView, Titled, WearView,
};
pub use mate::{MateFlankView, MateView, PatternFigures};
pub use orientation::{OrientationView, OrientedRowView, RotaryView};
pub use programs::{AxisCourse, CourseChart, CourseLine, ProgramsView};
