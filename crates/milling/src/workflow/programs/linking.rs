//! The rapid blocks from the end of one path to the begin of the next, outside of the workpiece
//! (`docs/mathematics/milling.md#positions-of-five-axes`): around it where the axes follow, else straight in the axes with one of them
//! turned back.

use super::drive::{Driver, NOWHERE, Node, rapid_seconds, step};
use super::follow::between;
use super::links::{SAMPLES, is_outside, lifted_pairs, straight_is_outside, ways};
use super::passes::CutterPass;
use super::safe_room::SafeRoom;
use super::steps::{Step, StepKind};
use job::Diagnostic;
use machine::Positions;
use motion::milling::{CutterPlace as Place, PoleStrategy, choose};
use run::RunFailure;

/// A rotary axis that differs by less than this (rad) stands in the same turn.
const SAME: f64 = 1e-6;
/// A rotary axis that turns by more than this (rad) on a piece of a link has changed its turn.
const JUMP: f64 = std::f64::consts::PI;
/// Largest turn of an axis on one block that turns it back, rad.
const UNWIND_STEP: f64 = 2.5;

/// Blocks shorter than this (s) go nowhere; no control takes them.
const NO_TIME: f64 = 1e-7;

impl Driver<'_> {
    /// The position for a place that is nearest to where the axes stand.
    fn near(&self, place: &Place, from: &Positions) -> Option<Positions> {
        let course = choose(self.setup, std::slice::from_ref(place), from, PoleStrategy::Slow).ok()?;
        course.nodes.first().copied()
    }

    fn rotary_step(&self, from: &Positions, to: &Positions) -> f64 {
        self.setup.axes().rotary.iter().map(|&axis| (to[axis] - from[axis]).abs()).fold(0.0, f64::max)
    }

    /// The blocks from the end of one pass to the begin of the next, which is included.
    pub(super) fn link(
        &self,
        pass: &CutterPass,
        room: &SafeRoom,
        [from, to]: [&Node; 2],
        guided: bool,
    ) -> Result<Vec<Step>, RunFailure> {
        if (from.0.tip.xyz - to.0.tip.xyz).norm() <= NOWHERE && self.rotary_step(&from.1, &to.1) <= SAME {
            return Ok(Vec::new());
        }
        for way in ways(&from.0, &to.0) {
            let Some(nodes) = self.along(&way.places, &from.1) else { continue };
            if nodes.last().is_none_or(|last| self.rotary_step(last, &to.1) > SAME) {
                continue;
            }
            let inner = usize::from(way.lifted)..way.places.len() - 1 - usize::from(way.lifted);
            let outside = inner.clone().all(|k| {
                let straight = || straight_is_outside(room, &way.places[k], &way.places[k + 1]);
                let axes = || self.axes_stay_outside(room, [&nodes[k], &nodes[k + 1]], SAMPLES);
                if guided { straight() } else { axes() }
            });
            if outside {
                let kind = |k: usize| match k {
                    _ if inner.contains(&(k - 1)) => StepKind::Link,
                    1 => StepKind::Retract,
                    _ => StepKind::Approach,
                };
                let made = (1..nodes.len()).map(|k| {
                    let seconds = rapid_seconds(self.setup, &nodes[k - 1], &nodes[k]);
                    step(pass, kind(k), (way.places[k], nodes[k]), seconds, guided)
                });
                return Ok(made.filter(|step| step.seconds > NO_TIME).collect());
            }
        }
        self.unwound(pass, room, [from, to], guided)
    }

    /// Positions along a link, each nearest to the one before; `None` where an axis has to change its turn or a travel ends.
    fn along(&self, places: &[Place], from: &Positions) -> Option<Vec<Positions>> {
        let mut nodes = vec![*from];
        for (k, place) in places.iter().enumerate().skip(1) {
            let at = self.near(place, &nodes[k - 1])?;
            if self.rotary_step(&nodes[k - 1], &at) > JUMP {
                return None;
            }
            nodes.push(at);
        }
        Some(nodes)
    }

    /// Whether the cutter stays outside while the axes go straight.
    fn axes_stay_outside(&self, room: &SafeRoom, [from, to]: [&Positions; 2], samples: usize) -> bool {
        (0..=samples).all(|k| {
            let at = between(self.setup, from, to, k as f64 / samples as f64);
            let stands = self.setup.stands(&at);
            stands.is_ok_and(|(tip, axis)| is_outside(room, &tip.xyz, &axis.xyz))
        })
    }

    /// A link on which the axes go straight into another turn or their other solution.
    fn unwound(
        &self,
        pass: &CutterPass,
        room: &SafeRoom,
        [from, to]: [&Node; 2],
        guided: bool,
    ) -> Result<Vec<Step>, RunFailure> {
        for [begin, end] in lifted_pairs(&from.0, &to.0) {
            let (Some(start), Some(stop)) = (self.near(&begin, &from.1), self.near(&end, &to.1)) else {
                continue;
            };
            let pieces = (self.rotary_step(&start, &stop) / UNWIND_STEP).ceil().max(1.0) as usize;
            if !self.axes_stay_outside(room, [&start, &stop], pieces * 4 * SAMPLES) {
                continue;
            }
            let mut nodes = vec![(StepKind::Retract, begin, start, guided)];
            for k in 1..=pieces {
                let at = between(self.setup, &start, &stop, k as f64 / pieces as f64);
                let place = match self.setup.stands(&at) {
                    Ok((tip, axis)) if k < pieces => Place { contact: tip, tip, axis },
                    _ => end,
                };
                nodes.push((StepKind::Unwind, place, at, false));
            }
            nodes.push((StepKind::Approach, to.0, to.1, guided));
            let mut steps = Vec::new();
            let mut last = from.1;
            for (kind, place, at, guided) in nodes {
                let seconds = rapid_seconds(self.setup, &last, &at);
                last = at;
                if seconds > NO_TIME {
                    steps.push(step(pass, kind, (place, at), seconds, guided));
                }
            }
            return Ok(steps);
        }
        let text = format!(
            "{}: no rapid way from the path before stays out of the workpiece within the travels of the axes",
            self.what(pass)
        );
        let finding = Diagnostic::with_code("link-blocked", text).field("machine.mount");
        let way_out = "mount the workpiece with more room around it, or take a machine with more travel";
        Err(RunFailure::not_producible(finding.way_out(way_out)))
    }
}
