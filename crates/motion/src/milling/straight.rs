//! Straight blocks of the axes without RTCP: how far the cutter leaves the straight way of tip and axis, blocks divided until it does
//! not, and rows that one block makes exactly (`docs/mathematics/milling.md#positions-of-five-axes`).

use super::{AxisCourse, CutterPlace, MillingSetup};
use crate::MotionError;
use crate::path::straight;
use machine::{AxisSolutions, MachineError, Positions, Station};
use nalgebra::Vector3;

/// How far a straight block of the axes is off the straight way of tip and axis between its ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StraightError {
    /// Of the tip in the middle of the block, on the workpiece, mm.
    pub middle: Vector3<f64>,
    /// Bound of that of the tip anywhere on the block, mm.
    pub tip: f64,
    /// Bound of that of the axis anywhere on the block, rad.
    pub axis: f64,
}

/// A path in blocks short enough.
#[derive(Clone, Debug, PartialEq)]
pub struct Refined {
    /// Ends of the blocks.
    pub places: Vec<CutterPlace>,
    /// Positions there.
    pub nodes: Vec<Positions>,
    /// Numbers (from 0) of the given places among them.
    pub given: Vec<usize>,
    /// Bound of the tip's deviation, mm.
    pub tip: f64,
    /// Bound of the axis' deviation, rad.
    pub axis: f64,
}

/// Places that one straight block of the axes passes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StraightRun {
    /// Number (from 0) of its first place.
    pub from: usize,
    /// Number of its last place.
    pub to: usize,
    /// Largest distance of the tip from a place on the way, mm.
    pub tip: f64,
    /// Largest angle of the axis from that of a place on the way, rad.
    pub axis: f64,
}

/// Parts into which a block is divided for its bound.
const PARTS: usize = 8;
/// Most blocks between two places.
const MOST_PIECES: usize = 1 << 16;
/// Most pieces into which a block is divided in one step.
const MOST_AT_ONCE: f64 = 64.0;
/// A block of less than this share of the way between two places cannot be divided further.
const LEAST_SHARE: f64 = 1e-7;

fn angle_between(a: &Vector3<f64>, b: &Vector3<f64>) -> f64 {
    a.cross(b).norm().atan2(a.dot(b))
}

/// How far the straight block between two positions leaves the straight way between two places.
///
/// Between the places looked at the tip is off by their line and an eighth of its second derivative times their distance squared;
/// so is the cross product of the axis and its straight way, whose second derivative is at most 3 times the rate squared.
///
/// # Errors
/// As [`Machine::pose`](machine::Machine::pose).
pub fn straight_error(
    setup: &MillingSetup,
    [from, to]: [(&CutterPlace, &Positions); 2],
) -> Result<StraightError, MachineError> {
    let machine = setup.machine();
    let bound = machine.straight_bound(Station::Work, [from.1, to.1], &setup.reach())?;
    let between = |a: &Vector3<f64>, b: &Vector3<f64>, u: f64| a + (b - a) * u;
    let mut middle = Vector3::zeros();
    let (mut tip, mut across): (f64, f64) = (0.0, 0.0);
    for k in 1..PARTS {
        let u = k as f64 / PARTS as f64;
        let (stands, axis) = setup.stands(&straight(machine, from.1, to.1, u))?;
        let off = stands.xyz - between(&from.0.tip.xyz, &to.0.tip.xyz, u);
        if 2 * k == PARTS {
            middle = off;
        }
        tip = tip.max(off.norm());
        let wanted = between(&from.0.axis.xyz, &to.0.axis.xyz, u);
        // On the far side the cross product falls again.
        let far = axis.xyz.dot(&wanted) < 0.0;
        across = across.max(if far { 1.0 } else { axis.xyz.cross(&wanted).norm() });
    }
    let parts = (PARTS * PARTS) as f64;
    let shortest = 0.5 * (from.0.axis.xyz + to.0.axis.xyz).norm();
    let sine = (across + 3.0 * bound.turn.powi(2) / (8.0 * parts)) / shortest;
    let axis = if sine < 1.0 { sine.asin() } else { std::f64::consts::PI };
    Ok(StraightError { middle, tip: tip + bound.chord() / parts, axis })
}

/// The solution for a place that is nearest to a position, in any turn within the travels.
fn nearest(setup: &MillingSetup, place: &CutterPlace, near: &Positions) -> Result<Positions, MachineError> {
    let found = match setup.solutions(place)? {
        AxisSolutions::Positions(found) => found,
        AxisSolutions::Pole { .. } => vec![setup.held(place, near[setup.axes().rotary[0]])?],
    };
    let turned = found.iter().map(|solution| {
        let mut at = *solution;
        for axis in setup.axes().rotary {
            at[axis] = MillingSetup::nearest_turn(at[axis], near[axis]);
        }
        at
    });
    let within = turned.filter(|at| setup.admits(at));
    match within.min_by(|a, b| setup.turned(near, a).total_cmp(&setup.turned(near, b))) {
        Some(at) => Ok(at),
        None => Err(setup.machine().limit_of(&setup.machine().judged(Station::Work, found)?)),
    }
}

