//! What holds for every scene, and distances from meshes.

use flankwright::exchange::{AnyJob, read_any_job};
use flankwright::workflow::scene::{Body, Frame, Scene};
use nalgebra::{Matrix3, Vector3};
use std::collections::{BTreeSet, HashSet};
use std::path::{Path, PathBuf};

/// Triangles that a browser turns without effort.
const MOST_TRIANGLES: usize = 62_000;

/// The jobs of a folder of examples, in order.
pub fn examples(folder: &str) -> Vec<PathBuf> {
    let directory = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples").join(folder);
    let mut found: Vec<PathBuf> = std::fs::read_dir(directory)
        .unwrap()
        .map(|entry| entry.unwrap().path())
        .filter(|path| path.extension().is_some_and(|e| e == "toml"))
        .collect();
    found.sort();
    found
}

pub fn job(path: &Path) -> AnyJob {
    read_any_job(path).unwrap_or_else(|e| panic!("{}: {e:?}", path.display()))
}

pub fn vertices(body: &Body) -> Vec<Vector3<f64>> {
    body.positions.chunks(3).map(|p| Vector3::new(p[0].into(), p[1].into(), p[2].into())).collect()
}

pub fn body<'a>(scene: &'a Scene, id: &str) -> &'a Body {
    scene.bodies.iter().find(|body| body.id == id).unwrap_or_else(|| panic!("no body `{id}`"))
}

pub fn volume(body: &Body) -> f64 {
    let at = vertices(body);
    let corner = |t: &[u32], k: usize| at[t[k] as usize];
    body.indices.chunks(3).map(|t| corner(t, 0).dot(&corner(t, 1).cross(&corner(t, 2))) / 6.0).sum()
}

/// Rotation and translation of a body in a frame.
pub fn pose(frame: &Frame, id: &str) -> (Matrix3<f64>, Vector3<f64>) {
    match frame.poses.get(id) {
        None => (Matrix3::identity(), Vector3::zeros()),
        Some(n) => (Matrix3::from_row_slice(&n[..9]), Vector3::new(n[9], n[10], n[11])),
    }
}

/// A point of the scene in coordinates of a body.
pub fn in_body(frame: &Frame, id: &str, point: &[f32; 3]) -> Vector3<f64> {
    let (rotation, translation) = pose(frame, id);
    rotation.transpose() * (Vector3::from(point.map(f64::from)) - translation)
}

/// Distance of a point from the triangles of a body.
pub fn off_mesh(body: &Body, at: &[Vector3<f64>], point: &Vector3<f64>) -> f64 {
    let of = |t: &[u32]| off_triangle([0, 1, 2].map(|k| at[t[k] as usize]), point);
    body.indices.chunks(3).map(of).fold(f64::INFINITY, f64::min)
}

fn off_triangle([a, b, c]: [Vector3<f64>; 3], p: &Vector3<f64>) -> f64 {
    let n = (b - a).cross(&(c - a));
    let inside = |u: Vector3<f64>, v: Vector3<f64>| (v - u).cross(&(p - u)).dot(&n) >= 0.0;
    if inside(a, b) && inside(b, c) && inside(c, a) {
        return (p - a).dot(&n.normalize()).abs();
    }
    let off_edge = |u: Vector3<f64>, v: Vector3<f64>| {
        let along = ((p - u).dot(&(v - u)) / (v - u).norm_squared()).clamp(0.0, 1.0);
        (p - u - (v - u) * along).norm()
    };
    off_edge(a, b).min(off_edge(b, c)).min(off_edge(c, a))
}

/// Bodies, poses and orders of any scene.
pub fn check(name: &str, scene: &Scene) {
    let ids: BTreeSet<&str> = scene.bodies.iter().map(|body| body.id.as_str()).collect();
    assert_eq!(ids.len(), scene.bodies.len(), "{name}");
    for body in &scene.bodies {
        check_body(&format!("{name}, {}", body.id), body);
    }
    let stages: BTreeSet<&str> = scene.stages.iter().map(|stage| stage.id.as_str()).collect();
    assert_eq!(stages.len(), scene.stages.len(), "{name}");
    assert!(!scene.stages.is_empty(), "{name}");
    for stage in &scene.stages {
        let name = format!("{name}, {}", stage.id);
        assert!(!stage.frames.is_empty() && !stage.title.is_empty(), "{name}");
        assert!(stage.frames.windows(2).all(|pair| pair[0].at <= pair[1].at), "{name}");
        assert!(stage.frames.len() <= 250, "{name}");
        for frame in &stage.frames {
            for (id, numbers) in &frame.poses {
                assert!(ids.contains(id.as_str()), "{name}: {id}");
                assert!(numbers.iter().all(|x| x.is_finite()), "{name}: {id}");
                let (r, _) = pose(frame, id);
                assert!((r * r.transpose() - Matrix3::identity()).norm() < 1e-12, "{name}: {id}");
                assert!((r.determinant() - 1.0).abs() < 1e-12, "{name}: {id}");
            }
            let points = frame.contact.iter().chain(frame.trace.iter().flatten());
            assert!(points.flatten().all(|x| x.is_finite()), "{name}");
        }
    }
}

fn check_body(name: &str, body: &Body) {
    assert!(body.positions.iter().all(|x| x.is_finite()), "{name}");
    assert_eq!(body.positions.len() % 3, 0, "{name}");
    assert_eq!(body.indices.len() % 3, 0, "{name}");
    let count = (body.positions.len() / 3) as u32;
    assert!(body.indices.iter().all(|&i| i < count), "{name}");
    assert!((12..=3 * MOST_TRIANGLES).contains(&body.indices.len()), "{name}: {}", body.indices.len() / 3);
    if !body.closed {
        return;
    }
    let mut edges = HashSet::new();
    for t in body.indices.chunks(3) {
        for (from, to) in [(t[0], t[1]), (t[1], t[2]), (t[2], t[0])] {
            assert!(from != to && edges.insert((from, to)), "{name}: an edge twice in one sense");
        }
    }
    assert!(edges.iter().all(|&(from, to)| edges.contains(&(to, from))), "{name}: an open edge");
    assert!(volume(body) > 0.0, "{name}: inside out");
}
