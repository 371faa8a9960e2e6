//! Power skiving and its tool: the virtual edge that makes a workpiece, the places of it that touch, what errors of the tool and of the
//! machine's setting do to the flank (`docs/mathematics/skiving.md`). Knows no referee and no file.

mod contact;
mod edge;
mod edge_place;
mod error;
pub mod evaluation;
mod flank;
pub mod history;
pub mod job;
pub mod measuring;
pub mod page;
mod pair;
mod pieces;
pub mod probe_readings;
mod process;
pub mod readings;
pub mod runout;
mod setting;
mod track;
pub mod wear;
pub mod workflow;

pub use contact::{Conjugate, conjugate, parallel_conjugate, parallel_turns};
pub use edge::{EdgePiece, VirtualEdge};
pub use edge_place::{ContactPlace, EdgeSection};
pub use error::SkivingError;
pub use flank::{ProfilePlace, SkivedFlank};
pub use pair::{Kinematics, PairData, SkivingPair};
pub use process::SkivingToolMeasuring;
pub use setting::{Setting, SettingFit, SettingLimits, fit_setting, setting_sensitivity};
pub use track::{MeasuringTrack, default_track_places};
