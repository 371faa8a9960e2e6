//! The scene of five-axis milling: the part stands still, the cutters come to one of its spaces, operation by operation. Knows no file.

mod mill;

use crate::workflow::MillingOutcome;
use crate::workflow::part_mesh::{AROUND, Fineness, part_with};
use crate::workflow::prepare::WorkpieceKind;
use crate::workflow::scene::mill::mill;
use crate::{CutterPlace, MilledSide, MillingPlan, Operation, OperationKind};
use foundation::geometry::Cutter;
use foundation::kinematics::{Pose, Room};
use nalgebra::{Rotation3, Vector3};
use run::{RunFailure, finished, unmeshed};
use scene::{Body, BodyKind, Coordinate, Frame, Scene, Stage, numbers, place};
use std::collections::HashSet;

/// Points of a flank: from root to tip, and along the teeth at most and at least.
const HEIGHT: usize = 12;
const LENGTH: [usize; 2] = [5, 17];
/// Triangles of all teeth at most, where the least points allow it.
const MOST_TRIANGLES: usize = 56_000;
/// Frames of an operation at most.
const FRAMES: usize = 201;
/// A cutter that waits is drawn back along its axis by this many lengths of the tool.
const WAITING: f64 = 3.0;

/// A cutter as a body.
struct ShownCutter<'a> {
    cutter: &'a Cutter,
    id: &'static str,
    /// Where it waits.
    waiting: [f64; 12],
}

/// The part with the cutters of a run, and a stage for every operation in one space.
///
/// # Errors
/// [`RunFailure`] for bodies that cannot be meshed and motions without numbers.
pub fn scene_of_milling(outcome: &MillingOutcome) -> Result<Scene, RunFailure> {
    let milled = &outcome.prepared.bodies;
    // Between two sections lie the teeth and bore or rim, between two halves a gap of three such strips.
    let strip = milled.spaces * 4 * (HEIGHT + 1) + 2 * AROUND;
    let parts = milled.parts.len().max(1);
    let of_teeth = (MOST_TRIANGLES / strip).saturating_sub(3 * (parts - 1));
    let length = (of_teeth / parts + 1).clamp(LENGTH[0], LENGTH[1]);
    let fineness = Fineness { height: HEIGHT, length };
    let part = part_with(milled, fineness).map_err(|e| unmeshed("part", &e))?;
    let (id, kind) = match milled.kind {
        WorkpieceKind::Bladed => ("part", BodyKind::Part),
        WorkpieceKind::Cylindrical | WorkpieceKind::Bevel | WorkpieceKind::Gridded => {
            ("gear", BodyKind::Gear)
        }
    };
    let part = Body::new(id, kind, part.check_watertight().is_ok(), &part);
    let mut bodies = vec![part];
    let mut cutters: Vec<ShownCutter<'_>> = Vec::new();
    for operation in &outcome.plan.operations {
        let cutter = milled.options.cutter_of(operation.kind);
        let Some(first) = operation.paths.iter().flat_map(|path| &path.places).next() else { continue };
        if cutters.iter().any(|shown| shown.cutter == cutter) {
            continue;
        }
        let id = match operation.kind {
            _ if *cutter == milled.options.cutter => "cutter",
            OperationKind::Roughing => "cutter-roughing",
            OperationKind::Bottom => "cutter-bottom",
            OperationKind::Flank(_) | OperationKind::Fillet(_) => "cutter",
        };
        let back = first.axis * (WAITING * cutter.length());
        cutters.push(ShownCutter {
            cutter,
            id,
            waiting: numbers(&stand(&CutterPlace { tip: first.tip + back, ..*first })),
        });
        let mesh = mill(cutter).map_err(|e| unmeshed("cutter", &e))?;
        bodies.push(Body::new(id, BodyKind::Cutter, true, &mesh));
    }
    let stages = outcome
        .plan
        .operations
        .iter()
        .enumerate()
        .filter_map(|(number, operation)| {
            let own = milled.options.cutter_of(operation.kind);
            stage(number, operation, own, &cutters, &outcome.plan)
        })
        .collect();
    finished(Scene { bodies, stages })
}

/// The stage of an operation; nothing for one without a path.
fn stage(
    number: usize,
    operation: &Operation,
    own: &Cutter,
    cutters: &[ShownCutter<'_>],
    plan: &MillingPlan,
) -> Option<Stage> {
    let shown = cutters.iter().find(|shown| shown.cutter == own)?;
    let touched = match operation.kind {
        OperationKind::Flank(side) => points_of_face(plan, side),
        // A fillet touches along its whole arc, a roughing pass wherever there is stock.
        OperationKind::Roughing | OperationKind::Fillet(_) | OperationKind::Bottom => HashSet::new(),
    };
    let mut places: Vec<(f64, &CutterPlace)> = Vec::new();
    let mut travelled = 0.0;
    for path in &operation.paths {
        for (k, place) in path.places.iter().enumerate() {
            if k > 0 {
                travelled += (place.tip - path.places[k - 1].tip).norm();
            }
            places.push((travelled, place));
        }
    }
    let last = places.len().checked_sub(1)?;
    let frames = places.len().min(FRAMES);
    let chosen = (0..frames).map(|k| places[k * last / (frames - 1).max(1)]);
    let frame = |(at, cutter): (f64, &CutterPlace)| {
        let mut frame = Frame::new(at, [(shown.id, numbers(&stand(cutter)))]);
        for other in cutters.iter().filter(|other| other.id != shown.id) {
            frame.poses.insert(other.id.to_owned(), other.waiting);
        }
        let contact = cutter.contact.filter(|point| touched.contains(&bits(point)));
        frame.contact = contact.iter().map(place).collect();
        frame
    };
    let title = match operation.kind {
        OperationKind::Roughing => "Clearing the space".to_owned(),
        OperationKind::Flank(side) => format!("Rows of the {side} flank"),
        OperationKind::Fillet(side) => format!("Fillet below the {side} flank"),
        OperationKind::Bottom => "Bottom of the space".to_owned(),
    };
    Some(Stage {
        id: format!("operation-{}", number + 1),
        title,
        coordinate: Coordinate { label: "way of the tip", unit: "mm" },
        frames: chosen.map(frame).collect(),
    })
}

/// The points of a flank's grid that lie within its face: rows go on beyond it, and arcs of approach carry a point that will touch.
fn points_of_face(plan: &MillingPlan, side: MilledSide) -> HashSet<[u64; 3]> {
    let of_side = plan.flanks.iter().filter(|flank| flank.side == side);
    of_side
        .flat_map(|flank| {
            let places = flank.lines.path.columns.iter().flat_map(|column| &column.places);
            places.filter(|place| !place.is_virtual).map(|place| bits(&place.jet.point))
        })
        .collect()
}

fn bits(point: &Vector3<f64>) -> [u64; 3] {
    [point.x, point.y, point.z].map(f64::to_bits)
}

/// Marks the frame of a mill: z from the tip towards the shank.
struct Mill;

/// The cutter at a place, its own z turned into the axis on the shortest way.
fn stand(place: &CutterPlace) -> Pose<Room, Mill> {
    let turn = Rotation3::rotation_between(&Vector3::z(), &place.axis)
        .unwrap_or_else(|| Rotation3::from_axis_angle(&Vector3::x_axis(), std::f64::consts::PI));
    Pose::rigid(*turn.matrix(), place.tip)
}
