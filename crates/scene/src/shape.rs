//! What a scene is: bodies as triangles, stages as frames of poses. Knows no gear and no process.

use crate::mesh::TriangleMesh;
use foundation::kinematics::Pose;
use nalgebra::Vector3;
use schemars::JsonSchema;
use serde::Serialize;
use std::collections::BTreeMap;

/// Bodies and how they move. Lengths in mm; coordinates of the scene are those of the room in which the process is described.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Scene {
    /// The bodies, each in its own coordinates.
    pub bodies: Vec<Body>,
    /// What happens, one stage after the other.
    pub stages: Vec<Stage>,
}

/// A body as triangles.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Body {
    /// Its name in poses.
    pub id: String,
    /// What it is.
    pub kind: BodyKind,
    /// Whether the triangles close it: every edge has one on each side. An open body is to be drawn from both sides.
    pub closed: bool,
    /// x, y, z of every vertex, mm.
    pub positions: Vec<f32>,
    /// Three vertices of every triangle, from 0, counterclockwise seen from outside.
    pub indices: Vec<u32>,
}

/// What a body is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum BodyKind {
    /// The gear that is made.
    Gear,
    /// Another workpiece: blades.
    Part,
    /// The worm, or another tool of its shape.
    Worm,
    /// The dresser of the worm.
    Dresser,
    /// A mill.
    Cutter,
    /// A skiving tool.
    Tool,
    /// The beam of a light barrier.
    Beam,
    /// A stylus.
    Stylus,
}

/// A motion from its first to its last frame.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Stage {
    /// A name that no other stage has.
    pub id: String,
    /// The same for people.
    pub title: String,
    /// What the frames are counted by.
    pub coordinate: Coordinate,
    /// The frames in ascending order of `at`.
    pub frames: Vec<Frame>,
}

/// A coordinate along a stage.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct Coordinate {
    /// What it is.
    pub label: &'static str,
    /// Its unit.
    pub unit: &'static str,
}

/// All bodies at one place of a stage.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Frame {
    /// Where on the coordinate of the stage.
    pub at: f64,
    /// Coordinates of a body into those of the scene, by its id: rotation row by row, then translation in mm. Bodies without an entry
    /// stand still, their coordinates being those of the scene.
    pub poses: BTreeMap<String, [f64; 12]>,
    /// Where tool and workpiece touch in this moment, in coordinates of the scene, mm: points in their order if they touch along a line.
    pub contact: Vec<[f32; 3]>,
    /// Lines on the workpiece that this place of the stage finishes, in coordinates of the scene, mm.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub trace: Vec<Vec<[f32; 3]>>,
}

impl Body {
    /// A body from its mesh.
    pub fn new(id: impl Into<String>, kind: BodyKind, closed: bool, mesh: &TriangleMesh) -> Self {
        Self {
            id: id.into(),
            kind,
            closed,
            positions: mesh.vertices.iter().flat_map(place).collect(),
            indices: mesh.triangles.iter().flatten().copied().collect(),
        }
    }
}

impl Frame {
    /// A frame without contact.
    pub fn new<const N: usize>(at: f64, poses: [(&str, [f64; 12]); N]) -> Self {
        let poses = poses.into_iter().map(|(id, pose)| (id.to_owned(), pose)).collect();
        Self { at, poses, contact: Vec::new(), trace: Vec::new() }
    }
}

/// A point as the scene has it.
pub fn place(point: &Vector3<f64>) -> [f32; 3] {
    [point.x as f32, point.y as f32, point.z as f32]
}

/// A pose as the scene has it.
pub fn numbers<To, From>(pose: &Pose<To, From>) -> [f64; 12] {
    let (r, t) = (pose.rotation(), pose.translation());
    [
        r[(0, 0)],
        r[(0, 1)],
        r[(0, 2)],
        r[(1, 0)],
        r[(1, 1)],
        r[(1, 2)],
        r[(2, 0)],
        r[(2, 1)],
        r[(2, 2)],
        t.x,
        t.y,
        t.z,
    ]
}
