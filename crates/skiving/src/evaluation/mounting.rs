//! How the tool is mounted: eccentricity and wobble as the rigid motion that fits the whole teeth best
//! (`docs/mathematics/skiving.md#evaluation`).

use super::Deviations;
use crate::MeasuringTrack;
use crate::measuring::{FlankTracks, turned};
use foundation::geometry::Sides;
use nalgebra::{Matrix4, RowVector4, Vector3, Vector4};
use std::f64::consts::TAU;

/// Eccentricity and wobble of a mounted tool. mm, rad.
#[derive(Clone, Debug, PartialEq)]
pub struct Mounting {
    /// e in the spindle's x and y, as it stands with tooth 0 at its nominal angle.
    pub eccentricity: [f64; 2],
    /// om about the same.
    pub wobble: [f64; 2],
    /// Standard deviations of [e_x, e_y, om_x, om_y] for a standard deviation of 1 mm of every f, mm/mm and rad/mm; infinite where the
    /// measurement does not tell.
    pub deviation_per_noise: [f64; 4],
    /// Standard deviations of the same from what the fit leaves, tooth by tooth, mm and rad: teeth scatter more than readings; and from
    /// what a linear evaluation is off, which no scatter shows. Infinite where the measurement does not tell.
    pub deviation: [f64; 4],
    /// C: what is left on each track in the mean, clocking included where the deviations include it, mm.
    pub constants: Sides<Vec<f64>>,
    /// Outlier teeth, which were left out of the fit.
    pub left_out: Vec<usize>,
}

/// Standard deviation of what a linear evaluation is off, as a share of how far the teeth deviate: 0.026 to 0.050 um at most of 16 to
/// 26 um (`docs/mathematics/skiving.md#how-it-is-verified`), evenly up to there.
const LINEARISATION: f64 = 1.1e-3;
/// Relative size of a singular value below which a direction is not observed.
const RANK: f64 = 1e-12;

impl Mounting {
    /// What the mounting does to a track of a tooth, mm.
    pub fn rigid_part(&self, track: &MeasuringTrack, tooth: usize, teeth: usize) -> f64 {
        let of = |k: usize| if k < 2 { self.eccentricity[k] } else { self.wobble[k - 2] };
        row(track, tooth, teeth).dot(&RowVector4::from_fn(|_, k| of(k)))
    }
}

/// The mounting from the deviations of the teeth in use, with or without their clocking.
pub(super) fn mounting(
    flanks: &Sides<FlankTracks>,
    deviations: &Deviations,
    used: &[bool],
    left_out: Vec<usize>,
) -> Mounting {
    let fit = fit(flanks, deviations, used);
    let v = &fit.values;
    Mounting {
        eccentricity: [v[0], v[1]],
        wobble: [v[2], v[3]],
        deviation_per_noise: fit.deviations,
        deviation: fit.of_teeth,
        constants: fit.constants,
        left_out,
    }
}

/// A fit with the means that belong to it.
struct Fit {
    values: Vector4<f64>,
    deviations: [f64; 4],
    of_teeth: [f64; 4],
    constants: Sides<Vec<f64>>,
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
    let mut linear = Matrix4::zeros();
    for (flank, number, mean_row, mean) in means {
        let (mut in_step, mut a_quarter_later, mut largest) = (Vector4::zeros(), Vector4::zeros(), 0.0f64);
        let track = &flanks[flank].tracks[number].0;
        for tooth in (0..teeth).filter(|&tooth| used[tooth]) {
            let row = row(track, tooth, teeth) - mean_row;
            let left = clocked.of[flank][number][tooth] - mean - (row * values).x;
            sums[tooth] += row.transpose() * left;
            let (sin, cos) = (TAU * tooth as f64 / teeth as f64).sin_cos();
            in_step += row.transpose() * cos;
            a_quarter_later += row.transpose() * sin;
            largest = largest.max((clocked.of[flank][number][tooth] - mean).abs());
        }
        // It goes around with the teeth as the mounting does, on every track as it likes.
        let off = LINEARISATION * largest;
        for wave in [in_step * off, a_quarter_later * off] {
            linear += wave * wave.transpose();
        }
        constants[flank].push(mean - (mean_row * values).x);
    }
    let scattered = sums.iter().map(|sum| sum * sum.transpose()).sum::<Matrix4<f64>>();
    // Four unknowns are taken from as many teeth as there are.
    let scattered = covariance * (scattered * (count / (count - 4.0).max(1.0)) + linear) * covariance;
    let of_teeth = std::array::from_fn(|k| told(scattered[(k, k)].max(0.0).sqrt()));
    Fit { values, deviations, of_teeth, constants }
}
