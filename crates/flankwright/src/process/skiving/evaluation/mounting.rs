//! How the tool is mounted: eccentricity and wobble as the rigid motion that fits best, once more without the teeth that stand out
//! (spec 60 section 8).

use super::Deviations;
use crate::geometry::Sides;
use crate::process::skiving::MeasuringTrack;
use crate::process::skiving::measuring::{FlankTracks, turned};
use nalgebra::{Matrix4, RowVector4, Vector3, Vector4};
use std::f64::consts::TAU;

/// Eccentricity and wobble of a mounted tool. mm, rad.
#[derive(Clone, Debug, PartialEq)]
pub struct Mounting {
    /// e in the spindle's x and y.
    pub eccentricity: [f64; 2],
    /// om about the spindle's x and y.
    pub wobble: [f64; 2],
    /// Standard deviations of [e_x, e_y, om_x, om_y] for a standard deviation of 1 mm of every f, mm/mm and rad/mm; infinite where the
    /// measurement does not tell.
    pub deviation_per_noise: [f64; 4],
    /// Standard deviations of the same from what the fit leaves, tooth by tooth, mm and rad: teeth scatter more than readings. Infinite
    /// where the measurement does not tell.
    pub deviation: [f64; 4],
    /// Teeth that were left out of the fit.
    pub left_out: Vec<usize>,
}

/// A residual that makes a tooth stand out: never below the first, mm, and the median of all times the second (a normal
/// distribution's 3.5 standard deviations).
const SURE: f64 = 1e-3;
const OUTLIER: f64 = 3.5 * 1.4826;
/// The share of the teeth that may be left out.
const SHARE: usize = 4;
/// Relative size of a singular value below which a direction is not observed.
const RANK: f64 = 1e-12;

impl Mounting {
    /// What the mounting does to a track of a tooth, mm.
    pub fn rigid_part(&self, track: &MeasuringTrack, tooth: usize, teeth: usize) -> f64 {
        let of = |k: usize| if k < 2 { self.eccentricity[k] } else { self.wobble[k - 2] };
        row(track, tooth, teeth).dot(&RowVector4::from_fn(|_, k| of(k)))
    }
}

/// The mounting from deviations without clocking.
pub fn mounting(flanks: &Sides<FlankTracks>, clocked: &Deviations) -> Mounting {
    let teeth = clocked.teeth();
    let first = fit(flanks, clocked, &vec![true; teeth]);
    let residuals = first.residuals(flanks, clocked);
    let mut sizes: Vec<f64> = residuals.iter().map(|(_, r)| r.abs()).collect();
    let limit = SURE.max(OUTLIER * median(&mut sizes));
    let mut used = vec![true; teeth];
    for (tooth, residual) in residuals {
        if residual.abs() > limit {
            used[tooth] = false;
        }
    }
    let left_out: Vec<usize> = (0..teeth).filter(|&tooth| !used[tooth]).collect();
    if left_out.is_empty() || left_out.len() > teeth / SHARE {
        return first.into_mounting(Vec::new());
    }
    fit(flanks, clocked, &used).into_mounting(left_out)
}

/// A fit with the means that belong to it.
struct Fit {
    values: Vector4<f64>,
    deviations: [f64; 4],
    of_teeth: [f64; 4],
    constants: Sides<Vec<f64>>,
}

impl Fit {
    fn residuals(&self, flanks: &Sides<FlankTracks>, clocked: &Deviations) -> Vec<(usize, f64)> {
        let teeth = clocked.teeth();
        clocked
            .iter()
            .map(|(flank, track, tooth, f)| {
                let rigid = (row(&flanks[flank].tracks[track].0, tooth, teeth) * self.values).x;
                (tooth, f - rigid - self.constants[flank][track])
            })
            .collect()
    }

    fn into_mounting(self, left_out: Vec<usize>) -> Mounting {
        let v = &self.values;
        Mounting {
            eccentricity: [v[0], v[1]],
            wobble: [v[2], v[3]],
            deviation_per_noise: self.deviations,
            deviation: self.of_teeth,
            left_out,
        }
    }
}

