//! Programs for controls with modulo axes (`docs/mathematics/programs.md`): long turns as turns below 360 deg. Knows no dialect.

use super::{AxisMotion, Block, NcError, Program, Targets};

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
                if matches!(
                    other,
                    Block::TipControlOff
                        | Block::LengthOffset(_)
                        | Block::WorkOffset(_)
                        | Block::Probe(_)
                        | Block::ShiftOffset(_)
                ) {
                    // The control has moved the axes on its own, or counts anew.
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
