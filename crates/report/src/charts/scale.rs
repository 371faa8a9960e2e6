//! Scales: from data ranges to round ticks and levels, and from values to places on the page.

use serde::Serialize;

use super::error::LEAST_SPAN;
use super::numbers::{decimal_exponent, format_fixed, power_of_ten};
use super::topography::Topography;

/// The smallest of 1, 2, 5 x 10^k that divides `span` into at most `count` steps.
pub fn round_step(span: f64, count: usize) -> f64 {
    let raw = span / count.max(1) as f64;
    let power = 10f64.powi(decimal_exponent(raw));
    let factor = [1.0, 2.0, 5.0].into_iter().find(|m| m * power >= raw * (1.0 - 1e-9)).unwrap_or(10.0);
    factor * power
}

/// The largest of 1, 2, 5 x 10^k that does not exceed `limit`: the length of a scale bar.
pub fn round_below(limit: f64) -> f64 {
    let power = 10f64.powi(decimal_exponent(limit));
    let factor = [5.0, 2.0].into_iter().find(|m| m * power <= limit * (1.0 + 1e-9)).unwrap_or(1.0);
    factor * power
}

/// Decimals that a multiple of `step` needs.
pub fn decimals_of(step: f64) -> usize {
    (-decimal_exponent(step)).clamp(0, 12) as usize
}

/// An axis: its range, its ticks and how their values are written.
#[derive(Clone, Debug)]
pub struct Axis {
    lo: f64,
    hi: f64,
    step: f64,
    logarithmic: bool,
    /// Power of ten taken out of the tick labels.
    exponent: i32,
}

impl Axis {
    /// Range widened to whole steps. Constant data get a range around their value; `least_span` keeps rounding
    /// noise from being blown up to a full axis.
    pub fn rounded(lo: f64, hi: f64, count: usize, least_span: f64) -> Self {
        let size = lo.abs().max(hi.abs());
        let noise = (size * 1e-9).max(LEAST_SPAN);
        let least = if hi - lo > noise { least_span } else { least_span.max(size * 0.2) };
        let least = if least > LEAST_SPAN { least } else { 1.0 };
        let (lo, hi) = if hi - lo > noise.max(least_span) {
            (lo, hi)
        } else {
            let middle = 0.5 * (lo + hi);
            (middle - 0.5 * least, middle + 0.5 * least)
        };
        let step = round_step(hi - lo, count);
        let lo = (lo / step + 1e-9).floor() * step;
        let hi = (hi / step - 1e-9).ceil() * step;
        Self::linear(lo, hi, step)
    }

    /// Exactly the range of the data (coordinates of a grid), ticks inside.
    pub fn tight(lo: f64, hi: f64, count: usize) -> Self {
        let constant = hi - lo <= (lo.abs().max(hi.abs()) * 1e-12).max(LEAST_SPAN);
        let (lo, hi) = if constant { (lo - 0.5, lo + 0.5) } else { (lo, hi) };
        Self::linear(lo, hi, round_step(hi - lo, count))
    }

    /// As [`Axis::tight`] with steps of at least 1, for counts.
    pub fn counts(lo: f64, hi: f64, count: usize) -> Self {
        let axis = Self::tight(lo, hi, count);
        Self { step: axis.step.max(1.0), ..axis }
    }

    fn linear(lo: f64, hi: f64, step: f64) -> Self {
        let size = lo.abs().max(hi.abs());
        let exponent = if step < 1e-4 || size >= 1e6 { decimal_exponent(size) } else { 0 };
        Self { lo, hi, step, logarithmic: false, exponent }
    }

    /// Whole decades around positive data, twelve at most; what lies below is drawn at the lower end.
    pub fn decades(lo: f64, hi: f64) -> Self {
        let hi = hi.max(LEAST_SPAN);
        let lo = lo.max(1e-12 * hi);
        let lo = f64::from(decimal_exponent(lo));
        let hi = (hi.log10() - 1e-12).ceil().max(lo + 1.0);
        let step = ((hi - lo) / 6.0).ceil().max(1.0);
        Self { lo, hi, step, logarithmic: true, exponent: 0 }
    }

