//! Where along the feed a region is ground.

use foundation::geometry::Flank;

/// The feeds at which a region is ground and the ratio that it needs there.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FeedInterval {
    /// Index of the region.
    pub region: usize,
    /// Its flank.
    pub flank: Flank,
    /// z_V2 from and to, mm.
    pub feed: [f64; 2],
    /// Diagonal ratio K.
    pub ratio: f64,
    /// tan(rho_2).
    pub direction: f64,
}
