//! Least squares of a + b cos(angle) + c sin(angle): what goes once around with the teeth.

use nalgebra::{Matrix3, Vector3};

/// The normal equations over some angles, for values of any number of quantities at them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Harmonic {
    /// Sum of the rows' products.
    pub normal: Matrix3<f64>,
    /// Its inverse: the covariance of a, b, c for values that scatter by 1.
    pub inverse: Matrix3<f64>,
}

impl Harmonic {
    /// 1, cos, sin of an angle, rad.
    pub fn row(angle: f64) -> Vector3<f64> {
        let (sin, cos) = angle.sin_cos();
        Vector3::new(1.0, cos, sin)
    }

    /// For rows at some angles; `None` where they do not tell the three apart at all.
    pub fn over(rows: impl IntoIterator<Item = Vector3<f64>>) -> Option<Self> {
        let normal: Matrix3<f64> = rows.into_iter().map(|row| row * row.transpose()).sum();
        Some(Self { normal, inverse: normal.try_inverse()? })
    }

    /// a, b, c of values at the same rows.
    pub fn through(&self, values: impl IntoIterator<Item = (Vector3<f64>, f64)>) -> Vector3<f64> {
        self.inverse * values.into_iter().map(|(row, value)| row * value).sum::<Vector3<f64>>()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::TAU;

    #[test]
    fn a_wave_is_found_again_wherever_it_is_seen() {
        let wave = Vector3::new(0.4, -2.0, 0.7);
        for places in [&[0, 1, 2, 3, 4, 5, 6][..], &[0, 2, 3], &[1, 2, 3, 4]] {
            let rows: Vec<_> = places.iter().map(|k| Harmonic::row(TAU * f64::from(*k) / 7.0)).collect();
            let fit = Harmonic::over(rows.iter().copied()).unwrap();
            let found = fit.through(rows.iter().map(|row| (*row, row.dot(&wave))));
            assert!((found - wave).norm() < 1e-12, "{found}");
        }
        let even: Vec<_> = (0..8).map(|k| Harmonic::row(TAU * f64::from(k) / 8.0)).collect();
        let inverse = Harmonic::over(even).unwrap().inverse;
        assert!((inverse - Matrix3::from_diagonal(&Vector3::new(0.125, 0.25, 0.25))).norm() < 1e-15);
    }

    #[test]
    fn two_places_tell_no_wave() {
        assert_eq!(Harmonic::over([Harmonic::row(0.0), Harmonic::row(0.0)]), None);
    }
}
