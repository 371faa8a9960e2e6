//! Charts, tables and CSV of studies over strokes and over deviations of the axes.

use super::files::label;
use super::{DeviationCurve, StrokeCurve, StrokeFigures};
use crate::workflow::explore::Refused;
use job::{Cell, Column, CsvError, CsvTable};
use report::charts::{ChartError, LineChart, Marks, Panel, Series, Svg, format_significant, line_chart};
use report::{Column as PageColumn, Table};

/// A quantity of a stroke with its name and unit in tables, and its title on the page.
type Quantity = (Column, &'static str, fn(&StrokeFigures) -> f64);

/// The correction of a stroke.
const CORRECTIONS: [Quantity; 4] = [
    (Column::new("d_phi_S", "deg"), "Δφ_S [°]", |s| s.d_phi_s_deg),
    (Column::new("d_gamma", "deg"), "Δγ [°]", |s| s.d_gamma_deg),
    (Column::new("d_d", "mm"), "Δd [mm]", |s| s.d_d_mm),
    (Column::new("d_v_yA", "mm"), "Δv_yA [mm]", |s| s.d_v_ya_mm),
];

/// Points of the finished profile, the wanted one and every stroke.
pub fn stroke_table(curves: &[StrokeCurve]) -> Result<CsvTable, CsvError> {
    let mut columns = vec![
        Column::new("bodies", ""),
        Column::new("curve", ""),
        Column::new("stroke", ""),
        Column::new("w", "mm"),
        Column::new("f_n", "um"),
    ];
    columns.extend(CORRECTIONS.iter().map(|(column, ..)| *column));
    let mut table = CsvTable::new(&columns);
    for c in curves {
        for (name, f) in [("finished", &c.f_n_um), ("wanted", &c.wanted_um)] {
            for (&w, &f) in c.w_mm.iter().zip(f) {
                let mut row = vec![Cell::Word(&c.bodies), Cell::Word(name), Cell::Empty];
                row.extend([Cell::Number(w), Cell::Number(f)]);
                row.extend([Cell::Empty; 4]);
                table.push_cells(&row)?;
            }
        }
        for (k, s) in c.strokes.iter().enumerate() {
            for (&w, &f) in s.w_mm.iter().zip(&s.f_n_um) {
                let mut row = vec![Cell::Word(&c.bodies), Cell::Word("stroke"), Cell::Number((k + 1) as f64)];
                row.extend([Cell::Number(w), Cell::Number(f)]);
                row.extend(CORRECTIONS.iter().map(|(_, _, value)| Cell::Number(value(s))));
                table.push_cells(&row)?;
            }
        }
    }
    Ok(table)
}

/// f over w with the range of every stroke, for one set of bodies; `None` without strokes.
pub fn stroke_chart(c: &StrokeCurve) -> Result<Option<Svg>, ChartError> {
    if c.strokes.is_empty() {
        return Ok(None);
    }
    let numbered = || c.strokes.iter().enumerate().map(|(k, s)| (format!("stroke {}", k + 1), k, s));
    let mut profile = Vec::new();
    if !c.w_mm.is_empty() {
        let wanted = Series::new("wanted profile", c.w_mm.clone(), c.wanted_um.clone());
        profile.push(Series { marks: Marks::Level, ..wanted });
    }
    profile.extend(numbered().map(|(name, _, s)| Series::new(name, s.w_mm.clone(), s.f_n_um.clone())));
    let ranges = numbered().map(|(name, k, s)| {
        Series::new(name, vec![s.from_mm, s.to_mm], vec![(k + 1) as f64; 2]).marked(vec![true; 2])
    });
    let mut panels = vec![
        Panel::linear("normal modification f_nFS of every stroke [µm]", 0.1, profile),
        Panel::linear("range of the stroke [number]", 1.0, ranges.collect()),
    ];
    if !c.w_mm.is_empty() {
        let off = c.f_n_um.iter().zip(&c.wanted_um).map(|(f, g)| f - g).collect();
        let series = vec![Series::new("finished profile", c.w_mm.clone(), off)];
        panels.push(Panel::linear("finished minus wanted profile [µm]", 0.01, series));
    }
    let title = if c.bodies.is_empty() { "Strokes".into() } else { format!("Strokes, {}", c.bodies) };
    line_chart(&LineChart { title, x_title: "length of roll on the worm w_FS [mm]".into(), panels }).map(Some)
}

/// Range and correction of every stroke.
pub fn stroke_figures(curves: &[StrokeCurve]) -> Table {
    let mut rows = Vec::new();
    for c in curves {
        for (k, s) in c.strokes.iter().enumerate() {
            let mut row = vec![label(&c.bodies), (k + 1).to_string(), s.area.to_string()];
            row.extend([s.from_mm, s.to_mm].map(|w| format_significant(w, 6)));
            row.extend(CORRECTIONS.iter().map(|(_, _, value)| format_significant(value(s), 5)));
            rows.push(row);
        }
    }
    let mut columns = vec![
        PageColumn::symbols("Bodies"),
        PageColumn::number("Stroke", ""),
        PageColumn::number("Active area", ""),
        PageColumn::number("From", "mm"),
        PageColumn::number("To", "mm"),
    ];
    columns.extend(CORRECTIONS.iter().map(|(_, title, _)| PageColumn::symbols(*title)));
    let refused = refusals(curves.iter().map(|c| (c.bodies.as_str(), c.refused.as_ref())));
    let deviations = curves.iter().filter_map(|c| {
        c.deviation_um.map(|um| {
            format!("{}: {} µm from the wanted profile. ", label(&c.bodies), format_significant(um, 3))
        })
    });
    let note = format!("{}{refused}All points stand in explore.csv.", deviations.collect::<String>());
    Table { caption: String::new(), columns, rows, note }
}

/// Points of the change by every axis.
pub fn deviation_table(curves: &[DeviationCurve]) -> Result<CsvTable, CsvError> {
    let mut table = CsvTable::new(&[
        Column::new("bodies", ""),
        Column::new("axis", ""),
        Column::new("w", "mm"),
        Column::new("f_n", "um"),
    ]);
    for c in curves {
        for axis in &c.axes {
            for (&w, &f) in c.w_mm.iter().zip(&axis.f_n_um) {
                table.push_cells(&[
                    Cell::Word(&c.bodies),
                    Cell::Word(axis.axis),
                    Cell::Number(w),
                    Cell::Number(f),
                ])?;
            }
        }
    }
    Ok(table)
}

/// The symbol of an axis in charts and tables.
fn symbol(axis: &str) -> &'static str {
    match axis {
        "d_phi_S" => "Δφ_S",
        "d_gamma" => "Δγ",
        "d_d" => "Δd",
        "d_v_yA" => "Δv_yA",
        _ => "all axes",
    }
}

