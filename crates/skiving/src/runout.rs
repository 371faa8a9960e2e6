//! The run-out of a tool answered while it skives: a periodic change of the centre distance, of the coupling, or of both over the turn of
//! the tool (`docs/mathematics/skiving.md#periodic-correction-of-the-run-out`).

use super::evaluation::Evaluation;
use super::measuring::FlankTracks;
use super::{SkivingError, setting_sensitivity};
use foundation::geometry::{Flank, Sides};
use foundation::kinematics::SkivingMotion;
use nalgebra::{DMatrix, DVector};
use std::f64::consts::TAU;

/// What changes with the turn of the tool.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct RunoutAxes {
    /// The centre distance.
    pub centre_distance: bool,
    /// The coupling of the workpiece to the tool.
    pub coupling: bool,
}

/// A law over the turn of the tool, by cosines and sines of its angle phi_1 and of multiples of it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PeriodicLaw {
    /// [cos, sin] of each order, added to d, mm.
    pub centre_distance: Vec<[f64; 2]>,
    /// [cos, sin] of each order, added to the angle of the workpiece, rad.
    pub work_angle: Vec<[f64; 2]>,
}

/// A law and what it leaves of the differences between the teeth.
#[derive(Clone, Debug, PartialEq)]
pub struct RunoutFit {
    /// The law.
    pub law: PeriodicLaw,
    /// f_2 of every tooth against the mean tooth, without and with the law, [track][tooth] of each flank, mm.
    pub teeth: [Sides<Vec<Vec<f64>>>; 2],
    /// Greatest range of them over the teeth of a track, without and with, mm.
    pub spread: [f64; 2],
}

/// Singular values of the scaled matrix below which a direction is left alone.
const SMALLEST: f64 = 1e-6;

impl PeriodicLaw {
    /// What is added to centre distance, mm, and angle of the workpiece, rad, at an angle of the tool.
    pub fn at(&self, tool_angle: f64) -> [f64; 2] {
        [&self.centre_distance, &self.work_angle].map(|terms| {
            let term = |(number, [cos, sin]): (usize, &[f64; 2])| {
                let (s, c) = ((number + 1) as f64 * tool_angle).sin_cos();
                cos * c + sin * s
            };
            terms.iter().enumerate().map(term).sum()
        })
    }

    /// Greatest change of both.
    pub fn amplitudes(&self) -> [f64; 2] {
        const PLACES: usize = 720;
        let mut most = [0.0f64; 2];
        for k in 0..PLACES {
            let at = self.at(TAU * k as f64 / PLACES as f64);
            most = [most[0].max(at[0].abs()), most[1].max(at[1].abs())];
        }
        most
    }
}

