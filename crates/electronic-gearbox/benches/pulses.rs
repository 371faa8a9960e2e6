//! Speed of the paths that count, on one core: clock ticks, pulses, updates of four axes, single pulses of a ratio.
//! Goals: 100 M ticks/s, 30 M pulses/s, 100 ns an update, 3 ns a pulse.

#[path = "../tests/common/draw.rs"]
mod draw;
#[path = "../tests/common/slide.rs"]
mod slide;

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use draw::Draw;
use electronic_gearbox::Sign;
use electronic_gearbox::chain::{AdditionalRotation, RateRule};
use electronic_gearbox::coupling::{Bresenham, Gearbox, IncrementalGearbox, LinearTerm, Ratio};
use electronic_gearbox::pulse::{
    ClockedInterpolator, Direction, EventInterpolator, Mode, Settings, TimedPulse,
};
use slide::Slide;
use std::hint::black_box;

fn train() -> Vec<(u64, Direction)> {
    Slide::new(1, 160, 400).take(2000).collect()
}

fn interpolator(c: &mut Criterion) {
    let train = train();
    let last = train.last().map_or(0, |(tick, _)| *tick);
    // The line of the scale as an input of the loop, tick by tick.
    let mut line = vec![None; last as usize + 1];
    train.iter().for_each(|(tick, direction)| line[*tick as usize] = Some(*direction));
    for (name, mode) in [("one-way", Mode::OneWay), ("no-backlash", Mode::NoBacklash)] {
        let settings = Settings::new(16, Settings::COUNTER_LIMIT, mode).unwrap();
        let mut group = c.benchmark_group(format!("interpolator {name}"));
        group.throughput(Throughput::Elements(last));
        group.bench_function("clocked, ticks", |b| {
            b.iter(|| {
                let mut machine = ClockedInterpolator::new(settings);
                let mut sum = 0;
                for reference in &line[1..] {
                    sum += machine.tick(*reference).map_or(0, |pulse| pulse.direction.sign());
                }
                sum
            })
        });
        let mut pulses = 0;
        let mut counted = EventInterpolator::new(settings);
        for (tick, direction) in &train {
            counted.reference(*tick, direction.sign(), |_| pulses += 1).unwrap();
        }
        group.throughput(Throughput::Elements(pulses));
        group.bench_function("events, pulses", |b| {
            b.iter(|| {
                let mut sum = 0;
                let mut machine = EventInterpolator::new(settings);
                for (tick, direction) in &train {
                    let sink = |timed: TimedPulse| {
                        sum += timed.tick as i64 * timed.pulse.direction.sign();
                    };
                    machine.reference(*tick, direction.sign(), sink).unwrap();
                }
                sum
            })
        });
        group.finish();
    }
}

fn multipliers(c: &mut Criterion) {
    let lines: Vec<Direction> = Slide::new(4, 2, 9).take(10_000).map(|(_, direction)| direction).collect();
    let mut group = c.benchmark_group("additional rotation");
    group.throughput(Throughput::Elements(lines.len() as u64));
    for (name, rule) in [("binary", RateRule::Binary), ("bresenham", RateRule::Bresenham)] {
        let mut chain = AdditionalRotation::new(123_456, rule, Sign::Plus, 16).unwrap();
        group.bench_function(name, |b| {
            b.iter(|| {
                for direction in &lines {
                    black_box(chain.pulse(*direction));
                }
                chain.total()
            })
        });
    }
    group.finish();
}

fn coupling(c: &mut Criterion) {
    let ratio = |n, d| LinearTerm::new(Ratio::new(n, d).unwrap(), 0);
    // Tool, feed by a dyadic lead, shift, a second spindle.
    let terms = [
        ratio(108_000, 327_680),
        ratio(1_129_650_402_061_102_241, 1 << 61),
        ratio(-467_057, 953_357),
        ratio(7, 30),
    ];
    let gearbox = Gearbox::new(0, terms);
    let mut draw = Draw::new(2);
    let steps: Vec<[i64; 4]> =
        (0..1000).map(|_| [0, 1, 2, 3].map(|k| (draw.bits() % 4001) as i64 - 1500 - 100 * k)).collect();
    let mut group = c.benchmark_group("four axes");
    group.throughput(Throughput::Elements(steps.len() as u64));
    group.bench_function("from positions", |b| {
        b.iter(|| {
            let (mut x, mut sum) = ([0i64; 4], 0i64);
            for step in &steps {
                x.iter_mut().zip(step).for_each(|(x, dx)| *x += dx);
                sum = sum.wrapping_add(gearbox.position(&x).unwrap().counts);
            }
            sum
        })
    });
    let mut running = IncrementalGearbox::new(gearbox, &[0; 4]).unwrap();
    group.bench_function("from increments", |b| {
        b.iter(|| {
            for step in &steps {
                running.advance(step).unwrap();
                black_box(running.position().unwrap());
            }
        })
    });
    group.finish();

    let lines: Vec<Direction> = Slide::new(6, 2, 9).take(10_000).map(|(_, direction)| direction).collect();
    let mut group = c.benchmark_group("single pulse");
    group.throughput(Throughput::Elements(lines.len() as u64));
    let start = Bresenham::new(Ratio::new(108_000, 327_680).unwrap()).unwrap();
    group.bench_function("bresenham", |b| {
        b.iter(|| {
            let mut line = start;
            // Counted without a branch: a mispredicted one of the counting would take a third of the time.
            let counted = |pulse| {
                i64::from(pulse == Some(Direction::Forward)) - i64::from(pulse == Some(Direction::Backward))
            };
            lines.iter().map(|direction| counted(line.pulse(*direction))).sum::<i64>()
        })
    });
    group.finish();
}

criterion_group!(benches, interpolator, multipliers, coupling);
criterion_main!(benches);
