//! The conical worm that a dresser fits without stretch on both flanks, P = 0, where no cylindrical one does
//! (`docs/mathematics/dressing.md#conditions`). Knows no wanted profile.

use crate::{DresserTool, DressingError, WormSeat, fit_profile};
use foundation::geometry::{Flank, Sides};

/// A worm of which neither flank is stretched.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StretchCone {
    /// The profile angle of the left flank by which the worm was asked for, rad.
    pub angle: f64,
    /// Its cone angle, rad.
    pub cone_angle: f64,
    /// What is left of P per flank.
    pub stretch: Sides<f64>,
}

/// Step of the differences, rad: P has some ten exact digits and bends little over it.
const DIFFERENCE: f64 = 1e-5;
/// P at which the worm counts as found.
const TOLERANCE: f64 = 1e-9;
/// Steps after which there is no such worm near.
const STEPS: usize = 20;
/// Longest step of an angle, rad; P has poles where the conjugate line ends.
const LONGEST: f64 = 0.03;
/// How often a step is halved that leads to no worm or to more stretch.
const HALVINGS: usize = 8;

/// The profile angle and the cone angle at which P = 0 on both flanks, sought from a cylindrical worm of the profile angle `start`
/// (rad) by Newton steps. `seat` places the worm of a profile angle and a cone angle, both in rad.
///
/// # Errors
/// Those of `seat` and of the fit at the start; [`DressingError::NoConeWithoutStretch`] where the steps end before P vanishes,
/// with the cone angle that they reached and what is left.
pub fn cone_without_stretch(
    dresser: &DresserTool,
    seat: &dyn Fn(f64, f64) -> Result<WormSeat, DressingError>,
    start: f64,
) -> Result<StretchCone, DressingError> {
    let stretch = |[angle, cone]: [f64; 2]| -> Result<[f64; 2], DressingError> {
        let seat = seat(angle, cone)?;
        let tool = dresser.on_worm(&seat)?;
        let of =
            |flank| fit_profile(&tool, flank, seat.reference_radius(), 0.0, &[0.0; 4]).map(|fit| fit.stretch);
        Ok([of(Flank::Left)?, of(Flank::Right)?])
    };
    let larger = |p: &[f64; 2]| p[0].abs().max(p[1].abs());
    let mut at = [start, 0.0];
    let mut p = stretch(at)?;
    for _ in 0..STEPS {
        if larger(&p) < TOLERANCE {
            let [left, right] = p;
            return Ok(StretchCone { angle: at[0], cone_angle: at[1], stretch: Sides { left, right } });
        }
        let Some(step) = newton_step(&stretch, at, p)? else { break };
        let shrink = (LONGEST / step[0].abs().max(step[1].abs())).min(1.0);
        let next = (0..=HALVINGS).find_map(|k| {
            let share = shrink * 0.5f64.powi(i32::try_from(k).unwrap_or(i32::MAX));
            let there = [at[0] + share * step[0], at[1] + share * step[1]];
            stretch(there).ok().filter(|q| larger(q) < larger(&p)).map(|q| (there, q))
        });
        let Some(next) = next else { break };
        (at, p) = next;
    }
    Err(DressingError::NoConeWithoutStretch { cone: at[1].to_degrees(), stretch: p })
}

/// The step to the zero of the tangents; `None` where they are parallel.
fn newton_step(
    stretch: &impl Fn([f64; 2]) -> Result<[f64; 2], DressingError>,
    at: [f64; 2],
    p: [f64; 2],
) -> Result<Option<[f64; 2]>, DressingError> {
    let by_angle = stretch([at[0] + DIFFERENCE, at[1]])?;
    let by_cone = stretch([at[0], at[1] + DIFFERENCE])?;
    let column = |q: [f64; 2]| [(q[0] - p[0]) / DIFFERENCE, (q[1] - p[1]) / DIFFERENCE];
    let ([a, c], [b, d]) = (column(by_angle), column(by_cone));
    let determinant = a * d - b * c;
    let scale = (a.abs() + c.abs()) * (b.abs() + d.abs());
    if determinant.abs() <= 1e-9 * scale {
        return Ok(None);
    }
    Ok(Some([(b * p[1] - d * p[0]) / determinant, (c * p[0] - a * p[1]) / determinant]))
}
