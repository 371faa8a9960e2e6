//! Features of a flank from the coefficients of its areal fit, in the signs of material.

use super::terms::Term;

/// Features, or their uncertainties, mm.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ArealFeatures {
    /// Mean: > 0 material left.
    pub offset: f64,
    /// f_Ha over the field: > 0 material rising to the tip.
    pub profile_slope: f64,
    /// f_Hb over the field: > 0 material rising to face II.
    pub helix_slope: f64,
    /// C_alpha: > 0 convex.
    pub profile_crowning: f64,
    /// C_beta: > 0 convex.
    pub helix_crowning: f64,
    /// Twist S in the sign of `docs/mathematics/modifications.md` (> 0 removes at tip and face II).
    pub twist: f64,
}

impl ArealFeatures {
    /// Names in the order of [`ArealFeatures::values`].
    pub const NAMES: [&'static str; 6] =
        ["offset", "profile_slope", "helix_slope", "profile_crowning", "helix_crowning", "twist"];

    /// From a number for each term: the coefficients give the features.
    pub(super) fn of(coefficient: impl Fn(Term) -> f64) -> Self {
        let a = |p, q| coefficient(Term { p, q });
        Self {
            offset: a(0, 0),
            profile_slope: 2.0 * a(1, 0),
            helix_slope: 2.0 * a(0, 1),
            profile_crowning: -1.5 * a(2, 0),
            helix_crowning: -1.5 * a(0, 2),
            twist: -4.0 * a(1, 1),
        }
    }

    /// The features in the order of their names.
    pub fn values(&self) -> [f64; 6] {
        [
            self.offset,
            self.profile_slope,
            self.helix_slope,
            self.profile_crowning,
            self.helix_crowning,
            self.twist,
        ]
    }

    /// Sizes only, as uncertainties have them.
    pub(super) fn sizes(self) -> Self {
        Self {
            offset: self.offset.abs(),
            profile_slope: self.profile_slope.abs(),
            helix_slope: self.helix_slope.abs(),
            profile_crowning: self.profile_crowning.abs(),
            helix_crowning: self.helix_crowning.abs(),
            twist: self.twist.abs(),
        }
    }
}
