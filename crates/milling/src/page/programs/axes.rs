//! The axes over time: over the first space, and along the middle row of the first flank.

use super::shown_motion::ShownMotion;
use crate::OperationKind;
use crate::workflow::programs::{Step, StepKind};
use machine::{Machine, Station};
use report::charts::{ChartError, LineChart, Panel, Series, Svg, line_chart};
use report::{Figure, kebab};

/// Parts of the time in each of which a line keeps its least and its greatest value: finer ones cannot be seen on the page.
const PARTS: usize = 400;
/// Smallest span of an axis, mm or deg: below it a line is flat.
const LEAST_SPAN: f64 = 0.001;

/// Both charts of a motion.
pub(super) fn figures(machine: &Machine, shown: &ShownMotion<'_>) -> Result<Vec<Figure>, ChartError> {
    let steps = shown.motion.tools.iter().flat_map(|run| &run.steps);
    let first: Vec<&Step> = steps.filter(|step| step.space == 0 && step.kind != StepKind::End).collect();
    let caption = format!(
        "As the blocks for {} have it; what lies between with other spaces is left out.",
        shown.controls
    );
    let title = "Axes over time: all paths of the first space";
    let svg = chart(title, machine, &first)?;
    let mut figures = vec![Figure::new("axes-over-time-all-paths-of-the-first-space", svg, caption)];
    if let Some((operation, steps)) = middle_row(shown, &first) {
        let name = &shown.result.operations[operation].name;
        let id = kebab(&format!("axes over time middle path of the {name}"));
        let svg = chart(&format!("Axes over time: middle path of the {name}"), machine, &steps)?;
        figures.push(Figure::new(id, svg, ""));
    }
    Ok(figures)
}

/// The first operation on a flank, and the steps of its middle path.
fn middle_row<'a>(shown: &ShownMotion<'_>, first: &[&'a Step]) -> Option<(usize, Vec<&'a Step>)> {
    let operations = &shown.motion.operations;
    let operation = operations.iter().position(|o| matches!(o.kind, OperationKind::Flank(_)))?;
    let path = operations[operation].rows.len() / 2;
    let of_row: Vec<&Step> =
        first.iter().copied().filter(|step| step.operation == operation && step.path == path).collect();
    let is_cut = |step: &&Step| step.kind == StepKind::Cut;
    let (from, to) = (of_row.iter().position(is_cut)?, of_row.iter().rposition(is_cut)?);
    // The row begins where the block before its first cut ends.
    Some((operation, of_row[from.saturating_sub(1)..=to].to_vec()))
}

/// The five axes at the ends of blocks, from the first of them on.
fn chart(title: &str, machine: &Machine, steps: &[&Step]) -> Result<Svg, ChartError> {
    let mut time = 0.0;
    let times: Vec<f64> = steps
        .iter()
        .enumerate()
        .map(|(k, step)| {
            time += if k > 0 { step.seconds } else { 0.0 };
            time
        })
        .collect();
    let panel = |axis: usize| {
        let described = &machine.axes()[axis];
        let values: Vec<f64> = steps.iter().map(|step| described.joint.shown(step.at[axis])).collect();
        let line = thinned("position", &times, &values);
        let title = format!("{} [{}]", described.name, described.joint.unit());
        Panel::linear(title, LEAST_SPAN, vec![line])
    };
    let axes = machine.five_axes(Station::Work).ok();
    let axes = axes.into_iter().flat_map(|axes| axes.rotary.into_iter().chain(axes.linear));
    line_chart(&LineChart {
        title: title.into(),
        x_title: "time [s]".into(),
        panels: axes.map(panel).collect(),
    })
}

/// Least and greatest value in each part of a line, in the order in which they come.
fn thinned(name: &str, times: &[f64], values: &[f64]) -> Series {
    let count = times.len();
    if count <= 2 * PARTS {
        return Series::new(name, times.to_vec(), values.to_vec());
    }
    let part = count.div_ceil(PARTS);
    let mut kept = vec![0];
    for from in (0..count).step_by(part) {
        let places = from..(from + part).min(count);
        let least = places.clone().min_by(|a, b| values[*a].total_cmp(&values[*b]));
        let greatest = places.max_by(|a, b| values[*a].total_cmp(&values[*b]));
        kept.extend(least.into_iter().chain(greatest));
    }
    kept.push(count - 1);
    kept.sort_unstable();
    kept.dedup();
    let of = |list: &[f64]| kept.iter().map(|&k| list[k]).collect();
    Series::new(name, of(times), of(values))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_peak_stays_in_a_thinned_line() {
        let times: Vec<f64> = (0..5001).map(f64::from).collect();
        let mut values: Vec<f64> = times.iter().map(|t| t.sin()).collect();
        values[777] = 7.5;
        let line = thinned("C", &times, &values);
        assert!(line.x.len() <= 2 * PARTS + 2);
        let peak = line.y.iter().position(|&y| y == 7.5).unwrap();
        assert_eq!(line.x[peak], 777.0);
    }
}
