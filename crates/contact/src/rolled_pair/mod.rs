//! Two gears on axes that cross or are parallel, rolled against each other: where their flanks touch, by a search over places that knows no contact
//! condition, and beside it what the ease-off of a conjugate pair says (`docs/mathematics/milling.md#flanks-as-patches`).
//!
//! The frame is that of the first gear: its axis is z, the pitch line lies in the plane of y and z. The axis of the second gear lies in
//! that plane too: at the shaft angle from z with both apexes in the origin, or parallel to it. Like meets like: the left flank of a
//! space of the first gear touches the left flank of a space of the second one, both seen from their heels or from +z; but for a gear
//! inside of the other, whose left flanks meet right ones.

mod arrangement;
mod course;
mod deviation;
mod field;
mod figures;
mod foretold;
mod pair;
mod parts;
mod touch;

pub use arrangement::Arrangement;
pub use course::RollCourse;
pub use deviation::FlankDeviation;
pub use field::{FlankPlaces, GapField};
pub use figures::{ContactPattern, overlap};
pub use foretold::ConjugateFlanks;
pub use pair::{PairGap, RolledGear, RolledPair};
pub use parts::parts;
