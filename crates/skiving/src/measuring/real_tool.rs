//! A tool as it is: every tooth with its own pitch, profile and rounding, the whole mounted off its axis
//! (`docs/mathematics/skiving.md#light-barrier`).

use crate::{SkivingError, VirtualEdge};
use foundation::geometry::Sides;
use foundation::numerics::power_series;
use nalgebra::{Rotation3, Vector3};
use std::f64::consts::TAU;

/// Errors of one edge over x = -1..1, as coefficients of 1, x, x^2, ... mm.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct EdgeErrors {
    /// f_k: material beyond the nominal edge along n_m.
    pub profile: Vec<f64>,
    /// drho_k: growth of the rounding between its faces.
    pub growth: Vec<f64>,
}

/// Errors of a whole tool. mm, rad.
#[derive(Clone, Debug, PartialEq)]
pub struct RealTool {
    /// delta_k: pitch deviation of each tooth, > 0 counter-clockwise.
    pub pitch: Vec<f64>,
    /// Errors of both edges of each tooth.
    pub edges: Sides<Vec<EdgeErrors>>,
    /// Teeth that are broken off.
    pub broken: Vec<bool>,
    /// e: eccentricity in x and y of the spindle.
    pub eccentricity: [f64; 2],
    /// om: wobble about x and y of the spindle.
    pub wobble: [f64; 2],
}

/// A function of the length of roll with two derivatives.
pub(super) type RollJet = [Vector3<f64>; 3];

impl EdgeErrors {
    /// Material beyond the nominal edge at x, mm.
    pub fn profile_at(&self, x: f64) -> f64 {
        power_series(&self.profile, x)[0]
    }

    /// Growth of the rounding at x, mm.
    pub fn growth_at(&self, x: f64) -> f64 {
        power_series(&self.growth, x)[0]
    }
}

impl RealTool {
    /// A tool without errors.
    pub fn ideal(teeth: usize) -> Self {
        Self {
            pitch: vec![0.0; teeth],
            edges: Sides::from_fn(|_| vec![EdgeErrors::default(); teeth]),
            broken: vec![false; teeth],
            eccentricity: [0.0; 2],
            wobble: [0.0; 2],
        }
    }

    /// z1.
    pub fn teeth(&self) -> usize {
        self.pitch.len()
    }

    /// Whether every list has as many entries as there are teeth and every number is finite.
    ///
    /// # Errors
    /// [`SkivingError::InvalidNumber`].
    pub fn check(&self, teeth: usize) -> Result<(), SkivingError> {
        let counts = [self.pitch.len(), self.edges.left.len(), self.edges.right.len(), self.broken.len()];
        if let Some(count) = counts.into_iter().find(|&count| count != teeth) {
            let (field, value) = ("real_tool", count as f64);
            return Err(SkivingError::InvalidNumber { field, value, allowed: "one entry for each tooth" });
        }
        let of_edges = self.edges.iter().flat_map(|(_, edges)| edges.iter());
        let coefficients = of_edges.flat_map(|edge| edge.profile.iter().chain(&edge.growth));
        let numbers = self.pitch.iter().chain(&self.eccentricity).chain(&self.wobble).chain(coefficients);
        match numbers.copied().find(|x| !x.is_finite()) {
            None => Ok(()),
            Some(value) => {
                let field = "real_tool";
                Err(SkivingError::InvalidNumber { field, value, allowed: "finite numbers" })
            }
        }
    }

    /// Centre of the rounding of a tooth over the length of roll, in spindle coordinates, and its radius, each with two derivatives.
    pub(super) fn centre(&self, edge: &VirtualEdge, tooth: usize, w: f64) -> (RollJet, [f64; 3]) {
        let flank = edge.flank();
        let [from, to] = flank.range();
        let slope = 2.0 / (to - from);
        let errors = &self.edges[edge.side()][tooth];
        let x = flank.edge_coordinate(w);
        let by_roll = |jet: [f64; 3]| [jet[0], jet[1] * slope, jet[2] * slope * slope];
        let (profile, growth) =
            (by_roll(power_series(&errors.profile, x)), by_roll(power_series(&errors.growth, x)));
        let piece = edge.piece(w);
        let [c, n, v] =
            [&piece.centre, &piece.normal, &piece.growth].map(|series| series.each_ref().map(|s| s.jet(w)));
        let moved = |k: usize, order: usize| {
            let product = |f: &[f64; 3], g: &[f64; 3]| match order {
                0 => f[0] * g[0],
                1 => f[1] * g[0] + f[0] * g[1],
                _ => f[2] * g[0] + 2.0 * f[1] * g[1] + f[0] * g[2],
            };
            c[k][order] + product(&profile, &n[k]) - product(&growth, &v[k])
        };
        let turn = self.turn(tooth);
        let jet = std::array::from_fn(|order| {
            let at = turn * Vector3::from_fn(|k, _| moved(k, order));
            let tilted = at + self.wobble_vector().cross(&at);
            if order == 0 { tilted + self.eccentricity_vector() } else { tilted }
        });
        let radius = edge.pair().tool().rounding().radius;
        (jet, [radius + growth[0], growth[1], growth[2]])
    }

    /// A ball of a tooth's edge at a length of roll, the tooth turned by its nominal pitch to where tooth 0 stands: centre in tool
    /// coordinates and radius, mm.
    pub fn ball(&self, edge: &VirtualEdge, tooth: usize, w: f64) -> (Vector3<f64>, f64) {
        let ([centre, ..], [radius, ..]) = self.centre(edge, tooth, w);
        let back = -TAU * tooth as f64 / self.teeth() as f64;
        (Rotation3::from_axis_angle(&Vector3::z_axis(), back) * centre, radius)
    }

    /// A direction of the spindle in coordinates of a tooth, turned to tooth 0.
    pub(super) fn direction_in_tooth(&self, tooth: usize, direction: &Vector3<f64>) -> Vector3<f64> {
        // The inverse of 1 + [om]x for a direction, up to its length.
        let om = self.wobble_vector();
        let level = direction - om.cross(direction) + om.cross(&om.cross(direction));
        self.turn(tooth).inverse() * level.normalize()
    }

    fn turn(&self, tooth: usize) -> Rotation3<f64> {
        let angle = TAU * tooth as f64 / self.teeth() as f64 + self.pitch[tooth];
        Rotation3::from_axis_angle(&Vector3::z_axis(), angle)
    }

    fn eccentricity_vector(&self) -> Vector3<f64> {
        Vector3::new(self.eccentricity[0], self.eccentricity[1], 0.0)
    }

    fn wobble_vector(&self) -> Vector3<f64> {
        Vector3::new(self.wobble[0], self.wobble[1], 0.0)
    }
}
