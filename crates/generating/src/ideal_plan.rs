//! Tool functions and motion for one command, before any dresser is asked, and what the ideal tool leaves (`docs/mathematics/planning.md`):
//! the command of each flank is split between motion, dresser and lines of the tool
//! (`docs/mathematics/generating-contact.md#decomposition-of-a-target`, `docs/mathematics/planning.md#who-carries-what`).

use super::carried::{Carried, FittedFlank, RestFit, misfit_of_lines};
use super::least_squares::{DiagonalCoordinates, FitSettings, FunctionClass};
use super::motion::with_fitted_motion;
use super::planning_grid::GroundError;
use super::{
    Decomposition, FeedLaw, FieldSpline, FlankLines, FlankTarget, GeneratingError, GrindingSetup, IdealWorm,
    PlanningGrid, ProfilePlace, ProfilePolicy, Tool, common_motion, decompose_diagonal, decompose_radial,
};
use contact::ModifiedThread;
use foundation::geometry::{Flank, Sides};
use foundation::kinematics::{GeneratingMotion, MotionLaw};
use foundation::modification::Modification;
use foundation::numerics::Polynomial2;
use std::sync::Arc;

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

    /// The plan that makes functions fitted to the whole targets, under a law of the shift; `given` are the profiles that a dresser
    /// already has.
    ///
    /// # Errors
    /// [`GeneratingError::Law`] for amounts that are not finite.
    pub(super) fn of_fits(
        setup: &GrindingSetup,
        feed: &FeedLaw,
        fitted: &Sides<Option<FittedFlank>>,
        given: &Sides<Vec<Modification>>,
    ) -> Result<Self, GeneratingError> {
        let which: Vec<Flank> = Flank::BOTH.into_iter().filter(|&flank| fitted[flank].is_some()).collect();
        let shift = feed.law(setup, &which);
        let fits = fitted.map(|_, f| f.as_ref().map(|f| f.fit.clone()));
        let still = (MotionLaw::zero(), MotionLaw::zero());
        let (delta_d, delta_phi_2) = with_fitted_motion(setup, still, &fits, &shift, &which)?;
        let worms = Sides::from_fn(|flank| {
            let fitted = fitted[flank].clone()?;
            Some(IdealWorm {
                lines: setup.lines[flank],
                shift: shift.clone(),
                parts: Decomposition::nothing(setup.lines[flank].t_k),
                carried: Carried { fitted: Some(fitted.fit), ..Carried::default() },
                reliefs: given[flank].clone(),
                moved: None,
                spline: fitted.profile,
                given: None,
            })
        });
        let occupation = setup.occupation(&shift, &which);
        let mut motion = setup.pair.motion(shift);
        motion.delta_d = delta_d;
        motion.delta_phi_2 = delta_phi_2;
        let (commanded, rest) = (Sides { left: None, right: None }, Sides { left: None, right: None });
        let outside = Sides::both(0.0);
        Ok(Self { feed: feed.clone(), commanded, worms, motion, occupation, outside, rest })
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
                moved: targets[flank].as_ref().and_then(|t| t.moved.clone()),
                spline: None,
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
    /// Closed decomposition.
    parts: Decomposition,
    /// What the lines carry beside it.
    carried: Carried,
    /// How the rest of the target is carried.
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

/// Steepest worm lines on the workpiece, |tan(rho_2)|: beyond it the shift is too small to tell them from the profile.
const STEEPEST: f64 = 1e4;

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
    if setup.strokes.is_some() && !target.rest.is_empty() {
        let misfit: f64 = target.rest.iter().map(|term| misfit_of_lines(term, lines, t)).sum();
        if misfit > policy.line_tolerance {
            // Strokes that follow it make it as it stands, each on its part of the profile.
            let polynomial = Some(command.polynomial.clone());
            let carried = Carried { polynomial, terms: target.rest.clone(), fitted: None, corrections };
            return Ok(Share::whole(Decomposition::nothing(lines.t_k), carried));
        }
    }
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
    // The target's own profile terms only: compensating ones are advice, not plan
    // (`docs/mathematics/generating-contact.md#what-the-grinding-motion-leaves-to-first-order`).
    for (i, p) in parts.profile.iter_mut().enumerate() {
        *p = if i == 0 { 0.0 } else { a.coefficient(i, 0) };
    }
    if !policy.free_dresser {
        // What three pitch points make of a dresser that is given.
        let made = if policy.place == ProfilePlace::Correction { 3 } else { 0 };
        parts.profile.truncate(made);
    }
    Share { parts, carried: Carried::default(), rest: RestCarrier::Polynomials, outside: target.outside }
}
