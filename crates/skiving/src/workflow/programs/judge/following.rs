//! What a text does to the axes, block by block, and where the output is on. Knows no plan.

use super::fault;
use machine::{Machine, Positions};
use motion::AxisWords;
use nc::Block;
use std::ops::Range;
use verdict::Remark;

/// A motion of the axes.
#[derive(Clone, Copy, Debug)]
pub(in super::super) struct Motion {
    /// Its block, from 1.
    pub block: usize,
    /// Where it begins, once the places of all axes of the tool are known.
    pub from: Option<Positions>,
    /// Where it ends.
    pub to: Positions,
    /// Time of a straight motion, s; none of a rapid one.
    pub seconds: Option<f64>,
}

/// Motions with the output on.
#[derive(Clone, Debug)]
pub(in super::super) struct Stretch {
    /// Blocks that switch it on and off, from 1.
    pub blocks: [usize; 2],
    /// Its motions.
    pub motions: Range<usize>,
}

/// A text as far as the axes go.
#[derive(Clone, Debug, Default)]
pub(in super::super) struct Followed {
    pub motions: Vec<Motion>,
    pub stretches: Vec<Stretch>,
    /// Blocks that no measuring program has, outputs that are switched wrongly.
    pub faults: Vec<Remark>,
}

const CORRECT: &str = "correct this block, or take the text as it was written";

impl Followed {
    /// Where the axes stand when a stretch begins.
    pub fn begin(&self, stretch: &Stretch) -> Option<Positions> {
        match self.motions.get(stretch.motions.start).filter(|_| !stretch.motions.is_empty()) {
            Some(first) => first.from,
            None => self.motions[..stretch.motions.start].last().map(|last| last.to),
        }
    }

    /// Whether a motion is part of a stretch.
    pub fn recorded(&self, number: usize) -> bool {
        self.stretches.iter().any(|stretch| stretch.motions.contains(&number))
    }

    /// The last block that moves.
    pub fn last_block(&self) -> usize {
        self.motions.last().map_or(1, |last| last.block)
    }
}

/// Follows the blocks of a text, in which the places of `axes` have to be known; `output` is the number of the output that records.
pub(in super::super) fn follow(
    blocks: &[Block],
    (machine, axes): (&Machine, &[usize]),
    words: &AxisWords,
    output: u8,
) -> Followed {
    let mut followed = Followed::default();
    let mut at = Positions::default();
    let mut known = vec![false; machine.axes().len()];
    let mut on: Option<(usize, usize)> = None;
    for (k, block) in blocks.iter().enumerate() {
        let number = k + 1;
        let all_known = |known: &[bool]| axes.iter().all(|&axis| known[axis]);
        let mut refused = |reason: &str| {
            followed.faults.push(fault("block-unexpected", number, reason, CORRECT));
        };
        let (target, seconds) = match block {
            Block::Rapid(target) => (target, None),
            Block::Linear { target, duration } => (target, Some(*duration)),
            Block::Output { number: other, .. } if *other != output => {
                refused(&format!("output {other} is switched; the recorder listens to output {output}"));
                continue;
            }
            Block::Output { on: true, .. } => {
                if !all_known(&known) {
                    refused("the output goes on before the places of all axes are known");
                }
                match on {
                    Some(_) => refused("the output goes on while it is on"),
                    None => on = Some((number, followed.motions.len())),
                }
                continue;
            }
            Block::Output { on: false, .. } => {
                match on.take() {
                    Some((begin, first)) => {
                        let motions = first..followed.motions.len();
                        followed.stretches.push(Stretch { blocks: [begin, number], motions });
                    }
                    None => refused("the output goes off while it is off"),
                }
                continue;
            }
            // Controls stop their spindles at the end.
            Block::Comment(_) | Block::End | Block::Spindle { speed: 0.0, .. } => continue,
            _ => {
                refused("no block of a measuring program");
                continue;
            }
        };
        let from = all_known(&known).then_some(at);
        at = words.positions(machine, &at, target);
        for (word, _) in target.iter() {
            if let Some(&axis) = words.numbers.get(word) {
                known[axis] = true;
            }
        }
        if seconds.is_none() && on.is_some() {
            refused("a rapid motion while the output is on");
        }
        if seconds.is_some() && from.is_none() {
            refused("a straight motion from a place that is not known");
        }
        followed.motions.push(Motion { block: number, from, to: at, seconds });
    }
    if let Some((begin, first)) = on {
        let end = blocks.len();
        followed.faults.push(fault("block-unexpected", begin, "the output stays on to the end", CORRECT));
        followed.stretches.push(Stretch { blocks: [begin, end], motions: first..followed.motions.len() });
    }
    followed
}
