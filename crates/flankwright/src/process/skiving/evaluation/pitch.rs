//! Pitch, tooth centres and thickness from the middle track (spec 60 section 8).

use super::Deviations;
use crate::geometry::{Flank, Sides};
use crate::numerics::extremes;
use crate::process::skiving::measuring::FlankTracks;
use std::f64::consts::TAU;

/// Pitch of the tooth centres and thickness at the middle track. mm, rad.
#[derive(Clone, Debug, PartialEq)]
pub struct Pitch {
    /// f_p,k: from each tooth's centre to the next one's.
    pub single: Vec<f64>,
    /// F_p,k: from tooth 0 to each tooth.
    pub cumulative: Vec<f64>,
    /// f_p,max.
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

/// Pitch from tooth position angles a' [rad].
pub fn pitch(flanks: &Sides<FlankTracks>, angles: &Deviations) -> Pitch {
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
    let harmonic = |wave: fn(f64) -> f64| {
        let sum: f64 = at.iter().enumerate().map(|(k, c)| c * wave(TAU * k as f64 / count as f64)).sum();
        2.0 / count as f64 * sum
    };
    let [least, greatest] = extremes(cumulative.iter().copied());
    Pitch {
        largest_single: extremes(single.iter().map(|x| x.abs()))[1],
        total: greatest - least,
        first_harmonic: [harmonic(f64::cos), harmonic(f64::sin)],
        thickness: of_track(middle, |a, b| a - b).into_iter().map(|x| x * radius).collect(),
        single,
        cumulative,
        centres,
    }
}
