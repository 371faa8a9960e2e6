//! The linear congruential sequence from which files draw (`docs/mathematics/gearbox.md#limits`).

/// State of the sequence.
#[derive(Clone, Debug)]
pub(super) struct Draw(u64);

impl Draw {
    pub const fn new(start: u64) -> Self {
        Self(start)
    }

    /// The next state's upper 31 bits, below `bound`; 0 where the bound is.
    pub fn below(&mut self, bound: u64) -> u64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33).checked_rem(bound).unwrap_or(0)
    }
}
