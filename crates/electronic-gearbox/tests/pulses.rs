//! The pulse interpolator: the clocked machine against the event form, and the properties I1 to I6 of
//! `docs/mathematics/gearbox.md#pulses-between-lines`.

#[path = "common/draw.rs"]
mod draw;
#[path = "common/slide.rs"]
mod slide;

use electronic_gearbox::Error;
use electronic_gearbox::pulse::{
    ClockedInterpolator, Direction, EventInterpolator, Mode, Pulse, PulseKind, Settings, Status, TimedPulse,
};
use slide::Slide;

const MODES: [Mode; 3] = [Mode::OneWay, Mode::NoBacklash, Mode::Literal];

fn settings(p: u32, mode: Mode) -> Settings {
    Settings::new(p, Settings::COUNTER_LIMIT, mode).unwrap()
}

/// Every pulse of the clocked machine up to `last`.
fn clocked(settings: Settings, train: &[(u64, Direction)], last: u64) -> (Vec<TimedPulse>, Status) {
    let mut machine = ClockedInterpolator::new(settings);
    let mut next = train.iter().copied().peekable();
    let mut pulses = Vec::new();
    for tick in 1..=last {
        let reference = next.next_if(|(at, _)| *at == tick).map(|(_, direction)| direction);
        pulses.extend(machine.tick(reference).map(|pulse| TimedPulse { tick, pulse }));
    }
    (pulses, machine.status())
}

/// Every pulse of the event form; `stops` are ticks at which time is told to it in between.
fn events(
    settings: Settings,
    train: &[(u64, Direction)],
    last: u64,
    stops: impl Fn(u64) -> u64,
) -> (Vec<TimedPulse>, Status) {
    let mut machine = EventInterpolator::new(settings);
    let mut pulses = Vec::new();
    let mut now = 0;
    let mut pass = |machine: &mut EventInterpolator, to: u64, pulses: &mut Vec<TimedPulse>| {
        while now < to {
            now = (now + stops(now)).min(to);
            if let Some(next) = machine.next_tick() {
                assert!(next > machine.now());
                let before = pulses.len();
                machine.advance(now, |pulse| pulses.push(pulse));
                assert_eq!(pulses.len() > before, next <= now, "next_tick told the truth");
            } else {
                machine.advance(now, |pulse| panic!("{pulse:?} without announcement"));
            }
        }
    };
    for &(tick, direction) in train {
        pass(&mut machine, tick - 1, &mut pulses);
        machine.reference(tick, direction.sign(), |pulse| pulses.push(pulse)).unwrap();
        pass(&mut machine, tick, &mut pulses);
    }
    pass(&mut machine, last, &mut pulses);
    (pulses, machine.status())
}

#[test]
fn both_forms_send_the_same_pulses() {
    let mut trains = 0;
    for p in [2, 3, 4, 8, 16, 64, 256] {
        for mode in MODES {
            for start in 0..12 {
                // A third of the trains is faster than the machine can follow.
                let shortest = if start % 3 == 0 { 1 + u64::from(p) / 5 } else { u64::from(p) };
                let train: Vec<_> = Slide::new(start, shortest, 60 * u64::from(p)).take(200).collect();
                let last = train.last().unwrap().0 + 100 * u64::from(p);
                let settings = settings(p, mode);
                let machine = clocked(settings, &train, last);
                for stops in [|_| u64::MAX / 2, |now| 1 + now % 7, |now| 1 + now % 1009] {
                    assert_eq!(
                        events(settings, &train, last, stops),
                        machine,
                        "P {p} {mode:?} start {start}"
                    );
                }
                trains += 1;
            }
        }
    }
    assert_eq!(trains, 252);
}

#[test]
fn both_forms_saturate_at_standstill() {
    for mode in MODES {
        for limit in [1, 7, 255] {
            let settings = Settings::new(4, limit, mode).unwrap();
            let train = [
                (100, Direction::Forward),
                (140, Direction::Forward),
                (90_000, Direction::Forward),
                (91_000, Direction::Forward),
                (180_000, Direction::Backward),
            ];
            let (pulses, status) = clocked(settings, &train, 200_000);
            assert_eq!(events(settings, &train, 200_000, |_| 12_345), (pulses.clone(), status));
            assert_eq!(status.spacing, limit.min(22_250));
            assert!(pulses.len() >= 3 * 4);
        }
    }
}

/// Sums of a run as `docs/mathematics/gearbox.md#pulses-between-lines` names them.
#[derive(Default)]
struct Sums {
    pulses: i64,
    references: i64,
    least: i64,
    greatest: i64,
}

