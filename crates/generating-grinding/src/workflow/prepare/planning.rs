//! What a job asks of planning, and the task that follows from it.

use super::Prepared;
use crate::job::{
    AxisLimits, DiagonalRatio, Dressing, DressingFlanks, Fit, Gauge, GaugeRule, Job, Method,
    Prefer as Preference, ProfileCrowningBy,
};
use generating::least_squares::FitNorm;
use generating::{
    DEFAULT_LEAST_DETERMINANT, DressingLimits, DressingRows, Effort, FreeCoefficients, PlanGauge, PlanTask,
    Prefer, ProfilePlace,
};
use job::{Diagnostic, Problem};
use run::RunFailure;

/// Rules of a plan.
#[derive(Clone, Debug)]
pub struct PlanningRules {
    /// Whether the worm is fed radially and not shifted.
    pub radial: bool,
    /// The diagonal ratio that the job gives as a number.
    pub given_ratio: Option<f64>,
    /// Places allowed for the profile crowning.
    pub places: Vec<ProfilePlace>,
    /// Whether the dresser is made for this job.
    pub free_dresser: bool,
    /// Whether second-order effects of the motion are compensated.
    pub precompensation: bool,
    norm: FitNorm,
    gauge: PlanGauge,
    dressing: DressingRows,
    grid: (usize, usize),
    prefer: Prefer,
    limits: DressingLimits,
    least_determinant: f64,
    /// How long a better plan is looked for.
    pub effort: Effort,
}

impl PlanningRules {
    /// The diagonal ratio as far as the job fixes it: 0 for a worm that is not shifted.
    pub fn known_ratio(&self) -> Option<f64> {
        if self.radial { Some(0.0) } else { self.given_ratio }
    }

    /// Of a job whose dresser is made for it, or given.
    ///
    /// # Errors
    /// A finding on `dressing.profile_crowning_by` for a crowning that a given dresser should carry.
    pub(super) fn of_job(job: &Job, rows: DressingRows, free_dresser: bool) -> Result<Self, RunFailure> {
        let radial = job.grinding.method == Method::Radial;
        Ok(Self {
            radial,
            given_ratio: match job.grinding.diagonal_ratio {
                Some(DiagonalRatio::Number(ratio)) => Some(ratio),
                _ => None,
            },
            places: places(&job.dressing, free_dresser)?,
            free_dresser,
            precompensation: job.grinding.precompensation.unwrap_or(!radial),
            norm: match job.target.fit {
                Fit::LeastSquares => FitNorm::LeastSquares,
                Fit::Largest => FitNorm::Largest,
            },
            gauge: match job.grinding.gauge {
                Gauge::Rule(GaugeRule::Centred) => PlanGauge::Centred,
                Gauge::Rule(GaugeRule::EqualSwivel) => PlanGauge::EqualSwivel,
                Gauge::Given(g) => {
                    PlanGauge::Given(FreeCoefficients { k_10: g.k_10, k_20: Some(g.k_20), k_k0: g.k_k0 })
                }
            },
            dressing: rows,
            grid: (job.grid.profile_points, job.grid.helix_points),
            prefer: match job.grinding.prefer {
                Some(Preference::Accuracy) => Prefer::Accuracy,
                Some(Preference::Worm) | None => Prefer::Worm,
                Some(Preference::Time) => Prefer::Time,
            },
            limits: axis_limits(job.grinding.axis_limits.unwrap_or_default()),
            least_determinant: job.grinding.least_determinant_ratio.unwrap_or(DEFAULT_LEAST_DETERMINANT),
            effort: Effort::Full,
        })
    }

    /// Determinant ratio that every contact is to keep.
    pub fn least_determinant(&self) -> f64 {
        self.least_determinant
    }

    /// Points of the result grid along profile and helix.
    pub fn grid(&self) -> (usize, usize) {
        self.grid
    }
}

/// What the correcting axes may do, by the job or by default.
pub fn axis_limits(given: AxisLimits) -> DressingLimits {
    let DressingLimits { correction: [phi, gamma, d, v], delta_d } = DressingLimits::default();
    let angle = |degrees: Option<f64>, default| degrees.map_or(default, f64::to_radians);
    DressingLimits {
        correction: [
            angle(given.d_phi_s_deg, phi),
            angle(given.d_gamma_deg, gamma),
            given.d_d_mm.unwrap_or(d),
            given.d_v_ya_mm.unwrap_or(v),
        ],
        delta_d: given.delta_d_mm.unwrap_or(delta_d),
    }
}

/// Where the profile crowning may come from.
fn places(dressing: &Dressing, free_dresser: bool) -> Result<Vec<ProfilePlace>, RunFailure> {
    let places = match dressing.profile_crowning_by {
        ProfileCrowningBy::Dresser => vec![ProfilePlace::Dresser],
        ProfileCrowningBy::Correction => vec![ProfilePlace::Correction],
        ProfileCrowningBy::Diagonal => vec![ProfilePlace::Diagonal],
        ProfileCrowningBy::Auto if free_dresser => vec![ProfilePlace::Dresser],
        // One correction for both flanks makes value and slope of each, no crowning.
        ProfileCrowningBy::Auto if dressing.flanks == DressingFlanks::Two => vec![ProfilePlace::Diagonal],
        ProfileCrowningBy::Auto => vec![ProfilePlace::Diagonal, ProfilePlace::Correction],
    };
    if places == [ProfilePlace::Dresser] && !free_dresser {
        let d = Diagnostic::new(
            Problem::InvalidJob,
            "the profile crowning cannot go into a dresser whose profile is given",
        )
        .field("dressing.profile_crowning_by")
        .allowed("\"auto\", \"diagonal\" or \"correction\"")
        .way_out("let the dresser be made for the target (dresser.modification = \"target\")");
        return Err(RunFailure::bad_input(d));
    }
    Ok(places)
}

impl Prepared {
    /// The task of planning this job.
    pub fn task(&self) -> PlanTask<'_> {
        let rules = &self.rules;
        PlanTask {
            setup: &self.setup,
            targets: self.targets.clone(),
            tolerance: self.tolerance.tightest(),
            tolerance_map: (!self.tolerance.is_uniform()).then(|| self.tolerance.clone()),
            limits: rules.limits,
            prefer: rules.prefer,
            least_determinant: rules.least_determinant,
            effort: rules.effort,
            ratio: rules.known_ratio(),
            law: self.law.clone(),
            norm: rules.norm,
            gauge: rules.gauge,
            places: rules.places.clone(),
            dressing: rules.dressing,
            free_dresser: rules.free_dresser,
            precompensation: rules.precompensation,
            grid: rules.grid,
        }
    }
}
