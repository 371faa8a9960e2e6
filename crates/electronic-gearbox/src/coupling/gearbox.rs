//! The sum over the leading axes, from positions or from increments.

use super::LinearTerm;
use crate::Error;

/// Leading axes that a gearbox may have.
const MOST_AXES: usize = 8;

/// A position of the follower: counts rounded down, and the rest as a fraction of 2^32.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct GearboxPosition {
    /// Whole counts.
    pub counts: i64,
    /// Rest, in counts/2^32; less than K/2^32 below the exact value, and never growing.
    pub fraction: u32,
}

/// Linear couplings to K leading axes, 1 <= K <= 8. The follower's position is a function of the leading positions, without history.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Gearbox<const K: usize> {
    offset: i64,
    terms: [LinearTerm; K],
    closed: bool,
}

impl<const K: usize> Gearbox<K> {
    const SIZE: () = assert!(1 <= K && K <= MOST_AXES, "a gearbox has 1 to 8 leading axes");

    /// Open, with y_0 = `offset`.
    pub const fn new(offset: i64, terms: [LinearTerm; K]) -> Self {
        let () = Self::SIZE;
        Self { offset, terms, closed: false }
    }

    /// Position of the follower at these positions of the leading axes, counts.
    ///
    /// # Errors
    /// [`Error::GearRange`] where a way or the sum leaves its range.
    #[inline]
    pub fn position(&self, leading: &[i64; K]) -> Result<GearboxPosition, Error> {
        let mut counts = self.offset;
        let mut fractions = 0u64;
        for (term, &x) in self.terms.iter().zip(leading) {
            let at = term.at(x)?;
            counts = sum(counts, at.quotient)?;
            fractions += u64::from(term.ratio().divisor.fraction(at.remainder));
        }
        rounded(counts, fractions)
    }

    /// Speed of the follower for speeds of the leading axes, counts a second.
    pub fn speed(&self, leading: &[f64; K]) -> f64 {
        self.terms.iter().zip(leading).map(|(term, speed)| term.ratio().as_f64() * speed).sum()
    }

    /// Closes the coupling: y_0 becomes such that the follower stays at `follower`, without a jump.
    ///
    /// # Errors
    /// [`Error::GearRange`] as for [`Gearbox::position`], [`Error::Busy`] if it is closed.
    pub fn engage(&mut self, leading: &[i64; K], follower: i64) -> Result<(), Error> {
        if self.closed {
            return Err(Error::Busy);
        }
        let counts = Self { offset: 0, ..*self }.position(leading)?.counts;
        self.offset = follower
            .checked_sub(counts)
            .ok_or(Error::GearRange { name: "follower's position", value: follower })?;
        self.closed = true;
        Ok(())
    }

    /// Opens the coupling.
    pub fn release(&mut self) {
        self.closed = false;
    }

    /// Whether it is closed.
    pub const fn is_engaged(&self) -> bool {
        self.closed
    }

    /// Changes ratios and zeros.
    ///
    /// # Errors
    /// [`Error::Busy`] while the coupling is closed.
    pub fn replace(&mut self, terms: [LinearTerm; K]) -> Result<(), Error> {
        if self.closed {
            return Err(Error::Busy);
        }
        self.terms = terms;
        Ok(())
    }

    /// y_0.
    pub const fn offset(&self) -> i64 {
        self.offset
    }

    /// The couplings.
    pub const fn terms(&self) -> &[LinearTerm; K] {
        &self.terms
    }
}

/// The same from increments, for a loop that reads differences of counters: it has the position of [`Gearbox::position`] after every
/// sequence of them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct IncrementalGearbox<const K: usize> {
    gearbox: Gearbox<K>,
    /// y without the rests.
    counts: i64,
    /// Rests in 1/d_i.
    remainders: [u64; K],
}

impl<const K: usize> IncrementalGearbox<K> {
    /// Starts at these positions of the leading axes.
    ///
    /// # Errors
    /// As for [`Gearbox::position`].
    pub fn new(gearbox: Gearbox<K>, leading: &[i64; K]) -> Result<Self, Error> {
        let mut counts = gearbox.offset;
        let mut remainders = [0; K];
        for ((term, &x), remainder) in gearbox.terms.iter().zip(leading).zip(&mut remainders) {
            let at = term.at(x)?;
            counts = sum(counts, at.quotient)?;
            *remainder = at.remainder;
        }
        Ok(Self { gearbox, counts, remainders })
    }

    /// The leading axes move by `steps` counts.
    ///
    /// # Errors
    /// [`Error::GearRange`] where a way or the sum leaves its range; nothing has changed then.
    #[inline]
    pub fn advance(&mut self, steps: &[i64; K]) -> Result<(), Error> {
        let mut counts = self.counts;
        let mut remainders = self.remainders;
        for ((term, &step), remainder) in self.gearbox.terms.iter().zip(steps).zip(&mut remainders) {
            // |n| < 2^62, |step| <= 2^63, and the rest is below 2^62: within 126 bits.
            let product = i128::from(term.ratio().numerator()) * i128::from(step) + i128::from(*remainder);
            let moved = term.divide(product, step)?;
            counts = sum(counts, moved.quotient)?;
            *remainder = moved.remainder;
        }
        (self.counts, self.remainders) = (counts, remainders);
        Ok(())
    }

    /// Where the follower has to be.
    ///
    /// # Errors
    /// [`Error::GearRange`] at the very end of the range of counts.
    #[inline]
    pub fn position(&self) -> Result<GearboxPosition, Error> {
        let terms = self.gearbox.terms.iter().zip(&self.remainders);
        let fractions = terms.map(|(term, rest)| u64::from(term.ratio().divisor.fraction(*rest))).sum();
        rounded(self.counts, fractions)
    }

    /// The gearbox whose increments these are.
    pub const fn gearbox(&self) -> &Gearbox<K> {
        &self.gearbox
    }
}

#[inline]
fn sum(counts: i64, more: i64) -> Result<i64, Error> {
    match counts.checked_add(more) {
        Some(sum) => Ok(sum),
        None => Err(Error::GearRange { name: "follower's position", value: more }),
    }
}

/// Whole counts out of a sum of at most eight fractions of 2^32.
#[inline]
fn rounded(counts: i64, fractions: u64) -> Result<GearboxPosition, Error> {
    // The sum is below 2^35.
    let counts = sum(counts, (fractions >> 32) as i64)?;
    Ok(GearboxPosition { counts, fraction: fractions as u32 })
}
