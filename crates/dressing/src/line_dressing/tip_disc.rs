//! The narrow disc of line dressing: parallel sides and a rounded tip, a torus. Knows no worm.

use crate::DressingError;

/// A disc of thickness 2 r_T whose rim is rounded with r_T. mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TipDisc {
    outside_radius: f64,
    tip_radius: f64,
}

impl TipDisc {
    /// From the outside radius r_aA and the tip radius r_T.
    ///
    /// # Errors
    /// [`DressingError::InvalidNumber`].
    pub fn new(outside_radius: f64, tip_radius: f64) -> Result<Self, DressingError> {
        let invalid = |field, value, allowed| Err(DressingError::InvalidNumber { field, value, allowed });
        if !(outside_radius.is_finite() && outside_radius > 0.0) {
            return invalid("outside radius of the dresser", outside_radius, "> 0 and finite");
        }
        if !(tip_radius > 0.0 && tip_radius <= 0.5 * outside_radius) {
            return invalid(
                "tip radius of the dresser",
                tip_radius,
                "above 0, at most half the outside radius",
            );
        }
        Ok(Self { outside_radius, tip_radius })
    }

    /// Radius r_aA of the rim.
    pub fn outside_radius(&self) -> f64 {
        self.outside_radius
    }

    /// Tip radius r_T: radius of the tube.
    pub fn tip_radius(&self) -> f64 {
        self.tip_radius
    }

    /// Radius of the circle on which the centres of the tip rounding lie.
    pub fn centre_radius(&self) -> f64 {
        self.outside_radius - self.tip_radius
    }
}
