//! One space from blank to finished: roughing, both flanks row by row, the root, in the order in which they are cut.

use super::finish::{FinishOptions, FinishedRow, finish};
use super::lines::{LaidLines, Lines, SpacingLaw, lay_lines};
use super::path::{CutDirection, CutterPath, CutterPlace, RowOrder, Traverse};
use super::root_pass::{RootDepth, RootSection};
use super::space::{Space, SpaceFlank};
use super::{
    CutterLocation, FlankGrid, HeightRule, LocalContact, MillingError, Orientation, Patch, RoughingLayer,
    RoughingOptions, check_access, check_path, drawn_section, rough, row_distance, row_path,
};
use crate::geometry::{Cutter, Flank};
use crate::numerics::{equidistant, extremes};

/// What a space is milled with and how.
#[derive(Clone, Debug)]
pub struct PlanOptions {
    /// The cutter of the flanks.
    pub cutter: Cutter,
    /// The cutter of the bottom; the flanks' own without.
    pub bottom_cutter: Option<Cutter>,
    /// The cutter that clears the space; the flanks' own without.
    pub roughing_cutter: Option<Cutter>,
    /// Rows and columns.
    pub lines: Lines,
    /// Law of the rows.
    pub spacing: SpacingLaw,
    /// Tilt and lead angle.
    pub orientation: Orientation,
    /// Contact heights.
    pub heights: HeightRule,
    /// How far the path goes on beyond the face, mm.
    pub overrun: f64,
    /// What the cutter keeps from everything that it does not mill, mm.
    pub safety: f64,
    /// Senses of the rows.
    pub traverse: Traverse,
    /// Order of the rows.
    pub order: RowOrder,
    /// Root: its depth, and whether the bottom between the fillets is milled as well.
    pub root: Option<(RootDepth, bool)>,
    /// Height of the finished bottom above the lead point that rows keep away from by the safety distance, mm.
    pub bottom: Option<f64>,
    /// Clearing: allowance, greatest depth of a layer and greatest distance of passes, mm.
    pub roughing: Option<[f64; 3]>,
    /// The flanks that are milled.
    pub sides: Vec<Flank>,
}

/// What a row leaves, by curvatures at its middle column. mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RowFigures {
    /// Scallop to the next row towards the tip; none above the last row.
    pub scallop: Option<f64>,
    /// Error of the straight blocks.
    pub chord: f64,
    /// Greatest angle of the normals out of their column planes, rad.
    pub out_of_plane: f64,
    /// Greatest angle of the axis out of its column plane, rad; 0 without a lead angle.
    pub axis_off: f64,
    /// Least curvature of the gap between cutter and flank, 1/mm.
    pub opening: f64,
}

/// The plan of one flank.
#[derive(Clone, Debug)]
pub struct FlankPlan {
    /// Which.
    pub side: Flank,
    /// Its rows and columns.
    pub lines: LaidLines,
    /// The cutter at all points of the path's grid.
    pub rows: Vec<FinishedRow>,
    /// What the rows leave.
    pub figures: Vec<RowFigures>,
    /// The root below the flank, column by column of the path.
    pub root: Vec<(RootSection, CutterLocation)>,
}

/// What an operation does.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum OperationKind {
    /// Clears the space.
    Roughing,
    /// Finishes the rows of a flank.
    Flank(Flank),
    /// Goes on below a flank with the fillet.
    Fillet(Flank),
    /// Joins both fillets.
    Bottom,
}

/// Paths of one cutter in the order of cutting.
#[derive(Clone, Debug)]
pub struct Operation {
    /// What it does.
    pub kind: OperationKind,
    /// Its paths.
    pub paths: Vec<CutterPath>,
}

/// A space from blank to finished.
#[derive(Clone, Debug)]
pub struct MillingPlan {
    /// The flanks.
    pub flanks: Vec<FlankPlan>,
    /// The layers that clear the space.
    pub layers: Vec<RoughingLayer>,
    /// Everything in its order.
    pub operations: Vec<Operation>,
}

