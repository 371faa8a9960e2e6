//! Error budget of the pulse interpolator: how far the pulse position is off the slide and what of it the flank sees
//! (`docs/mathematics/gearbox.md#error-budget`).

use super::error::{ControlError, within};
use std::f64::consts::FRAC_PI_2;

/// What the budget depends on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BudgetInput {
    /// P, pulses per reference interval, 2 to 256.
    pub multiplier: u32,
    /// Clock f1, Hz.
    pub clock: f64,
    /// Reference pulses per metre of feed, q.
    pub pulses_per_metre: f64,
    /// Speed of the feed v, mm/s.
    pub speed: f64,
    /// Least speed in the running and the preceding interval, mm/s; `None` takes `speed`.
    pub least_speed: Option<f64>,
    /// Acceleration of the feed a, its amount, mm/s^2.
    pub acceleration: f64,
    /// Normal pressure angle, rad.
    pub normal_pressure_angle: f64,
    /// Helix angle, rad; its sign does not matter.
    pub helix_angle: f64,
}

/// The parts of the error. Lengths in mm along the feed, unless named otherwise.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ErrorBudget {
    /// Distance of reference pulses p.
    pub pitch: f64,
    /// Staircase p/P, to one side.
    pub quantisation: f64,
    /// v (P-1)/f1: the period memory holds whole counts, so the last of the P-1 inserted pulses comes early.
    pub truncation: f64,
    /// v/f1: a reference pulse is seen up to one tick late.
    pub synchronisation: f64,
    /// The distance between pulses is that of the interval before.
    pub acceleration: f64,
    /// Whether the acceleration is so great for the speed (about v^2 < a p) that pulses pause or come as a burst.
    pub acceleration_saturates: bool,
    /// Sum of the four parts.
    pub total: f64,
    /// The sum at the flank, normal to it, um.
    pub flank_um: f64,
    /// Movement of the flank per error of the feed, s_ax = abs(sin beta) cos(alpha_n).
    pub flank_share: f64,
    /// Speed the budget is for, mm/s.
    pub speed: f64,
    /// Greatest speed f1 p/P, mm/s.
    pub greatest_speed: f64,
    /// P at which the staircase p/P is as large as v P/f1, sqrt(p f1/v): a larger P no longer helps. `None` at standstill.
    pub best_multiplier: Option<f64>,
}

/// Between which limits the pulse position minus the true slide position stays at the ticks of the clock, mm; the constant
/// lag (P-1) p/P of the running direction is taken off. Between two ticks the slide moves by up to v/f1 more.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ErrorBound {
    /// Lower limit, negative.
    pub lower: f64,
    /// Upper limit.
    pub upper: f64,
}

impl ErrorBudget {
    /// The budget of an interpolator at one speed and acceleration.
    ///
    /// # Errors
    /// [`ControlError::BadParameter`] with the name of the field.
    pub fn new(input: &BudgetInput) -> Result<Self, ControlError> {
        let multiplier =
            within("multiplier", f64::from(input.multiplier), 2.0..=256.0, "2 to 256 pulses per interval")?;
        let clock = within("clock", input.clock, 1e-3..=1e12, "0.001 to 1e12 Hz")?;
        let per_metre =
            within("pulses_per_metre", input.pulses_per_metre, 1e-3..=1e12, "0.001 to 1e12 per metre")?;
        let speed = within("speed", input.speed, 0.0..=1e9, "0 to 1e9 mm/s")?;
        let least = within(
            "least_speed",
            input.least_speed.unwrap_or(speed),
            0.0..=speed,
            "0 to the speed of the feed, mm/s",
        )?;
        let acceleration = within("acceleration", input.acceleration, 0.0..=1e12, "0 to 1e12 mm/s^2")?;
        // The open ends of a range: the next number inside.
        let right = FRAC_PI_2.next_down();
        let pressure_angle = within(
            "normal_pressure_angle",
            input.normal_pressure_angle,
            f64::MIN_POSITIVE..=right,
            "above 0, below pi/2",
        )?;
        let helix_angle =
            within("helix_angle", input.helix_angle, -right..=right, "between -pi/2 and pi/2, without them")?;

        let pitch = 1000.0 / per_metre;
        let quantisation = pitch / multiplier;
        let truncation = speed * (multiplier - 1.0) / clock;
        let synchronisation = speed / clock;
        let greatest_lead = pitch * (multiplier - 1.0) / multiplier;
        // At standstill the quotient is infinite and the other limit holds; without acceleration it is 0 at any speed.
        let lead = if acceleration == 0.0 { 0.0 } else { acceleration * pitch * pitch / (least * least) };
        let by_acceleration = lead.min(greatest_lead);
        let total = quantisation + truncation + synchronisation + by_acceleration;
        let flank_share = helix_angle.sin().abs() * pressure_angle.cos();
        Ok(Self {
            pitch,
            quantisation,
            truncation,
            synchronisation,
            acceleration: by_acceleration,
            acceleration_saturates: lead >= greatest_lead,
            total,
            flank_um: total * 1e3 * flank_share,
            flank_share,
            speed,
            greatest_speed: clock * pitch / multiplier,
            best_multiplier: (speed > 0.0).then(|| (pitch * clock / speed).sqrt()),
        })
    }

