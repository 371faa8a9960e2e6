//! Tip control while a program is read: which tool and offset, how directions come, where the tip is. Knows no text.

use super::error::ReadProblem;
use super::machine::{AxisWords, Fault, Machine, Motion, Tip, inverse_time};
use super::scan::Decimal;
use crate::{Angles, AxisMotion, Block, Orientation, Pace, TipControl, TipMotion};

/// How far from 1 the length of a direction is that was rounded and stays as it stands in the text; others are brought to 1.
const UNIT: f64 = 1e-3;

/// Three words of one line: of the tip, or of a direction.
pub(super) type Three = [Option<Decimal>; 3];

impl Machine<'_> {
    /// A tool is changed; the control stops spindle 0 for it.
    pub fn tool(&mut self, number: Option<u32>, length_offset: Option<u32>) -> Result<(), Fault> {
        if self.tip.is_some() {
            return Err((ReadProblem::Conflict, "tools before tip control or after it"));
        }
        let number =
            number.filter(|number| *number > 0).ok_or((ReadProblem::Missing, "T from 1 beside M6"))?;
        self.still();
        (self.length, self.length_of_tip) = (None, false);
        self.blocks.push(Block::Tool { number, length_offset });
        Ok(())
    }

    /// From here on the control adds this length to axis values, or none.
    pub fn length(&mut self, offset: Option<u32>) -> Result<(), Fault> {
        if self.tip.is_some() {
            return Err((ReadProblem::Conflict, "length offsets before tip control or after it"));
        }
        let change = self.length != offset && !(offset.is_none() && self.length_of_tip);
        (self.length, self.length_of_tip) = (offset, false);
        if change {
            self.blocks.push(Block::LengthOffset(offset));
            self.lost = u16::MAX;
        }
        Ok(())
    }

    /// Tip control takes the length that is in force; where nothing else came after it, for itself alone.
    pub fn length_for_tip(&mut self) -> Result<(), Fault> {
        let Some(offset) = self.length else { return Ok(()) };
        self.tool_offset(offset)?;
        if self.blocks.last() == Some(&Block::LengthOffset(Some(offset))) {
            self.blocks.pop();
            self.length_of_tip = true;
        }
        Ok(())
    }

    /// Values count from another origin; 0 is that of the machine.
    pub fn origin(&mut self, number: u16) -> Result<(), Fault> {
        if self.tip.is_some() {
            return Err((ReadProblem::Conflict, "work offsets before tip control or after it"));
        }
        if self.work_offset != number {
            self.work_offset = number;
            self.lost = u16::MAX;
            if number == 0 {
                return Err((
                    ReadProblem::Conflict,
                    "one count of the axes: no G500 or G53 behind a work offset",
                ));
            }
            self.blocks.push(Block::WorkOffset(number));
        }
        Ok(())
    }

    /// Tells the last tool its length offset.
    pub fn tool_offset(&mut self, offset: u32) -> Result<(), Fault> {
        let last = self.blocks.iter_mut().rev().find_map(|block| match block {
            Block::Tool { length_offset, .. } => Some(length_offset),
            _ => None,
        });
        let place = last.ok_or((ReadProblem::Missing, "T and M6 before the length offset"))?;
        if place.is_some_and(|before| before != offset) {
            return Err((ReadProblem::Conflict, "one length offset for each tool"));
        }
        *place = Some(offset);
        Ok(())
    }

    /// Tip control is switched on; `control` is none if only later lines say how the tool's axis is given.
    pub fn tip_on(&mut self, control: Option<TipControl>) -> Result<(), Fault> {
        if self.tip.is_some() {
            return Err((ReadProblem::Conflict, "tip control off before it is switched on again"));
        }
        self.tip = Some(Tip { block: self.blocks.len(), control, places: [None; 3] });
        self.blocks.push(Block::TipControlOn(control.unwrap_or(TipControl::Directions)));
        Ok(())
    }

    /// Tip control is switched off, if it is on.
    pub fn tip_off(&mut self) {
        if self.tip.take().is_some() {
            self.blocks.push(Block::TipControlOff);
            self.lost = u16::MAX;
        }
    }

    /// How the tool's axis is given: stated once, by a word or by the first line that does it.
    pub fn tip_control(&mut self, control: TipControl) -> Result<(), Fault> {
        let Some(tip) = &mut self.tip else {
            return Err((ReadProblem::Missing, "tip control before directions of the tool's axis"));
        };
        match tip.control {
            Some(before) if before != control => {
                return Err((ReadProblem::Conflict, "directions or angles, not both under one tip control"));
            }
            Some(_) => {}
            None => {
                tip.control = Some(control);
                self.blocks[tip.block] = Block::TipControlOn(control);
            }
        }
        Ok(())
    }

    /// A line under tip control with any of the words of the tip, of a direction, of rotary axes, or F.
    pub fn tip_line(
        &mut self,
        places: &Three,
        direction: &Three,
        angles: &AxisWords,
        feed: Option<f64>,
    ) -> Result<(), Fault> {
        let moves = places.iter().chain(direction).any(Option::is_some) || !angles.is_empty();
        if !moves {
            if let (Some(feed), false) = (feed, self.inverse_time) {
                self.feed = Some(feed);
                self.blocks.push(Block::TipSpeed(feed / 60.0));
            }
            return Ok(());
        }
        if self.incremental || self.inch {
            return Err((ReadProblem::Conflict, "places in mm under tip control"));
        }
        let orientation = self.orientation(direction, angles)?;
        let Some(tip) = &mut self.tip else {
            return Err((ReadProblem::Missing, "tip control before directions of the tool's axis"));
        };
        let mut at = [0.0; 3];
        for ((at, known), word) in at.iter_mut().zip(&mut tip.places).zip(places) {
            *known = word.map(Decimal::value).or(*known);
            *at = known.ok_or((ReadProblem::Missing, "X, Y and Z in the first block under tip control"))?;
        }
        let pace = match self.motion {
            Motion::None => {
                return Err((ReadProblem::Missing, "G0 or G1 before or beside the first axis word"));
            }
            Motion::Rapid => {
                if let (Some(feed), false) = (feed, self.inverse_time) {
                    self.feed = Some(feed);
                    self.blocks.push(Block::TipSpeed(feed / 60.0));
                }
                Pace::Rapid
            }
            Motion::Linear if self.inverse_time => Pace::Duration(inverse_time(feed)?),
            Motion::Linear => match feed {
                Some(feed) => {
                    self.feed = Some(feed);
                    Pace::Speed(feed / 60.0)
                }
                None => {
                    self.feed.ok_or((ReadProblem::Missing, "a feed F before the first G1"))?;
                    Pace::Kept
                }
            },
        };
        self.blocks.push(Block::Tip(TipMotion { tip: at, orientation, pace }));
        Ok(())
    }

    fn orientation(&mut self, direction: &Three, angles: &AxisWords) -> Result<Orientation, Fault> {
        match (direction.iter().any(Option::is_some), angles.is_empty()) {
            (false, true) => Ok(Orientation::Kept),
            (true, false) => Err((ReadProblem::Conflict, "a direction or angles of the tool's axis")),
            (true, true) => {
                self.tip_control(TipControl::Directions)?;
                // A part that is not named is 0.
                let parts = direction.map(|part| part.map_or(0.0, Decimal::value));
                unit(parts).map(Orientation::Direction)
            }
            (false, false) => {
                self.tip_control(TipControl::Angles)?;
                if angles.has_steps() {
                    return Err((ReadProblem::Conflict, "angles by their places under tip control"));
                }
                let targets = self.go(angles)?;
                let turns = |(axis, _): (usize, f64)| self.axes[axis].motion == AxisMotion::Rotary;
                let words: Vec<(usize, f64)> = targets.iter().collect();
                let made = Angles::new(&words).filter(|_| words.iter().copied().all(turns));
                made.map(Orientation::Angles)
                    .ok_or((ReadProblem::Conflict, "X, Y, Z and one to three rotary axes under tip control"))
            }
        }
    }
}

/// A direction of any length as a unit vector; one that was rounded stays as it stands in the text.
pub(super) fn unit(parts: [f64; 3]) -> Result<[f64; 3], Fault> {
    let length = parts.iter().map(|part| part * part).sum::<f64>().sqrt();
    if length < 1e-6 {
        return Err((ReadProblem::OutOfRange, "a direction that is not 0"));
    }
    let factor = if (length - 1.0).abs() <= UNIT { 1.0 } else { 1.0 / length };
    Ok(parts.map(|part| part * factor))
}
