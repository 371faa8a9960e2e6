//! Tables and values that jobs of several processes share: one table of the file, one file here. The ranges stand beside the fields, so
//! that the published schema and the messages cannot disagree.

pub mod choices;
pub mod control;
pub mod gear;
mod gear_body;
pub mod grid;
pub mod machine;
pub mod one_or_sides;
pub mod output;
pub mod process;
pub mod target;

pub use choices::{Flanks, Hand};
pub use control::{Control, FeedSenses};
pub use gear::{Allowances, Evaluation, EvaluationRange, Gear, MeasuredOver, OverBalls, Span};
pub use grid::Grid;
pub use machine::{BODY_CLEARANCE, Clamping, ClampingBody, Machine};
pub use one_or_sides::{OneOrSides, one_or_sides_schema, pressure_angle_schema};
pub use output::{Language, Mesh, Output, Program, Table};
pub use process::{JobInfo, ProcessName};
pub use target::{Modification, default_tolerance};
