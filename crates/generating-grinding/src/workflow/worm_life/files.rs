//! `explore.json`, `explore.csv` and `explore.html` of a worm over its life. Every file appears whole or not at all.

use super::{PlanOfLife, WormLifeOutcome, WormOfLife};
use foundation::geometry::Flank;
use job::{Cell, Column, CsvError, CsvTable};
use report::charts::{ChartError, LineChart, Panel, Series, format_fixed, format_significant, line_chart};
use report::{Banner, Block, Column as PageColumn, Fact, Figure, PlanReport, Section, Stamp, Table, html};
use run::{WriteError, write_study};
use std::path::{Path, PathBuf};

/// Writes the files of a study into `directory` (made if missing); returns their paths, the page last.
///
/// # Errors
/// [`WriteError`]; files written before the error stay.
pub fn write_worm_life(outcome: &WormLifeOutcome, directory: &Path) -> Result<Vec<PathBuf>, WriteError> {
    write_study(outcome, table(outcome)?.text(), &html::render(&page(outcome)?), directory)
}

/// A figure of a plan with its column and its title in charts.
type Quantity = (Column, &'static str, fn(&PlanOfLife) -> f64);

const QUANTITIES: [Quantity; 7] = [
    (Column::new("deviation", "um"), "largest deviation [µm]", |p| p.deviation_um),
    (Column::new("diagonal_ratio", ""), "diagonal ratio K", |p| p.diagonal_ratio),
    (Column::new("crossed_axes_angle", "deg"), "crossed-axes angle [°]", |p| p.crossed_axes_angle_deg),
    (Column::new("centre_distance", "mm"), "centre distance [mm]", |p| p.centre_distance_mm),
    (Column::new("used_width", "mm"), "used worm width [mm]", |p| p.used_width_mm),
    (Column::new("worm_speed", "rpm"), "worm speed [1/min]", |p| p.worm_speed_rpm),
    (Column::new("least_determinant_ratio", ""), "least determinant ratio", |p| p.least_determinant_ratio),
];

/// Corrections of dressing of one flank, with their titles in charts.
type OfDressing = (&'static str, fn(&super::DressingOfLife) -> f64);

const DRESSING: [OfDressing; 4] = [
    ("Δφ_S [°]", |d| d.d_phi_s_deg),
    ("Δγ [°]", |d| d.d_gamma_deg),
    ("Δd [mm]", |d| d.d_d_mm),
    ("Δv_yA [mm]", |d| d.d_v_ya_mm),
];

const OF_FLANKS: [[Column; 4]; 2] = [
    [
        Column::new("left_d_phi_S", "deg"),
        Column::new("left_d_gamma", "deg"),
        Column::new("left_d_d", "mm"),
        Column::new("left_d_v_yA", "mm"),
    ],
    [
        Column::new("right_d_phi_S", "deg"),
        Column::new("right_d_gamma", "deg"),
        Column::new("right_d_d", "mm"),
        Column::new("right_d_v_yA", "mm"),
    ],
];

fn table(outcome: &WormLifeOutcome) -> Result<CsvTable, CsvError> {
    let mut columns = vec![Column::new("tip_diameter", "mm"), Column::new("status", "")];
    columns.extend(QUANTITIES.iter().map(|(column, ..)| *column));
    columns.extend(OF_FLANKS.iter().flatten().copied());
    let mut table = CsvTable::new(&columns);
    for worm in &outcome.worms {
        let mut row = vec![Cell::Number(worm.tip_diameter_mm), Cell::Word(status(worm))];
        let number = |value: Option<f64>| value.map_or(Cell::Empty, Cell::Number);
        row.extend(QUANTITIES.iter().map(|(_, _, value)| number(worm.plan.as_ref().map(value))));
        for flank in Flank::BOTH {
            let dressing = worm.plan.as_ref().and_then(|plan| plan.dressing[flank].as_ref());
            row.extend(DRESSING.iter().map(|(_, value)| number(dressing.map(value))));
        }
        table.push_cells(&row)?;
    }
    Ok(table)
}

fn status(worm: &WormOfLife) -> &'static str {
    match (&worm.plan, &worm.refused) {
        (Some(plan), _) => plan.status.words(),
        (None, Some(refused)) => refused.code,
        (None, None) => "",
    }
}

/// Plans with their tip diameters.
fn plans(outcome: &WormLifeOutcome) -> Vec<(f64, &PlanOfLife)> {
    outcome.worms.iter().filter_map(|worm| Some((worm.tip_diameter_mm, worm.plan.as_ref()?))).collect()
}

fn series(name: &str, points: &[(f64, f64)]) -> Series {
    Series::new(name, points.iter().map(|(x, _)| *x).collect(), points.iter().map(|(_, y)| *y).collect())
}

fn chart(title: &str, panels: Vec<Panel>) -> LineChart {
    LineChart { title: title.to_owned(), x_title: "Tip diameter of the worm [mm]".to_owned(), panels }
}

/// The page of a study.
///
/// # Errors
/// [`ChartError`] for numbers that cannot be drawn.
pub fn page(outcome: &WormLifeOutcome) -> Result<PlanReport, ChartError> {
    let plans = plans(outcome);
    let mut sections = Vec::new();
    if let (Some((most, _)), Some((least, _))) = (plans.first(), plans.last())
        && most > least
    {
        let of = |value: fn(&PlanOfLife) -> f64| -> Vec<(f64, f64)> {
            plans.iter().map(|(x, plan)| (*x, value(plan))).collect()
        };
        let panel = |(k, (_, title, value)): (usize, &Quantity)| {
            let mut lines = vec![series("worm", &of(*value))];
            if k == 0 {
                let name = format!("tolerance {} µm", format_significant(outcome.tolerance_um, 4));
                lines = vec![
                    series("as made", &of(*value)),
                    Series::level(name, [*least, *most], outcome.tolerance_um),
                ];
            }
            Panel::linear(*title, 0.0, lines)
        };
        let panels = QUANTITIES[..6].iter().enumerate().map(panel).collect();
        let figure = Figure::new(
            "worm-over-its-life",
            line_chart(&chart("One worm over its life", panels))?,
            "Each diameter is planned by itself, dressed by the dresser of the new worm, and judged by simulated material removal.",
        );
        sections.push(Section::new("life", "Life", vec![Block::Figure(figure)]));
        let corrections = |(title, value): &OfDressing| {
            let of_flank = |flank: Flank| {
                let points: Vec<(f64, f64)> = plans
                    .iter()
                    .filter_map(|(x, plan)| Some((*x, value(plan.dressing[flank].as_ref()?))))
                    .collect();
                (!points.is_empty()).then(|| series(flank.name(), &points))
            };
            Panel::linear(*title, 0.0, Flank::BOTH.into_iter().filter_map(of_flank).collect())
        };
        if plans.iter().any(|(_, plan)| plan.dressing.iter().any(|(_, dressing)| dressing.is_some())) {
            let panels = DRESSING.iter().map(corrections).collect();
            let figure = Figure::new(
                "corrections-of-dressing-over-the-life",
                line_chart(&chart("Corrections of dressing over the life", panels))?,
                "In the middle of the dressing stroke, against the nominal kinematics of each worm.",
            );
            sections.push(Section::new("dressing", "Dressing", vec![Block::Figure(figure)]));
        }
    }
    sections.push(Section::new("diameters", "Diameters", vec![Block::Table(rows(outcome))]));
    let status = if plans.is_empty() { Stamp::NotProducible } else { Stamp::Study };
    let mut figures =
        vec![Fact::new("Tolerance", format!("{} µm", format_significant(outcome.tolerance_um, 4)))];
    figures.extend(
        outcome
            .last_usable_tip_diameter_mm
            .map(|last| Fact::new("Last usable tip diameter", format!("{} mm", format_fixed(last, 2)))),
    );
    Ok(outcome.head.clone().page(Banner { status, headline: outcome.headline(), figures }, sections))
}

fn rows(outcome: &WormLifeOutcome) -> Table {
    let row = |worm: &WormOfLife| {
        let mut row = vec![format_fixed(worm.tip_diameter_mm, 2)];
        match (&worm.plan, &worm.refused) {
            (Some(plan), _) => {
                row.push(plan.status.words().to_owned());
                for ((_, _, value), digits) in QUANTITIES.iter().zip([3, 4, 4, 3, 1, 0, 2]) {
                    row.push(format_fixed(value(plan), digits));
                }
                row.push(plan.reason.as_ref().map_or_else(String::new, |reason| reason.text.clone()));
            }
            (None, Some(refused)) => row.push(refused.text.clone()),
            (None, None) => {}
        }
        row
    };
    Table {
        caption: String::new(),
        columns: vec![
            PageColumn::number("Tip diameter", "mm"),
            PageColumn::text("Verdict"),
            PageColumn::number("Deviation", "µm"),
            PageColumn::number("K", ""),
            PageColumn::number("Crossing", "°"),
            PageColumn::number("Centre distance", "mm"),
            PageColumn::number("Worm used", "mm"),
            PageColumn::number("Worm speed", "1/min"),
            PageColumn::number("Least det.", ""),
            PageColumn::text("Why not met"),
        ],
        rows: outcome.worms.iter().map(row).collect(),
        note: "Settings of each diameter stand in explore.json, corrections in explore.csv. The flank is judged; programs, stock and control are not made for the diameters.".into(),
    }
}
