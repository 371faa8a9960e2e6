//! Best fits over the diagonal ratios, and the plans that make them.

use super::super::carried::RestFit;
use super::super::least_squares::FunctionClass;
use super::super::{FeedLaw, FlankTarget, GeneratingError, GrindingSetup, IdealPlan, PlanningGrid};
use super::flank::{FlankFit, PlannedFlank};
use super::ratios::{candidates, fits};
use contact::ContactSolution;
use foundation::geometry::{Flank, Sides};
use foundation::modification::Modification;
use foundation::numerics::golden_section;
use rayon::prelude::*;
use std::sync::Arc;

/// Evaluations of the golden section about the best ratio.
const GOLDEN: usize = 8;

/// What is to be planned.
pub struct BestFitTask<'a> {
    setup: &'a GrindingSetup,
    which: Vec<Flank>,
    grid: &'a PlanningGrid,
    wanted: Sides<Vec<f64>>,
    given: Sides<Vec<Modification>>,
    free_profile: bool,
    /// Normal, mm.
    tolerance: f64,
}

/// A ratio with what its fit is expected to cost.
#[derive(Clone, Copy, Debug)]
pub struct Expected {
    /// K.
    pub ratio: f64,
    /// 1 is the tolerance or a limit of the envelope.
    pub cost: f64,
}

/// A best fit at one ratio, on its way to the exact flank.
#[derive(Clone)]
pub struct BestFit<'a> {
    feed: FeedLaw,
    fits: Sides<Option<Arc<(FlankFit<'a>, PlannedFlank)>>>,
    commands: Sides<Option<Vec<f64>>>,
}

/// Contacts on the grid with their points on the unmodified worm.
pub type Contacts = Vec<(ContactSolution, (f64, f64))>;