/// The law of some orders that makes the differences between the counting teeth of a measured tool least. Tooth k touches the flank at
/// phi_1 - 2 pi k/z_1, so that a law of the angle is one of the teeth.
///
/// # Errors
/// [`SkivingError::InvalidNumber`] for no order, or more than every second tooth can tell.
pub fn fit_runout(
    flanks: &Sides<FlankTracks>,
    evaluation: &Evaluation,
    axes: RunoutAxes,
    orders: usize,
) -> Result<RunoutFit, SkivingError> {
    let pair = flanks.left.edge.pair();
    let motion = pair.motion();
    let teeth = pair.tool().teeth() as usize;
    if orders == 0 || 4 * orders > evaluation.count() {
        let (field, value) = ("runout.orders", orders as f64);
        return Err(SkivingError::InvalidNumber {
            field,
            value,
            allowed: "from 1 to a quarter of the teeth that count",
        });
    }
    let before = against_mean(flanks, evaluation);
    let parts = usize::from(axes.centre_distance) + usize::from(axes.coupling);
    let unknowns = 2 * orders * parts;
    let mut rows: Vec<(Flank, usize, usize, Vec<f64>)> = Vec::new();
    for (flank, of) in flanks.iter() {
        for (number, (track, _)) in of.tracks.iter().enumerate() {
            let [by_distance, by_turn] = sensitivity(motion, &track.contact);
            for tooth in 0..teeth {
                let angle = angle_of(track.contact.tool_angle, tooth, teeth);
                let mut row = Vec::with_capacity(unknowns);
                for (free, by) in [(axes.centre_distance, by_distance), (axes.coupling, by_turn)] {
                    for order in (1..=orders).filter(|_| free) {
                        let (sin, cos) = (order as f64 * angle).sin_cos();
                        row.extend([by * cos, by * sin]);
                    }
                }
                rows.push((flank, number, tooth, row));
            }
        }
    }
    let counting: Vec<&(Flank, usize, usize, Vec<f64>)> =
        rows.iter().filter(|(_, _, tooth, _)| evaluation.counting[*tooth]).collect();
    let matrix = DMatrix::from_fn(counting.len(), unknowns, |i, j| counting[i].3[j]);
    let right = DVector::from_fn(counting.len(), |i, _| {
        let (flank, track, tooth, _) = counting[i];
        -before[*flank][*track][*tooth]
    });
    let scale = DVector::from_fn(unknowns, |j, _| {
        let norm = matrix.column(j).norm();
        if norm > 0.0 { 1.0 / norm } else { 0.0 }
    });
    let svd = (&matrix * DMatrix::from_diagonal(&scale)).svd(true, true);
    let solved =
        svd.solve(&right, SMALLEST).unwrap_or_else(|_| DVector::zeros(unknowns)).component_mul(&scale);
    let mut after = before.clone();
    for (flank, track, tooth, row) in &rows {
        after[*flank][*track][*tooth] += row.iter().zip(solved.iter()).map(|(by, x)| by * x).sum::<f64>();
    }
    let mut terms = solved.as_slice().chunks_exact(2).map(|pair| [pair[0], pair[1]]);
    let mut take = |free: bool| -> Vec<[f64; 2]> {
        if free { terms.by_ref().take(orders).collect() } else { Vec::new() }
    };
    let law = PeriodicLaw { centre_distance: take(axes.centre_distance), work_angle: take(axes.coupling) };
    let spread = [&before, &after].map(|of| spread(of, &evaluation.counting));
    Ok(RunoutFit { law, teeth: [before, after], spread })
}

/// Angle of the tool at which a tooth touches where tooth 0 touches at another.
pub fn angle_of(tool_angle: f64, tooth: usize, teeth: usize) -> f64 {
    tool_angle - TAU * tooth as f64 / teeth as f64
}

/// Change of f_2 per mm of centre distance and per rad of the workpiece's angle: the workpiece turned is the tool turned back.
fn sensitivity(motion: &SkivingMotion, contact: &super::ContactPlace) -> [f64; 2] {
    let [distance, _, _, turn] = setting_sensitivity(motion, contact);
    [distance, -turn / motion.ratio]
}

/// What every tooth leaves beyond the mean of the counting ones.
fn against_mean(flanks: &Sides<FlankTracks>, evaluation: &Evaluation) -> Sides<Vec<Vec<f64>>> {
    flanks.map(|flank, of| {
        let of_track = |number: usize| -> Vec<f64> {
            let f = &evaluation.clocked.of[flank][number];
            let counted = f.iter().zip(&evaluation.counting).filter(|(_, counts)| **counts).map(|(f, _)| *f);
            let mean = counted.sum::<f64>() / evaluation.count().max(1) as f64;
            f.iter().map(|f| mean - f).collect()
        };
        (0..of.tracks.len()).map(of_track).collect()
    })
}

/// Greatest range over the counting teeth of a track.
pub fn spread(of: &Sides<Vec<Vec<f64>>>, counting: &[bool]) -> f64 {
    let range = |teeth: &Vec<f64>| {
        let counted = || teeth.iter().zip(counting).filter(|(_, counts)| **counts).map(|(f, _)| *f);
        counted().fold(f64::NEG_INFINITY, f64::max) - counted().fold(f64::INFINITY, f64::min)
    };
    of.iter().flat_map(|(_, tracks)| tracks.iter().map(range)).fold(0.0, f64::max)
}
