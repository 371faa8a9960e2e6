//! `explore.json`, `explore.csv` and `explore.html` of a dressing study. Every file appears whole or not at all.

use super::axis_files::{
    deviation_chart, deviation_figures, deviation_table, quantile_figures, stroke_chart, stroke_figures,
    stroke_table,
};
use super::worm_files::{worm_figures, worm_table, worms_missing};
use super::{CrowningCurve, CrowningPoint, DressingStudyOutcome, ProfileCurve, StudyCurves};
use crate::workflow::explore::Refused;
use job::{Cell, Column, CsvError, CsvTable};
use report::charts::{ChartError, LineChart, Panel, Series, Svg, format_significant, line_chart};
use report::kebab;
use report::{Banner, Block, Column as PageColumn, Fact, Figure, PlanReport, Section, Stamp, Table, html};
use run::{WriteError, write_study};
use std::path::{Path, PathBuf};

/// Writes the files of a study into `directory` (made if missing); returns their paths, the page last.
///
/// # Errors
/// [`WriteError`]; files written before the error stay.
pub fn write_dressing_study(
    outcome: &DressingStudyOutcome,
    directory: &Path,
) -> Result<Vec<PathBuf>, WriteError> {
    write_study(outcome, table(outcome)?.text(), &html::render(&page(outcome)?), directory)
}

/// All points of all curves.
fn table(outcome: &DressingStudyOutcome) -> Result<CsvTable, CsvError> {
    match &outcome.curves {
        StudyCurves::Crowning(curves) => crowning_table(curves),
        StudyCurves::Profile(curves) => profile_table(curves),
        StudyCurves::Worms(curves) => worm_table(curves),
        StudyCurves::Strokes(curves) => stroke_table(curves),
        StudyCurves::Deviations(curves) => deviation_table(curves),
    }
}

