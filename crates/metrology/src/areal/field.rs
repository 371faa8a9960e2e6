//! The field of a flank over which a surface is evaluated, and its scaled coordinates.

use super::ArealError;
use foundation::numerics::equidistant;

/// [w_f, w_a] x [z_I, z_II], mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ArealField {
    roll: [f64; 2],
    face: [f64; 2],
}

fn range(name: &'static str, [from, to]: [f64; 2]) -> Result<(), ArealError> {
    let good = from.is_finite() && to.is_finite() && from < to;
    if good { Ok(()) } else { Err(ArealError::EmptyRange { name, from, to }) }
}

impl ArealField {
    /// From lengths of roll [w_f, w_a] and axial positions [z_I, z_II], mm.
    ///
    /// # Errors
    /// [`ArealError::EmptyRange`].
    pub fn new(roll: [f64; 2], face: [f64; 2]) -> Result<Self, ArealError> {
        range("range of lengths of roll", roll)?;
        range("range of axial positions", face)?;
        Ok(Self { roll, face })
    }

    /// [w_f, w_a], mm.
    pub fn roll(&self) -> [f64; 2] {
        self.roll
    }

    /// [z_I, z_II], mm.
    pub fn face(&self) -> [f64; 2] {
        self.face
    }

    /// u of a length of roll: -1 at w_f, 1 at w_a.
    pub fn u(&self, w: f64) -> f64 {
        (2.0 * w - self.roll[0] - self.roll[1]) / (self.roll[1] - self.roll[0])
    }

    /// v of an axial position: -1 at z_I, 1 at z_II.
    pub fn v(&self, z: f64) -> f64 {
        (2.0 * z - self.face[0] - self.face[1]) / (self.face[1] - self.face[0])
    }

    /// What both fields have in common.
    ///
    /// # Errors
    /// [`ArealError::EmptyRange`] where they have nothing in common.
    pub fn common(&self, other: &Self) -> Result<Self, ArealError> {
        let both = |a: [f64; 2], b: [f64; 2]| [a[0].max(b[0]), a[1].min(b[1])];
        Self::new(both(self.roll, other.roll), both(self.face, other.face))
    }

    /// Lengths of roll and axial positions of an even grid over the field, its borders included and at least 2 x 2
    /// points; the grid of a comparison is 25 x 31.
    pub fn grid(&self, [n_w, n_z]: [usize; 2]) -> (Vec<f64>, Vec<f64>) {
        (equidistant(self.roll, n_w.max(2)), equidistant(self.face, n_z.max(2)))
    }
}
