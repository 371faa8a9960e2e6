//! Runs every part of the gearbox in a loop as firmware would, without std, without an allocator, without a C library. Inputs are opaque to
//! the compiler. The panic handler stays out of the linked program if nothing can panic; the test looks for it.

#![no_std]
#![no_main]

use core::hint::black_box;
use core::panic::PanicInfo;
use electronic_gearbox::chain::{AdditionalRotation, RateRule, SharedRotation};
use electronic_gearbox::coupling::{
    Bresenham, CubicTable, EndRule, Engagement, EngagementSettings, Gearbox, IncrementalGearbox, LinearTerm,
    Motion, PolynomialCoupling, Ratio, WrappingCounter,
};
use electronic_gearbox::pulse::{ClockedInterpolator, Direction, EventInterpolator, Mode, Settings};
use electronic_gearbox::{Error, Sign};

static SHARED: SharedRotation = SharedRotation::new();

/// One of everything, and a cycle of the loop.
fn run() -> Result<i64, Error> {
    let settings =
        Settings::new(black_box(16), black_box(Settings::COUNTER_LIMIT), black_box(Mode::NoBacklash))?;
    let mut clocked = ClockedInterpolator::new(settings);
    let mut events = EventInterpolator::new(settings);
    let mut rotation =
        AdditionalRotation::new(black_box(123_456), black_box(RateRule::Binary), black_box(Sign::Minus), 16)?;
    let ratio = Ratio::new(black_box(108_000), black_box(327_680))?;
    let mut line = Bresenham::new(ratio)?;
    let terms = [LinearTerm::new(ratio, black_box(0)), LinearTerm::new(ratio, black_box(7))];
    let mut gearbox = Gearbox::new(black_box(5), terms);
    gearbox.engage(&[black_box(0), black_box(0)], black_box(100))?;
    let mut running = IncrementalGearbox::new(gearbox, &[0, 0])?;
    let mut counter = WrappingCounter::new(black_box(24), black_box(0))?;
    let values = black_box([0.0, 1.0, 0.5, -0.5, 0.0]);
    let slopes = black_box([0.3, 0.1, -0.4, 0.1, 0.2]);
    let table = CubicTable::new(black_box(-10.0), black_box(5.0), &values, &slopes, EndRule::Natural)?;
    let polynomial = PolynomialCoupling::new(&black_box([0.1, 0.2, -0.3]))?;
    let mut engagement = Engagement::new(EngagementSettings {
        phase_speed: black_box(10.0),
        acceleration: black_box(100.0),
        fine_window: black_box(0.1),
        coarse_window: black_box(1.0),
        fault_time: black_box(0.5),
        standstill_speed: black_box(1e-3),
    })?;
    let rest = Motion { position: 0.0, speed: black_box(0.0), acceleration: 0.0 };
    engagement.engage(rest)?;

    let mut sum = 0i64;
    for tick in 1..black_box(1000u64) {
        let reference = black_box((tick % 200 == 0).then_some(Direction::Forward));
        let mut turn = |direction: Direction| sum += rotation.pulse(direction).map_or(0, Direction::sign);
        if let Some(pulse) = clocked.tick(reference) {
            turn(pulse.direction);
            line.pulse(pulse.direction);
        }
        match reference {
            Some(direction) => {
                events.reference(tick, direction.sign(), |timed| turn(timed.pulse.direction))?
            }
            None => events.advance(tick, |timed| turn(timed.pulse.direction)),
        }
        SHARED.publish(rotation.position());
        sum = sum.wrapping_add(SHARED.read(sum).coarse);
        let way = counter.read(black_box(tick * 3))?;
        running.advance(&[way, black_box(-1)])?;
        sum =
            sum.wrapping_add(running.position()?.counts).wrapping_add(gearbox.position(&[way, sum])?.counts);
        let x = black_box(0.01) * tick as f64;
        sum = sum.wrapping_add(table.counts(x)?).wrapping_add(polynomial.counts(x)?);
        let output = engagement.update(black_box(1e-3), rest, black_box(0.0))?;
        sum = sum.wrapping_add(i64::from(output.stop_leading_axes));
        sum = sum.wrapping_add(clocked.status().pending).wrapping_add(events.status().pending);
    }
    Ok(sum)
}

/// Entry of the program; it never returns, as firmware does not.
// Reason for the attribute: the linker looks for this name, and no other item has it. The test links it.
#[unsafe(no_mangle)]
pub extern "C" fn _start() -> ! {
    loop {
        let _ = black_box(run());
    }
}

#[panic_handler]
fn gearbox_panicked(_: &PanicInfo<'_>) -> ! {
    loop {}
}
