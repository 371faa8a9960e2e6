//! How smooth a modification is.

/// Number of continuous derivatives, ascending: the worst of several parts is their minimum.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Smoothness {
    /// Continuous, with kinks.
    C0,
    /// Continuous slope, jumps of curvature.
    C1,
    /// Continuous curvature.
    C2,
    /// Any number of continuous derivatives.
    Cinf,
}
