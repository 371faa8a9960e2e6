//! Finishing one flank: a cutter location at every point of the grid, contact heights within what root and opposite flank allow,
//! and a refusal where the cutter would dig in.

use super::wear::{HeightRule, HeightWindow};
use super::{
    CutterLocation, FlankGrid, GridPlace, LeadPoint, LocalContact, MillingError, Orientation, Patch,
    greatest_contact_height,
};
use crate::geometry::{Cutter, CutterShape};
use crate::numerics::brent;
use rayon::prelude::*;

/// How a flank is finished.
#[derive(Clone, Debug)]
pub struct FinishOptions<'a> {
    /// The cutter.
    pub cutter: &'a Cutter,
    /// Tilt and lead angle, the same everywhere.
    pub orientation: Orientation,
    /// Contact heights on a straight side.
    pub heights: &'a HeightRule,
    /// Height above the lead point that the cutter's corner must not go below, mm.
    pub bottom: Option<f64>,
    /// The opposite flank and what the cutter keeps from it, mm.
    pub opposite: Option<(Patch<'a>, f64)>,
}

/// One row with the cutter at all of its points.
#[derive(Clone, Debug, PartialEq)]
pub struct FinishedRow {
    /// Contact height, mm; of corners, balls and barrels it follows from the axis and stands in the locations.
    pub contact_height: f64,
    /// What root and edge allow, and the opposite flank where it does not let the wanted height pass; `None` for cutters without a
    /// straight side.
    pub window: Option<HeightWindow>,
    /// Whether the rule asked for a height outside of the window.
    pub limited: bool,
    /// The cutter, column by column.
    pub locations: Vec<CutterLocation>,
}

/// Accuracy of a contact height that the opposite flank limits, mm; and clearances that count as the same, as those of all columns of a
/// cylinder are.
const HEIGHT_STEP: f64 = 1e-6;
const SAME: f64 = 1e-6;

/// The cutter at all points of a grid.
///
/// # Errors
/// [`MillingError::GougeLocal`] where the cutter digs in around its contact, [`MillingError::WearWindow`] and others of the contact heights,
/// [`MillingError::ToolGap`] where a cutter without a straight side comes too near to the opposite flank, and those of the locations.
pub fn finish(grid: &FlankGrid, options: &FinishOptions) -> Result<Vec<FinishedRow>, MillingError> {
    let shape = options.cutter.shape();
    let sided = has_side(shape, &options.orientation);
    let rows = grid.rows();
    // First of all whether this kind of cutter suits the flank at all.
    let height = if sided { least_height(shape) } else { 0.0 };
    for column in &grid.columns {
        for place in &column.places {
            let location = locate(place, &column.lead, options, height)?;
            LocalContact::new(&place.jet, &location, shape).check(&place.jet)?;
        }
    }
    let windows: Option<Vec<HeightWindow>> = if sided {
        let of_row = |row: usize| window(grid, row, options);
        Some((0..rows).into_par_iter().map(of_row).collect::<Result<_, _>>()?)
    } else {
        None
    };
    let heights = match &windows {
        Some(windows) => options.heights.heights(windows)?,
        None => vec![0.0; rows],
    };
    let of_row = |row: usize| {
        let mut locations = Vec::with_capacity(grid.columns.len());
        for (number, column) in grid.columns.iter().enumerate() {
            let place = &column.places[row];
            let location = locate(place, &column.lead, options, heights[row])?;
            LocalContact::new(&place.jet, &location, shape).check(&place.jet)?;
            if let (false, Some((opposite, wanted))) = (sided, &options.opposite) {
                let kept = opposite.keeps(options.cutter, &location.tip, &location.axis, *wanted);
                kept.map_err(|near| MillingError::ToolGap {
                    row,
                    column: number,
                    from: "opposite flank",
                    clearance: near.value,
                    wanted: *wanted,
                })?;
            }
            locations.push(location);
        }
        Ok(FinishedRow {
            contact_height: heights[row],
            window: windows.as_ref().map(|windows| windows[row]),
            limited: options.heights.wanted(row, rows).is_some_and(|wanted| sided && wanted != heights[row]),
            locations,
        })
    };
    (0..rows).into_par_iter().map(of_row).collect()
}

