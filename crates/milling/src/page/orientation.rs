//! The rotary motion of the middle row with the axis in the column planes, along parameter lines, and along sheared lines
//! (`docs/mathematics/milling.md#positions-of-five-axes`).

use super::shown_flank::flank_name;
use crate::workflow::{ComparedOrientations, OrientationFigures, OrientationResult, RotaryFigures};
use report::charts::{ChartError, LineChart, Panel, Series, format_fixed, format_significant, line_chart};
use report::{Block, Column, Figure, Table, kebab};

/// Smallest span of an angle, deg: below it a line is flat.
const LEAST_SPAN: f64 = 0.01;
/// Second differences below this are rounding of angles over steps of the row, deg/mm^2.
const NO_CHANGE: f64 = 1e-8;

/// What may be said of column planes in general (`docs/mathematics/milling.md#positions-of-five-axes`).
const HONEST: &str = "Against clean parameter lines the column plane does not generally save rotary motion: none on spur, helical and \
                      straight bevel gears, more or less of it on the flanks of spiral bevels, and it saves some on twisted blades. \
                      Against irregular patches it removes the oscillation. Otherwise it gives a steady lean into the feed, mostly a \
                      smaller one; straight bevels are the exception.";

/// Sentences, table and chart of every flank; nothing where the job does not want the comparison.
pub(super) fn blocks(flanks: &[ComparedOrientations]) -> Result<Vec<Block>, ChartError> {
    if flanks.is_empty() {
        return Ok(Vec::new());
    }
    let mut blocks = vec![Block::Paragraph(HONEST.into())];
    for flank in flanks {
        let name = flank_name(flank.side.name());
        blocks.push(Block::Paragraph(sentence(&name, &flank.result)));
        blocks.push(Block::Table(table(&flank.result)));
        blocks.extend(chart(&name, flank)?);
    }
    Ok(blocks)
}

/// The orientations, the plan's own first: key, name, figures.
fn orientations(result: &OrientationResult) -> [(&'static str, String, &OrientationFigures); 3] {
    let sheared = format!("along lines sheared by {} % of the face", 100.0 * result.shear);
    [
        ("column", "in the column planes".to_owned(), &result.column),
        ("iso", "along the parameter lines".to_owned(), &result.iso),
        ("sheared", sheared, &result.sheared),
    ]
}

/// What both figures are here.
fn sentence(flank: &str, result: &OrientationResult) -> String {
    let machine = format!("the machine {}", result.machine.replace('_', " "));
    let (Some(own), Some(iso)) = (result.column.reached(), result.iso.reached()) else {
        return format!("{flank}: not all orientations are within reach of {machine}.");
    };
    let [a, b] = [own, iso].map(|figures| figures.travel_deg.iter().sum::<f64>());
    let verdict = match a - b {
        x if x.abs() < LEAST_SPAN => "as much as".to_owned(),
        x if x < 0.0 => format!("{} deg less than", format_fixed(-x, 2)),
        x => format!("{} deg more than", format_fixed(x, 2)),
    };
    let most = |figures: &RotaryFigures| {
        let [least, greatest] = figures.lean_deg;
        format_fixed(least.abs().max(greatest.abs()), 2)
    };
    format!(
        "{flank} on {machine}: both rotary axes together travel {} deg along the row, {verdict} with the axis along the parameter lines; \
         the lean into the feed is at most {} deg instead of {} deg.",
        format_fixed(a, 2),
        most(own),
        most(iso)
    )
}

fn table(result: &OrientationResult) -> Table {
    let [first, second] = &result.axes;
    let row = |(_, name, figures): (&str, String, &OrientationFigures)| match figures {
        OrientationFigures::Reached(figures) => vec![
            name,
            format_fixed(figures.travel_deg[0], 2),
            format_fixed(figures.travel_deg[1], 2),
            second_difference(figures.max_second_deg_per_mm2[0]),
            second_difference(figures.max_second_deg_per_mm2[1]),
            format!("{} / {}", figures.reversals[0], figures.reversals[1]),
            format!("{} to {}", format_fixed(figures.lean_deg[0], 2), format_fixed(figures.lean_deg[1], 2)),
        ],
        OrientationFigures::NotReached { not_reached } => vec![format!("{name}: {not_reached}")],
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
        rows: orientations(result).map(row).into(),
        note: String::new(),
    }
}

fn second_difference(value: f64) -> String {
    if value < NO_CHANGE { "0".into() } else { format_significant(value, 3) }
}

/// Both axes over the way of the contact; nothing where the machine reaches none of the orientations.
fn chart(flank: &str, compared: &ComparedOrientations) -> Result<Option<Block>, ChartError> {
    let result = &compared.result;
    let reached = orientations(result);
    let reached: Vec<_> = reached.iter().filter(|(_, _, figures)| figures.reached().is_some()).collect();
    if reached.is_empty() {
        return Ok(None);
    }
    let panel = |axis: usize| {
        let line = |(key, name, _): &&(&str, String, &OrientationFigures)| {
            let curve = compared.curves.iter().find(|curve| curve.name == *key)?;
            Some(Series::new(name.clone(), curve.arc_mm.clone(), curve.angles_deg[axis].clone()))
        };
        Panel::linear(
            format!("{} [deg]", result.axes[axis]),
            LEAST_SPAN,
            reached.iter().filter_map(line).collect(),
        )
    };
    let svg = line_chart(&LineChart {
        title: format!("{flank}: rotary axes along the middle row"),
        x_title: "way of the contact [mm]".into(),
        panels: [0, 1].map(panel).into(),
    })?;
    let id = format!("{}-rotary-axes-along-the-middle-row", kebab(flank));
    Ok(Some(Block::Figure(Figure::new(id, svg, ""))))
}