    /// Place of a value as a share of the axis, 0 .. 1.
    pub fn share(&self, value: f64) -> f64 {
        let value = if self.logarithmic { value.max(f64::MIN_POSITIVE).log10() } else { value };
        ((value - self.lo) / (self.hi - self.lo)).clamp(0.0, 1.0)
    }

    /// Ticks: place as a share of the axis, and label.
    pub fn ticks(&self) -> Vec<(f64, String)> {
        let first = (self.lo / self.step - 1e-6).ceil() as i64;
        let last = (self.hi / self.step + 1e-6).floor() as i64;
        (first..=last)
            .map(|k| {
                let value = k as f64 * self.step;
                let share = ((value - self.lo) / (self.hi - self.lo)).clamp(0.0, 1.0);
                (share, self.label(value))
            })
            .collect()
    }

    fn label(&self, value: f64) -> String {
        if self.logarithmic {
            return match value as i32 {
                exponent @ -3..=3 => format_fixed(10f64.powi(exponent), (-exponent).max(0) as usize),
                exponent => power_of_ten(exponent),
            };
        }
        let unit = 10f64.powi(self.exponent);
        format_fixed(value / unit, decimals_of(self.step / unit))
    }

    /// "×10⁻⁶" if a power was taken out of the labels.
    pub fn factor(&self) -> Option<String> {
        (self.exponent != 0).then(|| format!("×{}", power_of_ten(self.exponent)))
    }
}

/// Round contour levels around zero that several maps can share, so that equal shades mean equal values.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct LevelScale {
    lo_um: f64,
    hi_um: f64,
    step_um: f64,
}

impl LevelScale {
    /// A scale that holds zero and all values of the given topographies in at most a dozen steps.
    pub fn covering<'a>(topographies: impl IntoIterator<Item = &'a Topography>) -> Self {
        let (lo, hi) = topographies
            .into_iter()
            .map(Topography::range_um)
            .fold((0.0_f64, 0.0_f64), |(lo, hi), (a, b)| (lo.min(a), hi.max(b)));
        Self::over(lo, hi)
    }

    fn over(lo: f64, hi: f64) -> Self {
        let (lo, hi) = (lo.min(0.0), hi.max(0.0));
        if hi - lo <= LEAST_SPAN {
            return Self { lo_um: 0.0, hi_um: 0.0, step_um: 1.0 };
        }
        let step = round_step(hi - lo, 11);
        // A thousandth of a step beyond a level is rounding noise and earns no band of its own.
        Self {
            lo_um: (lo / step + 1e-3).floor() * step,
            hi_um: (hi / step - 1e-3).ceil() * step,
            step_um: step,
        }
    }

    /// True if all values are zero and there is nothing to contour.
    pub fn is_flat(&self) -> bool {
        self.hi_um <= self.lo_um
    }

    /// Edges of the bands from the lowest to the highest, um.
    pub fn edges_um(&self) -> Vec<f64> {
        if self.is_flat() {
            return Vec::new();
        }
        let first = (self.lo_um / self.step_um).round() as i64;
        let last = (self.hi_um / self.step_um).round() as i64;
        (first..=last).map(|k| k as f64 * self.step_um).collect()
    }

    /// Distance of the levels, um.
    pub fn step_um(&self) -> f64 {
        self.step_um
    }

    /// Largest magnitude on the scale, um.
    pub fn size(&self) -> f64 {
        self.lo_um.abs().max(self.hi_um.abs())
    }

    /// A level as text, with the decimals of the step.
    pub fn label(&self, level: f64) -> String {
        if level == 0.0 {
            return "0".to_owned();
        }
        if self.step_um < 1e-5 {
            return super::numbers::format_significant(level, 2);
        }
        format_fixed(level, decimals_of(self.step_um))
    }

    /// A value between the levels as text, to about a hundredth of a step.
    pub fn precise_label(&self, value: f64) -> String {
        if self.step_um < 1e-5 {
            return super::numbers::format_significant(value, 3);
        }
        format_fixed(value, decimals_of(self.step_um) + 2)
    }
}
