//! Finishing one flank: a cutter location at every point of the grid, contact heights within what root and opposite flank allow,
//! and a refusal where the cutter would dig in.

use super::wear::{HeightRule, HeightWindow};
use super::{
    Column, CutterLocation, FlankGrid, GridPlace, LeadPoint, LocalContact, MillingError, Obstacle,
    Orientation, RootDepth, RootSection, greatest_contact_height,
};
use foundation::geometry::{Cutter, CutterShape, in_tool};
use foundation::numerics::brent;
use nalgebra::Vector3;
use rayon::prelude::*;

/// The finished bottom of the space.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Bottom {
    /// At this height above the lead point, mm.
    Level(f64),
    /// Where the fillet below the lowest active point of a column ends if a straight piece of this length lies between them, mm.
    BelowFlank(f64),
}

/// Something that a cutter keeps away from while it finishes a flank.
#[derive(Clone, Debug)]
pub enum Kept<'a> {
    /// A surface.
    Surface(Obstacle<'a>),
    /// Points in every column's plane, those of the drawn root below a flank.
    Points {
        /// What they belong to, for messages.
        name: &'static str,
        /// Column by column, mm.
        columns: Vec<Vec<Vector3<f64>>>,
        /// What the cutter has to keep, mm.
        wanted: f64,
    },
}

impl Kept<'_> {
    /// What it is, and what is to be kept from it.
    fn name_and_wanted(&self) -> (&'static str, f64) {
        match self {
            Self::Surface(obstacle) => (obstacle.name, obstacle.wanted),
            Self::Points { name, wanted, .. } => (name, *wanted),
        }
    }

    /// Whether a cutter at a place of a column keeps away.
    fn keeps(&self, cutter: &Cutter, column: usize, at: &CutterLocation) -> bool {
        match self {
            Self::Surface(Obstacle { patch, wanted, .. }) => {
                patch.keeps(cutter, &at.tip, &at.axis, *wanted).is_ok()
            }
            Self::Points { wanted, .. } => self.clearance(cutter, column, at) >= *wanted,
        }
    }

    /// How far away it is, mm.
    fn clearance(&self, cutter: &Cutter, column: usize, at: &CutterLocation) -> f64 {
        match self {
            Self::Surface(obstacle) => obstacle.patch.clearance(cutter, &at.tip, &at.axis).value,
            Self::Points { columns, .. } => nearest(cutter, &at.tip, &at.axis, &columns[column]),
        }
    }
}

/// Distance of a cutter from the nearest of some points, mm.
pub(super) fn nearest(
    cutter: &Cutter,
    tip: &Vector3<f64>,
    axis: &Vector3<f64>,
    points: &[Vector3<f64>],
) -> f64 {
    let distance = |point: &Vector3<f64>| {
        let [rho, z] = in_tool(point, tip, axis);
        cutter.distance(rho, z)
    };
    points.iter().map(distance).fold(f64::INFINITY, f64::min)
}

/// How a flank is finished.
#[derive(Clone, Debug)]
pub struct FinishOptions<'a> {
    /// The cutter.
    pub cutter: &'a Cutter,
    /// Tilt and lead angle.
    pub orientation: Orientation,
    /// Tilt of the last row, rad, where rows lean differently: linear in the row's number.
    pub tilt_at_tip: Option<f64>,
    /// Contact heights on a straight side.
    pub heights: &'a HeightRule,
    /// The finished bottom, and what the cutter's corner keeps from it, mm.
    pub bottom: Option<(Bottom, f64)>,
    /// What limits the contact heights beside it: opposite flank, root body, drawn root.
    pub kept: Vec<Kept<'a>>,
}

impl FinishOptions<'_> {
    /// How the axis is turned in a row of so many.
    pub fn orientation_of(&self, row: usize, rows: usize) -> Orientation {
        let from = self.orientation.tilt;
        let share = row as f64 / rows.saturating_sub(1).max(1) as f64;
        let tilt = self.tilt_at_tip.map_or(from, |to| from + (to - from) * share);
        Orientation { tilt, ..self.orientation }
    }
}

