//! The modal state of a control while a program is read, and the neutral blocks that come out. Knows no text: the grammars of
//! the dialects tell it what happens.

use super::error::ReadProblem;
use super::probing::Probing;
use super::scan::Decimal;
use crate::{AxisMotion, AxisWord, Block, CubicMotion, CubicSpan, MAXIMUM_AXES, Targets, TipControl, Word};

/// How axis words without a motion word of their own move.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Motion {
    /// Not at all.
    None,
    Rapid,
    Linear,
}

/// What a fault is, without its place.
pub(super) type Fault = (ReadProblem, &'static str);

/// Axis words of one line.
#[derive(Clone, Copy)]
pub(super) struct AxisWords {
    values: [Decimal; MAXIMUM_AXES],
    present: u16,
    /// Those that are steps whatever the mode, and those that are places whatever the mode.
    steps: u16,
    places: u16,
}

/// How one axis word is meant.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Meaning {
    ByMode,
    Step,
    Place,
}

impl AxisWords {
    pub const NONE: Self = Self {
        values: [Decimal { mantissa: 0, decimals: 0, pointed: false }; MAXIMUM_AXES],
        present: 0,
        steps: 0,
        places: 0,
    };

    /// Adds a word; false if the axis has one already.
    pub fn add(&mut self, axis: usize, value: Decimal, meaning: Meaning) -> bool {
        let bit = 1 << axis;
        let new = self.present & bit == 0;
        self.values[axis] = value;
        self.present |= bit;
        self.steps |= if meaning == Meaning::Step { bit } else { 0 };
        self.places |= if meaning == Meaning::Place { bit } else { 0 };
        new
    }

    pub fn clear(&mut self) {
        (self.present, self.steps, self.places) = (0, 0, 0);
    }

    pub fn is_empty(&self) -> bool {
        self.present == 0
    }

    /// Whether one of the words is a step whatever the mode.
    pub fn has_steps(&self) -> bool {
        self.steps != 0
    }

    pub fn has(&self, axis: usize) -> bool {
        self.present >> axis & 1 == 1
    }
}

/// Where all axes stand, in units of the text.
pub(super) type Places = [Decimal; MAXIMUM_AXES];

pub(super) struct Machine<'a> {
    pub axes: &'a [AxisWord],
    pub blocks: Vec<Block>,
    pub motion: Motion,
    pub inverse_time: bool,
    pub incremental: bool,
    pub inch: bool,
    /// Feed of G94, mm/min or deg/min.
    pub feed: Option<f64>,
    pub ended: bool,
    /// Where the axes stand, in units of the text; what was never named stands at 0.
    pub places: Places,
    /// Tip control, if it is on.
    pub tip: Option<Tip>,
    /// Axes that tip control has moved to where no text says, as bits.
    pub lost: u16,
    /// Length offset in force, and whether tip control alone uses it.
    pub length: Option<u32>,
    pub length_of_tip: bool,
    /// A motion that a probe ends, until its place is kept.
    pub probing: Option<Probing>,
    /// Work offset in force; 0: the count of the machine.
    pub work_offset: u16,
    /// Speed, 1/min, and direction of each spindle.
    spindles: [(Option<f64>, f64); 8],
}

/// Which axes a feed of G94 counts for: X Y Z and addresses, else U V W, else those that turn.
fn feed_group(axis: &AxisWord) -> usize {
    match (axis.motion, &axis.word) {
        (AxisMotion::Rotary, _) => 2,
        (AxisMotion::Linear, Word::Letter('U' | 'V' | 'W')) => 1,
        (AxisMotion::Linear, _) => 0,
    }
}

impl<'a> Machine<'a> {
    pub fn new(axes: &'a [AxisWord]) -> Self {
        Self {
            axes,
            blocks: Vec::new(),
            motion: Motion::None,
            inverse_time: false,
            incremental: false,
            inch: false,
            feed: None,
            ended: false,
            places: [Decimal::default(); MAXIMUM_AXES],
            tip: None,
            lost: 0,
            length: None,
            length_of_tip: false,
            probing: None,
            work_offset: 0,
            spindles: [(None, 0.0); 8],
        }
    }

