//! Where the lines of a scale really are: the errors of its graduation, or those of a ball screw whose encoder takes the place of a
//! scale (`docs/mathematics/gearbox.md#errors-of-what-is-measured`).

use super::error::{ControlError, within};
use super::interpolation::Extremes;
use electronic_gearbox::pulse::Direction;
use std::f64::consts::TAU;

/// An error that repeats along the feed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LineWave {
    /// Amplitude, mm.
    pub amplitude: f64,
    /// Period, mm.
    pub period: f64,
    /// Phase at the position 0, rad.
    pub phase: f64,
}

impl LineWave {
    fn at(&self, place: f64) -> f64 {
        self.amplitude * (TAU * place / self.period + self.phase).sin()
    }

    fn steepness(&self) -> f64 {
        TAU * self.amplitude / self.period
    }
}

/// Displacement of lines along the feed; none by default. A line that is displaced upwards is passed late by a slide that goes upwards.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct LineErrors {
    slope: f64,
    waves: Vec<LineWave>,
    backlash: f64,
}

/// Steepest displacement: beyond, lines would change places.
const STEEPEST: f64 = 0.5;

impl LineErrors {
    /// A `slope` in mm a mm, errors that repeat, and what the slide lags behind its screw after a reversal, mm.
    ///
    /// # Errors
    /// [`ControlError::BadParameter`] with the name of the field; "steepness" where lines would change places.
    pub fn new(slope: f64, waves: Vec<LineWave>, backlash: f64) -> Result<Self, ControlError> {
        within("slope", slope, -STEEPEST..=STEEPEST, "-0.5 to 0.5 mm a mm")?;
        for wave in &waves {
            within("amplitude", wave.amplitude, 0.0..=1e3, "0 to 1000 mm")?;
            within("period", wave.period, 1e-6..=1e6, "1e-6 to 1e6 mm")?;
            within("phase", wave.phase, -1e6..=1e6, "-1e6 to 1e6 rad")?;
        }
        within("backlash", backlash, 0.0..=1e3, "0 to 1000 mm")?;
        let errors = Self { slope, waves, backlash };
        within(
            "steepness",
            errors.steepness(),
            0.0..=STEEPEST,
            "slope and 2 pi amplitude/period add up to 0.5 at most",
        )?;
        Ok(errors)
    }

    /// Whether lines are where they should be.
    pub fn is_none(&self) -> bool {
        *self == Self::default()
    }

    /// How far the line that belongs at `place` is displaced, mm, against what a slide that starts at `start` finds there. The slide has
    /// come upwards: going down it has to take up the backlash.
    pub fn displacement(&self, place: f64, start: f64, direction: Direction) -> f64 {
        let waves: f64 = self.waves.iter().map(|wave| wave.at(place) - wave.at(start)).sum();
        let backlash = match direction {
            Direction::Forward => 0.0,
            Direction::Backward => -self.backlash,
        };
        self.slope * (place - start) + waves + backlash
    }

    /// Least and greatest displacement over a travel, mm.
    pub fn limits(&self, travel: Extremes, start: f64) -> Extremes {
        let ends = [self.slope * (travel.least - start), self.slope * (travel.greatest - start)];
        let mut limits =
            Extremes { least: ends[0].min(ends[1]) - self.backlash, greatest: ends[0].max(ends[1]) };
        for wave in &self.waves {
            let zero = wave.at(start);
            limits.least -= wave.amplitude + zero;
            limits.greatest += wave.amplitude - zero;
        }
        limits
    }

    /// Greatest displacement per way.
    pub fn steepness(&self) -> f64 {
        self.slope.abs() + self.waves.iter().map(LineWave::steepness).sum::<f64>()
    }

    /// What uneven lines cost the interpolation between them at most, mm: the pace of the interval before is that of other lines.
    pub fn unevenness(&self, pitch: f64) -> f64 {
        let bends = self.waves.iter().map(|wave| {
            let turn = TAU * pitch / wave.period;
            wave.amplitude * (turn * turn).min(4.0)
        });
        2.0 * bends.sum::<f64>() + self.steepness() * pitch
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn uneven() -> LineErrors {
        let wave = LineWave { amplitude: 0.002, period: 5.0, phase: 0.7 };
        LineErrors::new(1e-4, vec![wave], 0.003).unwrap()
    }

    #[test]
    fn displacements_begin_at_the_start_and_keep_to_their_limits() {
        let errors = uneven();
        assert_eq!(errors.displacement(2.0, 2.0, Direction::Forward), 0.0);
        assert_eq!(errors.displacement(2.0, 2.0, Direction::Backward), -0.003);
        let limits = errors.limits(Extremes { least: -3.0, greatest: 9.0 }, 2.0);
        let (mut least, mut greatest) = (0.0f64, 0.0f64);
        for k in 0..12_000 {
            let place = -3.0 + 1e-3 * f64::from(k);
            for direction in [Direction::Forward, Direction::Backward] {
                let found = errors.displacement(place, 2.0, direction);
                (least, greatest) = (least.min(found), greatest.max(found));
            }
        }
        assert!(limits.least <= least && greatest <= limits.greatest);
        // They are near: a period and more was passed.
        assert!(greatest - least > 0.9 * limits.range(), "{least} {greatest} {limits:?}");
    }

    #[test]
    fn lines_that_would_change_places_are_refused() {
        let wave = |amplitude, period| LineWave { amplitude, period, phase: 0.0 };
        let refused = |slope, waves, backlash| match LineErrors::new(slope, waves, backlash) {
            Err(ControlError::BadParameter { name, .. }) => name,
            other => panic!("{other:?}"),
        };
        assert_eq!(refused(0.0, vec![wave(1.0, 6.0)], 0.0), "steepness");
        assert_eq!(refused(f64::NAN, vec![], 0.0), "slope");
        assert_eq!(refused(0.0, vec![wave(-1.0, 6.0)], 0.0), "amplitude");
        assert_eq!(refused(0.0, vec![wave(1.0, 0.0)], 0.0), "period");
        assert_eq!(refused(0.0, vec![], -1.0), "backlash");
        assert!(LineErrors::default().is_none() && !uneven().is_none());
    }
}
