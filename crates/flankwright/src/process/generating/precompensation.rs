//! From a commanded polynomial to worm functions and motion, the exact flank they leave, and the correction of the command
//! (spec 28 section 4, steps 2 to 5).

use super::carried::misfit_of_lines;
use super::target::ClassFit;
use super::{
    Carried, Decomposition, FeedLaw, FieldSpline, FlankLines, FlankTarget, GeneratingError, GrindingSetup,
    IdealWorm, ProfilePlace, Tool, common_motion, decompose_diagonal, decompose_radial,
};
use crate::contact::{ContactSolution, ExactContact, ModifiedThread, ToolSurface};
use crate::geometry::{Flank, Sides};
use crate::kinematics::GeneratingMotion;
use crate::numerics::Polynomial2;
use std::sync::Arc;

/// Rounds of precompensation with the ideal worm (spec 28 section 4).
pub(super) const ROUNDS: usize = 4;
/// Rounds where the correction is free: reliefs and steep lines shift the contact further, each round gains less.
pub(super) const FREE_ROUNDS: usize = 12;

/// Steepest worm lines on the workpiece, |tan(rho_2)|: beyond it the shift is too small to tell them from the profile.
const STEEPEST: f64 = 1e4;

/// Who carries the profile, and whether the dresser may be made for it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ProfilePolicy {
    /// Place of the u^2 part.
    pub place: ProfilePlace,
    /// The dresser is made for this job (`[dresser] modification = "target"`).
    pub free_dresser: bool,
    /// Parts of the target that are no polynomials stand on the tool's lines as they are when these miss them by no more
    /// than this; else they are best-fitted. Transverse, mm.
    pub line_tolerance: f64,
}

/// What is commanded on one flank: the target plus the corrections found so far.
#[derive(Clone, Debug)]
pub struct Command {
    /// Polynomial in (u, y), transverse, mm.
    pub polynomial: Polynomial2,
    /// Corrections that are no polynomials; only where the tool's lines carry more than polynomials.
    pub corrections: Vec<Arc<FieldSpline>>,
}

impl Command {
    /// The target itself.
    pub fn of(target: &FlankTarget) -> Self {
        Self { polynomial: target.of_class.clone(), corrections: Vec::new() }
    }
}

/// Points on the flanks on which a plan is judged, row-major `[w][z]`.
#[derive(Clone, Debug)]
pub struct PlanningGrid {
    /// Lengths of roll per flank, mm.
    pub w: Sides<Vec<f64>>,
    /// Axial positions, mm.
    pub z: Vec<f64>,
    fits: Sides<ClassFit>,
    pure_fits: Sides<ClassFit>,
}

/// Equidistant numbers from `from` to `to`, both included.
pub(super) fn equidistant([from, to]: [f64; 2], n: usize) -> Vec<f64> {
    (0..n).map(|i| from + (to - from) * i as f64 / (n - 1) as f64).collect()
}

impl PlanningGrid {
    /// `nw` x `nz` equidistant points over the evaluation fields.
    pub fn new(setup: &GrindingSetup, nw: usize, nz: usize) -> Self {
        let w = setup.fields.map(|_, f| equidistant(f.roll(), nw));
        let z = equidistant(setup.fields.left.face(), nz);
        let points = w.map(|flank, w| {
            let field = &setup.fields[flank];
            w.iter()
                .flat_map(|&w| z.iter().map(move |&z| (w - field.roll_middle(), z - field.face_middle())))
                .collect::<Vec<_>>()
        });
        let fits = points.map(|_, p| ClassFit::new(p));
        let pure_fits = points.map(|_, p| ClassFit::without_mixed_terms(p));
        Self { w, z, fits, pure_fits }
    }

    /// Target values on one flank, normal, mm.
    ///
    /// # Errors
    /// Evaluation errors of the target.
    pub fn target(
        &self,
        flank: Flank,
        target: &FlankTarget,
        cos_b2: f64,
    ) -> Result<Vec<f64>, GeneratingError> {
        let mut values = Vec::with_capacity(self.w[flank].len() * self.z.len());
        for &w in &self.w[flank] {
            for &z in &self.z {
                values.push(target.value(w, z)? * cos_b2);
            }
        }
        Ok(values)
    }

    /// The exact flank left by a tool surface, by grid point.
    ///
    /// # Errors
    /// Those of the exact contact.
    pub fn ground<S: ToolSurface>(
        &self,
        setup: &GrindingSetup,
        flank: Flank,
        motion: &GeneratingMotion,
        surface: &S,
    ) -> Result<Vec<ContactSolution>, GeneratingError> {
        let contact = ExactContact::new(&setup.pair, flank, motion, surface);
        Ok(contact.solve_grid(&self.w[flank], &self.z)?)
    }

