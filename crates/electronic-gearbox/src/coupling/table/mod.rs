//! Coupling by a table: a cubic spline through equally spaced knots (`docs/mathematics/gearbox.md#couplings`). [`solve_slopes`] runs once,
//! when the table is loaded; a look-up afterwards takes the same few operations everywhere.

mod slopes;

pub use slopes::solve_slopes;

use super::counts::nearest_count;
use crate::{Error, TableFault};

/// What the curve does at its ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum EndRule {
    /// No curvature at the ends; beyond them the end value is held. The derivative jumps there: see [`CubicTable::end_slopes`].
    Natural,
    /// The curve repeats; first and last value are the same.
    Periodic,
}

/// Curve with knots at x_0 + i h, i = 0..=N, over storage of the caller.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CubicTable<'a> {
    start: f64,
    spacing: f64,
    /// N h.
    length: f64,
    values: &'a [f64],
    slopes: &'a [f64],
    ends: EndRule,
}

/// Whole periods that an argument may be away: beyond, the spacing of numbers is a period itself.
const MOST_PERIODS: f64 = (1u64 << 52) as f64;

impl<'a> CubicTable<'a> {
    /// A table from x_0 = `start` on with the knot distance h = `spacing`, and slopes from [`solve_slopes`].
    ///
    /// # Errors
    /// [`Error::BadTable`] for fewer than two knots, a distance that is not positive and finite, slopes of another number than values,
    /// a periodic table whose ends differ in value or slope, and values that are not finite or so large that the curve between them would
    /// not be. [`Error::BadParameter`] for a start or an end that is not finite.
    pub fn new(
        start: f64,
        spacing: f64,
        values: &'a [f64],
        slopes: &'a [f64],
        ends: EndRule,
    ) -> Result<Self, Error> {
        check_knots(values, spacing, ends)?;
        if values.len() != slopes.len() {
            return Err(bad(TableFault::Storage { values: values.len(), slopes: slopes.len() }));
        }
        check_closed(slopes, ends)?;
        // Exact: no slice has 2^53 values.
        let length = values.len().saturating_sub(1) as f64 * spacing;
        if !(start.is_finite() && (start + length).is_finite()) {
            return Err(Error::BadParameter {
                name: "start of a table",
                value: start,
                allowed: "finite, as the end",
            });
        }
        let table = Self { start, spacing, length, values, slopes, ends };
        for index in 0..values.len().saturating_sub(1) {
            if !table.cell(index)?.is_bounded(spacing) {
                return Err(bad(TableFault::NotFinite { index }));
            }
        }
        Ok(table)
    }

    /// y(x).
    ///
    /// # Errors
    /// [`Error::BadParameter`] for an x that is not finite, or more than 2^52 periods away.
    #[inline]
    pub fn value(&self, x: f64) -> Result<f64, Error> {
        Ok(match self.place(x)? {
            Place::Within { cell, at } => cell.value(at),
            Place::Beyond { value } => value,
        })
    }

    /// dy/dx; 0 beyond the ends of a natural table.
    ///
    /// # Errors
    /// As for [`CubicTable::value`].
    #[inline]
    pub fn derivative(&self, x: f64) -> Result<f64, Error> {
        Ok(match self.place(x)? {
            Place::Within { cell, at } => cell.derivative(at) / self.spacing,
            Place::Beyond { .. } => 0.0,
        })
    }

    /// d2y/dx2; 0 beyond the ends of a natural table.
    ///
    /// # Errors
    /// As for [`CubicTable::value`].
    #[inline]
    pub fn second_derivative(&self, x: f64) -> Result<f64, Error> {
        Ok(match self.place(x)? {
            Place::Within { cell, at } => cell.second_derivative(at) / (self.spacing * self.spacing),
            Place::Beyond { .. } => 0.0,
        })
    }

    /// floor(y(x) + 1/2), for a table of counts.
    ///
    /// # Errors
    /// As for [`CubicTable::value`]; [`Error::GearRange`] from 2^62 counts on.
    #[inline]
    pub fn counts(&self, x: f64) -> Result<i64, Error> {
        nearest_count("value of a table", self.value(x)?)
    }

    /// Derivatives at the first and the last knot. A follower of a natural table gets a jump of speed of this size times the speed of the
    /// leading axis when that passes an end.
    pub fn end_slopes(&self) -> (f64, f64) {
        let end = |slope: Option<&f64>| slope.copied().unwrap_or_default();
        (end(self.slopes.first()), end(self.slopes.last()))
    }

