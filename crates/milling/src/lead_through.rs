//! Guide curves of cylinders whose column planes hold the normals of a chosen row (`docs/mathematics/milling.md#columns-and-rows`): eps = 0
//! there.

use super::{ActiveFlank, Column, HelixOnCylinder, MillingError, RowSpacing};
use foundation::numerics::brent;

/// Radii looked at, as shares of the given one, and pieces between them in which a change of sign is looked for.
const SHARES: [f64; 2] = [0.5, 2.0];
const PIECES: usize = 60;

/// r_0: the radius of the guide curve with which the normals of a height lie in their column planes, mm.
///
/// # Errors
/// [`MillingError::NoSuchLead`] if there is none between half and twice the radius of `lead`.
pub fn lead_through_row(
    flank: &ActiveFlank,
    lead: &HelixOnCylinder,
    row: usize,
    rows: usize,
) -> Result<f64, MillingError> {
    let off = |radius: f64| {
        let column =
            Column::build(flank, &HelixOnCylinder { radius, ..*lead }, 0.0, rows, RowSpacing::Arc).ok()?;
        Some(column.places.get(row)?.out_of_plane)
    };
    let [from, to] = SHARES.map(|share| share * lead.radius);
    let at = |piece: usize| from + (to - from) * piece as f64 / PIECES as f64;
    // The root that is nearest to the given radius.
    let mut best: Option<f64> = None;
    for piece in 0..PIECES {
        let ends = [at(piece), at(piece + 1)];
        let [Some(first), Some(last)] = ends.map(off) else { continue };
        if let Some(radius) = brent(ends, [first, last], 0.0, off)
            && best.is_none_or(|best| (radius - lead.radius).abs() < (best - lead.radius).abs())
        {
            best = Some(radius);
        }
    }
    best.ok_or(MillingError::NoSuchLead { from, to })
}
