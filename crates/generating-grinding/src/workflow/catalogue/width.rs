//! Profile crowning at positions over the face width: what a target wants there, what a plan makes, and which crownings a pair can make
//! at all. A crowning counts as everywhere in the catalogue: over the whole involute, transverse. Knows no ranking.

use super::task::Task;
use crate::workflow::result::FlankResult;
use dressing::catalogue::{DesignedDresser, PairFigures};
use dressing::{CrowningLimits, CrowningRows};
use foundation::geometry::{Flank, Sides};
use foundation::modification::{EvaluationField, Modification};
use foundation::numerics::{equidistant, extremes};
use generating::GeneratingError;
use schemars::JsonSchema;
use serde::Serialize;

/// Points of a profile that a parabola is fitted to.
const POINTS: usize = 41;

/// Crownings that a target wants over the width.
pub struct CrowningOverWidth {
    /// Positions z of the gear, mm, ascending.
    pub positions: Vec<f64>,
    /// Crowning at each of them of the flanks that are ground, mm.
    pub wanted: Sides<Option<Vec<f64>>>,
}

/// The crowning at one position over the width.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct CrowningAt {
    /// Position z of the gear.
    pub z_mm: f64,
    /// Profile crowning that the target wants there.
    pub wanted_um: f64,
    /// Profile crowning that the plan makes there; absent where there is none.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub made_um: Option<f64>,
}

/// Crownings of a flank that a pair can make within the limits of the axes, whatever the target wants.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct PairRange {
    /// The least one.
    pub least_um: f64,
    /// The largest one.
    pub largest_um: f64,
    /// Whether the least and the largest crowning that the target wants over the width lie within.
    pub serves_the_width: bool,
}

/// Height of the least-squares parabola through values at equidistant places: positive where the middle stands above the ends. 0 for
/// fewer than three.
fn parabola(values: &[f64]) -> f64 {
    let n = values.len();
    if n < 3 {
        return 0.0;
    }
    // u^2 less its mean is orthogonal to 1 and, on places that lie evenly about 0, to u.
    let squares: Vec<f64> = equidistant([-1.0, 1.0], n).into_iter().map(|u| u * u).collect();
    let mean = squares.iter().sum::<f64>() / n as f64;
    let (above, below) = squares
        .iter()
        .zip(values)
        .fold((0.0, 0.0), |(a, b), (s, f)| (a + (s - mean) * f, b + (s - mean) * (s - mean)));
    -above / below
}

impl CrowningOverWidth {
    /// Of the wanted flanks; `involute` is the length of roll from form to tip by flank, mm.
    ///
    /// # Errors
    /// A target that has no value at a position.
    pub fn of_target(
        positions: Vec<f64>,
        fields: &Sides<EvaluationField>,
        targets: &Sides<Option<Modification>>,
        involute: &Sides<f64>,
    ) -> Result<Self, GeneratingError> {
        let wanted = Sides::try_from_fn(|flank: Flank| -> Result<_, GeneratingError> {
            let Some(target) = &targets[flank] else { return Ok(None) };
            let roll = fields[flank].roll();
            let share = (involute[flank] / (roll[1] - roll[0])).powi(2);
            let at = |&z: &f64| -> Result<f64, GeneratingError> {
                let values: Result<Vec<f64>, _> =
                    equidistant(roll, POINTS).into_iter().map(|w| target.value(w, z)).collect();
                Ok(share * parabola(&values?))
            };
            positions.iter().map(at).collect::<Result<_, _>>().map(Some)
        })?;
        Ok(Self { positions, wanted })
    }

    /// The same beside what a flank was made to: `cos` is that of the gear's base helix angle, `involute` the length of roll from form to
    /// tip.
    pub fn made(&self, flank: Flank, result: &FlankResult, cos: f64, involute: f64) -> Vec<CrowningAt> {
        let (w, z) = (&result.w_mm, &result.z_mm);
        let share = (involute / (w[w.len() - 1] - w[0])).powi(2);
        let made = |at: f64| {
            let k = z.partition_point(|&z| z < at).clamp(1, z.len() - 1);
            let part = (at - z[k - 1]) / (z[k] - z[k - 1]);
            let profile = result.simulated_um.iter().map(|row| row[k - 1] + part * (row[k] - row[k - 1]));
            share * parabola(&profile.collect::<Vec<_>>()) / cos
        };
        let wanted = self.wanted[flank].iter().flatten();
        self.positions
            .iter()
            .zip(wanted)
            .map(|(&z_mm, wanted)| CrowningAt { z_mm, wanted_um: wanted * 1e3, made_um: Some(made(z_mm)) })
            .collect()
    }

    /// Wanted crownings of a flank alone.
    pub fn at(&self, flank: Flank) -> Vec<CrowningAt> {
        let wanted = self.wanted[flank].iter().flatten();
        let at = |(&z_mm, wanted): (&f64, &f64)| CrowningAt { z_mm, wanted_um: wanted * 1e3, made_um: None };
        self.positions.iter().zip(wanted).map(at).collect()
    }
}

/// The range of crownings of each flank of a pair whose figures are known; nothing where the corrections of the figures are beyond the
/// limits already.
pub fn ranges(
    task: &Task,
    over: &CrowningOverWidth,
    pair: (usize, usize),
    designed: &DesignedDresser,
    figures: &PairFigures,
) -> Sides<Option<PairRange>> {
    let (worm, dresser) = (&task.worms[pair.0], &task.dressers[pair.1]);
    let Ok(seat) = worm.seat(&task.workshop, dresser.size) else { return Sides::both(None) };
    let Ok(tool) = designed.tool.on_worm(&seat) else { return Sides::both(None) };
    let axes = task.limits.correction.map(|limit| [-limit, limit]);
    Sides::from_fn(|flank| {
        let found = figures.flanks[flank]?;
        let middle = -found.crowning * task.wanted.cos_base_helix[flank];
        let helix = task.workshop.gear.flank(flank).base_helix_angle;
        let rows = CrowningRows::new(&tool.flanks[flank], seat.reference_radius(), helix)
            .from_start(found.fit.dk, [0.0, middle, 0.0]);
        let range = rows.range(&CrowningLimits { axes: Some(axes), margin: None }).ok()?;
        // The path counts from the crowning of the figures, the gear has that of the dresser too.
        let asked = found.crowning + dresser.crowning[flank];
        let [least, largest] = [range.smallest, range.largest].map(|end| asked + end.crowning);
        let [from, to] = extremes(over.wanted[flank].iter().flatten().copied());
        Some(PairRange {
            least_um: least * 1e3,
            largest_um: largest * 1e3,
            serves_the_width: least <= from && to <= largest,
        })
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_parabola_keeps_its_height_beside_value_and_slope() {
        let values: Vec<f64> =
            equidistant([-1.0, 1.0], 9).into_iter().map(|u| 3.0 + 2.0 * u - 5.0 * u * u).collect();
        assert!((parabola(&values) - 5.0).abs() < 1e-12);
        assert_eq!(parabola(&values[..2]), 0.0);
    }
}
