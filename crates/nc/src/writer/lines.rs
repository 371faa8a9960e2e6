//! The text that all writers fill: lines of bounded length, their numbers, axis words, feeds. Knows no dialect's order of words.

use super::number::{push_fixed, push_units, units};
use super::options::{Decimals, FeedWords, Rounding, TipDecimals, WriteOptions, Written};
use crate::{AxisMotion, Coolant, MAXIMUM_AXES, NcError, ProbeMove, Program, Targets, Word};
use std::io::Write as _;

/// Decimals of dwells in s, of tolerances in mm and of spindle speeds in 1/min.
pub(super) const PLAIN_DECIMALS: u8 = 6;

/// Decimals of the speed of a probe, mm/min or deg/min.
const PROBING_DECIMALS: u8 = 3;

/// What a value of an axis looks like.
pub(super) struct AxisText {
    /// The address as the control names the axis: `X`, `B1`.
    pub address: Box<str>,
    /// What stands before the number: ` X` or ` B1=`.
    prefix: Box<[u8]>,
    /// Units of the text per unit of the program.
    pub scale: f64,
    decimals: u8,
    rotary: bool,
}

/// Kinds of feed.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum FeedMode {
    /// G93, which every preamble switches on.
    InverseTime,
    /// G94.
    PerMinute,
}

/// Most digits of a line number: what all controls here read.
const LARGEST_NUMBER: u64 = 99_999_999;

/// A text that grows line by line.
pub(super) struct Lines<'a> {
    /// The program.
    pub program: &'a Program,
    /// The axes, in the order of the program.
    pub axes: Vec<AxisText>,
    /// What is being written.
    pub text: Vec<u8>,
    /// The block being written, counted from 1; 0 before the first.
    pub block: usize,
    pub(super) decimals: Decimals,
    pub(super) tip_decimals: TipDecimals,
    /// Kind of the feed in force.
    mode: FeedMode,
    feed_words: FeedWords,
    /// Step of the line numbers and the last one given.
    numbers: Option<u32>,
    number: u64,
    line: usize,
    limit: usize,
    /// Where rotary axes are moved by increments: where all axes stand in units of their last digit.
    increments: Option<[Option<i64>; MAXIMUM_AXES]>,
    /// Largest change of the ratio of a lead term, rad/mm.
    pub lead_ratio: f64,
}

impl<'a> Lines<'a> {
    /// An empty text of lines up to `limit`; `address` makes an axis word's address of the dialect or refuses it.
    pub fn new(
        program: &'a Program,
        options: &WriteOptions,
        limit: usize,
        allowed: &'static str,
        address: impl Fn(&Word) -> Option<String>,
    ) -> Result<Self, NcError> {
        options.check()?;
        let decimals = options.decimals;
        let axes = program
            .axes()
            .iter()
            .map(|axis| {
                let refused = || NcError::AxisNotAvailable {
                    axis: axis.name.as_str().into(),
                    word: word_name(&axis.word),
                    allowed,
                };
                let address = address(&axis.word).ok_or_else(refused)?;
                let equals = if matches!(axis.word, Word::Named(_)) { "=" } else { "" };
                let rotary = axis.motion == AxisMotion::Rotary;
                Ok(AxisText {
                    prefix: format!(" {address}{equals}").into_bytes().into(),
                    address: address.into(),
                    scale: if rotary { 1f64.to_degrees() } else { 1.0 },
                    decimals: if rotary { decimals.deg } else { decimals.mm },
                    rotary,
                })
            })
            .collect::<Result<_, NcError>>()?;
        let increments = options.incremental_rotary.then_some([None; MAXIMUM_AXES]);
        // A line of a six-axis stroke has some 80 characters.
        let text = Vec::with_capacity(80 * program.blocks().len() + 256);
        Ok(Self {
            program,
            axes,
            text,
            block: 0,
            decimals,
            tip_decimals: options.tip_decimals,
            mode: FeedMode::InverseTime,
            feed_words: options.feed_words,
            numbers: options.line_numbers,
            number: 0,
            line: 0,
            limit,
            increments,
            lead_ratio: 0.0,
        })
    }

    /// Appends to the line.
    pub fn push(&mut self, text: &str) {
        self.text.extend_from_slice(text.as_bytes());
    }

    /// Appends what `format_args!` makes.
    pub fn push_format(&mut self, text: std::fmt::Arguments<'_>) {
        // Writing into memory does not fail.
        drop(self.text.write_fmt(text));
    }

