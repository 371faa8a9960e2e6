//! A worm as a closed mesh: its threads as a height over the cylinder, columns along the axis, rows along the helices; plane faces and a
//! bore for the eye. A section across the axis would cut threads of small lead so flatly that triangles between sections are seen.
//! Knows no motion, and no modification.

use super::toothed::{BORE, Toothed};
use crate::mesh::{MeshError, TriangleMesh};
use foundation::geometry::Flank;
use nalgebra::Vector3;
use std::collections::HashMap;
use std::f64::consts::TAU;

/// Columns around the axis: edges of a worm of 200 mm stand 0.03 mm inside the circle.
const COLUMNS: usize = 120;
/// Points of a flank at most and at least.
const PROFILE: [usize; 2] = [3, 8];
/// Triangles of the threads at most, where the least points of a flank allow it.
const MOST_TRIANGLES: usize = 52_000;
/// Rows nearer to a face end on it, mm.
const NEAR_FACE: f64 = 1e-3;
/// Rounds of the places of rows (a cylinder needs one), and of radii on a face.
const ROUNDS: usize = 40;
/// Most spaces along the axis that are meshed.
const MOST_SPACES: f64 = 1e4;

/// A place of a space's section: a share of the way from root to tip on one flank.
#[derive(Clone, Copy)]
struct Row {
    flank: Flank,
    share: f64,
}

/// A worm being meshed.
struct Threads<'a> {
    body: &'a Toothed<'a>,
    /// Rows of one space in ascending polar angle: down the right flank, up the left one.
    rows: Vec<Row>,
    /// Angle from space to space.
    pitch: f64,
}

/// The mesh of a worm.
///
/// # Errors
/// [`MeshError`] for a body that cannot be.
pub fn threaded(body: &Toothed<'_>) -> Result<TriangleMesh, MeshError> {
    let [from, to] = body.faces;
    let threads = body.gear.tooth_count();
    let pitch = TAU / threads;
    let twist = body.gear.flank(Flank::Left).twist_per_length();
    let spaces = ((to - from) * twist / pitch).abs() + 1.0;
    if !(spaces.is_finite() && spaces < MOST_SPACES) {
        let what = "threads along a worm";
        return Err(MeshError::TooMany { what, most: MOST_SPACES as usize, found: spaces as usize });
    }
    let affordable = MOST_TRIANGLES as f64 / (4.0 * COLUMNS as f64 * spaces);
    let points = (affordable as usize).clamp(PROFILE[0], PROFILE[1]);
    let share = |k: usize| k as f64 / (points - 1) as f64;
    let down = (0..points).rev().map(|k| Row { flank: Flank::Right, share: share(k) });
    let up = (0..points).map(|k| Row { flank: Flank::Left, share: share(k) });
    Threads { body, rows: down.chain(up).collect(), pitch }.mesh()
}

