//! Lines of a probing cycle: a motion that a probe ends, where the axis stood then, and the work offset that follows from it. Each is a whole
//! line of fixed words with numbers and axes between them; patterns know how controls spell them.

use super::error::{ReadError, ReadProblem};
use super::machine::{Fault, Machine};
use super::scan::Scan;
use crate::{Block, OffsetShift, ProbeMove, Word};

/// A motion that is not yet kept under a number.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Probing {
    axis: usize,
    to: f64,
    speed: f64,
}

/// What stood between the words of a line: numbers, and axes by their addresses.
#[derive(Debug, Default, PartialEq)]
pub(super) struct Found {
    pub numbers: Vec<f64>,
    pub axes: Vec<usize>,
}

/// Holds a line against a pattern, blanks aside: `%` is a number, `@` the address of an axis, everything else itself. A line number may
/// stand before.
pub(super) fn matched(line: &[u8], pattern: &str, machine: &Machine<'_>) -> Option<Found> {
    let text: Vec<u8> =
        line.iter().filter(|byte| !byte.is_ascii_whitespace()).map(u8::to_ascii_uppercase).collect();
    let mut rest = &text[..];
    if let Some(numbered) = rest.strip_prefix(b"N") {
        let digits = numbered.iter().take_while(|byte| byte.is_ascii_digit()).count();
        rest = &numbered[digits..];
    }
    let mut found = Found::default();
    for wanted in pattern.bytes() {
        match wanted {
            b'%' => {
                let length = rest
                    .iter()
                    .enumerate()
                    .take_while(|(k, byte)| {
                        byte.is_ascii_digit() || **byte == b'.' || *k == 0 && b"+-".contains(*byte)
                    })
                    .count();
                let number = std::str::from_utf8(&rest[..length]).ok()?.parse::<f64>().ok()?;
                found.numbers.push(number);
                rest = &rest[length..];
            }
            b'@' => {
                let (axis, length) = address(rest, machine)?;
                found.axes.push(axis);
                rest = &rest[length..];
            }
            _ => rest = rest.strip_prefix(&[wanted])?,
        }
    }
    rest.is_empty().then_some(found)
}

/// The axis whose address begins a text, and the length of that; of addresses with an equals sign that as well where it stands there.
fn address(text: &[u8], machine: &Machine<'_>) -> Option<(usize, usize)> {
    machine.axes.iter().enumerate().find_map(|(axis, word)| match &word.word {
        Word::Letter(letter) => {
            text.first().is_some_and(|first| *first == *letter as u8).then_some((axis, 1))
        }
        Word::Named(name) => {
            let after = text.strip_prefix(name.as_bytes())?;
            Some((axis, name.len() + usize::from(after.first() == Some(&b'='))))
        }
        Word::Spindle(_) => None,
    })
}

impl Machine<'_> {
    /// Whether a line belonged to a probing cycle, as `cycle` found; a cycle that is open takes no other line.
    ///
    /// # Errors
    /// [`ReadError`] for a fault in the line, and for another one in an open cycle.
    pub fn taken_by_probing(
        &self,
        cycle: Result<bool, Fault>,
        bytes: &[u8],
        scan: &mut Scan<'_>,
    ) -> Result<bool, ReadError> {
        match cycle {
            Ok(false) if self.probing.is_some() && !bytes.trim_ascii().is_empty() => {
                let allowed = "the line that keeps the place of the touch, behind the probing motion";
                Err(scan.fault(ReadProblem::Missing, 0, allowed))
            }
            Ok(taken) => Ok(taken),
            Err((problem, allowed)) => {
                scan.at = bytes.len();
                Err(scan.fault(problem, 0, allowed))
            }
        }
    }

    /// A motion that a probe ends: place and feed per minute.
    pub fn probing(&mut self, found: &Found) -> Result<(), Fault> {
        if self.tip.is_some() || self.incremental || self.inch {
            return Err((ReadProblem::Conflict, "probing of an axis by its place in mm or degrees"));
        }
        let ([axis], [to, feed]) = (&found.axes[..], &found.numbers[..]) else {
            return Err((ReadProblem::Missing, "one axis with its place, and F"));
        };
        if !(0.1..=1e6).contains(feed) || to.abs() > 99_999_999.0 {
            return Err((ReadProblem::OutOfRange, "a feed from 0.1 to 1e6, a place up to 99999999"));
        }
        let motion =
            Probing { axis: *axis, to: self.neutral(*axis, *to), speed: self.neutral(*axis, feed / 60.0) };
        (self.inverse_time, self.feed) = (false, None);
        self.probing = Some(motion);
        self.lost |= 1 << axis;
        Ok(())
    }

    /// The place at which the probe touched is kept under a number.
    pub fn probed(&mut self, axis: usize, slot: f64) -> Result<(), Fault> {
        let motion = self.probing.take().filter(|motion| motion.axis == axis);
        let motion = motion
            .ok_or((ReadProblem::Missing, "the probing motion of this axis before its place is kept"))?;
        let slot = kept(slot)?;
        self.blocks.push(Block::Probe(ProbeMove { axis, to: motion.to, speed: motion.speed, slot }));
        Ok(())
    }

    /// A work offset grows by the mean of two kept places less their mean otherwise.
    pub fn offset_by_probe(
        &mut self,
        number: f64,
        axis: usize,
        slots: [f64; 2],
        middle: f64,
    ) -> Result<(), Fault> {
        let [first, second] = slots;
        let slots = [kept(first)?, kept(second)?];
        let number = number as u16;
        let middle = self.neutral(axis, middle);
        self.blocks.push(Block::ShiftOffset(OffsetShift { number, axis, slots, middle }));
        self.lost = u16::MAX;
        Ok(())
    }
}

/// Number of a kept place: 101 is the first.
fn kept(variable: f64) -> Result<u8, Fault> {
    let slot = variable - 100.0;
    if slot.fract() == 0.0 && (1.0..=9.0).contains(&slot) {
        return Ok(slot as u8);
    }
    Err((ReadProblem::OutOfRange, "kept places 101 to 109"))
}
