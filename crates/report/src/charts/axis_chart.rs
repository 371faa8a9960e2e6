//! One axis of a machine over time: position, velocity and acceleration below each other, with what the machine allows. Small
//! enough for two of them beside each other on a page.

use super::axes::{Frame, TICK_SIZE, with_factor};
use super::error::{ChartError, check_count, check_length, check_values};
use super::numbers::format_significant;
use super::palette::{BLUE, INK};
use super::scale::Axis;
use super::svg::{Anchor, Canvas, Stroke, Svg, TextStyle};
use super::text::text_width;
use super::thinning::thinned;
use crate::ids::kebab;
use serde::Serialize;

/// Chart of an axis. Lists of equal length.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct AxisChart {
    /// Name on the machine.
    pub axis: String,
    /// Word in the program.
    pub word: String,
    /// "mm" or "deg".
    pub unit: String,
    /// Instants, s, none before the one ahead of it.
    pub time_s: Vec<f64>,
    /// Positions, mm or deg.
    pub position: Vec<f64>,
    /// Velocities, per s.
    pub velocity: Vec<f64>,
    /// Accelerations, per s^2.
    pub acceleration: Vec<f64>,
    /// What the machine allows.
    pub limits: AxisChartLimits,
}

/// What a machine allows an axis, mm or deg. `None` is not limited.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct AxisChartLimits {
    /// Ends of travel.
    pub travel: Option<[f64; 2]>,
    /// Greatest velocity, per s.
    pub velocity: Option<f64>,
    /// Greatest acceleration, per s^2.
    pub acceleration: Option<f64>,
}

const WIDTH: f64 = 430.0;
const LEFT: f64 = 60.0;
/// Room for the values of the limits.
const RIGHT: f64 = 46.0;
/// Room above a panel for its title.
const PANEL_HEAD: f64 = 19.0;
const PANEL_HEIGHT: f64 = 76.0;
const PANEL_GAP: f64 = 8.0;
/// Text beside the title of a panel, values of limits.
const SMALL: f64 = 10.5;
/// A limit is drawn if it lies outside the curve by at most this share of the curve's height.
const NEAR: f64 = 0.6;
/// Room between a drawn limit and the frame, as a share of the curve's height.
const HEADROOM: f64 = 0.08;
/// Least height of a panel in its unit: what is smaller is rounding, and stays a flat line.
const LEAST_SPAN: f64 = 1e-3;
/// Width of a column that a curve is thinned to, and what it may lose.
const COLUMN: f64 = 0.5;
const LOSS: f64 = 0.05;

const CURVE: Stroke<'static> = Stroke::solid(BLUE, 1.5);
const LIMIT: Stroke<'static> = Stroke { color: INK, width: 1.1, dash: "6 3" };

impl AxisChart {
    /// Id of the chart where no other machine or program stands.
    pub fn id(&self) -> String {
        kebab(&format!("axis {} word {}", self.axis, self.word))
    }
}

/// Draws one axis.
///
/// # Errors
/// [`ChartError`] without instants, for lists of different length, a value that is not finite, or time that runs backwards.
pub fn axis_chart(chart: &AxisChart) -> Result<Svg, ChartError> {
    check(chart)?;
    let panels = panels(chart);
    let title = format!("Axis {}, word {}", chart.axis, chart.word);
    let beside = text_width(&title, 15.0) * 1.08 + 24.0 + LEGEND_WIDTH <= WIDTH;
    let legend_y = if beside { 13.0 } else { 33.0 };
    let top = if beside { 24.0 } else { 42.0 };
    let height = top + panels.len() as f64 * (PANEL_HEAD + PANEL_HEIGHT + PANEL_GAP) + 30.0;
    let mut canvas = Canvas::new(WIDTH, height, &title);
    canvas.heading("");
    draw_legend(&mut canvas, legend_y, panels.iter().any(|panel| !near_limits(panel).is_empty()));
    let (begin, end) = range(&chart.time_s);
    let time = Axis::tight(begin, end, 8);
    for (k, panel) in panels.iter().enumerate() {
        let frame = Frame {
            left: LEFT,
            top: top + k as f64 * (PANEL_HEAD + PANEL_HEIGHT + PANEL_GAP) + PANEL_HEAD,
            width: WIDTH - LEFT - RIGHT,
            height: PANEL_HEIGHT,
        };
        draw_panel(&mut canvas, frame, panel, &chart.time_s, &time);
        if k + 1 == panels.len() {
            frame.abscissa(&mut canvas, &time, "time [s]");
        }
    }
    Ok(canvas.finish())
}

fn check(chart: &AxisChart) -> Result<(), ChartError> {
    let named = |what: &str| format!("axis {}, {what}", chart.axis);
    check_count(&named("time"), chart.time_s.len(), 1)?;
    check_values(&named("time"), &chart.time_s)?;
    if let Some(before) = chart.time_s.windows(2).position(|pair| pair[1] < pair[0]) {
        return Err(ChartError::NotAscending { quantity: named("time"), index: before + 1 });
    }
    let curves =
        [("position", &chart.position), ("velocity", &chart.velocity), ("acceleration", &chart.acceleration)];
    for (what, values) in curves {
        check_length(&named(what), chart.time_s.len(), values.len())?;
        check_values(&named(what), values)?;
    }
    let limits = &chart.limits;
    check_values(&named("travel"), limits.travel.as_ref().map_or(&[], |ends| ends.as_slice()))?;
    check_values(&named("greatest velocity"), limits.velocity.as_slice())?;
    check_values(&named("greatest acceleration"), limits.acceleration.as_slice())
}

