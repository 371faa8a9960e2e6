//! `explore.json`, `explore.csv` and `explore.html` of a study. Every file appears whole or not at all.

use super::axes::{Axes, Varied};
use super::{ExploreCandidate, ExploreOutcome};
use foundation::geometry::Flank;
use foundation::numerics::extremes;
use job::{Cell, Column, CsvError, CsvTable};
use report::charts::{ChartError, LineChart, Panel, Series, Svg, YScale, format_significant, line_chart};
use report::{Banner, Block, Column as PageColumn, Fact, Figure, PlanReport, Section, Stamp, Table, html};
use run::{WriteError, write_study};
use std::path::{Path, PathBuf};

/// Lines of the chart; of more worms those with the best candidates are drawn.
const LINES: usize = 6;
/// Rows of the table on the page; all of them stand in `explore.csv`.
const ROWS: usize = 200;

/// Writes the files of a study into `directory` (made if missing); returns their paths, the page last.
///
/// # Errors
/// [`WriteError`]; files written before the error stay.
pub fn write_exploration(outcome: &ExploreOutcome, directory: &Path) -> Result<Vec<PathBuf>, WriteError> {
    write_study(outcome, table(outcome)?.text(), &html::render(&page(outcome)?), directory)
}

/// All combinations in the order of the ranking.
fn table(outcome: &ExploreOutcome) -> Result<CsvTable, CsvError> {
    let mut columns = vec![
        Column::new("rank", ""),
        Column::new("worm_cone_angle", "deg"),
        Column::new("crossed_axes_angle", "deg"),
        Column::new("worm_pitch_diameter", "mm"),
        Column::new("diagonal_ratio", ""),
        Column::new("allowed", ""),
        Column::new("within_tolerance", ""),
        Column::new("residual", "um"),
        Column::new("score", ""),
        Column::new("worm_occupation", "mm"),
        Column::new("least_determinant_ratio", ""),
        Column::new("demanded_ratio_difference", ""),
    ];
    const PER_FLANK: [[&str; 3]; 2] = [
        ["left_max_residual", "left_rms_residual", "left_outside_class"],
        ["right_max_residual", "right_rms_residual", "right_outside_class"],
    ];
    columns.extend(PER_FLANK.iter().flatten().map(|name| Column::new(name, "um")));
    columns.push(Column::new("profile_crowning_by", ""));
    columns.push(Column::new("refused", ""));
    let mut table = CsvTable::new(&columns);
    let number = |x: Option<f64>| x.map_or(Cell::Empty, Cell::Number);
    let yes = |yes: bool| Cell::Word(if yes { "yes" } else { "no" });
    let word = |word: Option<&'static str>| word.map_or(Cell::Empty, Cell::Word);
    for c in &outcome.candidates {
        let mut row = vec![
            Cell::Number(c.rank as f64),
            Cell::Number(c.worm_cone_angle_deg),
            number(c.crossed_axes_angle_deg),
            number(c.worm_pitch_diameter_mm),
            number(c.diagonal_ratio),
            yes(c.allowed),
            yes(c.within_tolerance),
            number(c.residual_um),
            number(c.score),
            number(c.worm_occupation_mm),
            number(c.least_determinant_ratio),
            number(c.demanded_ratio_difference),
        ];
        for flank in Flank::BOTH {
            let figures = c.flanks.get(flank.name());
            row.push(number(figures.map(|f| f.max_residual_um)));
            row.push(number(figures.map(|f| f.rms_residual_um)));
            row.push(number(figures.map(|f| f.outside_class_um)));
        }
        row.push(word(c.profile_crowning_by));
        row.push(word(c.refused.as_ref().map(|r| r.code)));
        table.push_cells(&row)?;
    }
    Ok(table)
}

/// What varies: the abscissa is the ratio where it does, else the first angle that does.
const VARIED: [Varied<ExploreCandidate>; 3] = [
    ("diagonal_ratio", "diagonal ratio K", "K", |c| c.diagonal_ratio),
    ("worm_cone_angle_deg", "cone angle of the worm [°]", "cone", |c| Some(c.worm_cone_angle_deg)),
    ("crossed_axes_angle_deg", "crossed-axes angle [°]", "crossing", |c| c.crossed_axes_angle_deg),
];

