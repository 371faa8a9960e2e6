//! Sections of the page of a catalogue that is ranked by plans: what the plans leave, and crowning over the width. Knows no way to rank.

use super::files::{fixed, percent};
use super::outcome::{CatalogueOutcome, CataloguePair};
use super::width::CrowningAt;
use report::charts::{ChartError, LineChart, Panel, Series, format_significant, line_chart};
use report::{Block, Column, Fact, Figure, Section, Table};

/// Plans in the table of crownings, and lines in the chart.
const ROWS: usize = 40;
const LINES: usize = 3;

/// Figures of the plan of a pair for the banner.
pub fn plan_figures(pair: &CataloguePair) -> Vec<Fact> {
    let Some(plan) = &pair.plan else { return Vec::new() };
    vec![
        Fact::new("Largest deviation", format!("{} µm", fixed(Some(plan.deviation_um), 3))),
        Fact::new("Diagonal ratio", fixed(Some(plan.diagonal_ratio), 4)),
    ]
}

/// What plans leave, and the crownings over the width.
///
/// # Errors
/// [`ChartError`] for numbers that cannot be drawn.
pub fn plan_sections(outcome: &CatalogueOutcome) -> Result<Vec<Section>, ChartError> {
    let planned: Vec<&CataloguePair> =
        outcome.pairs.iter().filter(|pair| pair.plan.is_some()).take(ROWS).collect();
    let mut blocks = Vec::new();
    if let Some(figure) = chart(outcome, &planned)? {
        blocks.push(Block::Figure(figure));
    }
    blocks.push(Block::Table(crownings(outcome, &planned)));
    Ok(vec![
        Section::new("plans", "Plans of the whole target", vec![Block::Table(plans(&planned))]),
        Section::new("crowning-over-the-width", "Crowning over the width", blocks),
    ])
}

fn plans(planned: &[&CataloguePair]) -> Table {
    let row = |pair: &&CataloguePair| {
        let plan = pair.plan.as_ref();
        vec![
            pair.rank.to_string(),
            pair.worm.clone(),
            pair.dresser.clone(),
            plan.map_or_else(String::new, |plan| plan.status.words().to_owned()),
            fixed(plan.map(|plan| plan.deviation_um), 3),
            percent(plan.map(|plan| plan.tolerance_share)),
            fixed(plan.map(|plan| plan.diagonal_ratio), 4),
            percent(plan.map(|plan| plan.largest_share_of_limit)),
            fixed(plan.map(|plan| plan.used_width_mm), 1),
        ]
    };
    Table {
        caption: String::new(),
        columns: vec![
            Column::number("Rank", ""),
            Column::name("Worm"),
            Column::name("Dresser"),
            Column::text("Verdict"),
            Column::number("Deviation", "µm"),
            Column::number("Of the tolerance", "%"),
            Column::number("K", ""),
            Column::number("Limit", "%"),
            Column::number("Worm used", "mm"),
        ],
        rows: planned.iter().map(row).collect(),
        note: "Each pair is planned for the whole target and judged by simulated material removal; limit: largest share of an axis limit \
               over the dressing stroke."
            .into(),
    }
}

/// Rows of wanted and made crowning, a column for each position.
fn crownings(outcome: &CatalogueOutcome, planned: &[&CataloguePair]) -> Table {
    let positions: Vec<f64> =
        outcome.wanted_over_width.values().next().into_iter().flatten().map(|at| at.z_mm).collect();
    let at = |value: Option<f64>| fixed(value, 3);
    let mut rows = Vec::new();
    for (flank, wanted) in &outcome.wanted_over_width {
        let mut row = vec![(*flank).to_owned(), "wanted".to_owned(), String::new(), String::new()];
        row.extend(wanted.iter().map(|crowning| at(Some(crowning.wanted_um))));
        rows.push(row);
        for pair in planned {
            let range = pair.crowning_range.get(flank);
            let mut row = vec![
                (*flank).to_owned(),
                format!("{} · {}", pair.worm, pair.dresser),
                at(range.map(|range| range.least_um)),
                at(range.map(|range| range.largest_um)),
            ];
            let made = pair.plan.as_ref().and_then(|plan| plan.crowning.get(flank));
            row.extend(made.into_iter().flatten().map(|crowning| at(crowning.made_um)));
            rows.push(row);
        }
    }
    let mut columns = vec![
        Column::text("Flank"),
        Column::name("Pair"),
        Column::number("Least", "µm"),
        Column::number("Largest", "µm"),
    ];
    let position = |z: &f64| Column::number(format!("z = {}", format_significant(*z, 4)), "µm");
    columns.extend(positions.iter().map(position));
    Table {
        caption: String::new(),
        columns,
        rows,
        note: "Profile crowning of the gear from form to tip diameter by least squares at positions z in mm over the face width. Least and \
               largest: what the dresser makes on this worm by its position alone, within the limits of the axes."
            .into(),
    }
}

/// Crowning over the width: wanted, and as the best plans make it.
fn chart(outcome: &CatalogueOutcome, planned: &[&CataloguePair]) -> Result<Option<Figure>, ChartError> {
    let line = |name: String, at: &[CrowningAt], value: fn(&CrowningAt) -> Option<f64>| {
        let points: Vec<(f64, f64)> = at.iter().filter_map(|c| Some((c.z_mm, value(c)?))).collect();
        Series::new(name, points.iter().map(|p| p.0).collect(), points.iter().map(|p| p.1).collect())
    };
    let mut panels = Vec::new();
    for (flank, wanted) in &outcome.wanted_over_width {
        if wanted.len() < 2 {
            return Ok(None);
        }
        let mut series = vec![line("wanted".into(), wanted, |c| Some(c.wanted_um))];
        for pair in planned.iter().take(LINES) {
            if let Some(made) = pair.plan.as_ref().and_then(|plan| plan.crowning.get(flank)) {
                series.push(line(format!("{} · {}", pair.worm, pair.dresser), made, |c| c.made_um));
            }
        }
        panels.push(Panel::linear(format!("{flank} flank [µm]"), 1e-6, series));
    }
    let chart = LineChart {
        title: "Profile crowning over the face width".into(),
        x_title: "position z of the gear [mm]".into(),
        panels,
    };
    let caption = "Profile crowning that the target wants and that the best plans make.";
    Ok(Some(Figure::new("crowning-over-the-width", line_chart(&chart)?, caption)))
}
