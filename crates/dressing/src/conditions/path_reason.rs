//! Why a path of corrections goes no further (`docs/mathematics/dressing.md#conditions`). Knows no conditions.

use finding::Finding;
use std::fmt;

/// What ended a path of dressing corrections.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Finding)]
pub enum PathReason {
    /// The path turns back: beyond there is no solution on its branch.
    #[finding(code = "fold")]
    #[way_out(
        "reduce the amount, take a worm with more threads or smaller diameter, or let the dresser's profile make it"
    )]
    Fold,
    /// A circle of the dresser that is in use loses contact.
    #[finding(code = "contact-lost")]
    #[way_out(
        "reduce the amount, take a worm with more threads or smaller diameter, or let the dresser's profile make it"
    )]
    ContactLost,
    /// The contact leaves the dresser's profile, or the radii of the dresser no longer follow each other on the worm.
    #[finding(code = "out-of-dresser")]
    #[way_out("reduce the amount: the dresser's profile ends before the contact")]
    OutOfDresser,
    /// A correction reaches its limit: 0 d_phi_S, 1 d_gamma, 2 d_d, 3 d_v_yA.
    #[finding(code = "axis-limit")]
    #[way_out("reduce the amount: the axis has reached its range")]
    AxisLimit(usize),
    /// The limit that the caller set, such as a clearance.
    #[finding(code = "limit")]
    #[way_out("reduce the amount, or take a dresser with a narrower tip")]
    Limit,
    /// The steps became too short or too many: rounding hides where the path goes on.
    #[finding(code = "given-up")]
    #[way_out("reduce the amount, or replace a pitch point by a radius map or a fixed axis")]
    GivenUp,
}

impl fmt::Display for PathReason {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Fold => "fold",
            Self::ContactLost => "contact lost",
            Self::OutOfDresser => "out of dresser",
            Self::AxisLimit(0) => "axis limit of d_phi_S",
            Self::AxisLimit(1) => "axis limit of d_gamma",
            Self::AxisLimit(2) => "axis limit of d_d",
            Self::AxisLimit(_) => "axis limit of d_v_yA",
            Self::Limit => "limit",
            Self::GivenUp => "given up",
        })
    }
}
