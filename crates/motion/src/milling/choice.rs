//! Which of the two solutions, and which turn, along a path of cutter locations: dynamic programming over all that the travels allow
//! (`docs/mathematics/milling.md#positions-of-five-axes`).

use super::{CutterPlace, MillingSetup};
use crate::MotionError;
use foundation::geometry::CutterShape;
use foundation::kinematics::{Direction, Point};
use machine::{AxisSolutions, MachineError, Positions, Station};
use std::f64::consts::TAU;

/// What is done near the pole.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum PoleStrategy {
    /// The geometry stays; the axes take the time that they need.
    Slow,
    /// Within `cap` (rad) of the pole the first rotary axis keeps its angle. The cutter's axis is off by at most that, its ball
    /// stays where it is wanted, so that the flank does not change. For ball cutters only.
    Hold {
        /// The cutting part.
        cutter: CutterShape,
        /// theta_cap, rad.
        cap: f64,
    },
}

/// Positions of the axes along a path.
#[derive(Clone, Debug, PartialEq)]
pub struct AxisCourse {
    /// Positions at every place, turns kept.
    pub nodes: Vec<Positions>,
    /// The places as they are taken up: the wanted ones but where the first rotary axis was held.
    pub places: Vec<CutterPlace>,
    /// By how much the cutter's axis is off the wanted direction, rad: 0 but where it was held.
    pub axis_errors: Vec<f64>,
    /// Numbers (from 0) of places at the pole or held, which have the first rotary axis of the place before.
    pub inherited: Vec<usize>,
    /// Numbers (from 0) of places that the axes reach from the place before by a detour, in another solution or turn than the
    /// nearest one, because a travel ends: the cutter has to be retracted before.
    pub rewinds: Vec<usize>,
    /// Sum of |d th_1| + |d th_2| and 1e-3 times the way to the first place, rad.
    pub cost: f64,
}

/// Weight of the way to the first place (`docs/mathematics/milling.md#positions-of-five-axes`).
const APPROACH: f64 = 1e-3;
/// Costs that differ by less (rad) are equal: they are sums of rounded angles.
const EQUAL: f64 = 1e-12;
/// A step that turns more than the nearest one by this (rad) is a detour.
const DETOUR: f64 = 1e-6;
/// Turns to either side of where the axes stand that are looked at on an axis with many turns of travel.
const MOST_TURNS: f64 = 32.0;

/// What there is for a place before limits and turns.
enum Offer {
    /// One or two solutions.
    Solutions(Vec<Positions>),
    /// The first rotary axis keeps its angle.
    Held,
}

#[derive(Clone, Copy, Debug)]
struct State {
    at: Positions,
    cost: f64,
    parent: usize,
}

/// The positions along a path with the least turning of both rotary axes, beginning at `from`.
///
/// Candidates at a place are both solutions, the one with the positive root first, in all turns within the travels, ascending; of
/// equal ways the first is taken. Endless axes take the turn nearest to the place before. A place at the pole inherits the angle of
/// the first rotary axis.
///
/// # Errors
/// [`MotionError::Place`] with the place: its direction is beyond reach, or no solution stands within the travels;
/// [`MotionError::HoldNeedsBall`]; [`MotionError::InvalidNumber`].
pub fn choose(
    setup: &MillingSetup,
    places: &[CutterPlace],
    from: &Positions,
    strategy: PoleStrategy,
) -> Result<AxisCourse, MotionError> {
    CutterPlace::check(places)?;
    check_start(setup, from)?;
    let hold = held_zone(strategy)?;
    let mut layers: Vec<Vec<State>> = Vec::with_capacity(places.len());
    let mut offers = Vec::with_capacity(places.len());
    for (k, place) in places.iter().enumerate() {
        let failed = |error| MotionError::Place { place: k + 1, error };
        let offer = match hold {
            Some((_, cap)) if setup.pole_distance(&place.axis) <= cap => Offer::Held,
            _ => match setup.solutions(place).map_err(failed)? {
                AxisSolutions::Positions(found) => Offer::Solutions(found),
                AxisSolutions::Pole { .. } => Offer::Held,
            },
        };
        let start = [State { at: *from, cost: 0.0, parent: 0 }];
        let (before, weight) = match layers.last() {
            Some(layer) => (layer.as_slice(), 1.0),
            None => (start.as_slice(), APPROACH),
        };
        let step = Step { setup, before, weight, from };
        let layer = match &offer {
            Offer::Solutions(found) => step.to_solutions(found),
            Offer::Held => {
                let ball = hold.map_or(0.0, |(radius, _)| radius);
                step.held(place, ball).map_err(failed)?
            }
        };
        if layer.is_empty() {
            return Err(failed(step.refused(place, &offer)));
        }
        layers.push(layer);
        offers.push(offer);
    }
    collect(setup, places, &layers, &offers)
}

