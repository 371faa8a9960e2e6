//! The section on programs: motion of the machine's axes over time, cycle times, proof.

use crate::report::charts::{ChartError, LineChart, Panel, Series, line_chart};
use crate::report::{Block, Figure, Table};

/// Programs and what the axes do in them.
#[derive(Clone, Debug, PartialEq)]
pub struct ProgramsView {
    /// Axes to be shown over time, one panel each.
    pub axes: Vec<AxisCourse>,
    /// Times of operations and of the whole.
    pub cycle_times: Table,
    /// What was proven from the texts of the programs, paragraph by paragraph.
    pub proof: Vec<String>,
}

/// An axis over time.
#[derive(Clone, Debug, PartialEq)]
pub struct AxisCourse {
    /// Name of the axis, or of a quantity like the tip's difference.
    pub name: String,
    /// Unit.
    pub unit: String,
    /// Lines, equal names in different axes look alike.
    pub lines: Vec<CourseLine>,
}

/// A line over time.
#[derive(Clone, Debug, PartialEq)]
pub struct CourseLine {
    /// Name in the legend.
    pub name: String,
    /// Times, s, ascending.
    pub time_s: Vec<f64>,
    /// Values, as many as times.
    pub value: Vec<f64>,
}

/// Parts of the time in each of which a line keeps its least and its greatest value: finer ones cannot be seen on the page.
const PARTS: usize = 400;

impl ProgramsView {
    /// Chart of the axes, table of times, proof.
    pub(super) fn blocks(&self) -> Result<Vec<Block>, ChartError> {
        let mut blocks: Vec<Block> = self.proof.iter().cloned().map(Block::Paragraph).collect();
        if !self.axes.is_empty() {
            let panel = |axis: &AxisCourse| {
                let lines = axis.lines.iter().map(CourseLine::thinned).collect();
                Panel::linear(format!("{} [{}]", axis.name, axis.unit), 0.0, lines)
            };
            let svg = line_chart(&LineChart {
                title: "Axes over time".into(),
                x_title: "time [s]".into(),
                panels: self.axes.iter().map(panel).collect(),
            })?;
            blocks.push(Block::Figure(Figure { svg, caption: String::new() }));
        }
        if !self.cycle_times.rows.is_empty() {
            blocks.push(Block::Table(self.cycle_times.clone()));
        }
        Ok(blocks)
    }
}

impl CourseLine {
    /// Least and greatest value in each part of the line, in the order in which they come.
    fn thinned(&self) -> Series {
        let count = self.time_s.len().min(self.value.len());
        if count <= 2 * PARTS {
            return Series::new(self.name.clone(), self.time_s.clone(), self.value.clone());
        }
        let part = count.div_ceil(PARTS);
        let mut kept = vec![0];
        for from in (0..count).step_by(part) {
            let places = from..(from + part).min(count);
            let least = places.clone().min_by(|a, b| self.value[*a].total_cmp(&self.value[*b]));
            let greatest = places.max_by(|a, b| self.value[*a].total_cmp(&self.value[*b]));
            kept.extend(least.into_iter().chain(greatest));
        }
        kept.push(count - 1);
        kept.sort_unstable();
        kept.dedup();
        let of = |values: &[f64]| kept.iter().map(|&k| values[k]).collect();
        Series::new(self.name.clone(), of(&self.time_s), of(&self.value))
    }
}
