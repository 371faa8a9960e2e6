//! One space from blank to finished: roughing, both flanks row by row, the root, in the order in which they are cut.

use super::bottom::bottom;
use super::drawn_limits::{across, check_drawn_root};
use super::finish::{Bottom, FinishOptions, Kept, finish};
use super::flank_plan::{FlankPlan, figures};
use super::lines::lay_lines;
use super::middle::{Ended, Limits};
use super::milling_plan::{MillingPlan, Operation};
use super::operation_kind::OperationKind;
use super::path::RowOrder;
use super::plan_options::PlanOptions;
use super::root_pass::{RootDepth, RootSection};
use super::row_paths::RowPaths;
use super::space::{Space, SpaceFlank};
use super::wall::{DOWN_TO, SPARE, along_blocks};
use super::{
    Column, CutterLocation, FlankGrid, MillingError, Obstacle, Orientation, Patch, RoughingLayer,
    RoughingOptions, WallKind, check_access, check_path, drawn_section, root_limits, rough,
};
use foundation::numerics::extremes;
use rayon::prelude::*;

/// Plans a space that has several parts, the halves of a double-helical gear, one after the other in every stage of cutting: no cutter is
/// changed more often than for one part.
///
/// # Errors
/// As those of [`plan`].
pub fn plan_all(parts: &[Space], options: &PlanOptions) -> Result<MillingPlan, MillingError> {
    let mut whole = MillingPlan { flanks: Vec::new(), layers: Vec::new(), operations: Vec::new() };
    for part in parts {
        let MillingPlan { flanks, layers, operations } = plan(part, options)?;
        whole.flanks.extend(flanks);
        whole.layers.extend(layers);
        for operation in operations {
            match whole.operations.iter_mut().find(|known| known.kind == operation.kind) {
                Some(known) => known.paths.extend(operation.paths),
                None => whole.operations.push(operation),
            }
        }
    }
    whole.operations.sort_by_key(|operation| operation.kind.stage());
    Ok(whole)
}

/// Plans a space.
///
/// # Errors
/// [`MillingError`], with [`MillingError::Collides`] where the cutter comes too near to something on its way.
pub fn plan(space: &Space, options: &PlanOptions) -> Result<MillingPlan, MillingError> {
    let milled = space.flanks.iter().filter(|flank| options.sides.contains(&flank.side));
    let planned = milled.map(|flank| plan_flank(space, flank, options)).collect::<Result<Vec<_>, _>>()?;
    let (flanks, paths): (Vec<_>, Vec<_>) = planned.into_iter().unzip();
    let layers = roughing(space, options, &flanks)?;
    let mut operations = Vec::new();
    if !layers.is_empty() {
        let paths = layers.iter().flat_map(|layer| layer.passes.iter().cloned()).collect();
        operations.push(Operation { kind: OperationKind::Roughing, paths });
    }
    operations.extend(paths.into_iter().flatten());
    if let Some((_, true)) = options.root {
        let cutter = options.cutter_of(OperationKind::Bottom);
        let mut paths = bottom(options, &flanks)?;
        if let Some(limits) = Limits::of(space, cutter, None, 0.0) {
            let ended = paths.into_iter().map(|path| limits.end(path, 0));
            paths = ended.map(|ended| Ok(ended?.path)).collect::<Result<_, MillingError>>()?;
        }
        operations.push(Operation { kind: OperationKind::Bottom, paths });
    }
    check_access(space, options, &flanks)?;
    check_drawn_root(space, options, &flanks, &operations)?;
    operations.sort_by_key(|operation| operation.kind.stage());
    for operation in &operations {
        check(space, options, operation)?;
    }
    Ok(MillingPlan { flanks, layers, operations })
}

/// The plan of a flank, and the operations on it.
fn plan_flank(
    space: &Space,
    flank: &SpaceFlank,
    options: &PlanOptions,
) -> Result<(FlankPlan, Vec<Operation>), MillingError> {
    let side = flank.side();
    let orientation = options.orientation_on(side);
    let wanted = options.safety + SPARE;
    let opposite = space.opposite(flank.side);
    let across_space = opposite.map(|opposite| Obstacle {
        name: "opposite flank",
        patch: opposite.patch(0.0),
        wanted,
        between: true,
    });
    let mut finishing = FinishOptions {
        cutter: &options.cutter,
        orientation,
        tilt_at_tip: options.tilt_at_tip,
        heights: &options.heights,
        bottom: options.bottom.map(|bottom| (bottom, options.safety)),
        kept: across_space
            .into_iter()
            .chain(space.walls(WallKind::Base, wanted))
            .map(Kept::Surface)
            .collect(),
    };
    let (active, lead) = (flank.active.extended(), space.lead.clone());
    let lines =
        lay_lines(&active, &*lead, None, &options.lines, options.spacing, &finishing, options.overrun)?;
    finishing.kept.extend(across(opposite, options, &lines.path.columns, wanted)?);
    let rows = finish(&lines.path, &finishing)?;
    let figures = figures(&lines.path, &rows, options);
    let root = match options.root {
        Some((depth, _)) => root(&lines.path, options, orientation, depth)?,
        None => Vec::new(),
    };
    let paths = RowPaths { space, flank, options, columns: &lines.path.columns };
    let mut order: Vec<usize> = (0..rows.len()).collect();
    if options.order == RowOrder::TipToRoot {
        order.reverse();
    }
    let (mut milled, mut ends) = (Vec::new(), vec![None; rows.len()]);
    for (number, row) in order.into_iter().enumerate() {
        let made = paths.of_row(row, &rows[row], options.traverse.of_row(number))?;
        ends[row] = made.end;
        milled.push(made.path);
    }
    let mut operations = vec![Operation { kind: OperationKind::Flank(side), paths: milled }];
    if !root.is_empty() {
        let locations: Vec<CutterLocation> = root.iter().map(|(_, location)| *location).collect();
        let fillet = paths.of_fillet(&locations, options.traverse.of_row(0))?;
        operations.push(Operation { kind: OperationKind::Fillet(side), paths: vec![fillet] });
    }
    Ok((FlankPlan { side, active, lead, lines, rows, ends, figures, root }, operations))
}

