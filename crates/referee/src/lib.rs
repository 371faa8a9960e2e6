//! The referee: what is left on a flank when normal rays are shortened by the moving tool.
//!
//! Stage one shortens rays of the worm by the dresser ([`dress`], [`dress_in_strokes`]), stage two rays of the workpiece by the worm that
//! stage one left ([`grind`]). Five-axis milling has one stage: rays of the workpiece shortened by cutters that follow
//! blocks ([`mill`]). Power skiving holds the balls of a rounded edge
//! against the flank ([`Skiving`]). The room knows shapes, poses and motions. It must not know how `contact` or `process`
//! find a contact: every length here comes from a ray that meets a body in a pose of the real motion, so that an error
//! in a closed form shows as a difference instead of cancelling out.

pub mod active_threads;
mod descent;
pub mod dress;
pub mod dressed_flank;
mod engagement;
pub mod error;
pub mod exact_worm;
mod fit;
pub mod grid;
pub mod grind;
mod ground_flank;
pub mod in_time;
pub mod line_dress;
mod meridian;
pub mod mill;
pub mod root;
pub mod skive;
pub mod statistics;
pub mod strokes;
mod sweep;
pub mod worm_surface;

pub use active_threads::ActiveThreads;
pub use dress::{Dressing, dress};
pub use dressed_flank::{DressedFlank, DressedRay, DressedSurface};
pub use engagement::{Grinding, GrindingMode};
pub use error::{RemovalError, Stage, Uncut};
pub use exact_worm::ExactWorm;
pub use fit::{ContactSweep, FittedRelations, LinearRelation, SeenContact, feeds_to_fit, fit_relations};
pub use grid::RayGrid;
pub use grind::grind;
pub use ground_flank::{GroundFlank, GroundRay};
pub use in_time::{TimedGrinding, grind_in_time};
pub use line_dress::{LineCut, LineDressed, LinePasses, dress_lines};
pub use mill::{
    CutterPart, CutterPlace, MillPath, MillStatistics, MilledRay, MilledRays, Milling, NormalRay, RapidHit,
    Rapids, Swept, Unmilled, mill, rapid_hits,
};
pub use root::{RootGrinding, RootRay};
pub use skive::{SkivedPlace, Skiving};
pub use statistics::Statistics;
pub use strokes::dress_in_strokes;
pub use worm_surface::{Unmodified, WormArea, WormModification};
