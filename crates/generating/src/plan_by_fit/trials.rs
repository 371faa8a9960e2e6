//! What the fits of one plan share, and what comes of them.

use super::super::ratio::NoPlan;
use super::super::{GeneratingError, GrindingPlan, PlanningGrid};
use std::cell::Cell;

/// How a command follows one that folds or comes no nearer. What neither manner meets is near the limits of the bodies, where small things
/// decide: two ways find more than one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Manner {
    /// It stays nearer to the last one that did.
    Near,
    /// Its curvature is bounded where commands that were tried nearly folded, also where the worm as dressed does.
    Noting,
}

impl Manner {
    pub(super) const ALL: [Self; 2] = [Self::Near, Self::Noting];
}

/// A fit at one ratio with its tool.
pub(super) struct FittedPlan {
    pub(super) plan: GrindingPlan,
    /// What speaks against it, mm.
    pub(super) strain: f64,
    /// Whether its command folds between the points of the grid, as far as the second order tells.
    pub(super) folds: bool,
}

/// A fit that came to no plan.
pub(super) struct Failed {
    pub(super) error: GeneratingError,
    /// What its ideal worm leaves, limits that are not kept included, mm, where that was why no tool was made.
    pub(super) left: Option<f64>,
}

impl From<GeneratingError> for Failed {
    fn from(error: GeneratingError) -> Self {
        Self { error, left: None }
    }
}

/// Which fits get a tool.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Dressed {
    /// Those whose ideal worm promises a plan.
    Promising,
    /// All.
    Each,
}

/// What the fits of one plan share.
pub(super) struct Trials<'t> {
    pub(super) grid: &'t PlanningGrid,
    /// What the rules came to.
    pub(super) ruled: &'t Result<GrindingPlan, Box<NoPlan>>,
    /// How commands follow each other.
    pub(super) manner: Manner,
    /// Commands that were carried out.
    pub(super) rounds: Cell<usize>,
    /// So many are the end of it, with and without a plan.
    pub(super) rounds_in_all: [usize; 2],
}

impl Trials<'_> {
    /// Whether it is noted where commands nearly fold.
    pub(super) fn notes(&self) -> bool {
        self.manner == Manner::Noting
    }

    pub(super) fn count(&self) {
        self.rounds.set(self.rounds.get() + 1);
    }

    /// Whether no more is tried; `nearly` tells whether there is a plan, if perhaps with a fold.
    pub(super) fn are_over(&self, nearly: bool) -> bool {
        self.rounds.get() >= self.rounds_in_all[usize::from(!nearly)]
    }
}
