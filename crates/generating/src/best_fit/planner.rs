//! Best fits over the diagonal ratios, and the plans that make them.

use super::super::carried::FittedFlank;
use super::super::dressed::{dressing_response, finished_rolls};
use super::super::least_squares::FunctionClass;
use super::super::{
    DressingLimits, DressingRows, FeedLaw, FlankLines, FlankTarget, GeneratingError, GrindingSetup,
    IdealPlan, PlanningGrid,
};
use super::flank::{Contact, FlankCommand, FlankFit, Folds, SomeContacts, Step};
use super::programme::{AxisShares, Limits};
use super::within::Within;
use foundation::geometry::{Flank, Sides};
use foundation::modification::{Modification, ToleranceMap};
use std::sync::Arc;

/// What is to be planned.
pub struct BestFitTask<'a> {
    setup: &'a GrindingSetup,
    which: Vec<Flank>,
    grid: &'a PlanningGrid,
    /// Intervals of every function over the flank.
    intervals: usize,
    wanted: Sides<Vec<f64>>,
    /// The tightest tolerance over that of each place.
    weights: Sides<Vec<f64>>,
    given: Sides<Vec<Modification>>,
    free_profile: bool,
    within: Within,
    axes: Sides<AxisShares>,
    /// Lengths of roll between which the worm is finished, where the contact is to be kept there.
    reach: Sides<Option<[f64; 2]>>,
}

/// A best fit at one ratio, on its way to the exact flank.
#[derive(Clone)]
pub struct BestFit<'a> {
    feed: FeedLaw,
    fits: Sides<Option<Arc<FlankFit<'a>>>>,
    commands: Sides<Option<FlankCommand>>,
    /// What is left, transverse, mm.
    pub off: Sides<f64>,
}

/// Contacts on the grid.
pub type Contacts = Vec<Contact>;

/// What the functions of a flank ask of the axes, as shares of the limits.
fn axis_shares(
    setup: &GrindingSetup,
    flank: Flank,
    limits: DressingLimits,
    dressing: DressingRows,
) -> AxisShares {
    let lines = match dressing_response(setup, flank, dressing) {
        Some(answers) => (0..4).map(|j| answers[j].map(|by| by / limits.correction[j])).collect(),
        None => Vec::new(),
    };
    let of = &setup.lines[flank];
    AxisShares { lines, path: of.cos_b2 / (of.sin_an * limits.delta_d) }
}

/// The flank whose traces through the middle are those of the target, as a feed without shift leaves it: the helix trace moves along the
/// path of the contact from profile line to profile line.
fn with_natural_twist(
    target: &FlankTarget,
    lines: &FlankLines,
    w: f64,
    z: f64,
) -> Result<f64, GeneratingError> {
    let along = lines.t_k * (w - lines.w_m);
    Ok(target.value(lines.w_m, z + along)? + target.value(w, lines.z_m)?
        - target.value(lines.w_m, lines.z_m + along)?)
}

