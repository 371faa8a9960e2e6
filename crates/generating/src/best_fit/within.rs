//! What a fit keeps to.

use super::super::DressingLimits;

/// Share of the tolerance below which smoothness counts more than nearness.
pub const NEAR: f64 = 0.2;
/// The largest bend of a command against the gap: a determinant ratio of 0.3 (`docs/mathematics/best-fit.md#the-programme`).
pub const LARGEST_BEND: f64 = 0.3;

/// Limits of a fit.
#[derive(Clone, Copy, Debug)]
pub struct Within {
    /// Distance to the target, mm.
    pub tolerance: f64,
    /// Corrections of dressing and Delta_d.
    pub axes: DressingLimits,
    /// Contacts are kept on the finished part of the worm.
    pub on_worm: bool,
    /// Largest bend of the command.
    pub bend: f64,
    /// The bend is bounded at twice as many places, and between those whose contacts are far apart.
    pub closely: bool,
}

impl Within {
    /// Within a tolerance and the limits of the axes, as far bent as a command may be.
    pub fn new(tolerance: f64, axes: DressingLimits) -> Self {
        Self { tolerance, axes, on_worm: false, bend: LARGEST_BEND, closely: false }
    }
}