fn unit(unit: &str) -> &str {
    if unit == "deg" { "°" } else { unit }
}

/// A panel for every axis, a line for all bodies; `None` without curves.
pub fn deviation_chart(curves: &[DeviationCurve]) -> Result<Option<Svg>, ChartError> {
    let drawn: Vec<&DeviationCurve> = curves.iter().filter(|c| !c.w_mm.is_empty()).collect();
    let Some(first) = drawn.first() else { return Ok(None) };
    let panels = first.axes.iter().enumerate().map(|(k, axis)| {
        let what = match axis.deviation {
            Some(x) => format!("{} = {} {}", symbol(axis.axis), format_significant(x, 4), unit(axis.unit)),
            None => "all axes at once".into(),
        };
        let series =
            drawn.iter().map(|c| Series::new(label(&c.bodies), c.w_mm.clone(), c.axes[k].f_n_um.clone()));
        Panel::linear(format!("change of f_nFS by {what} [µm]"), 0.01, series.collect())
    });
    let panels = panels.collect();
    let chart = LineChart {
        title: "Change of the dressed profile by deviations of the axes".into(),
        x_title: "length of roll on the worm w_FS [mm]".into(),
        panels,
    };
    line_chart(&chart).map(Some)
}

/// Change at tip, middle and root by every axis.
pub fn deviation_figures(curves: &[DeviationCurve]) -> Table {
    let rows = curves.iter().flat_map(|c| {
        c.axes.iter().map(|axis| {
            let deviation = axis
                .deviation
                .map_or_else(String::new, |x| format!("{} {}", format_significant(x, 4), unit(axis.unit)));
            let mut row = vec![label(&c.bodies), symbol(axis.axis).into(), deviation];
            // Rounding is no change.
            let um = [axis.tip_um, axis.middle_um, axis.root_um, axis.beyond_first_order_um]
                .map(|x| if x.abs() < 1e-9 { 0.0 } else { x });
            row.extend(um.map(|um| format_significant(um, 4)));
            row
        })
    });
    let refused = refusals(curves.iter().map(|c| (c.bodies.as_str(), c.refused.as_ref())));
    Table {
        caption: String::new(),
        columns: vec![
            PageColumn::symbols("Bodies"),
            PageColumn::symbols("Axis"),
            PageColumn::symbols("Deviation"),
            PageColumn::number("At w_NfS (gear tip)", "µm"),
            PageColumn::number("Middle", "µm"),
            PageColumn::number("At w_NaS (gear root)", "µm"),
            PageColumn::number("Beyond first order", "µm"),
        ],
        rows: rows.collect(),
        note: format!("{refused}All points stand in explore.csv."),
    }
}

/// Quantiles of the draws.
pub fn quantile_figures(curves: &[DeviationCurve]) -> Table {
    let rows = curves.iter().flat_map(|c| {
        c.quantiles.iter().map(|q| {
            let mut row = vec![label(&c.bodies), format_significant(100.0 * q.level, 3)];
            row.extend([q.largest_um, q.slope_um, q.crowning_um].map(|um| format_significant(um, 4)));
            row
        })
    });
    let draws = curves.first().map_or_else(String::new, |c| {
        format!("{} draws, {} distribution, seed {}.", c.samples, c.distribution, c.seed)
    });
    Table {
        caption: String::new(),
        columns: vec![
            PageColumn::symbols("Bodies"),
            PageColumn::number("Draws below", "%"),
            PageColumn::number("Largest change", "µm"),
            PageColumn::number("Slope", "µm"),
            PageColumn::number("Crowning", "µm"),
        ],
        rows: rows.collect(),
        note: draws,
    }
}

fn refusals<'a>(all: impl Iterator<Item = (&'a str, Option<&'a Refused>)>) -> String {
    all.filter_map(|(bodies, refused)| {
        let refused = refused?;
        Some(format!("{}: {} ({}). ", label(bodies), refused.text, refused.way_out))
    })
    .collect()
}
