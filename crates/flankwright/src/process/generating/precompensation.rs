//! From a commanded polynomial to worm functions and motion, the exact flank they leave, and the correction of the command
//! (spec 28 section 4, steps 2 to 5).

use super::carried::{RestFit, misfit_of_lines};
use super::least_squares::{DiagonalCoordinates, FitNorm, FitSettings, FunctionClass};
use super::motion::with_fitted_motion;
use super::target::ClassFit;
use super::{
    Carried, Decomposition, FeedLaw, FieldSpline, FlankLines, FlankTarget, GeneratingError, GrindingSetup,
    IdealWorm, ProfilePlace, Tool, common_motion, decompose_diagonal, decompose_radial,
};
use crate::contact::{ContactSolution, ExactContact, ModifiedThread, ToolSurface};
use crate::geometry::{Flank, Sides};
use crate::kinematics::{GeneratingMotion, MotionLaw};
use crate::numerics::Polynomial2;
use std::sync::Arc;

/// Rounds of precompensation with the ideal worm (spec 28 section 4).
pub(super) const ROUNDS: usize = 4;
/// Rounds where the correction is free: reliefs and steep lines shift the contact further, each round gains less.
pub(super) const FREE_ROUNDS: usize = 12;

/// A free correction ends below this error, mm: a nanometre is far below what anything can hold.
const FINE: f64 = 1e-6;

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
    /// What a best fit makes small.
    pub norm: FitNorm,
    /// Free coefficients of the decomposition per flank; `None`: gauge `centred`.
    pub gauge: Sides<Option<FreeCoefficients>>,
}

/// The free coefficients of a decomposition, in centred variables, transverse (spec 25 section 4).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FreeCoefficients {
    /// K_10, mm/mm.
    pub k_10: f64,
    /// Share of u^2 in the profile, mm/mm^2; `None`: by the place of the profile crowning.
    pub k_20: Option<f64>,
    /// K_K0, mm.
    pub k_k0: f64,
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

/// Cells over profile and face width of a correction, the finest that the feet determine is taken.
const CORRECTION_CELLS: [[usize; 2]; 3] = [[6, 16], [4, 10], [2, 5]];

/// The command corrected by the normal errors `e` (target - ground, mm): what the class of polynomials takes, and the rest as a
/// smooth function. Errors are put where the tool touches (`feet`): there the flank follows the tool one to one, whatever the
/// contact has moved by (envelope theorem; dm/df_n1 of spec 20 section 14).
fn freely_corrected(lines: &FlankLines, command: &Command, e: &[f64], feet: &[(f64, f64)]) -> Command {
    let centred: Vec<(f64, f64)> = feet.iter().map(|&(w, z)| (w - lines.w_m, z - lines.z_m)).collect();
    let transverse: Vec<f64> = e.iter().map(|e| e / lines.cos_b2).collect();
    let fitted = ClassFit::new(&centred).fit(&transverse);
    let points: Vec<[f64; 3]> = feet
        .iter()
        .zip(&centred)
        .zip(&transverse)
        .map(|((&(w, z), &(u, y)), f)| [w, z, f - fitted.value(u, y)])
        .collect();
    let mut next = command.clone();
    next.polynomial = command.polynomial.add(&fitted);
    let spline = CORRECTION_CELLS.into_iter().find_map(|cells| FieldSpline::near(&points, cells).ok());
    next.corrections.extend(spline.map(Arc::new));
    next
}

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
    /// How the rest of the targets is carried.
    rest: Sides<Option<RestCarrier>>,
}

