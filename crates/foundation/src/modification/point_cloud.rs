//! A modification given at scattered points: linear on triangles, or a smooth surface fitted to them.

use spade::handles::{DirectedEdgeHandle, FaceHandle, InnerTag};
use spade::{
    DelaunayTriangulation, HasPosition, HierarchyHintGenerator, Point2, PositionInTriangulation,
    Triangulation,
};

use super::error::EvaluationError;
use super::smoothness::Smoothness;
use crate::numerics::{Jet2, TensorSpline};

/// How far outside its hull a cloud still answers, mm: files round coordinates, so the corner of the field may
/// lie a few nanometres outside a cloud that was meant to reach it.
const HULL_TOLERANCE: f64 = 1e-6;

/// A cloud thinner than this share of its length counts as a line.
const THINNEST: f64 = 1e-9;

/// One point of the cloud, mm.
#[derive(Clone, Copy, Debug)]
struct CloudPoint {
    w: f64,
    z: f64,
    f: f64,
}

impl HasPosition for CloudPoint {
    type Scalar = f64;
    fn position(&self) -> Point2<f64> {
        Point2::new(self.w, self.z)
    }
}

type Triangles = DelaunayTriangulation<CloudPoint, (), (), (), HierarchyHintGenerator<f64>>;
type Edge<'a> = DirectedEdgeHandle<'a, CloudPoint, (), (), ()>;
type Triangle<'a> = FaceHandle<'a, InnerTag, CloudPoint, (), (), ()>;

/// Distinct points, triangulated; answers inside their convex hull only.
#[derive(Clone, Debug)]
pub(super) struct PointCloud {
    triangles: Triangles,
    /// [[w_min, w_max], [z_min, z_max]], widened by the tolerance: avoids the search for far points.
    bounds: [[f64; 2]; 2],
    /// The fitted surface of method "spline".
    surface: Option<TensorSpline>,
}

impl PointCloud {
    /// `None` if the points (finite, pairwise distinct, mm) lie on one line.
    pub(super) fn new(points: &[[f64; 3]], surface: Option<TensorSpline>) -> Option<Self> {
        let vertices = points.iter().map(|&[w, z, f]| CloudPoint { w, z, f }).collect();
        let triangles = Triangles::bulk_load(vertices).ok()?;
        let range = |axis: usize| {
            let low = points.iter().map(|p| p[axis]).fold(f64::INFINITY, f64::min);
            let high = points.iter().map(|p| p[axis]).fold(f64::NEG_INFINITY, f64::max);
            [low - HULL_TOLERANCE, high + HULL_TOLERANCE]
        };
        let bounds = [range(0), range(1)];
        let size = (bounds[0][1] - bounds[0][0]).hypot(bounds[1][1] - bounds[1][0]);
        let area: f64 = triangles.inner_faces().map(|face| face.area()).sum();
        (area > THINNEST * size * size).then_some(Self { triangles, bounds, surface })
    }

    pub(super) fn smoothness(&self) -> Smoothness {
        if self.surface.is_some() { Smoothness::C2 } else { Smoothness::C0 }
    }

    pub(super) fn jet(&self, w: f64, z: f64) -> Result<Jet2, EvaluationError> {
        let outside = EvaluationError::OutsidePointCloud { w, z };
        let inside = |x: f64, [low, high]: [f64; 2]| low <= x && x <= high;
        if !inside(w, self.bounds[0]) || !inside(z, self.bounds[1]) {
            return Err(outside);
        }
        let plane = match self.triangles.locate(Point2::new(w, z)) {
            PositionInTriangulation::OnFace(face) => {
                let triangle = self.triangles.face(face);
                let [f, fu, fv] = plane(triangle, w, z);
                Jet2 { f, fu, fv, ..Jet2::default() }
            }
            PositionInTriangulation::OnEdge(edge) => on_edge(self.triangles.directed_edge(edge), w, z),
            PositionInTriangulation::OnVertex(vertex) => {
                let vertex = self.triangles.vertex(vertex);
                let faces = vertex.out_edges().filter_map(|edge| edge.face().as_inner());
                mean_of_planes(vertex.data().f, faces)
            }
            PositionInTriangulation::OutsideOfConvexHull(_) | PositionInTriangulation::NoTriangulation => {
                let (distance, edge) = self
                    .triangles
                    .convex_hull()
                    .map(|edge| (edge.distance_2(Point2::new(w, z)), edge))
                    .min_by(|a, b| a.0.total_cmp(&b.0))
                    .ok_or(outside)?;
                if distance > HULL_TOLERANCE * HULL_TOLERANCE {
                    return Err(outside);
                }
                on_edge(edge, w, z)
            }
        };
        Ok(self.surface.as_ref().map_or(plane, |surface| surface.jet(w, z)))
    }
}

/// Value at the foot of (w, z) on an edge, slope = mean of the triangles on both sides.
fn on_edge(edge: Edge<'_>, w: f64, z: f64) -> Jet2 {
    let [a, b] = edge.vertices().map(|vertex| *vertex.data());
    let (dw, dz) = (b.w - a.w, b.z - a.z);
    let t = (((w - a.w) * dw + (z - a.z) * dz) / (dw * dw + dz * dz)).clamp(0.0, 1.0);
    let faces = [edge, edge.rev()].into_iter().filter_map(|side| side.face().as_inner());
    mean_of_planes(a.f + t * (b.f - a.f), faces)
}

fn mean_of_planes<'a>(f: f64, faces: impl Iterator<Item = Triangle<'a>>) -> Jet2 {
    let (mut count, mut fu, mut fv) = (0.0, 0.0, 0.0);
    for face in faces {
        let [_, a, b] = plane(face, 0.0, 0.0);
        (count, fu, fv) = (count + 1.0, fu + a, fv + b);
    }
    let count = f64::max(count, 1.0);
    Jet2 { f, fu: fu / count, fv: fv / count, ..Jet2::default() }
}

/// The plane through a triangle at (w, z): value and slopes.
fn plane(triangle: Triangle<'_>, w: f64, z: f64) -> [f64; 3] {
    let [a, b, c] = triangle.vertices().map(|vertex| *vertex.data());
    let (b_w, b_z, b_f) = (b.w - a.w, b.z - a.z, b.f - a.f);
    let (c_w, c_z, c_f) = (c.w - a.w, c.z - a.z, c.f - a.f);
    let area = b_w * c_z - c_w * b_z;
    let fu = (b_f * c_z - c_f * b_z) / area;
    let fv = (c_f * b_w - b_f * c_w) / area;
    [a.f + fu * (w - a.w) + fv * (z - a.z), fu, fv]
}
