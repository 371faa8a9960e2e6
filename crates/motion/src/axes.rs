//! Which axes of a machine a program names, by which words, and how values go to and fro.

use super::MotionError;
use machine::{Joint, Machine, Positions};
use nc::{AxisMotion, AxisWord, Targets, Word};

/// The words of a machine's axes on a control.
#[derive(Clone, Debug, PartialEq)]
pub struct AxisWords {
    /// The axes of a program in their order.
    pub words: Vec<AxisWord>,
    /// Number of each in the machine.
    pub numbers: Vec<usize>,
}

/// Words for the axes `wanted` (numbers in the machine); `word` tells what the control calls an axis, `None` if nothing.
///
/// # Errors
/// [`MotionError::InvalidWord`].
pub fn axis_words<'w>(
    machine: &Machine,
    wanted: &[usize],
    word: impl Fn(&str) -> Option<&'w str>,
) -> Result<AxisWords, MotionError> {
    let mut words = Vec::with_capacity(wanted.len());
    let mut numbers = Vec::with_capacity(wanted.len());
    for &number in wanted {
        let axis = &machine.axes()[number];
        let Some(text) = word(&axis.name).filter(|text| *text != "none") else { continue };
        let invalid = || MotionError::InvalidWord { axis: axis.name.clone(), word: text.to_owned() };
        let motion = match axis.joint {
            Joint::Linear => AxisMotion::Linear,
            Joint::Rotary => AxisMotion::Rotary,
        };
        let mut letters = text.chars();
        let word = match (letters.next(), letters.next(), text.strip_prefix("spindle ")) {
            (Some(letter), None, _) if "XYZABCUVW".contains(letter) => Word::Letter(letter),
            (.., Some(spindle)) => Word::Spindle(spindle.parse().map_err(|_| invalid())?),
            (Some(first), Some(_), None) if first.is_ascii_uppercase() => Word::Named(text.to_owned()),
            _ => return Err(invalid()),
        };
        words.push(AxisWord { name: axis.name.clone(), motion, word });
        numbers.push(number);
    }
    Ok(AxisWords { words, numbers })
}

impl AxisWords {
    /// Place of a machine's axis among the axes of the program.
    pub fn place(&self, number: usize) -> Option<usize> {
        self.numbers.iter().position(|&known| known == number)
    }

    /// Whether the program gives targets of this axis: it has a word that is no spindle.
    pub fn is_moved(&self, number: usize) -> bool {
        self.place(number).is_some_and(|k| !matches!(self.words[k].word, Word::Spindle(_)))
    }

    /// Targets of those of the axes `which` that the program moves, as the control counts them.
    pub fn targets(&self, machine: &Machine, at: &Positions, which: impl Fn(usize) -> bool) -> Targets {
        let mut targets = Targets::NONE;
        for (k, &number) in self.numbers.iter().enumerate() {
            if self.is_moved(number) && which(number) {
                targets.set(k, machine.axes()[number].nc_sign * at[number]);
            }
        }
        targets
    }

    /// Positions with the targets of a block put in.
    pub fn positions(&self, machine: &Machine, from: &Positions, targets: &Targets) -> Positions {
        let mut at = *from;
        for (k, value) in targets.iter() {
            if let Some(&number) = self.numbers.get(k) {
                at[number] = machine.axes()[number].nc_sign * value;
            }
        }
        at
    }
}
