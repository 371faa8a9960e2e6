//! Which axis of the machine a measurement points to.

use super::settings::unit;
use crate::workflow::{AxesTogether, AxisResult, JointAxis};
use generating_grinding::page::axis_columns;
use report::cells::significant;
use report::charts::{ChartError, format_fixed};
use report::{Block, Column, Table};
use std::collections::BTreeMap;

/// An axis in words.
fn words(name: &str) -> String {
    match name {
        "radial_feed_1_um" => "centre distance, linear over the feed".into(),
        "radial_feed_2_um" => "centre distance, quadratic over the feed".into(),
        "work_angle_1_arcsec" => "angle of the workpiece, linear over the feed".into(),
        "work_angle_2_arcsec" => "angle of the workpiece, quadratic over the feed".into(),
        "crossing_angle_deg" => "crossing angle of worm and workpiece".into(),
        "dressing_phi_s_deg" => "angle of the worm in dressing".into(),
        "dressing_gamma_deg" => "crossing angle in dressing".into(),
        "dressing_d_um" => "centre distance in dressing".into(),
        "dressing_v_ya_um" => "offset of the dresser".into(),
        other => other.replace('_', " "),
    }
}

/// The table and what could not be asked; nothing without axes.
///
/// # Errors
/// [`ChartError`] for values that are not finite.
pub(super) fn blocks(
    axes: &[AxisResult],
    together: Option<&AxesTogether>,
    not_asked: &BTreeMap<String, String>,
) -> Result<Vec<Block>, ChartError> {
    let not_asked = not_asked
        .keys()
        .map(|name| Block::Paragraph(format!("The model has no flank with this axis off: {}.", words(name))));
    if axes.is_empty() {
        return Ok(not_asked.collect());
    }
    let row = |axis: &AxisResult| {
        let name = words(&axis.axis);
        let alike: Vec<String> = axis.not_told_apart.iter().map(|other| words(other)).collect();
        Ok(vec![
            name.clone(),
            significant(&name, axis.value, 3)?,
            significant(&name, axis.uncertainty, 2)?,
            unit(&axis.axis).to_owned(),
            format_fixed(100.0 * axis.explains, 1),
            alike.join("; "),
        ])
    };
    let table = Block::Table(Table {
        caption: "Axes of the machine that would explain the measurement, each by itself".into(),
        columns: vec![
            Column::text("Axis"),
            Column::number("Off by", ""),
            Column::number("Standard uncertainty", ""),
            Column::text("Unit"),
            Column::number("Explains", "%"),
            Column::text("Leaves nearly the same"),
        ],
        rows: axes.iter().map(row).collect::<Result<_, ChartError>>()?,
        note: "Share of the squares of the measured lines about their means. Coefficients hold at the ends of the face. A measurement cannot tell that an axis is off, only that this would explain it.".into(),
    });
    let together = together.map(of_several).transpose()?;
    Ok(std::iter::once(table).chain(together).chain(not_asked).collect())
}

fn of_several(of: &AxesTogether) -> Result<Block, ChartError> {
    let row = |axis: &JointAxis| {
        let name = words(&axis.axis);
        Ok(vec![
            name.clone(),
            significant(&name, axis.value, 3)?,
            significant(&name, axis.uncertainty, 2)?,
            unit(&axis.axis).to_owned(),
        ])
    };
    Ok(Block::Table(Table {
        caption: "Axes of the machine that explain the measurement together".into(),
        columns: axis_columns(),
        rows: of.axes.iter().map(row).collect::<Result<_, ChartError>>()?,
        note: format!(
            "Together they explain {} % of the squares of the measured lines, clearly more than each by itself.",
            format_fixed(100.0 * of.explains, 1)
        ),
    }))
}
