//! Whole engagements with leading axes that run: what the follower does, step by step.

extern crate std;

use std::vec::Vec;

use proptest::prelude::*;

use super::profile::{PEAK_ACCELERATION, PEAK_SPEED};
use super::{
    Engagement, EngagementOutput, EngagementSettings, EngagementState, FollowingWindow, Motion, shortest_move,
};
use crate::Error;

/// Degrees, seconds.
const SETTINGS: EngagementSettings = EngagementSettings {
    phase_speed: 40.0,
    acceleration: 2000.0,
    fine_window: 0.001,
    coarse_window: 0.01,
    fault_time: 0.005,
    standstill_speed: 0.01,
};

const CYCLE: f64 = 1e-3;

/// Speed v + a sin(w t) of the coupling, from a place far away from 0.
#[derive(Clone, Copy, Debug)]
struct Leading {
    start: f64,
    speed: f64,
    swing: f64,
    frequency: f64,
}

impl Leading {
    const fn steady(speed: f64) -> Self {
        Self { start: 4321.7, speed, swing: 0.0, frequency: 1.0 }
    }

    fn at(&self, time: f64) -> Motion {
        let phase = self.frequency * time;
        Motion {
            position: self.start
                + self.speed * time
                + self.swing / self.frequency * 2.0 * (phase / 2.0).sin().powi(2),
            speed: self.speed + self.swing * phase.sin(),
            acceleration: self.swing * self.frequency * phase.cos(),
        }
    }

    fn greatest_acceleration(&self) -> f64 {
        (self.swing * self.frequency).abs()
    }
}

/// A follower at rest at `follower`, its coupling engaged at time 0.
struct Run {
    engagement: Engagement,
    leading: Leading,
    zero: f64,
    cycles: u32,
    /// Setpoints with their rates, from time 0 on.
    setpoints: Vec<Motion>,
}

impl Run {
    fn engage(leading: Leading, follower: f64) -> Self {
        let mut engagement = Engagement::new(SETTINGS).unwrap();
        engagement.engage(leading.at(0.0)).unwrap();
        let rest = Motion { position: follower, ..Motion::default() };
        Self { engagement, leading, zero: follower - leading.start, cycles: 0, setpoints: Vec::from([rest]) }
    }

    fn time(&self) -> f64 {
        f64::from(self.cycles) * CYCLE
    }

    fn last(&self) -> Motion {
        *self.setpoints.last().unwrap()
    }

    fn cycle_with(&mut self, following_error: f64) -> EngagementOutput {
        self.cycles += 1;
        let coupled = self.leading.at(self.time());
        let output = self.engagement.update(CYCLE, coupled, following_error).unwrap();
        if let Some(offset) = output.offset {
            self.setpoints.push(Motion {
                position: self.zero + coupled.position + offset.position,
                speed: coupled.speed + offset.speed,
                acceleration: coupled.acceleration + offset.acceleration,
            });
        }
        output
    }

    fn cycle(&mut self) -> EngagementOutput {
        self.cycle_with(0.0)
    }

    fn until(&mut self, state: EngagementState) {
        for _ in 0..20_000 {
            if self.cycle().state == state {
                return;
            }
        }
        panic!("never {state:?}: {:?}", self.engagement);
    }

    /// Positions, speeds and accelerations belong together, and the accelerations keep the limit, by differences of the setpoints as well
    /// as by their own account. The motion of the leading axes comes on top.
    fn check_limits(&self) {
        let limit = SETTINGS.acceleration + self.leading.greatest_acceleration();
        for pair in self.setpoints.windows(2) {
            let [before, after] = [pair[0], pair[1]];
            // A trapezium errs by a quarter of the acceleration at most. The rest is rounding of positions of several thousand degrees.
            let way = (before.speed + after.speed) / 2.0 * CYCLE;
            let error = (after.position - before.position - way).abs();
            assert!(error <= limit * CYCLE * CYCLE / 4.0 + 1e-10, "{pair:?}");
            assert!((after.speed - before.speed).abs() <= limit * CYCLE * (1.0 + 1e-9), "{pair:?}");
            assert!(after.acceleration.abs() <= limit * (1.0 + 1e-9), "{pair:?}");
        }
        for three in self.setpoints.windows(3) {
            let second = three[2].position - 2.0 * three[1].position + three[0].position;
            assert!(second.abs() / (CYCLE * CYCLE) <= limit * (1.0 + 1e-5) + 1e-4, "{three:?}");
        }
    }

