//! Our side of the comparison: the gearbox with one leading axis. The only place that says how a follower is computed.

use electronic_gearbox::coupling::{Gearbox, LinearTerm, Ratio};

/// Follower y = numerator/denominator * x, in lowest terms (`docs/mathematics/gearbox.md#couplings`).
#[derive(Clone, Copy, Debug)]
pub struct Ours {
    pub numerator: i64,
    pub denominator: i64,
}

impl Ours {
    /// Counts of the follower for counts of the master, and the remainder: y + remainder/denominator is exact.
    pub fn position(self, master: i64) -> (i64, i64) {
        let ratio = Ratio::new(self.numerator, self.denominator).expect("a ratio within range");
        let gearbox = Gearbox::new(0, [LinearTerm::new(ratio, 0)]);
        let at = gearbox.position(&[master]).expect("a position within range");
        // The fraction is floor(r 2^32/d): for d below 2^32 only one remainder r fits.
        let scaled = i128::from(at.fraction) * i128::from(self.denominator);
        let remainder = (scaled + (1 << 32) - 1) >> 32;
        (at.counts, i64::try_from(remainder).expect("below d"))
    }

    /// What a slave is ahead of its place, in counts of the slave times the denominator.
    pub fn error_counts(self, master: i64, slave: i64) -> i64 {
        let (follower, remainder) = self.position(master);
        self.denominator * (slave - follower) - remainder
    }
}
