//! Errors of the input of a gearbox: one enum, with the data of the case. Nothing here allocates.

use core::fmt;

/// Why an input is refused. Running modules never fail this way: their states are counted (`Status`), not returned.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Error {
    /// P outside 2..=256.
    PulsesPerInterval {
        /// P as given.
        value: u32,
    },
    /// The period counter cannot count.
    CounterLimit {
        /// C_max as given.
        value: u32,
    },
    /// A parameter is NaN, infinite or outside its range.
    BadParameter {
        /// Which.
        name: &'static str,
        /// Its value.
        value: f64,
        /// What is allowed.
        allowed: &'static str,
    },
    /// A reference pulse that cannot be.
    BadReferenceTrain {
        /// Number of the reference, from 0.
        index: u64,
        /// What is wrong with it.
        fault: TrainFault,
    },
    /// The rate multiplier passes less than one pulse a reference pulse: b must stay below 1 - 2^-19.
    CoefficientTooLarge {
        /// b as computed.
        b: f64,
        /// Reference pulses per metre from which on it is small enough.
        least_pulses_per_metre: f64,
    },
    /// A spur gear has no lead.
    SpurGear,
    /// Gear data that describe no gear.
    BadGear {
        /// Which.
        name: &'static str,
        /// Its value.
        value: f64,
        /// What is allowed.
        allowed: &'static str,
    },
    /// A ratio, a position or a sum beyond the limits of the accumulators.
    GearRange {
        /// Which.
        name: &'static str,
        /// Its value, saturated to 64 bits.
        value: i64,
    },
    /// A counter moved by half its range or more between two updates: the direction is not known.
    EncoderJump {
        /// Difference modulo the range, interpreted as signed.
        difference: i64,
        /// Bits of the counter.
        bits: u32,
    },
    /// A table that cannot be interpolated.
    BadTable {
        /// What is wrong.
        reason: TableFault,
    },
    /// The coupling is closed: ratio, table and sign cannot change now.
    Busy,
    /// The coupling is open: there is nothing to put in phase.
    NotEngaged,
}

/// What is wrong with a reference pulse.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TrainFault {
    /// Ticks have to rise strictly, from tick 1 on.
    Tick {
        /// As given.
        tick: u64,
        /// The least tick that would have been possible.
        least: u64,
    },
    /// A sign that is neither +1 nor -1.
    Sign {
        /// As given.
        sign: i64,
    },
}

/// What is wrong with a table.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum TableFault {
    /// Fewer than two knots.
    TooFewKnots {
        /// How many.
        knots: usize,
    },
    /// The knot distance is not positive.
    Spacing {
        /// As given.
        value: f64,
    },
    /// First and last value of a periodic table differ.
    NotPeriodic {
        /// y_0.
        first: f64,
        /// y_N.
        last: f64,
    },
    /// A value is NaN or infinite.
    NotFinite {
        /// Number of the knot, from 0.
        index: usize,
    },
    /// Storage for slopes of another length than the values.
    Storage {
        /// Values.
        values: usize,
        /// Room for slopes.
        slopes: usize,
    },
    /// Too little room to work in while solving for the slopes.
    Workspace {
        /// Numbers needed.
        needed: usize,
        /// Numbers given.
        given: usize,
    },
}

impl Error {
    /// The name of the kind, stable and in kebab case.
    pub const fn code(&self) -> &'static str {
        match self {
            Self::PulsesPerInterval { .. } | Self::CounterLimit { .. } => "bad-multiplier",
            Self::BadParameter { .. } => "bad-parameter",
            Self::BadReferenceTrain { .. } => "bad-reference-train",
            Self::CoefficientTooLarge { .. } => "coefficient-too-large",
            Self::SpurGear => "spur-gear",
            Self::BadGear { .. } => "bad-gear",
            Self::GearRange { .. } => "gear-range",
            Self::EncoderJump { .. } => "encoder-jump",
            Self::BadTable { .. } => "bad-table",
            Self::Busy => "busy",
            Self::NotEngaged => "not-engaged",
        }
    }

    /// What helps, in one sentence.
    pub const fn way_out(&self) -> &'static str {
        match self {
            Self::PulsesPerInterval { .. } => "choose between 2 and 256 pulses per reference interval",
            Self::CounterLimit { .. } => "choose a period counter of at least one count; 2^24 - 1 is usual",
            Self::BadParameter { .. } => "give a finite value within the range",
            Self::BadReferenceTrain { .. } => {
                "list reference pulses in the order of their ticks, from tick 1 on, with signs +1 or -1"
            }
            Self::CoefficientTooLarge { .. } => {
                "take a finer scale of the slide or fewer pulses per revolution of the workpiece"
            }
            Self::SpurGear => "a spur gear needs no additional rotation: leave the coupling to the feed out",
            Self::BadGear { .. } => "check the gear data against the drawing",
            Self::GearRange { .. } => "shorten the fraction, or take coarser counts",
            Self::EncoderJump { .. } => "read the counter more often or use a wider one",
            Self::BadTable { .. } => "give at least two finite values at equal positive distances",
            Self::Busy => "switch the coupling off first",
            Self::NotEngaged => "engage the coupling first",
        }
    }
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::PulsesPerInterval { value } => {
                write!(f, "{value} pulses per reference interval; allowed are 2 to 256")
            }
            Self::CounterLimit { value } => write!(f, "a period counter up to {value}; at least 1 is needed"),
            Self::BadParameter { name, value, allowed } | Self::BadGear { name, value, allowed } => {
                write!(f, "{name} = {value}; allowed: {allowed}")
            }
            Self::BadReferenceTrain { index, fault: TrainFault::Tick { tick, least } } => {
                write!(f, "reference pulse {index} at tick {tick}; it cannot be before tick {least}")
            }
            Self::BadReferenceTrain { index, fault: TrainFault::Sign { sign } } => {
                write!(f, "reference pulse {index} of sign {sign}; allowed: +1, -1")
            }
            Self::CoefficientTooLarge { b, least_pulses_per_metre } => write!(
                f,
                "coefficient b = {b}; it must be below 1 - 2^-19, which needs at least {least_pulses_per_metre} reference pulses per metre"
            ),
            Self::SpurGear => f.write_str("a spur gear has no lead"),
            Self::GearRange { name, value } => {
                write!(f, "{name} = {value} is beyond the range of the gearbox")
            }
            Self::EncoderJump { difference, bits } => write!(
                f,
                "a counter of {bits} bits moved by {difference} between two updates, half its range or more"
            ),
            Self::BadTable { reason } => match reason {
                TableFault::TooFewKnots { knots } => {
                    write!(f, "a table of {knots} knots; at least 2 are needed")
                }
                TableFault::Spacing { value } => {
                    write!(f, "knots at distances of {value}; allowed: above 0, finite")
                }
                TableFault::NotPeriodic { first, last } => {
                    write!(
                        f,
                        "a periodic table begins with {first} and ends with {last}; the two must be equal"
                    )
                }
                TableFault::NotFinite { index } => write!(f, "value {index} of the table is not finite"),
                TableFault::Storage { values, slopes } => {
                    write!(f, "room for {slopes} slopes at {values} values; the two must be equal")
                }
                TableFault::Workspace { needed, given } => {
                    write!(
                        f,
                        "room for {given} numbers to solve for the slopes; at least {needed} are needed"
                    )
                }
            },
            Self::Busy => f.write_str("ratio, table or sign cannot change while the coupling is closed"),
            Self::NotEngaged => f.write_str("the coupling is open"),
        }
    }
}

impl core::error::Error for Error {}
