//! How all results scatter when the measurement is repeated with random noise.

use report::cells::{significant, significant_or_none};
use report::charts::ChartError;
use report::data::{Block, Column, Table};

/// Repeated measurements.
#[derive(Clone, Debug, PartialEq)]
pub struct MonteCarloView {
    /// How often.
    pub runs: usize,
    /// What was random, in words; empty for nothing to say.
    pub noise: String,
    /// Results.
    pub rows: Vec<MonteCarloRow>,
}

/// A result.
#[derive(Clone, Debug, PartialEq)]
pub struct MonteCarloRow {
    /// Name in words.
    pub name: String,
    /// Symbol; empty for none.
    pub symbol: String,
    /// Unit of all numbers.
    pub unit: String,
    /// Mean over the runs.
    pub mean: f64,
    /// Standard deviation over the runs.
    pub deviation: f64,
    /// Standard deviation that the evaluation states beforehand; none where it states none.
    pub stated_deviation: Option<f64>,
    /// 95 % of the runs lie between.
    pub interval: [f64; 2],
}

impl MonteCarloView {
    pub(super) fn blocks(&self) -> Result<Vec<Block>, ChartError> {
        let row = |row: &MonteCarloRow| {
            let number = |value: f64, digits| significant(&row.name, value, digits);
            Ok(vec![
                row.name.clone(),
                row.symbol.clone(),
                row.unit.clone(),
                number(row.mean, 5)?,
                number(row.deviation, 3)?,
                significant_or_none(&row.name, row.stated_deviation, 3)?,
                number(row.interval[0], 4)?,
                number(row.interval[1], 4)?,
            ])
        };
        let table = Table {
            caption: String::new(),
            columns: vec![
                Column::text("Result"),
                Column::symbols("Symbol"),
                Column::text("Unit"),
                Column::number("Mean", ""),
                Column::number("Standard deviation", ""),
                Column::number("Stated", ""),
                Column::number("95 % from", ""),
                Column::number("to", ""),
            ],
            rows: self.rows.iter().map(row).collect::<Result<_, ChartError>>()?,
            note: "Stated: the standard deviation that the evaluation gives from the noise alone, before any run.".into(),
        };
        let said = if self.noise.is_empty() { String::new() } else { format!(" {}", self.noise) };
        Ok(vec![
            Block::Paragraph(format!("{} repeated measurements of the same tool.{said}", self.runs)),
            Block::Table(table),
        ])
    }
}
