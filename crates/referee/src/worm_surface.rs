//! The worm as the grinding stage sees it: an involute flank, a function on it and the area that exists.

use super::RemovalError;
use super::error;
use foundation::numerics::{Polynomial2, TensorSpline};

/// A normal modification f_n1(w_1, z_1) of the worm flank, > 0 material left. mm.
pub trait WormModification: Sync {
    /// Value and derivatives by w and z.
    fn jet(&self, w: f64, z: f64) -> [f64; 3];

    /// Value alone.
    fn value(&self, w: f64, z: f64) -> f64 {
        self.jet(w, z)[0]
    }

    /// Where the function is known: `[[w, w], [z, z]]`, mm.
    fn domain(&self) -> [[f64; 2]; 2] {
        [[f64::NEG_INFINITY, f64::INFINITY]; 2]
    }

    /// Lengths of roll at which the function bends so sharply that there may be several bottoms side by side, mm.
    fn creases(&self) -> &[f64] {
        &[]
    }

    /// Bound of the function's own error, um.
    fn error_um(&self) -> f64 {
        0.0
    }
}

/// f_n1 = 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Unmodified;

impl WormModification for Unmodified {
    fn jet(&self, _: f64, _: f64) -> [f64; 3] {
        [0.0; 3]
    }
}

impl WormModification for TensorSpline {
    fn jet(&self, w: f64, z: f64) -> [f64; 3] {
        let jet = TensorSpline::jet(self, w, z);
        [jet.f, jet.fu, jet.fv]
    }

    fn value(&self, w: f64, z: f64) -> f64 {
        TensorSpline::value(self, w, z)
    }

    fn domain(&self) -> [[f64; 2]; 2] {
        TensorSpline::domain(self)
    }
}

impl WormModification for Polynomial2 {
    fn jet(&self, w: f64, z: f64) -> [f64; 3] {
        let jet = Polynomial2::jet(self, w, z);
        [jet.f, jet.fu, jet.fv]
    }
}

/// The part of the worm flank that exists: root to tip, end to end. mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WormArea {
    /// Smallest and largest length of roll.
    pub w: [f64; 2],
    /// Smallest and largest axial position.
    pub z: [f64; 2],
}

impl WormArea {
    /// The part of the area on which the modification is known.
    pub(super) fn within(&self, domain: [[f64; 2]; 2]) -> Result<Self, RemovalError> {
        error::range("worm area w", self.w)?;
        error::range("worm area z", self.z)?;
        error::positive("worm area w", self.w[1])?;
        let common = |a: [f64; 2], b: [f64; 2]| [a[0].max(b[0]), a[1].min(b[1])];
        let area =
            Self { w: common([self.w[0].max(0.0), self.w[1]], domain[0]), z: common(self.z, domain[1]) };
        error::range("common w of worm area and modification", area.w)?;
        error::range("common z of worm area and modification", area.z)?;
        Ok(area)
    }

    /// Whether a foot lies on the area.
    #[inline]
    pub fn covers(&self, w: f64, z: f64) -> bool {
        w >= self.w[0] && w <= self.w[1] && z >= self.z[0] && z <= self.z[1]
    }
}
