//! Which teeth are broken: found before anything is averaged, so that up to a third of the teeth, chipped by whatever amount and
//! wherever they stand, bend nothing.
//!
//! On one track of one flank a whole tooth differs from the mean by the mounting alone, a wave of one period around the tool, and by its
//! own small errors. So the wave that fits half of the teeth closest is the start (least trimmed squares, from waves through three teeth
//! each); whatever lies further from it than chance explains is an outlier.

use super::{Deviations, Mounting};
use crate::measuring::{FlankTracks, Noise};
use foundation::geometry::{Flank, Sides};
use foundation::numerics::{Harmonic, root_mean_square, student_quantile};
use nalgebra::{Matrix3, Vector3};
use std::f64::consts::TAU;

/// A distance below which no tooth is an outlier, mm: linear evaluation and small errors of grinding
/// (`docs/mathematics/skiving.md#evaluation`).
const SURE: f64 = 1e-3;
/// Probability with which any tooth of a whole tool is taken for a broken one, over all teeth, tracks and flanks.
const FAMILY: f64 = 1e-3;
/// Triples of teeth that are tried; with a third of the teeth broken, no triple of whole teeth among them has a probability of 1e-12.
const TRIPLES: usize = 240;
/// Share of the greatest determinant that a triple must have: teeth side by side tell no wave.
const SPREAD: f64 = 0.15;
/// Starts that are refined, and steps of that.
const STARTS: usize = 8;
const STEPS: usize = 20;
/// Standard deviations that make an outlier however few the teeth are.
const CERTAIN: f64 = 10.0;
/// Fewer teeth do not tell which of them are whole.
const FEWEST: usize = 8;
/// Standard deviations per median of the absolute values.
const OF_MEDIAN: f64 = 1.4826;
/// First number of the triples' random sequence.
const SEED: u64 = 60;

/// The outliers.
#[derive(Clone, Debug, Default)]
pub(super) struct StandingOut {
    /// Teeth, ascending.
    pub teeth: Vec<usize>,
    /// Which of their edges do, the left flank first, teeth ascending.
    pub edges: Vec<(Flank, usize)>,
}

/// The outliers among the teeth with `present`.
pub(super) fn standing_out(deviations: &Deviations, present: &[bool]) -> StandingOut {
    let waves = Waves::new(deviations);
    let there: Vec<usize> = (0..present.len()).filter(|&tooth| present[tooth]).collect();
    if there.len() < FEWEST {
        return StandingOut::default();
    }
    let Some(start) = waves.closest_half(&there) else { return StandingOut::default() };
    let Kept { teeth, far } = waves.kept(&there, start);
    // Rows are those of the left flank first.
    let left = deviations.of.left.len();
    let edge = |(row, tooth): (usize, usize)| (if row < left { Flank::Left } else { Flank::Right }, tooth);
    StandingOut {
        teeth: there.into_iter().filter(|tooth| !teeth.contains(tooth)).collect(),
        edges: in_order(far.into_iter().map(edge)),
    }
}

/// Each edge once, the left flank first, teeth ascending.
fn in_order(edges: impl Iterator<Item = (Flank, usize)>) -> Vec<(Flank, usize)> {
    let mut edges: Vec<(Flank, usize)> = edges.collect();
    edges.sort_by_key(|(flank, tooth)| (*flank == Flank::Right, *tooth));
    edges.dedup();
    edges
}

/// The teeth that `docs/mathematics/skiving.md#evaluation` leaves out of the mounting: with a residual of the fit to all teeth beyond 3.5
/// standard deviations, these from the median, unless that is more than a quarter of them. It takes the random errors of some whole teeth
/// for damage, and finds nothing where many are broken.
pub(super) fn beyond_median(
    flanks: &Sides<FlankTracks>,
    deviations: &Deviations,
    all: &Mounting,
) -> StandingOut {
    let teeth = deviations.teeth();
    let residuals = deviations.map(|flank, track, tooth, f| {
        f - all.rigid_part(&flanks[flank].tracks[track].0, tooth, teeth) - all.constants[flank][track]
    });
    let limit =
        SURE.max(3.5 * OF_MEDIAN * median(&mut residuals.iter().map(|(.., r)| r.abs()).collect::<Vec<_>>()));
    let far = residuals.iter().filter(|(.., residual)| residual.abs() > limit);
    let edges = in_order(far.map(|(flank, _, tooth, _)| (flank, tooth)));
    let far = |tooth: usize| edges.iter().any(|(_, of)| *of == tooth);
    let found: Vec<usize> = (0..teeth).filter(|&tooth| far(tooth)).collect();
    if found.len() > teeth / 4 {
        return StandingOut::default();
    }
    StandingOut { teeth: found, edges }
}

/// All rows of a measurement over the same teeth.
struct Waves<'a> {
    rows: Vec<&'a [f64]>,
    /// 1, cos, sin of every tooth.
    basis: Vec<Vector3<f64>>,
}

impl<'a> Waves<'a> {
    fn new(deviations: &'a Deviations) -> Self {
        let rows = Flank::BOTH.into_iter().flat_map(|flank| deviations.of[flank].iter().map(Vec::as_slice));
        let teeth = deviations.teeth();
        let basis = |tooth: usize| Harmonic::row(TAU * tooth as f64 / teeth as f64);
        Self { rows: rows.collect(), basis: (0..teeth).map(basis).collect() }
    }