/// A quantity of a point with its name and unit in tables, and its title in charts.
type Quantity = (Column, &'static str, fn(&CrowningPoint) -> f64);

/// Quantities over the crowning, in the order of the figures of `docs/mathematics/dressing.md#how-it-is-verified`.
const QUANTITIES: [Quantity; 8] = [
    (Column::new("d_phi_S", "deg"), "Δφ_S [°]", |p| p.d_phi_s_deg),
    (Column::new("d_gamma", "deg"), "Δγ [°]", |p| p.d_gamma_deg),
    (Column::new("d_d", "mm"), "Δd [mm]", |p| p.d_d_mm),
    (Column::new("d_v_yA", "mm"), "Δv_yA [mm]", |p| p.d_v_ya_mm),
    (Column::new("v_zS", "mm"), "v_zS [mm]", |p| p.v_zs_mm),
    (Column::new("stretch", "percent"), "profile stretch P [%]", |p| 100.0 * p.stretch),
    (Column::new("rho", "deg"), "direction of the contact line ρ [°]", |p| p.rho_deg),
    (Column::new("deviation_from_parabola", "um"), "deviation from the parabola [µm]", |p| p.deviation_um),
];

fn crowning_table(curves: &[CrowningCurve]) -> Result<CsvTable, CsvError> {
    let mut columns = vec![Column::new("bodies", ""), Column::new("crowning", "um")];
    columns.extend(QUANTITIES.iter().map(|(column, ..)| *column));
    let mut table = CsvTable::new(&columns);
    for curve in curves {
        for point in &curve.points {
            let mut row = vec![Cell::Word(&curve.bodies), Cell::Number(point.crowning_um)];
            row.extend(QUANTITIES.iter().map(|(_, _, value)| Cell::Number(value(point))));
            table.push_cells(&row)?;
        }
    }
    Ok(table)
}

fn profile_table(curves: &[ProfileCurve]) -> Result<CsvTable, CsvError> {
    let mut table = CsvTable::new(&[
        Column::new("curve", ""),
        Column::new("w", "mm"),
        Column::new("f_n", "um"),
        Column::new("shift", "mm"),
        Column::new("b", "mm"),
        Column::new("r_A", "mm"),
    ]);
    for c in curves {
        for i in 0..c.w_mm.len() {
            let numbers = [c.w_mm[i], c.f_n_um[i], c.shift_mm[i], c.b_mm[i], c.r_a_mm[i]];
            let mut row = vec![Cell::Word(&c.name)];
            row.extend(numbers.map(Cell::Number));
            table.push_cells(&row)?;
        }
    }
    Ok(table)
}

/// A curve's name in the legend; a study without comparison has one curve.
pub fn label(bodies: &str) -> String {
    if bodies.is_empty() { "worm and dresser of the job".into() } else { bodies.into() }
}

/// The axis corrections with the axial position, and stretch, direction and deviation below: `None` without points.
fn crowning_chart(
    title: &str,
    curves: &[CrowningCurve],
    quantities: &[Quantity],
) -> Result<Option<Svg>, ChartError> {
    if curves.iter().all(|c| c.points.is_empty()) {
        return Ok(None);
    }
    let panel = |(_, title, value): &Quantity| {
        let drawn = curves.iter().filter(|c| !c.points.is_empty());
        let series = drawn.map(|c| {
            let x = c.points.iter().map(|p| p.crowning_um).collect();
            Series::new(label(&c.bodies), x, c.points.iter().map(value).collect())
        });
        Panel::linear(*title, 0.0, series.collect())
    };
    let panels = quantities.iter().map(panel).collect();
    let chart =
        LineChart { title: title.into(), x_title: "profile crowning on the gear c_αV [µm]".into(), panels };
    line_chart(&chart).map(Some)
}

/// Modification, shift of the points and contact line over the length of roll: `None` without points.
fn profile_chart(curves: &[ProfileCurve]) -> Result<Option<Svg>, ChartError> {
    let drawn: Vec<&ProfileCurve> = curves.iter().filter(|c| c.refused.is_none()).collect();
    if drawn.is_empty() {
        return Ok(None);
    }
    let panel = |title: &str, least: f64, value: fn(&ProfileCurve) -> &Vec<f64>| {
        let series = drawn.iter().map(|c| {
            let marks = vec![true; c.w_mm.len()];
            Series::new(c.name.clone(), c.w_mm.clone(), value(c).clone()).marked(marks)
        });
        Panel::linear(title, least, series.collect())
    };
    let chart = LineChart {
        title: "Dressed profile".into(),
        x_title: "length of roll on the worm w_FS [mm]".into(),
        panels: vec![
            panel("normal modification f_nFS [µm]", 0.1, |c| &c.f_n_um),
            panel("shift of the point on the worm [mm]", 0.01, |c| &c.shift_mm),
            panel("contact line b [mm]", 0.1, |c| &c.b_mm),
        ],
    };
    line_chart(&chart).map(Some)
}

/// The page of a study.
///
/// # Errors
/// [`ChartError`] for numbers that cannot be drawn.
pub fn page(outcome: &DressingStudyOutcome) -> Result<PlanReport, ChartError> {
    let mut sections = Vec::new();
    let mut figure = |title: &str, id: &str, svg: Option<Svg>, caption: &str| {
        if let Some(svg) = svg {
            let block = Block::Figure(Figure::new(id, svg, caption));
            sections.push(Section::new(kebab(title), title, vec![block]));
        }
    };
    let result = match &outcome.curves {
        StudyCurves::Crowning(curves) => {
            figure(
                "Corrections",
                "corrections-of-dressing-over-the-profile-crowning",
                crowning_chart(
                    "Corrections of dressing over the profile crowning",
                    curves,
                    &QUANTITIES[..5],
                )?,
                "Three-point method with the radius map: ends and middle of the profile are met, the dresser radius made for the \
                 largest length of roll stays there. By v_zS the contact line passes through the middle of the profile at worm z = 0.",
            );
            figure(
                "Profile",
                "profile-stretch-contact-line-and-deviation",
                crowning_chart("Profile stretch, contact line and deviation", curves, &QUANTITIES[5..])?,
                "P > 0: the profile is stretched. The deviation is the largest distance of the dressed profile from the parabola through \
                 its three points, normal to the flank.",
            );
            crowning_ends(curves)
        }
        StudyCurves::Profile(curves) => {
            figure(
                "Profile",
                "dressed-profile",
                profile_chart(curves)?,
                "Each point belongs to one radius of the dresser, the same radii in all curves; the shift is how far its point on the worm \
                 lies from the one it was made for. Here b is the worm z of the contact.",
            );
            profile_figures(curves)
        }
        StudyCurves::Worms(curves) => {
            for (title, id, svg, caption) in worm_figures(curves, outcome.over)? {
                figure(title, id, svg, caption);
            }
            worms_missing(curves)
        }
        StudyCurves::Strokes(curves) => {
            for curve in curves {
                figure(
                    "Strokes",
                    &kebab(&format!("strokes {}", curve.bodies)),
                    stroke_chart(curve)?,
                    "Each stroke lays an active area of the dresser on its range by three points and the end of the area on the end of the \
                     range. The finished profile is the least of all strokes.",
                );
            }
            stroke_figures(curves)
        }
        StudyCurves::Deviations(curves) => {
            figure(
                "Profile",
                "change-of-the-dressed-profile-by-deviations-of-the-axes",
                deviation_chart(curves)?,
                "Exact change of the dressed profile against the nominal kinematics, positive = material left.",
            );
            deviation_figures(curves)
        }
    };
    sections.push(Section::new("table", "Table", vec![Block::Table(result)]));
    if let StudyCurves::Deviations(curves) = &outcome.curves {
        sections.push(Section::new(
            "random-deviations",
            "Random deviations",
            vec![Block::Table(quantile_figures(curves))],
        ));
    }
    let status = if outcome.is_producible() { Stamp::Study } else { Stamp::NotProducible };
    let figures = vec![Fact::new("Flank", outcome.flank)];
    Ok(outcome.head.clone().page(Banner { status, headline: headline(outcome), figures }, sections))
}

fn headline(outcome: &DressingStudyOutcome) -> String {
    let refusals: Vec<&Refused> = match &outcome.curves {
        StudyCurves::Crowning(curves) => curves.iter().filter_map(|c| c.refused.as_ref()).collect(),
        StudyCurves::Profile(curves) => curves.iter().filter_map(|c| c.refused.as_ref()).collect(),
        StudyCurves::Worms(curves) => curves.iter().flat_map(|c| &c.missing).map(|(_, r)| r).collect(),
        StudyCurves::Strokes(curves) => curves.iter().filter_map(|c| c.refused.as_ref()).collect(),
        StudyCurves::Deviations(curves) => curves.iter().filter_map(|c| c.refused.as_ref()).collect(),
    };
    match refusals.first() {
        None => "All bodies of the study can be dressed.".into(),
        Some(first) => format!(
            "Bodies of the study that cannot be dressed: {}. The first one: {}.",
            refusals.len(),
            first.text
        ),
    }
}

/// Where the curves end and the largest corrections on the way.
fn crowning_ends(curves: &[CrowningCurve]) -> Table {
    let rows = curves.iter().map(|c| {
        let um =
            |p: Option<&CrowningPoint>| p.map_or_else(String::new, |p| format_significant(p.crowning_um, 5));
        let reason = |end: &Option<super::CurveEnd>| {
            end.as_ref().map_or_else(|| "end of the study".into(), |end| end.reason.clone())
        };
        let largest = |value: fn(&CrowningPoint) -> f64| {
            format_significant(c.points.iter().map(|p| value(p).abs()).fold(0.0, f64::max), 4)
        };
        vec![
            label(&c.bodies),
            um(c.points.first()),
            c.refused.as_ref().map_or_else(|| reason(&c.least), |r| r.text.clone()),
            um(c.points.last()),
            reason(&c.most),
            c.with_tip_land.as_ref().map_or_else(String::new, |ends| {
                let of = |end: &super::CurveEnd| {
                    format!("{} ({})", format_significant(end.crowning_um, 5), end.reason)
                };
                format!("{} .. {}", of(&ends[0]), of(&ends[1]))
            }),
            largest(|p| p.d_phi_s_deg),
            largest(|p| p.d_gamma_deg),
            largest(|p| p.d_d_mm),
            largest(|p| p.d_v_ya_mm),
        ]
    });
    Table {
        caption: String::new(),
        columns: vec![
            PageColumn::symbols("Bodies"),
            PageColumn::number("Least crowning", "µm"),
            PageColumn::text("Ends with"),
            PageColumn::number("Largest crowning", "µm"),
            PageColumn::text("Ends with"),
            PageColumn::text("With the tip land, µm"),
            PageColumn::number("max |Δφ_S|", "°"),
            PageColumn::number("max |Δγ|", "°"),
            PageColumn::number("max |Δd|", "mm"),
            PageColumn::number("max |Δv_yA|", "mm"),
        ],
        rows: rows.collect(),
        note: "All points stand in explore.csv.".into(),
    }
}

fn profile_figures(curves: &[ProfileCurve]) -> Table {
    let rows = curves.iter().map(|c| {
        let mut row = vec![c.name.clone()];
        match &c.point {
            Some(point) => {
                row.extend(QUANTITIES.iter().map(|(_, _, value)| format_significant(value(point), 5)));
            }
            None => row.push(c.refused.as_ref().map_or_else(String::new, |r| r.text.clone())),
        }
        row
    });
    let mut columns = vec![PageColumn::symbols("Curve")];
    columns.extend(QUANTITIES.iter().map(|(_, title, _)| PageColumn::symbols(*title)));
    Table {
        caption: String::new(),
        columns,
        rows: rows.collect(),
        note: "All points stand in explore.csv.".into(),
    }
}
