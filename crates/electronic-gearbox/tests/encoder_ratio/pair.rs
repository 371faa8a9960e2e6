//! A master and a slave as `encoder_ratio` knows them, and what it makes of their counts.

use super::ours::Ours;

/// What moves the slave.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Slave {
    /// Its own random speed, with reversals.
    Wanders,
    /// Our gearbox, by one count a line at most.
    Follows,
    /// Forth for the given lines, then back.
    Runs { lines: usize },
}

/// Parameters of a channel. The counts of a revolution are what the peer calls ppr: four a period of the signals, not one.
#[derive(Clone, Copy, Debug)]
pub struct Pair {
    pub master_counts: i64,
    pub slave_counts: i64,
    pub master_teeth: i64,
    pub slave_teeth: i64,
    pub slave: Slave,
    /// The signals A and B of the slave are exchanged, so that the peer counts it backwards: the ratio is negative.
    pub crossed: bool,
}

impl Pair {
    pub const fn new(master_counts: i64, slave_counts: i64, teeth: (i64, i64), slave: Slave) -> Self {
        let (master_teeth, slave_teeth) = teeth;
        Self { master_counts, slave_counts, master_teeth, slave_teeth, slave, crossed: false }
    }

    pub const fn crossed(self) -> Self {
        Self { crossed: true, ..self }
    }

    /// The gearbox of the same ratio, counts of the slave by counts of the master.
    pub fn ours(&self) -> Ours {
        let (numerator, denominator) =
            (self.master_teeth * self.slave_counts, self.slave_teeth * self.master_counts);
        let divisor = greatest_common_divisor(numerator, denominator);
        let sign = if self.crossed { -1 } else { 1 };
        Ours { numerator: sign * numerator / divisor, denominator: denominator / divisor }
    }

    /// Our error in revolutions of the slave is this divided by `steps`; signed as the peer counts the slave.
    pub fn error_steps(&self, master: i64, slave: i64) -> i64 {
        let error = self.ours().error_counts(master, slave);
        if self.crossed { -error } else { error }
    }

    /// Steps of the error in a revolution of the slave.
    pub fn steps(&self) -> i64 {
        self.ours().denominator * self.slave_counts
    }

    /// What the peer divides by: it needs the steps times what the ratio was shortened by.
    pub fn peer_steps(&self) -> i64 {
        self.master_counts * self.slave_counts * self.slave_teeth
    }
}

fn greatest_common_divisor(a: i64, b: i64) -> i64 {
    if b == 0 { a } else { greatest_common_divisor(b, a % b) }
}
