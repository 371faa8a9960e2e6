//! The rotary motion of a row beside that of other systems (`docs/mathematics/milling.md#positions-of-five-axes`): the axis in the column
//! planes, along the parameter lines of the flank, and along lines that an irregular patch has sheared; on the job's own flank and machine.

use super::orientation_result::{OrientationFigures, OrientationResult};
use super::prepare::{MillingBodies, PreparedMilling, WorkpieceKind};
use super::programs::clamping;
use crate::job::MillingMount;
use crate::{
    AxisChoice, FlankPlan, MilledSide, MillingError, MillingPlan, OrientedPlace, OrientedRow, RowCutter,
};
use foundation::kinematics::{Direction, Point};
use job::{Diagnostic, Problem};
use machine::five_axis::{Chain, Places, chain};
use machine::{Machine, Positions};
use motion::MotionError;
use motion::milling::{
    CutterPlace, MillingSetup, PoleStrategy, RowSmoothness, choose, contact_arcs, smoothness_along,
};
use run::RunFailure;

/// Rotary axes along a row.
pub struct RotaryCourse {
    /// How smoothly they run.
    pub figures: RowSmoothness,
    /// The axes at all places.
    pub nodes: Vec<Positions>,
    /// Way of the contact up to each place, mm.
    pub arc: Vec<f64>,
}

/// The axes of a machine along a row, the feed along the flank's own lines.
///
/// # Errors
/// [`MotionError`] for a place that the machine does not reach.
pub fn rotary_course(setup: &MillingSetup<'_>, row: &[OrientedPlace]) -> Result<RotaryCourse, MotionError> {
    let place = |at: &OrientedPlace| CutterPlace {
        contact: Point::from_vector(at.jet.point),
        tip: Point::from_vector(at.location.tip),
        axis: Direction::from_vector(at.location.axis),
    };
    let places: Vec<CutterPlace> = row.iter().map(place).collect();
    let feeds: Vec<_> = row.iter().map(|at| at.jet.by_length.normalize()).collect();
    let course = choose(setup, &places, &Positions::default(), PoleStrategy::Slow)?;
    let figures = smoothness_along(setup, &course.places, &course.nodes, &feeds);
    let mut arc = vec![0.0];
    for step in contact_arcs(&places) {
        arc.push(arc[arc.len() - 1] + step);
    }
    Ok(RotaryCourse { figures, nodes: course.nodes, arc })
}

/// Angles of the rotary axes over the way of the contact: a line of the report.
#[derive(Clone, Debug, PartialEq)]
pub struct OrientationCurve {
    /// Key of the orientation in the result.
    pub name: &'static str,
    /// Way of the contact, mm.
    pub arc_mm: Vec<f64>,
    /// Angles of both axes, deg.
    pub angles_deg: [Vec<f64>; 2],
}

/// The comparison on one flank.
#[derive(Clone, Debug, PartialEq)]
pub struct ComparedOrientations {
    /// Which flank.
    pub side: MilledSide,
    /// For the result.
    pub result: OrientationResult,
    /// Curves of those that the machine reaches.
    pub curves: Vec<OrientationCurve>,
}

/// eps of the sheared lines: share of the face.
pub(super) const SHEAR: f64 = 0.02;
/// Places of a row.
const POINTS: usize = 121;

/// The comparison on every flank of a plan, in its order, on the machine of the job, else on a table A-C; empty where the job does not want
/// it.
///
/// # Errors
/// [`RunFailure`] for a machine that is none or has no five axes. What a row of the comparison does not reach is reported in the result.
pub(super) fn orientations(
    prepared: &PreparedMilling,
    plan: &MillingPlan,
) -> Result<Vec<ComparedOrientations>, RunFailure> {
    if !prepared.compare_orientation {
        return Ok(Vec::new());
    }
    let bodies = &prepared.bodies;
    let table;
    let (machine, mount, tool_length) = match (&prepared.mounting, &prepared.machine) {
        (Some(mounting), Some(machine)) => {
            (&machine.machine, mounting.mount, prepared.technology.finishing.length)
        }
        _ => {
            table = chain(Chain::AcTable, &Places::default()).map_err(|error| {
                let finding = Diagnostic::new(Problem::InvalidMachine, error.to_string());
                RunFailure::bad_input(finding.field("simulation.compare_orientation"))
            })?;
            // Bevel gears point their shank side down as they are described (`docs/mathematics/milling.md`).
            let turned_over = matches!(bodies.kind, WorkpieceKind::Bevel | WorkpieceKind::Gridded);
            (&table, MillingMount { turned_over, ..MillingMount::default() }, 0.0)
        }
    };
    let setup = MillingSetup::new(machine, clamping(&mount), tool_length).map_err(|error| refused(&error))?;
    Ok(plan.flanks.iter().filter_map(|flank| compare(machine, &setup, bodies, flank)).collect())
}

fn refused(error: &MotionError) -> RunFailure {
    super::programs::of_motion(error, "comparison of orientations")
}

fn compare(
    machine: &Machine,
    setup: &MillingSetup<'_>,
    bodies: &MillingBodies,
    plan: &FlankPlan,
) -> Option<ComparedOrientations> {
    let active = &plan.active;
    let middle = plan.rows.get(plan.rows.len() / 2)?;
    let cutter = RowCutter {
        cutter: &bodies.options.cutter,
        contact_height: middle.contact_height,
        orientation: middle.orientation,
    };
    let [root, tip] = active.height_span();
    let height = 0.5 * (root + tip);
    let mut curves = Vec::new();
    let mut figures = |name: &'static str, places: Result<Vec<OrientedPlace>, MillingError>| {
        let course = places
            .map_err(|error| error.to_string())
            .and_then(|places| rotary_course(setup, &places).map_err(|error| error.to_string()));
        match course {
            Ok(course) => {
                curves.push(curve(setup, name, &course));
                OrientationFigures::new(&course.figures)
            }
            Err(reason) => OrientationFigures::not_reached(reason),
        }
    };
    let row = OrientedRow::new(active, &*plan.lead, cutter, height, POINTS);
    let with = |choice: &dyn Fn(&OrientedRow<'_>) -> Result<Vec<OrientedPlace>, MillingError>| {
        row.as_ref().map_err(Clone::clone).and_then(choice)
    };
    let column = figures("column", with(&|row| Ok(row.in_columns().to_vec())));
    let iso = figures("iso", with(&|row| row.with(AxisChoice::ParameterLines)));
    let sheared = figures("sheared", with(&|row| row.with(row.sheared(SHEAR))));
    let result = OrientationResult {
        machine: machine.name().to_owned(),
        axes: setup.axes().rotary.map(|axis| machine.axes()[axis].name.clone()),
        height,
        shear: SHEAR,
        column,
        iso,
        sheared,
    };
    Some(ComparedOrientations { side: plan.side, result, curves })
}

fn curve(setup: &MillingSetup<'_>, name: &'static str, course: &RotaryCourse) -> OrientationCurve {
    let degrees = |axis: usize| course.nodes.iter().map(|at| at[axis].to_degrees()).collect();
    OrientationCurve { name, arc_mm: course.arc.clone(), angles_deg: setup.axes().rotary.map(degrees) }
}
