//! How all results scatter when the measurement is repeated with random noise.

use crate::workflow::{MonteCarloResult, ScatterResult};
use report::cells::{significant, significant_or_none};
use report::charts::ChartError;
use report::{Block, Column, Table};

/// The scatter of what counts for the whole tool; the rest stands in its table. Nothing without repetitions.
pub(super) fn blocks(found: Option<&MonteCarloResult>) -> Result<Vec<Block>, ChartError> {
    let Some(found) = found else { return Ok(Vec::new()) };
    let row = |scatter: &ScatterResult| {
        let name = &scatter.name;
        let number = |value: f64, digits| significant(name, value, digits);
        Ok(vec![
            name.replace("f_p,max", "f_pmax"),
            String::new(),
            unit(scatter.unit).to_owned(),
            number(scatter.mean, 5)?,
            number(scatter.sigma, 3)?,
            significant_or_none(name, scatter.stated_sigma, 3)?,
            number(scatter.interval[0], 4)?,
            number(scatter.interval[1], 4)?,
        ])
    };
    let of_tool = found.results.iter().filter(|scatter| !scatter.name.contains("tooth"));
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
        rows: of_tool.map(row).collect::<Result<_, ChartError>>()?,
        note:
            "Stated: the standard deviation that the evaluation gives from the noise alone, before any run."
                .into(),
    };
    let said = format!(
        "{} repeated measurements of the same tool. Jitter of the barrier and edge of the beam scatter; angles are rounded to steps of \
         the encoder.",
        found.measurements
    );
    Ok(vec![Block::Paragraph(said), Block::Table(table)])
}

fn unit(unit: &str) -> &str {
    match unit {
        "um" => "µm",
        "urad" => "µrad",
        other => other,
    }
}