fn range(values: &[f64]) -> (f64, f64) {
    values.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(lo, hi), &v| (lo.min(v), hi.max(v)))
}

/// Share of a limit in per cent, for readers: what is less than a thousandth is no matter of limits.
pub fn share_of_limit(share: f64) -> String {
    if share > 0.0 && share < 1e-3 {
        return "< 0.1".to_owned();
    }
    format_significant(100.0 * share, 3)
}

/// One of the three curves.
struct Panel<'a> {
    /// Quantity and unit.
    title: String,
    values: &'a [f64],
    /// Range of the curve; that of velocity and acceleration holds zero.
    range: (f64, f64),
    limits: Vec<f64>,
    /// What the machine allows, in words, and how much of it is used.
    allowed: [String; 2],
}

fn panels(chart: &AxisChart) -> [Panel<'_>; 3] {
    let unit = &chart.unit;
    let number = |x: f64| format_significant(x, 6);
    let (low, high) = range(&chart.position);
    let travel = chart.limits.travel;
    let spaced_unit = if unit == "deg" { "°".to_owned() } else { format!(" {unit}") };
    let position = Panel {
        title: format!("position [{unit}]"),
        values: &chart.position,
        range: (low, high),
        limits: travel.map_or(Vec::new(), |ends| ends.to_vec()),
        allowed: match travel {
            Some([from, to]) => [
                format!("travel {} .. {}", number(from), number(to)),
                format!("{}{spaced_unit} to spare", format_significant((low - from).min(to - high), 3)),
            ],
            None => ["travel without ends".into(), String::new()],
        },
    };
    let symmetric = |title: String, values, most: Option<f64>| {
        let (low, high) = range(values);
        let (low, high) = (low.min(0.0), high.max(0.0));
        Panel {
            title,
            values,
            range: (low, high),
            limits: most.map_or(Vec::new(), |most| vec![-most, most]),
            allowed: match most {
                Some(most) => {
                    let share = high.max(-low) / most;
                    [format!("limit ±{}", number(most)), format!("{} % used", share_of_limit(share))]
                }
                None => ["no limit given".into(), String::new()],
            },
        }
    };
    [
        position,
        symmetric(format!("velocity [{unit}/s]"), &chart.velocity, chart.limits.velocity),
        symmetric(format!("acceleration [{unit}/s²]"), &chart.acceleration, chart.limits.acceleration),
    ]
}

/// Limits that the curve reaches or nearly reaches. Farther ones would squeeze it; they are named beside the title.
fn near_limits(panel: &Panel<'_>) -> Vec<f64> {
    let (from, to) = panel.range;
    let near = NEAR * (to - from);
    panel.limits.iter().copied().filter(|limit| limit - to <= near && from - limit <= near).collect()
}

fn draw_panel(canvas: &mut Canvas, frame: Frame, panel: &Panel<'_>, time_s: &[f64], time: &Axis) {
    let (mut lo, mut hi) = panel.range;
    let headroom = HEADROOM * (hi - lo);
    let drawn = near_limits(panel);
    for limit in &drawn {
        lo = lo.min(limit - headroom);
        hi = hi.max(limit + headroom);
    }
    let ordinate = Axis::rounded(lo, hi, 4, LEAST_SPAN);
    frame.grid(canvas, time, &ordinate);
    frame.zero_line(canvas, &ordinate);
    frame.ordinate(canvas, &ordinate);
    frame.outline(canvas);
    let head = frame.top - 6.0;
    let title = with_factor(&panel.title, &ordinate);
    canvas.text([frame.left, head], &title, TextStyle::new(TICK_SIZE, Anchor::Start).bold());
    canvas.text([WIDTH, head], &remark(panel, &drawn), TextStyle::new(SMALL, Anchor::End));
    for limit in drawn {
        let [left, y] = frame.at(0.0, ordinate.share(limit));
        canvas.line([left, y], [frame.right(), y], LIMIT);
        let style = TextStyle::new(SMALL, Anchor::Start);
        canvas.text([frame.right() + 4.0, y + 3.6], &format_significant(limit, 6), style);
    }
    let places: Vec<[f64; 2]> = time_s
        .iter()
        .zip(panel.values)
        .map(|(&t, &value)| frame.at(time.share(t), ordinate.share(value)))
        .collect();
    canvas.polylines(&[thinned(&places, COLUMN, LOSS)], CURVE);
}

/// What stands beside the title of a panel: the limits, which of them lie too far off to be drawn, how much is used.
fn remark(panel: &Panel<'_>, drawn: &[f64]) -> String {
    let [allowed, used] = &panel.allowed;
    let mut text = allowed.clone();
    if !panel.limits.is_empty() && drawn.is_empty() {
        text.push_str(" (beyond the scale)");
    }
    if !used.is_empty() {
        text.push_str(", ");
        text.push_str(used);
    }
    text
}

const LEGEND: [(&str, Stroke<'static>); 2] = [("axis", CURVE), ("limit", LIMIT)];
const LEGEND_LINE: f64 = 26.0;
const LEGEND_WIDTH: f64 = 128.0;

/// Flush right, so that it stands beside a title of usual length.
fn draw_legend(canvas: &mut Canvas, y: f64, with_limits: bool) {
    let mut right = WIDTH;
    for (name, stroke) in LEGEND.iter().rev().skip(usize::from(!with_limits)) {
        canvas.text([right, y + 4.0], name, TextStyle::new(TICK_SIZE, Anchor::End));
        let end = right - text_width(name, TICK_SIZE) - 7.0;
        canvas.line([end - LEGEND_LINE, y], [end, y], *stroke);
        right = end - LEGEND_LINE - 14.0;
    }
}
