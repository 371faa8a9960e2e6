//! Wear of the tool over the parts that it has cut.

use foundation::geometry::{Flank, Sides};
use report::cells::{fixed, fixed_or_none, flank_title, significant};
use report::charts::{ChartError, LineChart, LineFrame, Panel, Series, Svg, line_chart_in};
use report::data::{Block, Column, Figure, Table};

/// Measurements of a tool so far.
#[derive(Clone, Debug, PartialEq)]
pub struct HistoryView {
    /// Measurements, oldest first.
    pub measurements: Vec<HistoryRow>,
    /// What they say of each flank.
    pub trends: Sides<WearTrend>,
    /// Wear at which the tool is reground, um, > 0.
    pub limit_um: Option<f64>,
}

/// A measurement. Wear is material that is missing, um, > 0.
#[derive(Clone, Debug, PartialEq)]
pub struct HistoryRow {
    /// Date or name.
    pub name: String,
    /// Parts cut until then.
    pub parts: f64,
    /// Wear of each flank; none where it was not measured.
    pub wear_um: Sides<Option<f64>>,
    /// What was done; empty for nothing.
    pub remark: String,
}

/// Trend of a flank. Places are [parts, wear in um].
#[derive(Clone, Debug, Default, PartialEq)]
pub struct WearTrend {
    /// The fitted line; empty without one.
    pub line: Vec<[f64; 2]>,
    /// Where the line meets the limit.
    pub forecast: Option<[f64; 2]>,
    /// Standard deviation of the forecast, parts.
    pub forecast_deviation: Option<f64>,
}

const TALL: f64 = 150.0;

impl HistoryView {
    pub(super) fn blocks(&self) -> Result<Vec<Block>, ChartError> {
        let mut blocks = Vec::new();
        if !self.measurements.is_empty() {
            let caption = "Wear at the track with the least material, mean of all teeth. A ring: where the fitted line meets the limit.";
            blocks.push(Block::Figure(Figure::new("wear-over-the-parts-cut", self.chart()?, caption)));
            blocks.push(Block::Table(self.table()?));
        }
        Ok(blocks)
    }

    fn chart(&self) -> Result<Svg, ChartError> {
        let (from, to) = self.span();
        let panel = |flank: Flank| {
            let measured = self.measurements.iter().filter_map(|row| Some((row.parts, row.wear_um[flank]?)));
            let (x, y): (Vec<f64>, Vec<f64>) = measured.unzip();
            let mut series = Vec::new();
            let trend = &self.trends[flank];
            if !trend.line.is_empty() {
                let (x, y) = trend.line.iter().map(|[x, y]| (*x, *y)).unzip();
                series.push(Series::new("fitted line", x, y).bare());
            }
            if !x.is_empty() {
                series.push(Series::points("measured", x, y));
            }
            if let Some(limit) = self.limit_um {
                series.push(Series::limit("limit", vec![from, to], vec![limit; 2]));
            }
            if let Some(at) = trend.forecast {
                let text = format!("{:.0} parts", at[0]);
                series.push(Series::rings("forecast", vec![(at, text)]));
            }
            Panel::linear(format!("{}: wear [µm]", flank_title(flank)), 0.5, series)
        };
        let panels: Vec<Panel> =
            Flank::BOTH.map(panel).into_iter().filter(|panel| !panel.series.is_empty()).collect();
        let chart = LineChart {
            title: "Wear over the parts cut".into(),
            x_title: "parts cut since the last regrinding".into(),
            panels,
        };
        line_chart_in(&chart, &LineFrame { panel_height: Some(TALL), beside: 0.03 * (to - from) })
    }

    /// First and last number of parts that is drawn.
    fn span(&self) -> (f64, f64) {
        let measured = self.measurements.iter().map(|row| row.parts);
        let lines = self.trends.iter().flat_map(|(_, trend)| trend.line.iter().chain(&trend.forecast));
        let all = measured.chain(lines.map(|at| at[0]));
        all.fold((f64::INFINITY, f64::NEG_INFINITY), |(lo, hi), x| (lo.min(x), hi.max(x)))
    }

    fn table(&self) -> Result<Table, ChartError> {
        let row = |row: &HistoryRow| {
            Ok(vec![
                row.name.clone(),
                fixed(&format!("parts at {}", row.name), row.parts, 0)?,
                fixed_or_none(&format!("left wear at {}", row.name), row.wear_um.left, 2)?,
                fixed_or_none(&format!("right wear at {}", row.name), row.wear_um.right, 2)?,
                row.remark.clone(),
            ])
        };
        let mut notes = Vec::new();
        for (flank, trend) in self.trends.iter() {
            let Some([parts, _]) = trend.forecast else { continue };
            let mut text = format!("{}: limit at {} parts", flank_title(flank), fixed("forecast", parts, 0)?);
            if let Some(deviation) = trend.forecast_deviation {
                text.push_str(&format!(" ± {}", significant("forecast", deviation, 2)?));
            }
            notes.push(text);
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
            rows: self.measurements.iter().map(row).collect::<Result<_, ChartError>>()?,
            note: notes.join("; "),
        })
    }
}
