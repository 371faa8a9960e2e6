//! How much the rounding of every edge has grown, from the deviations that remain without mounting: least squares of
//! f = shift + drho growth_at(theta) over the tracks of an edge.
//!
//! The factor growth_at differs little from track to track (-0.154 to -0.157 on the spur tool of
//! `docs/mathematics/skiving.md#how-it-is-verified`): a shift and a growth are distinguished only where its spread does more than the noise.
//! Where it does not, all is taken for growth. Then errors of grinding count as growth, some six times as large, unless the deviations are
//! those since the tool was fresh.

use super::WearError;
use super::growth_model::{Edge, Model};
use crate::evaluation::Deviations;
use crate::measuring::FlankTracks;
use foundation::geometry::{Flank, Sides};

/// What a tooth's position is taken for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ToothPositions {
    /// An error of pitch. For a single measurement. Both edges of a tooth then count as grown alike, by what makes it thinner.
    Pitch,
    /// Wear, as when the deviations are those since the tool was fresh ([`worn_since`]). The clocking of the tool is not known: it is
    /// taken so that left and right edges have grown alike in the mean of all teeth.
    Wear,
}

/// How growth is found.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GrowthOptions {
    /// What a tooth's position is taken for.
    pub positions: ToothPositions,
    /// Standard deviation of every deviation, mm.
    pub sigma: f64,
    /// Standard deviation of the growth up to which a shift is distinguished from it, mm.
    pub resolution: f64,
}

/// What the deviations were shared out to.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Attribution {
    /// A shift and a growth for every edge.
    ShiftAndGrowth,
    /// Growth alone: with a shift beside it the growth would be too uncertain.
    GrowthAlone {
        /// Standard deviation of the growth beside a shift on the worse flank, mm; infinite where the factor is the same on all tracks.
        deviation_with_shift: f64,
    },
}

/// Growth of every edge. mm.
#[derive(Clone, Debug, PartialEq)]
pub struct Growths {
    /// drho of each tooth; < 0 where material stands out.
    pub growth: Sides<Vec<f64>>,
    /// Standard deviation of each from the noise of the measurement.
    pub deviation: Sides<f64>,
    /// Root of the mean square of what shift and growth leave of each tooth's deviations.
    pub residual: Sides<Vec<f64>>,
    /// What the deviations were shared out to.
    pub attribution: Attribution,
}

/// Deviations that came since the tool was fresh, both without clocking and mounting.
///
/// # Errors
/// [`WearError::OtherShape`] for another number of tracks or teeth.
pub fn worn_since(fresh: &Deviations, now: &Deviations) -> Result<Deviations, WearError> {
    for flank in Flank::BOTH {
        let (a, b) = (&fresh.of[flank], &now.of[flank]);
        same("tracks", b.len(), a.len())?;
        a.iter().zip(b).try_for_each(|(a, b)| same("teeth", b.len(), a.len()))?;
    }
    Ok(now.map(|flank, track, tooth, f| f - fresh.of[flank][track][tooth]))
}

/// Growth of the rounding of every edge from what remains of the deviations without clocking and mounting.
///
/// # Errors
/// [`WearError::InvalidNumber`], [`WearError::OtherShape`].
pub fn edge_growths(
    flanks: &Sides<FlankTracks>,
    remaining: &Deviations,
    options: &GrowthOptions,
) -> Result<Growths, WearError> {
    check(flanks, remaining, options)?;
    let model = Model::new(flanks)?;
    let with_shift = model.deviation_with_shift(options.sigma);
    let deviation_with_shift = with_shift.left.max(with_shift.right);
    let shares = |tooth: usize| -> Sides<Vec<f64>> {
        remaining.of.map(|_, tracks| tracks.iter().map(|row| row[tooth]).collect())
    };
    let teeth: Vec<Sides<Vec<f64>>> = (0..remaining.teeth()).map(shares).collect();
    let (solved, deviation, attribution) = if deviation_with_shift <= options.resolution {
        (model.with_shifts(&teeth), with_shift, Attribution::ShiftAndGrowth)
    } else {
        let (solved, unit) = match options.positions {
            ToothPositions::Pitch => model.with_positions(&teeth),
            ToothPositions::Wear => model.with_clocking(&teeth),
        };
        let attribution = Attribution::GrowthAlone { deviation_with_shift };
        (solved, unit.map(|_, unit| options.sigma * unit), attribution)
    };
    let each = |flank: Flank, of: fn(&Edge) -> f64| solved.iter().map(|tooth| of(&tooth[flank])).collect();
    Ok(Growths {
        growth: Sides::from_fn(|flank| each(flank, |edge| edge.growth)),
        deviation,
        residual: Sides::from_fn(|flank| each(flank, |edge| edge.residual)),
        attribution,
    })
}

fn check(
    flanks: &Sides<FlankTracks>,
    remaining: &Deviations,
    options: &GrowthOptions,
) -> Result<(), WearError> {
    for (field, value) in [("sigma", options.sigma), ("resolution", options.resolution)] {
        if !(value.is_finite() && value > 0.0) {
            return Err(WearError::InvalidNumber { field, value, allowed: "> 0 mm" });
        }
    }
    for (flank, of) in flanks.iter() {
        same("tracks", remaining.of[flank].len(), of.tracks.len())?;
        remaining.of[flank].iter().try_for_each(|row| same("teeth", row.len(), remaining.teeth()))?;
    }
    match remaining.iter().find(|(.., f)| !f.is_finite()) {
        None => Ok(()),
        Some((.., value)) => {
            Err(WearError::InvalidNumber { field: "deviation", value, allowed: "finite numbers" })
        }
    }
}

fn same(field: &'static str, found: usize, wanted: usize) -> Result<(), WearError> {
    if found == wanted { Ok(()) } else { Err(WearError::OtherShape { field, found, wanted }) }
}
