//! A worm topography as the thing that is wanted: the dresser makes it as nearly as it can under a given shift, and no motion of grinding
//! helps it. What the gear becomes follows (`docs/mathematics/planning.md#a-worm-that-is-wanted`). Knows no job.

use super::plan::{Equipped, Records};
use super::ratio::{NoPlan, RatioChoice, RatioReason};
use super::{
    Carried, Decomposition, FeedLaw, GeneratingError, GrindingPlan, GrindingSetup, IdealPlan, IdealWorm,
    PlanTask, PlanningGrid, ProfilePlace, Tool,
};
use contact::{ModifiedThread, ThreadFunction};
use foundation::geometry::{Flank, Sides};
use foundation::kinematics::{MotionLaw, PiecewisePolynomial};
use foundation::modification::Modification;
use foundation::numerics::equidistant;

/// Places over the profile at which the profile of a dresser that is made for the worm is sampled, and positions along the worm over which
/// it is averaged.
const PROFILE_POINTS: usize = 65;
const POSITIONS: usize = 65;

/// A worm whose flank is `wanted` and nothing else, over (w_1, z_1), transverse, mm.
fn worm_of(setup: &GrindingSetup, flank: Flank, shift: &MotionLaw, wanted: &Modification) -> IdealWorm {
    let lines = setup.lines[flank];
    IdealWorm {
        lines,
        shift: shift.clone(),
        parts: Decomposition::nothing(lines.t_k),
        carried: Carried::default(),
        reliefs: Vec::new(),
        moved: None,
        spline: None,
        given: Some(wanted.clone()),
    }
}

/// What a wanted worm leaves on the gear by the exact contact, without any correction of grinding: f_n over the grid, `[w][z]`, mm.
///
/// # Errors
/// Those of the exact contact, and of a wanted flank that has no value where it grinds.
pub fn gear_of_worm(
    setup: &GrindingSetup,
    flank: Flank,
    shift: &MotionLaw,
    wanted: &Modification,
    grid: &PlanningGrid,
) -> Result<Vec<f64>, GeneratingError> {
    let worm = worm_of(setup, flank, shift, wanted);
    let thread = ModifiedThread::new(setup.pair.flanks[flank].worm, &worm);
    let ground = grid.ground(setup, flank, &setup.pair.motion(shift.clone()), &thread)?;
    Ok(ground.iter().map(|at| at.f_n).collect())
}

/// The profile of a dresser made for a wanted worm, as it shows on the gear over w_2, transverse, mm: what the worm has on average along
/// its length, less the value in the middle, which the distance of the dresser makes.
fn mean_profile(
    setup: &GrindingSetup,
    worm: &IdealWorm,
    flank: Flank,
) -> Result<PiecewisePolynomial, GeneratingError> {
    let lines = &worm.lines;
    let [from, to] = lines.worm_rolls(&worm.shift);
    let middle = 0.5 * (from + to);
    let occupied = setup.lines[flank].occupation(&worm.shift);
    let value = |w_1: f64, z_1: f64| {
        let jet = worm.jet(w_1, z_1).ok_or(GeneratingError::ToolUndefined { flank, w_1, z_1 })?;
        Ok::<f64, GeneratingError>(-jet.f / lines.cos_b2)
    };
    let rolls = equidistant([from, to], PROFILE_POINTS);
    // Along lines of the tool: that is how the dresser touches.
    let line = |w_1: f64| -lines.t_1 * (w_1 - middle);
    let mut values = Vec::with_capacity(rolls.len());
    for &w_1 in &rolls {
        let mut sum = 0.0;
        for z_1 in equidistant(occupied, POSITIONS) {
            let at = (z_1 + line(w_1)).clamp(occupied[0], occupied[1]);
            sum += value(w_1, at)?;
        }
        values.push(sum / POSITIONS as f64);
    }
    let centre = values[PROFILE_POINTS / 2];
    let mut points: Vec<(f64, f64)> =
        rolls.iter().zip(&values).map(|(&w_1, f)| (lines.work_roll(w_1), f - centre)).collect();
    points.sort_by(|a, b| a.0.total_cmp(&b.0));
    let (x, y): (Vec<f64>, Vec<f64>) = points.into_iter().unzip();
    PiecewisePolynomial::spline(&x, &y).map_err(GeneratingError::Law)
}

impl PlanTask<'_> {
    /// The shift of a plan whose ratio or law is given.
    fn given_feed(&self) -> Result<FeedLaw, GeneratingError> {
        match (&self.law, self.ratio) {
            (Some(law), _) => Ok(FeedLaw::Law(law.clone())),
            (None, Some(ratio)) => Ok(FeedLaw::Ratio(ratio)),
            (None, None) => Err(GeneratingError::InvalidNumber {
                field: "diagonal ratio",
                value: f64::NAN,
                allowed: "a number beside a worm that is wanted",
            }),
        }
    }

    /// Dresses the wanted worm of the setup; the targets are what it leaves on the gear.
    ///
    /// # Errors
    /// [`NoPlan`]: a worm that its dresser does not make, a shift that needs more worm than there is.
    pub(super) fn plan_worm(&self, wanted: &Sides<Modification>) -> Result<GrindingPlan, Box<NoPlan>> {
        self.dressed_as_wanted(wanted)
            .map_err(|error| Box::new(NoPlan { error, candidates: Vec::new(), failed: Vec::new() }))
    }

    fn dressed_as_wanted(&self, wanted: &Sides<Modification>) -> Result<GrindingPlan, GeneratingError> {
        let setup = self.setup;
        let which: Vec<Flank> = Flank::BOTH.into_iter().filter(|&f| self.targets[f].is_some()).collect();
        if which.is_empty() {
            return Err(GeneratingError::NoFlank);
        }
        let feed = self.given_feed()?;
        let shift = feed.law(setup, &which);
        let occupation = setup.occupation(&shift, &which);
        let [first, last] = setup.feed_range(&shift, &which);
        let ratio = feed.ratio().unwrap_or((shift.value(last) - shift.value(first)) / (last - first));
        let grid = self.planning_grid();
        let rule = self.rule(&grid);
        rule.check_width(occupation[1] - occupation[0], ratio)?;
        let worms = Sides::try_from_fn(|flank| -> Result<_, GeneratingError> {
            let Some(target) = &self.targets[flank] else { return Ok(None) };
            let mut worm = worm_of(setup, flank, &shift, &wanted[flank]);
            if !self.free_dresser {
                worm.reliefs = target.reliefs.clone();
                worm.moved = target.moved.clone();
            } else if matches!(setup.tool, Tool::Dressed(_)) {
                worm.spline = Some(mean_profile(setup, &worm, flank)?);
            }
            Ok(Some(worm))
        })?;
        let ideal = IdealPlan::of_settings(worms, setup.pair.motion(shift), occupation);
        let place = ProfilePlace::Dresser;
        let policy = rule.policy(place);
        let best: Equipped = self.equip(ideal, policy, &grid)?;
        let choice = RatioChoice {
            ratio,
            place,
            reason: if self.law.is_some() { RatioReason::Law } else { RatioReason::Given },
            lead_correction: rule.lead_corrections(place),
            demanded: Sides { left: Vec::new(), right: Vec::new() },
            candidates: Vec::new(),
            failed: Vec::new(),
        };
        let records = Records {
            ideal: Sides { left: Vec::new(), right: Vec::new() },
            dressed: Sides::from_fn(|f| best.error.largest(f).into_iter().collect()),
        };
        self.finish(best, choice, policy, &grid, records)
    }
}