/// One row with the cutter at all of its points.
#[derive(Clone, Debug, PartialEq)]
pub struct FinishedRow {
    /// How the axis is turned.
    pub orientation: Orientation,
    /// Contact height, mm; of corners, balls and barrels it follows from the axis and stands in the locations.
    pub contact_height: f64,
    /// What bottom and edge allow, and opposite flank and root body where they do not let the wanted height pass; `None` for cutters
    /// without a straight side.
    pub window: Option<HeightWindow>,
    /// Whether the rule asked for a height outside of the window.
    pub limited: bool,
    /// The cutter, column by column.
    pub locations: Vec<CutterLocation>,
}

/// Accuracy of a contact height that a body limits, mm; and clearances that count as the same, as those of all columns of a
/// cylinder are.
const HEIGHT_STEP: f64 = 1e-6;
const SAME: f64 = 1e-6;

/// The cutter at all points of a grid.
///
/// # Errors
/// [`MillingError::GougeLocal`] where the cutter digs in around its contact, [`MillingError::WearWindow`] and others of the contact heights,
/// [`MillingError::ToolGap`] where a cutter without a straight side, or one at its least contact height, comes too near to what limits it,
/// and those of the locations.
pub fn finish(grid: &FlankGrid, options: &FinishOptions) -> Result<Vec<FinishedRow>, MillingError> {
    let shape = options.cutter.shape();
    let sided = has_side(shape, &options.orientation) && options.tilt_at_tip.is_none();
    let rows = grid.rows();
    // First of all whether this kind of cutter suits the flank at all.
    let height = if sided { least_height(shape) } else { 0.0 };
    for column in &grid.columns {
        for (row, place) in column.places.iter().enumerate() {
            let turned = options.orientation_of(row, rows);
            let location = locate(place, &column.lead, (options.cutter, turned), height)?;
            LocalContact::new(&place.jet, &location, shape).check(&place.jet)?;
        }
    }
    let windows: Option<Vec<HeightWindow>> = if sided {
        let of_row = |row: usize| window(grid, row, options);
        // Collected before the first error is looked for: it is the same whatever the threads.
        let all: Vec<_> = (0..rows).into_par_iter().map(of_row).collect();
        Some(all.into_iter().collect::<Result<_, _>>()?)
    } else {
        None
    };
    let heights = match &windows {
        Some(windows) => options.heights.heights(windows)?,
        None => vec![0.0; rows],
    };
    let of_row = |row: usize| {
        let mut locations = Vec::with_capacity(grid.columns.len());
        let turned = options.orientation_of(row, rows);
        for (number, column) in grid.columns.iter().enumerate() {
            let place = &column.places[row];
            let location = locate(place, &column.lead, (options.cutter, turned), heights[row])?;
            LocalContact::new(&place.jet, &location, shape).check(&place.jet)?;
            let all: &[Kept] = if sided { &[] } else { &options.kept };
            if let Some(met) = all.iter().find(|kept| !kept.keeps(options.cutter, number, &location)) {
                let (from, wanted) = met.name_and_wanted();
                let clearance = met.clearance(options.cutter, number, &location);
                return Err(MillingError::ToolGap { row, column: number, from, clearance, wanted });
            }
            locations.push(location);
        }
        Ok(FinishedRow {
            orientation: turned,
            contact_height: heights[row],
            window: windows.as_ref().map(|windows| windows[row]),
            limited: options.heights.wanted(row, rows).is_some_and(|wanted| sided && wanted != heights[row]),
            locations,
        })
    };
    let all: Vec<_> = (0..rows).into_par_iter().map(of_row).collect();
    all.into_iter().collect()
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
    (cutter, turned): (&Cutter, Orientation),
    height: f64,
) -> Result<CutterLocation, MillingError> {
    CutterLocation::new(&place.jet, lead, cutter.shape(), cutter.cutting_length(), height, turned)
}

