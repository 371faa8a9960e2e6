//! Pulses between the lines of a scale, and what they turn.

use crate::slot::{Slot, Stored};
use crate::status::{Failure, Refused, Status, give, status, told};
use electronic_gearbox::Sign;
use electronic_gearbox::chain::{AdditionalRotation, RateRule};
use electronic_gearbox::pulse::{ClockedInterpolator, Direction, Mode, PulseKind, Settings};

impl Stored for ClockedInterpolator {
    const WORDS: usize = 16;
    const MARK: u64 = 0x6567_7075_6c73_6531;
}

impl Stored for AdditionalRotation {
    const WORDS: usize = 12;
    const MARK: u64 = 0x6567_726f_7461_7431;
}

/// `eg_interpolator_status`.
#[repr(C)]
pub struct InterpolatorStatus {
    references: u64,
    overruns: u64,
    too_fast: u64,
    overruns_at_reversals: u64,
    short_reversals: u64,
    pending: i64,
    inserted: u32,
    spacing: u32,
}

/// A sense, 0 for none.
fn direction(sign: i32) -> Result<Option<Direction>, Status> {
    match sign {
        0 => Ok(None),
        _ => Direction::from_sign(sign.into()).map(Some).ok_or(Status::BadChoice),
    }
}

fn sign(direction: Direction) -> i32 {
    match direction {
        Direction::Forward => 1,
        Direction::Backward => -1,
    }
}

/// `eg_interpolator_init`.
#[unsafe(no_mangle)]
pub extern "C" fn eg_interpolator_init(
    interpolator: Option<&mut Slot<ClockedInterpolator>>,
    pulses_per_interval: u32,
    counter_limit: u32,
    mode: u32,
    error: Option<&mut Refused>,
) -> Status {
    let made = || {
        let mode = match mode {
            0 => Mode::NoBacklash,
            1 => Mode::OneWay,
            2 => Mode::Literal,
            _ => return Err(Status::BadChoice.into()),
        };
        let settings = Settings::new(pulses_per_interval, counter_limit, mode)?;
        Ok(Slot::put(interpolator, ClockedInterpolator::new(settings))?)
    };
    told(made(), error)
}

/// `eg_interpolator_tick`.
#[unsafe(no_mangle)]
pub extern "C" fn eg_interpolator_tick(
    interpolator: Option<&mut Slot<ClockedInterpolator>>,
    reference: i32,
    pulse: Option<&mut i32>,
    kind: Option<&mut u32>,
) -> Status {
    let made = || {
        let sent = Slot::value(interpolator)?.tick(direction(reference)?);
        if let Some(kind) = kind {
            *kind = match sent.map(|sent| sent.kind) {
                None => 0,
                Some(PulseKind::Reference) => 1,
                Some(PulseKind::Intermediate) => 2,
                Some(PulseKind::Correction) => 3,
            };
        }
        give(pulse, sent.map_or(0, |sent| sign(sent.direction)))
    };
    status(made())
}

/// `eg_interpolator_status_of`.
#[unsafe(no_mangle)]
pub extern "C" fn eg_interpolator_status_of(
    interpolator: Option<&mut Slot<ClockedInterpolator>>,
    answer: Option<&mut InterpolatorStatus>,
) -> Status {
    let made = || -> Result<(), Failure> {
        let s = Slot::value(interpolator)?.status();
        give(
            answer,
            InterpolatorStatus {
                references: s.references,
                overruns: s.overruns,
                too_fast: s.too_fast,
                overruns_at_reversals: s.overruns_at_reversals,
                short_reversals: s.short_reversals,
                pending: s.pending,
                inserted: s.inserted,
                spacing: s.spacing,
            },
        )
    };
    status(made())
}

/// `eg_rotation_init`.
#[unsafe(no_mangle)]
pub extern "C" fn eg_rotation_init(
    rotation: Option<&mut Slot<AdditionalRotation>>,
    word: u32,
    rule: u32,
    hand: i32,
    parts: u32,
    error: Option<&mut Refused>,
) -> Status {
    let made = || {
        let rule = match rule {
            0 => RateRule::Bresenham,
            1 => RateRule::Binary,
            _ => return Err(Status::BadChoice.into()),
        };
        let hand = match hand {
            1 => Sign::Plus,
            -1 => Sign::Minus,
            _ => return Err(Status::BadChoice.into()),
        };
        Ok(Slot::put(rotation, AdditionalRotation::new(word, rule, hand, parts)?)?)
    };
    told(made(), error)
}

/// `eg_rotation_pulse`.
#[unsafe(no_mangle)]
pub extern "C" fn eg_rotation_pulse(
    rotation: Option<&mut Slot<AdditionalRotation>>,
    pulse: i32,
    turned: Option<&mut i32>,
) -> Status {
    let made = || {
        let rotation = Slot::value(rotation)?;
        let passed = direction(pulse)?.and_then(|pulse| rotation.pulse(pulse));
        give(turned, passed.map_or(0, sign))
    };
    status(made())
}

/// `eg_rotation_position`.
#[unsafe(no_mangle)]
pub extern "C" fn eg_rotation_position(
    rotation: Option<&mut Slot<AdditionalRotation>>,
    coarse: Option<&mut i64>,
    fine: Option<&mut u32>,
) -> Status {
    let made = || {
        let position = Slot::value(rotation)?.position();
        give(coarse, position.coarse)?;
        give(fine, position.fine)
    };
    status(made())
}