    #[inline]
    fn place(&self, x: f64) -> Result<Place, Error> {
        let mut way = x - self.start;
        if !way.is_finite() {
            return Err(argument(x));
        }
        match self.ends {
            EndRule::Natural if way < 0.0 => return self.beyond(self.values.first()),
            EndRule::Natural if way > self.length => return self.beyond(self.values.last()),
            EndRule::Natural => {}
            EndRule::Periodic => {
                let periods = libm::floor(way / self.length);
                if periods.abs() >= MOST_PERIODS {
                    return Err(argument(x));
                }
                // Rounding may lead a little beyond an end.
                way = (way - periods * self.length).max(0.0).min(self.length);
            }
        }
        let knots = way / self.spacing;
        // The cast saturates, and the last knot belongs to the cell before it.
        let index = (libm::floor(knots) as usize).min(self.values.len().saturating_sub(2));
        Ok(Place::Within { cell: self.cell(index)?, at: knots - index as f64 })
    }

    fn beyond(&self, value: Option<&f64>) -> Result<Place, Error> {
        value.map(|&value| Place::Beyond { value }).ok_or(self.too_few())
    }

    #[inline]
    fn cell(&self, index: usize) -> Result<Cell, Error> {
        let pair = |list: &[f64]| match list.get(index..) {
            Some(&[left, right, ..]) => Some((left, right)),
            _ => None,
        };
        match (pair(self.values), pair(self.slopes)) {
            (Some(values), Some(slopes)) => Ok(Cell::hermite(values, slopes, self.spacing)),
            // Construction has seen two knots at least and as many slopes.
            _ => Err(self.too_few()),
        }
    }

    const fn too_few(&self) -> Error {
        bad(TableFault::TooFewKnots { knots: self.values.len() })
    }
}

enum Place {
    Within { cell: Cell, at: f64 },
    Beyond { value: f64 },
}

/// Cubic between two knots, in s = 0..1.
#[derive(Clone, Copy)]
struct Cell {
    cubic: f64,
    square: f64,
    linear: f64,
    constant: f64,
}

impl Cell {
    #[inline]
    fn hermite((y0, y1): (f64, f64), (m0, m1): (f64, f64), spacing: f64) -> Self {
        Self {
            cubic: 2.0 * (y0 - y1) + spacing * (m0 + m1),
            square: 3.0 * (y1 - y0) - spacing * (2.0 * m0 + m1),
            linear: spacing * m0,
            constant: y0,
        }
    }

    #[inline]
    fn value(&self, s: f64) -> f64 {
        ((self.cubic * s + self.square) * s + self.linear) * s + self.constant
    }

    #[inline]
    fn derivative(&self, s: f64) -> f64 {
        (3.0 * self.cubic * s + 2.0 * self.square) * s + self.linear
    }

    #[inline]
    fn second_derivative(&self, s: f64) -> f64 {
        6.0 * self.cubic * s + 2.0 * self.square
    }

    /// Whether value and derivatives are finite everywhere between the knots.
    fn is_bounded(&self, spacing: f64) -> bool {
        let Self { cubic, square, linear, constant } = self.magnitudes();
        [
            cubic + square + linear + constant,
            (3.0 * cubic + 2.0 * square + linear) / spacing,
            (6.0 * cubic + 2.0 * square) / (spacing * spacing),
        ]
        .iter()
        .all(|bound| bound.is_finite())
    }

    fn magnitudes(&self) -> Self {
        Self {
            cubic: self.cubic.abs(),
            square: self.square.abs(),
            linear: self.linear.abs(),
            constant: self.constant.abs(),
        }
    }
}

/// What both the solver and the table require.
fn check_knots(values: &[f64], spacing: f64, ends: EndRule) -> Result<(), Error> {
    if values.len() < 2 {
        return Err(bad(TableFault::TooFewKnots { knots: values.len() }));
    }
    if !(spacing > 0.0 && spacing.is_finite()) {
        return Err(bad(TableFault::Spacing { value: spacing }));
    }
    check_finite(values)?;
    check_closed(values, ends)
}

fn check_finite(list: &[f64]) -> Result<(), Error> {
    match list.iter().position(|value| !value.is_finite()) {
        Some(index) => Err(bad(TableFault::NotFinite { index })),
        None => Ok(()),
    }
}

fn check_closed(list: &[f64], ends: EndRule) -> Result<(), Error> {
    match (ends, list) {
        (EndRule::Periodic, &[first, .., last]) if first != last => {
            Err(bad(TableFault::NotPeriodic { first, last }))
        }
        _ => Ok(()),
    }
}

const fn bad(reason: TableFault) -> Error {
    Error::BadTable { reason }
}

const fn argument(x: f64) -> Error {
    Error::BadParameter { name: "argument of a table", value: x, allowed: "finite, and within 2^52 periods" }
}

#[cfg(test)]
mod tests;
