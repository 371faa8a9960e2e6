//! Normally distributed noise that is the same everywhere for the same number to begin with: SplitMix64 and the pairs of Box and Muller
//! (`docs/mathematics/skiving.md#light-barrier`).

use std::f64::consts::TAU;

/// A sequence of normal numbers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Noise {
    state: u64,
    second: Option<f64>,
}

impl Noise {
    /// The sequence of a number.
    pub fn new(start: u64) -> Self {
        Self { state: start, second: None }
    }

    /// 64 random bits.
    pub fn bits(&mut self) -> u64 {
        self.state = self.state.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.state;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^ (z >> 31)
    }

    /// Uniform in 0..1, both ends excluded.
    pub fn uniform(&mut self) -> f64 {
        ((self.bits() >> 11) as f64 + 0.5) * (-53f64).exp2()
    }

    /// Normal with mean 0 and standard deviation 1.
    pub fn normal(&mut self) -> f64 {
        if let Some(second) = self.second.take() {
            return second;
        }
        let (a, b) = (self.uniform(), self.uniform());
        let radius = (-2.0 * a.ln()).sqrt();
        let (sin, cos) = (TAU * b).sin_cos();
        self.second = Some(radius * sin);
        radius * cos
    }
}
