//! The chart of a characteristic over the parts: individual values with mean, control limits, limits and trend; moving ranges below.

use super::characteristic::{fixed, limits, mark, name, unit};
use crate::workflow::series::{SeriesCharacteristic, SeriesFigures};
use report::charts::{ChartError, LineChart, LineFrame, Panel, Series, Svg, line_chart_in};

/// Height of a panel.
const PANEL: f64 = 120.0;
/// Room for texts behind the last part, as a share of the parts.
const BESIDE: f64 = 0.085;
/// Distance of the name of a limit from it, as a share of the chart.
const ROOM: f64 = 0.09;
/// More parts than this have no marker each.
const MARKED: usize = 150;

/// The chart; none without figures.
///
/// # Errors
/// [`ChartError`] for numbers that cannot be drawn.
pub(super) fn chart(of: &SeriesCharacteristic) -> Result<Option<Svg>, ChartError> {
    let Some(figures) = &of.figures else { return Ok(None) };
    let numbers: Vec<f64> = of.parts.iter().map(|part| *part as f64).collect();
    let (Some(&first), Some(&last)) = (numbers.first(), numbers.last()) else { return Ok(None) };
    let unit = if unit(of).is_empty() { String::new() } else { format!(" [{}]", unit(of)) };
    let beside = (BESIDE * (last - first)).max(0.6);
    let at = last + 0.55 * beside;
    let values =
        Panel::linear(format!("value{unit}"), 0.0, value_lines(of, figures, &numbers, [first, last], at));
    let ranges = Panel::linear(
        format!("distance of neighbouring parts{unit}"),
        0.0,
        range_lines(of, figures, &numbers, at),
    );
    let chart = LineChart {
        title: format!("{}{unit}", name(of)),
        x_title: "part".into(),
        panels: vec![values, ranges],
    };
    let layout = LineFrame { panel_height: Some(PANEL), beside };
    line_chart_in(&chart, &layout).map(Some)
}

fn value_lines(
    of: &SeriesCharacteristic,
    figures: &SeriesFigures,
    numbers: &[f64],
    ends: [f64; 2],
    beside: f64,
) -> Vec<Series> {
    let across = |name: &str, y: f64| Series::limit(name, ends.to_vec(), vec![y; 2]);
    let mut lines =
        vec![points("part", numbers.to_vec(), of.values.clone()), Series::level("mean", ends, figures.mean)];
    lines.extend(figures.control_limits.map(|y| across("control limits", y)));
    lines.extend(limits(of).iter().flatten().map(|y| Series::level("limits of the class", ends, *y)));
    if let Some(trend) = figures.trend {
        let y = ends.map(|x| trend.start + trend.per_part * x).to_vec();
        lines.push(Series::new("trend", ends.to_vec(), y).bare());
    }
    lines.push(rings(of, figures));
    let label = |word: &str, y: f64, at: f64| ([beside, at], format!("{word} {}", fixed(of, y)));
    let mut labels = vec![label("mean", figures.mean, figures.mean)];
    // Names of limits stand outside of them, which keeps the lines clear of the frame.
    let room = ROOM * (top(of, figures) - bottom(of, figures));
    let [lower, upper] = limits(of);
    labels.extend(lower.map(|y| label("limit", y, y - room)));
    labels.extend(upper.map(|y| label("limit", y, y + room)));
    lines.push(Series::texts("values of the lines", labels));
    lines.retain(|series| !series.x.is_empty());
    lines
}

/// The lowest of what the chart of values shows.
fn bottom(of: &SeriesCharacteristic, figures: &SeriesFigures) -> f64 {
    let lowest = figures.min.min(figures.control_limits[0]);
    limits(of).iter().flatten().copied().fold(lowest, f64::min)
}

/// The highest of it.
fn top(of: &SeriesCharacteristic, figures: &SeriesFigures) -> f64 {
    let highest = figures.max.max(figures.control_limits[1]);
    limits(of).iter().flatten().copied().fold(highest, f64::max)
}

/// The last part of every stretch that a rule has found; the marks of one part together.
fn rings(of: &SeriesCharacteristic, figures: &SeriesFigures) -> Series {
    let mut rings: Vec<([f64; 2], String)> = Vec::new();
    for stretch in &figures.special_causes {
        let Some(place) = of.parts.iter().position(|part| *part == stretch.last) else { continue };
        let at = [of.parts[place] as f64, of.values[place]];
        match rings.iter_mut().find(|(known, _)| *known == at) {
            Some((_, text)) => {
                text.push_str(", ");
                text.push_str(mark(stretch));
            }
            None => rings.push((at, mark(stretch).into())),
        }
    }
    Series::rings("special cause", rings)
}

fn range_lines(
    of: &SeriesCharacteristic,
    figures: &SeriesFigures,
    numbers: &[f64],
    beside: f64,
) -> Vec<Series> {
    let distances: Vec<f64> = of.values.windows(2).map(|pair| (pair[1] - pair[0]).abs()).collect();
    let from = numbers[1..].to_vec();
    let [mean, upper] = figures.moving_range;
    let ends = [from[0], from[from.len() - 1]];
    let label = |y: f64| ([beside, y], fixed(of, y));
    vec![
        points("distance", from, distances),
        Series::level("mean", ends, mean),
        Series::limit("control limits", ends.to_vec(), vec![upper; 2]),
        Series::texts("values of the lines", vec![label(mean), label(upper)]),
    ]
}

/// A line with a marker at each part, as long as there is room for them.
fn points(name: &str, x: Vec<f64>, y: Vec<f64>) -> Series {
    let count = x.len();
    let line = Series::new(name, x, y);
    if count > MARKED { line.bare() } else { line.marked(vec![true; count]) }
}
