//! What a free direction of the worm's lines buys (`docs/mathematics/dressing.md#conditions`): both flanks ask for the same diagonal ratio
//! without a cone angle. Knows directions of lines, not what is written along them.

use super::GeneratingError;
use contact::{ContactError, DiagonalLine, Pair};
use foundation::geometry::{Flank, Sides};
use foundation::numerics::golden_section;
use std::f64::consts::PI;

/// Directions of the worm's lines with which one ratio serves both flanks.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FreeLines {
    /// rho_1 on each flank.
    pub lines: Sides<DiagonalLine>,
    /// The common K_ZV1.
    pub ratio: f64,
    /// K_ZV1 that each flank would ask for with the lines preferred; `None` where there is none.
    pub preferred_ratios: Sides<Option<f64>>,
}

/// A worm line nearer than this to a profile line or to the contact path is none, rad: along the first the worm cannot change,
/// and the second needs no worm line at all.
const DEGENERATE: f64 = 1e-3;
/// Steps of the search; the interval between the ratios preferred shrinks below rounding.
const STEPS: usize = 80;

/// rho_1 on each flank that lays the worm's lines onto `work` at ratio K.
///
/// # Errors
/// `DirectionIsContactPath`, `DirectionIsProfile` where the line needed is one of those.
pub fn lines_for_ratio(
    pair: &Pair,
    work: Sides<DiagonalLine>,
    ratio: f64,
) -> Result<Sides<DiagonalLine>, GeneratingError> {
    Sides::try_from_fn(|flank| {
        let relations = &pair.flanks[flank];
        let line = relations.worm_direction(work[flank], ratio)?;
        let direction_deg = line.rho.to_degrees();
        if turned(line.rho, 0.5 * PI).abs() < DEGENERATE {
            return Err(ContactError::DirectionIsProfile { direction_deg }.into());
        }
        if turned(line.rho, relations.contact_path()[0].rho).abs() < DEGENERATE {
            return Err(ContactError::DirectionIsContactPath { direction_deg }.into());
        }
        Ok(line)
    })
}

/// The lines nearest to those preferred with which both flanks ask for the same ratio: least sum of the squares of the angles
/// between them.
///
/// # Errors
/// Those of [`lines_for_ratio`]; the first error of the ratios if no flank has one with the lines preferred.
pub fn equal_ratio_lines(
    pair: &Pair,
    work: Sides<DiagonalLine>,
    preferred: Sides<DiagonalLine>,
) -> Result<FreeLines, GeneratingError> {
    let asked = Sides::from_fn(|flank| pair.flanks[flank].ratio_of_directions(preferred[flank], work[flank]));
    let off = |ratio: f64| {
        let lines = lines_for_ratio(pair, work, ratio).ok()?;
        let square = |flank: Flank| turned(lines[flank].rho, preferred[flank].rho).powi(2);
        Some(square(Flank::Left) + square(Flank::Right))
    };
    let ratio = match (&asked.left, &asked.right) {
        (Ok(left), Ok(right)) => {
            let (from, to) = (left.min(*right), left.max(*right));
            let inner = golden_section(from, to, STEPS, |k| off(k).unwrap_or(f64::INFINITY));
            // Golden section looks inside the interval only.
            let least = |k: f64| off(k).unwrap_or(f64::INFINITY);
            [inner, from, to].into_iter().min_by(|a, b| least(*a).total_cmp(&least(*b))).unwrap_or(inner)
        }
        (Ok(only), Err(_)) | (Err(_), Ok(only)) => *only,
        (Err(error), Err(_)) => return Err(error.clone().into()),
    };
    Ok(FreeLines {
        lines: lines_for_ratio(pair, work, ratio)?,
        ratio,
        preferred_ratios: asked.map(|_, k| k.as_ref().ok().copied()),
    })
}

/// Angle from one line to another, in (-90, 90] degrees.
fn turned(a: f64, b: f64) -> f64 {
    let apart = a - b;
    apart - PI * (apart / PI).round()
}