impl<'a> BestFitTask<'a> {
    /// Targets on a grid, with a map of the tolerance or the same everywhere; with `natural_twist` of each target what its traces through the
    /// middle become without shift. Functions with `intervals` over the flank; `free_profile`: a dresser is made for them.
    ///
    /// # Errors
    /// [`GeneratingError::NoFlank`]; evaluation errors of the targets.
    pub fn new(
        setup: &'a GrindingSetup,
        (targets, map, natural_twist): (&'a Sides<Option<FlankTarget>>, Option<&ToleranceMap>, bool),
        (grid, intervals): (&'a PlanningGrid, usize),
        (free_profile, dressing): (bool, DressingRows),
        within: Within,
    ) -> Result<Self, GeneratingError> {
        let which: Vec<Flank> = targets.iter().filter(|(_, t)| t.is_some()).map(|(f, _)| f).collect();
        if which.is_empty() {
            return Err(GeneratingError::NoFlank);
        }
        // With a given dresser the reliefs of a target are what that dresser leaves.
        let given = targets.map(|_, target| match target {
            Some(target) if !free_profile => target.reliefs.clone(),
            _ => Vec::new(),
        });
        let wanted = Sides::try_from_fn(|flank| {
            let Some(target) = &targets[flank] else { return Ok(Vec::new()) };
            let mut wanted = Vec::with_capacity(grid.w[flank].len() * grid.z.len());
            for &w in &grid.w[flank] {
                for &z in &grid.z {
                    let mut f = match natural_twist {
                        true => with_natural_twist(target, &setup.lines[flank], w, z)?,
                        false => target.value(w, z)?,
                    };
                    for made in &given[flank] {
                        f -= made.value(w, z)?;
                    }
                    wanted.push(f);
                }
            }
            Ok::<_, GeneratingError>(wanted)
        })?;
        let axes = Sides::from_fn(|flank| axis_shares(setup, flank, within.axes, dressing));
        let dresser = setup.dresser()?;
        let reach = Sides::from_fn(|flank| within.on_worm.then(|| finished_rolls(setup, dresser, flank)));
        let weights = grid.weights(map);
        Ok(Self { setup, which, grid, intervals, wanted, weights, given, free_profile, within, axes, reach })
    }

    fn class(&self, ratio: f64) -> FunctionClass {
        let class = if ratio == 0.0 { FunctionClass::RADIAL } else { FunctionClass::CLPK };
        FunctionClass { profile: self.free_profile, ..class }
    }

    /// What is fitted at a ratio.
    ///
    /// # Errors
    /// Where bodies have no contact of second order.
    pub fn fits(&self, ratio: f64) -> Result<Sides<Option<Arc<FlankFit<'_>>>>, GeneratingError> {
        let shift = FeedLaw::Ratio(ratio).law(self.setup, &self.which);
        Sides::try_from_fn(|flank| {
            if !self.which.contains(&flank) {
                return Ok(None);
            }
            let tolerance = self.within.tolerance / self.setup.lines[flank].cos_b2;
            let within = Within { tolerance, ..self.within };
            FlankFit::new(
                self.setup,
                flank,
                (self.class(ratio), ratio, &shift),
                (&self.grid.w[flank], &self.grid.z),
                (&self.wanted[flank], &self.weights[flank]),
                (within, &self.axes[flank], self.reach[flank]),
                self.intervals,
            )
            .map(|fit| Some(Arc::new(fit)))
        })
    }

    /// The bodies.
    pub fn setup(&self) -> &GrindingSetup {
        self.setup
    }

    /// Flanks that are ground.
    pub fn which(&self) -> &[Flank] {
        &self.which
    }

    /// What its fits keep to.
    pub fn within(&self) -> Within {
        self.within
    }

    /// What the flank that fares worse leaves at one ratio at least, in tolerances.
    pub fn least_at(&self, ratio: f64, least_determinant: f64, limits: Limits) -> Option<f64> {
        let fits = self.fits(ratio).ok()?;
        let mut least: f64 = 0.0;
        for (_, fit) in fits.iter() {
            let Some(fit) = fit else { continue };
            least = least.max(fit.least(least_determinant, limits)?);
        }
        Some(least)
    }

    /// How far ground flanks lie from the class at a ratio, in tolerances: `ground` are their values on the grid, transverse, mm.
    pub fn beyond_class(&self, ratio: f64, ground: &Sides<Option<Vec<f64>>>) -> Option<f64> {
        let fits = self.fits(ratio).ok()?;
        let mut most: f64 = 0.0;
        for (flank, fit) in fits.iter() {
            let (Some(fit), Some(ground)) = (fit, &ground[flank]) else { continue };
            let places = self.grid.w[flank].iter().flat_map(|&w| self.grid.z.iter().map(move |&z| (w, z)));
            let mut own = ground.clone();
            for ((w, z), f) in places.zip(&mut own) {
                for made in &self.given[flank] {
                    *f -= made.value(w, z).ok()?;
                }
            }
            most = most.max(fit.beyond_class(&own)? * self.setup.lines[flank].cos_b2);
        }
        Some(most / self.within.tolerance)
    }

    /// The best fit at a ratio with its first command, for a share of what is wanted, smooth within `near` tolerances.
    ///
    /// # Errors
    /// Where bodies have no contact of second order or numbers are not finite.
    pub fn at(&self, ratio: f64, (share, near): (f64, f64)) -> Result<BestFit<'_>, GeneratingError> {
        let fits = self.fits(ratio)?;
        let command = |flank: Flank| {
            let fit = fits[flank].as_ref();
            fit.map(|fit| {
                fit.command(share, near).ok_or(GeneratingError::DegenerateDirection { flank, ratio })
            })
            .transpose()
        };
        let (left, right) = rayon::join(|| command(Flank::Left), || command(Flank::Right));
        let commands = Sides { left: left?, right: right? };
        Ok(BestFit { feed: FeedLaw::Ratio(ratio), fits, commands, off: Sides::both(0.0) })
    }

