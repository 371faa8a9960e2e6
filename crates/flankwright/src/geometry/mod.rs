//! Shapes: involute flanks, gears, worms, racks and surfaces of revolution. Knows no motion and no process.

mod sides;

pub use sides::{Flank, Sides};