/// Runs the clocked machine and checks I1, I2 and I3 after every tick; gives the extremes of Q - P N - Q_0 and the state.
fn invariants(p: u32, mode: Mode, train: impl Iterator<Item = (u64, Direction)>) -> (Sums, Status) {
    let mut machine = ClockedInterpolator::new(settings(p, mode));
    let mut sums = Sums::default();
    let (mut now, p) = (0, i64::from(p));
    let mut first = None;
    for (tick, direction) in train {
        first.get_or_insert(direction);
        while now < tick {
            now += 1;
            let reference = (now == tick).then_some(direction);
            // I1: the machine can send one pulse a tick at most; the type says so.
            let sent: Option<Pulse> = machine.tick(reference);
            sums.pulses += sent.map_or(0, |pulse| pulse.direction.sign());
            sums.references += reference.map_or(0, Direction::sign);
            let status = machine.status();
            let Some(d) = status.direction else {
                assert_eq!(sent, None);
                continue;
            };
            let inserted = i64::from(status.inserted);
            assert!((0..p).contains(&inserted));
            let origin = match (mode, first) {
                (Mode::NoBacklash, Some(Direction::Backward)) => p - 1,
                _ => 0,
            };
            let expected = match mode {
                // I2
                Mode::OneWay => p * sums.references - d.sign() * (p - 1 - inserted),
                // I3
                Mode::NoBacklash if d == Direction::Forward => {
                    p * sums.references - (p - 1 - inserted) + origin
                }
                Mode::NoBacklash => p * sums.references - inserted + origin,
                Mode::Literal => continue,
            };
            assert_eq!(sums.pulses + status.pending, expected, "P {p} {mode:?} tick {now}");
            let off = sums.pulses - p * sums.references - origin;
            (sums.least, sums.greatest) = (sums.least.min(off), sums.greatest.max(off));
        }
    }
    (sums, machine.status())
}

#[test]
fn pulses_are_conserved_over_a_million_references() {
    let mut references = 0;
    for mode in [Mode::OneWay, Mode::NoBacklash] {
        for (p, most) in [(2, 40), (3, 30), (4, 20), (8, 16), (16, 10), (64, 6), (256, 4)] {
            for start in 0..6 {
                let count = 14_000;
                let train = Slide::new(1000 + start, u64::from(p), most * u64::from(p)).take(count);
                let (sums, status) = invariants(p, mode, train);
                references += status.references;
                // I4: no interval below P ticks.
                let bound = 2 * (i64::from(p) - 1);
                assert_eq!((status.overruns, status.too_fast), (0, 0));
                assert!(-bound <= sums.least && sums.greatest <= bound, "{mode:?} P {p}");
            }
        }
    }
    assert!(references >= 1_000_000, "{references}");
}

#[test]
fn the_bound_of_two_intervals_is_reached() {
    for p in [2u32, 4, 8, 16, 64] {
        let bound = 2 * (i64::from(p) - 1);
        let reached = (0..40).any(|start| {
            let train = Slide::new(start, u64::from(p), 4 * u64::from(p)).take(2000);
            let (sums, _) = invariants(p, Mode::OneWay, train);
            sums.greatest.max(-sums.least) == bound
        });
        assert!(reached, "P {p}");
    }
}

#[test]
fn a_slide_that_is_too_fast_is_counted_and_loses_nothing() {
    for mode in [Mode::OneWay, Mode::NoBacklash] {
        for p in [4, 16, 64] {
            // I6: I2 and I3 hold (checked in `invariants`), and the counters tell.
            let train = Slide::new(5, 1 + u64::from(p) / 6, 3 * u64::from(p)).take(5000);
            let (_, status) = invariants(p, mode, train);
            assert!(status.overruns > 0 && status.too_fast > 0, "{status:?}");
        }
    }
}

/// A slide that turns on a line passes it twice at once, at any speed: no alarm. One interval of one sense that is as short is one.
#[test]
fn a_slide_that_turns_on_a_line_alarms_nothing() {
    use Direction::{Backward, Forward};
    for mode in [Mode::OneWay, Mode::NoBacklash] {
        for pulses in [4u32, 16, 64] {
            let (p, slow) = (u64::from(pulses), settings(pulses, mode));
            let mut train = Vec::new();
            let mut tick = 100;
            for stroke in 0..40 {
                let direction = if stroke % 2 == 0 { Forward } else { Backward };
                train.extend((0..5).map(|line| (tick + 10 * p * line, direction)));
                tick += 40 * p + 1 + stroke % (p - 1);
            }
            let (_, status) = clocked(slow, &train, tick + 100 * p);
            assert_eq!((status.too_fast, status.overruns), (0, 0), "P {p} {mode:?} {status:?}");
            assert_eq!(status.short_reversals, 39, "P {p} {mode:?}");
            // Vibration about a line: every interval ends with the other sense.
            let dither: Vec<_> =
                (0..40).map(|k| (100 + 3 * k, if k % 2 == 0 { Forward } else { Backward })).collect();
            let (_, status) = clocked(slow, &dither, 1000 * p);
            assert_eq!((status.too_fast, status.overruns), (0, 0), "P {p} {mode:?} {status:?}");
            // The same train with one line passed too fast before the turn.
            train.insert(5, (train[4].0 + 1, Forward));
            train[6].0 = train[6].0.max(train[5].0 + 1);
            let (_, status) = clocked(slow, &train, tick + 100 * p);
            assert_eq!(status.too_fast, 1, "P {p} {mode:?} {status:?}");
        }
    }
}

