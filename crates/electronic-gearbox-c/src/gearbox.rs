//! Leading axes that are summed exactly, counters that wrap, and a ratio driven pulse by pulse.

use crate::array;
use crate::gear::Fraction;
use crate::slot::{Slot, Stored};
use crate::status::{Failure, Refused, Status, give, status, told};
use electronic_gearbox::coupling::{
    Bresenham, Gearbox, GearboxPosition, IncrementalGearbox, LinearTerm, Ratio, WrappingCounter,
};
use electronic_gearbox::pulse::Direction;
use electronic_gearbox::{Error, coupling};

/// A gearbox of as many axes as were given. Eight take the time of eight: between four and eight there is no size of its own.
#[derive(Clone, Copy)]
pub enum Axes {
    /// One leading axis.
    One(IncrementalGearbox<1>),
    /// Two.
    Two(IncrementalGearbox<2>),
    /// Three.
    Three(IncrementalGearbox<3>),
    /// Four.
    Four(IncrementalGearbox<4>),
    /// Five to eight, as many as the number says, the rest at rest.
    Eight(IncrementalGearbox<8>, usize),
}

impl Stored for Axes {
    const WORDS: usize = 64;
    const MARK: u64 = 0x6567_6765_6172_7331;
}

impl Stored for WrappingCounter {
    const WORDS: usize = 4;
    const MARK: u64 = 0x6567_636f_756e_7431;
}

impl Stored for Bresenham {
    const WORDS: usize = 8;
    const MARK: u64 = 0x6567_6c69_6e65_3031;
}

/// Greatest number of leading axes.
const MOST_AXES: usize = 8;

impl Axes {
    fn new(ratios: &[Fraction], leading: &[i64], follower: i64) -> Result<Self, Failure> {
        if !(1..=MOST_AXES).contains(&ratios.len()) {
            let (name, value) = ("number of leading axes", ratios.len() as f64);
            return Err(Error::BadParameter { name, value, allowed: "1 to 8" }.into());
        }
        Ok(match ratios.len() {
            1 => Self::One(closed(ratios, leading, follower)?),
            2 => Self::Two(closed(ratios, leading, follower)?),
            3 => Self::Three(closed(ratios, leading, follower)?),
            4 => Self::Four(closed(ratios, leading, follower)?),
            count => Self::Eight(closed(ratios, leading, follower)?, count),
        })
    }

    fn advance(&mut self, steps: *const i64, axes: usize) -> Result<(), Failure> {
        if axes != self.axes() {
            let (name, value) = ("number of ways", axes as f64);
            let allowed = "as many as the gearbox has leading axes";
            return Err(Error::BadParameter { name, value, allowed }.into());
        }
        let steps = array::read(steps, axes)?;
        match self {
            Self::One(gearbox) => gearbox.advance(&filled(steps))?,
            Self::Two(gearbox) => gearbox.advance(&filled(steps))?,
            Self::Three(gearbox) => gearbox.advance(&filled(steps))?,
            Self::Four(gearbox) => gearbox.advance(&filled(steps))?,
            Self::Eight(gearbox, _) => gearbox.advance(&filled(steps))?,
        }
        Ok(())
    }

    fn axes(&self) -> usize {
        match self {
            Self::One(_) => 1,
            Self::Two(_) => 2,
            Self::Three(_) => 3,
            Self::Four(_) => 4,
            Self::Eight(_, count) => *count,
        }
    }

    fn position(&self) -> Result<GearboxPosition, Error> {
        match self {
            Self::One(gearbox) => gearbox.position(),
            Self::Two(gearbox) => gearbox.position(),
            Self::Three(gearbox) => gearbox.position(),
            Self::Four(gearbox) => gearbox.position(),
            Self::Eight(gearbox, _) => gearbox.position(),
        }
    }
}

/// The first K of a list, zeros where it ends.
fn filled<const K: usize>(list: &[i64]) -> [i64; K] {
    let mut all = [0; K];
    all.iter_mut().zip(list).for_each(|(place, value)| *place = *value);
    all
}

