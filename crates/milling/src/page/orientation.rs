//! The section on orientation: the rotary motion of the middle row with the axis in the column planes, along parameter lines, and
//! along sheared lines (`docs/mathematics/milling.md#positions-of-five-axes`).

use report::charts::{ChartError, LineChart, Panel, Series, format_fixed, format_significant, line_chart};
use report::data::{Block, Column, Figure, Table};
use report::kebab;

/// The comparison on one flank.
#[derive(Clone, Debug, PartialEq)]
pub struct OrientationView {
    /// The flank: `Left flank`.
    pub flank: String,
    /// The machine in words.
    pub machine: String,
    /// Names of both rotary axes.
    pub axes: [String; 2],
    /// The orientations: the plan's own first.
    pub rows: Vec<OrientedRowView>,
}

/// One orientation.
#[derive(Clone, Debug, PartialEq)]
pub struct OrientedRowView {
    /// Its name.
    pub name: String,
    /// Its figures, or why there are none.
    pub figures: Result<RotaryView, String>,
    /// Way of the contact, mm.
    pub arc_mm: Vec<f64>,
    /// Angles of both axes, deg.
    pub angles_deg: [Vec<f64>; 2],
}

/// Figures of both axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RotaryView {
    /// Travel, deg.
    pub travel_deg: [f64; 2],
    /// Largest second difference, deg/mm^2.
    pub second: [f64; 2],
    /// Reversals.
    pub reversals: [usize; 2],
    /// Least and greatest lean into the feed, deg.
    pub lean_deg: [f64; 2],
}

/// Smallest span of an angle, deg: below it a line is flat.
const LEAST_SPAN: f64 = 0.01;

/// What may be said of column planes in general (`docs/mathematics/milling.md#positions-of-five-axes`).
const HONEST: &str = "Against clean parameter lines the column plane does not generally save rotary motion: none on spur, helical and \
                      straight bevel gears, more or less of it on the flanks of spiral bevels, and it saves some on twisted blades. \
                      Against irregular patches it removes the oscillation. Otherwise it gives a steady lean into the feed, mostly a \
                      smaller one; straight bevels are the exception.";

impl OrientationView {
    /// Sentences, table and chart of a flank.
    fn blocks(&self) -> Result<Vec<Block>, ChartError> {
        let mut blocks = vec![Block::Paragraph(self.sentence()), Block::Table(self.table())];
        let panel = |axis: usize| {
            let line = |row: &OrientedRowView| {
                Series::new(row.name.clone(), row.arc_mm.clone(), row.angles_deg[axis].clone())
            };
            let drawn = self.rows.iter().filter(|row| row.figures.is_ok());
            Panel::linear(format!("{} [deg]", self.axes[axis]), LEAST_SPAN, drawn.map(line).collect())
        };
        if self.rows.iter().any(|row| row.figures.is_ok()) {
            let svg = line_chart(&LineChart {
                title: format!("{}: rotary axes along the middle row", self.flank),
                x_title: "way of the contact [mm]".into(),
                panels: [0, 1].map(panel).into(),
            })?;
            let id = format!("{}-rotary-axes-along-the-middle-row", kebab(&self.flank));
            blocks.push(Block::Figure(Figure::new(id, svg, "")));
        }
        Ok(blocks)
    }

    /// What both figures are here.
    fn sentence(&self) -> String {
        let both = |row: Option<&OrientedRowView>| row.and_then(|row| row.figures.as_ref().ok()).copied();
        let (Some(own), Some(iso)) = (both(self.rows.first()), both(self.rows.get(1))) else {
            return format!("{}: not all orientations are within reach of {}.", self.flank, self.machine);
        };
        let [a, b] = [own, iso].map(|figures| figures.travel_deg.iter().sum::<f64>());
        let verdict = match a - b {
            x if x.abs() < LEAST_SPAN => "as much as".to_owned(),
            x if x < 0.0 => format!("{} deg less than", format_fixed(-x, 2)),
            x => format!("{} deg more than", format_fixed(x, 2)),
        };
        let most = |lean: [f64; 2]| format_fixed(lean[0].abs().max(lean[1].abs()), 2);
        format!(
            "{} on {}: both rotary axes together travel {} deg along the row, {verdict} with the axis along the parameter lines; the \
             lean into the feed is at most {} deg instead of {} deg.",
            self.flank,
            self.machine,
            format_fixed(a, 2),
            most(own.lean_deg),
            most(iso.lean_deg)
        )
    }

    fn table(&self) -> Table {
        let [first, second] = &self.axes;
        let row = |row: &OrientedRowView| match &row.figures {
            Ok(figures) => vec![
                row.name.clone(),
                format_fixed(figures.travel_deg[0], 2),
                format_fixed(figures.travel_deg[1], 2),
                second_difference(figures.second[0]),
                second_difference(figures.second[1]),
                format!("{} / {}", figures.reversals[0], figures.reversals[1]),
                format!(
                    "{} to {}",
                    format_fixed(figures.lean_deg[0], 2),
                    format_fixed(figures.lean_deg[1], 2)
                ),
            ],
            Err(reason) => vec![format!("{}: {reason}", row.name)],
        };
        Table {
            caption: String::new(),
            columns: vec![
                Column::text("Axis of the cutter"),
                Column::number(format!("Travel of {first}"), "deg"),
                Column::number(format!("Travel of {second}"), "deg"),
                Column::number(format!("Largest second difference of {first}"), "deg/mm²"),
                Column::number(format!("of {second}"), "deg/mm²"),
                Column::number(format!("Reversals {first} / {second}"), ""),
                Column::number("Lean into the feed", "deg"),
            ],
            rows: self.rows.iter().map(row).collect(),
            note: String::new(),
        }
    }
}

/// Second differences below this are rounding of angles over steps of the row, deg/mm^2.
const NO_CHANGE: f64 = 1e-8;

fn second_difference(value: f64) -> String {
    if value < NO_CHANGE { "0".into() } else { format_significant(value, 3) }
}

/// The whole section.
pub(super) fn blocks(views: &[OrientationView]) -> Result<Vec<Block>, ChartError> {
    let mut blocks = vec![Block::Paragraph(HONEST.into())];
    for view in views {
        blocks.extend(view.blocks()?);
    }
    Ok(blocks)
}
