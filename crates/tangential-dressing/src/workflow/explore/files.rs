//! `explore.json`, `explore.csv` and `explore.html` of a study. Every file appears whole or not at all.

use super::{TangentialCandidate, TangentialExploration};
use foundation::geometry::Flank;
use foundation::numerics::extremes;
use generating_grinding::workflow::explore::{Axes, Varied, figure_text};
use job::{Cell, Column, CsvError, CsvTable};
use report::charts::{ChartError, LineChart, Panel, Series, Svg, YScale, format_significant, line_chart};
use report::{Banner, Block, Column as PageColumn, Fact, Figure, PlanReport, Section, Stamp, Table, html};
use run::{WriteError, write_study};
use std::path::{Path, PathBuf};

/// Lines of the chart; of more bodies those with the best candidates are drawn.
const LINES: usize = 6;
/// Rows of the table on the page; all of them stand in `explore.csv`.
const ROWS: usize = 200;

/// Writes the files of a study into `directory` (made if missing); returns their paths, the page last.
///
/// # Errors
/// [`WriteError`]; files written before the error stay.
pub(super) fn write_exploration(
    outcome: &TangentialExploration,
    directory: &Path,
) -> Result<Vec<PathBuf>, WriteError> {
    write_study(outcome, table(outcome)?.text(), &html::render(&page(outcome)?), directory)
}

/// All combinations in the order of the ranking.
fn table(outcome: &TangentialExploration) -> Result<CsvTable, CsvError> {
    let mut columns = vec![
        Column::new("rank", ""),
        Column::new("worm_threads", ""),
        Column::new("worm_tip_diameter", "mm"),
        Column::new("dresser_tip_diameter", "mm"),
        Column::new("shift_ratio", ""),
        Column::new("met", ""),
        Column::new("max_deviation", "um"),
        Column::new("variables", ""),
        Column::new("worm_length", "mm"),
    ];
    const PER_FLANK: [[&str; 3]; 2] = [
        ["left_max_deviation", "left_least_determinant_ratio", "left_worm_modification"],
        ["right_max_deviation", "right_least_determinant_ratio", "right_worm_modification"],
    ];
    for [deviation, determinant, worm] in PER_FLANK {
        columns.extend([Column::new(deviation, "um"), Column::new(determinant, ""), Column::new(worm, "um")]);
    }
    columns.push(Column::new("refused", ""));
    let mut table = CsvTable::new(&columns);
    let number = |x: Option<f64>| x.map_or(Cell::Empty, Cell::Number);
    for c in &outcome.candidates {
        let mut row = vec![
            Cell::Number(c.rank as f64),
            Cell::Number(f64::from(c.worm_threads)),
            number(c.worm_tip_diameter_mm),
            Cell::Number(c.dresser_tip_diameter_mm),
            number(c.shift_ratio),
            Cell::Word(if c.met { "yes" } else { "no" }),
            number(c.max_deviation_um),
            number(c.variables.map(|n| n as f64)),
            number(c.worm_length_mm),
        ];
        for flank in Flank::BOTH {
            let figures = c.flanks.get(flank.name());
            row.push(number(figures.map(|f| f.max_deviation_um)));
            row.push(number(figures.map(|f| f.least_determinant_ratio)));
            row.push(number(figures.map(|f| f.worm_modification_um)));
        }
        row.push(c.refused.as_ref().map_or(Cell::Empty, |refused| Cell::Word(refused.code)));
        table.push_cells(&row)?;
    }
    Ok(table)
}

/// What may vary.
const VARIED: [Varied<TangentialCandidate>; 4] = [
    ("shift_ratio", "tool shift per feed", "κ", |c| c.shift_ratio),
    ("worm_tip_diameter", "tip diameter of the worm [mm]", "worm", |c| c.worm_tip_diameter_mm),
    ("dresser_tip_diameter", "tip diameter of the dresser [mm]", "dresser", |c| {
        Some(c.dresser_tip_diameter_mm)
    }),
    ("worm_threads", "threads of the worm", "threads", |c| Some(f64::from(c.worm_threads))),
];