    /// Correction of the command that the normal errors `e` (target - ground, mm) ask for, transverse; with or without
    /// mixed terms.
    pub fn correction(&self, flank: Flank, e: &[f64], cos_b2: f64, mixed: bool) -> Polynomial2 {
        let transverse: Vec<f64> = e.iter().map(|e| e / cos_b2).collect();
        let fit = if mixed { &self.fits[flank] } else { &self.pure_fits[flank] };
        fit.fit(&transverse)
    }

    /// The command corrected by the normal errors `e` (target - ground, mm): what the class of polynomials takes, and the rest
    /// as a smooth function where the tool's lines may carry it.
    fn corrected(
        &self,
        setup: &GrindingSetup,
        flank: Flank,
        command: &Command,
        e: &[f64],
        terms: Correction,
    ) -> Command {
        let lines = &setup.lines[flank];
        let fitted = self.correction(flank, e, lines.cos_b2, terms != Correction::Pure);
        let mut next = command.clone();
        next.polynomial = command.polynomial.add(&fitted);
        if terms == Correction::Free {
            let at = |k: usize| (self.w[flank][k / self.z.len()], self.z[k % self.z.len()]);
            let points: Vec<[f64; 3]> = (0..e.len())
                .map(|k| {
                    let (w, z) = at(k);
                    [w, z, e[k] / lines.cos_b2 - fitted.value(w - lines.w_m, z - lines.z_m)]
                })
                .collect();
            // A grid too coarse for the spline corrects by polynomials only.
            next.corrections.extend(FieldSpline::near(&points, CORRECTION_CELLS).ok().map(Arc::new));
        }
        next
    }
}

/// Which terms of the error go back into the command.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Correction {
    /// Terms pure in u or in y.
    Pure,
    /// The class of polynomials.
    Mixed,
    /// The class and a smooth function for what is left.
    Free,
}

/// Cells over profile and face width of a correction: wide against the shift of the contact (about 1 mm), so that the loop
/// does not feed its own echo.
const CORRECTION_CELLS: [usize; 2] = [4, 10];

/// Tool functions and motion for one command, before any dresser is asked.
#[derive(Clone, Debug)]
pub struct IdealPlan {
    /// How the tool shift follows the feed.
    pub feed: FeedLaw,
    /// Command per flank.
    pub commanded: Sides<Option<Command>>,
    /// Ideal tool per flank.
    pub worms: Sides<Option<IdealWorm>>,
    /// The common motion.
    pub motion: GeneratingMotion,
    /// z_1 occupied on the tool, mm.
    pub occupation: [f64; 2],
    /// Largest part of the target that is best-fitted only, per flank, transverse, mm.
    pub outside: Sides<f64>,
}

/// Error of an ideal plan on the planning grid.
#[derive(Clone, Debug)]
pub struct GroundError {
    /// target - ground per grid point and flank, normal, mm.
    pub error: Sides<Option<Vec<f64>>>,
    /// Least determinant ratio of both flanks.
    pub determinant: f64,
}

impl GroundError {
    /// Compares what `ground` leaves on each flank (`None`: not ground) with its target.
    ///
    /// # Errors
    /// Those of `ground`; evaluation errors of the target.
    pub(super) fn of(
        setup: &GrindingSetup,
        targets: &Sides<Option<FlankTarget>>,
        grid: &PlanningGrid,
        ground: impl Fn(Flank) -> Option<Result<Vec<ContactSolution>, GeneratingError>>,
    ) -> Result<Self, GeneratingError> {
        let mut determinant = f64::INFINITY;
        let error = Sides::try_from_fn(|flank| -> Result<_, GeneratingError> {
            let (Some(ground), Some(target)) = (ground(flank), &targets[flank]) else { return Ok(None) };
            let ground = ground?;
            let wanted = grid.target(flank, target, setup.lines[flank].cos_b2)?;
            determinant = ground.iter().map(|g| g.determinant_ratio).fold(determinant, f64::min);
            Ok(Some(wanted.iter().zip(&ground).map(|(t, g)| t - g.f_n).collect()))
        })?;
        Ok(Self { error, determinant })
    }

    /// Largest |error| of one flank, mm.
    pub fn largest(&self, flank: Flank) -> Option<f64> {
        self.error[flank].as_ref().map(|e| e.iter().fold(0.0, |m: f64, x| m.max(x.abs())))
    }

    /// Root mean square of the error of one flank, mm.
    pub fn rms(&self, flank: Flank) -> Option<f64> {
        let errors = self.error[flank].as_ref()?;
        Some((errors.iter().map(|x| x * x).sum::<f64>() / errors.len() as f64).sqrt())
    }

    /// Largest |error| of all flanks, mm.
    pub fn max(&self) -> f64 {
        Flank::BOTH.into_iter().filter_map(|f| self.largest(f)).fold(0.0, f64::max)
    }
}

