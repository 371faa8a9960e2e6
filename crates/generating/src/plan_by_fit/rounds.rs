//! Rounds of one fit: a first command, others that come nearer to the target from where its tool touches, and the step from the ideal worm to
//! the one as dressed.

use super::super::best_fit::{BestFit, BestFitTask, Contacts, Folds, NEAR, SomeContacts, Step};
use super::super::plan::PlanTask;
use super::super::{GeneratingError, IdealPlan};
use super::trials::Trials;
use super::{GOOD, SETTLED};
use foundation::geometry::Sides;

/// Price of moving the contact, what it grows by where a round does not come nearer, also where folds are noted, and falls by where it does; rounds that do not or hardly,
/// one after the other, at most, and where a plan is good already; the largest price; and the share of the last distance below which a round within the tolerance is worth another.
const HOLD: f64 = 10.0;
const TIGHTER: f64 = 10.0;
const TIGHTER_WHERE_NOTED: f64 = 5.0;
const LOOSER: f64 = 3.0;
const FAILURES: usize = 4;
const PATIENCE_WHERE_GOOD: usize = 1;
const LARGEST_HOLD: f64 = 1e5;
const WORTH: f64 = 0.9;
/// A round that leaves more than this share of the last distance counts like one that does not come nearer.
const HARDLY: f64 = 0.97;
/// The smallest step towards a command that folds, over the part that is reached then, and steps at most.
const LEAST_STEP: f64 = 0.05;
const PARTS: usize = 10;
/// Commands that follow one whose worm folds as dressed, at most.
const LESS_CURVED: usize = 3;

/// Ways to a command that folds if it is made at once; a part of 1 is the command.
#[derive(Clone, Copy, Debug)]
enum Way {
    /// From smoother ones, further from the target.
    Nearness,
    /// From a share of what is wanted.
    Share,
}

impl Way {
    const ALL: [Self; 2] = [Self::Nearness, Self::Share];

    /// Parts with which to begin.
    fn first(self) -> &'static [f64] {
        match self {
            Self::Nearness => &[0.2, 0.05],
            Self::Share => &[0.4, 0.15],
        }
    }

    /// The next part.
    fn more(self, part: f64) -> f64 {
        match self {
            Self::Nearness => 2.0 * part,
            Self::Share => part + 0.3,
        }
        .min(1.0)
    }

    /// Share of what is wanted and nearness of a part.
    fn aim(self, part: f64) -> (f64, f64) {
        match self {
            Self::Nearness => (1.0, NEAR / part),
            Self::Share => (part, NEAR),
        }
    }
}

/// A command of which no tool is made.
pub(super) struct NoTool {
    pub(super) error: GeneratingError,
    /// Contacts that are known nevertheless.
    pub(super) known: Sides<SomeContacts>,
}

impl From<GeneratingError> for Box<NoTool> {
    fn from(error: GeneratingError) -> Self {
        Self::new(NoTool { error, known: Sides::both(Vec::new()) })
    }
}

/// What makes the tool of a plan and its contacts.
pub(super) type Carrying<T> = Result<(T, Sides<Option<Contacts>>), Box<NoTool>>;

/// Contacts with their grid points.
pub(super) fn numbered(contacts: &Sides<Option<Contacts>>) -> Sides<SomeContacts> {
    Sides::from_fn(|flank| contacts[flank].iter().flatten().copied().enumerate().collect())
}

/// A fit that is carried out.
pub(super) struct CarriedOut<'f, T> {
    pub(super) fit: BestFit<'f>,
    pub(super) made: T,
    pub(super) contacts: Sides<Option<Contacts>>,
}

/// The tool of a fit and its contacts.
fn carried<T>(
    task: &BestFitTask<'_>,
    fit: &BestFit<'_>,
    carried_out: impl FnOnce(IdealPlan) -> Carrying<T>,
) -> Carrying<T> {
    carried_out(task.plan(fit)?)
}

