//! The worm of a job that wants a worm topography: what is wanted, what the referee's rays found under the dresser, and its item of the
//! verdict.

use super::execution::Execution;
use super::prepare::Prepared;
use super::referee;
use foundation::geometry::{Flank, Sides};
use foundation::numerics::{equidistant, extremes};
use schemars::JsonSchema;
use serde::Serialize;
use std::collections::BTreeMap;
use verdict::{Remark, Verdict};

/// Points over the profile and along the worm.
const POINTS: [usize; 2] = [41, 81];

/// One flank of the worm over the part of it that grinds.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct WormFlankResult {
    /// Lengths of roll of the worm.
    pub w_mm: Vec<f64>,
    /// Positions along the worm.
    pub z_mm: Vec<f64>,
    /// What is wanted, normal, positive = material left, `[profile][length]`.
    pub wanted_um: Vec<Vec<f64>>,
    /// What the referee's rays left under the dresser, normal.
    pub simulated_um: Vec<Vec<f64>>,
    /// Largest |simulated - wanted| without what is the same everywhere: that is thread thickness and place, which the infeed sets.
    pub max_deviation_um: f64,
    /// Mean of simulated - wanted.
    pub mean_deviation_um: f64,
}

/// The flanks of a wanted worm that grind; nothing for a job whose target is a gear.
pub fn worm_flanks(
    prepared: &Prepared,
    execution: &Execution,
    verdicts: &Sides<Option<referee::Verdict>>,
) -> BTreeMap<&'static str, WormFlankResult> {
    let Some(wanted) = &prepared.setup.wanted_worm else { return BTreeMap::new() };
    let of_flank = |flank: Flank| {
        let (executed, verdict) = (execution.flanks[flank].as_ref()?, verdicts[flank].as_ref()?);
        let made = verdict.worm(&executed.tool)?;
        let lines = &prepared.setup.lines[flank];
        let shift = &execution.motion.shift;
        let within = |[from, to]: [f64; 2], [least, most]: [f64; 2]| [from.max(least), to.min(most)];
        let [known_w, known_z] = made.domain();
        let w_mm = equidistant(within(lines.worm_rolls(shift), known_w), POINTS[0]);
        let z_mm = equidistant(within(lines.occupation(shift), known_z), POINTS[1]);
        let rows = |value: &dyn Fn(f64, f64) -> Option<f64>| -> Option<Vec<Vec<f64>>> {
            w_mm.iter().map(|&w| z_mm.iter().map(|&z| Some(value(w, z)? * 1e3)).collect()).collect()
        };
        let wanted_um = rows(&|w, z| Some(wanted[flank].value(w, z).ok()? * lines.cos_b1))?;
        let simulated_um = rows(&|w, z| Some(made.value(w, z)))?;
        let off: Vec<f64> =
            simulated_um.iter().flatten().zip(wanted_um.iter().flatten()).map(|(s, w)| s - w).collect();
        let mean_deviation_um = off.iter().sum::<f64>() / off.len() as f64;
        let [least, most] = extremes(off);
        let max_deviation_um = f64::max(most - mean_deviation_um, mean_deviation_um - least);
        let result =
            WormFlankResult { w_mm, z_mm, wanted_um, simulated_um, max_deviation_um, mean_deviation_um };
        Some((flank.name(), result))
    };
    Flank::BOTH.into_iter().filter_map(of_flank).collect()
}

/// Judges the flanks of a wanted worm by the tolerance of the job.
pub fn judge_worm(verdict: &mut Verdict, worm: &BTreeMap<&'static str, WormFlankResult>, tolerance_um: f64) {
    for (name, flank) in worm {
        let off = flank.max_deviation_um;
        let detail = format!("{off:.4} of {tolerance_um} um");
        verdict.judge(format!("{name} flank of the worm"), off <= tolerance_um, detail, || {
            not_dressed(name, off)
        });
    }
}

fn not_dressed(name: &str, off: f64) -> Remark {
    Remark::new(
        "worm-not-dressed",
        format!("the dresser leaves {off:.3} um between the {name} flank of the worm and the wanted one"),
        "let the profile change less along the worm, take a worm with more threads or a smaller dresser, or write the worm by a disc in point contact (dresser.contact = \"point\")",
    )
}

/// Why the gear of a wanted worm is missed: it is as far off as the worm is.
pub fn gear_missed(worm: &BTreeMap<&'static str, WormFlankResult>) -> Remark {
    let worst = worm.iter().max_by(|a, b| a.1.max_deviation_um.total_cmp(&b.1.max_deviation_um));
    worst.map_or_else(|| not_dressed("", 0.0), |(name, flank)| not_dressed(name, flank.max_deviation_um))
}