/// Error of an ideal plan on the planning grid.
#[derive(Clone, Debug)]
pub struct GroundError {
    /// target - ground per grid point and flank, normal, mm.
    pub error: Sides<Option<Vec<f64>>>,
    /// The workpiece points (w_2, z_2) that the tool points in contact would grind unmodified, per grid point and flank: a
    /// correction of the tool acts where the contact stands, and that moves with the modification. mm.
    feet: Sides<Option<Vec<(f64, f64)>>>,
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
        shift: &MotionLaw,
        ground: impl Fn(Flank) -> Option<Result<Vec<ContactSolution>, GeneratingError>>,
        foot: impl Fn(Flank, &ContactSolution) -> Option<(f64, f64)>,
    ) -> Result<Self, GeneratingError> {
        let mut determinant = f64::INFINITY;
        let mut feet = Sides { left: None, right: None };
        let error = Sides::try_from_fn(|flank| -> Result<_, GeneratingError> {
            let (Some(ground), Some(target)) = (ground(flank), &targets[flank]) else { return Ok(None) };
            let ground = ground?;
            let lines = &setup.lines[flank];
            let wanted = grid.target(flank, target, lines.cos_b2)?;
            determinant = ground.iter().map(|g| g.determinant_ratio).fold(determinant, f64::min);
            if !shift.is_constant() {
                let on_work = |g| {
                    let (w_1, z_1) = foot(flank, g)?;
                    let [w, z] = lines.work_point(w_1, z_1, shift);
                    Some((w.f, z.f))
                };
                feet[flank] = ground.iter().map(on_work).collect();
            }
            Ok(Some(wanted.iter().zip(&ground).map(|(t, g)| t - g.f_n).collect()))
        })?;
        Ok(Self { error, feet, determinant })
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

/// How the parts of a target that are no polynomials are carried.
#[derive(Clone, Debug)]
enum RestCarrier {
    /// There are none, or a tool carries them whatever they are.
    Whole,
    /// They stand on the lines as they are, missing them by this much, transverse, mm.
    Lines(f64),
    /// Worm functions and a motion by least squares.
    Fitted(Arc<RestFit>),
    /// The class of polynomials fits them better than splines do.
    Polynomials,
}

impl RestCarrier {
    /// The best carrier under a constant ratio with lines of direction t.
    fn of(
        target: &FlankTarget,
        lines: &FlankLines,
        t: f64,
        policy: ProfilePolicy,
    ) -> Result<Self, GeneratingError> {
        let Some(samples) = &target.rest_samples else { return Ok(Self::Whole) };
        let misfit: f64 = target.rest.iter().map(|term| misfit_of_lines(term, lines, t)).sum();
        if misfit <= policy.line_tolerance {
            return Ok(Self::Lines(misfit));
        }
        let coordinates = DiagonalCoordinates::new(t, lines.t_k, lines.profile_slope())?;
        let settings = FitSettings { norm: policy.norm, ..FitSettings::new(FunctionClass::CLK) };
        let fit = RestFit::fit(samples, coordinates, &settings)?;
        let better = fit.report.quality().largest < target.outside;
        Ok(if better { Self::Fitted(Arc::new(fit)) } else { Self::Polynomials })
    }
}

/// One flank's share of a plan.
struct Share {
    parts: Decomposition,
    carried: Carried,
    rest: RestCarrier,
    /// Best-fitted only, mm.
    outside: f64,
}

impl Share {
    /// Parts and carried functions that leave nothing outside.
    fn whole(parts: Decomposition, carried: Carried) -> Self {
        Self { parts, carried, rest: RestCarrier::Whole, outside: 0.0 }
    }
}

/// Splits the command of one flank between motion, dresser and lines of the tool.
fn share(
    setup: &GrindingSetup,
    flank: Flank,
    target: &FlankTarget,
    command: &Command,
    feed: &FeedLaw,
    policy: ProfilePolicy,
    known: Option<&RestCarrier>,
) -> Result<Share, GeneratingError> {
    let lines = &setup.lines[flank];
    if matches!(setup.tool, Tool::Given(_)) {
        // The tool is what it is: only the motion is free.
        let mut parts = decompose_radial(&command.polynomial, lines.t_k);
        parts.profile.clear();
        return Ok(Share::whole(parts, Carried::default()));
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
        let carried = Carried { polynomial, terms: target.rest.clone(), fitted: None, corrections };
        return Ok(Share::whole(Decomposition::nothing(lines.t_k), carried));
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
        let carried = Carried { polynomial, terms: target.rest.clone(), fitted: None, corrections };
        return Ok(Share::whole(parts, carried));
    };
    let t = lines.work_direction(ratio);
    let rest = match known {
        Some(rest) => rest.clone(),
        None => RestCarrier::of(target, lines, t, policy)?,
    };
    let a = match rest {
        RestCarrier::Polynomials => a.add(&target.fit_of_rest()),
        _ => a.clone(),
    };
    let p_2 = match policy.place {
        ProfilePlace::Diagonal => 0.0,
        ProfilePlace::Dresser | ProfilePlace::Correction => a.coefficient(2, 0),
    };
    let free = policy.gauge[flank];
    let p_2 = free.and_then(|free| free.k_20).unwrap_or(p_2);
    let mut parts = decompose_diagonal(&a, t, lines.t_k, p_2, lines.profile_slope());
    if let Some(free) = free {
        parts = parts.with_gauge(free.k_10, free.k_k0);
    }
    if !policy.free_dresser {
        parts.profile.truncate(3); // no dresser is there to carry u^3 and higher
    }
    let (terms, fitted, outside) = match &rest {
        RestCarrier::Whole => (Vec::new(), None, 0.0),
        RestCarrier::Lines(misfit) => (target.rest.clone(), None, *misfit),
        RestCarrier::Fitted(fit) => (Vec::new(), Some(fit.clone()), fit.report.quality().largest),
        RestCarrier::Polynomials => (Vec::new(), None, target.outside),
    };
    Ok(Share { parts, carried: Carried { polynomial: None, terms, fitted, corrections }, rest, outside })
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
    Share { parts, carried: Carried::default(), rest: RestCarrier::Polynomials, outside: target.outside }
}

impl IdealPlan {
    /// A plan that is nothing but its settings: what stands in a job, without targets or commands.
    pub fn of_settings(
        worms: Sides<Option<IdealWorm>>,
        motion: GeneratingMotion,
        occupation: [f64; 2],
    ) -> Self {
        Self {
            feed: FeedLaw::Law(motion.shift.clone()),
            commanded: Sides { left: None, right: None },
            worms,
            motion,
            occupation,
            outside: Sides::both(0.0),
            rest: Sides { left: None, right: None },
        }
    }

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
        Self::with_rest(setup, targets, commanded, feed, policy, &Sides { left: None, right: None })
    }

    /// The same plan with other commands.
    ///
    /// # Errors
    /// As [`IdealPlan::new`].
    pub(super) fn commanding(
        &self,
        setup: &GrindingSetup,
        targets: &Sides<Option<FlankTarget>>,
        commanded: Sides<Option<Command>>,
        policy: ProfilePolicy,
    ) -> Result<Self, GeneratingError> {
        Self::with_rest(setup, targets, commanded, &self.feed, policy, &self.rest)
    }

    fn with_rest(
        setup: &GrindingSetup,
        targets: &Sides<Option<FlankTarget>>,
        commanded: Sides<Option<Command>>,
        feed: &FeedLaw,
        policy: ProfilePolicy,
        known: &Sides<Option<RestCarrier>>,
    ) -> Result<Self, GeneratingError> {
        let which: Vec<Flank> = targets.iter().filter(|(_, t)| t.is_some()).map(|(f, _)| f).collect();
        if which.is_empty() {
            return Err(GeneratingError::NoFlank);
        }
        let shares = Sides::try_from_fn(|flank| {
            let (Some(command), Some(target)) = (&commanded[flank], &targets[flank]) else { return Ok(None) };
            share(setup, flank, target, command, feed, policy, known[flank].as_ref()).map(Some)
        })?;
        let shift = feed.law(setup, &which);
        let parts = shares.map(|_, s| s.as_ref().map(|s| s.parts.clone()));
        let [origin, slope, _] = shift.jet(0.0);
        let (delta_d, delta_phi_2) = {
            let fits = shares.map(|_, s| s.as_ref().and_then(|s| s.carried.fitted.clone()));
            let polynomials = common_motion(&setup.lines, &parts, [origin, slope]);
            with_fitted_motion(setup, polynomials, &fits, &shift, &which)?
        };
        let occupation = setup.occupation(&shift, &which);
        let outside = shares.map(|_, s| s.as_ref().map_or(0.0, |s| s.outside));
        let rest = shares.map(|_, s| s.as_ref().map(|s| s.rest.clone()));
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
        Ok(Self { feed: feed.clone(), commanded, worms, motion, occupation, outside, rest })
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
        let ground = |flank: Flank| {
            self.worms[flank].as_ref().map(|worm| {
                let thread = ModifiedThread::new(setup.pair.flanks[flank].worm, worm);
                grid.ground(setup, flank, &self.motion, &thread)
            })
        };
        // The parameters of a thread are (w_1, z_1).
        GroundError::of(setup, targets, grid, &self.motion.shift, ground, |_, at| Some(at.tool))
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
        Some(match (&error.feet[flank], terms) {
            (Some(feet), Correction::Free) => freely_corrected(&setup.lines[flank], command, e, feet),
            _ => {
                let mixed = terms != Correction::Pure;
                let fitted = grid.correction(flank, e, setup.lines[flank].cos_b2, mixed);
                Command { polynomial: command.polynomial.add(&fitted), ..command.clone() }
            }
        })
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
        if best.correction(setup) == Correction::Free && error.max() < FINE {
            break;
        }
        let command = corrected(setup, grid, &best, &error);
        let Ok(next) = best.commanding(setup, targets, command, policy) else { break };
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
