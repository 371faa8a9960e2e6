//! Arranges the page of the electronic gearbox.

use super::data::{BandPanel, BudgetRow, GearboxReport, ServoReport, SetUpPoint, SetUpReport};
use report::charts::{
    ChartError, LineChart, Panel, Series, Svg, YScale, format_fixed, format_significant, line_chart,
};
use report::data::{Block, Column, Figure, PlanReport, Section, Table};

/// Stretches of a band that are drawn as one: more than two hundred do not fit on the page.
const JOINED: usize = 2;

impl GearboxReport {
    /// The page.
    ///
    /// # Errors
    /// A number that is not finite.
    pub fn to_page(&self) -> Result<PlanReport, ChartError> {
        let mut sections = Vec::new();
        if let Some(set_ups) = &self.set_ups {
            sections.push(Section::new(
                "set-ups-to-choose-from",
                "Set-ups to choose from",
                set_ups.blocks()?,
            ));
        }
        sections.push(Section::new("errors", "Errors", self.error_blocks()?));
        if !self.budget.is_empty() {
            sections.push(Section::new(
                "error-budget",
                "Error budget",
                vec![Block::Table(budget_table(&self.budget))],
            ));
        }
        if let Some(servo) = &self.servo {
            sections.push(Section::new(
                "servo-of-the-workpiece-spindle",
                "Servo of the workpiece spindle",
                servo.blocks()?,
            ));
        }
        let sheets = [
            ("Pulses", &self.counters),
            ("Coupling", &self.coupling),
            ("Scale, interpolator, encoder", &self.settings),
        ];
        let tables = sheets.map(|(caption, quantities)| Table::of_quantities(caption, quantities));
        sections.push(Section::new(
            "counters-and-settings",
            "Counters and settings",
            vec![Block::Tables(tables.to_vec())],
        ));
        Ok(self.head.page(sections))
    }

    fn error_blocks(&self) -> Result<Vec<Block>, ChartError> {
        if self.error_panels.is_empty() {
            let text = "A train of pulses has no true position of the slide to compare with: counters only.";
            return Ok(vec![Block::Paragraph(text.into())]);
        }
        let svg = bands("Errors of interpolation and rotation", &self.error_panels)?;
        let caption = "Least and greatest error in each stretch of time. The constant lag of the running sense is taken off. Limits hold at \
                       every instant; the first panel shows starts, stops and reversals, the second is cut off outside the limits of constant speed.";
        Ok(vec![
            Block::Figure(Figure::new("errors-of-interpolation-and-rotation", svg, caption)),
            Block::Table(Table::of_quantities("", &self.errors)),
        ])
    }
}

/// A chart of bands below each other.
fn bands(title: &str, panels: &[BandPanel]) -> Result<Svg, ChartError> {
    let panels = panels.iter().map(|panel| Panel::linear(panel.title.clone(), 0.0, band_lines(panel)));
    line_chart(&LineChart { title: title.into(), x_title: "time [s]".into(), panels: panels.collect() })
}

fn band_lines(panel: &BandPanel) -> Vec<Series> {
    let band = &panel.band;
    let cut = |y: f64| panel.cut.map_or(y, |[low, high]| y.clamp(low, high));
    let time: Vec<f64> = band.time_s.chunks(JOINED).map(|t| t.iter().sum::<f64>() / t.len() as f64).collect();
    let joined = |values: &[f64], choose: fn(f64, f64) -> f64| -> Vec<f64> {
        values.chunks(JOINED).map(|v| cut(v[1..].iter().fold(v[0], |a, &b| choose(a, b)))).collect()
    };
    let mut lines = vec![
        Series::new("greatest", time.clone(), joined(&band.greatest, f64::max)),
        Series::new("least", time.clone(), joined(&band.least, f64::min)),
    ];
    if let (Some(limits), Some(first), Some(last)) = (panel.limits, time.first(), time.last()) {
        lines.extend(limits.map(|y| Series::level("limit", [*first, *last], y)));
    }
    lines
}

