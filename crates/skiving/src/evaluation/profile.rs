//! The profile of the edges: means of the tracks, compensation curve, tolerance bands, wear, and the workpiece's profile to come
//! (`docs/mathematics/skiving.md#evaluation`).

use super::Deviations;
use crate::SkivingError;
use crate::measuring::FlankTracks;
use foundation::geometry::{Flank, Sides};
use foundation::numerics::power_series;
use nalgebra::{DMatrix, DVector};

/// What a tool is judged by.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ProfileOptions {
    /// Degree of the compensation curve over x.
    pub degree: usize,
    /// D: width of the tolerance band about the curve, mm.
    pub band: f64,
    /// Mean material that may be missing on a track, mm.
    pub wear_limit: f64,
}

/// Profiles of both flanks. mm.
#[derive(Clone, Debug, PartialEq)]
pub struct ProfileVerdict {
    /// Mean over the whole teeth of every track.
    pub track_means: Sides<Vec<f64>>,
    /// Compensation curve: coefficients of 1, x, x^2, ...
    pub curve: Sides<Vec<f64>>,
    /// Teeth that leave the band, with their flank; ascending, the left flank first.
    pub out_of_band: Vec<(Flank, usize)>,
    /// Whether a flank is worn.
    pub worn: Sides<bool>,
    /// f_2: profile of the workpiece at the tracks' lengths of roll, for the mean tooth; > 0 = material left.
    pub workpiece: Sides<Vec<f64>>,
}

/// Judges what remains of the deviations without clocking and mounting: means of the teeth that count, bands of all that were measured.
///
/// # Errors
/// [`SkivingError::TooFewTracks`], [`SkivingError::InvalidNumber`].
pub(super) fn profile_verdict(
    flanks: &Sides<FlankTracks>,
    remaining: &Deviations,
    (counting, present): (&[bool], &[bool]),
    options: &ProfileOptions,
) -> Result<ProfileVerdict, SkivingError> {
    for (field, value) in [("band_um", options.band), ("wear_limit_um", options.wear_limit)] {
        if !(value.is_finite() && value > 0.0) {
            return Err(SkivingError::InvalidNumber { field, value: 1e3 * value, allowed: "> 0 um" });
        }
    }
    let mean = |teeth: &Vec<f64>| {
        let taken = || teeth.iter().zip(counting).filter(|(_, counts)| **counts).map(|(f, _)| *f);
        taken().sum::<f64>() / taken().count().max(1) as f64
    };
    let track_means = remaining.of.map(|_, tracks| tracks.iter().map(mean).collect::<Vec<f64>>());
    let curve = Sides::try_from_fn(|flank| {
        let places: Vec<f64> = flanks[flank].tracks.iter().map(|(track, _)| track.place).collect();
        polynomial(&places, &track_means[flank], options.degree)
    })?;
    let mut out_of_band = Vec::new();
    for flank in [Flank::Left, Flank::Right] {
        let outside = |tooth: usize| {
            remaining.of[flank].iter().zip(&flanks[flank].tracks).any(|(teeth, (track, _))| {
                (teeth[tooth] - power_series(&curve[flank], track.place)[0]).abs() > 0.5 * options.band
            })
        };
        let teeth = (0..remaining.teeth()).filter(|&tooth| present[tooth] && outside(tooth));
        out_of_band.extend(teeth.map(|tooth| (flank, tooth)));
    }
    let worn = track_means.map(|_, means| means.iter().any(|mean| *mean < -options.wear_limit));
    let workpiece = track_means.map(|_, means| means.iter().map(|mean| -mean).collect());
    Ok(ProfileVerdict { track_means, curve, out_of_band, worn, workpiece })
}

/// Coefficients of the polynomial over x that fits values at places best.
pub(super) fn polynomial(places: &[f64], values: &[f64], degree: usize) -> Result<Vec<f64>, SkivingError> {
    let too_few = SkivingError::TooFewTracks { tracks: places.len(), degree };
    if degree >= places.len() {
        return Err(too_few);
    }
    let matrix = DMatrix::from_fn(places.len(), degree + 1, |i, j| places[i].powi(j as i32));
    let qr = matrix.qr();
    let right = qr.q().transpose() * DVector::from_column_slice(values);
    let solved = qr.r().solve_upper_triangular(&right).ok_or(too_few)?;
    Ok(solved.iter().copied().collect())
}
