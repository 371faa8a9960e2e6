//! Programs for controls that take straight blocks only (`docs/mathematics/programs.md`): curves into chords within a tolerance
//! of each axis, long turns into turns below 360 deg. Knows no dialect.

use super::{AxisMotion, Block, NcError, Program, Targets};

/// Most halvings of one curve: 2^20 pieces.
const HALVINGS: u32 = 20;

/// The program with its cubics and B-splines as straight blocks: at 1/4, 1/2 and 3/4 of every block each axis is within its
/// tolerance (mm or rad, in the order of the axes) of the curve. Chord errors of a flank are a matter for the caller, who knows the flank:
/// its sensitivities make the tolerances.
///
/// # Errors
/// `BadHeader` unless there is one finite tolerance above 0 for each axis, `ToleranceNotReached` with more than 2^20 pieces, and
/// those of [`Program::new`] if a piece becomes too short in time.
pub fn subdivide(program: &Program, tolerances: &[f64]) -> Result<Program, NcError> {
    check_tolerances(program, tolerances)?;
    let mut blocks = Vec::with_capacity(program.blocks().len());
    let mut places = Targets::NONE;
    for (k, block) in program.blocks().iter().enumerate() {
        let start = places;
        let stands = |axis: usize| start.get(axis).unwrap_or_default();
        match block {
            Block::Rapid(target) | Block::Linear { target, .. } => {
                places.update(target);
                blocks.push(block.clone());
            }
            Block::Cubic(motion) => {
                let at = |u: f64| {
                    let values =
                        motion.spans.iter().map(|(axis, span)| (*axis, span.value(stands(*axis), u)));
                    values.fold(Targets::NONE, |targets, (axis, value)| targets.with(axis, value))
                };
                let chords = Chords { program, tolerances, block: k + 1, at };
                chords.between(&[0.0, 1.0], motion.duration, &mut blocks)?;
                places.update(&(chords.at)(1.0));
            }
            Block::BSpline(motion) => {
                let at = |parameter: f64| {
                    let axes = motion.points.first().into_iter().flat_map(Targets::iter);
                    let values = axes
                        .filter_map(|(axis, _)| Some((axis, motion.value(axis, stands(axis), parameter)?)));
                    values.fold(Targets::NONE, |targets, (axis, value)| targets.with(axis, value))
                };
                let mut knots = motion.knots.clone();
                knots.dedup();
                let chords = Chords { program, tolerances, block: k + 1, at };
                chords.between(&knots, motion.duration, &mut blocks)?;
                if let Some(last) = motion.points.last() {
                    places.update(last);
                }
            }
            other => blocks.push(other.clone()),
        }
    }
    Program::new(program.header().clone(), blocks)
}

/// One finite tolerance above 0 for each axis.
pub(super) fn check_tolerances(program: &Program, tolerances: &[f64]) -> Result<(), NcError> {
    if tolerances.len() == program.axes().len() && tolerances.iter().all(|&t| t > 0.0 && t.is_finite()) {
        return Ok(());
    }
    Err(NcError::BadHeader { reason: "tolerances; needed: one above 0 for each axis".into() })
}

/// A curve as chords.
pub(super) struct Chords<'a, A: Fn(f64) -> Targets> {
    pub program: &'a Program,
    pub tolerances: &'a [f64],
    pub block: usize,
    /// Where the axes stand at a parameter.
    pub at: A,
}

impl<A: Fn(f64) -> Targets> Chords<'_, A> {
    /// Chords over the intervals between the borders, in which the curve is smooth; the time is shared as the parameter.
    pub fn between(&self, borders: &[f64], duration: f64, blocks: &mut Vec<Block>) -> Result<(), NcError> {
        let whole = borders.last().zip(borders.first()).map_or(1.0, |(last, first)| last - first);
        for pair in borders.windows(2) {
            // A stack of intervals that are still to be judged, the next on top.
            let mut open = vec![(pair[0], pair[1], 0)];
            let mut from = (self.at)(pair[0]);
            while let Some((low, high, depth)) = open.pop() {
                let to = (self.at)(high);
                let worst = self.worst(&from, &to, low, high);
                if worst.is_none() {
                    blocks.push(Block::Linear { target: to, duration: duration * (high - low) / whole });
                    from = to;
                    continue;
                }
                if let (Some((axis, deviation)), HALVINGS) = (worst, depth) {
                    let axis = self.program.axes()[axis].name.as_str().into();
                    return Err(NcError::ToleranceNotReached {
                        block: self.block,
                        axis,
                        deviation,
                        pieces: 1 << HALVINGS,
                    });
                }
                let middle = 0.5 * (low + high);
                open.push((middle, high, depth + 1));
                open.push((low, middle, depth + 1));
            }
        }
        Ok(())
    }

    /// The first axis that leaves its tolerance, and by how much it is off its curve.
    fn worst(&self, from: &Targets, to: &Targets, low: f64, high: f64) -> Option<(usize, f64)> {
        [0.25, 0.5, 0.75].into_iter().find_map(|share| {
            let curve = (self.at)(low + share * (high - low));
            curve.iter().find_map(|(axis, value)| {
                let chord = (1.0 - share) * from.get(axis)? + share * to.get(axis)?;
                let deviation = (value - chord).abs();
                // Written so that NaN is a deviation.
                let inside = deviation <= self.tolerances[axis];
                (!inside).then_some((axis, deviation))
            })
        })
    }
}

/// The program with every straight block in which a rotary axis makes a turn or more as several of less than one turn, as
/// controls with modulo axes need them ([`super::WriteOptions::incremental_rotary`]).
///
/// # Errors
/// Those of [`Program::new`] if a piece becomes too short in time.
pub fn split_turns(program: &Program) -> Result<Program, NcError> {
    let turns = |axis: usize| program.axes()[axis].motion == AxisMotion::Rotary;
    let mut blocks = Vec::with_capacity(program.blocks().len());
    let mut places = Targets::NONE;
    for block in program.blocks() {
        let (target, duration) = match block {
            Block::Rapid(target) => (target, None),
            Block::Linear { target, duration } => (target, Some(*duration)),
            other => {
                if matches!(other, Block::TipControlOff) {
                    // The control has moved the axes on its own.
                    places = Targets::NONE;
                }
                blocks.push(other.clone());
                continue;
            }
        };
        let ways = target.iter().filter(|(axis, _)| turns(*axis));
        let ways = ways.map(|(axis, to)| (to - places.get(axis).unwrap_or(to)).abs() / std::f64::consts::TAU);
        let count = ways.fold(0.0, f64::max).floor() as usize + 1;
        let start = places;
        for k in 1..=count {
            let share = k as f64 / count as f64;
            let between = |(axis, to): (usize, f64)| {
                let from = start.get(axis).unwrap_or(to);
                // The last piece ends exactly where the block does.
                (axis, if k == count { to } else { from + share * (to - from) })
            };
            let piece =
                target.iter().map(between).fold(Targets::NONE, |all, (axis, value)| all.with(axis, value));
            blocks.push(match duration {
                None => Block::Rapid(piece),
                Some(duration) => Block::Linear { target: piece, duration: duration / count as f64 },
            });
        }
        places.update(target);
    }
    Program::new(program.header().clone(), blocks)
}
