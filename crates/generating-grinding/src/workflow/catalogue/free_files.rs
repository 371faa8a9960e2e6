//! `explore.json`, `explore.csv` and `explore.html` of a catalogue with a free quantity. Every file appears whole or not at all.

use super::files::{fixed, percent};
use super::free::{FreeOutcome, FreePair, FreePoint};
use job::{Cell, Column, CsvError, CsvTable};
use report::charts::{ChartError, LineChart, Panel, Series, Svg, YScale, format_significant, line_chart};
use report::{Banner, Block, Column as PageColumn, Fact, Figure, PlanReport, Section, Stamp, Table, html};
use run::{WriteError, write_study};
use std::path::{Path, PathBuf};

/// Lines of the chart: the pairs that need least.
const LINES: usize = 6;

/// Writes the files of a study into `directory` (made if missing); returns their paths, the page last.
///
/// # Errors
/// [`WriteError`]; files written before the error stay.
pub fn write_free_study(outcome: &FreeOutcome, directory: &Path) -> Result<Vec<PathBuf>, WriteError> {
    write_study(outcome, table(outcome)?.text(), &html::render(&page(outcome)?), directory)
}

/// Name and unit of the free quantity.
fn quantity(outcome: &FreeOutcome) -> (&'static str, &'static str) {
    match outcome.free {
        "pitch-diameter" => ("pitch diameter of the worm", "mm"),
        "pressure-angle" => ("normal pressure angle of the worm", "°"),
        _ => ("number of threads of the worm", ""),
    }
}

/// All values of all pairs.
fn table(outcome: &FreeOutcome) -> Result<CsvTable, CsvError> {
    let unit = match outcome.free {
        "pitch-diameter" => "mm",
        "pressure-angle" => "deg",
        _ => "",
    };
    let mut table = CsvTable::new(&[
        Column::new("worm", ""),
        Column::new("dresser", ""),
        Column::new("value", unit),
        Column::new("ok", ""),
        Column::new("largest_share_of_limit", ""),
        Column::new("stretch", "percent"),
        Column::new("refused", ""),
    ]);
    let number = |x: Option<f64>| x.map_or(Cell::Empty, Cell::Number);
    for pair in &outcome.pairs {
        for p in &pair.points {
            table.push_cells(&[
                Cell::Word(&pair.worm),
                Cell::Word(&pair.dresser),
                Cell::Number(p.value),
                Cell::Word(if p.refused.is_none() { "yes" } else { "no" }),
                number(p.largest_share_of_limit),
                number(stretch(p)),
                p.refused.as_ref().map_or(Cell::Empty, |refused| Cell::Word(refused.code)),
            ])?;
        }
    }
    Ok(table)
}

/// Stretch of largest magnitude in percent.
fn stretch(p: &FreePoint) -> Option<f64> {
    p.flanks.values().map(|f| 100.0 * f.stretch).max_by(|a, b| a.abs().total_cmp(&b.abs()))
}

/// The page of the study.
///
/// # Errors
/// [`ChartError`] for numbers that cannot be drawn.
pub fn page(outcome: &FreeOutcome) -> Result<PlanReport, ChartError> {
    let (name, unit) = quantity(outcome);
    let best = outcome.pairs.first().and_then(|pair| Some((pair, pair.best()?)));
    let figures = best.map_or_else(Vec::new, |(pair, at)| {
        vec![
            Fact::new("Dresser", pair.dresser.clone()),
            Fact::new("Worm, all else of", pair.worm.clone()),
            Fact::new("Best value", format!("{} {unit}", format_significant(at.value, 5))),
            Fact::new("Largest share of an axis limit", format!("{} %", percent(at.largest_share_of_limit))),
        ]
    });
    let mut sections = Vec::new();
    if let Some(svg) = chart(outcome)? {
        let caption = format!(
            "Largest share of an axis limit over the {name}, for the pairs that need least, at most {LINES}. Filled: the target is made; \
             open: something forbids it."
        );
        sections.push(Section::new(
            "share-of-the-limits",
            "Share of the limits",
            vec![Block::Figure(Figure::new("share-of-the-limits", svg, caption))],
        ));
    }
    sections.push(Section::new(
        "where-the-dressers-make-the-target",
        "Where the dressers make the target",
        vec![Block::Table(ranges(outcome))],
    ));
    let (working, all) = (outcome.working(), outcome.pairs.len());
    let asked = [
        Fact::new("Range", format!("{} to {} {unit}", outcome.range[0], outcome.range[1])),
        Fact::new("Tolerance", format!("{} µm", format_significant(outcome.tolerance_um, 4))),
    ];
    let banner = Banner {
        status: if working > 0 { Stamp::Study } else { Stamp::NotProducible },
        headline: format!("{working} of {all} pairs have a value that makes the profile."),
        figures: figures.into_iter().chain(asked).collect(),
    };
    Ok(outcome.head.clone().page(banner, sections))
}

