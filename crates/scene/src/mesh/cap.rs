//! The end face of a swept body: triangles between an outline and its holes.

use super::error::MeshError;
use super::section::Section;
use nalgebra::{Vector2, Vector3};
use spade::handles::FixedVertexHandle;
use spade::{ConstrainedDelaunayTriangulation, HasPosition, Point2, Triangulation, mitigate_underflow};
use std::collections::VecDeque;

/// The area of the triangles agrees with that of the loops up to this share; an outline that runs round twice or a hole outside misses
/// by far more.
const AREA_TOLERANCE: f64 = 1e-6;

/// A point of a loop in the plane of the face.
#[derive(Clone, Copy, Debug)]
struct LoopPoint {
    place: Point2<f64>,
    vertex: u32,
}

impl HasPosition for LoopPoint {
    type Scalar = f64;
    fn position(&self) -> Point2<f64> {
        self.place
    }
}

type Triangles = ConstrainedDelaunayTriangulation<LoopPoint>;

/// An end face: its triangles over the vertices of a section, counted through outline and holes, counterclockwise as the outline runs;
/// and for each loop (outline first) whether it runs counterclockwise in that sense.
pub(super) struct Cap {
    pub(super) triangles: Vec<[u32; 3]>,
    pub(super) with_outline: Vec<bool>,
}

/// The end face of a section. A face that is not plane is divided as it looks along the axis closest to its normal.
pub(super) fn cap(section: &Section, number: usize) -> Result<Cap, MeshError> {
    let refused = |reason| MeshError::OutlineNotSimple { section: number, reason };
    let normal = area_vector(&section.outline);
    // Leaving one coordinate out keeps the others exact, so that points on a line stay on it.
    let axis = normal.iamax();
    let (right, up) =
        if normal[axis] >= 0.0 { ((axis + 1) % 3, (axis + 2) % 3) } else { ((axis + 2) % 3, (axis + 1) % 3) };
    let loops: Vec<Vec<Vector2<f64>>> = std::iter::once(&section.outline)
        .chain(&section.holes)
        .map(|points| points.iter().map(|p| Vector2::new(p[right], p[up])).collect())
        .collect();
    let areas: Vec<f64> = loops.iter().map(|points| plane_area(points)).collect();

    if areas[0] <= 0.0 {
        return Err(refused("the outline is flat"));
    }

    let mut points = Vec::new();
    let mut edges = Vec::new();
    for places in &loops {
        let first = points.len();
        for (i, place) in places.iter().enumerate() {
            let position = mitigate_underflow(Point2::new(place.x, place.y));
            points.push(LoopPoint { place: position, vertex: (first + i) as u32 });
            edges.push([first + i, first + (i + 1) % places.len()]);
        }
    }
    let (given, sides) = (points.len(), edges.clone());
    let mut crossing = false;
    let triangulation = Triangles::try_bulk_load_cdt(points, edges, |_| crossing = true)
        .map_err(|_| refused("its coordinates cannot be compared"))?;
    if crossing {
        return Err(refused("lines cross each other"));
    }
    // A point on a line that does not end there divides the line, and two lines that coincide become one.
    let is_side = |[from, to]: [usize; 2]| {
        let [from, to] = [from, to].map(FixedVertexHandle::from_index);
        triangulation.get_edge_from_neighbors(from, to).is_some_and(|edge| edge.is_constraint_edge())
    };
    let whole = triangulation.num_vertices() == given && triangulation.num_constraints() == sides.len();
    if !whole || !sides.into_iter().all(is_side) {
        return Err(refused("points or lines coincide"));
    }

    let triangles = inside(&triangulation);
    let covered: f64 = triangles
        .iter()
        .map(|corners| plane_area(&corners.map(|c| Vector2::new(c.place.x, c.place.y))))
        .sum();
    let bounded = areas[0] - areas[1..].iter().map(|a| a.abs()).sum::<f64>();
    if (covered - bounded).abs() > AREA_TOLERANCE * areas[0] {
        return Err(refused("a hole lies outside the outline or in another hole"));
    }
    Ok(Cap {
        triangles: triangles.iter().map(|corners| corners.map(|c| c.vertex)).collect(),
        with_outline: areas.iter().map(|&a| a > 0.0).collect(),
    })
}

/// The triangles that an odd number of lines separates from the outside.
fn inside(triangulation: &Triangles) -> Vec<[LoopPoint; 3]> {
    let mut is_inside: Vec<Option<bool>> = vec![None; triangulation.num_all_faces()];
    let outer = triangulation.outer_face().index();
    is_inside[outer] = Some(false);
    let mut waiting: VecDeque<_> = VecDeque::new();
    for edge in triangulation.convex_hull() {
        let face = edge.rev().face();
        if is_inside[face.index()].is_none() {
            is_inside[face.index()] = Some(edge.is_constraint_edge());
            waiting.extend(face.as_inner());
        }
    }
    while let Some(face) = waiting.pop_front() {
        let here = is_inside[face.index()] == Some(true);
        for edge in face.adjacent_edges() {
            let next = edge.rev().face();
            if is_inside[next.index()].is_none() {
                is_inside[next.index()] = Some(here != edge.is_constraint_edge());
                waiting.extend(next.as_inner());
            }
        }
    }
    let found = triangulation.inner_faces().filter(|face| is_inside[face.index()] == Some(true));
    found.map(|face| face.vertices().map(|vertex| *vertex.data())).collect()
}

/// Twice the area vector of a loop in space: its direction is the normal about which the loop runs counterclockwise.
fn area_vector(points: &[Vector3<f64>]) -> Vector3<f64> {
    let from = points[0];
    points.windows(2).map(|pair| (pair[0] - from).cross(&(pair[1] - from))).sum()
}

/// The area of a loop in the plane, positive if it runs counterclockwise.
fn plane_area(points: &[Vector2<f64>]) -> f64 {
    let from = points[0];
    0.5 * points.windows(2).map(|pair| (pair[0] - from).perp(&(pair[1] - from))).sum::<f64>()
}
