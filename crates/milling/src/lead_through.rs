//! Guide curves of cylinders whose column planes hold the normals of a chosen row (`docs/mathematics/milling.md#columns-and-rows`): eps = 0
//! there.

use super::{ActiveFlank, Column, ColumnPlane, HelixOnCylinder, LeadCurve, MillingError, RowSpacing};
use foundation::numerics::brent;

/// Radii looked at, as shares of the given one, and pieces between them in which a change of sign is looked for.
const SHARES: [f64; 2] = [0.5, 2.0];
const PIECES: usize = 60;

/// r_0: the radius of the guide curve with which the normals of a height lie in their column planes, mm.
///
/// # Errors
/// [`MillingError::NoSuchLead`] if there is none between half and twice the radius of `lead`.
pub fn lead_through_height(
    flank: &ActiveFlank,
    lead: &HelixOnCylinder,
    height: f64,
) -> Result<f64, MillingError> {
    search(lead, |lead| {
        let plane = ColumnPlane::new(flank, lead.at(0.0).ok()?);
        let section = plane.section(height, 0.0).ok()?;
        Some(section.jet.normal.dot(&plane.lead().direction))
    })
}

/// r_0 for a row of equal arcs, counted from 0 at the root, mm. The row moves with the radius.
///
/// # Errors
/// As [`lead_through_height`].
pub fn lead_through_row(
    flank: &ActiveFlank,
    lead: &HelixOnCylinder,
    row: usize,
    rows: usize,
) -> Result<f64, MillingError> {
    search(lead, |lead| {
        let column = Column::build(flank, lead, 0.0, rows, RowSpacing::Arc).ok()?;
        Some(column.places.get(row)?.out_of_plane)
    })
}

/// The root of an angle over the radius that is nearest to the given radius.
fn search(
    lead: &HelixOnCylinder,
    out_of_plane: impl Fn(&HelixOnCylinder) -> Option<f64>,
) -> Result<f64, MillingError> {
    let off = |radius: f64| out_of_plane(&HelixOnCylinder { radius, ..*lead });
    let [from, to] = SHARES.map(|share| share * lead.radius);
    let at = |piece: usize| from + (to - from) * piece as f64 / PIECES as f64;
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
