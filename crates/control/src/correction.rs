//! Rotation of the workpiece that is added over the place of the feed or the angle of the worm: a polynomial or a cubic table
//! (`docs/mathematics/gearbox.md#added-rotation`).

use electronic_gearbox::Error as GearboxError;
use electronic_gearbox::coupling::{CubicTable, EndRule, PolynomialCoupling, solve_slopes};

/// Which axis leads.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LeadingAxis {
    /// The feed slide, mm.
    Feed,
    /// The worm, degrees.
    Worm,
}

/// How the rotation depends on the axis, rad.
#[derive(Clone, Debug, PartialEq)]
pub enum CorrectionCurve {
    /// A polynomial.
    Polynomial(PolynomialCoupling),
    /// A table, solved.
    Table(SolvedTable),
}

/// A table with its slopes.
#[derive(Clone, Debug, PartialEq)]
pub struct SolvedTable {
    start: f64,
    spacing: f64,
    values: Vec<f64>,
    slopes: Vec<f64>,
    ends: EndRule,
}

impl SolvedTable {
    /// A spline through values at `start` + i `spacing`.
    ///
    /// # Errors
    /// Those of the gearbox's table.
    pub fn new(start: f64, spacing: f64, values: Vec<f64>, ends: EndRule) -> Result<Self, GearboxError> {
        let mut slopes = vec![0.0; values.len()];
        solve_slopes(&values, spacing, ends, &mut slopes, &mut vec![0.0; 2 * values.len()])?;
        let solved = Self { start, spacing, values, slopes, ends };
        solved.table()?;
        Ok(solved)
    }

    fn table(&self) -> Result<CubicTable<'_>, GearboxError> {
        CubicTable::new(self.start, self.spacing, &self.values, &self.slopes, self.ends)
    }
}

/// One added rotation.
#[derive(Clone, Debug, PartialEq)]
pub struct Correction {
    /// The axis that it depends on.
    pub axis: LeadingAxis,
    /// How.
    pub curve: CorrectionCurve,
}

/// State of an axis, in its unit and seconds; or what is added, rad and seconds.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct AxisState {
    /// Position.
    pub position: f64,
    /// Speed.
    pub speed: f64,
    /// Acceleration.
    pub acceleration: f64,
}

impl Correction {
    /// What is added at a state of its axis: position, and its rates by the chain rule.
    ///
    /// # Errors
    /// Those of the gearbox's curves, for a place beyond the range of numbers.
    pub fn at(&self, axis: AxisState) -> Result<AxisState, GearboxError> {
        let x = axis.position;
        let (value, slope, bend) = match &self.curve {
            CorrectionCurve::Polynomial(curve) => {
                (curve.value(x)?, curve.derivative(x)?, curve.second_derivative(x)?)
            }
            CorrectionCurve::Table(table) => {
                let table = table.table()?;
                (table.value(x)?, table.derivative(x)?, table.second_derivative(x)?)
            }
        };
        Ok(AxisState {
            position: value,
            speed: slope * axis.speed,
            acceleration: bend * axis.speed * axis.speed + slope * axis.acceleration,
        })
    }

    /// Greatest slope at the ends of a table that holds its end values, rad a unit of the axis: the follower's speed jumps by this times
    /// the speed of the axis. 0 for other curves.
    ///
    /// # Errors
    /// As [`Correction::at`].
    pub fn end_slope(&self) -> Result<f64, GearboxError> {
        match &self.curve {
            CorrectionCurve::Table(table) if table.ends == EndRule::Natural => {
                let (first, last) = table.table()?.end_slopes();
                Ok(first.abs().max(last.abs()))
            }
            _ => Ok(0.0),
        }
    }
}

/// The sum of corrections at states of feed and worm.
///
/// # Errors
/// As [`Correction::at`].
pub fn added(
    corrections: &[Correction],
    feed: AxisState,
    worm: AxisState,
) -> Result<AxisState, GearboxError> {
    corrections.iter().try_fold(AxisState::default(), |sum, correction| {
        let at = correction.at(match correction.axis {
            LeadingAxis::Feed => feed,
            LeadingAxis::Worm => worm,
        })?;
        Ok(AxisState {
            position: sum.position + at.position,
            speed: sum.speed + at.speed,
            acceleration: sum.acceleration + at.acceleration,
        })
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rates_are_those_of_the_sum_in_time() {
        let cubic = Correction {
            axis: LeadingAxis::Feed,
            curve: CorrectionCurve::Polynomial(PolynomialCoupling::new(&[0.1, 0.2, -0.3, 0.05]).unwrap()),
        };
        let values: Vec<f64> =
            (0..=12).map(|k| 0.3 * (f64::from(k % 12) * 30f64.to_radians()).sin()).collect();
        let wave = Correction {
            axis: LeadingAxis::Worm,
            curve: CorrectionCurve::Table(SolvedTable::new(0.0, 30.0, values, EndRule::Periodic).unwrap()),
        };
        let both = [cubic, wave];
        let at = |time: f64| {
            let feed = AxisState {
                position: 1.0 + 2.0 * time + 0.5 * time * time,
                speed: 2.0 + time,
                acceleration: 1.0,
            };
            let worm = AxisState { position: 500.0 * time, speed: 500.0, acceleration: 0.0 };
            added(&both, feed, worm).unwrap()
        };
        let (now, step) = (at(0.3), 1e-5);
        let (before, behind) = (at(0.3 - step), at(0.3 + step));
        assert!((now.speed - (behind.position - before.position) / (2.0 * step)).abs() < 1e-6);
        assert!((now.acceleration - (behind.speed - before.speed) / (2.0 * step)).abs() < 1e-2);
        assert_eq!(both[1].end_slope(), Ok(0.0));
    }

    #[test]
    fn a_table_that_ends_jumps_in_speed() {
        let line = SolvedTable::new(0.0, 1.0, vec![0.0, 2.0, 4.0], EndRule::Natural).unwrap();
        let line = Correction { axis: LeadingAxis::Feed, curve: CorrectionCurve::Table(line) };
        assert!((line.end_slope().unwrap() - 2.0).abs() < 1e-12);
        let behind = line.at(AxisState { position: 5.0, speed: 1.0, acceleration: 0.0 }).unwrap();
        assert_eq!(behind, AxisState { position: 4.0, speed: 0.0, acceleration: 0.0 });
    }
}
