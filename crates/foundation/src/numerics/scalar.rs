//! The scalar that geometry and kinematics are generic over: `f64` or a dual number.

use num_dual::{DualNum, DualSVec64};

/// A real number or a dual number over `f64` (crate `num-dual`); every formula that is differentiated takes it.
pub trait Scalar: DualNum<Primitive = f64> + Copy + Send + Sync {}

impl<T: DualNum<Primitive = f64> + Copy + Send + Sync> Scalar for T {}

/// The real part of a scalar.
#[inline]
pub fn value_of<T: Scalar>(x: T) -> f64 {
    x.re()
}

/// N independent variables at the given values: the seeds of an N-column Jacobian.
#[inline]
pub fn variables<const N: usize>(values: [f64; N]) -> [DualSVec64<N>; N] {
    let mut index = 0;
    values.map(|value| {
        let seed = DualSVec64::from_re(value).derivative(index);
        index += 1;
        seed
    })
}

/// The derivatives of a dual number by its N variables.
#[inline]
pub fn gradient_of<const N: usize>(x: &DualSVec64<N>) -> [f64; N] {
    match &x.eps.0 {
        Some(eps) => std::array::from_fn(|i| eps[i]),
        None => [0.0; N],
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn seeds_give_the_gradient() {
        let [x, y] = variables([2.0, 3.0]);
        let f = x * x * y + y.sin();
        assert_eq!(value_of(f), 12.0 + 3f64.sin());
        let g = gradient_of(&f);
        assert!((g[0] - 12.0).abs() < 1e-15 && (g[1] - (4.0 + 3f64.cos())).abs() < 1e-15);
        assert_eq!(gradient_of(&DualSVec64::<2>::from(1.0)), [0.0, 0.0]);
    }
}