    /// Ends the line.
    pub fn end_line(&mut self) -> Result<(), NcError> {
        let length = self.text.len() - self.line;
        if length > self.limit {
            return Err(NcError::BlockTooLong { block: self.block, length, limit: self.limit });
        }
        self.text.push(b'\n');
        self.line = self.text.len();
        Ok(())
    }

    /// The number of a straight block's line, if lines are numbered.
    pub fn line_number(&mut self) -> Result<(), NcError> {
        let Some(step) = self.numbers else { return Ok(()) };
        self.number += u64::from(step);
        if self.number > LARGEST_NUMBER {
            let (block, value) = (self.block, self.number as f64);
            let allowed = "line numbers to 99999999: take a smaller step";
            return Err(NcError::NumberRange { block, axis: "line number".into(), value, allowed });
        }
        let number = self.number;
        self.push_format(format_args!("N{number} "));
        Ok(())
    }

    /// Line number and word of the feed's kind before a straight block of axis values.
    pub fn start_axis_block(&mut self, rapid: bool) -> Result<(), NcError> {
        self.line_number()?;
        match (self.feed_words, rapid) {
            (FeedWords::OnChange, true) => {}
            (FeedWords::OnChange, false) => self.feed_mode(FeedMode::InverseTime),
            (FeedWords::AxisBlocks, true) => {
                self.mode = FeedMode::PerMinute;
                self.push("G94 ");
            }
            (FeedWords::AxisBlocks, false) => {
                self.mode = FeedMode::InverseTime;
                self.push("G93 ");
            }
        }
        Ok(())
    }

    /// The word of the feed's kind, if another one is in force.
    pub fn feed_mode(&mut self, mode: FeedMode) {
        if self.mode != mode {
            self.mode = mode;
            self.push(if mode == FeedMode::InverseTime { "G93 " } else { "G94 " });
        }
    }

    /// Inverse time by a line of its own, where blocks follow that have no place for the word.
    pub fn inverse_time(&mut self) -> Result<(), NcError> {
        if self.mode == FeedMode::InverseTime {
            return Ok(());
        }
        self.mode = FeedMode::InverseTime;
        self.push_line("G93")
    }

    /// Forgets where all axes stand: the control moves them.
    pub fn loose_all(&mut self) {
        if let Some(places) = &mut self.increments {
            *places = [None; MAXIMUM_AXES];
        }
    }

    /// The word of a supply of coolant, which all controls have alike.
    pub fn coolant(&mut self, coolant: Coolant) -> Result<(), NcError> {
        self.push_line(match coolant {
            Coolant::Off => "M9",
            Coolant::Flood => "M8",
            Coolant::Mist => "M7",
        })
    }

    /// A motion of one axis by words of a control, with the axis's place and a feed per minute behind them.
    pub fn probe(&mut self, words: &str, motion: &ProbeMove) -> Result<(), NcError> {
        self.line_number()?;
        self.mode = FeedMode::PerMinute;
        self.push("G94 ");
        self.push(words);
        self.absolute(motion.axis, motion.to);
        self.push(" F");
        let scale = self.axes[motion.axis].scale;
        self.fixed(60.0 * scale * motion.speed, PROBING_DECIMALS);
        self.loose(motion.axis);
        self.end_line()
    }

    /// A work offset beyond those that the control has.
    pub fn no_such_offset(&self, number: u16, allowed: &'static str) -> NcError {
        let (axis, value) = ("work offset".into(), f64::from(number));
        NcError::NumberRange { block: self.block, axis, value, allowed }
    }

    /// A whole line.
    pub fn push_line(&mut self, text: &str) -> Result<(), NcError> {
        self.push(text);
        self.end_line()
    }

    /// A number with so many decimals.
    pub fn fixed(&mut self, value: f64, decimals: u8) {
        push_fixed(&mut self.text, value, decimals);
    }

    /// A value of an axis, mm or rad, without its address.
    pub fn axis_value(&mut self, axis: usize, value: f64) {
        let AxisText { scale, decimals, .. } = self.axes[axis];
        self.fixed(value * scale, decimals);
    }

    /// The word of an axis, absolute.
    pub fn absolute(&mut self, index: usize, value: f64) {
        let axis = &self.axes[index];
        self.text.extend_from_slice(&axis.prefix);
        push_fixed(&mut self.text, value * axis.scale, axis.decimals);
    }

    /// The words of the targets, absolute.
    pub fn targets(&mut self, targets: &Targets) {
        targets.iter().for_each(|(axis, value)| self.absolute(axis, value));
    }

