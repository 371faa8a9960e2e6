//! How a call went: a number, its name, what helps, and which value was refused.

use core::ffi::{CStr, c_char};
use electronic_gearbox::{Error, TableFault, TrainFault};

/// `eg_status`. The numbers stay.
#[repr(i32)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Status {
    /// Done.
    Ok = 0,
    /// P or the limit of the period counter.
    BadMultiplier = 1,
    /// A number outside its range.
    BadParameter = 2,
    /// A reference pulse that cannot be.
    BadReference = 3,
    /// b beyond a rate multiplier.
    CoefficientTooLarge = 4,
    /// A lead of a spur gear.
    SpurGear = 5,
    /// Gear data that describe no gear.
    BadGear = 6,
    /// A ratio, position or sum beyond the accumulators.
    GearRange = 7,
    /// A counter moved too far between two readings.
    EncoderJump = 8,
    /// A table that cannot be interpolated.
    BadTable = 9,
    /// The coupling is closed.
    Busy = 10,
    /// The coupling is open.
    NotEngaged = 11,
    /// A pointer is null.
    NullPointer = 12,
    /// Storage that was not set up.
    NotInitialised = 13,
    /// A number that names no choice.
    BadChoice = 14,
}

impl From<Error> for Status {
    fn from(error: Error) -> Self {
        match error {
            Error::PulsesPerInterval { .. } | Error::CounterLimit { .. } => Self::BadMultiplier,
            Error::BadParameter { .. } => Self::BadParameter,
            Error::BadReferenceTrain { .. } => Self::BadReference,
            Error::CoefficientTooLarge { .. } => Self::CoefficientTooLarge,
            Error::SpurGear => Self::SpurGear,
            Error::BadGear { .. } => Self::BadGear,
            Error::GearRange { .. } => Self::GearRange,
            Error::EncoderJump { .. } => Self::EncoderJump,
            Error::BadTable { .. } => Self::BadTable,
            Error::Busy => Self::Busy,
            Error::NotEngaged => Self::NotEngaged,
        }
    }
}

impl Status {
    const fn texts(number: i32) -> (&'static CStr, &'static CStr) {
        match number {
            0 => (c"ok", c""),
            1 => (
                c"bad-multiplier",
                c"choose 2 to 256 pulses per reference interval and a period counter of at least one count",
            ),
            2 => (c"bad-parameter", c"give a finite value within the range"),
            3 => (
                c"bad-reference-train",
                c"give reference pulses in the order of their ticks, from tick 1 on, with signs +1 or -1",
            ),
            4 => (
                c"coefficient-too-large",
                c"take a finer scale of the slide or fewer pulses per revolution of the workpiece",
            ),
            5 => (
                c"spur-gear",
                c"a spur gear needs no additional rotation: leave the coupling to the feed out",
            ),
            6 => (c"bad-gear", c"check the gear data against the drawing"),
            7 => (c"gear-range", c"shorten the fraction, or take coarser counts"),
            8 => (c"encoder-jump", c"read the counter more often or use a wider one"),
            9 => (c"bad-table", c"give at least two finite values at equal positive distances"),
            10 => (c"busy", c"switch the coupling off first"),
            11 => (c"not-engaged", c"engage the coupling first"),
            12 => (c"null-pointer", c"pass the address of the object"),
            13 => (c"not-initialised", c"call the _init function of this storage first"),
            14 => (c"bad-choice", c"pass one of the constants of the header"),
            _ => (c"unknown-status", c"pass a status that a function of this library returned"),
        }
    }
}

/// A text that does not end with 0: `printf("%.*s", (int)text.length, text.start)`.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct Text {
    start: *const c_char,
    length: usize,
}

impl Text {
    const fn of(text: &'static str) -> Self {
        Self { start: text.as_ptr().cast(), length: text.len() }
    }
}

/// `eg_error`: what was refused.
#[repr(C)]
pub struct Refused {
    status: Status,
    name: Text,
    value: f64,
    allowed: Text,
}