    fn phase_error(&self, target: f64, pitch: f64) -> f64 {
        shortest_move(self.last().position, target, pitch).unwrap()
    }
}

#[test]
fn a_steady_speed_is_taken_up_along_the_closed_way() {
    let speed = -1350.0;
    let whole = PEAK_SPEED * f64::abs(speed) / SETTINGS.acceleration;
    let mut run = Run::engage(Leading::steady(speed), 12.5);
    while run.engagement.state() == EngagementState::Ramping {
        run.cycle();
        let u = (run.time() / whole).min(1.0);
        let integral = u.powi(4) * (2.5 - 3.0 * u + u * u);
        let way = speed * (whole * integral + (run.time() - whole).max(0.0));
        assert!((run.last().position - 12.5 - way).abs() < 1e-9, "{u}: {:?}", run.last());
    }
    assert!((run.time() - whole).abs() <= CYCLE);
    assert_eq!(run.last().speed, speed);
    run.check_limits();
    // No jerk at either end: the accelerations of neighbouring cycles differ by no more than S'' allows.
    let jerk = PEAK_ACCELERATION * f64::abs(speed) / (whole * whole);
    for pair in run.setpoints.windows(2) {
        assert!(
            (pair[1].acceleration - pair[0].acceleration).abs() <= jerk * CYCLE * (1.0 + 1e-9),
            "{pair:?}"
        );
    }
}

#[test]
fn the_follower_waits_in_step_until_it_has_a_target() {
    let mut run = Run::engage(Leading::steady(300.0), 0.0);
    assert!(!run.engagement.awaits_target());
    run.until(EngagementState::Synchronising);
    assert!(run.engagement.awaits_target());
    let offset = run.cycle().offset;
    for _ in 0..100 {
        let output = run.cycle();
        assert_eq!((output.state, output.offset), (EngagementState::Synchronising, offset));
    }
    run.engagement.synchronise(run.last().position, run.last().position + 1.0, 9.0).unwrap();
    assert!(!run.engagement.awaits_target());
    run.until(EngagementState::Coupled);
    run.check_limits();
}

#[test]
fn a_target_named_during_the_ramp_is_reached_after_it() {
    let leading = Leading { swing: 200.0, frequency: 20.0, ..Leading::steady(600.0) };
    let mut run = Run::engage(leading, -77.7);
    for _ in 0..50 {
        run.cycle();
    }
    // The gap is at 3 degrees now and turns with the coupling.
    let gap = 3.0 - leading.at(run.time()).position;
    run.engagement.synchronise(run.last().position, 3.0, 9.0).unwrap();
    run.until(EngagementState::Coupled);
    assert!(run.phase_error(gap + leading.at(run.time()).position, 9.0).abs() < 1e-9);
    run.check_limits();
}

#[test]
fn leading_axes_that_speed_up_during_the_ramp_stretch_it() {
    // From 100 to 1100 degrees a second within the first tenth of a second.
    let leading =
        Leading { swing: 1000.0, frequency: core::f64::consts::FRAC_PI_2 / 0.1, ..Leading::steady(100.0) };
    let mut run = Run::engage(leading, 0.0);
    run.until(EngagementState::Synchronising);
    assert!(run.time() > PEAK_SPEED * 500.0 / SETTINGS.acceleration, "{}", run.time());
    run.check_limits();
}

