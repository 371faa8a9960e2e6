//! What a job asks of planning, and the task that follows from it.

use super::Prepared;
use crate::job::{
    Condition, DegreeOfFreedom, DiagonalRatio, Dressing, DressingFlanks, Fit, Gauge, GaugeRule, Job, Method,
    ProfileCrowningBy,
};
use generating::least_squares::FitNorm;
use generating::{
    DressingLimits, DressingRows, FlankRows, FreeCoefficients, PlanGauge, PlanTask, ProfilePlace,
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
}

impl PlanningRules {
    /// Of a job whose dresser is made for it, or given.
    ///
    /// # Errors
    /// A finding on `dressing.profile_crowning_by` for a crowning that a given dresser should carry.
    pub(super) fn of_job(job: &Job, free_dresser: bool) -> Result<Self, RunFailure> {
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
            dressing: dressing_rows(&job.dressing),
            grid: (job.grid.profile_points, job.grid.helix_points),
        })
    }

    /// Points of the result grid along profile and helix.
    pub fn grid(&self) -> (usize, usize) {
        self.grid
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

/// The rows of the dressing motion as the job names them; that they are four has been checked.
fn dressing_rows(dressing: &Dressing) -> DressingRows {
    if dressing.flanks == DressingFlanks::Two {
        return DressingRows::BothFlanks;
    }
    let has = |condition: Condition| dressing.conditions.contains(&condition);
    let fixed = dressing.fixed();
    DressingRows::Alone(FlankRows {
        points: if has(Condition::FourPoint) { 4 } else { 3 },
        map: has(Condition::RadiusMap),
        head: has(Condition::Head),
        fixed: DegreeOfFreedom::ALL.map(|axis| fixed.contains(&axis)),
    })
}

impl Prepared {
    /// The task of planning this job.
    pub fn task(&self) -> PlanTask<'_> {
        let rules = &self.rules;
        PlanTask {
            setup: &self.setup,
            targets: self.targets.clone(),
            tolerance: self.tolerance.tightest(),
            limits: DressingLimits::default(),
            ratio: if rules.radial { Some(0.0) } else { rules.given_ratio },
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
