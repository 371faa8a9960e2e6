//! The flank that is to be made: an involute helicoid, modified along its profile only. Its section at z = 0 screwed along the axis is
//! the whole flank (`docs/mathematics/skiving.md#tool-and-workpiece`).

use super::SkivingError;
use foundation::geometry::{Helicoid, Modified, NormalOffset, Surface};
use foundation::numerics::equidistant;
use nalgebra::Vector3;
use std::sync::Arc;

/// A flank of a tooth space with the range of its length of roll.
#[derive(Clone, Debug)]
pub struct SkivedFlank {
    helicoid: Helicoid,
    modified: Option<Modified<Helicoid>>,
    range: [f64; 2],
}

/// A place of the profile at z = 0; a modified one lies off that plane. mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ProfilePlace {
    /// Q.
    pub point: Vector3<f64>,
    /// The unit normal out of the material.
    pub normal: Vector3<f64>,
    /// f_n: the profile modification there, > 0 = material left.
    pub modification: f64,
}

/// Places at which a modification is compared with itself elsewhere along the tooth, and what counts as the same, mm.
const PLACES: usize = 9;
const SAME: f64 = 1e-12;

impl SkivedFlank {
    /// An unmodified flank between two lengths of roll, mm.
    ///
    /// # Errors
    /// [`SkivingError::BelowBaseCircle`], [`SkivingError::InvalidNumber`].
    pub fn new(helicoid: Helicoid, range: [f64; 2]) -> Result<Self, SkivingError> {
        let [from, to] = range;
        if !(from.is_finite() && to.is_finite()) {
            let (field, value) = ("length_of_roll", if from.is_finite() { to } else { from });
            return Err(SkivingError::InvalidNumber { field, value, allowed: "a finite length" });
        }
        if from <= 0.0 {
            return Err(SkivingError::BelowBaseCircle { w: from });
        }
        if from >= to {
            let (field, allowed) = ("length_of_roll", "the end above the start");
            return Err(SkivingError::InvalidNumber { field, value: to, allowed });
        }
        Ok(Self { helicoid, modified: None, range })
    }

    /// The flank with a modification f_n of its profile, within `lengths` along the tooth.
    ///
    /// # Errors
    /// [`SkivingError::LeadModificationNotSupported`] where it is not the same all along the tooth.
    pub fn modified(self, offset: Arc<dyn NormalOffset>, lengths: [f64; 2]) -> Result<Self, SkivingError> {
        for w in equidistant(self.range, PLACES) {
            let middle = offset.jet(w, 0.5 * (lengths[0] + lengths[1])).f;
            for z in equidistant(lengths, PLACES) {
                let difference = offset.jet(w, z).f - middle;
                if difference.is_nan() || difference.abs() > SAME {
                    return Err(SkivingError::LeadModificationNotSupported { w, z, difference });
                }
            }
        }
        Ok(Self { modified: Some(Modified::new(self.helicoid, offset)), ..self })
    }

    /// The helicoid without its modification.
    pub fn helicoid(&self) -> &Helicoid {
        &self.helicoid
    }

    /// Whether it is more than the involute.
    pub(super) fn is_modified(&self) -> bool {
        self.modified.is_some()
    }

    /// The modification along the profile: value, slope, bend.
    pub(super) fn modification_jet(&self, w: f64) -> [f64; 3] {
        self.modified.as_ref().map_or([0.0; 3], |modified| {
            let jet = modified.offset().jet(w, 0.0);
            [jet.f, jet.fu, jet.fuu]
        })
    }

    /// Lengths of roll [w_0, w_1], mm.
    pub fn range(&self) -> [f64; 2] {
        self.range
    }

    /// x = -1..1 over the range.
    pub fn edge_coordinate(&self, w: f64) -> f64 {
        (2.0 * w - self.range[0] - self.range[1]) / (self.range[1] - self.range[0])
    }

    /// The length of roll at x.
    pub fn length_of_roll(&self, x: f64) -> f64 {
        0.5 * (self.range[0] + self.range[1] + x * (self.range[1] - self.range[0]))
    }

    /// The profile at a length of roll.
    pub fn at(&self, w: f64) -> ProfilePlace {
        match &self.modified {
            None => {
                let jet = self.helicoid.jet(w, 0.0);
                ProfilePlace { point: jet.point, normal: jet.normal, modification: 0.0 }
            }
            Some(modified) => {
                let jet = modified.jet(w, 0.0);
                let modification = modified.offset().jet(w, 0.0).f;
                ProfilePlace { point: jet.point, normal: jet.normal, modification }
            }
        }
    }
}