impl PlanOptions {
    /// The cutter of an operation.
    pub fn cutter_of(&self, kind: OperationKind) -> &Cutter {
        let own = match kind {
            OperationKind::Roughing => &self.roughing_cutter,
            OperationKind::Bottom => &self.bottom_cutter,
            OperationKind::Flank(_) | OperationKind::Fillet(_) => &None,
        };
        own.as_ref().unwrap_or(&self.cutter)
    }
}

/// Plans a space.
///
/// # Errors
/// [`MillingError`], with [`MillingError::Collides`] where the cutter comes too near to something on its way.
pub fn plan(space: &Space, options: &PlanOptions) -> Result<MillingPlan, MillingError> {
    let milled = space.flanks.iter().filter(|flank| options.sides.contains(&flank.side));
    let flanks = milled.map(|flank| plan_flank(space, flank, options)).collect::<Result<Vec<_>, _>>()?;
    let layers = roughing(space, options, &flanks)?;
    let mut operations = Vec::new();
    if !layers.is_empty() {
        let paths = layers.iter().flat_map(|layer| layer.passes.iter().cloned()).collect();
        operations.push(Operation { kind: OperationKind::Roughing, paths });
    }
    for flank in &flanks {
        operations
            .push(Operation { kind: OperationKind::Flank(flank.side), paths: rows_in_order(flank, options) });
    }
    for flank in flanks.iter().filter(|flank| !flank.root.is_empty()) {
        let locations: Vec<_> = flank
            .root
            .iter()
            .zip(&flank.lines.path.columns)
            .map(|((_, location), column)| (*location, column.places[0].jet.point))
            .collect();
        operations.push(Operation {
            kind: OperationKind::Fillet(flank.side),
            paths: vec![directed(&locations, flank, 0, options.traverse.of_row(0))],
        });
    }
    if let Some((_, true)) = options.root {
        let paths = bottom(options, &flanks)?;
        operations.push(Operation { kind: OperationKind::Bottom, paths });
    }
    check_access(space, options, &flanks)?;
    for operation in &operations {
        check(space, options, operation)?;
    }
    Ok(MillingPlan { flanks, layers, operations })
}

fn plan_flank(space: &Space, flank: &SpaceFlank, options: &PlanOptions) -> Result<FlankPlan, MillingError> {
    let finishing = FinishOptions {
        cutter: &options.cutter,
        orientation: options.orientation,
        heights: &options.heights,
        bottom: options.bottom.map(|bottom| bottom + options.safety),
        opposite: space.opposite(flank.side).map(|opposite| (opposite.patch(0.0), options.safety)),
    };
    let (active, lead) = (&flank.active, &*space.lead);
    let lines = lay_lines(active, lead, None, &options.lines, options.spacing, &finishing, options.overrun)?;
    let rows = finish(&lines.path, &finishing)?;
    let figures = figures(&lines.path, &rows, options);
    let root = match options.root {
        Some((depth, _)) => root(&lines.path, options, depth)?,
        None => Vec::new(),
    };
    Ok(FlankPlan { side: flank.side, lines, rows, figures, root })
}

/// What the rows leave at the middle column.
fn figures(grid: &FlankGrid, rows: &[FinishedRow], options: &PlanOptions) -> Vec<RowFigures> {
    let middle = grid.columns.len() / 2;
    let neighbour = if middle + 1 < grid.columns.len() { middle + 1 } else { middle - 1 };
    let place = |row: usize, column: usize| &grid.columns[column].places[row];
    let of_row = |(row, finished): (usize, &FinishedRow)| {
        let here = place(row, middle);
        let local = LocalContact::new(&here.jet, &finished.locations[middle], options.cutter.shape());
        let block = (place(row, neighbour).jet.point - here.jet.point).norm();
        let feed = &here.jet.by_length;
        let scallop = (row + 1 < rows.len()).then(|| {
            let between = place(row + 1, middle).jet.point - here.jet.point;
            local.scallop(feed, row_distance(feed, &between))
        });
        let greatest = |value: &dyn Fn(usize) -> f64| {
            (0..grid.columns.len()).map(|column| value(column).abs()).fold(0.0, f64::max)
        };
        RowFigures {
            scallop,
            chord: local.chord(feed, block),
            out_of_plane: greatest(&|column| place(row, column).out_of_plane),
            axis_off: greatest(&|column| finished.locations[column].out_of_plane),
            opening: local.least_opening(),
        }
    };
    rows.iter().enumerate().map(of_row).collect()
}

