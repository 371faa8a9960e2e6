//! A figure with its standard deviation.

/// A result with its standard deviation.
#[derive(Clone, Debug, PartialEq)]
pub struct UncertainFigure {
    /// Name in words.
    pub name: String,
    /// Symbol; empty for none.
    pub symbol: String,
    /// The value.
    pub value: f64,
    /// Its unit.
    pub unit: String,
    /// Standard deviation in the same unit; none where the measurement does not tell.
    pub deviation: Option<f64>,
}
