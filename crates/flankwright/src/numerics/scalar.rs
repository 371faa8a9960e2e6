//! The scalar that geometry and kinematics are generic over: `f64` or a dual number.

use num_dual::DualNum;

/// A real number or a dual number over `f64` (crate `num-dual`); every formula that is differentiated takes it.
pub trait Scalar: DualNum<Primitive = f64> + Copy + Send + Sync {}

impl<T: DualNum<Primitive = f64> + Copy + Send + Sync> Scalar for T {}
