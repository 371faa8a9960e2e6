//! Deviations of the dressing axes drawn at random: how far the dressed profile scatters
//! (`docs/mathematics/dressing.md#axes-and-their-deviations`). The same seed gives the same result on any number of threads. Knows no
//! measurement.

use crate::axes::deviation::{check_correction, sum};
use crate::{DressedProfile, DresserTool, DressingError};
use foundation::geometry::{Flank, Sides};
use foundation::kinematics::DressingCorrection;
use foundation::numerics::{Progress, equidistant};
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;
use rand_distr::{Distribution, StandardNormal, StandardUniform};
use rayon::prelude::*;

/// How the deviation of one axis scatters, rad or mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Spread {
    /// Normally with this standard deviation.
    Normal(f64),
    /// Evenly up to this amount in both directions.
    Uniform(f64),
}

/// What is drawn and how often.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spreads {
    /// d_phi_S, d_gamma, d_d, d_v_yA.
    pub axes: [Spread; 4],
    /// Number of draws.
    pub samples: usize,
    /// Seed; draw k depends on it and on k alone.
    pub seed: u64,
}

/// Quantiles of one quantity in the order of the levels asked for, mm normal.
#[derive(Clone, Debug, PartialEq)]
pub struct Quantiles {
    /// Largest absolute change of f over the used range.
    pub largest: Vec<f64>,
    /// Change of f over the used range by the mean line, end minus start.
    pub slope: Vec<f64>,
    /// Height of the mean parabola above its chord in the middle of the used range.
    pub crowning: Vec<f64>,
}

/// Scatter of both profiles, which the same draws make.
#[derive(Clone, Debug, PartialEq)]
pub struct SpreadOfProfile {
    /// Levels of the quantiles, 0 to 1.
    pub levels: Vec<f64>,
    /// Per flank.
    pub quantiles: Sides<Quantiles>,
}

/// Most draws: a profile takes some 20 us, so these some minutes.
const MOST_SAMPLES: usize = 10_000_000;
/// Points of a profile.
const POINTS: usize = 15;
/// Draws per parcel of work.
const PARCEL: usize = 64;

impl Spread {
    fn size(self) -> f64 {
        match self {
            Self::Normal(size) | Self::Uniform(size) => size,
        }
    }

    /// A draw; takes the same amount from the generator whatever the size.
    fn draw(self, random: &mut ChaCha8Rng) -> f64 {
        match self {
            Self::Normal(sigma) => {
                let x: f64 = StandardNormal.sample(random);
                sigma * x
            }
            Self::Uniform(half) => {
                let x: f64 = StandardUniform.sample(random);
                half * (2.0 * x - 1.0)
            }
        }
    }
}

/// Largest change, slope and crowning of one profile.
type Figures = [f64; 3];

/// Draws deviations from the correction `dk` and takes quantiles of what they do to the profiles of both flanks.
///
/// # Errors
/// [`DressingError::InvalidNumber`] for a negative or infinite spread, 0 or more than 10 million draws, levels that are absent or outside
/// 0..1; those of [`DressedProfile::at_roll`] for the first draw whose profile cannot be dressed.
pub fn spread_of_profile(
    tool: &DresserTool,
    dk: DressingCorrection,
    spreads: &Spreads,
    levels: &[f64],
    progress: &dyn Progress,
) -> Result<SpreadOfProfile, DressingError> {
    check(&dk, spreads, levels)?;
    let rolls = Sides::from_fn(|flank| {
        let range = tool.flanks[flank].range;
        equidistant([range.w_nf, range.w_na], POINTS)
    });
    let ideal = Sides::try_from_fn(|flank| f_of(tool, flank, dk, &rolls[flank]))?;
    progress.start("draws", spreads.samples as u64);
    let numbers: Vec<usize> = (0..spreads.samples).collect();
    let drawn: Result<Vec<Vec<Sides<Figures>>>, DressingError> = numbers
        .par_chunks(PARCEL)
        .map(|parcel| {
            let figures = parcel
                .iter()
                .map(|&k| {
                    let real = sum(&dk, &draw(spreads, k));
                    Sides::try_from_fn(|flank| {
                        let f = f_of(tool, flank, real, &rolls[flank])?;
                        let change: Vec<f64> = f.iter().zip(&ideal[flank]).map(|(f, g)| f - g).collect();
                        Ok(figures_of(&change))
                    })
                })
                .collect::<Result<Vec<_>, DressingError>>();
            progress.advance(parcel.len() as u64);
            figures
        })
        // Collected before the first error is taken, so that it is the same on any number of threads.
        .collect::<Vec<_>>()
        .into_iter()
        .collect();
    progress.finish();
    let drawn: Vec<Sides<Figures>> = drawn?.into_iter().flatten().collect();
    let quantiles = Sides::from_fn(|flank| {
        let of = |k: usize| quantiles(drawn.iter().map(|d| d[flank][k]).collect(), levels);
        Quantiles { largest: of(0), slope: of(1), crowning: of(2) }
    });
    Ok(SpreadOfProfile { levels: levels.to_vec(), quantiles })
}

