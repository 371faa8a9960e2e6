//! One worm over its life: a plan with its referee for each of its diameters, all dressed by the dresser that was made for the new worm
//! (`docs/mathematics/grinding-technology.md#one-worm-over-its-life`). Knows no user interface.

mod dresser;
pub mod files;
mod worn;

pub use files::write_worm_life;

use super::explore::Refused;
use super::run::{Outcome, plan_job};
use crate::job::{LoadedJob, Settings, WormLifeStudy};
use dresser::with_dresser_of;
use foundation::geometry::{Flank, Sides};
use foundation::numerics::{Progress, Silent};
use job::{Diagnostic, Problem, shown_number};
use rayon::prelude::*;
use report::PageHead;
use run::{Conclusion, JobTitle, RunFailure, TaskOutcome, WriteError};
use schemars::JsonSchema;
use serde::Serialize;
use std::path::{Path, PathBuf};
use verdict::{Remark, Status, Verdict};
use worn::first_tip_diameter;
pub(super) use worn::{plain, worn};

/// Halvings between the last diameter that meets the target and the first one that does not.
const HALVINGS: usize = 5;

/// What a study found: the document of `explore.json`.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct WormLifeOutcome {
    /// Head of its page.
    #[serde(skip)]
    pub head: PageHead,
    /// Name of the job.
    pub job: String,
    /// Process.
    pub process: String,
    /// Version of flankwright.
    pub version: &'static str,
    /// Tolerance of the job, the tightest of its map.
    pub tolerance_um: f64,
    /// Least tip diameter at which the target is met, and at every larger one that was planned; absent where the new worm misses it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub last_usable_tip_diameter_mm: Option<f64>,
    /// Whether that is the last diameter of the study: nothing ends the life before.
    pub whole_life: bool,
    /// Diameters from the new worm down, those between that look for the last usable one included.
    pub worms: Vec<WormOfLife>,
}

/// The worm at one diameter.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct WormOfLife {
    /// Tip diameter.
    pub tip_diameter_mm: f64,
    /// What the plan at this diameter comes to; absent where there is none.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub plan: Option<PlanOfLife>,
    /// Why there is none.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub refused: Option<Refused>,
}

/// A plan for one diameter.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct PlanOfLife {
    /// Whether the target is met.
    pub status: Status,
    /// Why it is not met.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub reason: Option<Remark>,
    /// Largest deviation from the target by the referee, normal, of the flank that has more.
    pub deviation_um: f64,
    /// Least determinant ratio of the envelope.
    pub least_determinant_ratio: f64,
    /// Pitch diameter of the worm.
    pub worm_pitch_diameter_mm: f64,
    /// Diagonal ratio.
    pub diagonal_ratio: f64,
    /// Crossed-axes angle of worm and gear.
    pub crossed_axes_angle_deg: f64,
    /// Centre distance of worm and gear.
    pub centre_distance_mm: f64,
    /// Length of the worm that is used.
    pub used_width_mm: f64,
    /// Speed of the worm for the cutting speed of the job.
    pub worm_speed_rpm: f64,
    /// Corrections of dressing in the middle of the stroke, of each flank; null for a flank that is not dressed.
    pub dressing: Sides<Option<DressingOfLife>>,
    /// Settings of machine and dresser, for `[settings]` of a job with this worm.
    pub settings: Settings,
}

/// Corrections of dressing against the nominal kinematics.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct DressingOfLife {
    /// Worm angle.
    #[serde(rename = "d_phi_S_deg")]
    pub d_phi_s_deg: f64,
    /// Crossing angle.
    pub d_gamma_deg: f64,
    /// Centre distance.
    pub d_d_mm: f64,
    /// Offset.
    #[serde(rename = "d_v_yA_mm")]
    pub d_v_ya_mm: f64,
}

impl WormOfLife {
    /// Whether the target is met.
    pub fn is_met(&self) -> bool {
        self.plan.as_ref().is_some_and(|plan| plan.status == Status::Met)
    }
}

/// Plans the diameters of a job's worm.
///
/// # Errors
/// [`RunFailure`]: what is wrong with the job as it stands; a last diameter that is not below the first.
pub fn study_worm_life(
    loaded: &LoadedJob,
    study: WormLifeStudy,
    progress: &dyn Progress,
) -> Result<WormLifeOutcome, RunFailure> {
    let new = plain(loaded);
    let first = first_tip_diameter(&new)?;
    let last = study.last_tip_diameter;
    if last >= first {
        let finding = Diagnostic::new(Problem::InvalidNumber, "the last worm is no smaller than the new one")
            .field("explore.worm_life.last_tip_diameter")
            .value(shown_number(last))
            .allowed(format!("below {first:.3} mm, the tip diameter of [worm]"))
            .way_out("give the tip diameter at which the worm is worn out");
        return Err(RunFailure::bad_input(finding));
    }
    progress.start("diameters", (study.count + HALVINGS) as u64);
    let outcome = plan_job(&new, &Silent)?;
    progress.advance(1);
    let with_dresser = with_dresser_of(&new, &outcome, first);
    let tolerance_um = outcome.result.tolerance_um;
    let mut worms = vec![of_outcome(first, &outcome)];
    let at = |tip_diameter: f64| {
        let planned = plan_job(&worn(&with_dresser, tip_diameter), &Silent);
        progress.advance(1);
        match planned {
            Ok(outcome) => of_outcome(tip_diameter, &outcome),
            Err(failure) => WormOfLife {
                tip_diameter_mm: tip_diameter,
                plan: None,
                refused: Some(Refused::from(failure)),
            },
        }
    };
    let steps = study.count - 1;
    let diameter = |k: usize| first + (last - first) * k as f64 / steps as f64;
    worms.extend((1..=steps).into_par_iter().map(|k| at(diameter(k))).collect::<Vec<_>>());
    let met = worms.iter().take_while(|worm| worm.is_met()).count();
    let whole_life = met == worms.len();
    let mut usable = met.checked_sub(1).map(|k| worms[k].tip_diameter_mm);
    if let (Some(good), Some(bad)) = (&mut usable, worms.get(met).map(|worm| worm.tip_diameter_mm)) {
        let mut bad = bad;
        for _ in 0..HALVINGS {
            let between = at(0.5 * (*good + bad));
            if between.is_met() {
                *good = between.tip_diameter_mm;
            } else {
                bad = between.tip_diameter_mm;
            }
            worms.push(between);
        }
    }
    progress.finish();
    worms.sort_by(|a, b| b.tip_diameter_mm.total_cmp(&a.tip_diameter_mm));
    let title = JobTitle::new(&loaded.job.job, loaded.job.output.language);
    Ok(WormLifeOutcome {
        head: title.head("Generating grinding, one worm over its life"),
        job: loaded.job.job.name.clone(),
        process: loaded.job.job.process.name().to_string(),
        version: env!("CARGO_PKG_VERSION"),
        tolerance_um,
        last_usable_tip_diameter_mm: usable,
        whole_life,
        worms,
    })
}