fn closed<const K: usize>(
    ratios: &[Fraction],
    leading: &[i64],
    follower: i64,
) -> Result<IncrementalGearbox<K>, Failure> {
    let leading = filled::<K>(leading);
    let mut terms = [LinearTerm::new(Ratio::new(0, 1)?, 0); K];
    for ((term, ratio), zero) in terms.iter_mut().zip(ratios).zip(leading) {
        *term = LinearTerm::new(Ratio::new(ratio.numerator, ratio.denominator)?, zero);
    }
    let mut gearbox = Gearbox::new(0, terms);
    gearbox.engage(&leading, follower)?;
    Ok(IncrementalGearbox::new(gearbox, &leading)?)
}

/// `eg_gearbox_init`.
#[unsafe(no_mangle)]
pub extern "C" fn eg_gearbox_init(
    gearbox: Option<&mut Slot<Axes>>,
    axes: usize,
    ratios: *const Fraction,
    leading: *const i64,
    follower: i64,
    error: Option<&mut Refused>,
) -> Status {
    let made = || {
        let count = axes.min(MOST_AXES + 1);
        let axes = Axes::new(array::read(ratios, count)?, array::read(leading, count)?, follower)?;
        Ok(Slot::put(gearbox, axes)?)
    };
    told(made(), error)
}

/// `eg_gearbox_advance`.
#[unsafe(no_mangle)]
pub extern "C" fn eg_gearbox_advance(
    gearbox: Option<&mut Slot<Axes>>,
    axes: usize,
    steps: *const i64,
) -> Status {
    status(Slot::value(gearbox).map_err(Failure::from).and_then(|gearbox| gearbox.advance(steps, axes)))
}

/// `eg_gearbox_position`.
#[unsafe(no_mangle)]
pub extern "C" fn eg_gearbox_position(
    gearbox: Option<&mut Slot<Axes>>,
    counts: Option<&mut i64>,
    fraction: Option<&mut u32>,
) -> Status {
    let made = || {
        let position = Slot::value(gearbox)?.position()?;
        if let Some(fraction) = fraction {
            *fraction = position.fraction;
        }
        give(counts, position.counts)
    };
    status(made())
}

/// `eg_counter_init`.
#[unsafe(no_mangle)]
pub extern "C" fn eg_counter_init(
    counter: Option<&mut Slot<WrappingCounter>>,
    bits: u32,
    first: u64,
    largest_step: u32,
    error: Option<&mut Refused>,
) -> Status {
    let made = || {
        let plain = WrappingCounter::new(bits, first)?;
        let limited = if largest_step == 0 { plain } else { plain.with_largest_step(largest_step) };
        Ok(Slot::put(counter, limited)?)
    };
    told(made(), error)
}

/// `eg_counter_read`.
#[unsafe(no_mangle)]
pub extern "C" fn eg_counter_read(
    counter: Option<&mut Slot<WrappingCounter>>,
    value: u64,
    way: Option<&mut i64>,
) -> Status {
    let made = || give(way, Slot::value(counter)?.read(value)?);
    status(made())
}

/// `eg_line_init`.
#[unsafe(no_mangle)]
pub extern "C" fn eg_line_init(
    line: Option<&mut Slot<Bresenham>>,
    numerator: i64,
    denominator: i64,
    error: Option<&mut Refused>,
) -> Status {
    let made = || Ok(Slot::put(line, Bresenham::new(coupling::Ratio::new(numerator, denominator)?)?)?);
    told(made(), error)
}

/// `eg_line_pulse`.
#[unsafe(no_mangle)]
pub extern "C" fn eg_line_pulse(
    line: Option<&mut Slot<Bresenham>>,
    pulse: i32,
    sent: Option<&mut i32>,
) -> Status {
    let made = || {
        let line = Slot::value(line)?;
        let pulse = Direction::from_sign(pulse.into()).ok_or(Status::BadChoice)?;
        let answer = match line.pulse(pulse) {
            Some(Direction::Forward) => 1,
            Some(Direction::Backward) => -1,
            None => 0,
        };
        give(sent, answer)
    };
    status(made())
}