/// The pass below the lowest row, column by column.
fn root(
    grid: &FlankGrid,
    options: &PlanOptions,
    depth: RootDepth,
) -> Result<Vec<(RootSection, CutterLocation)>, MillingError> {
    let of_column = |column: &super::Column| {
        let lowest = &column.places[0].jet;
        let section = drawn_section(&column.lead, lowest, options, depth)?;
        let (shape, length) = (options.cutter.shape(), options.cutter.cutting_length());
        let (height, orientation) = (section.contact_height, options.orientation);
        let location = CutterLocation::new(lowest, &column.lead, shape, length, height, orientation)?;
        Ok((section, location))
    };
    grid.columns.iter().map(of_column).collect()
}

/// Rows in the order and the senses that are asked for.
fn rows_in_order(flank: &FlankPlan, options: &PlanOptions) -> Vec<CutterPath> {
    let mut order: Vec<usize> = (0..flank.rows.len()).collect();
    if options.order == RowOrder::TipToRoot {
        order.reverse();
    }
    let of_row = |(number, row): (usize, usize)| {
        let contacts = flank.lines.path.columns.iter().map(|column| column.places[row].jet.point);
        let locations: Vec<_> = flank.rows[row].locations.iter().copied().zip(contacts).collect();
        directed(&locations, flank, row, options.traverse.of_row(number))
    };
    order.into_iter().enumerate().map(of_row).collect()
}

/// A row's path in the wanted sense of cutting.
fn directed(
    locations: &[(CutterLocation, nalgebra::Vector3<f64>)],
    flank: &FlankPlan,
    row: usize,
    wanted: CutDirection,
) -> CutterPath {
    let middle = locations.len() / 2;
    let travel = locations[middle].1 - locations[middle - 1].1;
    let normal = &flank.lines.path.columns[middle].places[row].jet.normal;
    let forwards = CutDirection::of(&travel, &locations[middle].0.axis, normal);
    row_path(locations, forwards != wanted)
}

/// The passes between both fillets, axis upright.
fn bottom(options: &PlanOptions, flanks: &[FlankPlan]) -> Result<Vec<CutterPath>, MillingError> {
    let cutter = options.cutter_of(OperationKind::Bottom);
    let radius = match cutter.shape() {
        crate::geometry::CutterShape::Conical { radius, half_angle, .. } if *half_angle == 0.0 => *radius,
        _ => return Err(MillingError::RootTool),
    };
    // Each flank tells one end of the travel across; with one flank only, both ends are its own, mirrored.
    let mut ends: Vec<Vec<(super::LeadPoint, f64, f64)>> = Vec::new();
    for flank in flanks {
        let of_column = |(column, (section, _)): (&super::Column, &(RootSection, CutterLocation))| {
            let pass = section.bottom_pass(column.lead.u, radius)?;
            Ok::<_, MillingError>((column.lead, pass.half_travel.copysign(section.lowest[0]), pass.height))
        };
        ends.push(flank.lines.path.columns.iter().zip(&flank.root).map(of_column).collect::<Result<_, _>>()?);
    }
    let [first, .., last] = ends.as_slice() else {
        let Some(only) = ends.first() else { return Ok(Vec::new()) };
        let mirrored: Vec<_> = only.iter().map(|(lead, aside, height)| (*lead, -aside, *height)).collect();
        return Ok(across(only, &mirrored, radius));
    };
    // Both flanks have their own columns; the travel of the second one is read at the columns of the first one.
    let at: Vec<f64> = last.iter().map(|(lead, ..)| lead.u).collect();
    let read = |u: f64, value: &dyn Fn(usize) -> f64| {
        let k = at.partition_point(|x| *x <= u).clamp(1, at.len() - 1);
        let share = ((u - at[k - 1]) / (at[k] - at[k - 1])).clamp(0.0, 1.0);
        value(k - 1) + (value(k) - value(k - 1)) * share
    };
    let other: Vec<_> = first
        .iter()
        .map(|(lead, ..)| (*lead, read(lead.u, &|k| last[k].1), read(lead.u, &|k| last[k].2)))
        .collect();
    Ok(across(first, &other, radius))
}

