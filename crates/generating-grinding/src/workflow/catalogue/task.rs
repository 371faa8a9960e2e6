//! The question that a job asks of a catalogue: which profile crowning, with which limits, on which gear.

use super::bodies::bodies;
use super::width::CrowningOverWidth;
use crate::catalogue::LoadedCatalogue;
use crate::job::{AxisLimits, CatalogueSource, LoadedJob, RankBy};
use crate::workflow::generating_finding;
use crate::workflow::prepare::{axis_limits, tolerance_of_job, wanted_flanks};
use dressing::catalogue::{CatalogueDresser, CatalogueSearch, CatalogueWorm, PairLimits, Wanted};
use foundation::geometry::{Flank, Gear, Sides};
use foundation::modification::{EvaluationField, Modification};
use generating::{FlankTarget, GearWorkshop, GeneratingError};
use job::{Diagnostic, Problem};
use run::{RunFailure, blank_of_job, gear_of_job, geometry_finding};

/// Pairs that one search may have.
pub const MOST_PAIRS: usize = 100_000;

/// Bodies, target and limits of a search.
pub struct Task {
    /// Gear and machine, in which pairs are judged.
    pub workshop: GearWorkshop,
    /// Worms of the catalogue.
    pub worms: Vec<CatalogueWorm>,
    /// Dressers of the catalogue.
    pub dressers: Vec<CatalogueDresser>,
    /// What the pair has to make.
    pub wanted: Wanted,
    /// What a pair must keep to.
    pub limits: PairLimits,
    /// um, normal.
    pub tolerance_um: f64,
    /// Length of roll from form to tip, mm.
    pub involute: Sides<f64>,
    /// Crownings that the target wants over the width, where pairs are ranked by plans of it.
    pub whole: Option<CrowningOverWidth>,
}

impl Task {
    /// The task of a job that names a catalogue.
    ///
    /// # Errors
    /// A job without catalogue, an impossible gear or target, more than [`MOST_PAIRS`].
    pub fn new(loaded: &LoadedJob, catalogue: &LoadedCatalogue) -> Result<Self, RunFailure> {
        let job = &loaded.job;
        let Some(source) = &job.catalogue else {
            let finding = Diagnostic::new(Problem::MissingKey, "the job names no catalogue")
                .field("catalogue")
                .way_out("add `[catalogue]` with `file`, instead of `[worm]` and `[dresser]`");
            return Err(RunFailure::bad_input(finding));
        };
        let gear = gear_of_job(&job.gear).map_err(RunFailure::bad_input)?;
        let blank = blank_of_job(&job.gear);
        blank.check(&gear).map_err(|e| RunFailure::bad_input(geometry_finding(&e, "gear")))?;
        let (worms, dressers) = bodies(job, &catalogue.catalogue);
        check_count(worms.len().saturating_mul(dressers.len()))?;
        let range = job.gear.evaluation_range();
        let evaluation = [range.start_diameter, range.end_diameter, range.z_start, range.z_end];
        let forms = blank.limits(&gear).map_err(|e| RunFailure::bad_input(geometry_finding(&e, "gear")))?;
        let tolerance = tolerance_of_job(loaded).map_err(RunFailure::bad_input)?.tightest();
        let involute = forms.map(|_, f| f.w_a - f.w_f);
        let (fields, targets) = targets(loaded, &gear, evaluation)?;
        let crowning = crowning(&fields, &targets, &involute)?;
        let whole = (source.rank_by == RankBy::WholeTarget)
            .then(|| {
                let [.., from, to] = evaluation;
                let at = source.crowning_at.clone().unwrap_or_else(|| vec![from, 0.5 * (from + to), to]);
                CrowningOverWidth::of_target(at, &fields, &targets, &involute).map_err(fault)
            })
            .transpose()?;
        Ok(Self {
            workshop: GearWorkshop { gear, blank, evaluation, root_clearance: source.root_clearance },
            worms,
            dressers,
            wanted: Wanted {
                crowning,
                cos_base_helix: gear.flanks().map(|_, f| f.base_helix_angle.cos()),
                tolerance: Some(tolerance),
            },
            limits: limits(source, job.grinding.axis_limits.unwrap_or_default()),
            tolerance_um: tolerance * 1e3,
            involute,
            whole,
        })
    }

    /// The search over all pairs with everything that is looked at.
    pub fn search(&self) -> CatalogueSearch<'_> {
        CatalogueSearch {
            workshop: &self.workshop,
            worms: &self.worms,
            dressers: &self.dressers,
            wanted: self.wanted,
            limits: self.limits,
            collisions: true,
            life: true,
        }
    }
}

fn limits(source: &CatalogueSource, axes: AxisLimits) -> PairLimits {
    PairLimits {
        correction: axis_limits(axes).correction,
        stretch: Some(source.largest_stretch),
        tip_land: source.smallest_tip_land,
        clearance: source.clearance,
    }
}

fn check_count(pairs: usize) -> Result<(), RunFailure> {
    if pairs <= MOST_PAIRS {
        return Ok(());
    }
    let text = format!("worms and dressers of the catalogue make {pairs} pairs");
    let finding = Diagnostic::with_code("too-many-combinations", text)
        .field("catalogue")
        .value(pairs)
        .allowed(format!("up to {MOST_PAIRS}"))
        .way_out("leave out bodies that are far from the gear in module or size");
    Err(RunFailure::bad_input(finding))
}

fn fault(error: GeneratingError) -> RunFailure {
    RunFailure::bad_input(generating_finding::generating_finding(&error))
}

/// Evaluated flanks of the gear with what is wanted on those that are ground.
fn targets(
    loaded: &LoadedJob,
    gear: &Gear,
    [start, end, z_from, z_to]: [f64; 4],
) -> Result<(Sides<EvaluationField>, Sides<Option<Modification>>), RunFailure> {
    let fields = Sides::try_from_fn(|flank: Flank| -> Result<_, GeneratingError> {
        let f = gear.flank(flank);
        let roll = [f.length_of_roll(0.5 * start)?, f.length_of_roll(0.5 * end)?];
        Ok(EvaluationField::new(roll, [z_from, z_to], f.base_radius, f.base_helix_angle)?)
    })
    .map_err(fault)?;
    let wanted = wanted_flanks(loaded, &fields).map_err(RunFailure::bad_input)?;
    Ok((fields, wanted))
}

/// Profile crowning that the target asks for over the whole involute, per flank that is ground: the u^2 part of the target in the
/// class that a given dresser serves, reliefs best-fitted. mm, transverse.
fn crowning(
    fields: &Sides<EvaluationField>,
    targets: &Sides<Option<Modification>>,
    involute: &Sides<f64>,
) -> Result<Sides<Option<f64>>, RunFailure> {
    Sides::try_from_fn(|flank| {
        let Some(target) = &targets[flank] else { return Ok(None) };
        let plain = Modification::none(&fields[flank]);
        let target = FlankTarget::with_given_dresser(target.clone(), plain).map_err(fault)?;
        Ok(Some(-target.polynomial.coefficient(2, 0) * (0.5 * involute[flank]).powi(2)))
    })
}
