//! Coupling by a polynomial of the leading axis' absolute position (`docs/mathematics/gearbox.md#couplings`): no history, hence no drift.

use super::counts::nearest_count;
use crate::Error;

/// Degree 7.
pub const MOST_COEFFICIENTS: usize = 8;

/// c_0 + c_1 x + ... + c_7 x^7 with x in mm or degrees.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PolynomialCoupling {
    coefficients: [f64; MOST_COEFFICIENTS],
}

impl PolynomialCoupling {
    /// From c_0 upwards; degrees that are not given have the coefficient 0.
    ///
    /// # Errors
    /// [`Error::BadParameter`] for none or more than eight coefficients, and for one that is not finite.
    pub fn new(coefficients: &[f64]) -> Result<Self, Error> {
        if !(1..=MOST_COEFFICIENTS).contains(&coefficients.len()) {
            return Err(Error::BadParameter {
                name: "number of coefficients",
                value: coefficients.len() as f64,
                allowed: "1 to 8",
            });
        }
        let mut all = [0.0; MOST_COEFFICIENTS];
        for (place, &value) in all.iter_mut().zip(coefficients) {
            if !value.is_finite() {
                return Err(Error::BadParameter {
                    name: "coefficient of a polynomial",
                    value,
                    allowed: "finite",
                });
            }
            *place = value;
        }
        Ok(Self { coefficients: all })
    }

    /// y(x).
    ///
    /// # Errors
    /// [`Error::BadParameter`] for an x that is not finite, or so large that y is not.
    #[inline]
    pub fn value(&self, x: f64) -> Result<f64, Error> {
        self.horner(x, |_| 1.0, 0)
    }

    /// dy/dx.
    ///
    /// # Errors
    /// As for [`PolynomialCoupling::value`].
    #[inline]
    pub fn derivative(&self, x: f64) -> Result<f64, Error> {
        self.horner(x, |degree| degree, 1)
    }

    /// d2y/dx2.
    ///
    /// # Errors
    /// As for [`PolynomialCoupling::value`].
    #[inline]
    pub fn second_derivative(&self, x: f64) -> Result<f64, Error> {
        self.horner(x, |degree| degree * (degree - 1.0), 2)
    }

    /// floor(y(x) + 1/2), for a polynomial of counts.
    ///
    /// # Errors
    /// As for [`PolynomialCoupling::value`]; [`Error::GearRange`] from 2^62 counts on.
    #[inline]
    pub fn counts(&self, x: f64) -> Result<i64, Error> {
        nearest_count("value of a polynomial", self.value(x)?)
    }

    /// Sum of factor(k) c_k x^(k - order) over k >= order. Always the same number of steps.
    #[inline]
    fn horner(&self, x: f64, factor: impl Fn(f64) -> f64, order: usize) -> Result<f64, Error> {
        let terms = self.coefficients.iter().enumerate().skip(order).rev();
        let sum = terms.fold(0.0, |sum, (degree, coefficient)| sum * x + factor(degree as f64) * coefficient);
        // NaN and infinity of x come through to here: 0 x is NaN for both.
        if sum.is_finite() {
            Ok(sum)
        } else {
            Err(Error::BadParameter {
                name: "argument of a polynomial",
                value: x,
                allowed: "finite, and small enough for a finite value",
            })
        }
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::PolynomialCoupling;
    use crate::Error;

    #[test]
    fn powers_have_their_derivatives() {
        let cubic = PolynomialCoupling::new(&[1.0, -2.0, 3.0, 0.5]).unwrap();
        assert_eq!(cubic.value(2.0), Ok(13.0));
        assert_eq!(cubic.derivative(2.0), Ok(16.0));
        assert_eq!(cubic.second_derivative(2.0), Ok(12.0));
        let seventh = PolynomialCoupling::new(&[0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0]).unwrap();
        assert_eq!(seventh.value(-2.0), Ok(-128.0));
        assert_eq!(seventh.derivative(-2.0), Ok(448.0));
        assert_eq!(seventh.second_derivative(-2.0), Ok(-1344.0));
        let constant = PolynomialCoupling::new(&[3.0]).unwrap();
        assert_eq!((constant.value(9.0), constant.derivative(9.0)), (Ok(3.0), Ok(0.0)));
    }

    #[test]
    fn counts_are_rounded_and_limited() {
        let line = PolynomialCoupling::new(&[0.0, 1.0]).unwrap();
        assert_eq!(line.counts(2.5), Ok(3));
        assert_eq!(line.counts(-2.5), Ok(-2));
        assert!(matches!(line.counts(1e19), Err(Error::GearRange { value: i64::MAX, .. })));
    }

    #[test]
    fn what_is_no_number_is_refused() {
        for coefficients in [&[][..], &[0.0; 9], &[0.0, f64::NAN], &[f64::INFINITY]] {
            let refused = PolynomialCoupling::new(coefficients);
            assert!(matches!(refused, Err(Error::BadParameter { .. })), "{refused:?}");
        }
        let constant = PolynomialCoupling::new(&[3.0]).unwrap();
        let square = PolynomialCoupling::new(&[0.0, 0.0, 1.0]).unwrap();
        for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            for refused in [
                constant.value(bad),
                square.value(bad),
                square.derivative(bad),
                square.second_derivative(bad),
            ] {
                assert!(matches!(refused, Err(Error::BadParameter { .. })), "{refused:?}");
            }
            assert!(constant.counts(bad).is_err());
        }
        assert!(square.value(1e200).is_err());
    }

    proptest! {
        #[test]
        fn derivatives_are_those_of_the_value(coefficients in prop::collection::vec(-1.0f64..1.0, 1..=8), x in -1.0f64..1.0) {
            let curve = PolynomialCoupling::new(&coefficients).unwrap();
            let step = 1e-5;
            let slope = (curve.value(x + step).unwrap() - curve.value(x - step).unwrap()) / (2.0 * step);
            prop_assert!((curve.derivative(x).unwrap() - slope).abs() < 1e-7);
            let bend = (curve.derivative(x + step).unwrap() - curve.derivative(x - step).unwrap()) / (2.0 * step);
            prop_assert!((curve.second_derivative(x).unwrap() - bend).abs() < 1e-6);
        }
    }
}
