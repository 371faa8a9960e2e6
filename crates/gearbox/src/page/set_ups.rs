//! Set-ups to choose from: the cheapest that is accurate enough, the chart, the ranking.

use super::set_up_chart::chart;
use crate::workflow::{BestSetUpResult, ExploreResult, SetUpResult};
use report::charts::{ChartError, format_significant};
use report::{Block, Column, Figure, Quantity, Table};

/// Rows of the table of set-ups; all of them stand in `set-ups.csv`.
const ROWS: usize = 200;

pub(super) fn blocks(explored: &ExploreResult) -> Result<Vec<Block>, ChartError> {
    let mut blocks = Vec::new();
    if let Some(best) = &explored.best {
        let caption = "The cheapest that is accurate enough";
        blocks.push(Block::Table(Table::of_quantities(caption, &quantities(best))));
    }
    if let Some(svg) = chart(explored)? {
        let caption = "Every set-up by its cost and its budget at the flank. The frontier joins those for which more accuracy costs more.";
        blocks.push(Block::Figure(Figure::new("accuracy-and-cost-of-set-ups", svg, caption)));
    }
    blocks.push(Block::Table(ranking(explored)));
    Ok(blocks)
}

fn quantities(best: &BestSetUpResult) -> Vec<Quantity> {
    let s = best.set_up;
    let mut list = vec![
        Quantity::number("cost", "", s.cost, ""),
        Quantity::number("reference pulses per metre", "q", s.pulses_per_metre, "1/m"),
        Quantity::number("clock", "f_1", s.clock_hz, "Hz"),
        Quantity::count("pulses per interval", "P", i64::from(s.pulses_per_interval)),
        Quantity::count("workpiece pulses per revolution", "N_w", i64::from(s.pulses_per_revolution)),
    ];
    list.extend(s.flank_um.map(|um| Quantity::number("budget at the flank", "", um, "µm")));
    for (name, value) in [
        ("simulated, constant speed", best.measured_steady_um),
        ("simulated, starts and reversals among it", best.measured_whole_um),
    ] {
        list.extend(value.map(|um| Quantity::number(name, "", um, "µm")));
    }
    list
}

/// A verdict in as few words as the table has room for.
fn verdict(refused: Option<&str>) -> &str {
    match refused {
        None => "accurate",
        Some("not-accurate-enough") => "coarse",
        Some("interpolator-too-fast") => "too slow",
        Some(_) => "b ≥ 1",
    }
}

fn ranking(explored: &ExploreResult) -> Table {
    let um = |x: f64| format_significant(x, 4);
    let row = |s: &SetUpResult| {
        vec![
            s.rank.to_string(),
            format_significant(s.cost, 6),
            s.flank_um.map_or_else(|| "–".into(), um),
            format_significant(s.pulses_per_metre, 6),
            format_significant(s.clock_hz, 6),
            s.pulses_per_interval.to_string(),
            s.pulses_per_revolution.to_string(),
            um(s.quantisation_um),
            um(s.clock_um),
            um(s.acceleration_um),
            um(s.resolution_um),
            s.rounding_um.map_or_else(|| "–".into(), um),
            verdict(s.refused).to_owned(),
        ]
    };
    let rest = explored.set_ups.len().saturating_sub(ROWS);
    let more = if rest > 0 { format!(" {rest} more rows stand in set-ups.csv.") } else { String::new() };
    Table {
        caption: "Ranking".into(),
        columns: vec![
            Column::number("Rank", ""),
            Column::number("Cost", ""),
            Column::number("Flank", "µm"),
            Column::number("q", "1/m"),
            Column::number("Clock", "Hz"),
            Column::number("P", ""),
            Column::number("N_w", "1/rev"),
            Column::number("Staircase", "µm"),
            Column::number("Clock", "µm"),
            Column::number("Accel.", "µm"),
            Column::number("Resol.", "µm"),
            Column::number("Round.", "µm"),
            Column::text("Verdict"),
        ],
        rows: explored.set_ups.iter().take(ROWS).map(row).collect(),
        note: format!(
            "At {} mm/min and {} mm/s². Ranked: {}.{more}",
            format_significant(explored.speed_mm_per_min, 6),
            format_significant(explored.acceleration_mm_per_s2, 6),
            explored.ranking
        ),
    }
}