/// A course with so many places between its own that straight blocks of the axes keep tip (mm) and axis (rad) within the
/// tolerances of the straight way from place to place. Blocks that end in a rewind stay as they are: nothing is cut there.
///
/// # Errors
/// [`MotionError::InvalidNumber`] for tolerances that are not above 0; [`MotionError::Place`]; [`MotionError::CutterMissed`].
pub fn refine(
    setup: &MillingSetup,
    course: &AxisCourse,
    tip_tolerance: f64,
    axis_tolerance: f64,
) -> Result<Refined, MotionError> {
    check_tolerances(tip_tolerance, axis_tolerance)?;
    let mut refined = Refined { places: vec![], nodes: vec![], given: vec![], tip: 0.0, axis: 0.0 };
    for (k, (place, node)) in course.places.iter().zip(&course.nodes).enumerate() {
        let failed = |error| MotionError::Place { place: k, error };
        if k > 0 && !course.rewinds.contains(&k) {
            let (start, begin) = (course.places[k - 1], course.nodes[k - 1]);
            let mut done = (0.0, start, begin);
            let mut ahead = vec![1.0];
            let mut pieces = 0;
            while let Some(&share) = ahead.last() {
                let (target, at) = if share < 1.0 {
                    let target = start.towards(place, share);
                    (target, nearest(setup, &target, &done.2).map_err(failed)?)
                } else {
                    (*place, *node)
                };
                let off = straight_error(setup, [(&done.1, &done.2), (&target, &at)]).map_err(failed)?;
                let excess = (off.tip / tip_tolerance).max(off.axis / axis_tolerance);
                if excess <= 1.0 {
                    refined.tip = refined.tip.max(off.tip);
                    refined.axis = refined.axis.max(off.axis);
                    ahead.pop();
                    pieces += 1;
                    if share < 1.0 {
                        refined.places.push(target);
                        refined.nodes.push(at);
                    }
                    done = (share, target, at);
                } else if pieces + ahead.len() > MOST_PIECES || share - done.0 < LEAST_SHARE {
                    return Err(MotionError::CutterMissed {
                        place: k,
                        pieces: pieces + ahead.len(),
                        tip_um: off.tip * 1e3,
                        tip_tolerance_um: tip_tolerance * 1e3,
                        axis_deg: off.axis.to_degrees(),
                        axis_tolerance_deg: axis_tolerance.to_degrees(),
                    });
                } else {
                    // A chord misses a smooth curve by the square of its length.
                    let parts = excess.sqrt().ceil().clamp(2.0, MOST_AT_ONCE) as usize;
                    let shares =
                        (1..parts).rev().map(|j| done.0 + (share - done.0) * j as f64 / parts as f64);
                    ahead.extend(shares);
                }
            }
        }
        refined.given.push(refined.nodes.len());
        refined.places.push(*place);
        refined.nodes.push(*node);
    }
    Ok(refined)
}

fn check_tolerances(tip: f64, axis: f64) -> Result<(), MotionError> {
    for (field, value) in [("tip_tolerance", tip), ("axis_tolerance", axis)] {
        if !(value.is_finite() && value > 0.0) {
            return Err(MotionError::InvalidNumber { field, value, allowed: "above 0" });
        }
    }
    Ok(())
}

/// The path in as few straight blocks of the axes as pass all places within the tolerances of tip (mm) and axis (rad): a pure
/// screw row is one. What the path does between its places is not asked. No block leads to a rewind.
///
/// # Errors
/// [`MotionError::InvalidNumber`] for tolerances that are not above 0; [`MotionError::Place`].
pub fn straight_runs(
    setup: &MillingSetup,
    course: &AxisCourse,
    tip_tolerance: f64,
    axis_tolerance: f64,
) -> Result<Vec<StraightRun>, MotionError> {
    check_tolerances(tip_tolerance, axis_tolerance)?;
    let mut runs = Vec::new();
    let mut from = 0;
    while from + 1 < course.nodes.len() {
        if course.rewinds.contains(&(from + 1)) {
            from += 1;
            continue;
        }
        let mut run = StraightRun { from, to: from + 1, tip: 0.0, axis: 0.0 };
        for to in (from + 2..course.nodes.len()).take_while(|to| !course.rewinds.contains(to)) {
            match one_block(setup, course, from, to)? {
                Some(longer) if longer.tip <= tip_tolerance && longer.axis <= axis_tolerance => run = longer,
                _ => break,
            }
        }
        from = run.to;
        runs.push(run);
    }
    Ok(runs)
}

/// How far one block from place to place misses those between; `None` if it does not pass them in their order.
fn one_block(
    setup: &MillingSetup,
    course: &AxisCourse,
    from: usize,
    to: usize,
) -> Result<Option<StraightRun>, MotionError> {
    let (begin, end) = (&course.nodes[from], &course.nodes[to]);
    let (origin, target) = (setup.scaled(begin), setup.scaled(end));
    let length: f64 = origin.iter().zip(&target).map(|(a, b)| (b - a).powi(2)).sum();
    let mut run = StraightRun { from, to, tip: 0.0, axis: 0.0 };
    let mut last = 0.0;
    for k in from + 1..to {
        let along: f64 = setup
            .scaled(&course.nodes[k])
            .iter()
            .zip(&origin)
            .zip(&target)
            .map(|((x, a), b)| (x - a) * (b - a))
            .sum();
        let share = if length > 0.0 { along / length } else { 0.0 };
        if !(last..=1.0).contains(&share) {
            return Ok(None);
        }
        last = share;
        let failed = |error| MotionError::Place { place: k + 1, error };
        let (tip, axis) = setup.stands(&straight(setup.machine(), begin, end, share)).map_err(failed)?;
        run.tip = run.tip.max((tip.xyz - course.places[k].tip.xyz).norm());
        run.axis = run.axis.max(angle_between(&axis.xyz, &course.places[k].axis.xyz));
    }
    Ok(Some(run))
}
