//! What makes the tool of a fit, where that touches, and which limits it keeps.

use super::super::best_fit::{Contact, Contacts, SomeContacts};
use super::super::dressed::finished_rolls;
use super::super::plan::{Equipped, LARGEST_DRESSING_MARGIN, PlanTask};
use super::super::planning_grid::GroundError;
use super::super::ratio::{Candidate, FlankResidual};
use super::super::{GeneratingError, IdealPlan, PlannedTool, PlanningGrid, ProfilePlace, ProfilePolicy};
use super::rounds::{Carrying, NoTool, numbered};
use super::trials::Trials;
use contact::{ContactError, ModifiedThread};
use foundation::geometry::{Flank, Sides};

/// Length of the tool beyond its contacts, mm: room for the search and for dressed lines that are not those of the ideal worm.
const MARGIN_OF_CONTACTS: f64 = 3.0;
/// Length of roll that contacts stay within the finished part of the worm, mm: rays stand between the points of a fit. And by how much
/// beyond that counts as a tolerance, mm.
const ROOM_AT_ENDS: f64 = 0.02;
const STRAINED: f64 = 0.3;

/// Contacts of both flanks, side by side.
fn on_both(of_flank: impl Fn(Flank) -> SomeContacts + Sync) -> Sides<SomeContacts> {
    let (left, right) = rayon::join(|| of_flank(Flank::Left), || of_flank(Flank::Right));
    Sides { left, right }
}

