//! A move from rest to rest in seven phases under a greatest speed, acceleration and jerk. Knows no axis.

/// The move. Any unit of length.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SCurve {
    /// Length of the move.
    pub length: f64,
    /// Speed of the phase in the middle.
    pub speed: f64,
    /// Peak acceleration.
    pub acceleration: f64,
    /// Jerk; infinite without limit.
    pub jerk: f64,
    /// Time of one jerk phase, of the phase of constant acceleration, of the middle, s.
    times: [f64; 3],
}

impl SCurve {
    /// The fastest move over `length` (0 or more) under limits above 0; each may be infinite.
    pub fn new(length: f64, speed: f64, acceleration: f64, jerk: f64) -> Self {
        let length = length.abs();
        // Length of getting up to speed v and down again, and its time: v T with T = t_jerk + t_const + t_jerk.
        let ramp = |v: f64| {
            if jerk.is_infinite() || v <= 0.0 {
                // Without any limit the speed is there at once.
                return if acceleration.is_infinite() || v <= 0.0 {
                    (0.0, 0.0, 0.0)
                } else {
                    (0.0, v / acceleration, acceleration)
                };
            }
            let peak = acceleration.min((v * jerk).sqrt());
            (peak / jerk, (v / peak - peak / jerk).max(0.0), peak)
        };
        let over = |v: f64| {
            let (t_jerk, t_const, _) = ramp(v);
            v * (2.0 * t_jerk + t_const)
        };
        if length == 0.0 {
            return Self { length, speed: 0.0, acceleration: 0.0, jerk, times: [0.0; 3] };
        }
        // Without any finite limit the move takes no time; one of the three has to hold it.
        let mut reached = if speed.is_finite() { speed } else { 1e9 * length.max(1.0) };
        if over(reached) > length {
            let (mut low, mut high) = (0.0, reached);
            for _ in 0..200 {
                let middle = 0.5 * (low + high);
                if over(middle) > length {
                    high = middle;
                } else {
                    low = middle;
                }
            }
            reached = low;
        }
        let (t_jerk, t_const, peak) = ramp(reached);
        let middle = ((length - over(reached)) / reached).max(0.0);
        Self { length, speed: reached, acceleration: peak, jerk, times: [t_jerk, t_const, middle] }
    }

    /// Time of the whole move, s.
    pub fn duration(&self) -> f64 {
        let [jerk, constant, middle] = self.times;
        4.0 * jerk + 2.0 * constant + middle
    }

    /// Length on which the speed is reached, the same as that of stopping.
    pub fn ramp_length(&self) -> f64 {
        let [jerk, constant, _] = self.times;
        0.5 * self.speed * (2.0 * jerk + constant)
    }

    /// Time of getting up to speed and down again, less what the same way takes at that speed, s.
    pub fn ramp_time(&self) -> f64 {
        let [jerk, constant, _] = self.times;
        2.0 * jerk + constant
    }

    /// Way, speed and acceleration at a time after the start, s; held at both ends.
    pub fn at(&self, t: f64) -> [f64; 3] {
        let total = self.duration();
        let t = t.clamp(0.0, total);
        if t > 0.5 * total {
            let [way, speed, acceleration] = self.rising(total - t);
            return [self.length - way, speed, -acceleration];
        }
        self.rising(t)
    }

    /// The first half.
    fn rising(&self, t: f64) -> [f64; 3] {
        let [t_jerk, t_const, _] = self.times;
        let a = self.acceleration;
        let j = if t_jerk > 0.0 { a / t_jerk } else { 0.0 };
        if t < t_jerk {
            return [j * t * t * t / 6.0, 0.5 * j * t * t, j * t];
        }
        let (v_1, s_1) = (0.5 * a * t_jerk, a * t_jerk * t_jerk / 6.0);
        let u = t - t_jerk;
        if u < t_const {
            return [s_1 + v_1 * u + 0.5 * a * u * u, v_1 + a * u, a];
        }
        let (v_2, s_2) = (v_1 + a * t_const, s_1 + v_1 * t_const + 0.5 * a * t_const * t_const);
        let u = u - t_const;
        if u < t_jerk {
            return [
                s_2 + v_2 * u + 0.5 * a * u * u - j * u * u * u / 6.0,
                v_2 + a * u - 0.5 * j * u * u,
                a - j * u,
            ];
        }
        [self.ramp_length() + self.speed * (u - t_jerk), self.speed, 0.0]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_move_arrives_within_its_limits() {
        for (length, speed, acceleration, jerk) in [
            (100.0, 10.0, 5.0, 20.0),
            (0.01, 10.0, 5.0, 20.0),
            (3.0, 10.0, 5.0, 20.0),
            (3.0, 10.0, 5.0, f64::INFINITY),
            (3.0, f64::INFINITY, 5.0, 2.0),
            (3.0, 10.0, f64::INFINITY, 2.0),
            (3.0, 10.0, f64::INFINITY, f64::INFINITY),
            (3.0, f64::INFINITY, f64::INFINITY, f64::INFINITY),
            (0.0, 1.0, 1.0, 1.0),
        ] {
            let curve = SCurve::new(length, speed, acceleration, jerk);
            let n = 4000;
            let step = curve.duration() / f64::from(n);
            let (mut before, mut way) = (curve.at(0.0), 0.0);
            for k in 1..=n {
                let now = curve.at(step * f64::from(k));
                assert!(now[1] <= speed * (1.0 + 1e-9) && now[2].abs() <= acceleration * (1.0 + 1e-9));
                way += 0.5 * step * (before[1] + now[1]);
                assert!(now.iter().all(|x| x.is_finite()));
                assert!(
                    (now[0] - way).abs() < 1e-5 * (length + 1e-12) || acceleration.is_infinite(),
                    "{length}: {way}"
                );
                before = now;
            }
            assert!((before[0] - length).abs() < 1e-9 * length.max(1e-9));
            assert!(before[1].abs() < 1e-6 || acceleration.is_infinite() && jerk.is_infinite());
        }
    }
}
