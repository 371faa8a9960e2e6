//! What the report of tangential dressing shows beside what every grinding report shows: variables, their choice and fit, methods,
//! radial feed, sensitivities. Finished numbers in, sections out.

mod compose;
mod data;

pub use compose::VARIABLES;
pub use data::{
    ComparedMethod, FitRecord, PassReport, RadialFeedReport, SelectionRow, SensitivityMap, TangentialReport,
    VariableRow,
};
