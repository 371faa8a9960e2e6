//! Crowning, slope and twist of a topography (`docs/mathematics/modifications.md` and
//! `docs/mathematics/generating-contact.md#what-the-grinding-motion-leaves-to-first-order`): least squares by {1, u, v, uv, u^2, v^2} and corners.

use super::Topography;
use nalgebra::{DMatrix, DVector};

/// Characteristics of a flank, transverse, mm, positive = material removed (ISO 21771).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Characteristics {
    /// Helix crowning C_beta.
    pub helix_crowning: f64,
    /// Profile crowning C_alpha.
    pub profile_crowning: f64,
    /// Helix slope C_Hbeta: > 0 removes at face II.
    pub helix_slope: f64,
    /// Profile slope C_Halpha: > 0 removes at the tip.
    pub profile_slope: f64,
    /// Twist S from the four corners.
    pub twist_corner: f64,
    /// Twist S from the bilinear term.
    pub twist_fit: f64,
}

impl Characteristics {
    /// Of a topography of normal values; `cos_b` = cos(beta_b) turns them transverse.
    pub fn of(topography: &Topography, cos_b: f64) -> Self {
        let t = topography;
        let centred = |x: &[f64]| {
            let (a, b) = (x[0], x[x.len() - 1]);
            x.iter().map(|x| (2.0 * x - a - b) / (b - a)).collect::<Vec<_>>()
        };
        let (u, v) = (centred(&t.w), centred(&t.z));
        let matrix = DMatrix::from_fn(t.f.len(), 6, |row, k| {
            let (u, v) = (u[row / t.z.len()], v[row % t.z.len()]);
            [1.0, u, v, u * v, u * u, v * v][k]
        });
        let values = DVector::from_iterator(t.f.len(), t.f.iter().map(|f| f / cos_b));
        // The six functions are independent on every grid of at least 3 x 3 points, so the normal equations are regular.
        let normal = matrix.transpose() * &matrix;
        let c = normal
            .cholesky()
            .map_or_else(|| DVector::zeros(6), |factor| factor.solve(&(matrix.transpose() * values)));
        let (i, j) = (t.w.len() - 1, t.z.len() - 1);
        Self {
            helix_crowning: -c[5],
            profile_crowning: -c[4],
            helix_slope: -2.0 * c[2],
            profile_slope: -2.0 * c[1],
            twist_corner: -(t.at(i, j) - t.at(i, 0) - t.at(0, j) + t.at(0, 0)) / cos_b,
            twist_fit: -4.0 * c[3],
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn recovers_what_a_bilinear_quadratic_flank_was_made_of() {
        let w: Vec<f64> = (0..9).map(|i| 4.0 + 2.0 * f64::from(i)).collect();
        let z: Vec<f64> = (0..11).map(|j| -20.0 + 4.0 * f64::from(j)).collect();
        let cos_b = 0.8;
        let f = w
            .iter()
            .flat_map(|&w| {
                z.iter().map(move |&z| {
                    let (u, v) = ((w - 12.0) / 8.0, z / 20.0);
                    -cos_b * (0.02 * v * v + 0.005 * u * u + 0.006 * u * v / 4.0 + 0.003 * u / 2.0)
                })
            })
            .collect();
        let c = Characteristics::of(&Topography::new(w, z, f).unwrap(), cos_b);
        for (got, want) in [
            (c.helix_crowning, 0.02),
            (c.profile_crowning, 0.005),
            (c.twist_fit, 0.006),
            (c.twist_corner, 0.006),
            (c.profile_slope, 0.003),
            (c.helix_slope, 0.0),
        ] {
            assert!((got - want).abs() < 1e-15, "{got} {want}");
        }
    }

    #[test]
    fn shapes_that_do_not_fit_are_refused() {
        assert!(Topography::new(vec![1.0, 2.0], vec![0.0, 1.0], vec![0.0; 3]).is_none());
    }
}
