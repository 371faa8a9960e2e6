//! Our side of the comparison: the gearbox with one leading axis. The only place that says how a follower is computed.

/// Follower y = numerator/denominator * x, in lowest terms (spec 70 section 7).
#[derive(Clone, Copy, Debug)]
pub struct Ours {
    pub numerator: i64,
    pub denominator: i64,
}

impl Ours {
    /// Counts of the follower for counts of the master, and the remainder: y + remainder/denominator is exact.
    pub fn position(self, master: i64) -> (i64, i64) {
        let product = self.numerator * master;
        (product.div_euclid(self.denominator), product.rem_euclid(self.denominator))
    }

    /// What a slave is ahead of its place, in counts of the slave times the denominator.
    pub fn error_counts(self, master: i64, slave: i64) -> i64 {
        let (follower, remainder) = self.position(master);
        self.denominator * (slave - follower) - remainder
    }
}
