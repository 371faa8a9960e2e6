//! What the page of a skiving tool's measurement shows, as data.

use super::{
    AngleView, ConventionalRow, CorrectionsView, EdgeSectionView, HistoryView, MeasuredView, MonteCarloView,
    PitchView, PoseRow, ProfileView, ProgramsView, StripView, ToothView,
};
use report::data::Quantity;
use report::head::ReportHead;
use verdict::Verdict;

/// The whole page. What is none or empty is left out.
#[derive(Clone, Debug, PartialEq)]
pub struct SkivingReport {
    /// The answer, warnings and files.
    pub head: ReportHead,
    /// What was judged and what was not.
    pub verdict: Verdict,
    /// Deviations of all teeth.
    pub measured: Option<MeasuredView>,
    /// Switching angles of single teeth over the radius.
    pub angles: Vec<AngleView>,
    /// Light and dark over one turn.
    pub strip: Option<StripView>,
    /// Pitch and concentricity.
    pub pitch: Option<PitchView>,
    /// Tooth 0 along the tool's axis.
    pub tooth: Option<ToothView>,
    /// Sections across the edge.
    pub edge_sections: Vec<EdgeSectionView>,
    /// Poses of the measurement, left flank first.
    pub poses: Vec<PoseRow>,
    /// What the tool will leave on the workpiece.
    pub profile: Option<ProfileView>,
    /// Changes of the setting, wear, regrinding.
    pub corrections: Option<CorrectionsView>,
    /// The conventional method beside the virtual contact points.
    pub conventional: Vec<ConventionalRow>,
    /// Measurements of the same tool so far.
    pub history: Option<HistoryView>,
    /// Scatter of all results.
    pub monte_carlo: Option<MonteCarloView>,
    /// Tool, workpiece, beam, measurement.
    pub sheets: Vec<DataSheet>,
    /// Programs of the measurement.
    pub programs: Option<ProgramsView>,
}

/// Quantities under a heading.
#[derive(Clone, Debug, PartialEq)]
pub struct DataSheet {
    /// Heading.
    pub caption: String,
    /// The quantities.
    pub quantities: Vec<Quantity>,
}