/// n.e + om.(m x n) as a row for [e_x, e_y, om_x, om_y], the tooth turned to its place.
fn row(track: &MeasuringTrack, tooth: usize, teeth: usize) -> RowVector4<f64> {
    let angle = TAU * tooth as f64 / teeth as f64;
    let at = |v: &Vector3<f64>| turned(angle, v);
    let (m, n) = (at(&track.contact.point), at(&track.contact.normal));
    let moment = m.cross(&n);
    RowVector4::new(n.x, n.y, moment.x, moment.y)
}

/// Least squares with a constant for every flank and track: rows and numbers without their means over the teeth in use.
fn fit(flanks: &Sides<FlankTracks>, clocked: &Deviations, used: &[bool]) -> Fit {
    let teeth = used.len();
    let count = used.iter().filter(|&&used| used).count() as f64;
    let mut normal = Matrix4::zeros();
    let mut right = Vector4::zeros();
    let mut means = Vec::new();
    for (flank, of) in clocked.of.iter() {
        for (number, numbers) in of.iter().enumerate() {
            let track = &flanks[flank].tracks[number].0;
            let taken = || (0..teeth).filter(|&k| used[k]).map(|k| (row(track, k, teeth), numbers[k]));
            let (rows, sum) = taken().fold((RowVector4::zeros(), 0.0), |(r, s), (row, f)| (r + row, s + f));
            let (mean_row, mean) = (rows / count, sum / count);
            for (row, f) in taken() {
                let row = row - mean_row;
                normal += row.transpose() * row;
                right += row.transpose() * (f - mean);
            }
            means.push((flank, number, mean_row, mean));
        }
    }
    // Scaled, so that lengths and angles count alike.
    let scale = normal.diagonal().map(|x| if x > 0.0 { 1.0 / x.sqrt() } else { 0.0 });
    let scaling = Matrix4::from_diagonal(&scale);
    let eigen = (scaling * normal * scaling).symmetric_eigen();
    let largest = eigen.eigenvalues.max();
    let inverse = eigen.eigenvalues.map(|x| if x > RANK * largest { 1.0 / x } else { 0.0 });
    let lost = eigen.eigenvalues.iter().any(|&x| x <= RANK * largest);
    let vectors = eigen.eigenvectors;
    let covariance = scaling * vectors * Matrix4::from_diagonal(&inverse) * vectors.transpose() * scaling;
    let values = covariance * right;
    let told = |deviation: f64| if lost { f64::INFINITY } else { deviation };
    let deviations = std::array::from_fn(|k| told(covariance[(k, k)].sqrt()));
    let mut constants = Sides { left: Vec::new(), right: Vec::new() };
    // What is left of a tooth comes from one cause on all its tracks: the sums of each tooth scatter, not single numbers.
    let mut sums = vec![Vector4::zeros(); teeth];
    for (flank, number, mean_row, mean) in means {
        let track = &flanks[flank].tracks[number].0;
        for tooth in (0..teeth).filter(|&tooth| used[tooth]) {
            let row = row(track, tooth, teeth) - mean_row;
            let left = clocked.of[flank][number][tooth] - mean - (row * values).x;
            sums[tooth] += row.transpose() * left;
        }
        constants[flank].push(mean - (mean_row * values).x);
    }
    let scattered = sums.iter().map(|sum| sum * sum.transpose()).sum::<Matrix4<f64>>();
    // Four unknowns are taken from as many teeth as there are.
    let scattered = covariance * scattered * covariance * (count / (count - 4.0).max(1.0));
    let of_teeth = std::array::from_fn(|k| told(scattered[(k, k)].max(0.0).sqrt()));
    Fit { values, deviations, of_teeth, constants }
}

fn median(values: &mut [f64]) -> f64 {
    values.sort_by(f64::total_cmp);
    let half = values.len() / 2;
    if values.len() % 2 == 1 { values[half] } else { 0.5 * (values[half - 1] + values[half]) }
}