/// One flank's share of a plan.
struct Share {
    parts: Decomposition,
    carried: Carried,
    /// Best-fitted only, mm.
    outside: f64,
}

/// Splits the command of one flank between motion, dresser and lines of the tool.
fn share(
    setup: &GrindingSetup,
    flank: Flank,
    target: &FlankTarget,
    command: &Command,
    feed: &FeedLaw,
    policy: ProfilePolicy,
) -> Result<Share, GeneratingError> {
    let lines = &setup.lines[flank];
    if matches!(setup.tool, Tool::Given(_)) {
        // The tool is what it is: only the motion is free.
        let mut parts = decompose_radial(&command.polynomial, lines.t_k);
        parts.profile.clear();
        return Ok(Share { parts, carried: Carried::default(), outside: 0.0 });
    }
    let corrections = command.corrections.clone();
    if let FeedLaw::Ratio(ratio) = *feed {
        let t = lines.work_direction(ratio);
        let steep = t.is_nan() || t.abs() > STEEPEST || (t - lines.t_k).abs() < 1e-6;
        if ratio != 0.0 && (steep || lines.big_t1.abs() < 1e-9) {
            return Err(GeneratingError::DegenerateDirection { flank, ratio });
        }
    }
    if feed.is_radial() {
        return Ok(radial_share(lines, target, command, policy));
    }
    if matches!(setup.tool, Tool::Made) {
        let polynomial = Some(command.polynomial.clone());
        let carried = Carried { polynomial, terms: target.rest.clone(), corrections };
        return Ok(Share { parts: Decomposition::nothing(lines.t_k), carried, outside: 0.0 });
    }
    let a = &command.polynomial;
    let FeedLaw::Ratio(ratio) = *feed else {
        // Along curves the profile stays with the dresser and all else stands on the lines.
        let mut parts = Decomposition::nothing(lines.t_k);
        if policy.free_dresser && lines.profile_slope() == 0.0 {
            let highest = a.terms().map(|(i, ..)| i).max().unwrap_or(0);
            parts.profile = (0..=highest).map(|i| if i < 2 { 0.0 } else { a.coefficient(i, 0) }).collect();
        }
        let profile = parts.profile.iter().enumerate().map(|(i, &p)| (i, 0, -p));
        let polynomial = Some(a.add(&Polynomial2::from_terms(profile)));
        let carried = Carried { polynomial, terms: target.rest.clone(), corrections };
        return Ok(Share { parts, carried, outside: 0.0 });
    };
    let t = lines.work_direction(ratio);
    let misfit: f64 = target.rest.iter().map(|term| misfit_of_lines(term, lines, t)).sum();
    let stands = misfit <= policy.line_tolerance;
    let a = if stands || target.rest.is_empty() { a.clone() } else { a.add(&target.fit_of_rest()) };
    let p_2 = match policy.place {
        ProfilePlace::Diagonal => 0.0,
        ProfilePlace::Dresser | ProfilePlace::Correction => a.coefficient(2, 0),
    };
    let mut parts = decompose_diagonal(&a, t, lines.t_k, p_2, lines.profile_slope());
    if !policy.free_dresser {
        parts.profile.truncate(3); // no dresser is there to carry u^3 and higher
    }
    let terms = if stands { target.rest.clone() } else { Vec::new() };
    let outside = if stands { misfit } else { target.outside };
    Ok(Share { parts, carried: Carried { polynomial: None, terms, corrections }, outside })
}

/// The share of a flank without tool shift.
fn radial_share(lines: &FlankLines, target: &FlankTarget, command: &Command, policy: ProfilePolicy) -> Share {
    let a = if target.rest.is_empty() {
        command.polynomial.clone()
    } else {
        command.polynomial.add(&target.fit_of_rest())
    };
    let mut parts = decompose_radial(&a, lines.t_k);
    // The target's own profile terms only: compensating ones are advice, not plan (spec 28 section 6).
    for (i, p) in parts.profile.iter_mut().enumerate() {
        *p = if i == 0 { 0.0 } else { a.coefficient(i, 0) };
    }
    if !policy.free_dresser {
        parts.profile.clear();
    }
    Share { parts, carried: Carried::default(), outside: target.outside }
}