fn check_start(setup: &MillingSetup, from: &Positions) -> Result<(), MotionError> {
    let rotary = setup.axes().rotary;
    match rotary.into_iter().map(|axis| from[axis]).find(|x| !x.is_finite()) {
        Some(value) => Err(MotionError::InvalidNumber {
            field: "position of a rotary axis at the start",
            value,
            allowed: "finite",
        }),
        None => Ok(()),
    }
}

/// Radius of the ball and cap of the strategy that holds.
fn held_zone(strategy: PoleStrategy) -> Result<Option<(f64, f64)>, MotionError> {
    let PoleStrategy::Hold { cutter, cap } = strategy else { return Ok(None) };
    if !(cap > 0.0 && cap < std::f64::consts::FRAC_PI_2) {
        let value = cap.to_degrees();
        return Err(MotionError::InvalidNumber {
            field: "pole_cap_deg",
            value,
            allowed: "above 0, below 90",
        });
    }
    match cutter {
        CutterShape::Conical { radius, .. } if cutter.is_ball() => Ok(Some((radius, cap))),
        _ => Err(MotionError::HoldNeedsBall),
    }
}

/// From the states at one place to those at the next.
struct Step<'s> {
    setup: &'s MillingSetup<'s>,
    before: &'s [State],
    weight: f64,
    from: &'s Positions,
}

impl Step<'_> {
    /// All turns of a rotary axis within its travel, ascending; the angle alone for an endless one.
    fn turns(&self, axis: usize, angle: f64) -> Vec<f64> {
        let described = &self.setup.machine().axes()[axis];
        let Some([low, high]) = described.travel else { return vec![angle] };
        let near = self.from[axis].clamp(low, high);
        let first = ((low - angle) / TAU).floor().max(((near - angle) / TAU).round() - MOST_TURNS);
        let last = ((high - angle) / TAU).ceil().min(((near - angle) / TAU).round() + MOST_TURNS);
        let count = (last - first) as usize;
        (0..=count)
            .map(|k| angle + TAU * (first + k as f64))
            .filter(|&value| described.admits(value))
            .collect()
    }

    /// The rotary axes in the turns nearest to a state, where they have no ends.
    fn unrolled(&self, mut at: Positions, near: &Positions) -> Positions {
        for axis in self.setup.axes().rotary {
            if self.setup.machine().axes()[axis].travel.is_none() {
                at[axis] = MillingSetup::nearest_turn(at[axis], near[axis]);
            }
        }
        at
    }

    /// The best way to a candidate.
    fn best(&self, at: Positions) -> Option<State> {
        let mut best: Option<State> = None;
        for (parent, state) in self.before.iter().enumerate() {
            let at = self.unrolled(at, &state.at);
            let cost = state.cost + self.weight * self.setup.turned(&state.at, &at);
            if best.is_none_or(|known| cost < known.cost - EQUAL) {
                best = Some(State { at, cost, parent });
            }
        }
        best
    }

    fn to_solutions(&self, found: &[Positions]) -> Vec<State> {
        let [first, second] = self.setup.axes().rotary;
        let mut states = Vec::new();
        for solution in found {
            for a in self.turns(first, solution[first]) {
                for b in self.turns(second, solution[second]) {
                    let mut at = *solution;
                    (at[first], at[second]) = (a, b);
                    if self.setup.admits(&at) {
                        states.extend(self.best(at));
                    }
                }
            }
        }
        states
    }

    /// Every state before goes on with its own first rotary axis; of states that become one, the best.
    fn held(&self, place: &CutterPlace, ball: f64) -> Result<Vec<State>, MachineError> {
        let [first, second] = self.setup.axes().rotary;
        let mut states: Vec<State> = Vec::new();
        for (parent, state) in self.before.iter().enumerate() {
            let solution = held_at(self.setup, place, ball, state.at[first])?;
            for b in self.turns(second, solution[second]) {
                let mut at = solution;
                at[second] = b;
                let at = self.unrolled(at, &state.at);
                if !self.setup.admits(&at) {
                    continue;
                }
                let cost = state.cost + self.weight * self.setup.turned(&state.at, &at);
                let new = State { at, cost, parent };
                match states.iter_mut().find(|known| self.setup.turned(&known.at, &at) < EQUAL) {
                    Some(known) if cost < known.cost - EQUAL => *known = new,
                    Some(_) => {}
                    None => states.push(new),
                }
            }
        }
        Ok(states)
    }

    /// Why a place has no candidate.
    fn refused(&self, place: &CutterPlace, offer: &Offer) -> MachineError {
        let found = match offer {
            Offer::Solutions(found) => found.clone(),
            Offer::Held => {
                let first = self.setup.axes().rotary[0];
                self.before.iter().filter_map(|state| self.setup.held(place, state.at[first]).ok()).collect()
            }
        };
        let machine = self.setup.machine();
        match machine.judged(Station::Work, found) {
            Ok(judged) => machine.limit_of(&judged),
            Err(error) => error,
        }
    }
}

