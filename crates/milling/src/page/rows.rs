//! Rows over their numbers: what they leave, how they lie, where they touch.

use super::shown_flank::ShownFlank;
use crate::workflow::RowResult;
use report::charts::{ChartError, LineChart, Panel, Series, Svg, line_chart};
use report::{Block, Figure};

/// Angles below this are rounding, deg.
const NO_ANGLE: f64 = 1e-9;
/// Smallest span of an ordinate: below it a line is flat. um, deg and mm.
const LEAST_SPAN: f64 = 1e-3;

/// What is drawn of a row, with the title of its panel.
type Quantity = (&'static str, fn(&RowResult) -> Option<f64>);

/// A line over the numbers of rows; rows without the value are left out.
fn over_rows(name: &str, rows: &[RowResult], value: impl Fn(&RowResult) -> Option<f64>) -> Option<Series> {
    let points = rows.iter().filter_map(|row| Some((row.row as f64, value(row)?)));
    let (x, y): (Vec<f64>, Vec<f64>) = points.unzip();
    (!x.is_empty()).then(|| Series::new(name, x, y))
}

fn per_row(flanks: &[ShownFlank<'_>]) -> Result<Svg, ChartError> {
    let mut quantities: Vec<Quantity> = vec![
        ("scallop to the next row [µm]", |row| row.scallop_um),
        ("straight blocks, in the middle (< 0: gouge) [µm]", |row| Some(row.chord_um)),
        ("ε: normals out of their column planes, greatest [deg]", |row| Some(row.out_of_plane_deg)),
    ];
    let mut rows = flanks.iter().flat_map(|flank| &flank.result.rows);
    if rows.any(|row| row.axis_out_of_plane_deg > NO_ANGLE) {
        let of_axis: Quantity =
            ("axis out of its column plane, greatest [deg]", |row| Some(row.axis_out_of_plane_deg));
        quantities.push(of_axis);
    }
    let panel = |(title, value): Quantity| {
        let lines = flanks.iter().filter_map(|flank| over_rows(&flank.name(), &flank.result.rows, value));
        Panel::linear(title, LEAST_SPAN, lines.collect())
    };
    let panels: Vec<Panel> =
        quantities.into_iter().map(panel).filter(|panel| !panel.series.is_empty()).collect();
    line_chart(&LineChart {
        title: "What rows leave, and how they lie".into(),
        x_title: "row, from the root".into(),
        panels,
    })
}

fn heights(flanks: &[ShownFlank<'_>]) -> Result<Svg, ChartError> {
    let panel = |flank: &ShownFlank<'_>| {
        let rows = &flank.result.rows;
        let lines = [
            over_rows("contact height", rows, |row| Some(row.contact_height_mm)),
            over_rows("least allowed", rows, |row| row.allowed_mm.map(|window| window[0])),
            over_rows("greatest allowed", rows, |row| row.allowed_mm.map(|window| window[1])),
        ];
        Panel::linear(
            format!("{}: above the tip [mm]", flank.name()),
            LEAST_SPAN,
            lines.into_iter().flatten().collect(),
        )
    };
    line_chart(&LineChart {
        title: "Contact height of rows".into(),
        x_title: "row, from the root".into(),
        panels: flanks.iter().filter(|flank| !flank.result.rows.is_empty()).map(panel).collect(),
    })
}

/// Charts over the rows of all flanks.
pub(super) fn blocks(flanks: &[ShownFlank<'_>]) -> Result<Vec<Block>, ChartError> {
    if flanks.iter().all(|flank| flank.result.rows.is_empty()) {
        return Ok(Vec::new());
    }
    let heights_caption = "Least: where the straight side of the cutter begins. Greatest: the end of its edge, or where the corner comes too \
                           near to the bottom or the cutter to the opposite flank.";
    Ok(vec![
        Block::Figure(Figure::new(
            "what-rows-leave-and-how-they-lie",
            per_row(flanks)?,
            "By curvatures at the middle column; row 0 lies at the root.",
        )),
        Block::Figure(Figure::new("contact-height-of-rows", heights(flanks)?, heights_caption)),
    ])
}
