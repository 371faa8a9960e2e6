//! How far column planes reach along the guide curve (`docs/mathematics/milling.md#columns-and-rows`): on helical gears beyond the face.

use super::{ActiveFlank, LeadCurve, MillingError};
use foundation::numerics::{brent, equidistant};

/// Heights at which the ends of the face are followed.
const HEIGHTS: usize = 9;

/// Bracketing steps from the end of the face; each doubles the reach.
const DOUBLINGS: usize = 24;

/// [u_min, u_max]: the lead parameters whose planes hold the ends of the face at 9 heights, without any overrun.
///
/// # Errors
/// [`MillingError::RangeNotFound`] where no plane holds such a point; those of the guide curve.
pub fn lead_range(flank: &ActiveFlank, lead: &dyn LeadCurve) -> Result<[f64; 2], MillingError> {
    let mut range = [f64::INFINITY, f64::NEG_INFINITY];
    for height in equidistant(flank.height_span(), HEIGHTS) {
        for end in flank.face {
            let u = plane_through(flank, lead, height, end)?;
            range = [range[0].min(u), range[1].max(u)];
        }
    }
    Ok(range)
}

/// The parameter of the plane that holds the flank's point at (a, b).
///
/// # Errors
/// [`MillingError::RangeNotFound`] if none does.
pub fn plane_through(
    flank: &ActiveFlank,
    lead: &dyn LeadCurve,
    height: f64,
    length: f64,
) -> Result<f64, MillingError> {
    let point = flank.surface.point(height, length);
    let off = |u: f64| lead.at(u).ok().map(|at| (point - at.point).dot(&at.direction));
    let not_found = || MillingError::RangeNotFound { height, length };
    let middle = off(length).ok_or_else(not_found)?;
    let mut step = (flank.face[1] - flank.face[0]) / 64.0;
    let mut ends = [(length, middle); 2];
    for _ in 0..DOUBLINGS {
        for (end, sense) in ends.iter_mut().zip([-1.0, 1.0]) {
            let u = length + sense * step;
            let Some(value) = off(u) else { continue };
            if (value > 0.0) != (middle > 0.0) || middle == 0.0 {
                return brent([end.0, u], [end.1, value], 0.0, off).ok_or_else(not_found);
            }
            *end = (u, value);
        }
        step *= 2.0;
    }
    Err(not_found())
}