fn budget_table(rows: &[BudgetRow]) -> Table {
    let sum = |value: fn(&BudgetRow) -> f64| rows.iter().map(value).sum::<f64>();
    let (along, flank) = (sum(|row| row.along_um), sum(|row| row.flank_um));
    let cells = |name: &str, formula: &str, along_um: f64, flank_um: f64| {
        let share = if along > 0.0 { 1e2 * along_um / along } else { 0.0 };
        vec![
            name.to_owned(),
            formula.to_owned(),
            format_significant(along_um, 4),
            format_significant(flank_um, 4),
            format_fixed(share, 1),
        ]
    };
    let mut table: Vec<Vec<String>> =
        rows.iter().map(|row| cells(&row.name, &row.formula, row.along_um, row.flank_um)).collect();
    table.push(cells("sum", "", along, flank));
    Table {
        caption: String::new(),
        columns: vec![
            Column::text("Part"),
            Column::symbols("Formula"),
            Column::number("Along the feed", "µm"),
            Column::number("At the flank", "µm"),
            Column::number("Share", "%"),
        ],
        rows: table,
        note: "At the greatest speed of the motion; starts, stops and reversals saturate the part of the acceleration at p (P − 1)/P.".into(),
    }
}

impl ServoReport {
    fn blocks(&self) -> Result<Vec<Block>, ChartError> {
        let svg = bands("Servo of the workpiece spindle over time", &self.panels)?;
        let caption =
            "Least and greatest in each stretch of time; errors at the flank, normal, their means removed.";
        let response = Table {
            caption: "Answer to a disturbing torque, linear".into(),
            columns: vec![Column::number("Frequency", "Hz"), Column::number("Flank per torque", "µm/(N m)")],
            rows: self.response.iter().map(|row| row.map(|x| format_significant(x, 4)).to_vec()).collect(),
            note: String::new(),
        };
        Ok(vec![
            Block::Figure(Figure::new("servo-of-the-workpiece-spindle-over-time", svg, caption)),
            Block::Tables(vec![Table::of_quantities("Figures", &self.quantities), response]),
        ])
    }
}

impl SetUpReport {
    fn blocks(&self) -> Result<Vec<Block>, ChartError> {
        let mut blocks = Vec::new();
        if !self.best.is_empty() {
            blocks
                .push(Block::Table(Table::of_quantities("The cheapest that is accurate enough", &self.best)));
        }
        if let Some(svg) = self.chart()? {
            let caption = "Every set-up by its cost and its budget at the flank. The frontier joins those for which more accuracy costs more.";
            blocks.push(Block::Figure(Figure::new("accuracy-and-cost-of-set-ups", svg, caption)));
        }
        blocks.push(Block::Table(self.table.clone()));
        Ok(blocks)
    }

    fn chart(&self) -> Result<Option<Svg>, ChartError> {
        let line = |points: Vec<SetUpPoint>| -> (Vec<f64>, Vec<f64>) {
            points.iter().map(|point| (point.cost, point.flank_um)).unzip()
        };
        let of = |fast: bool| line(self.points.iter().copied().filter(|p| p.fast == fast).collect());
        let mut series = Vec::new();
        let (x, y) = line(self.frontier());
        if !x.is_empty() {
            let filled = vec![true; x.len()];
            series.push(Series::new("frontier", x, y).marked(filled));
        }
        for (name, fast) in [("set-up", true), ("too slow for the feed", false)] {
            let (x, y) = of(fast);
            if !x.is_empty() {
                series.push(Series::points(name, x, y));
            }
        }
        let costs = || self.points.iter().map(|point| point.cost);
        let (least, greatest) = (costs().fold(f64::INFINITY, f64::min), costs().fold(0.0, f64::max));
        if series.is_empty() {
            return Ok(None);
        }
        // One cost has no range to draw a line over.
        let to = if greatest > least { greatest } else { least + 1.0 };
        series.push(Series::level("wanted at most", [least, to], self.wanted_um));
        let panel = Panel {
            y_title: "error at the flank [µm]".into(),
            least_span: 0.0,
            scale: YScale::Logarithmic,
            series,
        };
        let chart = LineChart {
            title: "Accuracy and cost of set-ups".into(),
            x_title: "cost [as given]".into(),
            panels: vec![panel],
        };
        line_chart(&chart).map(Some)
    }

    /// Set-ups that no cheaper one, nor one of the same cost, surpasses; by rising cost.
    fn frontier(&self) -> Vec<SetUpPoint> {
        let mut points: Vec<SetUpPoint> = self.points.iter().copied().filter(|point| point.fast).collect();
        points.sort_by(|a, b| a.cost.total_cmp(&b.cost).then(a.flank_um.total_cmp(&b.flank_um)));
        let mut frontier: Vec<SetUpPoint> = Vec::new();
        for point in points {
            if frontier.last().is_none_or(|last| point.flank_um < last.flank_um) {
                frontier.push(point);
            }
        }
        frontier
    }
}
