//! Rows over their numbers: what they leave, how they lie, where they touch; and the load along the edge.

use super::{FlankView, RowView, WearView};
use report::charts::{
    ChartError, LineChart, Panel, Series, Svg, format_fixed, format_significant, line_chart,
};
use report::data::{Block, Figure};

/// Angles below this are rounding, deg.
const NO_ANGLE: f64 = 1e-9;
/// Smallest span of an ordinate: below it a line is flat. um, deg and mm.
const LEAST_SPAN: f64 = 1e-3;

/// What is drawn of a row, with the title of its panel.
type Quantity = (&'static str, fn(&RowView) -> Option<f64>);

/// A line over the numbers of rows; rows without the value are left out.
fn over_rows(name: &str, rows: &[RowView], value: impl Fn(&RowView) -> Option<f64>) -> Option<Series> {
    let points = rows.iter().enumerate().filter_map(|(k, row)| Some((k as f64, value(row)?)));
    let (x, y): (Vec<f64>, Vec<f64>) = points.unzip();
    (!x.is_empty()).then(|| Series::new(name, x, y))
}

fn per_row(flanks: &[FlankView]) -> Result<Svg, ChartError> {
    let mut quantities: Vec<Quantity> = vec![
        ("scallop to the next row [µm]", |row| row.scallop_um),
        ("straight blocks, in the middle (< 0: gouge) [µm]", |row| Some(row.chord_um)),
        ("ε: normals out of their column planes, greatest [deg]", |row| Some(row.out_of_plane_deg)),
    ];
    if flanks.iter().flat_map(|flank| &flank.rows).any(|row| row.axis_out_of_plane_deg > NO_ANGLE) {
        let of_axis: Quantity =
            ("axis out of its column plane, greatest [deg]", |row| Some(row.axis_out_of_plane_deg));
        quantities.push(of_axis);
    }
    let panel = |(title, value): Quantity| {
        let lines = flanks.iter().filter_map(|flank| over_rows(&flank.name, &flank.rows, value));
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

fn heights(flanks: &[FlankView]) -> Result<Svg, ChartError> {
    let panel = |flank: &FlankView| {
        let lines = [
            over_rows("contact height", &flank.rows, |row| Some(row.contact_height_mm)),
            over_rows("least allowed", &flank.rows, |row| row.allowed_mm.map(|window| window[0])),
            over_rows("greatest allowed", &flank.rows, |row| row.allowed_mm.map(|window| window[1])),
        ];
        Panel::linear(
            format!("{}: above the tip [mm]", flank.name),
            LEAST_SPAN,
            lines.into_iter().flatten().collect(),
        )
    };
    line_chart(&LineChart {
        title: "Contact height of rows".into(),
        x_title: "row, from the root".into(),
        panels: flanks.iter().filter(|flank| !flank.rows.is_empty()).map(panel).collect(),
    })
}

/// Charts over the rows of all flanks.
pub(super) fn blocks(flanks: &[FlankView]) -> Result<Vec<Block>, ChartError> {
    if flanks.iter().all(|flank| flank.rows.is_empty()) {
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

/// A histogram as the line around its bars.
fn steps(name: &str, bin: f64, load: &[f64]) -> Series {
    let edges = load.iter().enumerate().flat_map(|(k, &y)| [[k as f64 * bin, y], [(k + 1) as f64 * bin, y]]);
    let (x, y) = edges.map(|[x, y]| (x, y)).unzip();
    Series::new(name, x, y)
}

/// Load along the edge, flank by flank.
pub(super) fn wear(flanks: &[FlankView]) -> Result<Vec<Block>, ChartError> {
    let worn: Vec<(&FlankView, &WearView)> =
        flanks.iter().filter_map(|flank| Some((flank, flank.wear.as_ref()?))).collect();
    if worn.is_empty() {
        return Ok(Vec::new());
    }
    let panel = |(flank, wear): &(&FlankView, &WearView)| {
        let lines = vec![
            steps("heights of this plan", wear.bin_mm, &wear.load_m_per_mm),
            steps("one height for all rows", wear.bin_mm, &wear.fixed_m_per_mm),
        ];
        Panel::linear(format!("{}: path per length of edge [m/mm]", flank.name), 0.0, lines)
    };
    let svg = line_chart(&LineChart {
        title: "Load along the cutting edge".into(),
        x_title: "height above the cutter's tip [mm]".into(),
        panels: worn.iter().map(panel).collect(),
    })?;
    let figures: Vec<String> = worn
        .iter()
        .map(|(flank, wear)| {
            let [peak, spread] =
                [format_significant(wear.peak_over_fixed, 3), format_fixed(wear.spread_mm, 1)];
            format!("{}: {peak} times the peak of one height, over {spread} mm of the edge.", flank.name)
        })
        .collect();
    let caption =
        format!("{} Bins of {} mm, one space.", figures.join(" "), format_significant(worn[0].1.bin_mm, 3));
    Ok(vec![Block::Figure(Figure::new("load-along-the-cutting-edge", svg, caption))])
}
