//! Wear of the tool over the parts that it has cut.

use crate::history::HistoryRecord;
use crate::wear::WearTrend;
use crate::workflow::SkivingOutcome;
use foundation::geometry::{Flank, Sides};
use report::cells::{fixed, flank_title, significant};
use report::charts::{ChartError, LineChart, LineFrame, Panel, Series, Svg, line_chart_in};
use report::{Block, Column, Figure, Table};

const TALL: f64 = 150.0;

/// What is drawn of the trend of a flank. Places are [parts, wear in um].
struct DrawnTrend {
    /// The fitted line.
    line: [[f64; 2]; 2],
    /// Where the line meets the limit, with its standard deviation in parts.
    forecast: Option<([f64; 2], f64)>,
}

impl DrawnTrend {
    fn new(found: &WearTrend) -> Self {
        // Beyond twice the workpieces so far a line says nothing.
        let shown = found.forecast.as_ref().ok();
        let shown = shown.filter(|f| f.parts > 0.0 && f.parts <= 2.0 * found.last_parts);
        let last = shown.map_or(found.last_parts, |f| f.parts.max(found.last_parts));
        Self {
            line: [0.0, last].map(|parts| [parts, 1e3 * found.wear_at(parts)]),
            forecast: shown.map(|f| ([f.parts, 1e3 * found.limit], f.deviation)),
        }
    }
}

/// Earlier measurements and the trend; nothing without a history.
pub(super) fn blocks(outcome: &SkivingOutcome) -> Result<Vec<Block>, ChartError> {
    let Some(noted) = outcome.history.as_ref().filter(|noted| !noted.cycle.is_empty()) else {
        return Ok(Vec::new());
    };
    let trends = Sides::from_fn(|flank| noted.trends[flank].as_ref().map(DrawnTrend::new));
    let limit_um = 1e3 * outcome.prepared.bodies.options.wear_limit;
    let caption = "Wear at the track with the least material, mean of all teeth. A ring: where the fitted line meets the limit.";
    let svg = chart(&noted.cycle, &trends, limit_um)?;
    Ok(vec![
        Block::Figure(Figure::new("wear-over-the-parts-cut", svg, caption)),
        Block::Table(table(&noted.cycle, &trends)?),
    ])
}

fn wear_um(record: &HistoryRecord, flank: Flank) -> f64 {
    1e3 * record.wear_point(flank).wear
}

fn chart(
    cycle: &[HistoryRecord],
    trends: &Sides<Option<DrawnTrend>>,
    limit_um: f64,
) -> Result<Svg, ChartError> {
    let (from, to) = span(cycle, trends);
    let panel = |flank: Flank| {
        let (x, y) = cycle.iter().map(|record| (record.parts, wear_um(record, flank))).unzip();
        let mut series = Vec::new();
        let trend = trends[flank].as_ref();
        if let Some(trend) = trend {
            let (x, y) = trend.line.iter().map(|[x, y]| (*x, *y)).unzip();
            series.push(Series::new("fitted line", x, y).bare());
        }
        series.push(Series::points("measured", x, y));
        series.push(Series::limit("limit", vec![from, to], vec![limit_um; 2]));
        if let Some((at, _)) = trend.and_then(|trend| trend.forecast) {
            series.push(Series::rings("forecast", vec![(at, format!("{:.0} parts", at[0]))]));
        }
        Panel::linear(format!("{}: wear [µm]", flank_title(flank)), 0.5, series)
    };
    let chart = LineChart {
        title: "Wear over the parts cut".into(),
        x_title: "parts cut since the last regrinding".into(),
        panels: Flank::BOTH.map(panel).into(),
    };
    line_chart_in(&chart, &LineFrame { panel_height: Some(TALL), beside: 0.03 * (to - from) })
}

/// First and last number of parts that is drawn.
fn span(cycle: &[HistoryRecord], trends: &Sides<Option<DrawnTrend>>) -> (f64, f64) {
    let drawn = trends.iter().filter_map(|(_, trend)| trend.as_ref());
    let of_trends = drawn
        .flat_map(|trend| trend.line.iter().chain(trend.forecast.iter().map(|(at, _)| at)))
        .map(|at| at[0]);
    let all = cycle.iter().map(|record| record.parts).chain(of_trends);
    all.fold((f64::INFINITY, f64::NEG_INFINITY), |(lo, hi), x| (lo.min(x), hi.max(x)))
}

fn table(cycle: &[HistoryRecord], trends: &Sides<Option<DrawnTrend>>) -> Result<Table, ChartError> {
    let row = |record: &HistoryRecord| {
        let name = &record.time;
        Ok(vec![
            name.clone(),
            fixed(&format!("parts at {name}"), record.parts, 0)?,
            fixed(&format!("left wear at {name}"), wear_um(record, Flank::Left), 2)?,
            fixed(&format!("right wear at {name}"), wear_um(record, Flank::Right), 2)?,
            match record.out_of_band.len() {
                0 => String::new(),
                count => format!("{count} edges out of their band"),
            },
        ])
    };
    let mut notes = Vec::new();
    for (flank, trend) in trends.iter() {
        let Some(([parts, _], deviation)) = trend.as_ref().and_then(|trend| trend.forecast) else { continue };
        notes.push(format!(
            "{}: limit at {} parts ± {}",
            flank_title(flank),
            fixed("forecast", parts, 0)?,
            significant("forecast", deviation, 2)?
        ));
    }
    if !notes.is_empty() {
        notes.push("± one standard deviation".into());
    }
    Ok(Table {
        caption: "Measurements".into(),
        columns: vec![
            Column::name("Measurement"),
            Column::number("Parts", ""),
            Column::number("Wear left", "µm"),
            Column::number("Wear right", "µm"),
            Column::text("Remark"),
        ],
        rows: cycle.iter().map(row).collect::<Result<_, ChartError>>()?,
        note: notes.join("; "),
    })
}
