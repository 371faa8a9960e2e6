//! Worm lines that are used twice.

use foundation::geometry::Flank;

/// Worm lines of a region that its flank touches in another segment too.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SharedLines {
    /// Flank.
    pub flank: Flank,
    /// Index of the region.
    pub region: usize,
    /// z_V2 of the region from and to, mm.
    pub feed: [f64; 2],
    /// z_V2 of the other segment from and to, mm.
    pub segment: [f64; 2],
    /// Range of worm lines used twice, mm.
    pub overlap: f64,
}
