//! Natural twist of a crowning made by the radial feed
//! (`docs/mathematics/generating-contact.md#what-the-grinding-motion-leaves-to-first-order`, first order).

use super::FlankLines;

/// What a radial-feed crowning brings along on one flank. Transverse, mm, positive = removed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NaturalTwist {
    /// Apex of the crowning in the feed, z_V20, mm.
    pub apex_feed: f64,
    /// Twist S_nat.
    pub twist: f64,
    /// Profile crowning C_alpha,nat.
    pub profile_crowning: f64,
}

/// Natural twist of a helix crowning `amount` (mm, transverse) over the evaluation field of `lines`.
pub fn natural_twist(lines: &FlankLines, amount: f64) -> NaturalTwist {
    let length_w = lines.roll[1] - lines.roll[0];
    let length_z = lines.face[1] - lines.face[0];
    NaturalTwist {
        apex_feed: lines.c_c2 - lines.t_k * lines.w_m - lines.z_m,
        twist: 8.0 * amount * lines.t_k * length_w / length_z,
        profile_crowning: amount * (lines.t_k * length_w / length_z).powi(2),
    }
}