    /// A value of the text as the neutral program has it: mm or rad.
    pub fn neutral(&self, axis: usize, value: f64) -> f64 {
        if self.axes[axis].motion == AxisMotion::Rotary { value.to_radians() } else { value }
    }

    /// Where an axis stands, mm or rad.
    pub fn place(&self, axis: usize) -> f64 {
        self.neutral(axis, self.places[axis].value())
    }

    /// The places that axis words mean; the axes stand there afterwards.
    pub fn go(&mut self, words: &AxisWords) -> Result<Targets, Fault> {
        let mut targets = Targets::NONE;
        let mut left = words.present;
        while left != 0 {
            let axis = left.trailing_zeros() as usize;
            let bit = left & left.wrapping_neg();
            left ^= bit;
            let out_of_range = (ReadProblem::OutOfRange, "values of at most 18 digits");
            let mut value = words.values[axis];
            if self.inch && self.axes[axis].motion == AxisMotion::Linear {
                value = value.inches().ok_or(out_of_range)?;
            }
            if words.steps & bit != 0 || (self.incremental && words.places & bit == 0) {
                self.found(bit)?;
                value = self.places[axis].plus(value).ok_or(out_of_range)?;
            }
            self.places[axis] = value;
            targets.set(axis, self.neutral(axis, value.value()));
        }
        self.lost &= !words.present;
        Ok(targets)
    }

    /// Where axes stand must be known: tip control has not left them somewhere.
    fn found(&self, axes: u16) -> Result<(), Fault> {
        if self.lost & axes == 0 {
            return Ok(());
        }
        Err((ReadProblem::Missing, "the place of the axis by G0 after tip control"))
    }

    /// Time of a straight move of `length` units of the text with the F of its line.
    fn duration(&mut self, feed: Option<f64>, from: &Places, moved: u16) -> Result<f64, Fault> {
        if self.inverse_time {
            return inverse_time(feed);
        }
        if let Some(feed) = feed {
            self.feed = Some(feed);
        }
        let feed = self.feed.ok_or((ReadProblem::Missing, "a feed F before the first G1"))?;
        let mut squares = [0.0; 3];
        for (axis, word) in self.axes.iter().enumerate().filter(|(axis, _)| moved >> axis & 1 == 1) {
            let way = self.places[axis].value() - from[axis].value();
            squares[feed_group(word)] += way * way;
        }
        let square = squares.into_iter().find(|&square| square > 0.0).unwrap_or(0.0);
        Ok(60.0 * square.sqrt() / feed)
    }

    /// Axis words by the motion in force.
    pub fn straight(&mut self, words: &AxisWords, feed: Option<f64>) -> Result<(), Fault> {
        let from = if self.inverse_time { [Decimal::default(); MAXIMUM_AXES] } else { self.places };
        match self.motion {
            Motion::None => {
                return Err((ReadProblem::Missing, "G0 or G1 before or beside the first axis word"));
            }
            Motion::Rapid => {
                let target = self.go(words)?;
                if !self.inverse_time && feed.is_some() {
                    self.feed = feed;
                }
                self.blocks.push(Block::Rapid(target));
            }
            Motion::Linear => {
                if !self.inverse_time {
                    self.found(words.present)?;
                }
                let target = self.go(words)?;
                let duration = self.duration(feed, &from, words.present)?;
                // A feed per minute over no way takes no time and does nothing.
                if duration > 0.0 {
                    self.blocks.push(Block::Linear { target, duration });
                }
            }
        }
        Ok(())
    }

