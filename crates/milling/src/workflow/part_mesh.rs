//! The milled part as a closed body: teeth all around, swept along their length with a bore or a rim; of blades the milled side of each.

use super::prepare::MillingBodies;
use crate::{Along, Space, SpaceFlank};
use foundation::numerics::{equidistant, extremes};
use nalgebra::{Rotation3, Vector3};
use scene::mesh::{MeshError, PatchSide, Section, TriangleMesh, patch, swept};
use std::f64::consts::TAU;

/// Points from root to tip, and sections along the teeth, of a part that is handed on.
const ALONG_HEIGHT: usize = 25;
const ALONG_LENGTH: usize = 33;
/// Corners of a bore or rim.
pub(super) const AROUND: usize = 180;
/// How much deeper than the root the gap of a double-helical gear is drawn, as a share of the depth of the teeth.
const GROOVE: f64 = 0.1;
/// What is left of the teeth on its floor, and how far its walls lean as a share of its width: points of a section that lie on one radius
/// would otherwise make faces without an area.
const PRESSED: f64 = 0.01;
const WALL: f64 = 0.01;

/// How many points stand for the teeth.
#[derive(Clone, Copy, Debug)]
pub struct Fineness {
    /// From root to tip.
    pub height: usize,
    /// Along the teeth.
    pub length: usize,
}

/// The body.
///
/// # Errors
/// [`MeshError`].
pub(super) fn part(bodies: &MillingBodies) -> Result<TriangleMesh, MeshError> {
    part_with(bodies, Fineness { height: ALONG_HEIGHT, length: ALONG_LENGTH })
}

/// The body by so many points, at least two of each. Blades are open: their milled sides alone.
///
/// # Errors
/// [`MeshError`].
pub fn part_with(bodies: &MillingBodies, fineness: Fineness) -> Result<TriangleMesh, MeshError> {
    // From -z to +z.
    let parts: Vec<Stretch<'_>> =
        bodies.parts.iter().rev().filter_map(|space| Stretch::new(bodies, space, fineness.height)).collect();
    let (Some(first), Some(last)) = (parts.first(), parts.last()) else { return blades(bodies, fineness) };
    let ends = [first.left.active.face[0], last.left.active.face[1]];
    let mut sections: Vec<Section> = Vec::new();
    for stretch in &parts {
        let mut lengths = equidistant(stretch.left.active.face, fineness.length);
        if let Some(before) = sections.last() {
            let gap = stretch.left.active.face[0] - first.left.active.face[1];
            if gap > 0.0 {
                let behind = stretch.section(lengths[0], ends);
                let wall = WALL * gap;
                let grooves = [stretch.groove(before, wall), stretch.groove(&behind, -wall)];
                sections.extend(grooves);
            } else {
                // The halves have this section in common.
                lengths.remove(0);
            }
        }
        sections.extend(lengths.into_iter().map(|length| stretch.section(length, ends)));
    }
    swept(&sections)
}

/// The milled sides of all blades.
fn blades(bodies: &MillingBodies, fineness: Fineness) -> Result<TriangleMesh, MeshError> {
    let Some(flank) = bodies.flanks().next() else { return TriangleMesh::joined(&[]) };
    let lengths = equidistant(flank.active.face, fineness.length);
    let heights = equidistant(flank.active.height_span(), fineness.height);
    let side = |k: usize| {
        let points: Vec<Vector3<f64>> = heights
            .iter()
            .flat_map(|&a| lengths.iter().map(move |&b| (a, b)))
            .map(|(a, b)| turn(bodies, k) * flank.active.surface.point(a, b))
            .collect();
        patch(&points, fineness.length, PatchSide::RowsTimesColumns)
    };
    let sides = (0..bodies.spaces).map(side).collect::<Result<Vec<_>, _>>()?;
    TriangleMesh::joined(&sides)
}

fn turn(bodies: &MillingBodies, space: usize) -> Rotation3<f64> {
    Rotation3::from_axis_angle(&Vector3::z_axis(), TAU * space as f64 / bodies.spaces as f64)
}

/// Teeth with both flanks: all, or those of one half.
struct Stretch<'a> {
    bodies: &'a MillingBodies,
    space: &'a Space,
    left: &'a SpaceFlank,
    right: &'a SpaceFlank,
    /// Points from root to tip.
    along_height: usize,
}

impl<'a> Stretch<'a> {
    fn new(bodies: &'a MillingBodies, space: &'a Space, along_height: usize) -> Option<Self> {
        let [left, right] = space.flanks.as_slice() else { return None };
        Some(Self { bodies, space, left, right, along_height })
    }