impl Threads<'_> {
    fn mesh(&self) -> Result<TriangleMesh, MeshError> {
        let [from, to] = self.body.faces;
        let mut mesh = TriangleMesh::default();
        let angle = |column: usize| TAU * column as f64 / COLUMNS as f64;
        // Rings: outside and bore of both faces.
        let bore = BORE * self.body.radii(from).root.min(self.body.radii(to).root);
        let mut ring = |z: f64, radius: &dyn Fn(f64) -> f64| -> u32 {
            let first = mesh.vertices.len() as u32;
            mesh.vertices.extend((0..COLUMNS).map(|j| on_cylinder(radius(angle(j)), angle(j), z)));
            first
        };
        let outside = [from, to].map(|z| ring(z, &|angle| self.radius(angle, z)));
        let inside = [from, to].map(|z| ring(z, &|_| bore));
        // Rows are counted through all spaces; a turn leads from a row to that of another space.
        let per_space = self.rows.len() as i64;
        let turn = per_space * self.body.gear.tooth_count() as i64;
        let [first, last] = self.spaces();
        let mut known: HashMap<(i64, usize), u32> = HashMap::new();
        let mut vertex = |row: i64, column: usize| -> u32 {
            let (row, column) = if column == COLUMNS { (row - turn, 0) } else { (row, column) };
            *known.entry((row, column)).or_insert_with(|| {
                let z = self.place(row, angle(column));
                if z < from + NEAR_FACE {
                    return outside[0] + column as u32;
                }
                if z > to - NEAR_FACE {
                    return outside[1] + column as u32;
                }
                let Row { share, .. } = self.rows[row.rem_euclid(per_space) as usize];
                mesh.vertices.push(on_cylinder(self.at(share, z), angle(column), z));
                mesh.vertices.len() as u32 - 1
            })
        };
        let mut cells = Vec::new();
        for row in first * per_space..last * per_space {
            for column in 0..COLUMNS {
                cells.push([
                    vertex(row, column),
                    vertex(row, column + 1),
                    vertex(row + 1, column + 1),
                    vertex(row + 1, column),
                ]);
            }
        }
        // Where rows run against the axis, the threads are inside out against the faces.
        let against = self.place(1, 0.0) < self.place(0, 0.0);
        for [a, b, c, d] in cells {
            for [u, v, w] in [[a, b, c], [a, c, d]] {
                if u != v && v != w && w != u {
                    mesh.triangles.push(if against { [u, w, v] } else { [u, v, w] });
                }
            }
        }
        for j in 0..COLUMNS {
            let (here, next) = (j as u32, ((j + 1) % COLUMNS) as u32);
            let mut wall = |[a, b]: [u32; 2]| {
                mesh.triangles.push([a + here, a + next, b + next]);
                mesh.triangles.push([a + here, b + next, b + here]);
            };
            // Outwards: the upper face, the bore, the lower face.
            wall([outside[1], inside[1]]);
            wall([inside[1], inside[0]]);
            wall([inside[0], outside[0]]);
        }
        let mesh = if mesh.volume() < 0.0 { mesh.turned() } else { mesh };
        mesh.check_watertight()?;
        Ok(mesh)
    }

    /// Radius at a share of the way from root to tip.
    fn at(&self, share: f64, z: f64) -> f64 {
        let radii = self.body.radii(z);
        radii.root + share * (radii.tip - radii.root)
    }

    /// First space and the one behind the last that reach the faces anywhere.
    fn spaces(&self) -> [i64; 2] {
        let [from, to] = self.body.faces;
        // Angles from +y towards +x at which the middle of space 0 passes the faces.
        let middle = |z: f64| {
            let root = self.body.radii(z).root;
            0.5 * (self.body.polar(Flank::Left, root, z) + self.body.polar(Flank::Right, root, z))
        };
        let (a, b) = (middle(from), middle(to));
        let least = (-a.max(b) / self.pitch).floor() as i64 - 2;
        let most = ((TAU - a.min(b)) / self.pitch).ceil() as i64 + 3;
        [least, most]
    }

    /// Axial position of a row at an angle.
    fn place(&self, row: i64, angle: f64) -> f64 {
        let per_space = self.rows.len() as i64;
        let Row { flank, share } = self.rows[row.rem_euclid(per_space) as usize];
        let wanted = angle - self.pitch * row.div_euclid(per_space) as f64;
        let twist = self.body.gear.flank(flank).twist_per_length();
        let mut z = 0.0;
        for _ in 0..ROUNDS {
            // The angle falls along the axis by the twist, and on a cone by what the radius changes.
            let step = (self.body.polar(flank, self.at(share, z), z) - wanted) / twist;
            z += step;
            if step.abs() < 1e-12 * (1.0 + z.abs()) {
                break;
            }
        }
        z
    }

    /// Radius of the body at an angle and an axial position.
    fn radius(&self, angle: f64, z: f64) -> f64 {
        let radii = self.body.radii(z);
        let polar = |flank: Flank, radius: f64| self.body.polar(flank, radius, z);
        let lowest = polar(Flank::Right, radii.tip);
        let x = lowest + (angle - lowest).rem_euclid(self.pitch);
        let on = |flank: Flank, sign: f64| {
            let (mut low, mut high) = (radii.root, radii.tip);
            for _ in 0..60 {
                let middle = 0.5 * (low + high);
                if sign * (polar(flank, middle) - x) < 0.0 { low = middle } else { high = middle }
            }
            0.5 * (low + high)
        };
        if x < polar(Flank::Right, radii.root) {
            on(Flank::Right, -1.0)
        } else if x <= polar(Flank::Left, radii.root) {
            radii.root
        } else if x < polar(Flank::Left, radii.tip) {
            on(Flank::Left, 1.0)
        } else {
            radii.tip
        }
    }
}

/// A point by its angle from +y towards +x.
fn on_cylinder(radius: f64, angle: f64, z: f64) -> Vector3<f64> {
    let (sin, cos) = angle.sin_cos();
    Vector3::new(radius * sin, radius * cos, z)
}
