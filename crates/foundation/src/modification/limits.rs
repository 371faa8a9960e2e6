//! Limits beyond which a number in a description can only be a slip (a wrong unit, a lost decimal point).

/// Largest magnitude of an amount, um (100 mm).
pub(super) const AMOUNT_UM: f64 = 1e5;

/// Largest magnitude of a coordinate or a length, mm.
pub(super) const LENGTH_MM: f64 = 1e6;

/// Smallest length that something is divided by, mm.
pub(super) const SHORTEST_MM: f64 = 1e-6;

/// Largest magnitude of a direction or phase, degree.
pub(super) const ANGLE_DEG: f64 = 1e6;

/// Largest exponent of a relief.
pub(super) const RELIEF_EXPONENT: f64 = 100.0;

/// Largest exponent of w or z in a polynomial.
pub(super) const POLYNOMIAL_EXPONENT: u32 = 40;

/// Largest magnitude of a polynomial coefficient, um/mm^(i+j), and of a factor.
pub(super) const FACTOR: f64 = 1e9;

/// Most characters of a formula: longer ones are tables, and each character costs time at every point.
pub(super) const FORMULA_LENGTH: usize = 2000;

/// Traces closer together than this (mm of roll) say nothing about what lies between them.
pub(super) const TRACE_DISTANCE_MM: f64 = 1e-3;

/// Deepest nesting of sums, products, scalings and mirrors, and of a formula.
pub(super) const NESTING: usize = 64;
