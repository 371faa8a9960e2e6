//! The first harmonic of values over the teeth of one revolution.

use std::f64::consts::TAU;

/// c + A cos(t) + B sin(t) at t = 2 pi i/z, the values of teeth i = 1 .. z, by least squares.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Harmonic {
    /// c.
    pub mean: f64,
    /// A.
    pub cosine: f64,
    /// B.
    pub sine: f64,
}

impl Harmonic {
    /// Of the values of at least three teeth.
    pub fn of(values: &[f64]) -> Self {
        // Over whole revolutions the three functions are orthogonal.
        let share = 2.0 / values.len() as f64;
        let sum = |weight: fn(f64) -> f64| -> f64 {
            angles(values.len()).zip(values).map(|(angle, value)| weight(angle) * value).sum()
        };
        Self { mean: share / 2.0 * sum(|_| 1.0), cosine: share * sum(f64::cos), sine: share * sum(f64::sin) }
    }

    /// Its values at the teeth 1 .. z of a gear with so many.
    pub fn values(&self, teeth: usize) -> Vec<f64> {
        angles(teeth).map(|t| self.mean + self.cosine * t.cos() + self.sine * t.sin()).collect()
    }

    /// Its amplitude, in the unit of the values.
    pub fn amplitude(&self) -> f64 {
        self.cosine.hypot(self.sine)
    }

    /// Where it is greatest, rad from tooth z, in -pi .. pi.
    pub fn phase(&self) -> f64 {
        self.sine.atan2(self.cosine)
    }
}

/// Angles of the teeth 1 .. z, rad.
pub(super) fn angles(teeth: usize) -> impl Iterator<Item = f64> {
    (1..=teeth).map(move |tooth| TAU * tooth as f64 / teeth as f64)
}
