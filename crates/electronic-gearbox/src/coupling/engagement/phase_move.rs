//! The move into the wanted tooth space, on top of a coupling that runs.

use super::Motion;
use super::profile::{PEAK_ACCELERATION, PEAK_SPEED, transition, transition_acceleration, transition_speed};
use crate::Error;

/// Whole pitches that a target may be away: beyond, the spacing of numbers is a pitch itself.
const MOST_PITCHES: f64 = (1u64 << 52) as f64;

/// The way from `position` to the nearest place that is a multiple of `pitch` away from `target`, in (-pitch/2, pitch/2]. All three in
/// one unit, degrees say; the pitch of a gear of z_2 teeth is 360/|z_2| degrees.
///
/// # Errors
/// [`Error::BadParameter`] for a pitch that is not positive and finite, and for a way that is not finite or 2^52 pitches long.
pub fn shortest_move(position: f64, target: f64, pitch: f64) -> Result<f64, Error> {
    if !(pitch > 0.0 && pitch.is_finite()) {
        return Err(Error::BadParameter { name: "tooth pitch", value: pitch, allowed: "above 0, finite" });
    }
    let way = target - position;
    let pitches = libm::floor(way / pitch);
    if pitches.is_nan() || pitches.abs() >= MOST_PITCHES {
        return Err(Error::BadParameter {
            name: "way to the tooth space",
            value: way,
            allowed: "finite, below 2^52 pitches",
        });
    }
    let rest = way - pitches * pitch;
    Ok(if rest > pitch / 2.0 { rest - pitch } else { rest })
}

/// From `start` by `way` along way S(t/T).
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct PhaseMove {
    start: f64,
    way: f64,
    duration: f64,
    elapsed: f64,
}

impl PhaseMove {
    /// T = max(1.875 |m|/v_max, sqrt(10/sqrt(3) |m|/a_max)).
    pub(super) fn new(start: f64, way: f64, greatest_speed: f64, greatest_acceleration: f64) -> Self {
        let by_speed = PEAK_SPEED * way.abs() / greatest_speed;
        let by_acceleration = libm::sqrt(PEAK_ACCELERATION * way.abs() / greatest_acceleration);
        Self { start, way, duration: by_speed.max(by_acceleration), elapsed: 0.0 }
    }

    pub(super) fn is_over(&self) -> bool {
        self.elapsed >= self.duration
    }

    /// Where the offset is and how it moves after a further step. At the end it is start plus way, whatever the steps were.
    pub(super) fn advance(&mut self, step: f64) -> Motion {
        self.elapsed += step;
        if self.is_over() {
            return Motion { position: self.start + self.way, ..Motion::default() };
        }
        let u = self.elapsed / self.duration;
        Motion {
            position: self.start + self.way * transition(u),
            speed: self.way * transition_speed(u) / self.duration,
            acceleration: self.way * transition_acceleration(u) / (self.duration * self.duration),
        }
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::{PhaseMove, shortest_move};
    use crate::Error;

    #[test]
    fn half_a_pitch_goes_forward() {
        assert_eq!(shortest_move(4.5, 0.0, 9.0), Ok(4.5));
        assert_eq!(shortest_move(-4.5, 0.0, 9.0), Ok(4.5));
        assert_eq!(shortest_move(0.0, 4.75, 9.0), Ok(-4.25));
        assert_eq!(shortest_move(0.0, -1e-30, 9.0), Ok(0.0));
    }

    #[test]
    fn what_is_no_pitch_or_place_is_refused() {
        for (position, target, pitch) in [
            (0.0, 1.0, 0.0),
            (0.0, 1.0, -9.0),
            (0.0, 1.0, f64::NAN),
            (0.0, 1.0, f64::INFINITY),
            (f64::NAN, 1.0, 9.0),
            (0.0, f64::INFINITY, 9.0),
            (0.0, 1e30, 9.0),
            (f64::MAX, f64::MIN, 9.0),
        ] {
            let refused = shortest_move(position, target, pitch);
            assert!(matches!(refused, Err(Error::BadParameter { .. })), "{refused:?}");
        }
    }

    proptest! {
        #[test]
        fn moves_end_in_a_gap_and_are_short(position in -1e4f64..1e4, target in -1e4f64..1e4, pitch in 0.5f64..100.0) {
            let way = shortest_move(position, target, pitch).unwrap();
            prop_assert!(way.abs() <= pitch / 2.0 + 1e-11);
            let pitches = (position + way - target) / pitch;
            prop_assert!((pitches - pitches.round()).abs() * pitch < 1e-10);
        }

        #[test]
        fn moves_keep_their_limits_and_reach_one(way in -10.0f64..10.0, speed in 0.1f64..100.0, acceleration in 0.1f64..1000.0) {
            prop_assume!(way.abs() > 1e-3);
            let mut run = PhaseMove::new(1.0, way, speed, acceleration);
            let step = run.duration / 5000.0;
            let (mut fastest, mut hardest) = (0f64, 0f64);
            while !run.is_over() {
                let at = run.advance(step);
                fastest = fastest.max(at.speed.abs() / speed);
                hardest = hardest.max(at.acceleration.abs() / acceleration);
            }
            prop_assert!(fastest < 1.0 + 1e-12 && hardest < 1.0 + 1e-12);
            prop_assert!(fastest.max(hardest) > 0.9999);
            prop_assert_eq!(run.advance(step).position, 1.0 + way);
        }
    }
}