/// The pass below the lowest row, column by column.
fn root(
    grid: &FlankGrid,
    options: &PlanOptions,
    orientation: Orientation,
    depth: RootDepth,
) -> Result<Vec<(RootSection, CutterLocation)>, MillingError> {
    let of_column = |column: &Column| {
        let lowest = &column.places[0].jet;
        let section = drawn_section(&column.lead, lowest, options, orientation, depth)?;
        let (shape, length) = (options.cutter.shape(), options.cutter.cutting_length());
        let height = section.contact_height;
        let location = CutterLocation::new(lowest, &column.lead, shape, length, height, orientation)?;
        Ok((section, location))
    };
    grid.columns.iter().map(of_column).collect()
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
    let height = |column: &Column, row: usize| column.lead.in_plane(&column.places[row].jet.point)[1];
    let last = plan.rows.len() - 1;
    let top = columns.iter().map(|column| height(column, last)).fold(f64::NEG_INFINITY, f64::max);
    let lowest = columns.iter().map(|column| height(column, 0)).fold(f64::INFINITY, f64::min);
    let bottom = match options.bottom {
        Some(Bottom::Level(height)) => height,
        Some(Bottom::BelowFlank(_)) | None => lowest,
    };
    let layers = RoughingOptions { allowance, top, bottom, step_down, step_over };
    // Beside the face the cutter stays between the flanks as if they went on, or it would cut across their ends.
    let lengths = columns.iter().flat_map(|column| column.places.iter().map(|place| place.length));
    let lengths = extremes(lengths);
    let extended = |flank: &'_ SpaceFlank| {
        let [least, greatest] = flank.active.surface.domain()[1];
        [lengths[0].max(least), lengths[1].min(greatest)]
    };
    let patches = [first, second].map(|flank| Patch { lengths: extended(flank), ..flank.patch(0.0) });
    let cutter = options.cutter_of(OperationKind::Roughing);
    let roots = at.iter().map(|&u| root_limits(space, options, u)).collect::<Result<Vec<_>, _>>()?;
    let mut layers = rough(cutter, &*space.lead, &at, patches, &roots, &layers)?;
    if let Some(limits) = Limits::of(space, cutter, None, allowance) {
        for layer in &mut layers {
            // A piece that lies wholly in the way of the other half is left out.
            let ended = std::mem::take(&mut layer.passes).into_iter().map(|pass| limits.end(pass, 0));
            layer.passes.extend(ended.flatten().map(|Ended { path, .. }| path));
            layer.passes.retain(|pass| pass.places.len() > 1);
        }
    }
    Ok(layers)
}

/// Follows an operation's paths past everything that its cutter must not touch.
fn check(space: &Space, options: &PlanOptions, operation: &Operation) -> Result<(), MillingError> {
    let (on, safety) = match operation.kind {
        OperationKind::Flank(side) | OperationKind::Fillet(side) => (Some(side.flank), options.safety),
        OperationKind::Bottom => (None, 0.0),
        // Roughing keeps its allowance from the flanks of the space; to a hundredth of a millimetre, as it was laid.
        OperationKind::Roughing => (None, 0.0),
    };
    // Passes of the root come down to the root body, and roughing as near as its allowance.
    let from_base = match operation.kind {
        OperationKind::Flank(_) => along_blocks(options.safety),
        OperationKind::Fillet(_) | OperationKind::Bottom | OperationKind::Roughing => -DOWN_TO,
    };
    let cutter = options.cutter_of(operation.kind);
    let mut obstacles = space.obstacles(on, safety);
    obstacles.extend(space.walls(WallKind::Base, from_base));
    for kind in [WallKind::Blade, WallKind::Back] {
        obstacles.extend(space.walls(kind, along_blocks(options.safety)));
    }
    if cutter.is_held() {
        obstacles.extend(space.walls(WallKind::Ring, along_blocks(options.safety)));
    }
    // Collected before the first error is looked for: it is the same whatever the threads.
    let all: Vec<_> =
        operation.paths.par_iter().map(|path| check_path(cutter, &path.places, &obstacles)).collect();
    let met = all.into_iter().enumerate().find_map(|(path, checked)| Some((path, checked.err()?)));
    met.map_or(Ok(()), |(path, collision)| {
        Err(MillingError::Collides { kind: operation.kind, path, collision })
    })
}
