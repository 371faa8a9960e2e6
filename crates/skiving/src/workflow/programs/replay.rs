//! What a text does to the axes while the output is on. Knows no plan.

use super::failure::not_proven;
use machine::{Machine, Positions};
use motion::AxisWords;
use nc::Block;
use run::RunFailure;

/// A straight motion of the axes.
#[derive(Clone, Copy, Debug)]
pub(super) struct Move {
    pub from: Positions,
    pub to: Positions,
    /// Time, s.
    pub seconds: f64,
}

/// The motions of a text between on and off of the output, stretch by stretch.
///
/// # Errors
/// Blocks that no such program has; an output that is not switched on and off in turn.
pub(super) fn recorded(
    blocks: &[Block],
    machine: &Machine,
    words: &AxisWords,
    output: u8,
) -> Result<Vec<Vec<Move>>, RunFailure> {
    let mut at = Positions::default();
    let mut known = 0u16;
    let all = words.words.iter().enumerate().filter(|(k, _)| words.is_moved(words.numbers[*k]));
    let all = all.fold(0u16, |mask, (k, _)| mask | 1 << k);
    let (mut stretches, mut open): (Vec<Vec<Move>>, Option<Vec<Move>>) = (Vec::new(), None);
    for (k, block) in blocks.iter().enumerate() {
        let refused = |reason: &str| Err(not_proven(format!("block {}: {reason}", k + 1)));
        match block {
            Block::Rapid(target) => {
                if open.is_some() {
                    return refused("a rapid motion while the output is on");
                }
                at = words.positions(machine, &at, target);
                known |= target.mask();
            }
            Block::Linear { target, duration } => {
                let to = words.positions(machine, &at, target);
                known |= target.mask();
                if let Some(moves) = &mut open {
                    moves.push(Move { from: at, to, seconds: *duration });
                }
                at = to;
            }
            Block::Output { number, on } => {
                if *number != output {
                    return refused("another output");
                }
                if known & all != all {
                    return refused("the output before the places of all axes are known");
                }
                match (on, open.take()) {
                    (true, None) => open = Some(Vec::new()),
                    (false, Some(moves)) => stretches.push(moves),
                    _ => return refused("the output is switched to what it is"),
                }
            }
            // Controls stop their spindles at the end.
            Block::Comment(_) | Block::End | Block::Spindle { speed: 0.0, .. } => {}
            _ => return refused("no block of a measuring program"),
        }
    }
    match open {
        None => Ok(stretches),
        Some(_) => Err(not_proven("the output stays on at the end".into())),
    }
}