    /// The plan of a best fit.
    ///
    /// # Errors
    /// `InvalidSpline`, `Law`.
    pub fn plan(&self, best: &BestFit<'_>) -> Result<IdealPlan, GeneratingError> {
        let fitted: Sides<Option<FittedFlank>> = Sides::try_from_fn(|flank| {
            let (Some(fit), Some(command)) = (best.fits[flank].as_deref(), &best.commands[flank]) else {
                return Ok(None);
            };
            fit.decomposition(command, best.off[flank]).map(Some)
        })?;
        IdealPlan::of_fits(self.setup, &best.feed, &fitted, &self.given)
    }
}

impl BestFit<'_> {
    /// The best fit whose command lies in the middle between two of one ratio.
    pub fn halfway(&self, to: &Self) -> Self {
        let commands = Sides::from_fn(|flank| {
            let (from, to) = (self.commands[flank].as_ref()?, to.commands[flank].as_ref()?);
            Some(from.halfway(to))
        });
        Self { commands, ..self.clone() }
    }

    /// The next best fit, from where the tool touched, not curved too much where others nearly folded; `None` where a programme has no
    /// solution.
    pub fn next(
        &self,
        setup: &GrindingSetup,
        contacts: &Sides<Option<Contacts>>,
        step: Step,
        folds: &Sides<Folds>,
    ) -> Option<Self> {
        let next = |flank: Flank| {
            let (fit, command, at) =
                (self.fits[flank].as_ref()?, self.commands[flank].as_ref()?, contacts[flank].as_ref()?);
            fit.next(command, at, (step, &folds[flank]), setup.lines[flank].cos_b2)
        };
        let (left, right) = rayon::join(|| next(Flank::Left), || next(Flank::Right));
        let commands = Sides { left, right };
        let whole = commands.iter().all(|(flank, next)| next.is_some() == self.commands[flank].is_some());
        whole.then(|| Self { commands, ..self.clone() })
    }

    /// Notes where these commands nearly fold, by contacts of their tool.
    pub fn note_folds(&self, contacts: &Sides<SomeContacts>, folds: &mut Sides<Folds>) {
        for flank in Flank::BOTH {
            if let (Some(fit), Some(command)) = (&self.fits[flank], &self.commands[flank]) {
                fit.note_folds(command, &contacts[flank], &mut folds[flank]);
            }
        }
    }

    /// Least determinant ratio of the commands between contacts on the grid, where each stands for itself: what a grid passes over.
    pub fn least_between(&self, contacts: &Sides<Option<Contacts>>) -> f64 {
        let of_flank = |flank: Flank| {
            let (fit, command, at) =
                (self.fits[flank].as_ref()?, self.commands[flank].as_ref()?, contacts[flank].as_ref()?);
            fit.least_between(command, at)
        };
        Flank::BOTH.into_iter().filter_map(of_flank).fold(f64::INFINITY, f64::min)
    }

    /// Notes what contacts leave; the largest, normal, mm.
    pub fn judge(&mut self, setup: &GrindingSetup, contacts: &Sides<Option<Contacts>>) -> f64 {
        let mut largest: f64 = 0.0;
        for flank in Flank::BOTH {
            let (Some(fit), Some(at)) = (&self.fits[flank], &contacts[flank]) else { continue };
            let cos = setup.lines[flank].cos_b2;
            self.off[flank] = fit.off(at, cos);
            largest = largest.max(self.off[flank] * cos);
        }
        largest
    }
}
