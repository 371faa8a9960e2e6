//! Workpiece, cutter and paths: drawings of the space with its flanks as nets, the paths of all operations, the cutter at three places
//! of a row; and what is milled.

use super::cutter_words::cutter_words;
use super::outline::silhouettes;
use crate::workflow::{MillingBodies, MillingOutcome, MillingResult};
use crate::{CutterPlace, FlankPlan, MillingPlan, OperationKind};
use foundation::numerics::equidistant;
use nalgebra::Vector3;
use report::charts::{ChartError, Drawing, DrawingLayer, DrawingLook, drawing};
use report::{Block, Figure, Quantity, Table};

/// Lines of a flank's net: over the height, along the tooth; and points of each line.
const ACROSS: usize = 7;
const ALONG: usize = 13;
const FINE: usize = 25;

/// A projection.
struct View {
    id: &'static str,
    title: &'static str,
    subtitle: String,
    axes: Option<[String; 2]>,
    right: Vector3<f64>,
    up: Vector3<f64>,
}

impl View {
    fn of(&self, point: &Vector3<f64>) -> [f64; 2] {
        [point.dot(&self.right), point.dot(&self.up)]
    }

    /// Towards the viewer.
    fn towards(&self) -> Vector3<f64> {
        self.right.cross(&self.up)
    }
}

/// The drawings and the bodies.
pub(super) fn blocks(outcome: &MillingOutcome) -> Result<Vec<Block>, ChartError> {
    let (bodies, plan) = (&outcome.prepared.bodies, &outcome.plan);
    let mut blocks = Vec::new();
    for view in views(plan) {
        let svg = drawing(&draw(&view, bodies, plan))?;
        blocks.push(Block::Figure(Figure::new(view.id, svg, "")));
    }
    blocks.push(Block::Table(Table::of_quantities("", &quantities(&outcome.result))));
    Ok(blocks)
}

fn quantities(result: &MillingResult) -> Vec<Quantity> {
    let [spaces, milled] = result.spaces.map(|count| count as i64);
    let mut list = vec![
        Quantity::count("tooth spaces", "z", spaces),
        Quantity::count("tooth spaces milled", "", milled),
        Quantity::text("cutter of the flanks", cutter_words(&result.cutter)),
        Quantity::number("its cutting length", "l_c", result.cutter.cutting_length, "mm"),
    ];
    for (name, flank) in &result.flanks {
        list.push(Quantity::count(&format!("rows, {name} flank"), "", flank.rows.len() as i64));
    }
    list
}

/// The space from the front, from the side and obliquely.
fn views(plan: &MillingPlan) -> [View; 3] {
    // The space opens away from the base body.
    let opening = plan.flanks.first().and_then(|flank| {
        let columns = &flank.lines.path.columns;
        columns.get(columns.len() / 2).map(|column| column.lead.base_normal)
    });
    let opening = opening.unwrap_or_else(Vector3::y);
    let sense = if opening.y < 0.0 { -1.0 } else { 1.0 };
    let (x, y, z) = (Vector3::x(), Vector3::y(), Vector3::z());
    let towards = Vector3::new(0.35, 0.72 * sense, -0.6).normalize();
    let right = (y * sense).cross(&towards).normalize();
    [
        View {
            id: "the-space-along-the-axis",
            title: "The space along the axis",
            subtitle: "seen against +z; one space, dots where paths begin".into(),
            axes: Some(["x [mm]".into(), "y [mm]".into()]),
            right: x,
            up: y,
        },
        View {
            id: "the-space-from-the-side",
            title: "The space from the side",
            subtitle: "seen along +x; one space, dots where paths begin".into(),
            axes: Some(["z [mm]".into(), "y [mm]".into()]),
            right: z,
            up: y,
        },
        View {
            id: "the-space-oblique-view",
            title: "The space, oblique view",
            subtitle: "one space, dots where paths begin".into(),
            axes: None,
            right,
            up: towards.cross(&right),
        },
    ]
}