    /// A block of cubics, of axes that go straight and axes that have coefficients a2 and a3
    /// (`docs/mathematics/programs.md#the-independent-reader`).
    pub fn cubic(
        &mut self,
        words: &AxisWords,
        coefficients: &[(usize, f64, f64)],
        feed: Option<f64>,
    ) -> Result<(), Fault> {
        let duration = inverse_time(feed)?;
        self.found(words.present)?;
        let before: [f64; MAXIMUM_AXES] =
            std::array::from_fn(|axis| if words.has(axis) { self.place(axis) } else { 0.0 });
        let target = self.go(words)?;
        let spans = target.iter().map(|(axis, end)| {
            let (a2, a3) = coefficients
                .iter()
                .find(|(of, ..)| *of == axis)
                .map_or((0.0, 0.0), |&(_, a2, a3)| (self.neutral(axis, a2), self.neutral(axis, a3)));
            (axis, span(before[axis], end, a2, a3))
        });
        let spans = spans.collect();
        self.blocks.push(Block::Cubic(Box::new(CubicMotion { spans, duration })));
        Ok(())
    }

    /// Speed and direction words of a line; none leaves what was.
    pub fn spindle(
        &mut self,
        spindle: usize,
        speed: Option<f64>,
        direction: Option<f64>,
    ) -> Result<(), Fault> {
        let Some(state) = self.spindles.get_mut(spindle) else {
            return Err((ReadProblem::OutOfRange, "eight spindles"));
        };
        if let Some(speed) = speed {
            if !(0.0..=1e6).contains(&speed) {
                return Err((ReadProblem::OutOfRange, "speeds of 0 to 1e6 1/min"));
            }
            state.0 = Some(speed);
        }
        let turned = state.1;
        state.1 = direction.unwrap_or(turned);
        if direction.is_none() && turned == 0.0 {
            return Ok(());
        }
        let speed = match (state.1, state.0) {
            (0.0, _) => 0.0,
            (direction, Some(speed)) => direction * speed * (std::f64::consts::PI / 30.0),
            (_, None) => return Err((ReadProblem::Missing, "a speed S before the spindle is started")),
        };
        self.blocks.push(Block::Spindle { spindle: spindle as u8, speed });
        Ok(())
    }

    /// Spindle 0 stands; its speed stays what it was set to.
    pub fn still(&mut self) {
        self.spindles[0].1 = 0.0;
    }

    /// A digital output.
    pub fn output(&mut self, number: Option<u32>, on: bool) -> Result<(), Fault> {
        let number = number.and_then(|number| u8::try_from(number).ok());
        let number = number.filter(|number| (1..=15).contains(number));
        let number = number.ok_or((ReadProblem::OutOfRange, "outputs 1 to 15"))?;
        self.blocks.push(Block::Output { number, on });
        Ok(())
    }

    /// A dwell of so many seconds.
    pub fn dwell(&mut self, seconds: f64) -> Result<(), Fault> {
        if !(0.0..=1e6).contains(&seconds) {
            return Err((ReadProblem::OutOfRange, "0 to 1e6 s"));
        }
        // To wait for no time does nothing.
        if seconds > 0.0 {
            self.blocks.push(Block::Dwell(seconds));
        }
        Ok(())
    }
}

/// Time of a block from its F in inverse time, s.
pub(super) fn inverse_time(feed: Option<f64>) -> Result<f64, Fault> {
    Ok(60.0 / feed.ok_or((ReadProblem::Missing, "F in every block of G93 that is no G0"))?)
}

/// The cubic from `start` to `end` with coefficients a2 and a3 of u in 0..1.
pub(super) fn span(start: f64, end: f64, a2: f64, a3: f64) -> CubicSpan {
    let a1 = end - start - a2 - a3;
    CubicSpan { end, start_slope: a1, end_slope: a1 + 2.0 * a2 + 3.0 * a3 }
}

/// Tip control that is on.
#[derive(Default)]
pub(super) struct Tip {
    /// Where the block that switched it on is, and what that says already.
    pub block: usize,
    pub control: Option<TipControl>,
    /// Where the tip is, as far as the program has said it.
    pub places: [Option<f64>; 3],
}
