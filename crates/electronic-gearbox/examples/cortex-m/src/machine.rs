//! A machine for the firmware to run: counters of a worm spindle and of a feed slide as hardware would show them, limited in width. On a
//! board, [`Machine::read`] reads two registers of timers in quadrature mode.

/// Cycles of the loop a second.
pub const CYCLES_PER_SECOND: u32 = 10_000;

/// Counts of the worm a cycle, in 1/100: 3000 1/min of 4096 counts are 20.48 a cycle.
const WORM_COUNTS_PER_100: u64 = 2048;

/// What the timers show.
pub struct Counters {
    /// Encoder of the worm, 16 bits.
    pub worm: u16,
    /// Scale of the feed slide, 24 bits.
    pub feed: u32,
}

/// Both axes in motion.
pub struct Machine {
    cycle: u64,
}

impl Machine {
    /// Both at 0.
    pub const fn new() -> Self {
        Self { cycle: 0 }
    }

    /// The counters a cycle later.
    pub fn read(&mut self) -> Counters {
        self.cycle += 1;
        // Cut to the width of the timers on purpose.
        Counters { worm: worm(self.cycle) as u16, feed: feed(self.cycle) as u32 & 0xff_ffff }
    }

    /// Cycles so far.
    pub fn cycle(&self) -> u64 {
        self.cycle
    }
}

/// Counts of the worm in all, after a cycle.
pub fn worm(cycle: u64) -> u64 {
    cycle * WORM_COUNTS_PER_100 / 100
}

/// Counts of the slide in all: 1 um each, forward for 5000 cycles and back again, at 2 counts a cycle.
pub fn feed(cycle: u64) -> i64 {
    let place = cycle % 10_000;
    2 * if place < 5000 { place as i64 } else { 10_000 - place as i64 }
}