#[test]
fn standing_axes_are_coupled_at_once() {
    let mut run = Run::engage(Leading::steady(0.0), 5.0);
    assert_eq!(run.cycle().state, EngagementState::Synchronising);
    assert_eq!(run.last().position, 5.0);
    // Already in the gap: no move.
    run.engagement.synchronise(5.0, 23.0, 9.0).unwrap();
    assert_eq!(run.cycle().state, EngagementState::Coupled);
    assert_eq!(run.last().position, 5.0);
}

#[test]
fn a_coupling_in_counts_does_not_drift() {
    // Worm of 3 starts with 8192 counts, workpiece of 40 teeth with 36000 counts: 675/2048 counts a count, pitch 900 counts.
    let sum = |counts: i64| {
        let product = 675 * i128::from(counts);
        (product.div_euclid(2048) as i64, product.rem_euclid(2048) as f64 / 2048.0)
    };
    let settings = EngagementSettings {
        phase_speed: 4000.0,
        acceleration: 200_000.0,
        fine_window: 1.0,
        coarse_window: 5.0,
        ..SETTINGS
    };
    let mut engagement = Engagement::new(settings).unwrap();
    // 409600 counts a second, 410 counts in a cycle, after a long time of running.
    let per_cycle = 410;
    let motion = |counts: i64| Motion {
        position: sum(counts).0 as f64 + sum(counts).1,
        speed: per_cycle as f64 / CYCLE * 675.0 / 2048.0,
        acceleration: 0.0,
    };
    let start = 123_456_789_012;
    let follower = 1000;
    let zero = follower - sum(start).0;
    engagement.engage(motion(start)).unwrap();
    let mut counts = start;
    let mut cycle = |engagement: &mut Engagement, moved: i64| {
        counts += moved;
        let output = engagement.update(CYCLE, motion(counts), 0.0).unwrap();
        (output, counts)
    };
    while !engagement.awaits_target() {
        cycle(&mut engagement, per_cycle);
    }
    let (output, now) = cycle(&mut engagement, per_cycle);
    let setpoint = |output: EngagementOutput, counts: i64| {
        let (whole, rest) = sum(counts);
        ((zero + whole).rem_euclid(900) as f64 + rest + output.offset.unwrap().position).rem_euclid(900.0)
    };
    let wanted = 222.25;
    // Where the gap stands while the worm is at its zero; it turns with the coupling.
    let gap = |counts: i64| (wanted + sum(counts).0.rem_euclid(900) as f64 + sum(counts).1).rem_euclid(900.0);
    engagement.synchronise(setpoint(output, now), gap(now), 900.0).unwrap();
    while engagement.state() != EngagementState::Coupled {
        cycle(&mut engagement, per_cycle);
    }
    let (first, now) = cycle(&mut engagement, per_cycle);
    assert!(shortest_move(setpoint(first, now), gap(now), 900.0).unwrap().abs() < 1e-9);
    // A year of eight-hour days at that speed, in strides.
    for _ in 0..10_000 {
        let (later, now) = cycle(&mut engagement, 431_234_567);
        assert_eq!(later.offset, first.offset);
        assert!(shortest_move(setpoint(later, now), gap(now), 900.0).unwrap().abs() < 1e-9);
    }
}

#[test]
fn windows_are_told_and_a_lasting_error_stops_the_leading_axes() {
    let mut run = Run::engage(Leading::steady(0.0), 0.0);
    run.cycle();
    run.engagement.synchronise(0.0, 0.0, 9.0).unwrap();
    run.until(EngagementState::Coupled);
    assert_eq!(run.cycle_with(-0.001).window, Some(FollowingWindow::Fine));
    assert_eq!(run.cycle_with(0.01).window, Some(FollowingWindow::Coarse));
    // Four cycles outside are not yet five, and one inside begins anew.
    for error in [0.02, -0.02, f64::NAN, f64::INFINITY, 0.0, 0.02, 0.02, 0.02, 0.02] {
        let output = run.cycle_with(error);
        assert_eq!((output.state, output.stop_leading_axes), (EngagementState::Coupled, false));
    }
    let fault = run.cycle_with(0.02);
    assert_eq!((fault.state, fault.stop_leading_axes), (EngagementState::Fault, true));
    assert_eq!(fault.window, Some(FollowingWindow::Outside));
}

