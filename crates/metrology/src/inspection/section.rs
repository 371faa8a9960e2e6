//! The section in which a deviation was measured, and what it is in the transverse section (`docs/mathematics/inspection.md`).

use super::InspectionError;

/// Direction in which deviations of a file are counted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MeasuredSection {
    /// In the transverse section, f_t.
    Transverse,
    /// Normal to the flank, f_n = f_t cos(beta_b).
    Normal,
    /// In the axial section.
    Axial,
}

impl MeasuredSection {
    /// Factor that makes transverse deviations of those of this section; `base_helix_angle` in rad.
    ///
    /// # Errors
    /// [`InspectionError::UnverifiedSetting`] for the axial section.
    pub fn to_transverse(self, base_helix_angle: f64) -> Result<f64, InspectionError> {
        match self {
            Self::Transverse => Ok(1.0),
            Self::Normal => Ok(1.0 / base_helix_angle.cos()),
            Self::Axial => {
                Err(InspectionError::UnverifiedSetting { setting: "measurement in the axial section" })
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn normal_values_grow_in_the_transverse_section() {
        let beta = 0.5_f64;
        assert_eq!(MeasuredSection::Transverse.to_transverse(beta), Ok(1.0));
        let factor = MeasuredSection::Normal.to_transverse(beta).unwrap();
        assert!((factor * beta.cos() - 1.0).abs() < 1e-15);
        assert_eq!(MeasuredSection::Axial.to_transverse(beta).unwrap_err().code(), "unverified-setting");
    }
}