    /// F of a block in inverse time, at the end of its line.
    pub fn feed(&mut self, duration: f64) -> Result<(), NcError> {
        let feed = 60.0 / duration;
        // Below 1 four more decimals keep the time to 1e-6; of the greatest feeds a reader takes 18 digits.
        let decimals = match feed {
            _ if feed < 1.0 => self.decimals.feed + 4,
            _ if feed >= 1e8 => self.decimals.feed.min(8),
            _ => self.decimals.feed,
        };
        self.push(" F");
        self.fixed(feed, decimals);
        self.end_line()
    }

    /// Whether rotary axes are moved by increments.
    pub fn is_incremental(&self) -> bool {
        self.increments.is_some()
    }

    /// Whether the control knows where the axis stands, so that an increment means something.
    pub fn stands(&self, axis: usize) -> bool {
        self.increments.is_some_and(|places| places[axis].is_some())
    }

    /// The step of an axis to its new place as a word: address, `open`, increment, `close`. The increments are differences of
    /// rounded places, so that they do not drift.
    pub fn increment(&mut self, index: usize, value: f64, open: &str, close: &str) -> Result<(), NcError> {
        let axis = &self.axes[index];
        let to = units(value * axis.scale, axis.decimals).unwrap_or_default();
        let from = self.increments.and_then(|places| places[index]).unwrap_or_default();
        let step = to - from;
        let turn = 360 * 10i64.pow(u32::from(axis.decimals));
        if axis.rotary && step.abs() >= turn {
            return Err(NcError::NumberRange {
                block: self.block,
                axis: self.program.axes()[index].name.as_str().into(),
                value: (to - from) as f64 / 10f64.powi(i32::from(axis.decimals)),
                allowed: "steps below 360 deg for a control with modulo axes",
            });
        }
        self.text.extend_from_slice(&axis.prefix);
        self.text.extend_from_slice(open.as_bytes());
        push_units(&mut self.text, step, axis.decimals);
        self.text.extend_from_slice(close.as_bytes());
        Ok(())
    }

    /// Remembers where axes stand, if that is needed.
    pub fn moved(&mut self, targets: &Targets) {
        if let Some(places) = &mut self.increments {
            for (index, value) in targets.iter() {
                let axis = &self.axes[index];
                places[index] = units(value * axis.scale, axis.decimals);
            }
        }
    }

    /// Forgets where an axis stands: a gear moves it.
    pub fn loose(&mut self, axis: usize) {
        if let Some(places) = &mut self.increments {
            places[axis] = None;
        }
    }

    /// Whether a block has a rotary axis.
    pub fn turns(&self, targets: &Targets) -> bool {
        targets.iter().any(|(axis, _)| self.axes[axis].rotary)
    }

    /// A motion word and the words of the targets for dialects in which absolute and incremental are modes of the whole block.
    pub fn moded_targets(&mut self, motion: &str, targets: &Targets) -> Result<(), NcError> {
        self.start_axis_block(motion == "G0")?;
        if self.is_incremental() {
            let by_steps = self.turns(targets) && targets.iter().all(|(axis, _)| self.stands(axis));
            self.push(if by_steps { "G91 " } else { "G90 " });
            self.push(motion);
            if by_steps {
                targets.iter().try_for_each(|(axis, value)| self.increment(axis, value, "", ""))?;
            } else {
                self.targets(targets);
            }
            self.moved(targets);
        } else {
            self.push(motion);
            self.targets(targets);
        }
        Ok(())
    }

    /// The text with what rounding did.
    pub fn finish(self) -> Written {
        let half = |decimals: u8| 0.5 * 10f64.powi(-i32::from(decimals));
        let rounding = Rounding {
            linear: half(self.decimals.mm),
            rotary: half(self.decimals.deg).to_radians(),
            lead_ratio: self.lead_ratio,
        };
        // ASCII by construction: names, comments and addresses are checked, the rest is written here.
        let text = String::from_utf8(self.text)
            .unwrap_or_else(|error| String::from_utf8_lossy(error.as_bytes()).into_owned());
        Written { text, hal: None, rounding, warnings: Vec::new() }
    }
}

/// A word as a message shows it.
fn word_name(word: &Word) -> Box<str> {
    match word {
        Word::Letter(letter) => letter.to_string().into(),
        Word::Named(name) => name.as_str().into(),
        Word::Spindle(spindle) => format!("spindle {spindle}").into(),
    }
}

/// Speed of a spindle, rad/s as 1/min.
pub(super) fn per_minute(speed: f64) -> f64 {
    speed * (30.0 / std::f64::consts::PI)
}