impl IdealPlan {
    /// Splits the commands between tool, dresser and common motion under a law of the shift.
    ///
    /// # Errors
    /// [`GeneratingError::DegenerateDirection`], [`GeneratingError::NoFlank`].
    pub fn new(
        setup: &GrindingSetup,
        targets: &Sides<Option<FlankTarget>>,
        commanded: Sides<Option<Command>>,
        feed: &FeedLaw,
        policy: ProfilePolicy,
    ) -> Result<Self, GeneratingError> {
        let which: Vec<Flank> = targets.iter().filter(|(_, t)| t.is_some()).map(|(f, _)| f).collect();
        if which.is_empty() {
            return Err(GeneratingError::NoFlank);
        }
        let shares = Sides::try_from_fn(|flank| {
            let (Some(command), Some(target)) = (&commanded[flank], &targets[flank]) else { return Ok(None) };
            share(setup, flank, target, command, feed, policy).map(Some)
        })?;
        let shift = feed.law(setup, &which);
        let parts = shares.map(|_, s| s.as_ref().map(|s| s.parts.clone()));
        let [origin, slope, _] = shift.jet(0.0);
        let (delta_d, delta_phi_2) = common_motion(&setup.lines, &parts, [origin, slope]);
        let occupation = setup.occupation(&shift, &which);
        let outside = shares.map(|_, s| s.as_ref().map_or(0.0, |s| s.outside));
        let mut shares = shares;
        let worms = Sides::from_fn(|flank| {
            let share = shares[flank].take()?;
            Some(IdealWorm {
                lines: setup.lines[flank],
                shift: shift.clone(),
                parts: share.parts,
                carried: share.carried,
                reliefs: targets[flank].as_ref().map(|t| t.reliefs.clone()).unwrap_or_default(),
                given: match &setup.tool {
                    Tool::Given(modifications) => Some(modifications[flank].clone()),
                    Tool::Dressed(_) | Tool::Made => None,
                },
            })
        });
        let mut motion = setup.pair.motion(shift);
        motion.delta_d = delta_d;
        motion.delta_phi_2 = delta_phi_2;
        Ok(Self { feed: feed.clone(), commanded, worms, motion, occupation, outside })
    }

    /// Which terms of an error may go back into the command.
    pub(super) fn correction(&self, setup: &GrindingSetup) -> Correction {
        let carries = |w: &Option<IdealWorm>| w.as_ref().is_some_and(|w| !w.carried.is_empty());
        if self.feed.is_radial() || matches!(setup.tool, Tool::Given(_)) {
            Correction::Pure
        } else if self.worms.iter().any(|(_, w)| carries(w)) {
            Correction::Free
        } else {
            Correction::Mixed
        }
    }

    /// What the ideal worm leaves, against the target.
    ///
    /// # Errors
    /// Those of the exact contact.
    pub fn error(
        &self,
        setup: &GrindingSetup,
        targets: &Sides<Option<FlankTarget>>,
        grid: &PlanningGrid,
    ) -> Result<GroundError, GeneratingError> {
        GroundError::of(setup, targets, grid, |flank| {
            self.worms[flank].as_ref().map(|worm| {
                let thread = ModifiedThread::new(setup.pair.flanks[flank].worm, worm);
                grid.ground(setup, flank, &self.motion, &thread)
            })
        })
    }
}

/// The commands of a plan corrected by the errors it leaves.
pub(super) fn corrected(
    setup: &GrindingSetup,
    grid: &PlanningGrid,
    plan: &IdealPlan,
    error: &GroundError,
) -> Sides<Option<Command>> {
    let terms = plan.correction(setup);
    Sides::from_fn(|flank| {
        let (Some(command), Some(e)) = (&plan.commanded[flank], &error.error[flank]) else {
            return plan.commanded[flank].clone();
        };
        Some(grid.corrected(setup, flank, command, e, terms))
    })
}

/// Precompensation: corrects the command by the fitted error of the exact flank, `rounds` times or until a round does not
/// reduce the largest error. Returns the best plan, its error and the largest error per flank by round, mm.
///
/// # Errors
/// Those of [`IdealPlan::new`] and [`IdealPlan::error`] in the first round; a later round that fails ends the loop.
pub fn precompensate(
    setup: &GrindingSetup,
    targets: &Sides<Option<FlankTarget>>,
    grid: &PlanningGrid,
    feed: &FeedLaw,
    policy: ProfilePolicy,
    rounds: usize,
) -> Result<(IdealPlan, GroundError, Sides<Vec<f64>>), GeneratingError> {
    let command = targets.map(|_, t| t.as_ref().map(Command::of));
    let mut best = IdealPlan::new(setup, targets, command, feed, policy)?;
    let mut error = best.error(setup, targets, grid)?;
    let mut record: Sides<Vec<f64>> = Sides::from_fn(|f| error.largest(f).into_iter().collect());
    for _ in 0..rounds {
        let command = corrected(setup, grid, &best, &error);
        let Ok(next) = IdealPlan::new(setup, targets, command, feed, policy) else { break };
        let Ok(next_error) = next.error(setup, targets, grid) else { break };
        for flank in Flank::BOTH {
            record[flank].extend(next_error.largest(flank));
        }
        if next_error.max() >= error.max() {
            break;
        }
        (best, error) = (next, next_error);
    }
    Ok((best, error, record))
}
