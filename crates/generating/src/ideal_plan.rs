//! Tool functions and motion for one command, before any dresser is asked, and what the ideal tool leaves
//! (`docs/mathematics/planning.md`).

use super::carried::{Carried, FittedFlank};
use super::motion::with_fitted_motion;
use super::planning_grid::GroundError;
use super::share::{RestCarrier, share};
use super::{
    Command, Decomposition, FeedLaw, FlankTarget, GeneratingError, GrindingSetup, IdealWorm, PlanningGrid,
    ProfilePolicy, Tool, common_motion,
};
use contact::ModifiedThread;
use foundation::geometry::{Flank, Sides};
use foundation::kinematics::{GeneratingMotion, MotionLaw};
use foundation::modification::Modification;

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
