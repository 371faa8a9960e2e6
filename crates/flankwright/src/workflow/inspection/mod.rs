//! Measured gears, from files to figures: what was read, evaluated after ISO 1328-1, judged by classes, beside what the measuring machine
//! printed.

mod evaluate;
mod printed;
mod result;
mod run;
mod tables;
mod write;

pub use evaluate::{EvaluatedGear, EvaluatedPitch, EvaluatedTrace, evaluate_inspection};
pub use result::{
    ClassResult, GearInspectionResult, LinesResult, PitchInspectionResult, PrintedResult, SummaryResult,
    ThicknessResult, TraceInspectionResult,
};
pub use run::{GearInspection, inspect_gear};
pub use write::write_gear_inspection;
