//! Flanks as surfaces: areal fit with its features and their uncertainty, a surface from profiles and leads of one tooth, comparison of
//! target, produced and measured flank on one grid (`docs/mathematics/inspection.md#surfaces`). Deviations are those of material, > 0
//! material left, mm, normal or transverse as they come. Knows no file, no tolerance class and no process.

mod comparison;
mod error;
mod features;
mod field;
mod fit;
mod reconstruction;
mod tensor;
mod terms;
mod trace;

pub use comparison::{Comparison, Difference};
pub use error::ArealError;
pub use features::ArealFeatures;
pub use field::ArealField;
pub use fit::{ArealFit, ArealPoint};
pub use reconstruction::{Mismatch, OutsideTraces, Reconstruction, Zeros};
pub use terms::{ArealDegree, Term};
pub use trace::Trace;
