//! Two gears on axes that cross, rolled against each other: where their flanks touch, by a search over places that knows no contact
//! condition, and beside it what the ease-off of a conjugate pair says (`docs/mathematics/milling.md#flanks-as-patches`).
//!
//! The frame is that of the first gear: its axis is z, both apexes are the origin, the pitch line lies in the plane of y and z. The axis
//! of the second gear lies in that plane too, at the shaft angle from z. Like meets like: the left flank of a space of the first gear
//! touches the left flank of a space of the second one, both seen from their heels.

mod course;
mod field;
mod figures;
mod foretold;
mod pair;
mod touch;

pub use course::RollCourse;
pub use field::{FlankPlaces, GapField};
pub use figures::{ContactPattern, overlap};
pub use foretold::ConjugateFlanks;
pub use pair::{PairGap, RolledGear, RolledPair};
