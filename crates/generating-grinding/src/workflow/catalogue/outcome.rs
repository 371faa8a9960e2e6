//! What a search in a catalogue found, as the document of `explore.json`.

use super::Ranking;
use super::task::Task;
use super::whole::{PairPlan, WholePair};
use super::width::{CrowningAt, PairRange};
use crate::catalogue::Catalogue;
use crate::job::LoadedJob;
use crate::workflow::explore::Refused;
use dressing::catalogue::{FlankOfPair, LifeRow, PairFigures, RankedPair, Refusal, RemainingLife};
use foundation::geometry::{Flank, Sides};
use report::PageHead;
use run::JobTitle;
use schemars::JsonSchema;
use serde::Serialize;
use std::collections::BTreeMap;

/// The rule of the ranking, in words.
pub const PAIR_RANKING: &str = "pairs that make the profile first, then by the largest share of an axis limit; pairs that cannot \
    be dressed at all last";

/// The rule of a ranking by plans, in words.
pub const PLAN_RANKING: &str = "pairs whose plan meets the target first, by the largest share of an axis limit; then those that miss \
    it, by what they leave over the tolerance; then those that were not planned; pairs that cannot be made last";

impl From<&Refusal> for Refused {
    fn from(refusal: &Refusal) -> Self {
        Self { code: refusal.code(), text: refusal.to_string(), way_out: refusal.way_out().into() }
    }
}

/// One flank of a pair.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct PairFlank {
    /// Profile crowning asked of the dressing motion: the wanted one without that of the dresser.
    pub crowning_by_motion_um: f64,
    /// Correction of the worm angle.
    #[serde(rename = "d_phi_S_deg")]
    pub d_phi_s_deg: f64,
    /// Correction of the crossing angle.
    pub d_gamma_deg: f64,
    /// Correction of the centre distance.
    pub d_d_mm: f64,
    /// Correction of the offset.
    #[serde(rename = "d_v_yA_mm")]
    pub d_v_ya_mm: f64,
    /// Relative stretch of the profile.
    pub stretch: f64,
    /// Largest distance from the wanted parabola, normal.
    pub profile_error_um: f64,
    /// Largest tip land that clears the opposite flank; absent where none does.
    pub largest_tip_land_mm: Option<f64>,
}

impl From<&FlankOfPair> for PairFlank {
    fn from(f: &FlankOfPair) -> Self {
        Self {
            crowning_by_motion_um: f.crowning * 1e3,
            d_phi_s_deg: f.fit.dk[0].to_degrees(),
            d_gamma_deg: f.fit.dk[1].to_degrees(),
            d_d_mm: f.fit.dk[2],
            d_v_ya_mm: f.fit.dk[3],
            stretch: f.fit.stretch,
            profile_error_um: f.profile_error * 1e3,
            largest_tip_land_mm: f.tip_land.flatten(),
        }
    }
}

/// The flanks of a pair that are ground, by name.
pub fn flanks(figures: &PairFigures) -> BTreeMap<&'static str, PairFlank> {
    let known = figures.flanks.iter().filter_map(|(flank, f)| Some((flank.name(), f.as_ref()?)));
    known.map(|(name, f)| (name, PairFlank::from(f))).collect()
}

/// How long a worm serves.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct PairLife {
    /// Current pitch diameter.
    pub from_mm: f64,
    /// Smallest pitch diameter at which the target is still made.
    pub to_mm: f64,
    /// What ends it before the worm is used up.
    pub ended_by: Option<Refused>,
}

impl From<&RemainingLife> for PairLife {
    fn from(life: &RemainingLife) -> Self {
        Self { from_mm: life.from, to_mm: life.to, ended_by: life.end.as_ref().map(Refused::from) }
    }
}

/// One pair of the ranking. Figures are absent where the worm cannot be dressed to the profile.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct CataloguePair {
    /// Place in the ranking, from 1.
    pub rank: usize,
    /// Name of the worm.
    pub worm: String,
    /// Name of the dresser.
    pub dresser: String,
    /// Whether the pair makes the profile within all limits.
    pub ok: bool,
    /// max |DK_j/limit_j|.
    pub largest_share_of_limit: Option<f64>,
    /// Pitch diameter of the worm in its present state.
    pub worm_pitch_diameter_mm: Option<f64>,
    /// Figures per flank that is ground.
    pub flanks: BTreeMap<&'static str, PairFlank>,
    /// Remaining life of the worm with this dresser.
    pub life: Option<PairLife>,
    /// What a plan of the whole target leaves; absent where pairs are ranked by their profile, or this one was not planned.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub plan: Option<PairPlan>,
    /// Profile crownings that the pair can make by its dressing within the limits of the axes, by flank; absent where pairs are ranked by
    /// their profile.
    #[serde(skip_serializing_if = "BTreeMap::is_empty")]
    pub crowning_range: BTreeMap<&'static str, PairRange>,
    /// Why the pair does not make the profile or, ranked by plans, the target, if so.
    pub refused: Option<Refused>,
}

