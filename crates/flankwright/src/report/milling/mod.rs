//! The page of five-axis milling: figures of the flanks, drawings of the space with cutter and paths, deviations, rows, wear, density,
//! root and operations. Finished numbers in, a page out.

mod compose;
mod data;
mod deviations;
mod programs;
mod rows;
mod tables;

pub use data::{DensityRow, FlankFigures, FlankView, MillingReport, OperationRow, RowView, Titled, WearView};
pub use programs::{AxisCourse, CourseLine, ProgramsView};
