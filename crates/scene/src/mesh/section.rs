//! A section of a body.

use nalgebra::Vector3;

/// A section of a body: closed loops of points, mm. The last point of a loop is joined with its first, which is not repeated.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Section {
    /// The outer loop, in either sense.
    pub outline: Vec<Vector3<f64>>,
    /// Loops inside it without material, e.g. the bore, in either sense.
    pub holes: Vec<Vec<Vector3<f64>>>,
}

impl Section {
    pub(super) fn loops(&self) -> impl Iterator<Item = &Vec<Vector3<f64>>> {
        std::iter::once(&self.outline).chain(&self.holes)
    }
}
