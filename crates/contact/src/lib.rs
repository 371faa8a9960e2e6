//! Where worm and workpiece touch: closed forms for involute flanks (`docs/mathematics/generating-contact.md#affine-relations`) and one
//! exact solver for any worm surface given by point, normal and derivatives (section 14); and where two gears touch that are rolled against
//! each other (`rolled_pair`). Knows no dresser and no plan.

mod diagonal;
mod error;
mod exact;
mod kernel;
mod pair;
mod relative_curvature;
mod rolled_pair;
mod stand_off;
mod surface;
mod thread;
mod tip_corner;
mod working_area;

pub use diagonal::{DiagonalLine, DiagonalRatio, LineMap, PointMap, WorkPoint};
pub use error::{ContactError, FOLD_BEGINS};
pub use exact::{ContactSolution, ExactContact, Measure, Sensitivities};
pub use pair::{FlankPair, Pair};
pub use relative_curvature::RelativeCurvature;
pub use rolled_pair::{
    Arrangement, ConjugateFlanks, ContactPattern, FlankDeviation, FlankPlaces, GapField, PairGap, RollCourse,
    RolledGear, RolledPair, overlap, parts,
};
pub use stand_off::{Lever, StandOff};
pub use surface::{SurfaceJet, ToolSurface};
pub use thread::{ModifiedThread, ThreadFunction, Unmodified};
pub use tip_corner::{RootFillet, TipCorner};
pub use working_area::WorkingArea;
