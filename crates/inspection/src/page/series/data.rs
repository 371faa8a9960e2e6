//! What the page of a series shows.

use report::head::ReportHead;

/// The whole page.
#[derive(Clone, Debug, PartialEq)]
pub struct SeriesReport {
    /// Head of the page; files that were refused are its warnings.
    pub head: ReportHead,
    /// Parts that belong together.
    pub groups: Vec<SeriesGroup>,
}

/// Parts of one drawing.
#[derive(Clone, Debug, PartialEq)]
pub struct SeriesGroup {
    /// Name of the series.
    pub name: String,
    /// Heading.
    pub title: String,
    /// Parts in their order.
    pub parts: Vec<PartRow>,
    /// Characteristics.
    pub characteristics: Vec<CharacteristicRow>,
}

/// A part.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PartRow {
    /// Its number in the series.
    pub number: usize,
    /// Its number or name.
    pub part: String,
    /// When it was measured; empty if that is not known.
    pub time: String,
    /// Path of its sheet; empty for none.
    pub sheet: String,
    /// Class that it reaches; empty if it was not judged.
    pub class: String,
    /// Characteristics beyond their limits.
    pub exceeded: String,
    /// Doubts of its evaluation.
    pub warnings: usize,
}

/// A characteristic.
#[derive(Clone, Debug, PartialEq)]
pub struct CharacteristicRow {
    /// What it is.
    pub key: String,
    /// Unit as it is printed; empty for none.
    pub unit: String,
    /// Decimals to print.
    pub decimals: usize,
    /// Lower and upper limit.
    pub limits: [Option<f64>; 2],
    /// Numbers of the parts that have it, ascending.
    pub parts: Vec<usize>,
    /// Their values.
    pub values: Vec<f64>,
    /// Figures; none for a single part.
    pub figures: Option<CharacteristicFigures>,
    /// What to know.
    pub remarks: Vec<String>,
}

/// Figures of a characteristic.
#[derive(Clone, Debug, PartialEq)]
pub struct CharacteristicFigures {
    /// Mean with its interval of 95 percent.
    pub mean: [f64; 3],
    /// Standard deviation.
    pub deviation: f64,
    /// Least and greatest value.
    pub extremes: [f64; 2],
    /// Control limits of individual values.
    pub control: [f64; 2],
    /// Mean distance of neighbouring parts, its upper control limit.
    pub moving_range: [f64; 2],
    /// Capability.
    pub capability: Option<CapabilityFigures>,
    /// Trend.
    pub trend: Option<TrendFigures>,
    /// Stretches of parts with a special cause.
    pub marked: Vec<MarkedStretch>,
}

/// Capability.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CapabilityFigures {
    /// By the standard deviation of all parts.
    pub cp: Option<f64>,
    /// As `cp`, of the nearer limit.
    pub cpk: f64,
    /// Interval of 95 percent of `cpk`.
    pub cpk_interval: Option<[f64; 2]>,
    /// By the moving ranges.
    pub short_term: [Option<f64>; 2],
    /// Share of parts outside the limits, ppm.
    pub outside_ppm: Option<f64>,
}

/// The straight course over the parts.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TrendFigures {
    /// Value at part number 0.
    pub start: f64,
    /// Change from part to part.
    pub slope: f64,
    /// Interval of 95 percent of the change.
    pub interval: [f64; 2],
    /// Probability by chance.
    pub probability: Option<f64>,
}

/// A stretch of parts that a rule has found.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct MarkedStretch {
    /// Numbers of the first and the last part.
    pub parts: [usize; 2],
    /// A few letters for the chart.
    pub mark: &'static str,
    /// What it means, in words.
    pub meaning: &'static str,
}
