//! The transition S(u) = 10 u^3 - 15 u^4 + 6 u^5 from 0 to 1 over u = 0..1, at rest and without acceleration at both ends.

/// Greatest S': at u = 1/2.
pub(super) const PEAK_SPEED: f64 = 1.875;

/// Greatest |S''|, 10/sqrt(3): at u = 1/2 -+ 1/sqrt(12).
pub(super) const PEAK_ACCELERATION: f64 = 5.773_502_691_896_258;

/// S(u).
pub(super) fn transition(u: f64) -> f64 {
    u * u * u * (10.0 + u * (6.0 * u - 15.0))
}

/// S'(u).
pub(super) fn transition_speed(u: f64) -> f64 {
    let both = u * (1.0 - u);
    30.0 * both * both
}

/// S''(u).
pub(super) fn transition_acceleration(u: f64) -> f64 {
    60.0 * u * (1.0 - u) * (1.0 - 2.0 * u)
}

/// Mean of S between two places, by Boole's rule, which is exact for the fifth degree and does not cancel for places close together.
pub(super) fn mean_transition(from: f64, to: f64) -> f64 {
    let at = |quarters: f64| transition(from + (to - from) * quarters / 4.0);
    (7.0 * (at(0.0) + at(4.0)) + 32.0 * (at(1.0) + at(3.0)) + 12.0 * at(2.0)) / 90.0
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::{
        PEAK_ACCELERATION, PEAK_SPEED, mean_transition, transition, transition_acceleration, transition_speed,
    };

    /// Integral of S from 0.
    fn integral(u: f64) -> f64 {
        u.powi(4) * (2.5 - 3.0 * u + u * u)
    }

    #[test]
    fn the_transition_starts_and_ends_at_rest() {
        assert_eq!([transition(0.0), transition(0.5), transition(1.0)], [0.0, 0.5, 1.0]);
        assert_eq!([transition_speed(0.0), transition_speed(1.0)], [0.0, 0.0]);
        assert_eq!([transition_acceleration(0.0), transition_acceleration(1.0)], [0.0, 0.0]);
        assert_eq!(integral(1.0), 0.5);
    }

    #[test]
    fn peaks_are_reached_and_not_exceeded() {
        assert_eq!(transition_speed(0.5), PEAK_SPEED);
        let peak = transition_acceleration(0.5 - 1.0 / 12f64.sqrt());
        assert!((peak - PEAK_ACCELERATION).abs() < 1e-14, "{peak}");
        for step in 0..=10_000 {
            let u = f64::from(step) / 1e4;
            assert!(
                transition_speed(u) <= PEAK_SPEED && transition_acceleration(u).abs() <= PEAK_ACCELERATION
            );
        }
    }

    proptest! {
        #[test]
        fn the_mean_is_that_of_the_integral(from in 0.0f64..1.0, share in 0.01f64..1.0) {
            let to = from + (1.0 - from) * share;
            let mean = (integral(to) - integral(from)) / (to - from);
            prop_assert!((mean_transition(from, to) - mean).abs() < 1e-10 / (to - from).min(1.0));
        }

        #[test]
        fn derivatives_follow_each_other(u in 0.001f64..0.999) {
            let step = 1e-5;
            let speed = (transition(u + step) - transition(u - step)) / (2.0 * step);
            prop_assert!((transition_speed(u) - speed).abs() < 1e-8);
            let acceleration = (transition_speed(u + step) - transition_speed(u - step)) / (2.0 * step);
            prop_assert!((transition_acceleration(u) - acceleration).abs() < 1e-7);
        }
    }
}