impl Refused {
    fn of_status(status: Status) -> Self {
        Self { status, name: Text::of(""), value: 0.0, allowed: Text::of("") }
    }

    fn of_error(error: Error) -> Self {
        let (name, value, allowed) = match error {
            Error::PulsesPerInterval { value } => {
                ("pulses per reference interval", f64::from(value), "2 to 256")
            }
            Error::CounterLimit { value } => ("limit of the period counter", f64::from(value), "at least 1"),
            Error::BadParameter { name, value, allowed } | Error::BadGear { name, value, allowed } => {
                (name, value, allowed)
            }
            Error::BadReferenceTrain { fault: TrainFault::Tick { tick, .. }, .. } => {
                ("tick of a reference pulse", tick as f64, "later than all before")
            }
            Error::BadReferenceTrain { fault: TrainFault::Sign { sign }, .. } => {
                ("sign of a reference pulse", sign as f64, "+1 or -1")
            }
            Error::CoefficientTooLarge { b, .. } => ("coefficient b", b, "below 1 - 2^-19"),
            Error::GearRange { name, value } => (name, value as f64, "within the range of the gearbox, 2^62"),
            Error::EncoderJump { difference, .. } => {
                ("way of a counter between two readings", difference as f64, "less than half its range")
            }
            Error::BadTable { reason } => match reason {
                TableFault::TooFewKnots { knots } => ("knots of a table", knots as f64, "at least 2"),
                TableFault::Spacing { value } => ("distance of knots", value, "above 0, finite"),
                TableFault::NotPeriodic { last, .. } => {
                    ("last value of a periodic table", last, "its first value")
                }
                TableFault::NotFinite { index } => {
                    ("value of a table that is not finite, number", index as f64, "finite values")
                }
                TableFault::Storage { slopes, .. } => {
                    ("slopes of a table", slopes as f64, "as many as values")
                }
                TableFault::Workspace { given, .. } => {
                    ("numbers to work with", given as f64, "twice the number of values")
                }
            },
            Error::SpurGear | Error::Busy | Error::NotEngaged => ("", 0.0, ""),
        };
        Self { status: error.into(), name: Text::of(name), value, allowed: Text::of(allowed) }
    }
}

/// Why a call failed: with a value, or without.
pub(crate) enum Failure {
    Status(Status),
    Error(Error),
}

impl From<Status> for Failure {
    fn from(status: Status) -> Self {
        Self::Status(status)
    }
}

impl From<Error> for Failure {
    fn from(error: Error) -> Self {
        Self::Error(error)
    }
}

/// The status of a call; what was refused goes to `report`, which may be null.
pub(crate) fn told(result: Result<(), Failure>, report: Option<&mut Refused>) -> Status {
    let refused = match result {
        Ok(()) => Refused::of_status(Status::Ok),
        Err(Failure::Status(status)) => Refused::of_status(status),
        Err(Failure::Error(error)) => Refused::of_error(error),
    };
    let status = refused.status;
    if let Some(report) = report {
        *report = refused;
    }
    status
}

/// The status of a call in the running loop.
pub(crate) fn status(result: Result<(), Failure>) -> Status {
    match result {
        Ok(()) => Status::Ok,
        Err(Failure::Status(status)) => status,
        Err(Failure::Error(error)) => error.into(),
    }
}

/// Writes to where a pointer of C leads.
pub(crate) fn give<T>(place: Option<&mut T>, value: T) -> Result<(), Failure> {
    *place.ok_or(Status::NullPointer)? = value;
    Ok(())
}

/// `eg_status_name`: the name of a status in kebab case.
#[unsafe(no_mangle)]
pub extern "C" fn eg_status_name(status: i32) -> *const c_char {
    Status::texts(status).0.as_ptr()
}

/// `eg_status_way_out`: what helps, in one sentence.
#[unsafe(no_mangle)]
pub extern "C" fn eg_status_way_out(status: i32) -> *const c_char {
    Status::texts(status).1.as_ptr()
}