impl PlanTask<'_> {
    /// Length of the tool beyond the used width that the contacts of a plan need, mm.
    pub(super) fn margin(&self, plan: &IdealPlan, contacts: &Sides<Option<Contacts>>) -> f64 {
        let of_flank = |flank: Flank| {
            let [from, to] = self.setup.lines[flank].occupation(&plan.motion.shift);
            let at = contacts[flank].iter().flatten();
            at.map(|(_, (_, z))| (from - z).max(z - to)).fold(0.0, f64::max)
        };
        Flank::BOTH.into_iter().map(of_flank).fold(0.0, f64::max) + MARGIN_OF_CONTACTS
    }

    /// An ideal plan with the contacts of its worm.
    pub(super) fn ideally_carried_out(&self, trials: &Trials<'_>, ideal: IdealPlan) -> Carrying<IdealPlan> {
        let grid = trials.grid;
        let thread = |flank: Flank| {
            let worm = ideal.worms[flank].as_ref()?;
            Some(ModifiedThread::new(self.setup.pair.flanks[flank].worm, worm))
        };
        let of_flank = |flank: Flank| -> Result<Option<Contacts>, GeneratingError> {
            let Some(thread) = thread(flank) else { return Ok(None) };
            let ground = grid.ground(self.setup, flank, &ideal.motion, &thread)?;
            Ok(Some(ground.into_iter().map(|at| (at, at.tool)).collect()))
        };
        let both = rayon::join(|| of_flank(Flank::Left), || of_flank(Flank::Right));
        match both {
            (Ok(left), Ok(right)) => {
                let contacts = Sides { left, right };
                match self.unbroken(grid, &contacts) {
                    Ok(()) => Ok((ideal, contacts)),
                    Err(error) if !trials.notes() => Err(error.into()),
                    Err(error) => Err(Box::new(NoTool { error, known: numbered(&contacts) })),
                }
            }
            (Err(error), _) | (_, Err(error)) if !trials.notes() => Err(error.into()),
            (Err(error), _) | (_, Err(error)) => {
                let known = on_both(|flank| {
                    let Some(thread) = thread(flank) else { return Vec::new() };
                    let ground = grid.ground_where_easy(self.setup, flank, &ideal.motion, &thread);
                    ground.into_iter().map(|(point, at)| (point, (at, at.tool))).collect()
                });
                Err(Box::new(NoTool { error, known }))
            }
        }
    }

    /// Refuses contacts near a fold.
    pub(super) fn unbroken(
        &self,
        grid: &PlanningGrid,
        contacts: &Sides<Option<Contacts>>,
    ) -> Result<(), GeneratingError> {
        for (flank, at) in contacts.iter() {
            let Some(at) = at else { continue };
            let by_ratio = |(_, a): &(usize, &Contact), (_, b): &(usize, &Contact)| {
                a.0.determinant_ratio.total_cmp(&b.0.determinant_ratio)
            };
            if let Some((k, (least, _))) = at.iter().enumerate().min_by(by_ratio)
                && least.determinant_ratio < self.least_determinant
            {
                let (w, z) = (grid.w[flank][k / grid.z.len()], grid.z[k % grid.z.len()]);
                let ratio = least.determinant_ratio;
                return Err(ContactError::Undercut { flank, w, z, ratio }.into());
            }
        }
        Ok(())
    }

    /// Refuses contacts beyond the finished part of the worm.
    pub(super) fn on_the_worm(&self, contacts: &Sides<Option<Contacts>>) -> Result<(), GeneratingError> {
        for (flank, at) in contacts.iter() {
            let beyond = self.beyond(flank)?;
            if let Some(&(_, (p, q))) = at.iter().flatten().find(|(_, (w, _))| beyond(*w) > 0.0) {
                return Err(ContactError::WormSurfaceMissing { p, q }.into());
            }
        }
        Ok(())
    }

    /// How far a length of roll on the worm lies beyond what is finished of it, mm.
    pub(crate) fn beyond(&self, flank: Flank) -> Result<impl Fn(f64) -> f64 + use<>, GeneratingError> {
        let [low, high] = finished_rolls(self.setup, self.setup.dresser()?, flank);
        Ok(move |w: f64| (low + ROOM_AT_ENDS - w).max(w - high + ROOM_AT_ENDS))
    }

    /// How far contacts are beyond the limits of envelope and worm: 0 within them, else what counts as so many tolerances.
    pub(super) fn strain(&self, contacts: &Sides<Option<Contacts>>) -> f64 {
        let of_flank = |flank: Flank| {
            let (Some(at), Ok(beyond)) = (&contacts[flank], self.beyond(flank)) else { return 0.0 };
            let of_contact = |(at, (w, _)): &Contact| {
                let folds = (self.least_determinant - at.determinant_ratio) / self.least_determinant;
                f64::max(folds, beyond(*w) / STRAINED)
            };
            at.iter().map(of_contact).fold(0.0, f64::max)
        };
        f64::max(of_flank(Flank::Left), of_flank(Flank::Right))
    }

    /// The tool of a plan as dressed, reaching `margin` beyond the used width or further, and its contacts.
    pub(super) fn dressed_carried_out(
        &self,
        ideal: &IdealPlan,
        policy: ProfilePolicy,
        trials: &Trials<'_>,
        mut margin: f64,
    ) -> Carrying<Equipped> {
        let grid = trials.grid;
        loop {
            let (dresser, flanks) = self.tools(ideal, policy, margin)?;
            match self.contacts(&flanks, ideal, grid) {
                Ok(contacts) => {
                    let wanted =
                        |flank: Flank| contacts[flank].as_ref().map(|at| at.iter().map(|c| c.0).collect());
                    let shift = &ideal.motion.shift;
                    let ground = |flank: Flank| wanted(flank).map(Ok);
                    let error = GroundError::of(self.setup, &self.targets, grid, shift, ground, |_, _| None)?;
                    let equipped = Equipped { ideal: ideal.clone(), dresser, flanks, error, margin };
                    return Ok((equipped, contacts));
                }
                Err(GeneratingError::Contact(ContactError::WormSurfaceMissing { .. }))
                    if margin < LARGEST_DRESSING_MARGIN =>
                {
                    margin *= 2.0;
                }
                Err(error) if !trials.notes() => return Err(error.into()),
                Err(error) => {
                    let known = on_both(|flank| {
                        let Some(tool) = &flanks[flank] else { return Vec::new() };
                        let PlannedTool::Dressed(dressed) = tool else { return Vec::new() };
                        let ground = grid.ground_where_easy(self.setup, flank, &ideal.motion, &dressed.worm);
                        let footed = |(point, at)| Some((point, (at, tool.foot(&at)?)));
                        ground.into_iter().filter_map(footed).collect()
                    });
                    return Err(Box::new(NoTool { error, known }));
                }
            }
        }
    }

    fn contacts(
        &self,
        flanks: &Sides<Option<PlannedTool>>,
        ideal: &IdealPlan,
        grid: &PlanningGrid,
    ) -> Result<Sides<Option<Contacts>>, GeneratingError> {
        let of_flank = |flank: Flank| -> Result<Option<Contacts>, GeneratingError> {
            let Some(tool) = &flanks[flank] else { return Ok(None) };
            let ground = tool.ground(self.setup, flank, grid, &ideal.motion)?;
            let lost = |at: &contact::ContactSolution| ContactError::WormSurfaceMissing {
                p: at.tool.0,
                q: at.tool.1,
            };
            let footed = ground.into_iter().map(|at| Ok((at, tool.foot(&at).ok_or_else(|| lost(&at))?)));
            footed.collect::<Result<Contacts, GeneratingError>>().map(Some)
        };
        let (left, right) = rayon::join(|| of_flank(Flank::Left), || of_flank(Flank::Right));
        Ok(Sides { left: left?, right: right? })
    }

    /// The largest share of a limit that a correcting axis of dressing takes, with the axis and its value.
    pub(crate) fn dressing_share(&self, equipped: &Equipped) -> (f64, (usize, f64)) {
        let mut largest = (0.0, (0, 0.0));
        for (flank, tool) in equipped.flanks.iter() {
            let Some(PlannedTool::Dressed(dressed)) = tool else { continue };
            let settled = equipped.dresser.as_ref().map_or([0.0; 4], |dresser| dresser.flanks[flank].settled);
            for node in &dressed.nodes {
                for j in 0..4 {
                    let value = (node.dk[j] + settled[j]).abs();
                    let share = value / self.limits.correction[j];
                    if share > largest.0 {
                        largest = (share, (j, value));
                    }
                }
            }
        }
        largest
    }

    /// What a fitted ratio asks of the axes, as the rule judges ratios.
    pub(super) fn candidate_of(
        &self,
        equipped: &Equipped,
        grid: &PlanningGrid,
        ratio: f64,
        place: ProfilePlace,
    ) -> Candidate {
        let rule = self.rule(grid);
        let ideal = &equipped.ideal;
        let (dressing_share, worst) = self.dressing_share(equipped);
        let feeds = self.setup.feed_range(&ideal.motion.shift, &rule.which());
        let delta_d = (0..=64)
            .map(|k| ideal.motion.delta_d.value(feeds[0] + (feeds[1] - feeds[0]) * f64::from(k) / 64.0).abs())
            .fold(0.0, f64::max);
        let occupation = ideal.occupation[1] - ideal.occupation[0];
        let refusal = rule
            .check_width(occupation, ratio)
            .and_then(|()| rule.check_axes(dressing_share, worst, delta_d))
            .err();
        Candidate {
            ratio,
            place,
            dressing_share,
            delta_d_share: delta_d / self.limits.delta_d,
            occupation,
            feed_travel: feeds[1] - feeds[0],
            error: equipped.error.max(),
            residuals: FlankResidual::of(self.setup, ideal, &equipped.error),
            determinant: equipped.error.determinant,
            refusal,
        }
    }
}
