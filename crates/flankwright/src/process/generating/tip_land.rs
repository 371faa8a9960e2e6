//! The counter flank while a plan's worm is dressed: the largest tip land that spares it (spec 30 section 13). Knows no worm
//! function.

use super::{GeneratingError, GrindingSetup};
use crate::geometry::Flank;
use crate::numerics::{Chebyshev, equidistant};
use crate::process::dressing::{DresserSection, DresserTool, ThreadSpace};

/// Worm positions at which the clearance is looked at: DK(v) is smooth.
const POSITIONS: usize = 17;

/// The largest tip land of the dresser with which the motion DK(v) of one flank spares the flank across the thread space, mm;
/// `None` if a dresser without land cuts into it. `left_out`: threads removed across the space.
///
/// # Errors
/// Those of [`DresserSection`].
pub fn largest_tip_land(
    setup: &GrindingSetup,
    tool: &DresserTool,
    flank: Flank,
    corrections: &[Chebyshev; 4],
    left_out: u32,
) -> Result<Option<f64>, GeneratingError> {
    let Some(choice) = &setup.input.dresser else { return Err(GeneratingError::NotDressed) };
    let section = DresserSection::new(tool, flank, 0.5 * choice.tip_diameter)?;
    let width = setup.input.worm_width.map(|width| [-0.5 * width, 0.5 * width]);
    let space = ThreadSpace { left_out, width };
    let (from, to) = corrections[0].interval();
    let mut least: Option<f64> = None;
    for v in equidistant([from, to], POSITIONS) {
        let dk = std::array::from_fn(|j| corrections[j].value(v));
        match section.largest_tip_land(&dk, 0.0, space)? {
            Some(land) => least = Some(least.map_or(land, |least| least.min(land))),
            None => return Ok(None),
        }
    }
    Ok(least)
}
