//! Lines of blocks under tip control (`docs/mathematics/programs.md#cutters`), which Siemens and Fanuc write alike but for the words of a
//! direction.

use super::lines::{FeedMode, Lines};
use super::number::push_fixed;
use crate::{NcError, Orientation, Pace, TipMotion};

/// Words of the tip, whatever the axes of the machine are called.
const PLACE: [&str; 3] = [" X", " Y", " Z"];

impl Lines<'_> {
    /// A straight block of the tip; `direction` are the words of the tool's axis.
    pub(super) fn tip(&mut self, motion: &TipMotion, direction: [&str; 3]) -> Result<(), NcError> {
        self.line_number()?;
        match motion.pace {
            Pace::Rapid => {}
            Pace::Speed(_) | Pace::Kept => self.feed_mode(FeedMode::PerMinute),
            Pace::Duration(_) => self.feed_mode(FeedMode::InverseTime),
        }
        self.push(if motion.pace == Pace::Rapid { "G0" } else { "G1" });
        let (place, part) = (self.decimals.mm, self.tip_decimals.direction);
        self.three(PLACE, motion.tip, place);
        match motion.orientation {
            Orientation::Kept => {}
            Orientation::Direction(parts) => self.three(direction, parts, part),
            Orientation::Angles(angles) => {
                if self.is_incremental() {
                    let what = "steps of modulo axes under tip control";
                    return Err(NcError::BlockNotAvailable { block: self.block, what });
                }
                angles.iter().for_each(|(axis, value)| self.absolute(axis, value));
            }
        }
        match motion.pace {
            Pace::Rapid | Pace::Kept => self.end_line(),
            Pace::Speed(speed) => {
                self.push(" F");
                self.fixed(speed * 60.0, self.tip_decimals.speed);
                self.end_line()
            }
            Pace::Duration(duration) => self.feed(duration),
        }
    }

    /// The speed of the tip by a line of its own.
    pub(super) fn tip_speed(&mut self, speed: f64) -> Result<(), NcError> {
        self.feed_mode(FeedMode::PerMinute);
        self.push("F");
        self.fixed(speed * 60.0, self.tip_decimals.speed);
        self.end_line()
    }

    fn three(&mut self, words: [&str; 3], values: [f64; 3], decimals: u8) {
        for (word, value) in words.into_iter().zip(values) {
            self.push(word);
            push_fixed(&mut self.text, value, decimals);
        }
    }
}