/// The deviation over what varies first; `None` where no combination has figures.
fn chart(outcome: &TangentialExploration) -> Result<Option<Svg>, ChartError> {
    let Some(axes) = Axes::of(&VARIED, &outcome.varied) else { return Ok(None) };
    let (lines, _) = axes
        .lines(&outcome.candidates, LINES, ("", "Deviation"), |c, x| Some((x, c.max_deviation_um?, c.met)));
    let mut series = Vec::new();
    for (name, mut points) in lines {
        points.sort_by(|a, b| a.0.total_cmp(&b.0));
        let filled = points.iter().map(|p| p.2).collect();
        let (x, y) = points.iter().map(|p| (p.0, p.1)).unzip();
        series.push(Series::new(name, x, y).marked(filled));
    }
    let ends = extremes(series.iter().flat_map(|s| s.x.iter().copied()));
    if ends[0] > ends[1] {
        return Ok(None);
    }
    let tolerance = format!("tolerance {} µm", format_significant(outcome.tolerance_um, 4));
    series.push(Series::level(tolerance, ends, outcome.tolerance_um));
    let panel = Panel { scale: YScale::Logarithmic, ..Panel::linear("largest deviation [µm]", 0.0, series) };
    line_chart(&LineChart {
        title: "Deviation of the candidates".into(),
        x_title: axes.title.into(),
        panels: vec![panel],
    })
    .map(Some)
}

/// The page of a study.
///
/// # Errors
/// [`ChartError`] for numbers that cannot be drawn.
pub fn page(outcome: &TangentialExploration) -> Result<PlanReport, ChartError> {
    let headline = format!(
        "{} of {} combinations are within the tolerance. The figures are those of the first one of the ranking.",
        outcome.met,
        outcome.candidates.len()
    );
    let best = outcome.candidates.first();
    let made = best.is_some_and(|c| c.refused.is_none());
    let mut figures = best.map_or_else(Vec::new, |c| {
        let mm = |x: Option<f64>| format!("{} mm", figure_text(x, 6));
        vec![
            Fact::new("Threads", c.worm_threads.to_string()),
            Fact::new("Worm tip diameter", mm(c.worm_tip_diameter_mm)),
            Fact::new("Dresser tip diameter", mm(Some(c.dresser_tip_diameter_mm))),
            Fact::new("Tool shift per feed", figure_text(c.shift_ratio, 6)),
            Fact::new("Deviation", format!("{} µm", figure_text(c.max_deviation_um, 3))),
            Fact::new("Worm used", mm(c.worm_length_mm)),
        ]
    });
    figures.push(Fact::new("Tolerance", format!("{} µm", format_significant(outcome.tolerance_um, 4))));
    let mut sections = Vec::new();
    if let Some(svg) = chart(outcome)? {
        let caption = "Largest deviation of the planned flanks from the target. Filled: within the tolerance. Of many bodies those with \
                       the best candidates are drawn.";
        let figure = Figure::new("deviation-of-the-candidates", svg, caption);
        sections.push(Section::new("deviation", "Deviation", vec![Block::Figure(figure)]));
    }
    sections.push(Section::new("ranking", "Ranking", vec![Block::Table(ranking(outcome))]));
    let status = if made { Stamp::Study } else { Stamp::NotProducible };
    Ok(outcome.head.clone().page(Banner { status, headline, figures }, sections))
}

fn ranking(outcome: &TangentialExploration) -> Table {
    let rows = outcome.candidates.iter().take(ROWS).map(|c| {
        vec![
            c.rank.to_string(),
            c.worm_threads.to_string(),
            figure_text(c.worm_tip_diameter_mm, 6),
            format_significant(c.dresser_tip_diameter_mm, 6),
            figure_text(c.shift_ratio, 6),
            figure_text(c.max_deviation_um, 4),
            c.variables.map_or_else(String::new, |n| n.to_string()),
            figure_text(c.worm_length_mm, 5),
            figure_text(c.least_determinant_ratio(), 3),
            c.refused.as_ref().map_or_else(|| c.verdict().into(), |refused| refused.text.clone()),
        ]
    });
    let rest = outcome.candidates.len().saturating_sub(ROWS);
    let more = if rest > 0 { format!(" More rows in explore.csv: {rest}.") } else { String::new() };
    Table {
        caption: String::new(),
        columns: vec![
            PageColumn::number("Rank", ""),
            PageColumn::number("Threads", ""),
            PageColumn::number("Worm tip", "mm"),
            PageColumn::number("Dresser tip", "mm"),
            PageColumn::number("κ", ""),
            PageColumn::number("Deviation", "µm"),
            PageColumn::number("Variables", ""),
            PageColumn::number("Worm used", "mm"),
            PageColumn::number("Least det.", ""),
            PageColumn::text("Verdict"),
        ],
        rows: rows.collect(),
        note: format!("Ranking: {}.{more}", outcome.ranking),
    }
}
