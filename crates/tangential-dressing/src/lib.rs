//! Tangential dressing motion (`docs/mathematics/tangential-dressing.md`): the dresser shifts, tilts and turns while it travels along the
//! worm, and the worm carries that to the gear by its axial shift. Forward model and inverse on the exact contact solver of the other
//! processes; knows no referee.

mod channel;
mod error;
mod existing;
mod fit;
mod forward;
pub mod job;
mod model;
mod motion;
pub mod page;
mod process;
mod profile;
mod radial_feed;
mod selection;
mod settings;
mod strokes;
mod target;
pub mod workflow;
mod worm_surface;

pub use channel::{Abscissa, Channel, LARGEST_EXPONENT, Shape, Variable};
pub use error::TangentialError;
pub use existing::{CarriedProfile, ExistingDresser};
pub use fit::{Fit, FitLimits, FitMethod, FitTask, Judged};
pub use forward::{FlankPoint, RollGrid, TangentialFlank};
pub use model::{DressedLine, ShiftOffset, ShiftRatio, TangentialInput, TangentialModel};
pub use motion::DressingRow;
pub use process::TangentialDressing;
pub use profile::ProfileKind;
pub use radial_feed::RadialFeed;
pub use selection::{Selection, SelectionStep, SelectionTask};
pub use settings::TangentialSettings;
pub use strokes::TangentialStrokes;
pub use target::{EdgeAmounts, FitGrid, Wanted, Weights};
