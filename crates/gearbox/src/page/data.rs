//! What the page of the electronic gearbox shows, as data.

use report::data::{Quantity, Table};
use report::head::ReportHead;

/// The whole page.
#[derive(Clone, Debug, PartialEq)]
pub struct GearboxReport {
    /// The answer, warnings and files.
    pub head: ReportHead,
    /// Scale, interpolator, encoder.
    pub settings: Vec<Quantity>,
    /// Lead and coefficient.
    pub coupling: Vec<Quantity>,
    /// Counters.
    pub counters: Vec<Quantity>,
    /// Errors in figures.
    pub errors: Vec<Quantity>,
    /// Errors over time; empty without a motion.
    pub error_panels: Vec<BandPanel>,
    /// Parts of the budget; empty without a motion.
    pub budget: Vec<BudgetRow>,
    /// The servo.
    pub servo: Option<ServoReport>,
    /// Set-ups.
    pub set_ups: Option<SetUpReport>,
}

/// Least and greatest of a quantity over time.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Band {
    /// Times, s.
    pub time_s: Vec<f64>,
    /// Least in the stretch about each time.
    pub least: Vec<f64>,
    /// Greatest in it.
    pub greatest: Vec<f64>,
}

/// A band with the limits that it keeps to.
#[derive(Clone, Debug, PartialEq)]
pub struct BandPanel {
    /// Quantity and unit.
    pub title: String,
    /// The band.
    pub band: Band,
    /// Limits, if there are any.
    pub limits: Option<[f64; 2]>,
    /// Values beyond this are drawn at it, so that smaller ones can be seen.
    pub cut: Option<[f64; 2]>,
}

/// A part of the error budget.
#[derive(Clone, Debug, PartialEq)]
pub struct BudgetRow {
    /// Name.
    pub name: String,
    /// How it comes about.
    pub formula: String,
    /// Along the feed, um.
    pub along_um: f64,
    /// At the flank, um.
    pub flank_um: f64,
}

/// The servo.
#[derive(Clone, Debug, PartialEq)]
pub struct ServoReport {
    /// Figures.
    pub quantities: Vec<Quantity>,
    /// Errors and torque over time.
    pub panels: Vec<BandPanel>,
    /// Frequency in Hz and um at the flank per N m.
    pub response: Vec<[f64; 2]>,
}

/// Set-ups side by side.
#[derive(Clone, Debug, PartialEq)]
pub struct SetUpReport {
    /// Error that is wanted at most, um.
    pub wanted_um: f64,
    /// All set-ups that have an error.
    pub points: Vec<SetUpPoint>,
    /// The cheapest one that is accurate enough, in words.
    pub best: Vec<Quantity>,
    /// The ranking.
    pub table: Table,
}

/// A set-up in the chart.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SetUpPoint {
    /// Cost.
    pub cost: f64,
    /// Error at the flank, um.
    pub flank_um: f64,
    /// Whether it is fast enough.
    pub fast: bool,
}