fn chart(outcome: &FreeOutcome) -> Result<Option<Svg>, ChartError> {
    let (name, unit) = quantity(outcome);
    let mut series = Vec::new();
    for pair in outcome.pairs.iter().filter(|pair| !pair.ranges.is_empty()).take(LINES) {
        let known =
            |p: &FreePoint| p.largest_share_of_limit.map(|s| (p.value, 100.0 * s, p.refused.is_none()));
        // A value without figures interrupts the line.
        let points: Vec<Option<(f64, f64, bool)>> = pair.points.iter().map(known).collect();
        for run in points.split(Option::is_none).filter(|run| !run.is_empty()) {
            let run: Vec<(f64, f64, bool)> = run.iter().copied().flatten().collect();
            let x = run.iter().map(|p| p.0).collect();
            let line = Series::new(
                format!("{} · {}", pair.worm, pair.dresser),
                x,
                run.iter().map(|p| p.1).collect(),
            );
            series.push(line.marked(run.iter().map(|p| p.2).collect()));
        }
    }
    if series.is_empty() {
        return Ok(None);
    }
    series.push(Series::level("limit", outcome.range, 100.0));
    let panel = Panel {
        scale: YScale::Logarithmic,
        ..Panel::linear("largest share of an axis limit [%]", 0.0, series)
    };
    let x_title = if unit.is_empty() { name.to_string() } else { format!("{name} [{unit}]") };
    let chart = LineChart { title: "Share of the limits".into(), x_title, panels: vec![panel] };
    line_chart(&chart).map(Some)
}

fn ranges(outcome: &FreeOutcome) -> Table {
    let (name, unit) = quantity(outcome);
    let decimals = match outcome.free {
        "threads" => 0,
        "pressure-angle" => 3,
        _ => 2,
    };
    let mut rows = Vec::new();
    for pair in &outcome.pairs {
        for r in &pair.ranges {
            rows.push(vec![
                pair.dresser.clone(),
                pair.worm.clone(),
                fixed(Some(r.from), decimals),
                fixed(Some(r.to), decimals),
                fixed(Some(r.best.value), decimals),
                percent(r.best.largest_share_of_limit),
                fixed(stretch(&r.best), 2),
                String::new(),
            ]);
        }
        if pair.ranges.is_empty() {
            let mut row = vec![pair.dresser.clone(), pair.worm.clone()];
            row.resize(7, "–".into());
            row.push(nearest(pair));
            rows.push(row);
        }
    }
    Table {
        caption: String::new(),
        columns: vec![
            PageColumn::name("Dresser"),
            PageColumn::name("Worm"),
            PageColumn::number("From", unit),
            PageColumn::number("To", unit),
            PageColumn::number("Best", unit),
            PageColumn::number("Limit", "%"),
            PageColumn::number("P", "%"),
            PageColumn::text("Why not"),
        ],
        rows,
        note: format!(
            "The {name} is free; all else is as the catalogue has it. Limit: largest share of an axis limit at the best value."
        ),
    }
}

/// Why a pair has no range: at the value of least share of a limit, else of the first value.
fn nearest(pair: &FreePair) -> String {
    if let Some(refused) = &pair.refused {
        return refused.text.clone();
    }
    let share = |p: &&FreePoint| p.largest_share_of_limit.unwrap_or(f64::INFINITY);
    let point = pair.points.iter().min_by(|a, b| share(a).total_cmp(&share(b)));
    let Some((at, refused)) = point.and_then(|p| Some((p.value, p.refused.as_ref()?))) else {
        return String::new();
    };
    format!("at {}: {}", format_significant(at, 5), refused.text)
}