#[test]
fn at_rest_every_reference_pulse_has_brought_its_pulses() {
    for p in [2, 5, 16, 256] {
        let train: Vec<_> = Slide::new(9, u64::from(p), 20 * u64::from(p)).take(999).collect();
        let last = train.last().unwrap().0 + 400 * u64::from(p);
        let (pulses, status) = clocked(settings(p, Mode::OneWay), &train, last);
        let sum: i64 = pulses.iter().map(|timed| timed.pulse.direction.sign()).sum();
        let references: i64 = train.iter().map(|(_, direction)| direction.sign()).sum();
        assert_eq!((status.pending, status.inserted), (0, p - 1));
        assert_eq!(sum, i64::from(p) * references);
    }
}

/// I5, seen from the pulses alone.
#[test]
fn an_interval_has_one_sense_and_p_pulses() {
    for p in [4u32, 16, 64] {
        let train: Vec<_> = Slide::new(77, u64::from(p), 12 * u64::from(p)).take(20_000).collect();
        let last = train.last().unwrap().0;
        let (pulses, _) = clocked(settings(p, Mode::OneWay), &train, last);
        let starts: Vec<usize> = (0..pulses.len())
            .filter(|&k| pulses[k].pulse.kind == PulseKind::Reference)
            .chain([pulses.len()])
            .collect();
        let mut checked = 0;
        for span in starts.windows(3) {
            let (own, next) = (&pulses[span[0]..span[1]], &pulses[span[1]..span[2]]);
            let direction = own[0].pulse.direction;
            let inserted = own.iter().filter(|timed| timed.pulse.kind == PulseKind::Intermediate);
            assert!(inserted.clone().all(|timed| timed.pulse.direction == direction));
            let burst: Vec<_> =
                next.iter().filter(|timed| timed.pulse.kind == PulseKind::Correction).collect();
            // The burst follows the reference pulse without a gap and has the sense of the interval that owes it.
            for (k, timed) in burst.iter().enumerate() {
                assert_eq!(timed.tick, next[0].tick + 1 + k as u64);
                assert_eq!(timed.pulse.direction, direction);
            }
            if next[0].pulse.direction == direction {
                assert_eq!(1 + inserted.count() + burst.len(), p as usize);
                checked += 1;
            }
        }
        assert!(checked > 15_000, "{checked}");
    }
}

#[test]
fn the_circuit_as_printed_loses_pulses_at_quick_reversals_only() {
    let run = |mode, turn: u64| {
        let mut train: Vec<_> = (1..=10).map(|k| (100 * k, Direction::Forward)).collect();
        train.extend((0..10).map(|k| (1000 + turn + 100 * k, Direction::Backward)));
        let (pulses, status) = clocked(settings(4, mode), &train, 5000);
        pulses.iter().map(|timed| timed.pulse.direction.sign()).sum::<i64>() + status.pending
    };
    assert_eq!(run(Mode::OneWay, 30), 0);
    assert_eq!(run(Mode::Literal, 200), 0);
    // 30 ticks after the last line one intermediate pulse of three has been sent; the two corrections run the wrong way.
    assert_eq!(run(Mode::Literal, 30), -4);
}

#[test]
fn bad_settings_and_trains_are_refused() {
    for p in [0, 1, 257, u32::MAX] {
        let error = Settings::new(p, 5, Mode::OneWay).unwrap_err();
        assert_eq!((error, error.code()), (Error::PulsesPerInterval { value: p }, "bad-multiplier"));
    }
    let error = Settings::new(16, 0, Mode::OneWay).unwrap_err();
    assert_eq!((error, error.code()), (Error::CounterLimit { value: 0 }, "bad-multiplier"));

    let mut machine = EventInterpolator::new(settings(16, Mode::OneWay));
    let mut sent = 0;
    for (tick, sign) in [(0, 1), (1, 0), (1, 2)] {
        let error = machine.reference(tick, sign, |_| sent += 1).unwrap_err();
        assert!(matches!(error, Error::BadReferenceTrain { index: 0, .. }), "{error}");
        assert_eq!(error.code(), "bad-reference-train");
    }
    assert_eq!(sent, 0);
    machine.reference(50, 1, |_| sent += 1).unwrap();
    machine.reference(200, -1, |_| sent += 1).unwrap();
    let before = (machine.status(), sent);
    for tick in [7, 200] {
        let error = machine.reference(tick, 1, |_| sent += 1).unwrap_err();
        assert!(error.to_string().contains("cannot be before tick 201"), "{error}");
    }
    machine.advance(17, |_| panic!("the past is gone"));
    assert_eq!((machine.status(), sent), before);
}
