//! The additional rotation as counted: what turns pulses of the slide into parts of a workpiece pulse, by a rate multiplier of 18 bits or by
//! the exact accumulator of the gearbox (`docs/mathematics/gearbox.md`).

use electronic_gearbox::Error;
use electronic_gearbox::chain::{AdditionalRotation, RateRule};
use electronic_gearbox::coefficient::Coefficient;
use electronic_gearbox::coupling::{Gearbox, IncrementalGearbox, LinearTerm, Ratio, dyadic};
use electronic_gearbox::pulse::Direction;

/// How pulses of the slide become rotation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum RotationRule {
    /// By a rate multiplier on each line; less than one pulse of rotation a pulse of the slide.
    Multiplier {
        /// b, B and hand.
        coefficient: Coefficient,
        /// Which pulses pass.
        rule: RateRule,
    },
    /// By an accumulator of 128 bits; any ratio.
    Exact {
        /// Parts of rotation per interpolated pulse.
        ratio: Ratio,
    },
}

/// The coupling of a workpiece to a slide.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rotation {
    /// How it is counted.
    pub rule: RotationRule,
    /// Turns of the workpiece per millimetre of feed, with the sense of the machine.
    pub turns_per_millimetre: f64,
    /// Parts of rotation per revolution: workpiece pulses times P.
    pub parts_per_revolution: f64,
}

impl Rotation {
    /// The accumulator for this lead: `pulse_distance` is the way p/P of one interpolated pulse, mm.
    ///
    /// # Errors
    /// [`Error::BadParameter`] or [`Error::GearRange`] for a ratio beyond the accumulator.
    pub fn exact(
        turns_per_millimetre: f64,
        parts_per_revolution: f64,
        pulse_distance: f64,
    ) -> Result<Self, Error> {
        let ratio = dyadic(turns_per_millimetre * parts_per_revolution * pulse_distance)?.ratio();
        Ok(Self { rule: RotationRule::Exact { ratio }, turns_per_millimetre, parts_per_revolution })
    }

    /// The counter, at 0.
    ///
    /// # Errors
    /// [`Error::PulsesPerInterval`] for P outside its range.
    pub fn counter(&self, pulses_per_interval: u32) -> Result<RotationCounter, Error> {
        let counting = match self.rule {
            RotationRule::Multiplier { coefficient, rule } => Counting::Multiplier(AdditionalRotation::new(
                coefficient.word(),
                rule,
                coefficient.hand(),
                pulses_per_interval,
            )?),
            RotationRule::Exact { ratio } => {
                let gearbox = Gearbox::new(0, [LinearTerm::new(ratio, 0)]);
                Counting::Exact(IncrementalGearbox::new(gearbox, &[0])?)
            }
        };
        Ok(RotationCounter { counting, total: 0 })
    }

    /// Angle that the rounding of the ratio costs, rad per metre of feed.
    pub fn error_per_metre(&self, pulse_distance: f64) -> f64 {
        let wanted = self.turns_per_millimetre * self.parts_per_revolution * pulse_distance;
        let made = match self.rule {
            RotationRule::Multiplier { coefficient, .. } => wanted * (1.0 + coefficient.relative_error()),
            RotationRule::Exact { ratio } => ratio.as_f64(),
        };
        (made - wanted) / pulse_distance * 1e3 * std::f64::consts::TAU / self.parts_per_revolution
    }
}

/// Counts rotation pulse by pulse.
#[derive(Clone, Copy, Debug)]
pub struct RotationCounter {
    counting: Counting,
    total: i64,
}

/// What counts, by rule.
#[derive(Clone, Copy, Debug)]
enum Counting {
    Multiplier(AdditionalRotation),
    Exact(IncrementalGearbox<1>),
}

impl RotationCounter {
    /// One pulse of the interpolator; by how many parts it turns the workpiece.
    ///
    /// # Errors
    /// [`Error::GearRange`] at the end of the range of counts.
    pub fn pulse(&mut self, direction: Direction) -> Result<i64, Error> {
        let turned = match &mut self.counting {
            Counting::Multiplier(chain) => chain.pulse(direction).map_or(0, Direction::sign),
            Counting::Exact(gearbox) => {
                gearbox.advance(&[direction.sign()])?;
                gearbox.position()?.counts - self.total
            }
        };
        self.total += turned;
        Ok(turned)
    }

    /// Parts of rotation so far.
    pub fn total(&self) -> i64 {
        self.total
    }
}
