//! Limits of a value on the sheet.

/// Limits of a value in its unit.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct SheetLimits {
    /// Lower one.
    pub lower: Option<f64>,
    /// Upper one.
    pub upper: Option<f64>,
}

/// How much a value may exceed its limit and still count as equal to it.
const SAME: f64 = 1e-9;

impl SheetLimits {
    /// No more than this.
    pub fn upper(limit: f64) -> Self {
        Self { lower: None, upper: Some(limit) }
    }

    /// No more than this to either side.
    pub fn both_sides(limit: f64) -> Self {
        Self { lower: Some(-limit), upper: Some(limit) }
    }

    /// Whether a value is beyond a limit.
    pub fn exceeded_by(&self, value: f64) -> bool {
        self.upper.is_some_and(|upper| value > upper + SAME)
            || self.lower.is_some_and(|lower| value < lower - SAME)
    }
}
