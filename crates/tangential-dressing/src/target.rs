//! What is wanted of the flanks of one pass, and the points at which it is asked for. Knows no motion.

use super::forward::RollGrid;
use super::model::TangentialModel;
use foundation::geometry::Flank;

/// The wanted flanks: material left, mm, at (w, z) on a flank.
pub type Wanted<'a> = dyn Fn(Flank, f64, f64) -> f64 + Sync + 'a;

/// Amounts at the edge of the evaluated range, as the source states them: material removed normal to the flank, mm
/// (`docs/mathematics/tangential-dressing.md#fit`).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct EdgeAmounts {
    /// O_r1: linear in the radius.
    pub pressure_angle: f64,
    /// O_r2: quadratic in the radius.
    pub profile_crowning: f64,
    /// O_z1: linear along the face.
    pub lead_conical: f64,
    /// O_z2: quadratic along the face.
    pub lead_crowning: f64,
}

impl EdgeAmounts {
    /// Material left at a point of a flank, mm.
    pub fn value(&self, model: &TangentialModel, flank: Flank, w: f64, z: f64) -> f64 {
        let (xi, eta) = edge_coordinates(model, flank, w, z);
        -(self.pressure_angle * xi
            + self.profile_crowning * xi * xi
            + self.lead_conical * eta
            + self.lead_crowning * eta * eta)
    }
}

/// (xi, eta): -1 to 1 over the evaluated radii and over the face width.
fn edge_coordinates(model: &TangentialModel, flank: Flank, w: f64, z: f64) -> (f64, f64) {
    let [start, end] = model.input().radii;
    let middle = 0.5 * (start + end);
    ((model.radius(flank, w) - middle) / (end - middle), 2.0 * z / model.input().face_width)
}

/// How the points of a fit count.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Weights {
    /// All alike.
    #[default]
    Uniform,
    /// 0.1 + xi^2 + eta^2, as the source has it: the edges count most.
    Source,
}

impl Weights {
    /// The factor on the residual at a point of a flank.
    pub fn at(self, model: &TangentialModel, flank: Flank, w: f64, z: f64) -> f64 {
        match self {
            Self::Uniform => 1.0,
            Self::Source => {
                let (xi, eta) = edge_coordinates(model, flank, w, z);
                0.1 + xi * xi + eta * eta
            }
        }
    }
}

/// Where a fit asks.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FitGrid {
    /// That many points each way at equidistant radii, as the source has it with 5.
    Radii(usize),
    /// That many points each way, graded in the length of roll: between Chebyshev and equidistant, for near the base circle the radius hides
    /// what the roll shows.
    Graded(usize),
    /// That many points over the profile and over the face, equidistant in the length of roll.
    Equidistant(usize, usize),
}

impl FitGrid {
    /// Its points on a flank.
    pub fn of(self, model: &TangentialModel, flank: Flank) -> RollGrid {
        let spread = |[from, to]: [f64; 2], n: usize, at: &dyn Fn(f64) -> f64| -> Vec<f64> {
            let last = n.max(2) - 1;
            (0..=last).map(|i| from + (to - from) * at(i as f64 / last as f64)).collect()
        };
        let equidistant = |x: f64| x;
        let graded = |x: f64| 0.5 * x + 0.25 * (1.0 - (std::f64::consts::PI * x).cos());
        let rolls = model.rolls(flank);
        let faces = model.input().faces;
        match self {
            Self::Radii(n) => {
                let r_b = model.pair.work.flank(flank).base_radius;
                let radii = spread(model.input().radii, n, &equidistant);
                let w = radii.iter().map(|r| (r * r - r_b * r_b).sqrt()).collect();
                RollGrid { w, z: spread(faces, n, &equidistant) }
            }
            Self::Graded(n) => RollGrid { w: spread(rolls, n, &graded), z: spread(faces, n, &graded) },
            Self::Equidistant(rows, columns) => {
                RollGrid { w: spread(rolls, rows, &equidistant), z: spread(faces, columns, &equidistant) }
            }
        }
    }
}
