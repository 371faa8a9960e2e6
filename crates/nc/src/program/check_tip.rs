//! What blocks under tip control must keep whatever control they are for: their order, unit vectors, rotary axes, speeds. Knows no
//! dialect.

use super::check_state::{State, TipState};
use super::{AxisMotion, Block, Orientation, Pace, TipControl, TipMotion, Word};
use crate::NcError;

/// Speeds of the tip that a text with one decimal still tells from a standstill, mm/min.
const SPEED: [f64; 2] = [0.1, 1e6];
/// How far a unit vector may be off its length: what rounding its components to four decimals leaves, and some more.
const UNIT: f64 = 1e-3;
/// Largest place of the tip, mm.
const PLACE: f64 = 999_999.999_999;

impl State<'_> {
    fn tip_state(&self, reason: &'static str) -> NcError {
        NcError::TipControlState { block: self.block, reason }
    }

    /// Whether the block may stand where it does.
    pub(super) fn fits_tip_control(&self, block: &Block) -> Result<(), NcError> {
        let either = matches!(
            block,
            Block::Dwell(_)
                | Block::Spindle { .. }
                | Block::Output { .. }
                | Block::Coolant(_)
                | Block::Comment(_)
                | Block::Stop
                | Block::TipControlOn(_)
        );
        let tip = matches!(block, Block::Tip(_) | Block::TipSpeed(_) | Block::TipControlOff);
        match (self.tip.on, either, tip) {
            (Some(_), false, false) => Err(self.tip_state("is not possible under tip control")),
            (None, false, true) => Err(self.tip_state("is possible under tip control only")),
            _ => Ok(()),
        }
    }

    /// A tool call, or a block of tip control.
    pub(super) fn tip_block(&mut self, block: &Block) -> Result<(), NcError> {
        match block {
            Block::Tool { number, length_offset } => {
                self.tool_number("tool", *number, 99_999_999, "tools 1 to 99999999")?;
                if let Some(offset) = length_offset {
                    self.tool_number("length offset", *offset, 999, "length offsets 1 to 999")?;
                }
                (self.tip.tool, self.tip.offset, self.tip.lengthened) =
                    (true, length_offset.is_some(), false);
                self.speeds[0] = 0.0;
            }
            Block::TipControlOn(control) => {
                if self.tip.on.is_some() {
                    return Err(self.tip_state("switches tip control on that is on"));
                }
                if self.is_coupled() {
                    return Err(self.tip_state("switches tip control on under a gear"));
                }
                if self.tip.lengthened {
                    return Err(self.tip_state(
                        "switches tip control on while the control adds a length to axis values",
                    ));
                }
                if !self.tip.offset {
                    return Err(self.tip_state("needs a tool with a length offset before"));
                }
                self.tip = TipState { on: Some(*control), oriented: false, paced: false, ..self.tip };
            }
            Block::TipControlOff => {
                self.tip.on = None;
                // The control has moved all axes as it needed them.
                self.known = 0;
            }
            Block::LengthOffset(offset) => {
                if let Some(offset) = offset {
                    self.tool_number("length offset", *offset, 999, "length offsets 1 to 999")?;
                }
                if !self.tip.tool {
                    return Err(self.tip_state("adds the length of a tool that nothing has called"));
                }
                self.tip.lengthened = offset.is_some();
                // The axes stand elsewhere in the new count.
                self.known = 0;
            }
            Block::Tip(motion) => self.tip_motion(motion)?,
            Block::TipSpeed(speed) => {
                self.tip_speed(*speed)?;
                self.tip.paced = true;
            }
            _ => {}
        }
        Ok(())
    }

    fn tool_number(&self, what: &str, number: u32, most: u32, allowed: &'static str) -> Result<(), NcError> {
        if (1..=most).contains(&number) {
            return Ok(());
        }
        Err(NcError::NumberRange { block: self.block, axis: what.into(), value: number.into(), allowed })
    }

    fn tip_motion(&mut self, motion: &TipMotion) -> Result<(), NcError> {
        let block = self.block;
        for (name, value) in ["tip X", "tip Y", "tip Z"].into_iter().zip(motion.tip) {
            // Written so that NaN fails.
            let inside = value.abs() <= PLACE;
            if !inside {
                let allowed = "-999999.999999 to 999999.999999 mm";
                return Err(NcError::NumberRange { block, axis: name.into(), value, allowed });
            }
        }
        match (motion.orientation, self.tip.on) {
            (Orientation::Kept, _) if self.tip.oriented => {}
            (Orientation::Kept, _) => {
                return Err(self.tip_state("keeps a direction of the tool's axis that nothing has given"));
            }
            (Orientation::Direction(direction), Some(TipControl::Directions)) => {
                let length = direction.iter().map(|part| part * part).sum::<f64>().sqrt();
                // Written so that NaN fails.
                let unit = (length - 1.0).abs() <= UNIT;
                if !unit {
                    let axis = "length of the tool's direction".into();
                    let allowed = "a unit vector";
                    return Err(NcError::NumberRange { block, axis, value: length, allowed });
                }
            }
            (Orientation::Angles(angles), Some(TipControl::Angles)) => {
                for (index, value) in angles.iter() {
                    let axis = self.movable(index)?;
                    self.value(axis, value)?;
                    let tip_word = matches!(axis.word, Word::Letter('X' | 'Y' | 'Z'));
                    if axis.motion != AxisMotion::Rotary || tip_word {
                        return Err(self.tip_state(
                            "turns the tool by an axis that is straight or has a word of the tip",
                        ));
                    }
                }
            }
            _ => {
                return Err(
                    self.tip_state("gives the tool's axis in another form than the tip control expects")
                );
            }
        }
        self.tip.oriented = true;
        match motion.pace {
            Pace::Rapid => {}
            Pace::Kept if self.tip.paced => {}
            Pace::Kept => return Err(self.tip_state("keeps a speed that nothing has given")),
            Pace::Speed(speed) => {
                self.tip_speed(speed)?;
                self.tip.paced = true;
            }
            Pace::Duration(duration) => {
                self.duration(duration)?;
                // Controls forget the speed with the kind of the feed.
                self.tip.paced = false;
            }
        }
        Ok(())
    }

    fn tip_speed(&self, speed: f64) -> Result<(), NcError> {
        let shown = speed * 60.0;
        if (SPEED[0]..=SPEED[1]).contains(&shown) {
            return Ok(());
        }
        let (axis, allowed) = ("speed of the tip".into(), "0.1 to 1e6 mm/min");
        Err(NcError::NumberRange { block: self.block, axis, value: shown, allowed })
    }
}
