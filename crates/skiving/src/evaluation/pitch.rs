//! Pitch, tooth centres and thickness from the middle track (`docs/mathematics/skiving.md#evaluation`).

use super::Deviations;
use crate::measuring::FlankTracks;
use foundation::geometry::{Flank, Sides};
use foundation::numerics::{Harmonic, extremes};
use std::f64::consts::TAU;

/// Pitch of the tooth centres and thickness at the middle track. mm, rad.
#[derive(Clone, Debug, PartialEq)]
pub struct Pitch {
    /// f_p,k: from each tooth's centre to the next one's.
    pub single: Vec<f64>,
    /// F_p,k: from tooth 0 to each tooth.
    pub cumulative: Vec<f64>,
    /// f_p,max; as F_p of whole teeth only.
    pub largest_single: f64,
    /// F_p.
    pub total: f64,
    /// Cosine and sine part of the first harmonic of the centres, rad.
    pub first_harmonic: [f64; 2],
    /// Deviation of each tooth's thickness.
    pub thickness: Vec<f64>,
    /// Tooth centres of every track, rad.
    pub centres: Vec<Vec<f64>>,
}

/// Pitch from tooth position angles a' [rad]; the largest deviations and the first harmonic are those of the teeth that `count`.
pub(super) fn pitch(flanks: &Sides<FlankTracks>, angles: &Deviations, counting: &[bool]) -> Pitch {
    let tracks = &flanks.left.tracks;
    let middle = tracks.len() / 2;
    let radius = 0.5 * (tracks[middle].0.radius() + flanks.right.tracks[middle].0.radius());
    let plus = if tracks[middle].0.contact.lever > 0.0 { Flank::Left } else { Flank::Right };
    let of_track = |track: usize, of: fn(f64, f64) -> f64| -> Vec<f64> {
        let (a, b) = (&angles.of[plus][track], &angles.of[plus.other()][track]);
        a.iter().zip(b).map(|(a, b)| of(*a, *b)).collect()
    };
    let centres: Vec<Vec<f64>> =
        (0..tracks.len()).map(|track| of_track(track, |a, b| 0.5 * (a + b))).collect();
    let at = &centres[middle];
    let count = at.len();
    let single: Vec<f64> = (0..count).map(|k| radius * (at[(k + 1) % count] - at[k])).collect();
    let cumulative: Vec<f64> = at.iter().map(|centre| radius * (centre - at[0])).collect();
    let taken = |tooth: &usize| counting[*tooth];
    let next = |tooth: usize| (tooth + 1) % count;
    let both = |tooth: &usize| counting[*tooth] && counting[next(*tooth)];
    let [least, greatest] = extremes((0..count).filter(taken).map(|k| cumulative[k]));
    Pitch {
        largest_single: (0..count).filter(both).map(|k| single[k].abs()).fold(0.0, f64::max),
        total: greatest - least,
        first_harmonic: first_harmonic(at, counting),
        thickness: of_track(middle, |a, b| a - b).into_iter().map(|x| x * radius).collect(),
        single,
        cumulative,
        centres,
    }
}

/// Cosine and sine part of the wave of one period that fits the teeth which count best. Of all teeth these are the sums of Fourier.
fn first_harmonic(centres: &[f64], counting: &[bool]) -> [f64; 2] {
    let count = centres.len() as f64;
    let rows = || {
        let taken = centres.iter().enumerate().filter(|(tooth, _)| counting[*tooth]);
        taken.map(|(tooth, centre)| (Harmonic::row(TAU * tooth as f64 / count), *centre))
    };
    Harmonic::over(rows().map(|(row, _)| row)).map_or([0.0; 2], |fit| {
        let wave = fit.through(rows());
        [wave[1], wave[2]]
    })
}