/// Passes side by side from one end of the travel to the other, at most half a tool apart.
fn across(
    first: &[(super::LeadPoint, f64, f64)],
    last: &[(super::LeadPoint, f64, f64)],
    radius: f64,
) -> Vec<CutterPath> {
    let widest = first.iter().zip(last).map(|(a, b)| (a.1 - b.1).abs()).fold(0.0, f64::max);
    let passes = (widest / radius).ceil() as usize + 1;
    let pass = |share: f64| {
        let place = |(a, b): (&(super::LeadPoint, f64, f64), &(super::LeadPoint, f64, f64))| {
            let lead = &a.0;
            let [aside, height] = [[a.1, b.1], [a.2, b.2]].map(|[from, to]| from + (to - from) * share);
            let tip = lead.point + lead.abscissa() * aside + lead.base_normal * height;
            CutterPlace { tip, axis: lead.base_normal, contact: None }
        };
        CutterPath { places: first.iter().zip(last).map(place).collect() }
    };
    if passes == 1 {
        return vec![pass(0.5)];
    }
    equidistant([0.0, 1.0], passes).into_iter().map(pass).collect()
}

/// The layers over all columns of the first flank.
fn roughing(
    space: &Space,
    options: &PlanOptions,
    flanks: &[FlankPlan],
) -> Result<Vec<RoughingLayer>, MillingError> {
    let (Some([allowance, step_down, step_over]), [first, .., second], Some(plan)) =
        (options.roughing, space.flanks.as_slice(), flanks.first())
    else {
        return Ok(Vec::new());
    };
    let columns = &plan.lines.path.columns;
    let at: Vec<f64> = columns.iter().map(|column| column.lead.u).collect();
    let height = |column: &super::Column, row: usize| column.lead.in_plane(&column.places[row].jet.point)[1];
    let last = plan.rows.len() - 1;
    let top = columns.iter().map(|column| height(column, last)).fold(f64::NEG_INFINITY, f64::max);
    let lowest = columns.iter().map(|column| height(column, 0)).fold(f64::INFINITY, f64::min);
    let layers =
        RoughingOptions { allowance, top, bottom: options.bottom.unwrap_or(lowest), step_down, step_over };
    // Beside the face the cutter stays between the flanks as if they went on, or it would cut across their ends.
    let lengths = columns.iter().flat_map(|column| column.places.iter().map(|place| place.length));
    let lengths = extremes(lengths);
    let extended = |flank: &'_ SpaceFlank| {
        let [least, greatest] = flank.active.surface.domain()[1];
        [lengths[0].max(least), lengths[1].min(greatest)]
    };
    let patches = [first, second].map(|flank| Patch { lengths: extended(flank), ..flank.patch(0.0) });
    let cutter = options.cutter_of(OperationKind::Roughing);
    rough(cutter, &*space.lead, &at, patches, &layers)
}

/// Follows an operation's paths past everything that its cutter must not touch.
fn check(space: &Space, options: &PlanOptions, operation: &Operation) -> Result<(), MillingError> {
    let (on, safety) = match operation.kind {
        OperationKind::Flank(side) | OperationKind::Fillet(side) => (Some(side), options.safety),
        OperationKind::Bottom => (None, 0.0),
        // Roughing keeps its allowance from the flanks of the space; to a hundredth of a millimetre, as it was laid.
        OperationKind::Roughing => (None, 0.0),
    };
    let obstacles = space.obstacles(on, safety);
    let cutter = options.cutter_of(operation.kind);
    for (number, path) in operation.paths.iter().enumerate() {
        check_path(cutter, &path.places, &obstacles).map_err(|collision| MillingError::Collides {
            kind: operation.kind,
            path: number,
            collision,
        })?;
    }
    Ok(())
}