#[test]
fn a_fault_keeps_the_coupling_until_the_leading_axes_stand() {
    let mut run = Run::engage(Leading::steady(300.0), 0.0);
    run.until(EngagementState::Synchronising);
    run.engagement.synchronise(0.0, 1.0, 9.0).unwrap();
    run.until(EngagementState::Coupled);
    let offset = run.cycle().offset;
    let states = [(); 5].map(|()| run.cycle_with(1.0).state);
    assert_eq!(states[3..], [EngagementState::Coupled, EngagementState::Fault]);
    run.engagement.switch_off();
    for _ in 0..100 {
        let output = run.cycle();
        assert_eq!(
            (output.state, output.offset, output.stop_leading_axes),
            (EngagementState::Fault, offset, true)
        );
        assert_eq!(run.engagement.change_allowed(), Err(Error::Busy));
    }
    run.leading = Leading { start: run.leading.at(run.time()).position, ..Leading::steady(0.0) };
    let output = run.cycle();
    assert_eq!((output.state, output.offset, output.stop_leading_axes), (EngagementState::Off, None, false));
    assert_eq!(run.engagement.change_allowed(), Ok(()));
}

#[test]
fn leaving_running_axes_ends_at_rest() {
    let leading = Leading { swing: 100.0, frequency: 10.0, ..Leading::steady(900.0) };
    let mut run = Run::engage(leading, 0.0);
    run.until(EngagementState::Synchronising);
    run.engagement.synchronise(0.0, 4.0, 9.0).unwrap();
    run.until(EngagementState::Coupled);
    run.engagement.switch_off();
    assert_eq!(run.cycle().state, EngagementState::Leaving);
    run.engagement.switch_off();
    run.until(EngagementState::Off);
    assert_eq!(run.last().speed, 0.0);
    run.check_limits();
    // And anew, from where it stands.
    assert_eq!(run.engagement.engage(leading.at(run.time())), Ok(()));
}

#[test]
fn switching_off_waits_for_ramp_and_move() {
    let mut run = Run::engage(Leading::steady(500.0), 0.0);
    run.cycle();
    run.engagement.switch_off();
    run.until(EngagementState::Synchronising);
    assert_eq!(run.cycle().state, EngagementState::Leaving);
    run.until(EngagementState::Off);
    run.check_limits();

    let mut run = Run::engage(Leading::steady(500.0), 0.0);
    run.until(EngagementState::Synchronising);
    run.engagement.synchronise(0.0, 4.0, 9.0).unwrap();
    run.cycle();
    run.engagement.switch_off();
    run.until(EngagementState::Coupled);
    assert_eq!(run.cycle().state, EngagementState::Leaving);
    run.until(EngagementState::Off);
    run.check_limits();
}

#[test]
fn calls_out_of_turn_are_refused() {
    let mut run = Run::engage(Leading::steady(300.0), 0.0);
    assert_eq!(run.engagement.engage(Motion::default()), Err(Error::Busy));
    run.until(EngagementState::Synchronising);
    assert_eq!(run.engagement.change_allowed(), Err(Error::Busy));
    run.engagement.synchronise(0.0, 4.0, 9.0).unwrap();
    run.cycle();
    assert_eq!(run.engagement.synchronise(0.0, 4.0, 9.0), Err(Error::Busy));
    run.until(EngagementState::Coupled);
    assert_eq!(run.engagement.synchronise(0.0, 4.0, 9.0), Err(Error::Busy));
    assert_eq!(run.engagement.change_allowed(), Err(Error::Busy));

    let mut open = Engagement::new(SETTINGS).unwrap();
    assert_eq!(open.synchronise(0.0, 4.0, 9.0), Err(Error::NotEngaged));
    open.switch_off();
    let output = open.update(CYCLE, Motion::default(), 0.0).unwrap();
    assert_eq!((output.state, output.offset), (EngagementState::Off, None));
}