/// Where the straight side of a cutter begins, mm above the tip.
pub(super) fn least_height(shape: &CutterShape) -> f64 {
    match shape {
        CutterShape::Conical { half_angle, corner_radius, .. } => corner_radius * (1.0 - half_angle.sin()),
        CutterShape::Barrel { .. } => 0.0,
    }
}

/// Whether a straight side touches, so that the contact height is free.
fn has_side(shape: &CutterShape, orientation: &Orientation) -> bool {
    matches!(shape, CutterShape::Conical { .. }) && !shape.is_ball() && orientation.tilt == 0.0
}

fn locate(
    place: &GridPlace,
    lead: &LeadPoint,
    options: &FinishOptions,
    height: f64,
) -> Result<CutterLocation, MillingError> {
    let cutter = options.cutter;
    CutterLocation::new(
        &place.jet,
        lead,
        cutter.shape(),
        cutter.cutting_length(),
        height,
        options.orientation,
    )
}

/// Contact heights that all places of a row allow. How far the opposite flank limits them is looked for only where it does not let the
/// wanted height pass.
fn window(grid: &FlankGrid, row: usize, options: &FinishOptions) -> Result<HeightWindow, MillingError> {
    let CutterShape::Conical { corner_radius, .. } = *options.cutter.shape() else {
        return Ok(HeightWindow { least: 0.0, greatest: 0.0 });
    };
    let least = least_height(options.cutter.shape());
    let mut greatest = options.cutter.cutting_length();
    for column in &grid.columns {
        let place = &column.places[row];
        let (point, normal) = (&place.jet.point, &place.jet.normal);
        if let Some(bottom) = options.bottom {
            let axis = locate(place, &column.lead, options, least)?.axis;
            let limit = greatest_contact_height(&column.lead, point, normal, &axis, corner_radius, bottom);
            greatest = greatest.min(limit);
        }
    }
    let asked = options.heights.wanted(row, grid.rows()).unwrap_or(greatest);
    let Some((opposite, wanted)) = &options.opposite else { return Ok(HeightWindow { least, greatest }) };
    if greatest < least {
        return Ok(HeightWindow { least, greatest });
    }
    let mut reached = asked.clamp(least, greatest);
    let mut limited = false;
    let tool = |column: usize, height: f64| {
        let column = &grid.columns[column];
        locate(&column.places[row], &column.lead, options, height)
    };
    // The deeper tool contains the other one: what it keeps falls with the height.
    let beyond = |column: usize, height: f64| {
        let location = tool(column, height)?;
        let kept = opposite.clearance(options.cutter, &location.tip, &location.axis);
        Ok::<_, MillingError>(kept.value - wanted)
    };
    let mut narrow = Vec::new();
    for column in 0..grid.columns.len() {
        let location = tool(column, reached)?;
        if opposite.keeps(options.cutter, &location.tip, &location.axis, *wanted).is_err() {
            narrow.push((column, beyond(column, reached)?));
        }
    }
    // The narrowest column first: the height that it allows is as a rule that of the row.
    narrow.sort_by(|a, b| a.1.total_cmp(&b.1));
    for (column, kept) in narrow {
        let deepest = if limited { beyond(column, reached)? } else { kept };
        if deepest >= -SAME {
            continue;
        }
        let highest = beyond(column, least)?;
        if highest < 0.0 {
            let (from, clearance) = ("opposite flank", highest + wanted);
            return Err(MillingError::ToolGap { row, column, from, clearance, wanted: *wanted });
        }
        let limit = brent([least, reached], [highest, deepest], HEIGHT_STEP, |h| beyond(column, h).ok());
        reached = limit.unwrap_or(least);
        limited = true;
    }
    Ok(HeightWindow { least, greatest: if limited { reached } else { greatest } })
}
