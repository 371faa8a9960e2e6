//! The drawn root as something that cutters keep away from: rows from that across the space, all passes from the one that they leave.

use super::drawn_root::drawn_below;
use super::finish::{Kept, nearest};
use super::wall::DOWN_TO;
use super::{
    Clearance, Collision, Column, FlankPlan, LeadPoint, MillingError, Operation, OperationKind, PlanOptions,
    Space, SpaceFlank,
};
use nalgebra::Vector3;

const NAME: &str = "drawn root";

/// The drawn root below the flank across the space, in the planes of columns; nothing where no root is drawn.
pub(super) fn across<'a>(
    opposite: Option<&SpaceFlank>,
    options: &PlanOptions,
    columns: &[Column],
    wanted: f64,
) -> Result<Option<Kept<'a>>, MillingError> {
    let (Some(opposite), Some(_)) = (opposite, options.root) else { return Ok(None) };
    let below = |column: &Column| drawn_below(opposite, options, &column.lead);
    let columns = columns.iter().map(below).collect::<Result<Vec<_>, _>>()?;
    Ok(Some(Kept::Points { name: NAME, columns, wanted }))
}

/// Refuses places of passes at which a cutter digs into the root that the passes are to leave.
///
/// # Errors
/// [`MillingError::Collides`]; those of the sections.
pub(super) fn check_drawn_root(
    space: &Space,
    options: &PlanOptions,
    flanks: &[FlankPlan],
    operations: &[Operation],
) -> Result<(), MillingError> {
    let (Some(_), Some(first)) = (options.root, flanks.first()) else { return Ok(()) };
    for plan in flanks {
        let roots = Roots::new(space, options, &plan.lines.path.columns)?;
        for (row, finished) in plan.rows.iter().enumerate() {
            let places = finished.locations.iter().map(|at| (at.tip, at.axis));
            roots.check(options, OperationKind::Flank(plan.side), row, places)?;
        }
        let places = plan.root.iter().map(|(_, at)| (at.tip, at.axis));
        roots.check(options, OperationKind::Fillet(plan.side), 0, places)?;
    }
    // Bottom passes stand at the columns of the first flank, in their order; of a half of a double-helical gear they may end before.
    let roots = Roots::new(space, options, &first.lines.path.columns)?;
    for operation in operations.iter().filter(|operation| operation.kind == OperationKind::Bottom) {
        for (number, path) in operation.paths.iter().enumerate() {
            if path.places.len() == roots.columns.len() {
                let places = path.places.iter().map(|place| (place.tip, place.axis));
                roots.check(options, operation.kind, number, places)?;
            }
        }
    }
    Ok(())
}

/// The drawn root below both flanks, column by column.
struct Roots {
    columns: Vec<Vec<Vector3<f64>>>,
}

impl Roots {
    fn new(space: &Space, options: &PlanOptions, columns: &[Column]) -> Result<Self, MillingError> {
        let below = |lead: &LeadPoint| {
            let both = space.flanks.iter().map(|flank| drawn_below(flank, options, lead));
            Ok::<_, MillingError>(both.collect::<Result<Vec<_>, _>>()?.concat())
        };
        let columns = columns.iter().map(|column| below(&column.lead)).collect::<Result<_, _>>()?;
        Ok(Self { columns })
    }

    fn check(
        &self,
        options: &PlanOptions,
        kind: OperationKind,
        path: usize,
        places: impl Iterator<Item = (Vector3<f64>, Vector3<f64>)>,
    ) -> Result<(), MillingError> {
        let cutter = options.cutter_of(kind);
        for (block, ((tip, axis), points)) in places.zip(&self.columns).enumerate() {
            let value = nearest(cutter, &tip, &axis, points);
            if value < -DOWN_TO {
                let clearance = Clearance { value, lower_bound: value, place: [f64::NAN; 2] };
                let collision =
                    Box::new(Collision { block, share: 0.0, name: NAME, clearance, wanted: -DOWN_TO });
                return Err(MillingError::Collides { kind, path, collision });
            }
        }
        Ok(())
    }
}
