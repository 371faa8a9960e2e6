//! Where a path of corrections ends: circles that break off, and margins of the axes (`docs/mathematics/dressing.md#conditions`).

use super::path_reason::PathReason;
use crate::DressedProfile;

/// A circle has lost contact when its slack is below this: the path grazes the end of contact, so that the slack falls with the
/// square of the steps left.
const NO_SLACK: f64 = 1e-4;
/// Share of the profile within which its end is reached.
const AT_END: f64 = 1e-3;
/// Change of w per t below which the dresser's radii no longer follow each other on the worm.
const NO_ORDER: f64 = 1e-2;

/// Why equations that use these circles (profile and parameter t) cannot be solved beyond here.
pub(crate) fn reason_of_break(circles: &[(DressedProfile<'_>, f64)]) -> PathReason {
    let any = |test: fn(&DressedProfile<'_>, f64) -> bool| circles.iter().any(|(p, t)| test(p, *t));
    if any(|profile, t| profile.slack(t) < NO_SLACK) {
        PathReason::ContactLost
    } else if any(|profile, t| {
        let (from, to) = profile.interval();
        let end = (t - from).min(to - t);
        end < AT_END * (to - from) || profile.roll_slope(t).is_none_or(|slope| slope < NO_ORDER)
    }) {
        PathReason::OutOfDresser
    } else {
        PathReason::GivenUp
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
