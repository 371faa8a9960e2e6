//! The closed loop (`docs/mathematics/inspection.md#correction`): what settings of grinding and dressing do to the flank, which correction
//! of them removes a measured deviation within their bounds, what stays, and which settings were off. Knows no measuring files, no
//! statistics of teeth and no referee.

pub mod closed_loop;
pub mod column;
mod dressing;
pub mod error;
pub mod forward;
mod gearing_offset;
pub mod influence;
pub mod setting;
mod settings_worm;
pub mod solve;
pub mod task;
pub mod thinning;

pub use closed_loop::{ClosedLoop, LoopEnd, gain_is_stable};
pub use column::{Column, FlankPoint, worm_column};
pub use dressing::{DressingInfluence, FlankDressing, TwoFlankPattern};
pub use error::CorrectionError;
pub use forward::SettingsFlank;
pub use gearing_offset::offset_of_gearing;
pub use influence::SettingInfluence;
pub use setting::{Setting, SettingUnit, Stage};
pub use settings_worm::SettingsWorm;
pub use solve::{CorrectedSetting, Correction};
pub use task::{CorrectionTask, Weighting};
pub use thinning::thinned;