    /// Least squares on each row over some teeth, and the inverse normal matrix.
    fn fit(&self, teeth: &[usize]) -> Option<(Vec<Vector3<f64>>, Matrix3<f64>)> {
        let fit = Harmonic::over(teeth.iter().map(|&k| self.basis[k]))?;
        let of_row = |row: &&[f64]| fit.through(teeth.iter().map(|&k| (self.basis[k], row[k])));
        Some((self.rows.iter().map(of_row).collect(), fit.inverse))
    }

    fn off(&self, waves: &[Vector3<f64>], row: usize, tooth: usize) -> f64 {
        self.rows[row][tooth] - waves[row].dot(&self.basis[tooth])
    }

    /// The teeth nearest to some waves, each by its worst row, and the sum of their squares.
    fn nearest(&self, waves: &[Vector3<f64>], there: &[usize], count: usize) -> (Vec<usize>, f64) {
        let worst = |tooth: usize| {
            (0..self.rows.len()).map(|row| self.off(waves, row, tooth).abs()).fold(0.0, f64::max)
        };
        let mut all: Vec<(f64, usize)> = there.iter().map(|&tooth| (worst(tooth), tooth)).collect();
        all.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        all.truncate(count);
        let sum = all.iter().map(|(off, _)| off * off).sum();
        (all.into_iter().map(|(_, tooth)| tooth).collect(), sum)
    }

    /// Half of the teeth, and what a wave needs beside, that lie closest to waves of their own.
    fn closest_half(&self, there: &[usize]) -> Option<Vec<usize>> {
        let half = (there.len() + 4) / 2;
        let mut random = Noise::new(SEED);
        let mut starts: Vec<(Vec<usize>, f64)> = Vec::new();
        let mut tried = 0;
        // Every second triple at least is spread widely enough.
        for _ in 0..10 * TRIPLES {
            let mut pick = || there[((random.uniform() * there.len() as f64) as usize).min(there.len() - 1)];
            let triple = [pick(), pick(), pick()];
            let columns = triple.map(|tooth| self.basis[tooth]);
            // An even triple has the greatest determinant, 3/2 of the root of 3.
            if Matrix3::from_columns(&columns).determinant().abs() < SPREAD * 1.5 * 3f64.sqrt() {
                continue;
            }
            if let Some((waves, _)) = self.fit(&triple) {
                starts.push(self.nearest(&waves, there, half));
            }
            tried += 1;
            if tried == TRIPLES {
                break;
            }
        }
        starts.push((there.to_vec(), f64::INFINITY));
        starts.sort_by(|a, b| a.1.total_cmp(&b.1));
        starts.truncate(STARTS);
        let refined = starts.into_iter().filter_map(|(mut teeth, mut sum)| {
            for _ in 0..STEPS {
                let (waves, _) = self.fit(&teeth)?;
                let (closer, less) = self.nearest(&waves, there, half);
                if less >= sum {
                    break;
                }
                (teeth, sum) = (closer, less);
            }
            Some((teeth, sum))
        });
        refined.min_by(|a, b| a.1.total_cmp(&b.1)).map(|(teeth, _)| teeth)
    }

    /// The teeth that chance explains, from a start of whole ones.
    fn kept(&self, there: &[usize], start: Vec<usize>) -> Kept {
        let mut fitted = start;
        let mut measure = there.to_vec();
        let mut kept = there.to_vec();
        let mut far = Vec::new();
        for _ in 0..STEPS {
            let Some((waves, inverse)) = self.fit(&fitted) else { break };
            let sigma: Vec<f64> = (0..self.rows.len())
                .map(|row| scatter(measure.iter().map(|&k| self.off(&waves, row, k).abs()).collect()))
                .collect();
            let freedom = measure.len().saturating_sub(3).max(1) as f64;
            let tests = (there.len() * self.rows.len()) as f64;
            let factor = student_quantile(1.0 - FAMILY / tests, freedom).min(CERTAIN);
            let is_far = |row: usize, tooth: usize| {
                let lever = self.basis[tooth].dot(&(inverse * self.basis[tooth]));
                let limit = SURE.max(factor * sigma[row] * (1.0 + lever).sqrt());
                self.off(&waves, row, tooth).abs() > limit
            };
            far = (0..self.rows.len())
                .flat_map(|row| there.iter().map(move |&tooth| (row, tooth)))
                .filter(|&(row, tooth)| is_far(row, tooth))
                .collect();
            let whole = |tooth: usize| far.iter().all(|&(_, of)| of != tooth);
            let next: Vec<usize> = there.iter().copied().filter(|&tooth| whole(tooth)).collect();
            if next == kept && fitted == kept {
                break;
            }
            kept.clone_from(&next);
            fitted.clone_from(&next);
            measure = next;
        }
        Kept { teeth: kept, far }
    }
}

/// The teeth that chance explains, and rows and teeth that it does not.
struct Kept {
    teeth: Vec<usize>,
    far: Vec<(usize, usize)>,
}

/// Standard deviation of distances of which a third may be anything: by their median, which does not ask for the rest, and by the root of
/// the mean square of those within three of it, which is surer; the larger, since a low one would make outliers of whole teeth.
fn scatter(mut off: Vec<f64>) -> f64 {
    let by_median = OF_MEDIAN * median(&mut off);
    let near: Vec<f64> = off.into_iter().filter(|off| *off <= 3.0 * by_median).collect();
    by_median.max(root_mean_square(&near))
}

/// The middle value; sorts them.
fn median(values: &mut [f64]) -> f64 {
    if values.is_empty() {
        return 0.0;
    }
    values.sort_by(f64::total_cmp);
    let half = values.len() / 2;
    if values.len() % 2 == 1 { values[half] } else { 0.5 * (values[half - 1] + values[half]) }
}
