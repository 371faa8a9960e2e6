//! What the page of a measured gear shows, as data. um, normal to the flank, positive = material left, unless a name says otherwise.

use super::difference::DifferenceRow;
use super::{CorrectionView, EvaluationView, TestRow};
use foundation::geometry::Sides;
use report::charts::Topography;
use report::head::ReportHead;
use verdict::Verdict;

/// The whole page. What is none or empty is left out.
#[derive(Clone, Debug, PartialEq)]
pub struct MeasuredGearReport {
    /// The answer, warnings and files.
    pub head: ReportHead,
    /// Rounds of measuring and correcting against a job.
    pub rounds: Vec<RoundView>,
    /// What was judged.
    pub verdict: Verdict,
    /// Evaluation to ISO 1328-1, of the last round.
    pub evaluation: EvaluationView,
    /// Lines of the files that were not understood: file, line, beginning.
    pub not_understood: Vec<(String, usize, String)>,
}

/// A measurement against a job.
#[derive(Clone, Debug, PartialEq)]
pub struct RoundView {
    /// From 1.
    pub number: usize,
    /// Flanks that were measured.
    pub flanks: Sides<Option<FlankView>>,
    /// What all teeth share.
    pub tests: Vec<TestRow>,
    /// The correction.
    pub correction: Option<CorrectionView>,
    /// Why there is none.
    pub no_correction: Option<String>,
}

/// A flank of the target, of the process and of the part on one grid.
#[derive(Clone, Debug, PartialEq)]
pub struct FlankView {
    /// Wanted.
    pub target: Topography,
    /// By the exact contact.
    pub planned: Topography,
    /// By the referee's rays.
    pub simulated: Topography,
    /// Measured, mean over the teeth; none where it does not cover the grid.
    pub measured: Option<Topography>,
    /// What the measured surface was made of, in words.
    pub surface: String,
    /// Measured less target.
    pub deviation: DifferenceRow,
    /// Measured less simulated.
    pub model: DifferenceRow,
    /// Correlation of measured and simulated deviations.
    pub correlation: Option<f64>,
    /// Whether the process model explains the part.
    pub explained: bool,
}