fn draw(view: &View, bodies: &MillingBodies, plan: &MillingPlan) -> Drawing {
    let mut layers = vec![DrawingLayer {
        name: "cutter at three places of a row".into(),
        look: DrawingLook::Body,
        lines_mm: cutters(view, bodies, plan),
    }];
    let [seen, hidden] = nets(view, bodies);
    layers.push(DrawingLayer {
        name: "flank from behind".into(),
        look: DrawingLook::HiddenNet,
        lines_mm: hidden,
    });
    layers.push(DrawingLayer { name: "flank".into(), look: DrawingLook::Net, lines_mm: seen });
    for (kind, operation) in plan.operations.iter().enumerate() {
        let of_place = |place: &CutterPlace| view.of(&place.contact.unwrap_or(place.tip));
        let lines = operation.paths.iter().map(|path| path.places.iter().map(of_place).collect());
        let what = if matches!(operation.kind, OperationKind::Flank(_) | OperationKind::Fillet(_)) {
            "contact"
        } else {
            "tip"
        };
        layers.push(DrawingLayer {
            name: format!("{} ({what})", operation.kind),
            look: DrawingLook::Path(kind),
            lines_mm: lines.collect(),
        });
    }
    Drawing {
        title: view.title.into(),
        subtitle: view.subtitle.clone(),
        axes: view.axes.clone(),
        layers,
        notes: Vec::new(),
    }
}

/// The cutter at both ends and in the middle of the middle row of the first flank.
fn cutters(view: &View, bodies: &MillingBodies, plan: &MillingPlan) -> Vec<Vec<[f64; 2]>> {
    let Some(flank) = plan.flanks.first() else { return Vec::new() };
    let cutter = bodies.options.cutter_of(OperationKind::Flank(flank.side));
    places(flank).iter().flat_map(|place| silhouettes(cutter, place, &|point| view.of(point))).collect()
}

fn places(flank: &FlankPlan) -> Vec<CutterPlace> {
    let Some(row) = flank.rows.get(flank.rows.len() / 2) else { return Vec::new() };
    let (first, count) = (flank.lines.first, flank.lines.dense.grid.columns.len());
    [first, first + count / 2, first + count.max(1) - 1]
        .into_iter()
        .filter_map(|column| row.locations.get(column))
        .map(|location| CutterPlace { tip: location.tip, axis: location.axis, contact: None })
        .collect()
}

/// Lines on the flanks where they face the viewer, and where they are seen from behind.
fn nets(view: &View, bodies: &MillingBodies) -> [Vec<Vec<[f64; 2]>>; 2] {
    let mut lines = [Vec::new(), Vec::new()];
    for flank in bodies.flanks() {
        let active = &flank.active;
        let (heights, face) = (active.height_span(), active.face);
        let mut add = |places: Vec<[f64; 2]>| {
            let points: Vec<([f64; 2], bool)> = places
                .into_iter()
                .map(|[a, b]| active.surface.jet(a, b))
                .filter(|jet| jet.point.iter().all(|x| x.is_finite()))
                .map(|jet| (view.of(&jet.point), jet.normal.dot(&view.towards()) >= 0.0))
                .collect();
            // Each stretch of one kind, with the first point of the next one so that no gap is left.
            let mut from = 0;
            while from < points.len() {
                let kind = points[from].1;
                let to = points[from..].iter().position(|p| p.1 != kind).map_or(points.len(), |k| from + k);
                let end = (to + 1).min(points.len());
                lines[usize::from(!kind)].push(points[from..end].iter().map(|p| p.0).collect());
                from = to;
            }
        };
        for a in equidistant(heights, ACROSS) {
            add(equidistant(face, FINE).into_iter().map(|b| [a, b]).collect());
        }
        for b in equidistant(face, ALONG) {
            add(equidistant(heights, FINE).into_iter().map(|a| [a, b]).collect());
        }
    }
    lines
}
