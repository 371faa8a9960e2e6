//! A loop of 10 kHz as a board runs it: read the counters, sum the leading axes exactly, publish the setpoint of the workpiece spindle.
//!
//! `cargo run --release` in this folder builds it for a Cortex-M4 and runs it in QEMU. It ends with status 0 if every setpoint was the
//! exact one.

#![no_std]
#![no_main]

mod machine;

use core::sync::atomic::{AtomicU32, Ordering};
use cortex_m::peripheral::syst::SystClkSource;
use cortex_m_rt::{entry, exception};
use cortex_m_semihosting::{debug, hprintln};
use electronic_gearbox::Error;
use electronic_gearbox::chain::{SharedRotation, SplitRotation};
use electronic_gearbox::coefficient::{CouplingSigns, Couplings, GearGeometry};
use electronic_gearbox::coupling::{
    Gearbox, GearboxPosition, IncrementalGearbox, LinearTerm, WrappingCounter, dyadic, endless_ratio,
};
use machine::{CYCLES_PER_SECOND, Machine};
use panic_halt as _;

/// Clock of the processor, Hz.
const CLOCK: u32 = 25_000_000;
/// Parts into which the setpoint divides a count of the workpiece.
const PARTS: i64 = 16;
/// Counts of a revolution.
const WORM_COUNTS: i64 = 4096;
const WORKPIECE_COUNTS: i64 = 36_000;
const CYCLES: u32 = 20_000;

/// What the interrupt tells the rest of the program.
static SETPOINT: SharedRotation = SharedRotation::new();
static DONE: AtomicU32 = AtomicU32::new(0);
static WRONG: AtomicU32 = AtomicU32::new(0);

/// The part of the firmware that runs in the interrupt.
struct Loop {
    machine: Machine,
    worm: WrappingCounter,
    feed: WrappingCounter,
    gearbox: IncrementalGearbox<2>,
}

impl Loop {
    /// A worm of 3 threads leads a gear of 40 teeth, module 2.5, helix angle 20 degrees; the feed adds its share of a turn a lead.
    fn new() -> Result<Self, Error> {
        let gear = GearGeometry::new(2.5, 40, 20f64.to_radians(), 20f64.to_radians())?;
        let couplings = Couplings::new(&gear, 3, 87f64.to_radians(), CouplingSigns::default())?;
        // Rotations without end: an exact fraction. Internal parts of a count keep the setpoint smooth.
        let worm = endless_ratio(-3, WORKPIECE_COUNTS * PARTS, 40, WORM_COUNTS)?;
        // A lead is irrational: the next fraction over a power of two, for a slide of finite travel. Degrees a mm to parts a um.
        let parts_per_micrometre = couplings.feed / 360.0 * (WORKPIECE_COUNTS * PARTS) as f64 / 1000.0;
        let feed = dyadic(parts_per_micrometre)?.ratio();
        let gearbox = Gearbox::new(0, [LinearTerm::new(worm, 0), LinearTerm::new(feed, 0)]);
        Ok(Self {
            machine: Machine::new(),
            worm: WrappingCounter::new(16, 0)?,
            feed: WrappingCounter::new(24, 0)?,
            gearbox: IncrementalGearbox::new(gearbox, &[0, 0])?,
        })
    }

    /// One cycle.
    fn run(&mut self) -> Result<GearboxPosition, Error> {
        let counters = self.machine.read();
        let ways = [self.worm.read(counters.worm.into())?, self.feed.read(counters.feed.into())?];
        self.gearbox.advance(&ways)?;
        let position = self.gearbox.position()?;
        let (coarse, fine) = (position.counts.div_euclid(PARTS), position.counts.rem_euclid(PARTS));
        SETPOINT.publish(SplitRotation { coarse, fine: fine as u32 });
        Ok(position)
    }

    /// The same position from the counts in all, without increments and without counters that wrap.
    fn expected(&self) -> Result<GearboxPosition, Error> {
        let cycle = self.machine.cycle();
        self.gearbox.gearbox().position(&[machine::worm(cycle) as i64, machine::feed(cycle)])
    }
}

#[exception]
fn SysTick() {
    static mut LOOP: Option<Loop> = None;
    if DONE.load(Ordering::Relaxed) >= CYCLES {
        return;
    }
    let right = match LOOP {
        Some(running) => running.run().is_ok_and(|position| running.expected() == Ok(position)),
        None => match Loop::new() {
            Ok(new) => {
                *LOOP = Some(new);
                return;
            }
            Err(_) => false,
        },
    };
    if !right {
        WRONG.store(WRONG.load(Ordering::Relaxed) + 1, Ordering::Relaxed);
    }
    DONE.store(DONE.load(Ordering::Relaxed) + 1, Ordering::Release);
}

#[entry]
fn main() -> ! {
    let status = match firmware() {
        Ok(0) => debug::EXIT_SUCCESS,
        Ok(wrong) => {
            hprintln!("{} setpoints were wrong", wrong);
            debug::EXIT_FAILURE
        }
        Err(error) => {
            hprintln!("{}: {}", error, error.way_out());
            debug::EXIT_FAILURE
        }
    };
    loop {
        debug::exit(status);
    }
}

/// Measures a cycle, then lets the interrupt run; how many setpoints were wrong.
fn firmware() -> Result<u32, Error> {
    let Some(mut board) = cortex_m::Peripherals::take() else { return Ok(u32::MAX) };
    let timer = &mut board.SYST;
    timer.set_clock_source(SystClkSource::Core);

    const MEASURED: u32 = 1000;
    let mut cycles = Loop::new()?;
    timer.set_reload(0xff_ffff);
    timer.clear_current();
    timer.enable_counter();
    for _ in 0..MEASURED {
        cycles.run()?;
    }
    let ticks = 0xff_ffff - cortex_m::peripheral::SYST::get_current();
    hprintln!("{} ticks of the processor's clock for {} cycles of the loop", ticks, MEASURED);

    timer.set_reload(CLOCK / CYCLES_PER_SECOND - 1);
    timer.clear_current();
    timer.enable_interrupt();
    let mut seen = SplitRotation::default();
    while DONE.load(Ordering::Acquire) < CYCLES {
        cortex_m::asm::wfi();
        // Half a word is never seen: both are one word of 32 bits.
        seen = SETPOINT.read(seen.coarse);
    }
    timer.disable_interrupt();
    hprintln!("after {} cycles: {} counts and {}/{}", CYCLES, seen.coarse, seen.fine, PARTS);
    Ok(WRONG.load(Ordering::Relaxed))
}