impl<'a> BestFitTask<'a> {
    /// Targets on a grid; `free_profile`: a dresser is made for them.
    ///
    /// # Errors
    /// Evaluation errors of the targets.
    pub fn new(
        setup: &'a GrindingSetup,
        targets: &'a Sides<Option<FlankTarget>>,
        grid: &'a PlanningGrid,
        free_profile: bool,
        tolerance: f64,
    ) -> Result<Self, GeneratingError> {
        let which: Vec<Flank> = targets.iter().filter(|(_, t)| t.is_some()).map(|(f, _)| f).collect();
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
                    let mut f = target.value(w, z)?;
                    for made in &given[flank] {
                        f -= made.value(w, z)?;
                    }
                    wanted.push(f);
                }
            }
            Ok::<_, GeneratingError>(wanted)
        })?;
        Ok(Self { setup, which, grid, wanted, given, free_profile, tolerance })
    }

    fn class(&self, ratio: f64) -> FunctionClass {
        let class = if ratio == 0.0 { FunctionClass::RADIAL } else { FunctionClass::CLPK };
        FunctionClass { profile: self.free_profile, ..class }
    }

    fn fits(&self, ratio: f64) -> Result<Sides<Option<FlankFit<'_>>>, GeneratingError> {
        let shift = FeedLaw::Ratio(ratio).law(self.setup, &self.which);
        Sides::try_from_fn(|flank| {
            if !self.which.contains(&flank) {
                return Ok(None);
            }
            FlankFit::new(
                self.setup,
                flank,
                (self.class(ratio), ratio, &shift),
                (&self.grid.w[flank], &self.grid.z),
                &self.wanted[flank],
                self.tolerance / self.setup.lines[flank].cos_b2,
            )
            .map(Some)
        })
    }

    fn cost(&self, ratio: f64) -> f64 {
        let fits = self.fits(ratio);
        fits.map_or(f64::INFINITY, |fits| {
            fits.iter().filter_map(|(_, fit)| fit.as_ref()).map(FlankFit::estimate).fold(0.0, f64::max)
        })
    }

    /// Ratios by what their fits are expected to cost, the best first; refined about the best. Among those well within the tolerance the
    /// smaller one comes first: it uses less worm.
    pub fn ratios(&self) -> Vec<Expected> {
        let expected = |ratio: f64| Expected { ratio, cost: self.cost(ratio) };
        let mut tried: Vec<Expected> =
            candidates(self.setup, &self.which).into_par_iter().map(expected).collect();
        let order = |a: &Expected, b: &Expected| {
            a.cost.total_cmp(&b.cost).then(a.ratio.abs().total_cmp(&b.ratio.abs()))
        };
        tried.sort_by(order);
        if let Some(best) = tried.first().copied().filter(|best| best.ratio != 0.0 && best.cost > 0.3) {
            let (a, b) = (0.8 * best.ratio, 1.25 * best.ratio);
            let mut found = Vec::new();
            golden_section(a, b, GOLDEN, |ratio| {
                if !fits(self.setup, &self.which, ratio) {
                    return f64::INFINITY;
                }
                let cost = self.cost(ratio);
                found.push(Expected { ratio, cost });
                cost
            });
            found.sort_by(order);
            tried.extend(found.first());
            tried.sort_by(order);
        }
        tried.retain(|tried| tried.cost.is_finite());
        tried
    }

    /// The best fit at a ratio with its first command.
    ///
    /// # Errors
    /// Where bodies have no contact of second order or numbers are not finite.
    pub fn at(&self, ratio: f64) -> Result<BestFit<'_>, GeneratingError> {
        let mut fits = self.fits(ratio)?;
        let fits = Sides::try_from_fn(|flank| {
            let Some(fit) = fits[flank].take() else { return Ok(None) };
            let planned = fit.plan().ok_or(GeneratingError::DegenerateDirection { flank, ratio })?;
            Ok::<_, GeneratingError>(Some(Arc::new((fit, planned))))
        })?;
        let commands = Sides::try_from_fn(|flank| {
            let Some((fit, planned)) = fits[flank].as_deref() else { return Ok(None) };
            fit.command(planned).map(Some).ok_or(GeneratingError::DegenerateDirection { flank, ratio })
        })?;
        Ok(BestFit { feed: FeedLaw::Ratio(ratio), fits, commands })
    }

    /// The plan of a best fit.
    ///
    /// # Errors
    /// `InvalidSpline`, `Law`.
    pub fn plan(&self, best: &BestFit<'_>) -> Result<IdealPlan, GeneratingError> {
        let decompositions: Sides<Option<Arc<RestFit>>> = Sides::try_from_fn(|flank| {
            let (Some((fit, planned)), Some(command)) = (best.fits[flank].as_deref(), &best.commands[flank])
            else {
                return Ok(None);
            };
            fit.decomposition(command, planned).map(Some)
        })?;
        let outside = Sides::from_fn(|flank| best.fits[flank].as_ref().map_or(0.0, |fit| fit.1.off));
        IdealPlan::of_fits(self.setup, &best.feed, &decompositions, &self.given, outside)
    }
}

impl BestFit<'_> {
    /// Corrects the commands where the tool touched. `false` where nothing is finite: the commands are as they were.
    pub fn correct(&mut self, setup: &GrindingSetup, contacts: &Sides<Option<Contacts>>) -> bool {
        let next = Sides::from_fn(|flank| {
            let (fit, planned) = self.fits[flank].as_deref()?;
            let (command, at) = (self.commands[flank].as_ref()?, contacts[flank].as_ref()?);
            fit.corrected(command, planned, at, setup.lines[flank].cos_b2)
        });
        let whole =
            Flank::BOTH.into_iter().all(|flank| next[flank].is_some() == self.commands[flank].is_some());
        if whole {
            self.commands = next;
        }
        whole
    }

    /// Largest distance between planned flank and contacts, normal, mm.
    pub fn off(&self, setup: &GrindingSetup, contacts: &Sides<Option<Contacts>>) -> f64 {
        let of_flank = |flank: Flank| {
            let ((_, planned), at) = (self.fits[flank].as_deref()?, contacts[flank].as_ref()?);
            let cos = setup.lines[flank].cos_b2;
            let off = planned.values.iter().zip(at).map(|(f, (contact, _))| (f * cos - contact.f_n).abs());
            Some(off.fold(0.0, f64::max))
        };
        Flank::BOTH.into_iter().filter_map(of_flank).fold(0.0, f64::max)
    }
}
