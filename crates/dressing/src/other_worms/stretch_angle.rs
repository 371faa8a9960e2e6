//! The profile angle at which a dresser fits another worm without stretch, P = 0 (`docs/mathematics/dressing.md#conditions`). Knows no
//! wanted profile.

use crate::{DresserTool, DressingError, WormSeat, fit_profile};
use foundation::geometry::{Flank, Sides};
use foundation::numerics::{brent, equidistant};

/// A profile angle and the stretch that it leaves.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StretchAngle {
    /// Whatever the worms were asked for by: the profile angle of the left flank, rad.
    pub angle: f64,
    /// P per flank; `None` for a flank that was not asked about.
    pub stretch: Sides<Option<f64>>,
}

/// Points at which a change of sign is sought.
const SCAN: usize = 9;
/// Accuracy of the angle, rad.
const TOLERANCE: f64 = 1e-13;

/// The angle in `bracket` (rad) at which P = 0, or, where the flanks want different ones, the angle between them at which
/// both are stretched by the same share with opposite signs: the larger |P| is least there, because P changes with the angle in
/// the same sense on both flanks.
///
/// # Errors
/// [`DressingError::NoAngleWithoutStretch`] where P keeps its sign all over the bracket on one of the `flanks`; where no worm
/// of the bracket can be dressed, the reason of the last one.
pub fn angle_of_least_stretch(
    dresser: &DresserTool,
    flanks: &[Flank],
    seat: &dyn Fn(f64) -> Result<WormSeat, DressingError>,
    bracket: [f64; 2],
) -> Result<StretchAngle, DressingError> {
    let stretch = |flank: Flank, angle: f64| -> Result<f64, DressingError> {
        let seat = seat(angle)?;
        let tool = dresser.on_worm(&seat)?;
        Ok(fit_profile(&tool, flank, seat.reference_radius(), 0.0, &[0.0; 4])?.stretch)
    };
    let zero = |of: &dyn Fn(f64) -> Result<f64, DressingError>, [from, to]: [f64; 2], flank: Flank| {
        let mut last: Option<(f64, f64)> = None;
        let mut ends: Option<[f64; 2]> = None;
        let mut failure = None;
        for angle in equidistant([from, to], SCAN) {
            let here = match of(angle) {
                Ok(p) => p,
                Err(error) => {
                    (failure, last) = (Some(error), None);
                    continue;
                }
            };
            if let Some((before, p)) = last
                && (p <= 0.0) != (here <= 0.0)
            {
                let root = brent([before, angle], [p, here], TOLERANCE, |x| of(x).ok());
                if let Some(root) = root {
                    return Ok(root);
                }
            }
            ends = Some([ends.map_or(here, |[first, _]| first), here]);
            last = Some((angle, here));
        }
        Err(match (ends, failure) {
            (Some(stretch), _) => {
                let [from, to] = [from, to].map(f64::to_degrees);
                DressingError::NoAngleWithoutStretch { flank, from, to, stretch }
            }
            (None, Some(error)) => error,
            (None, None) => DressingError::InvalidNumber {
                field: "profile angle",
                value: from,
                allowed: "a finite number",
            },
        })
    };
    let roots = flanks
        .iter()
        .map(|&flank| zero(&|angle| stretch(flank, angle), bracket, flank))
        .collect::<Result<Vec<_>, _>>()?;
    let angle = match (roots.as_slice(), flanks) {
        (&[left, right], &[first, second]) if (left - right).abs() > TOLERANCE => {
            let sum = |angle: f64| Ok(stretch(first, angle)? + stretch(second, angle)?);
            zero(&sum, [left.min(right), left.max(right)], first)?
        }
        (&[root, ..], _) => root,
        ([], _) => {
            return Err(DressingError::InvalidNumber {
                field: "number of flanks",
                value: 0.0,
                allowed: "1 or 2",
            });
        }
    };
    let asked =
        Sides::try_from_fn(|flank| flanks.contains(&flank).then(|| stretch(flank, angle)).transpose())?;
    Ok(StretchAngle { angle, stretch: asked })
}
