//! Deviations of a tooth as growth of its roundings, a shift of its edges, a turn: three least squares. Knows no options.

use super::WearError;
use crate::measuring::FlankTracks;
use foundation::geometry::{Flank, Sides};

/// What is found of an edge.
#[derive(Clone, Copy)]
pub(super) struct Edge {
    /// Growth of its rounding.
    pub growth: f64,
    /// Root of the mean square of what is left.
    pub residual: f64,
}

/// f = factor * growth + lever * position on every track of an edge.
pub(super) struct Model {
    factors: Sides<Vec<f64>>,
    levers: Sides<Vec<f64>>,
}

impl Model {
    pub fn new(flanks: &Sides<FlankTracks>) -> Result<Self, WearError> {
        let factors = flanks.map(|_, of| {
            let sections = of.tracks.iter().map(|(track, _)| &track.section);
            sections.map(|section| section.growth_at(section.contact_angle)).collect::<Vec<f64>>()
        });
        let levers = flanks.map(|_, of| of.tracks.iter().map(|(t, _)| t.contact.lever).collect());
        for (_, factors) in factors.iter() {
            let value = dot(factors, factors);
            if value.is_nan() || value <= 0.0 {
                let allowed = "a contact between both ends of the rounding";
                return Err(WearError::InvalidNumber { field: "growth_at", value, allowed });
            }
        }
        Ok(Self { factors, levers })
    }

    /// Standard deviation of the growth beside a shift for that of a deviation.
    pub fn deviation_with_shift(&self, sigma: f64) -> Sides<f64> {
        self.factors.map(|_, factors| sigma / spread(factors).sqrt())
    }

    fn edge(&self, flank: Flank, f: &[f64], growth: f64, position: f64, shift: f64) -> Edge {
        let (factors, levers) = (&self.factors[flank], &self.levers[flank]);
        let left = f.iter().zip(factors).zip(levers).map(|((f, g), l)| f - g * growth - l * position - shift);
        let squares: f64 = left.map(|r| r * r).sum();
        Edge { growth, residual: (squares / f.len() as f64).sqrt() }
    }

    /// A shift for every edge; it takes up position and clocking.
    pub fn with_shifts(&self, teeth: &[Sides<Vec<f64>>]) -> Vec<Sides<Edge>> {
        let edge = |flank: Flank, f: &Vec<f64>| {
            let factors = &self.factors[flank];
            let (factor, level) = (mean(factors), mean(f));
            let product: f64 = f.iter().zip(factors).map(|(f, g)| (f - level) * (g - factor)).sum();
            let growth = product / spread(factors);
            self.edge(flank, f, growth, 0.0, level - growth * factor)
        };
        teeth.iter().map(|tooth| tooth.map(edge)).collect()
    }

    /// One growth and one position for every tooth. With them: the growth's standard deviation for a unit of noise.
    pub fn with_positions(&self, teeth: &[Sides<Vec<f64>>]) -> (Vec<Sides<Edge>>, Sides<f64>) {
        let both = |a: &Sides<Vec<f64>>, b: &Sides<Vec<f64>>| -> f64 {
            dot(&a.left, &b.left) + dot(&a.right, &b.right)
        };
        let (gg, gl, ll) = (
            both(&self.factors, &self.factors),
            both(&self.factors, &self.levers),
            both(&self.levers, &self.levers),
        );
        // Levers have opposite signs on both flanks and factors the same one: never singular.
        let determinant = gg * ll - gl * gl;
        let solve = |tooth: &Sides<Vec<f64>>| {
            let (gf, lf) = (both(&self.factors, tooth), both(&self.levers, tooth));
            let (growth, position) = ((ll * gf - gl * lf) / determinant, (gg * lf - gl * gf) / determinant);
            tooth.map(|flank, f| self.edge(flank, f, growth, position, 0.0))
        };
        (teeth.iter().map(solve).collect(), Sides::both((ll / determinant).sqrt()))
    }

    /// A growth for every edge and one turn of the whole tool, with which both flanks have grown alike in the mean.
    pub fn with_clocking(&self, teeth: &[Sides<Vec<f64>>]) -> (Vec<Sides<Edge>>, Sides<f64>) {
        let squares = self.factors.map(|_, g| dot(g, g));
        let raw = |flank: Flank, f: &[f64]| dot(&self.factors[flank], f) / squares[flank];
        let count = teeth.len() as f64;
        let level = Sides::from_fn(|flank| teeth.iter().map(|t| raw(flank, &t[flank])).sum::<f64>() / count);
        let turned = Sides::from_fn(|flank| raw(flank, &self.levers[flank]));
        let turn = (level.left - level.right) / (turned.left - turned.right);
        let edge =
            |flank: Flank, f: &Vec<f64>| self.edge(flank, f, raw(flank, f) - turn * turned[flank], turn, 0.0);
        let solved = teeth.iter().map(|tooth| tooth.map(edge)).collect();
        (solved, squares.map(|_, squares| 1.0 / squares.sqrt()))
    }
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

fn mean(values: &[f64]) -> f64 {
    values.iter().sum::<f64>() / values.len() as f64
}

/// Sum of the squares of the distances from the mean.
fn spread(values: &[f64]) -> f64 {
    let mean = mean(values);
    values.iter().map(|x| (x - mean) * (x - mean)).sum()
}
