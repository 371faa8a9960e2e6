//! Ranges along a trace: where it is evaluated, from the drawing or by default (`docs/mathematics/inspection.md#one-trace`).

use super::InspectionError;
use super::error::usable;
use foundation::geometry::InvoluteFlank;

/// A range of a trace's abscissa (length of roll of a profile, axial position of a helix) with a length above 0. mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EvaluationRange {
    from: f64,
    to: f64,
}

impl EvaluationRange {
    /// From and to, mm.
    ///
    /// # Errors
    /// [`InspectionError::EmptyRange`] unless it begins before it ends; [`InspectionError::InvalidNumber`].
    pub fn new(from: f64, to: f64) -> Result<Self, InspectionError> {
        for (field, value) in [("begin of the evaluation range", from), ("end of the evaluation range", to)] {
            usable(field, value, true, "a finite length")?;
        }
        if from < to { Ok(Self { from, to }) } else { Err(InspectionError::EmptyRange { from, to }) }
    }

    /// Range of roll between two diameters, mm.
    ///
    /// # Errors
    /// [`InspectionError::BelowBaseCircle`], those of [`EvaluationRange::new`].
    pub fn between_diameters(flank: &InvoluteFlank, diameters: [f64; 2]) -> Result<Self, InspectionError> {
        let [a, b] = [roll_at_diameter(flank, diameters[0])?, roll_at_diameter(flank, diameters[1])?];
        // Towards the tip the diameters of an internal gear fall, and so does the roll.
        Self::new(a.min(b), a.max(b))
    }

    /// Range of a profile for which a drawing states no range: from the control diameter over 95 percent of the length of roll to the
    /// tip form diameter. Not verified against the text of the standard.
    ///
    /// # Errors
    /// Those of [`EvaluationRange::between_diameters`].
    pub fn default_profile(
        flank: &InvoluteFlank,
        control_diameter: f64,
        tip_form_diameter: f64,
    ) -> Result<Self, InspectionError> {
        let [from, to] =
            [roll_at_diameter(flank, control_diameter)?, roll_at_diameter(flank, tip_form_diameter)?];
        let end = from + 0.95 * (to - from);
        Self::new(from.min(end), from.max(end))
    }

    /// Range of a helix for which a drawing states no range: the face width, z = 0 in its middle, without the smaller of 5 percent and
    /// one normal module at each end. Not verified against the text of the standard.
    ///
    /// # Errors
    /// Those of [`EvaluationRange::new`].
    pub fn default_helix(face_width: f64, normal_module: f64) -> Result<Self, InspectionError> {
        let half = face_width / 2.0 - (0.05 * face_width).min(normal_module);
        Self::new(-half, half)
    }

    /// Where it begins, mm.
    pub fn from(&self) -> f64 {
        self.from
    }

    /// Where it ends, mm.
    pub fn to(&self) -> f64 {
        self.to
    }

    /// Its length, mm.
    pub fn length(&self) -> f64 {
        self.to - self.from
    }

    /// The abscissa counted from -1 at the begin to +1 at the end.
    pub fn unit(&self, a: f64) -> f64 {
        (2.0 * a - self.from - self.to) / self.length()
    }

    /// How far beside an end a sample still counts as lying at it, mm.
    pub(super) fn slack(&self) -> f64 {
        1e-9 * self.from.abs().max(self.to.abs()).max(1.0)
    }
}

/// Length of roll at a diameter, mm.
///
/// # Errors
/// [`InspectionError::BelowBaseCircle`].
pub fn roll_at_diameter(flank: &InvoluteFlank, diameter: f64) -> Result<f64, InspectionError> {
    flank.length_of_roll(diameter / 2.0).map_err(|_| InspectionError::BelowBaseCircle {
        flank: flank.flank,
        diameter,
        base_diameter: 2.0 * flank.base_radius,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use foundation::geometry::{Flank, Gear, GearData, Sides};

    fn pinion() -> Gear {
        Gear::new(GearData {
            teeth: 51,
            normal_module: 1.0,
            pressure_angle: Sides::both(20f64.to_radians()),
            helix_angle: 0.0,
            profile_shift: -0.1827,
            cone_angle: 0.0,
        })
        .unwrap()
    }

    #[test]
    fn ranges_follow_from_diameters_and_defaults() {
        let gear = pinion();
        let flank = gear.flank(Flank::Left);
        let range = EvaluationRange::between_diameters(flank, [52.9, 50.4]).unwrap();
        assert!((flank.radius(range.from()) - 25.2).abs() < 1e-12);
        assert!((flank.radius(range.to()) - 26.45).abs() < 1e-12);
        assert_eq!([range.from(), range.to()].map(|a| range.unit(a).round()), [-1.0, 1.0]);
        let default = EvaluationRange::default_profile(flank, 50.4, 52.9).unwrap();
        assert!((default.length() - 0.95 * range.length()).abs() < 1e-12);
        assert_eq!(default.from(), range.from());
        // 5 percent of a narrow face, one module of a wide one.
        assert_eq!(EvaluationRange::default_helix(20.0, 3.0).unwrap().to(), 9.0);
        assert_eq!(EvaluationRange::default_helix(100.0, 3.0).unwrap().from(), -47.0);
    }

    #[test]
    fn ranges_without_length_are_refused() {
        let gear = pinion();
        let error = EvaluationRange::between_diameters(gear.flank(Flank::Right), [40.0, 52.0]).unwrap_err();
        assert_eq!(error.code(), "below-base-circle");
        assert_eq!(EvaluationRange::new(2.0, 2.0).unwrap_err().code(), "empty-range");
        assert_eq!(EvaluationRange::new(3.0, 2.0).unwrap_err().code(), "empty-range");
        assert_eq!(EvaluationRange::new(f64::NAN, 2.0).unwrap_err().code(), "invalid-number");
        assert_eq!(EvaluationRange::new(0.0, f64::INFINITY).unwrap_err().code(), "invalid-number");
    }
}
