//! The section on a measured worm: which axes of dressing it points to.

use crate::workflow::{MeasuredWormResult, WormAxis};
use report::cells::{NONE, significant};
use report::charts::{ChartError, format_fixed};
use report::{Block, Column, Table};

/// The table; nothing without a measured worm.
///
/// # Errors
/// [`ChartError`] for values that are not finite.
pub(super) fn measured_worm(of: Option<&MeasuredWormResult>) -> Result<Vec<Block>, ChartError> {
    let Some(of) = of else { return Ok(Vec::new()) };
    let row = |axis: &WormAxis| {
        let (name, unit) = words(axis.axis);
        let uncertainty = match axis.uncertainty {
            0.0 => NONE.to_owned(),
            uncertainty => significant(name, uncertainty, 2)?,
        };
        Ok(vec![name.to_owned(), significant(name, axis.value, 3)?, uncertainty, unit.to_owned()])
    };
    let left_out = match of.points_left_out {
        0 => String::new(),
        count => format!(" {count} points beside the dressed area are not used."),
    };
    Ok(vec![
        Block::Paragraph(format!(
            "{} points of the measured worm deviate by {} µm (root mean square) from the planned one, and by {} µm with these axes off.{left_out}",
            of.points,
            format_fixed(of.rms_um, 3),
            format_fixed(of.rms_left_um, 3)
        )),
        Block::Table(Table {
            caption: "Axes of dressing that would explain the measured worm".to_owned(),
            columns: axis_columns(),
            rows: of.axes.iter().map(row).collect::<Result<_, ChartError>>()?,
            note: "All axes at once, the same all along the worm. An axis without an uncertainty is taken to stand right.".to_owned(),
        }),
    ])
}

/// Columns of a table of axes that would be off.
pub fn axis_columns() -> Vec<Column> {
    vec![
        Column::text("Axis"),
        Column::number("Off by", ""),
        Column::number("Standard uncertainty", ""),
        Column::text("Unit"),
    ]
}

/// An axis in words, with its unit.
fn words(name: &str) -> (&'static str, &'static str) {
    match name {
        "d_phi_S_deg" => ("angle of the worm", "°"),
        "d_gamma_deg" => ("crossing angle", "°"),
        "d_d_mm" => ("centre distance", "mm"),
        _ => ("offset of the dresser", "mm"),
    }
}
