//! Why a path of corrections goes no further (`docs/mathematics/dressing.md#conditions`). Knows no conditions.

use crate::DressedProfile;
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

/// A circle has lost contact when its slack is below this: the path grazes the end of contact, so that the slack falls with the
/// square of the steps left.
const NO_SLACK: f64 = 1e-4;
/// Share of the profile within which its end is reached.
const AT_END: f64 = 1e-3;
/// Change of w per t below which the dresser's radii no longer follow each other on the worm.
const NO_ORDER: f64 = 1e-2;

impl PathReason {
    /// Why equations that use these circles (profile and parameter t) cannot be solved beyond here.
    pub(crate) fn of_break(circles: &[(DressedProfile<'_>, f64)]) -> Self {
        let any = |test: fn(&DressedProfile<'_>, f64) -> bool| circles.iter().any(|(p, t)| test(p, *t));
        if any(|profile, t| profile.slack(t) < NO_SLACK) {
            Self::ContactLost
        } else if any(|profile, t| {
            let (from, to) = profile.interval();
            let end = (t - from).min(to - t);
            end < AT_END * (to - from) || profile.roll_slope(t).is_none_or(|slope| slope < NO_ORDER)
        }) {
            Self::OutOfDresser
        } else {
            Self::GivenUp
        }
    }
}

/// Smallest distance of a correction from its limits, in scaled units, and the component concerned.
pub(crate) fn axis_margin(dk: &[f64; 4], limits: &[[f64; 2]; 4], scale: &[f64; 4]) -> (f64, usize) {
    let margin = |j: usize| (dk[j] - limits[j][0]).min(limits[j][1] - dk[j]) / scale[j];
    (0..4).map(|j| (margin(j), j)).fold((f64::INFINITY, 0), |least, other| {
        // A NaN is beyond every limit.
        if other.0.is_nan() || other.0 < least.0 { other } else { least }
    })
}

/// Sizes of one scaled unknown (`docs/mathematics/dressing.md#conditions`): 1/r_S and 1/20 rad, 1 mm, 5 mm.
pub(crate) fn correction_scale(reference_radius: f64) -> [f64; 4] {
    [1.0 / reference_radius, 1.0 / 20.0, 1.0, 5.0]
}

/// The same in the tilt chart, whose last number is an angle.
pub(crate) fn tilt_scale(reference_radius: f64) -> [f64; 4] {
    [1.0 / reference_radius, 1.0 / 20.0, 1.0, 1.0 / 20.0]
}
