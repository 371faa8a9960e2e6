//! Instructions of one update, counted by Callgrind: the same on every machine, so that a regression shows without a stop-watch. Each
//! path runs on inputs that differ in everything that could matter; the count of one update is constant where the group says so.
//! `scripts/instruction-counts` gets what is needed and runs it; a count above its limit ends the run with an error.

// The macros make modules that cannot carry documentation.
#![allow(missing_docs)]

use electronic_gearbox::Sign;
use electronic_gearbox::chain::{AdditionalRotation, RateRule};
use electronic_gearbox::coupling::{
    Bresenham, Gearbox, GearboxPosition, IncrementalGearbox, LinearTerm, Ratio,
};
use electronic_gearbox::pulse::{ClockedInterpolator, Direction, Mode, Pulse, Settings};
use gungraun::prelude::*;
use gungraun::{Callgrind, EventKind};
use std::hint::black_box;

/// A benchmark that fails beyond this many instructions.
fn at_most(instructions: u64) -> LibraryBenchmarkConfig {
    let mut config = LibraryBenchmarkConfig::default();
    config.tool(Callgrind::default().hard_limits([(EventKind::Ir, instructions)]));
    config
}

fn term(n: i64, d: i64) -> LinearTerm {
    LinearTerm::new(Ratio::new(n, d).unwrap(), 0)
}

fn four_axes() -> Gearbox<4> {
    Gearbox::new(
        0,
        [
            term(108_000, 327_680),
            term(1_129_650_402_061_102_241, 1 << 61),
            term(-467_057, 953_357),
            term((1 << 62) - 1, (1 << 62) - 3),
        ],
    )
}

/// At rest, in the middle, at both ends of the range of the positions.
const PLACES: [[i64; 4]; 4] = [
    [0; 4],
    [12_345, -678_901, 23_456_789, 1],
    [i64::MIN / 4; 4],
    [i64::MAX / 4, 5, i64::MIN / 8, i64::MAX / 4],
];

#[library_benchmark(config = at_most(450))]
#[bench::rest(four_axes(), PLACES[0])]
#[bench::middle(four_axes(), PLACES[1])]
#[bench::least(four_axes(), PLACES[2])]
#[bench::greatest(four_axes(), PLACES[3])]
fn position_of_four_axes(gearbox: Gearbox<4>, at: [i64; 4]) -> Option<GearboxPosition> {
    black_box(&gearbox).position(black_box(&at)).ok()
}

fn running() -> IncrementalGearbox<4> {
    IncrementalGearbox::new(four_axes(), &[0; 4]).unwrap()
}

#[library_benchmark(config = at_most(400))]
#[bench::rest(running(), PLACES[0])]
#[bench::middle(running(), PLACES[1])]
#[bench::least(running(), PLACES[2])]
fn advance_of_four_axes(mut gearbox: IncrementalGearbox<4>, by: [i64; 4]) -> Option<GearboxPosition> {
    black_box(&mut gearbox).advance(black_box(&by)).ok()?;
    gearbox.position().ok()
}

/// An interpolator in the middle of an interval, with or without corrections owed.
fn interpolator(owed: bool) -> ClockedInterpolator {
    let settings = Settings::new(16, Settings::COUNTER_LIMIT, Mode::NoBacklash).unwrap();
    let mut machine = ClockedInterpolator::new(settings);
    let references: &[u64] = if owed { &[160, 320, 400] } else { &[160, 320] };
    for tick in 1..=references[references.len() - 1] {
        machine.tick(references.contains(&tick).then_some(Direction::Forward));
    }
    machine
}

#[library_benchmark(config = at_most(75))]
#[bench::quiet(interpolator(false), None)]
#[bench::correction(interpolator(true), None)]
#[bench::reference(interpolator(false), Some(Direction::Forward))]
#[bench::reversal(interpolator(true), Some(Direction::Backward))]
fn tick(mut machine: ClockedInterpolator, reference: Option<Direction>) -> Option<Pulse> {
    black_box(&mut machine).tick(black_box(reference))
}

#[library_benchmark(config = at_most(64))]
#[bench::stays(Direction::Forward)]
#[bench::carries(Direction::Backward)]
fn pulse_of_a_ratio(direction: Direction) -> Option<Direction> {
    let mut line = Bresenham::new(black_box(Ratio::new(108_000, 327_680).unwrap())).unwrap();
    black_box(&mut line).pulse(black_box(direction))
}

#[library_benchmark(config = at_most(40))]
#[bench::forward(RateRule::Bresenham, Direction::Forward)]
#[bench::backward(RateRule::Binary, Direction::Backward)]
fn pulse_of_the_chain(rule: RateRule, direction: Direction) -> Option<Direction> {
    let mut chain = AdditionalRotation::new(123_456, rule, Sign::Minus, 16).unwrap();
    black_box(&mut chain).pulse(black_box(direction))
}

library_benchmark_group!(name = gearbox, benchmarks = [position_of_four_axes, advance_of_four_axes]);
library_benchmark_group!(name = pulses, benchmarks = [tick, pulse_of_a_ratio, pulse_of_the_chain]);

main!(library_benchmark_groups = [gearbox, pulses]);
