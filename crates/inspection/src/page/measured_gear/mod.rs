//! The page of a measured gear: its flank beside the target and the process, what all teeth share, the correction and its proof, and the
//! evaluation to ISO 1328-1. Finished numbers in, a page out. The inspection sheet is another page.

mod correction;
mod data;
mod difference;
mod evaluation;
mod page;
mod pictures;
mod tests_table;

pub use correction::{CorrectionView, ProofRow, SettingRow};
pub use data::{FlankView, MeasuredGearReport, RoundView};
pub use difference::DifferenceRow;
pub use evaluation::{ArealRow, ClassRow, EvaluationView, LineRow, PitchRow, TwistRow};
pub use tests_table::TestRow;