    /// The section at a length of teeth that go from one to the other of `ends`.
    fn section(&self, length: f64, [from, to]: [f64; 2]) -> Section {
        // The blank's section goes round from the tip at the first end to bore or rim there.
        let [_, _, last, first] = self.bodies.blank;
        let of = |flank: &SpaceFlank| -> Vec<Vector3<f64>> {
            let heights = equidistant(flank.active.height_span(), self.along_height);
            heights.into_iter().map(|a| flank.active.surface.point(a, length)).collect()
        };
        let (left, right) = (of(self.left), of(self.right));
        // Down one flank, along the root body, up the other one.
        let root = self.space.lead.at(length).map(|lead| lead.point);
        let foot = |point: &Vector3<f64>| match &root {
            Ok(root) => at_radius(&Vector3::new(point.x, point.y, root.z), root.xy().norm()),
            Err(_) => *point,
        };
        let mut space: Vec<Vector3<f64>> = left.iter().rev().copied().collect();
        space.extend([foot(&left[0]), foot(&right[0])]);
        space.extend(right.iter().copied());
        let spaces = self.bodies.spaces;
        let around = (0..spaces).flat_map(|k| {
            // Spaces follow each other in the sense in which the flanks of one do.
            let sense = if left[0].x > right[0].x { 1 } else { spaces - 1 };
            let turn = turn(self.bodies, k * sense % spaces);
            space.iter().map(move |point| turn * point).collect::<Vec<_>>()
        });
        let teeth: Vec<Vector3<f64>> = around.collect();
        let share = (length - from) / (to - from);
        let [radius, height] = [0, 1].map(|k| first[k] + (last[k] - first[k]) * share);
        let circle: Vec<Vector3<f64>> = (0..AROUND)
            .map(|k| {
                let (sin, cos) = (TAU * k as f64 / AROUND as f64).sin_cos();
                Vector3::new(radius * cos, radius * sin, height)
            })
            .collect();
        if self.is_internal() {
            Section { outline: circle, holes: vec![teeth] }
        } else {
            Section { outline: teeth, holes: vec![circle] }
        }
    }

    fn is_internal(&self) -> bool {
        let [[tip, _], _, _, [start, _]] = self.bodies.blank;
        start > tip
    }

    /// The floor of the gap beside a section, moved along the teeth: its teeth pressed flat.
    fn groove(&self, section: &Section, along: f64) -> Section {
        if self.left.active.kink.is_some_and(|kink| kink.along == Along::Rays) {
            return conical_groove(section, along);
        }
        let teeth = if self.is_internal() { &section.holes[0] } else { &section.outline };
        let [least, greatest] = extremes(teeth.iter().map(|point| point.xy().norm()));
        let depth = greatest - least;
        let pressed = |radius: f64| match self.is_internal() {
            true => greatest + GROOVE * depth - PRESSED * (greatest - radius),
            false => least - GROOVE * depth + PRESSED * (radius - least),
        };
        let moved = |point: &Vector3<f64>| Vector3::new(point.x, point.y, point.z + along);
        let flat = |point: &Vector3<f64>| moved(&at_radius(point, pressed(point.xy().norm())));
        let [of_teeth, of_circle] = [&flat as &dyn Fn(&Vector3<f64>) -> Vector3<f64>, &moved];
        let (outer, inner) = if self.is_internal() { (of_circle, of_teeth) } else { (of_teeth, of_circle) };
        Section {
            outline: section.outline.iter().map(outer).collect(),
            holes: section.holes.iter().map(|hole| hole.iter().map(inner).collect()).collect(),
        }
    }
}

/// The floor of the gap of a bevel gear: its teeth pressed towards the axis on their sphere about the apex.
fn conical_groove(section: &Section, along: f64) -> Section {
    let polar = |point: &Vector3<f64>| point.xy().norm().atan2(point.z);
    let [least, greatest] = extremes(section.outline.iter().map(polar));
    let depth = greatest - least;
    let moved = |point: &Vector3<f64>| point * (1.0 + along / point.norm());
    let flat = |point: &Vector3<f64>| {
        let (sin, cos) = (least - GROOVE * depth + PRESSED * (polar(point) - least)).sin_cos();
        let distance = point.norm();
        moved(&at_radius(&Vector3::new(point.x, point.y, distance * cos), distance * sin))
    };
    Section {
        outline: section.outline.iter().map(flat).collect(),
        holes: section.holes.iter().map(|hole| hole.iter().map(moved).collect()).collect(),
    }
}

/// The point moved to a radius about the axis.
fn at_radius(point: &Vector3<f64>, radius: f64) -> Vector3<f64> {
    let share = radius / point.xy().norm();
    Vector3::new(point.x * share, point.y * share, point.z)
}
