//! How an interpolator is set: checked once, constant from then on.

use crate::Error;

/// How the corrections of an ended interval are counted and on which line they run (`docs/mathematics/gearbox.md#pulses-between-lines`).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Mode {
    /// Every reference pulse brings exactly P pulses of its own sense. After a reversal the pulse position differs from the forward
    /// one by P - 1 pulses at the same place of the slide: for grinding in one direction.
    OneWay,
    /// At a reversal the inserted pulses are taken back: both directions give the same position. The recommended mode.
    #[default]
    NoBacklash,
    /// The circuit as printed in its source: corrections run on the line of the last reference pulse. Loses pulses at quick reversals;
    /// only to show that effect, never for a machine.
    Literal,
}

/// Settings of an interpolator.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Settings {
    pulses_per_interval: u32,
    counter_limit: u32,
    mode: Mode,
}

impl Settings {
    /// Largest content of a period counter of 24 bits.
    pub const COUNTER_LIMIT: u32 = (1 << 24) - 1;

    /// P pulses per interval, the reference pulse included, a period counter that saturates at `counter_limit`, and the mode.
    ///
    /// # Errors
    /// [`Error::PulsesPerInterval`] for P outside 2..=256, [`Error::CounterLimit`] for a limit of 0.
    pub const fn new(pulses_per_interval: u32, counter_limit: u32, mode: Mode) -> Result<Self, Error> {
        if pulses_per_interval < 2 || pulses_per_interval > 256 {
            return Err(Error::PulsesPerInterval { value: pulses_per_interval });
        }
        if counter_limit == 0 {
            return Err(Error::CounterLimit { value: counter_limit });
        }
        Ok(Self { pulses_per_interval, counter_limit, mode })
    }

    /// P.
    #[inline]
    pub const fn pulses_per_interval(&self) -> u32 {
        self.pulses_per_interval
    }

    /// C_max.
    #[inline]
    pub const fn counter_limit(&self) -> u32 {
        self.counter_limit
    }

    /// The mode.
    #[inline]
    pub const fn mode(&self) -> Mode {
        self.mode
    }
}
