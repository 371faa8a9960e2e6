//! The page of measuring a power-skiving tool: deviations of all teeth, angles and signal of the light barrier, concentricity, pitch,
//! the tooth with its contact points, poses, the workpiece to come, corrections, comparison, history, Monte Carlo, programs. Finished
//! numbers in, a page out; teeth count from 0, tracks from 1.

mod angles;
mod compose;
mod conventional;
mod corrections;
mod data;
mod edge_section;
mod history;
mod measured;
mod monte_carlo;
mod pitch;
mod poses;
mod profile;
mod programs;
mod strip;
mod tooth;
mod uncertain_figure;

pub use angles::{AngleEdge, AngleStation, AngleTrack, AngleView};
pub use conventional::ConventionalRow;
pub use corrections::{CorrectionsView, SettingChange, WearRow};
pub use data::{DataSheet, SkivingReport};
pub use edge_section::EdgeSectionView;
pub use history::{HistoryRow, HistoryView, WearTrend};
pub use measured::{FlankDeviations, MeasuredView, TrackDeviations, WorstTooth};
pub use monte_carlo::{MonteCarloRow, MonteCarloView};
pub use pitch::PitchView;
pub use poses::PoseRow;
pub use profile::{FlankProfile, ProfileView};
pub use programs::{ProgramRow, ProgramsView};
pub use strip::{StripView, ToothMark, ToothSignal};
pub use tooth::ToothView;
pub use uncertain_figure::UncertainFigure;