/// Why a pair does not make what the ranking goes by.
fn refused(pair: &RankedPair, whole: &WholePair, by_plans: bool) -> Option<Refused> {
    let of_profile = || pair.refusal.as_ref().map(Refused::from);
    if !by_plans {
        return of_profile();
    }
    match &whole.plan {
        Some(Ok(plan)) => plan.reason.as_ref().map(|reason| Refused {
            code: reason.code,
            text: reason.text.clone(),
            way_out: reason.way_out.to_string(),
        }),
        Some(Err(refused)) => Some(refused.clone()),
        None => of_profile().or_else(|| {
            Some(Refused {
                code: "not-planned",
                text: "the pair was not planned: others come before it by their crownings".into(),
                way_out: "raise catalogue.plans to have it planned".into(),
            })
        }),
    }
}

impl CataloguePair {
    fn of(
        rank: usize,
        catalogue: &Catalogue,
        (pair, whole): &(RankedPair, WholePair),
        ranking: &Ranking,
    ) -> Self {
        let plan = whole.plan.as_ref().and_then(|plan| plan.as_ref().ok());
        let named = |(flank, range): (Flank, &Option<PairRange>)| Some((flank.name(), (*range)?));
        let name = |name: Option<&String>| name.cloned().unwrap_or_default();
        Self {
            rank,
            worm: name(catalogue.worm.get(pair.worm).map(|w| &w.name)),
            dresser: name(catalogue.dresser.get(pair.dresser).map(|d| &d.name)),
            ok: if ranking.by_plans { whole.is_met() } else { pair.is_ok() },
            largest_share_of_limit: plan.map(|plan| plan.largest_share_of_limit).or(pair.cost()),
            worm_pitch_diameter_mm: pair.figures.as_ref().map(|f| f.pitch_diameter),
            flanks: pair.figures.as_ref().map(flanks).unwrap_or_default(),
            life: pair.life.as_ref().map(PairLife::from),
            plan: plan.cloned(),
            crowning_range: whole.ranges.iter().filter_map(named).collect(),
            refused: refused(pair, whole, ranking.by_plans),
        }
    }

    /// Of the flanks the value of largest magnitude.
    pub fn largest(&self, of: impl Fn(&PairFlank) -> f64) -> Option<f64> {
        self.flanks.values().map(of).max_by(|a, b| a.abs().total_cmp(&b.abs()))
    }

    /// Largest tip land that clears the opposite flanks of all flanks.
    pub fn tip_land_mm(&self) -> Option<f64> {
        let lands: Option<Vec<f64>> = self.flanks.values().map(|f| f.largest_tip_land_mm).collect();
        lands?.into_iter().reduce(f64::min)
    }
}

/// One diameter in the life of a pair.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct LifePoint {
    /// Pitch diameter of the worm.
    pub worm_pitch_diameter_mm: f64,
    /// Profile crowning of the gear without corrections of crossing angle and offset, per flank.
    pub uncorrected_crowning_um: BTreeMap<&'static str, f64>,
    /// max |DK_j/limit_j|.
    pub largest_share_of_limit: Option<f64>,
    /// Figures per flank that is ground.
    pub flanks: BTreeMap<&'static str, PairFlank>,
    /// Why the target is not made at this diameter, if so.
    pub refused: Option<Refused>,
}

impl From<&LifeRow> for LifePoint {
    fn from(row: &LifeRow) -> Self {
        let by_name = |sides: &Sides<Option<f64>>| -> BTreeMap<&'static str, f64> {
            Flank::BOTH.into_iter().filter_map(|f| Some((f.name(), sides[f]? * 1e3))).collect()
        };
        let figures = row.figures.as_ref().ok();
        Self {
            worm_pitch_diameter_mm: row.pitch_diameter,
            uncorrected_crowning_um: row.uncorrected.as_ref().map(by_name).unwrap_or_default(),
            largest_share_of_limit: figures.map(|f| f.cost),
            flanks: figures.map(flanks).unwrap_or_default(),
            refused: row.refusal().map(Refused::from),
        }
    }
}

/// The whole life of a worm with a dresser.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct LifeCurve {
    /// Name of the worm.
    pub worm: String,
    /// Name of the dresser.
    pub dresser: String,
    /// From the current diameter to the smallest.
    pub points: Vec<LifePoint>,
}

