//! Poles of the sampled loop (`docs/mathematics/gearbox.md#position-loop`), and with them whether it settles.

use super::super::error::ControlError;
use super::parameters::ServoParameters;
use foundation::numerics::bisect;
use nalgebra::Complex;

/// Coefficients of the characteristic polynomial in u = z - 1, u^3 + c2 u^2 + c1 u + c0, as [c0, c1, c2]. Slow loops
/// have their poles near z = 1; about that point nothing of them is lost.
pub(super) fn characteristic(parameters: &ServoParameters) -> [f64; 3] {
    let ts = parameters.sample_time;
    let rate = ts / parameters.drive.inertia;
    let gains = &parameters.gains;
    let damping = rate * (parameters.drive.viscous_friction + gains.derivative);
    let stiffness = rate * gains.proportional * ts;
    let integral = rate * gains.integral * ts * ts;
    // (B + Kd) u^2 + Kp Ts (1 + u) u + Ki Ts^2 (1 + u)^2, times Ts/J.
    [integral, stiffness + 2.0 * integral, damping + stiffness + integral]
}

impl ServoParameters {
    /// The three poles z of the sampled loop, by rising modulus.
    ///
    /// # Errors
    /// [`ControlError::BadParameter`].
    pub fn poles(&self) -> Result<[Complex<f64>; 3], ControlError> {
        self.validate_numbers()?;
        let roots = cubic_roots(characteristic(self))
            .ok_or(ControlError::UnstableLoop { largest_pole: f64::INFINITY });
        let mut poles = roots?.map(|u| u + 1.0);
        poles.sort_by(|a, b| a.norm().total_cmp(&b.norm()));
        Ok(poles)
    }

    /// Largest modulus of the poles: below 1 the loop is stable.
    ///
    /// # Errors
    /// [`ControlError::BadParameter`].
    pub fn largest_pole(&self) -> Result<f64, ControlError> {
        let largest = self.poles()?[2].norm();
        // The value of the polynomial at z = 1 is c0. At 0 one pole is 1, whatever rounding makes of it.
        Ok(if characteristic(self)[0] > 0.0 { largest } else { largest.max(1.0) })
    }
}

/// Roots of x^3 + c2 x^2 + c1 x + c0: one real root by bisection, then a quadratic. `None` if the coefficients overflow.
fn cubic_roots([c0, c1, c2]: [f64; 3]) -> Option<[Complex<f64>; 3]> {
    // Twice the bound of Fujiwara covers rounding; a quotient by it keeps powers of large roots within range.
    let scale = 4.0 * c2.abs().max(c1.abs().sqrt()).max(c0.abs().cbrt());
    if scale == 0.0 {
        return Some([Complex::new(0.0, 0.0); 3]);
    }
    let [a0, a1, a2] = [c0 / scale / scale / scale, c1 / scale / scale, c2 / scale];
    let r = bisect(-1.0, 1.0, |x| ((x + a2) * x + a1) * x + a0)?;
    // x^2 + p x + q: the quotient from the end at which the division is stable for this root.
    let (p, q) = if (r * r * r).abs() > a0.abs() {
        let q = -a0 / r;
        ((q - a1) / r, q)
    } else {
        let p = a2 + r;
        (p, a1 + p * r)
    };
    let half = -0.5 * p;
    let under = half * half - q;
    let pair = if under < 0.0 {
        let beside = (-under).sqrt();
        [Complex::new(half, beside), Complex::new(half, -beside)]
    } else {
        let larger = half + under.sqrt().copysign(half);
        let smaller = if larger == 0.0 { 0.0 } else { q / larger };
        [Complex::new(larger, 0.0), Complex::new(smaller, 0.0)]
    };
    Some([Complex::new(r, 0.0), pair[0], pair[1]].map(|x| x * scale))
}

#[cfg(test)]
mod tests {
    use super::super::parameters::tests::example;
    use super::super::{Gains, ServoParameters};
    use super::*;

    #[test]
    fn roots_come_back() {
        let cases = [
            [Complex::new(-0.3, 0.0), Complex::new(-0.02, 0.1), Complex::new(-0.02, -0.1)],
            [Complex::new(1e6, 0.0), Complex::new(-1e-6, 0.0), Complex::new(2.0, 0.0)],
            [Complex::new(-1e-9, 0.0), Complex::new(-2e-9, 0.0), Complex::new(-0.5, 0.0)],
            [Complex::new(0.0, 0.0), Complex::new(0.0, 3.0), Complex::new(0.0, -3.0)],
            [Complex::new(1e80, 0.0), Complex::new(-1.0, 0.0), Complex::new(-1.5, 0.0)],
        ];
        for roots in cases {
            let [a, b, c] = roots;
            let found = cubic_roots([-(a * b * c).re, (a * b + b * c + a * c).re, -(a + b + c).re]).unwrap();
            for root in roots {
                let nearest = found.iter().map(|x| (x - root).norm()).fold(f64::MAX, f64::min);
                assert!(nearest <= 1e-12 * root.norm(), "{root}: {found:?}");
            }
        }
        assert_eq!(cubic_roots([0.0; 3]).unwrap(), [Complex::new(0.0, 0.0); 3]);
    }

    /// Jury's criterion for z^3 + a2 z^2 + a1 z + a0: no root needed.
    fn jury(parameters: &ServoParameters) -> bool {
        let [c0, c1, c2] = characteristic(parameters);
        let (a2, a1, a0) = (c2 - 3.0, c1 - 2.0 * c2 + 3.0, c0 - c1 + c2 - 1.0);
        c0 > 0.0 && 1.0 - a2 + a1 - a0 > 0.0 && a0.abs() < 1.0 && (a0 * a0 - 1.0).abs() > (a0 * a2 - a1).abs()
    }

    #[test]
    fn poles_agree_with_the_criterion_of_jury() {
        let mut counts = [0; 2];
        for bandwidth in [1.0, 10.0, 40.0, 200.0, 600.0, 1200.0, 2500.0] {
            for [p, i, d] in
                [[1.0, 1.0, 1.0], [1.0, 3.0, 0.3], [1.0, 20.0, 1.0], [-1.0, 1.0, 1.0], [0.1, 0.01, 4.0]]
            {
                let mut parameters = example();
                let gains = Gains::triple_pole(bandwidth, &parameters.drive).unwrap();
                parameters.gains = Gains {
                    proportional: p * gains.proportional,
                    integral: i * gains.integral,
                    derivative: d * gains.derivative,
                };
                let stable = parameters.validate().is_ok();
                assert_eq!(stable, jury(&parameters), "{bandwidth} Hz, {:?}", parameters.poles());
                counts[usize::from(stable)] += 1;
            }
        }
        assert!(counts[0] > 5 && counts[1] > 5, "{counts:?}");
    }

    #[test]
    fn a_loop_without_integral_has_a_pole_at_one() {
        let mut parameters = example();
        parameters.gains.integral = 0.0;
        match parameters.validate() {
            Err(ControlError::UnstableLoop { largest_pole }) => {
                assert!((largest_pole - 1.0).abs() < 1e-12, "{largest_pole}");
            }
            other => panic!("{other:?}"),
        }
    }
}
