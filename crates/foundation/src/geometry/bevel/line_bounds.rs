//! What a flank line is over an interval.

/// Over an interval of R: enclosing range of R Theta' and an upper bound of |d(R Theta')/dR|, 1/mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct LineBounds {
    /// Range of R Theta'.
    pub(super) turn: [f64; 2],
    /// Bound of its derivative.
    pub(super) turn_rate: f64,
}
