//! A skiving tool as a closed mesh: its edges where they touch the finished flank, the rake face between them, the clearance faces a
//! little way behind. Knows no beam and no pose.

use crate::{SkivingError, VirtualEdge};
use foundation::geometry::{Flank, Sides, SkivingTool};
use foundation::numerics::equidistant;
use nalgebra::{Rotation3, Vector3};
use scene::mesh::{MeshError, Section, TriangleMesh, swept};
use scene::toothed::circle;
use std::f64::consts::TAU;

/// Points of an edge, of a tip and of a root between two teeth.
const EDGE: usize = 17;
const TIP: usize = 4;
const ROOT: usize = 6;
/// The root is drawn this far below the edges, in modules of the pitch circle.
const DEPTH: f64 = 0.4;
/// The tool is drawn so thick, in modules: behind that, clearance faces of slender teeth may run together.
const THICKNESS: [f64; 4] = [1.5, 0.75, 0.375, 0.2];
/// Bore as a share of the root radius.
const BORE: f64 = 0.4;
const BORE_CORNERS: usize = 60;

/// A point of the tool's face, and which way its line on the clearance face goes: per mm against z.
#[derive(Clone, Copy)]
struct FacePoint {
    point: Vector3<f64>,
    back: Vector3<f64>,
}

/// The ideal tool in its own coordinates.
///
/// # Errors
/// Edges without contact, and a mesh that cannot be made.
pub(super) fn skiving_tool(
    tool: &SkivingTool,
    edges: &Sides<VirtualEdge>,
) -> Result<Result<TriangleMesh, MeshError>, SkivingError> {
    let [high, low] = sides(edges)?;
    let module = TAU * tool.pitch_radius() / f64::from(tool.teeth()) / std::f64::consts::PI;
    let least = high.iter().chain(&low).map(|p| p.point.xy().norm()).fold(f64::INFINITY, f64::min);
    let root = least - DEPTH * module;
    let tooth = tooth(tool, [&high, &low], root);
    let teeth = tool.teeth();
    let pitch = TAU / f64::from(teeth);
    // Teeth follow each other as the points of one do: their angles from +y towards +x fall, that about z rises.
    let around = (0..teeth).flat_map(|k| {
        let turn = Rotation3::from_axis_angle(&Vector3::z_axis(), pitch * f64::from(k));
        tooth
            .iter()
            .map(move |p| FacePoint { point: turn * p.point, back: turn * p.back })
            .collect::<Vec<_>>()
    });
    let face: Vec<FacePoint> = around.collect();
    let of_root = |p: &&FacePoint| p.point.xy().norm() < root + 1e-9;
    let (sum, count) = face.iter().filter(of_root).fold((0.0, 0.0), |(z, n), p| (z + p.point.z, n + 1.0));
    let section = |depth: f64| Section {
        outline: face.iter().map(|p| p.point + p.back * depth).collect(),
        holes: vec![circle(BORE * root, sum / count - depth, BORE_CORNERS)],
    };
    let of = |thickness: f64| swept(&[section(thickness * module), section(0.0)]);
    let mut made = of(THICKNESS[0]);
    for thickness in &THICKNESS[1..] {
        if made.is_ok() {
            break;
        }
        made = of(*thickness);
    }
    Ok(made)
}

/// Both edges of tooth 0 from root to tip; first the one at the greater angle from +y towards +x.
fn sides(edges: &Sides<VirtualEdge>) -> Result<[Vec<FacePoint>; 2], SkivingError> {
    let of = |flank: Flank| -> Result<Vec<FacePoint>, SkivingError> {
        let edge = &edges[flank];
        let mut points = Vec::with_capacity(EDGE);
        for x in equidistant([-1.0, 1.0], EDGE) {
            let w = edge.flank().length_of_roll(x);
            let ruling = edge.section(w).ruling;
            points.push(FacePoint { point: edge.contact(w)?.point, back: ruling / -ruling.z });
        }
        if points[0].point.xy().norm() > points[EDGE - 1].point.xy().norm() {
            points.reverse();
        }
        Ok(points)
    };
    let (left, right) = (of(Flank::Left)?, of(Flank::Right)?);
    let angle = |points: &[FacePoint]| polar(&points[EDGE / 2].point);
    Ok(if angle(&left) > angle(&right) { [left, right] } else { [right, left] })
}

/// Tooth 0 with the root behind it, up to the next one.
fn tooth(tool: &SkivingTool, [high, low]: [&[FacePoint]; 2], root: f64) -> Vec<FacePoint> {
    let pitch = TAU / f64::from(tool.teeth());
    let clearance = tool.rounding().clearance_angle.tan();
    let at = |radius: f64, angle: f64, number: f64, lean: f64| {
        let own = Rotation3::from_axis_angle(&Vector3::z_axis(), -pitch * number);
        let point = on_rake(tool, &(own * Vector3::new(radius * angle.sin(), radius * angle.cos(), 0.0)));
        let point = own.inverse() * point;
        let helix = Vector3::new(tool.twist() * point.y, -tool.twist() * point.x, -1.0);
        let radial = Vector3::new(point.x, point.y, 0.0).normalize();
        FacePoint { point, back: helix - radial * lean }
    };
    let (first, last) = (&high[0].point, &low[0].point);
    let (high_tip, low_tip) = (&high[EDGE - 1].point, &low[EDGE - 1].point);
    let mut points = vec![at(root, polar(first), 0.0, 0.0)];
    points.extend(high);
    let radii = [high_tip.xy().norm(), low_tip.xy().norm()];
    let angles = [polar(high_tip), polar(low_tip)];
    points.extend((1..=TIP).map(|k| {
        let share = k as f64 / (TIP + 1) as f64;
        let between = |[from, to]: [f64; 2]| from + share * (to - from);
        at(between(radii), between(angles), 0.0, clearance)
    }));
    points.extend(low.iter().rev());
    let (from, to) = (polar(last), polar(first) - pitch);
    points.push(at(root, from, 0.0, 0.0));
    points.extend((1..=ROOT).map(|k| {
        // Behind the middle of the root the next tooth's rake face begins.
        let number = if 2 * k > ROOT { 1.0 } else { 0.0 };
        at(root, from + (to - from) * k as f64 / (ROOT + 1) as f64, number, 0.0)
    }));
    points
}

/// Angle from +y towards +x.
fn polar(point: &Vector3<f64>) -> f64 {
    point.x.atan2(point.y)
}

/// The point of tooth 0's rake face above or below a place.
fn on_rake(tool: &SkivingTool, place: &Vector3<f64>) -> Vector3<f64> {
    let mut point = *place;
    for _ in 0..20 {
        point.z -= tool.rake().distance(&point) / tool.rake().normal(&point).z;
    }
    point
}