fn check(dk: &DressingCorrection, spreads: &Spreads, levels: &[f64]) -> Result<(), DressingError> {
    check_correction("dressing correction", dk)?;
    let invalid = |field, value, allowed| Err(DressingError::InvalidNumber { field, value, allowed });
    for spread in spreads.axes {
        let size = spread.size();
        if !(size.is_finite() && size >= 0.0) {
            let field = match spread {
                Spread::Normal(_) => "standard deviation of an axis",
                Spread::Uniform(_) => "half width of the deviation of an axis",
            };
            return invalid(field, size, "finite numbers from 0 on");
        }
    }
    if spreads.samples == 0 || spreads.samples > MOST_SAMPLES {
        return invalid("number of draws", spreads.samples as f64, "1 to 10 million");
    }
    if levels.is_empty() {
        return invalid("number of quantiles", 0.0, "at least 1");
    }
    match levels.iter().find(|p| !(0.0..=1.0).contains(*p)) {
        Some(&value) => invalid("level of a quantile", value, "0 to 1"),
        None => Ok(()),
    }
}

/// Draw k: a stream of the generator of its own.
fn draw(spreads: &Spreads, k: usize) -> DressingCorrection {
    let mut random = ChaCha8Rng::seed_from_u64(spreads.seed);
    random.set_stream(k as u64);
    spreads.axes.map(|axis| axis.draw(&mut random))
}

fn f_of(
    tool: &DresserTool,
    flank: Flank,
    dk: DressingCorrection,
    w: &[f64],
) -> Result<Vec<f64>, DressingError> {
    Ok(DressedProfile::new(tool, flank, dk).at_rolls(w)?.iter().map(|at| at.f).collect())
}

/// Least-squares parabola a + b x + c (1 - x^2) over x = -1 .. 1 at equidistant points: slope 2 b, crowning c.
fn figures_of(f: &[f64]) -> Figures {
    let n = f.len() as f64;
    let x = |i: usize| 2.0 * i as f64 / (n - 1.0) - 1.0;
    let x2 = (0..f.len()).map(|i| x(i) * x(i)).sum::<f64>();
    // x^2 less its mean is orthogonal to 1 and to x.
    let bowed = |i: usize| x(i) * x(i) - x2 / n;
    let bowed2 = (0..f.len()).map(|i| bowed(i) * bowed(i)).sum::<f64>();
    let along = |g: &dyn Fn(usize) -> f64| f.iter().enumerate().map(|(i, f)| f * g(i)).sum::<f64>();
    let largest = f.iter().fold(0.0_f64, |m, f| m.max(f.abs()));
    [largest, 2.0 * along(&x) / x2, -along(&bowed) / bowed2]
}

/// Quantiles with linear interpolation between the ordered values.
fn quantiles(mut values: Vec<f64>, levels: &[f64]) -> Vec<f64> {
    values.sort_by(f64::total_cmp);
    let last = values.len() - 1;
    let at = |level: &f64| {
        let place = level * last as f64;
        let k = (place.floor() as usize).min(last);
        let next = (k + 1).min(last);
        values[k] + (place - k as f64) * (values[next] - values[k])
    };
    levels.iter().map(at).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn slope_and_crowning_of_a_parabola_are_its_own() {
        let f: Vec<f64> = (0..POINTS)
            .map(|i| {
                let x = 2.0 * i as f64 / (POINTS - 1) as f64 - 1.0;
                0.3 + 0.5 * x + 0.7 * (1.0 - x * x)
            })
            .collect();
        let [largest, slope, crowning] = figures_of(&f);
        assert!((slope - 1.0).abs() < 1e-14 && (crowning - 0.7).abs() < 1e-14, "{slope} {crowning}");
        assert_eq!(largest, f.iter().copied().fold(0.0, f64::max));
    }

    #[test]
    fn quantiles_are_interpolated() {
        assert_eq!(quantiles(vec![3.0, 1.0, 2.0], &[0.0, 0.25, 0.5, 1.0]), [1.0, 1.5, 2.0, 3.0]);
        assert_eq!(quantiles(vec![4.0], &[0.0, 0.9]), [4.0, 4.0]);
    }

    /// Moments of many draws; each has the same stream whatever is drawn before it.
    #[test]
    fn draws_have_the_spread_asked_for() {
        let axes = [Spread::Normal(2.0), Spread::Uniform(3.0), Spread::Normal(0.0), Spread::Uniform(0.0)];
        let spreads = Spreads { axes, samples: 20_000, seed: 7 };
        let draws: Vec<_> = (0..spreads.samples).map(|k| draw(&spreads, k)).collect();
        let n = draws.len() as f64;
        for (j, sigma) in [(0, 2.0), (1, 3.0 / 3f64.sqrt())] {
            let mean = draws.iter().map(|d| d[j]).sum::<f64>() / n;
            let variance = draws.iter().map(|d| d[j] * d[j]).sum::<f64>() / n;
            assert!(mean.abs() < 4.0 * sigma / n.sqrt(), "{mean}");
            assert!((variance.sqrt() / sigma - 1.0).abs() < 0.02, "{variance}");
        }
        assert!(draws.iter().all(|d| d[2] == 0.0 && d[3] == 0.0 && d[1].abs() <= 3.0));
        assert_eq!(draw(&spreads, 11), draws[11]);
    }
}