/// The positions with the first rotary axis at `angle` and a ball of the radius `ball` where it is wanted.
fn held_at(
    setup: &MillingSetup,
    place: &CutterPlace,
    ball: f64,
    angle: f64,
) -> Result<Positions, MachineError> {
    let (_, axis) = setup.stands(&setup.held(place, angle)?)?;
    setup.held(&turned_ball(place, ball, axis), angle)
}

/// A place with another axis and the same ball.
fn turned_ball(
    place: &CutterPlace,
    ball: f64,
    axis: Direction<foundation::kinematics::Workpiece>,
) -> CutterPlace {
    let tip = Point::from_vector(place.tip.xyz + (place.axis.xyz - axis.xyz) * ball);
    CutterPlace { tip, axis, ..*place }
}

/// The best way back from the last place.
fn collect(
    setup: &MillingSetup,
    places: &[CutterPlace],
    layers: &[Vec<State>],
    offers: &[Offer],
) -> Result<AxisCourse, MotionError> {
    let mut chosen: Option<usize> = None;
    if let Some(last) = layers.last() {
        for (k, state) in last.iter().enumerate() {
            if chosen.is_none_or(|best| state.cost < last[best].cost - EQUAL) {
                chosen = Some(k);
            }
        }
    }
    let cost = match (layers.last(), chosen) {
        (Some(last), Some(k)) => last[k].cost,
        _ => 0.0,
    };
    let mut nodes = Vec::with_capacity(places.len());
    for layer in layers.iter().rev() {
        let Some(k) = chosen else { break };
        nodes.push(layer[k].at);
        chosen = Some(layer[k].parent);
    }
    nodes.reverse();
    let mut course = AxisCourse {
        nodes,
        places: places.to_vec(),
        axis_errors: vec![0.0; places.len()],
        inherited: Vec::new(),
        rewinds: Vec::new(),
        cost,
    };
    for (k, offer) in offers.iter().enumerate() {
        let at = &course.nodes[k];
        match offer {
            Offer::Held => {
                let failed = |error| MotionError::Place { place: k + 1, error };
                let (tip, axis) = setup.stands(at).map_err(failed)?;
                let wanted = places[k].axis.xyz;
                course.axis_errors[k] = axis.xyz.cross(&wanted).norm().atan2(axis.xyz.dot(&wanted));
                course.places[k] = CutterPlace { tip, axis, ..places[k] };
                course.inherited.push(k);
            }
            Offer::Solutions(found) if k > 0 => {
                let before = &course.nodes[k - 1];
                let nearest = found.iter().map(|solution| {
                    let mut near = *solution;
                    for axis in setup.axes().rotary {
                        near[axis] = MillingSetup::nearest_turn(solution[axis], before[axis]);
                    }
                    setup.turned(before, &near)
                });
                if setup.turned(before, at) > nearest.fold(f64::INFINITY, f64::min) + DETOUR {
                    course.rewinds.push(k);
                }
            }
            Offer::Solutions(_) => {}
        }
    }
    Ok(course)
}
