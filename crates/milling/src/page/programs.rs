//! The section on programs: motion of the machine's axes over time, cycle times, proof.

use report::charts::{ChartError, LineChart, Panel, Series, line_chart};
use report::data::{Block, Figure, Table};

/// Programs and what the axes do in them.
#[derive(Clone, Debug, PartialEq)]
pub struct ProgramsView {
    /// What was proven from the texts of the programs, paragraph by paragraph.
    pub proof: Vec<String>,
    /// What the axes do, paragraph by paragraph: solutions, turning back, the pole.
    pub remarks: Vec<String>,
    /// Charts of the axes.
    pub courses: Vec<CourseChart>,
    /// Times of operations and of the whole, a table for every way of leading the tip.
    pub cycle_times: Vec<Table>,
}

/// Axes over time.
#[derive(Clone, Debug, PartialEq)]
pub struct CourseChart {
    /// By which programs find it.
    pub id: String,
    /// What they do.
    pub title: String,
    /// What else is to be known.
    pub caption: String,
    /// One panel each.
    pub axes: Vec<AxisCourse>,
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
/// Smallest span of an axis, mm or deg: below it a line is flat.
const LEAST_SPAN: f64 = 0.001;

impl ProgramsView {
    /// Proof, remarks, tables of times, charts of the axes.
    pub(super) fn blocks(&self) -> Result<Vec<Block>, ChartError> {
        let paragraphs = self.proof.iter().chain(&self.remarks).cloned();
        let mut blocks: Vec<Block> = paragraphs.map(Block::Paragraph).collect();
        let times = self.cycle_times.iter().filter(|table| !table.rows.is_empty());
        blocks.extend(times.cloned().map(Block::Table));
        for course in &self.courses {
            let panel = |axis: &AxisCourse| {
                let lines = axis.lines.iter().map(CourseLine::thinned).collect();
                Panel::linear(format!("{} [{}]", axis.name, axis.unit), LEAST_SPAN, lines)
            };
            let svg = line_chart(&LineChart {
                title: course.title.clone(),
                x_title: "time [s]".into(),
                panels: course.axes.iter().map(panel).collect(),
            })?;
            blocks.push(Block::Figure(Figure::new(course.id.clone(), svg, course.caption.clone())));
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