#[test]
fn values_that_are_no_numbers_change_nothing() {
    let mut run = Run::engage(Leading::steady(300.0), 0.0);
    run.cycle();
    let before = run.engagement;
    for bad in [f64::NAN, f64::INFINITY, -1e19] {
        for motion in [
            Motion { position: bad, ..Motion::default() },
            Motion { speed: bad, ..Motion::default() },
            Motion { acceleration: bad, ..Motion::default() },
        ] {
            assert!(matches!(run.engagement.update(CYCLE, motion, 0.0), Err(Error::BadParameter { .. })));
            assert!(matches!(
                Engagement::new(SETTINGS).unwrap().engage(motion),
                Err(Error::BadParameter { .. })
            ));
        }
    }
    for step in [0.0, -CYCLE, f64::NAN, f64::INFINITY] {
        assert!(run.engagement.update(step, Motion::default(), 0.0).is_err());
    }
    assert!(run.engagement.synchronise(f64::NAN, 0.0, 9.0).is_err());
    assert_eq!(run.engagement, before);
}

#[test]
fn settings_out_of_range_are_refused() {
    for bad in [-1.0, f64::NAN, f64::INFINITY] {
        for settings in [
            EngagementSettings { phase_speed: bad, ..SETTINGS },
            EngagementSettings { acceleration: bad, ..SETTINGS },
            EngagementSettings { fine_window: bad, ..SETTINGS },
            EngagementSettings { coarse_window: bad, ..SETTINGS },
            EngagementSettings { fault_time: bad, ..SETTINGS },
            EngagementSettings { standstill_speed: bad, ..SETTINGS },
        ] {
            assert!(matches!(Engagement::new(settings), Err(Error::BadParameter { .. })), "{settings:?}");
        }
    }
    assert!(Engagement::new(EngagementSettings { acceleration: 0.0, ..SETTINGS }).is_err());
    let swapped = EngagementSettings { fine_window: 0.02, ..SETTINGS };
    assert!(matches!(Engagement::new(swapped), Err(Error::BadParameter { name: "coarse window", .. })));
}

proptest! {
    #[test]
    fn any_engagement_keeps_its_limits_and_ends_in_the_gap(
        speed in -1500.0f64..1500.0,
        swing in -500.0f64..500.0,
        frequency in 0.5f64..30.0,
        follower in -1e4f64..1e4,
        target in -1e4f64..1e4,
        teeth in 1u32..200,
        waiting in 0u32..300,
        constant: bool,
    ) {
        let leading = Leading { swing: if constant { 0.0 } else { swing }, frequency, ..Leading::steady(speed) };
        let pitch = 360.0 / f64::from(teeth);
        let mut run = Run::engage(leading, follower);
        run.until(EngagementState::Synchronising);
        for _ in 0..waiting {
            run.cycle();
        }
        let gap = target - leading.at(run.time()).position;
        run.engagement.synchronise(run.last().position, target, pitch).unwrap();
        run.until(EngagementState::Coupled);
        prop_assert!(run.phase_error(gap + leading.at(run.time()).position, pitch).abs() < 1e-9);
        let offset = run.cycle().offset;
        for _ in 0..500 {
            prop_assert_eq!(run.cycle().offset, offset);
        }
        prop_assert!(run.phase_error(gap + leading.at(run.time()).position, pitch).abs() < 1e-9);
        run.check_limits();
    }
}
