//! Random numbers that every run has the same.

/// Draws of a linear congruential sequence.
pub struct Draw(u64);

impl Draw {
    pub fn new(start: u64) -> Self {
        Self(start)
    }

    /// 31 bits.
    pub fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        self.0 >> 33
    }
}