    /// Limits that the error never leaves.
    ///
    /// # Errors
    /// [`ControlError::TooFast`] beyond the greatest speed: there pulses come late and no limit holds.
    pub fn bound(&self) -> Result<ErrorBound, ControlError> {
        if self.speed > self.greatest_speed {
            return Err(ControlError::TooFast { speed: self.speed, greatest: self.greatest_speed });
        }
        Ok(ErrorBound {
            lower: -self.quantisation - self.synchronisation - self.acceleration,
            // v P/f1: the interval before is measured to one tick.
            upper: self.truncation + self.synchronisation + self.acceleration,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn input() -> BudgetInput {
        BudgetInput {
            multiplier: 16,
            clock: 1e6,
            pulses_per_metre: 1e5,
            speed: 5.0,
            least_speed: None,
            acceleration: 100.0,
            normal_pressure_angle: 20f64.to_radians(),
            helix_angle: -20f64.to_radians(),
        }
    }

    #[test]
    fn examples_of_the_specification() {
        // `docs/mathematics/gearbox.md#how-it-is-verified`: P, f1, q, v, a and the flank in um, to the three digits given there.
        for (multiplier, clock, pulses_per_metre, speed, acceleration, flank_um) in [
            (16, 1e6, 1e5, 5.0, 100.0, 0.355),
            (16, 1e6, 1e5, 50.0, 100.0, 0.459),
            (16, 1e6, 1e5, 1.0, 50.0, 1.81),
            (64, 1e7, 2.5e5, 20.0, 2000.0, 0.087),
        ] {
            let given = BudgetInput { multiplier, clock, pulses_per_metre, speed, acceleration, ..input() };
            let found = ErrorBudget::new(&given).unwrap().flank_um;
            assert!((found / flank_um - 1.0).abs() < 4e-3, "{found} instead of {flank_um}");
        }
    }

    /// A drive of constant acceleration, tick by tick: references are seen at the tick after the line, pulses follow
    /// at the distance floor(L/P). The error never leaves the bound, and uses most of it.
    #[test]
    fn no_drive_leaves_the_bound() {
        let mut used = 0.0_f64;
        for (speed, acceleration, multiplier) in
            [(5.0, 100.0, 16u32), (37.0, 0.0, 16), (20.0, 2000.0, 64), (2.0, 300.0, 4), (90.0, -800.0, 32)]
        {
            let (clock, pitch) = (1e6, 0.01);
            // Crosses 400 lines; the slide starts between two of them.
            let at = |tick: f64| {
                let t = tick / clock;
                0.003 + speed * t + 0.5 * acceleration * t * t
            };
            let crossing = |line: usize| {
                let way = line as f64 * pitch - 0.003;
                let root = (speed * speed + 2.0 * acceleration * way).sqrt();
                (2.0 * way / (speed + root) * clock).ceil()
            };
            for line in 2..400 {
                let [before, now, next] = [line - 1, line, line + 1].map(crossing);
                let spacing = ((now - before) / f64::from(multiplier)).floor();
                // Speeds at the ends of the two intervals.
                let speeds = [line - 1, line, line + 1]
                    .map(|n: usize| (speed * speed + 2.0 * acceleration * (n as f64 * pitch - 0.003)).sqrt());
                let [least, greatest] = [
                    speeds.iter().fold(f64::MAX, |m, v| m.min(*v)),
                    speeds.iter().fold(0.0, |m: f64, v| m.max(*v)),
                ];
                let budget = ErrorBudget::new(&BudgetInput {
                    multiplier,
                    clock,
                    pulses_per_metre: 1000.0 / pitch,
                    speed: greatest,
                    least_speed: Some(least),
                    acceleration: acceleration.abs(),
                    ..input()
                })
                .unwrap();
                let bound = budget.bound().unwrap();
                // At the ticks the error is greatest with a pulse and least at the tick before the next.
                for inserted in 0..multiplier {
                    let tick = now + f64::from(inserted) * spacing;
                    if tick >= next {
                        break;
                    }
                    let until = if inserted + 1 < multiplier { (tick + spacing).min(next) } else { next };
                    let pulses = (line as f64 + f64::from(inserted) / f64::from(multiplier)) * pitch;
                    for error in [tick, until - 1.0].map(|tick| pulses - at(tick)) {
                        used = used.max(if error > 0.0 { error / bound.upper } else { error / bound.lower });
                        let spare = 1e-12;
                        assert!(
                            bound.lower - spare <= error && error <= bound.upper + spare,
                            "{error} outside {bound:?}, line {line}, pulse {inserted}, {speed} mm/s"
                        );
                    }
                }
            }
        }
        assert!(used > 0.9, "only {used} of the bound is used");
    }

    #[test]
    fn standstill_and_slow_feeds() {
        let slow = ErrorBudget::new(&BudgetInput { speed: 0.9, ..input() }).unwrap();
        assert!(slow.acceleration_saturates && slow.acceleration == 0.01 * 15.0 / 16.0);
        let fast = ErrorBudget::new(&BudgetInput { speed: 1.1, ..input() }).unwrap();
        assert!(!fast.acceleration_saturates);
        let turning =
            ErrorBudget::new(&BudgetInput { speed: 5.0, least_speed: Some(0.0), ..input() }).unwrap();
        assert_eq!(turning.acceleration, slow.acceleration);
        let still = BudgetInput { speed: 0.0, acceleration: 0.0, ..input() };
        let still = ErrorBudget::new(&still).unwrap();
        assert_eq!((still.acceleration, still.total, still.best_multiplier), (0.0, still.quantisation, None));
    }

    #[test]
    fn the_best_multiplier_has_the_least_sum() {
        let at = |multiplier| {
            ErrorBudget::new(&BudgetInput { multiplier, acceleration: 0.0, speed: 6.4, ..input() })
        };
        let best = at(16).unwrap().best_multiplier.unwrap();
        let total = |multiplier| at(multiplier).unwrap().total;
        let nearest = best.round() as u32;
        assert!(total(nearest) <= total(nearest - 1) && total(nearest) <= total(nearest + 1), "{best}");
    }

    #[test]
    fn bad_input_names_the_field() {
        let bad: [(&str, BudgetInput); 9] = [
            ("multiplier", BudgetInput { multiplier: 1, ..input() }),
            ("multiplier", BudgetInput { multiplier: 257, ..input() }),
            ("clock", BudgetInput { clock: 0.0, ..input() }),
            ("pulses_per_metre", BudgetInput { pulses_per_metre: f64::NAN, ..input() }),
            ("speed", BudgetInput { speed: -1.0, ..input() }),
            ("least_speed", BudgetInput { least_speed: Some(6.0), ..input() }),
            ("acceleration", BudgetInput { acceleration: f64::INFINITY, ..input() }),
            ("normal_pressure_angle", BudgetInput { normal_pressure_angle: 0.0, ..input() }),
            ("helix_angle", BudgetInput { helix_angle: FRAC_PI_2, ..input() }),
        ];
        for (field, given) in bad {
            match ErrorBudget::new(&given) {
                Err(ControlError::BadParameter { name, .. }) => assert_eq!(name, field),
                other => panic!("{field}: {other:?}"),
            }
        }
        let fast = ErrorBudget::new(&BudgetInput { speed: 626.0, ..input() }).unwrap();
        assert_eq!(fast.bound().unwrap_err().code(), "interpolator-too-fast");
    }
}