/// The residual over the ratio; `None` where no combination has figures.
fn chart(outcome: &ExploreOutcome) -> Result<Option<(Svg, String)>, ChartError> {
    let Some(axes) = Axes::of(&VARIED, &outcome.varied) else { return Ok(None) };
    // The ranking brings the worms with the best candidates first. A combination that failed has an abscissa and no figures.
    let (mut lines, left_out) = axes.lines(&outcome.candidates, LINES, ("°", "residual"), |c, x| {
        Some((x, c.residual_um.map(|residual| (residual, c.allowed))))
    });
    let mut series = Vec::new();
    for (name, points) in &mut lines {
        points.sort_by(|a, b| a.0.total_cmp(&b.0));
        // A combination without figures interrupts the line.
        for run in points.split(|(_, figures)| figures.is_none()).filter(|run| !run.is_empty()) {
            let x = run.iter().map(|(x, _)| *x).collect();
            let y = run.iter().filter_map(|(_, f)| f.map(|(residual, _)| residual)).collect();
            let filled = run.iter().filter_map(|(_, f)| f.map(|(_, allowed)| allowed)).collect();
            series.push(Series::new(name.clone(), x, y).marked(filled));
        }
    }
    let ends = extremes(series.iter().flat_map(|s| s.x.iter().copied()));
    if ends[0] > ends[1] {
        return Ok(None);
    }
    let tolerance = format!("tolerance {} µm", format_significant(outcome.tolerance_um, 4));
    series.push(Series::level(tolerance, ends, outcome.tolerance_um));
    let panel = Panel {
        scale: YScale::Logarithmic,
        ..Panel::linear("largest residual on the ideal tool [µm]", 0.0, series)
    };
    let svg = line_chart(&LineChart {
        title: "Residual of the candidates".into(),
        x_title: axes.title.into(),
        panels: vec![panel],
    })?;
    let mut caption =
        "Largest deviation from the target on the planning grid with an ideal tool. Filled: allowed; open: refused.".to_string();
    if left_out {
        caption += " Drawn are the worms with the best candidates only.";
    }
    Ok(Some((svg, caption)))
}

/// A figure of a candidate with so many significant digits; nothing where it has none.
pub fn figure_text(x: Option<f64>, digits: usize) -> String {
    x.map_or_else(String::new, |x| format_significant(x, digits))
}

/// The page of a study.
///
/// # Errors
/// [`ChartError`] for numbers that cannot be drawn.
pub fn page(outcome: &ExploreOutcome) -> Result<PlanReport, ChartError> {
    let best = outcome.candidates.first();
    let headline = format!(
        "{} of {} combinations are allowed. The figures are those of the first one of the ranking.",
        outcome.allowed,
        outcome.candidates.len()
    );
    let status = if outcome.is_producible() { Stamp::Study } else { Stamp::NotProducible };
    let figures = best.map_or_else(Vec::new, |c| {
        vec![
            Fact::new("Cone angle", format!("{}°", format_significant(c.worm_cone_angle_deg, 6))),
            Fact::new("Crossed-axes angle", format!("{}°", figure_text(c.crossed_axes_angle_deg, 6))),
            Fact::new("Diagonal ratio", figure_text(c.diagonal_ratio, 6)),
            Fact::new("Residual", format!("{} µm", figure_text(c.residual_um, 3))),
            Fact::new("Worm used", format!("{} mm", figure_text(c.worm_occupation_mm, 4))),
        ]
    });
    let mut sections = Vec::new();
    if let Some((svg, caption)) = chart(outcome)? {
        sections.push(Section::new(
            "residual",
            "Residual",
            vec![Block::Figure(Figure::new("residual-of-the-candidates", svg, caption))],
        ));
    }
    if !outcome.levers.is_empty() {
        sections.push(Section::new(
            "worms-with-one-ratio-for-both-flanks",
            "Worms with one ratio for both flanks",
            vec![Block::Table(levers(outcome))],
        ));
    }
    sections.push(Section::new("ranking", "Ranking", vec![Block::Table(ranking(outcome))]));
    let tolerance = Fact::new("Tolerance", format!("{} µm", format_significant(outcome.tolerance_um, 4)));
    let figures = figures.into_iter().chain([tolerance]).collect();
    Ok(outcome.head.clone().page(Banner { status, headline, figures }, sections))
}

fn levers(outcome: &ExploreOutcome) -> Table {
    let rows = outcome
        .levers
        .iter()
        .map(|offer| vec![offer.in_words(), format_significant(offer.diagonal_ratio, 6)]);
    Table {
        caption: String::new(),
        columns: vec![PageColumn::text("Worm with"), PageColumn::number("K", "")],
        rows: rows.collect(),
        note: "Tool lines as given in the job, else along the generatrix; dressed lines shift the values slightly.".into(),
    }
}

fn ranking(outcome: &ExploreOutcome) -> Table {
    let rows = outcome.candidates.iter().take(ROWS).map(|c| {
        vec![
            c.rank.to_string(),
            format_significant(c.worm_cone_angle_deg, 6),
            figure_text(c.crossed_axes_angle_deg, 6),
            figure_text(c.diagonal_ratio, 6),
            figure_text(c.residual_um, 4),
            figure_text(c.score, 3),
            figure_text(c.worm_occupation_mm, 5),
            figure_text(c.least_determinant_ratio, 3),
            figure_text(c.demanded_ratio_difference, 4),
            c.refused.as_ref().map_or_else(|| "allowed".into(), |r| r.text.clone()),
        ]
    });
    let rest = outcome.candidates.len().saturating_sub(ROWS);
    let more = if rest > 0 { format!(" More rows in explore.csv: {rest}.") } else { String::new() };
    Table {
        caption: String::new(),
        columns: vec![
            PageColumn::number("Rank", ""),
            PageColumn::number("Cone", "°"),
            PageColumn::number("Crossing", "°"),
            PageColumn::number("K", ""),
            PageColumn::number("Residual", "µm"),
            PageColumn::number("Score", ""),
            PageColumn::number("Worm used", "mm"),
            PageColumn::number("Least det.", ""),
            PageColumn::number("|K left − K right|", ""),
            PageColumn::text("Verdict"),
        ],
        rows: rows.collect(),
        note: format!("Ranking: {}.{more}", outcome.ranking),
    }
}