fn of_outcome(tip_diameter_mm: f64, outcome: &Outcome) -> WormOfLife {
    let (result, execution) = (&outcome.result, &outcome.execution);
    let of_flanks = result.flanks.values();
    let dressing = Sides::from_fn(|flank: Flank| {
        let dressing = execution.flanks[flank].as_ref()?.dressing()?;
        let [from, to] = dressing.driven;
        let [phi, gamma, d, offset] =
            std::array::from_fn(|axis| dressing.corrections[axis].value(0.5 * (from + to)));
        Some(DressingOfLife {
            d_phi_s_deg: f64::to_degrees(phi),
            d_gamma_deg: f64::to_degrees(gamma),
            d_d_mm: d,
            d_v_ya_mm: offset,
        })
    });
    let plan = PlanOfLife {
        status: result.verdict.status(),
        reason: result.verdict.reason().cloned(),
        deviation_um: of_flanks.clone().map(|flank| flank.max_deviation_um).fold(0.0, f64::max),
        least_determinant_ratio: of_flanks
            .map(|flank| flank.least_determinant_ratio)
            .fold(f64::INFINITY, f64::min),
        worm_pitch_diameter_mm: result.settings.worm_pitch_diameter_mm,
        diagonal_ratio: execution.ratio,
        crossed_axes_angle_deg: result.settings.crossed_axes_angle_deg,
        centre_distance_mm: result.settings.centre_distance_mm,
        used_width_mm: result.settings.worm_length_mm,
        worm_speed_rpm: outcome.prepared.technology.finishing().worm_speed * 60.0 / std::f64::consts::TAU,
        dressing,
        settings: result.settings.settings.clone(),
    };
    WormOfLife { tip_diameter_mm, plan: Some(plan), refused: None }
}

impl WormLifeOutcome {
    /// What the study comes to, in a sentence.
    pub fn headline(&self) -> String {
        match self.last_usable_tip_diameter_mm {
            None => "The new worm misses the target already.".to_owned(),
            Some(last) if self.whole_life => {
                format!(
                    "The target is met down to the last diameter, {last:.2} mm, with the dresser of the new worm."
                )
            }
            Some(last) => {
                let ends = self.worms.iter().find(|worm| !worm.is_met() && worm.tip_diameter_mm < last);
                let plan = ends.and_then(|worm| worm.plan.as_ref());
                let reason = plan.and_then(|plan| plan.reason.as_ref()).map(|reason| reason.text.as_str());
                let refused =
                    ends.and_then(|worm| worm.refused.as_ref()).map(|refused| refused.text.as_str());
                let why = reason.or(refused).map(|text| format!(" Below: {text}.")).unwrap_or_default();
                format!("The target is met down to {last:.2} mm with the dresser of the new worm.{why}")
            }
        }
    }
}

impl TaskOutcome for WormLifeOutcome {
    fn job(&self) -> &str {
        &self.job
    }

    fn verdict(&self) -> Option<&Verdict> {
        None
    }

    fn result(&self) -> &dyn erased_serde::Serialize {
        self
    }

    fn write(&self, directory: &Path) -> Result<Vec<PathBuf>, WriteError> {
        write_worm_life(self, directory)
    }

    fn summary(&self, written: &[PathBuf], _: usize) -> String {
        let mut text = format!("{}: {}\n", self.job, self.headline());
        for worm in &self.worms {
            let says = match (&worm.plan, &worm.refused) {
                (Some(plan), _) => {
                    format!(
                        "{}, {:.3} um, K = {:.4}",
                        plan.status.words(),
                        plan.deviation_um,
                        plan.diagonal_ratio
                    )
                }
                (None, Some(refused)) => format!("{}: {}", refused.code, refused.text),
                (None, None) => String::new(),
            };
            text += &format!("  {:>9.3} mm  {says}\n", worm.tip_diameter_mm);
        }
        if let Some(page) = written.last() {
            text += &format!("  report: {}\n", page.display());
        }
        text
    }

    fn conclusion(&self) -> Conclusion {
        if self.worms.iter().any(|worm| worm.plan.is_some()) {
            Conclusion::Done
        } else {
            Conclusion::NotProducible
        }
    }
}