/// The contact height of a cutter at which its corner just keeps what it has to keep from the bottom, mm.
fn above_bottom(
    column: &Column,
    row: usize,
    options: &FinishOptions,
    (bottom, keep): (Bottom, f64),
) -> Result<f64, MillingError> {
    let CutterShape::Conical { corner_radius, .. } = *options.cutter.shape() else {
        return Ok(f64::INFINITY);
    };
    let least = least_height(options.cutter.shape());
    // Only a straight side has a height that is chosen, and takes no tilt.
    let tool = (options.cutter, options.orientation);
    let axis = |place: &GridPlace| Ok::<_, MillingError>(locate(place, &column.lead, tool, least)?.axis);
    let level = match bottom {
        Bottom::Level(height) => height,
        Bottom::BelowFlank(straight) => {
            let lowest = &column.places[0];
            let section = RootSection::new(
                &column.lead,
                &lowest.jet.point,
                &lowest.jet.normal,
                &axis(lowest)?,
                corner_radius,
                options.cutter.cutting_length(),
                RootDepth::Straight(straight),
            )?;
            section.lowest[1]
        }
    };
    let place = &column.places[row];
    let (point, normal) = (&place.jet.point, &place.jet.normal);
    Ok(greatest_contact_height(&column.lead, point, normal, &axis(place)?, corner_radius, level + keep))
}

/// Contact heights that all places of a row allow. How far bodies limit them is looked for only where they do not let the wanted height
/// pass.
fn window(grid: &FlankGrid, row: usize, options: &FinishOptions) -> Result<HeightWindow, MillingError> {
    if !matches!(options.cutter.shape(), CutterShape::Conical { .. }) {
        return Ok(HeightWindow { least: 0.0, greatest: 0.0 });
    }
    let least = least_height(options.cutter.shape());
    let mut greatest = options.cutter.cutting_length();
    if let Some(bottom) = options.bottom {
        for column in &grid.columns {
            greatest = greatest.min(above_bottom(column, row, options, bottom)?);
        }
    }
    let asked = options.heights.wanted(row, grid.rows()).unwrap_or(greatest);
    if greatest < least {
        return Ok(HeightWindow { least, greatest });
    }
    let mut reached = asked.clamp(least, greatest);
    let mut limited = false;
    for kept in &options.kept {
        if let Some(height) = limit(grid, row, options, kept, [least, reached])? {
            (reached, limited) = (height, true);
        }
    }
    Ok(HeightWindow { least, greatest: if limited { reached } else { greatest } })
}

/// The contact height to which something limits a row, between the least one and the one that is to be reached; `None` where the latter
/// is free.
fn limit(
    grid: &FlankGrid,
    row: usize,
    options: &FinishOptions,
    kept: &Kept,
    [least, asked]: [f64; 2],
) -> Result<Option<f64>, MillingError> {
    let (from, wanted) = kept.name_and_wanted();
    let tool = |column: usize, height: f64| {
        let column = &grid.columns[column];
        locate(&column.places[row], &column.lead, (options.cutter, options.orientation), height)
    };
    // The deeper tool contains the other one: what it keeps falls with the height.
    let beyond = |column: usize, height: f64| {
        Ok::<_, MillingError>(kept.clearance(options.cutter, column, &tool(column, height)?) - wanted)
    };
    let mut narrow = Vec::new();
    for column in 0..grid.columns.len() {
        if !kept.keeps(options.cutter, column, &tool(column, asked)?) {
            narrow.push((column, beyond(column, asked)?));
        }
    }
    // The narrowest column first: the height that it allows is as a rule that of the row.
    narrow.sort_by(|a, b| a.1.total_cmp(&b.1));
    let mut reached = asked;
    let mut limited = false;
    for (column, at_asked) in narrow {
        let deepest = if limited { beyond(column, reached)? } else { at_asked };
        if deepest >= -SAME {
            continue;
        }
        let highest = beyond(column, least)?;
        if highest < 0.0 {
            return Err(MillingError::ToolGap { row, column, from, clearance: highest + wanted, wanted });
        }
        let height = brent([least, reached], [highest, deepest], HEIGHT_STEP, |h| beyond(column, h).ok());
        reached = height.unwrap_or(least);
        limited = true;
    }
    Ok(limited.then_some(reached))
}
