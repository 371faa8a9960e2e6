//! The worm without a surface through its rays: wherever the grinding stage asks, a ray of the dressing stage is shortened.
//!
//! It costs a search over the dressing stroke for every question, so it serves samples: it tells what the spline between the rays
//! of the fast way leaves, and by how much the two stages together agree with a closed theory.

use super::dress::Cutter;
use super::meridian::FINEST;
use super::{DressedSurface, Dressing, RemovalError, WormModification};

/// A worm flank as its dresser leaves it, asked point by point.
pub struct ExactWorm<'a> {
    cutter: Cutter<'a>,
    /// Where it is known, and where a rough answer does: searches for the place of the cut.
    surface: DressedSurface,
}

impl<'a> ExactWorm<'a> {
    /// The flank that `dressing` leaves; `surface` is the spline through its rays.
    ///
    /// # Errors
    /// As [`super::dress`].
    pub fn new(dressing: &'a Dressing<'a>, surface: DressedSurface) -> Result<Self, RemovalError> {
        Ok(Self { cutter: Cutter::new(dressing, FINEST)?, surface })
    }
}

impl WormModification for ExactWorm<'_> {
    /// NaN, which no ray ends on, where the dresser does not finish the worm.
    fn jet(&self, w: f64, z: f64) -> [f64; 3] {
        self.cutter.jet(w, z).unwrap_or([f64::NAN; 3])
    }

    fn value(&self, w: f64, z: f64) -> f64 {
        self.surface.value(w, z)
    }

    fn domain(&self) -> [[f64; 2]; 2] {
        self.surface.domain()
    }

    fn error_um(&self) -> f64 {
        self.cutter.error_um()
    }
}