impl PlanTask<'_> {
    /// The tool of a fit with its contacts. Where its envelope folds though that of the ideal worm does not, other commands near the ideal one
    /// follow, less curved there.
    pub(super) fn first_dressed<'f, T>(
        &self,
        task: &BestFitTask<'_>,
        trials: &Trials<'_>,
        ideal: CarriedOut<'f, IdealPlan>,
        (carried_out, folds): (&impl Fn(IdealPlan) -> Carrying<T>, &mut Sides<Folds>),
    ) -> Result<CarriedOut<'f, T>, GeneratingError> {
        let mut fit = ideal.fit.clone();
        let mut refused = match carried_out(ideal.made) {
            Ok((made, contacts)) => return Ok(CarriedOut { fit, made, contacts }),
            Err(refused) => refused,
        };
        let tries = if trials.notes() { LESS_CURVED } else { 0 };
        for _ in 0..tries {
            fit.note_folds(&refused.known, folds);
            let step = Step { share: 1.0, hold: HOLD, near: NEAR };
            let Some(next) = ideal.fit.next(self.setup, &ideal.contacts, step, folds) else { break };
            fit = next;
            trials.count();
            match carried(task, &fit, carried_out) {
                Ok((made, contacts)) => return Ok(CarriedOut { fit, made, contacts }),
                Err(again) => refused = again,
            }
        }
        Err(refused.error)
    }

    /// The first command with its contacts. Where it folds, a smoother one comes first and is brought nearer from its contacts as far as that
    /// goes; where that folds too, a share of what is wanted, and more of it.
    pub(super) fn begun<'f>(
        &self,
        task: &'f BestFitTask<'_>,
        trials: &Trials<'_>,
        ratio: f64,
        (carried_out, folds): (&impl Fn(IdealPlan) -> Carrying<IdealPlan>, &mut Sides<Folds>),
    ) -> Result<CarriedOut<'f, IdealPlan>, GeneratingError> {
        let mut at = |way: Way, part: f64| {
            trials.count();
            let fit = task.at(ratio, way.aim(part))?;
            match carried(task, &fit, carried_out) {
                Ok((made, contacts)) => Ok(CarriedOut { fit, made, contacts }),
                Err(no) => {
                    fit.note_folds(&no.known, folds);
                    Err(no.error)
                }
            }
        };
        let refusal = match at(Way::Share, 1.0) {
            Ok(begun) => return Ok(begun),
            Err(error) => error,
        };
        let mut first = |way: Way| {
            way.first().iter().find_map(|&part| at(way, part).ok().map(|begun| (way, part, begun)))
        };
        let (way, mut part, mut begun) = Way::ALL.into_iter().find_map(&mut first).ok_or(refusal)?;
        for _ in 0..PARTS {
            let mut more = way.more(part);
            let (share, near) = way.aim(more);
            let step = Step { share, hold: HOLD, near };
            let Some(mut fit) = begun.fit.next(self.setup, &begun.contacts, step, folds) else { break };
            let next = loop {
                trials.count();
                match carried(task, &fit, carried_out) {
                    Ok((made, contacts)) => break Some(CarriedOut { fit, made, contacts }),
                    Err(no) => fit.note_folds(&no.known, folds),
                }
                if more - part < LEAST_STEP * more {
                    break None;
                }
                // A command on the way is a part of the way.
                (fit, more) = (begun.fit.halfway(&fit), 0.5 * (part + more));
            };
            let Some(next) = next else { break };
            (begun, part) = (next, more);
            if part >= 1.0 {
                break;
            }
        }
        Ok(begun)
    }

    /// Corrects a fit and its plan where the tool touches, as long as a round comes nearer; `carried_out` makes the tool of a plan and its
    /// contacts. With the distance to the target after each round, mm, to which limits that are not kept add.
    pub(super) fn settled<'f, T>(
        &self,
        task: &BestFitTask<'_>,
        trials: &Trials<'_>,
        CarriedOut { mut fit, mut made, mut contacts }: CarriedOut<'f, T>,
        rounds: usize,
        (carried_out, folds): (impl Fn(IdealPlan) -> Carrying<T>, &mut Sides<Folds>),
    ) -> (CarriedOut<'f, T>, Vec<f64>) {
        let judge = |fit: &mut BestFit<'_>, at: &Sides<Option<Contacts>>| {
            fit.judge(self.setup, at) + self.tolerance * self.strain(at)
        };
        let tighter = if trials.notes() { TIGHTER_WHERE_NOTED } else { TIGHTER };
        let mut off = judge(&mut fit, &contacts);
        let mut record = vec![off];
        for &near in self.nears() {
            let (mut hold, mut failed, mut gently, mut tightened) = (HOLD, 0, 0, false);
            let last = record.len() + rounds;
            while record.len() < last && off > (near + SETTLED) * self.tolerance && hold <= LARGEST_HOLD {
                let patience = if off <= GOOD * self.tolerance { PATIENCE_WHERE_GOOD } else { FAILURES };
                if failed > patience {
                    break;
                }
                // All that is wanted at once; after failures a part of what is missing.
                let kept = 1.0 - f64::powi(0.5, gently);
                let step = Step { share: 1.0, hold, near: near.max(kept * off / self.tolerance) };
                let Some(mut tried) = fit.next(self.setup, &contacts, step, folds) else { break };
                trials.count();
                let carried = match carried(task, &tried, &carried_out) {
                    Ok((tool, at)) => {
                        if trials.notes() {
                            tried.note_folds(&numbered(&at), folds);
                        }
                        Some((tool, at))
                    }
                    Err(no) => {
                        tried.note_folds(&no.known, folds);
                        None
                    }
                };
                let now = carried.as_ref().map(|(_, at)| judge(&mut tried, at));
                record.extend(now);
                match (carried, now) {
                    (Some((tool, at)), Some(now)) if now < off => {
                        let settles = now > WORTH * off && now <= self.tolerance;
                        failed = if now > HARDLY * off { failed + 1 } else { 0 };
                        (fit, made, contacts, off) = (tried, tool, at, now);
                        // What was too far before it is so still.
                        let looser = if tightened && trials.notes() { hold } else { HOLD.max(hold / LOOSER) };
                        (hold, gently, tightened) = (looser, (gently - 1).max(0), false);
                        if settles {
                            break;
                        }
                    }
                    // Too far for what the contact at the last command tells.
                    _ => {
                        (hold, failed, gently, tightened) = (hold * tighter, failed + 1, gently + 1, true);
                    }
                }
            }
        }
        (CarriedOut { fit, made, contacts }, record)
    }
}