/// The whole answer.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct CatalogueOutcome {
    /// Head of its page.
    #[serde(skip)]
    pub head: PageHead,
    /// Name of the job.
    pub job: String,
    /// Process.
    pub process: String,
    /// Version of flankwright.
    pub version: &'static str,
    /// Tolerance of the job, the tightest of its map, normal.
    pub tolerance_um: f64,
    /// Profile crowning that the target asks for from form to tip diameter, per flank, transverse.
    pub wanted_profile_crowning_um: BTreeMap<&'static str, f64>,
    /// The same at positions over the width; absent where pairs are ranked by their profile.
    #[serde(skip_serializing_if = "BTreeMap::is_empty")]
    pub wanted_over_width: BTreeMap<&'static str, Vec<CrowningAt>>,
    /// Limits of the corrections: degrees, degrees, mm, mm.
    pub limits: CatalogueLimits,
    /// Worms of the catalogue, in its order.
    pub worms: Vec<String>,
    /// Dressers of the catalogue, in its order.
    pub dressers: Vec<String>,
    /// How the pairs are ranked.
    pub ranking: &'static str,
    /// Number of pairs that make the profile or, ranked by plans, the whole target.
    pub ok: usize,
    /// All pairs, the best first.
    pub pairs: Vec<CataloguePair>,
    /// The life of the best pairs.
    pub lives: Vec<LifeCurve>,
}

/// Limits of a search as a file has them.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct CatalogueLimits {
    /// |d_phi_S|.
    #[serde(rename = "d_phi_S_deg")]
    pub d_phi_s_deg: f64,
    /// |d_gamma|.
    pub d_gamma_deg: f64,
    /// |d_d|.
    pub d_d_mm: f64,
    /// |d_v_yA|.
    #[serde(rename = "d_v_yA_mm")]
    pub d_v_ya_mm: f64,
    /// |P|.
    pub stretch: Option<f64>,
    /// Tip land of a dresser whose land the catalogue does not state.
    pub smallest_tip_land_mm: f64,
    /// Distance from the opposite flank.
    pub clearance_mm: f64,
}

impl CatalogueLimits {
    /// The limits of a task as the document gives them.
    pub fn of(task: &Task) -> Self {
        let [phi, gamma, d, v_y] = task.limits.correction;
        Self {
            d_phi_s_deg: phi.to_degrees(),
            d_gamma_deg: gamma.to_degrees(),
            d_d_mm: d,
            d_v_ya_mm: v_y,
            stretch: task.limits.stretch,
            smallest_tip_land_mm: task.limits.tip_land,
            clearance_mm: task.limits.clearance,
        }
    }
}

/// Wanted crowning by flank, um.
pub fn wanted_um(task: &Task) -> BTreeMap<&'static str, f64> {
    let wanted = &task.wanted.crowning;
    Flank::BOTH.into_iter().filter_map(|f| Some((f.name(), wanted[f]? * 1e3))).collect()
}

impl CatalogueOutcome {
    /// The answer of a ranking.
    pub(super) fn new(loaded: &LoadedJob, catalogue: &Catalogue, task: &Task, ranking: &Ranking) -> Self {
        let job = &loaded.job.job;
        let pair = |(k, pair)| CataloguePair::of(k + 1, catalogue, pair, ranking);
        let ground = Flank::BOTH.into_iter().filter(|&flank| task.wanted.crowning[flank].is_some());
        let over = task.whole.iter();
        let wanted = over.flat_map(|over| ground.clone().map(|flank| (flank.name(), over.at(flank))));
        let title = JobTitle::new(job, loaded.job.output.language);
        Self {
            head: title.head("Generating grinding, worms and dressers of the catalogue"),
            job: job.name.clone(),
            process: job.process.name().to_string(),
            version: env!("CARGO_PKG_VERSION"),
            tolerance_um: task.tolerance_um,
            wanted_profile_crowning_um: wanted_um(task),
            wanted_over_width: wanted.collect(),
            limits: CatalogueLimits::of(task),
            worms: catalogue.worm.iter().map(|w| w.name.clone()).collect(),
            dressers: catalogue.dresser.iter().map(|d| d.name.clone()).collect(),
            ranking: if ranking.by_plans { PLAN_RANKING } else { PAIR_RANKING },
            ok: ranking.pairs.iter().filter(|pair| ranking.is_ok(pair)).count(),
            pairs: ranking.pairs.iter().enumerate().map(pair).collect(),
            lives: ranking.lives.clone(),
        }
    }

    /// Whether pairs are ranked by plans of the whole target.
    pub fn is_by_plans(&self) -> bool {
        !self.wanted_over_width.is_empty()
    }

    /// The best pair, if one makes the profile or, ranked by plans, the target.
    pub fn best(&self) -> Option<&CataloguePair> {
        self.pairs.first().filter(|pair| pair.ok)
    }
}
