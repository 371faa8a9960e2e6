//! Lines over a common abscissa, in one panel or in a stack of small panels.

use super::axes::{Frame, TICK_SIZE, with_factor};
use super::error::{ChartError, check_count, check_length, check_values};
use super::line_legend::{self, Entry};
use super::line_marks::{draw_bars, draw_marker, draw_rings, draw_texts, marked};
use super::scale::Axis;
use super::svg::{Anchor, Canvas, Svg, TextStyle};

/// A chart of lines.
#[derive(Clone, Debug, PartialEq)]
pub struct LineChart {
    /// Heading of the chart.
    pub title: String,
    /// Quantity and unit of the abscissa, for example `z_V2 [mm]`.
    pub x_title: String,
    /// Panels from top to bottom; all share the abscissa.
    pub panels: Vec<Panel>,
}

/// One quantity of a line chart.
#[derive(Clone, Debug, PartialEq)]
pub struct Panel {
    /// Quantity and unit, for example `Δd [µm]`.
    pub y_title: String,
    /// Smallest span of the ordinate in its unit: noise below it stays a flat line. 0 = no limit.
    pub least_span: f64,
    /// Linear or logarithmic ordinate.
    pub scale: YScale,
    /// Lines; equal names in different panels share style and legend entry.
    pub series: Vec<Series>,
}

impl Panel {
    /// A panel with a linear ordinate.
    pub fn linear(y_title: impl Into<String>, least_span: f64, series: Vec<Series>) -> Self {
        Self { y_title: y_title.into(), least_span, scale: YScale::Linear, series }
    }
}

/// Scale of an ordinate.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum YScale {
    /// Equal steps.
    Linear,
    /// Decades; values that are not positive are drawn at the lower edge.
    Logarithmic,
}

/// One line.
#[derive(Clone, Debug, PartialEq)]
pub struct Series {
    /// Name in the legend.
    pub name: String,
    /// Abscissae.
    pub x: Vec<f64>,
    /// Ordinates, as many as abscissae.
    pub y: Vec<f64>,
    /// What is drawn at its points.
    pub marks: Marks,
}

/// What a line shows at its points.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Marks {
    /// A marker at a few of them, so that the line stays visible.
    Few,
    /// A marker at each, filled or open; as many as points.
    Each(Vec<bool>),
    /// A marker at each, and no line between them.
    Points,
    /// None, though the line has a style of its own.
    Bare,
    /// None: the line is a level that others are compared with, thin and solid.
    Level,
    /// None: the line is a limit of others, thin and dashed.
    Limit,
    /// A bar from zero to each, and no line between them.
    Bars,
    /// A text at each, no line between them and no place in the legend; as many as points.
    Texts(Vec<String>),
    /// A ring about each and a text beside it, and no line between them; as many as points. Texts that find no room are left out.
    Rings(Vec<String>),
}

impl Series {
    /// A line through the points (x, y).
    pub fn new(name: impl Into<String>, x: Vec<f64>, y: Vec<f64>) -> Self {
        Self { name: name.into(), x, y, marks: Marks::Few }
    }

    /// With a marker at every point, filled or open.
    pub fn marked(self, filled: Vec<bool>) -> Self {
        Self { marks: Marks::Each(filled), ..self }
    }

    /// Without markers.
    pub fn bare(self) -> Self {
        Self { marks: Marks::Bare, ..self }
    }

    /// Points (x, y) that nothing joins.
    pub fn points(name: impl Into<String>, x: Vec<f64>, y: Vec<f64>) -> Self {
        Self { name: name.into(), x, y, marks: Marks::Points }
    }

    /// A level over a range of the abscissa that other lines are compared with.
    pub fn level(name: impl Into<String>, x: [f64; 2], y: f64) -> Self {
        Self { name: name.into(), x: x.to_vec(), y: vec![y; 2], marks: Marks::Level }
    }

    /// A limit that others keep to or leave, through the points (x, y).
    pub fn limit(name: impl Into<String>, x: Vec<f64>, y: Vec<f64>) -> Self {
        Self { name: name.into(), x, y, marks: Marks::Limit }
    }

    /// Bars from zero to the points (x, y).
    pub fn bars(name: impl Into<String>, x: Vec<f64>, y: Vec<f64>) -> Self {
        Self { name: name.into(), x, y, marks: Marks::Bars }
    }

    /// Rings about points [x, y] of other lines, each with its text.
    pub fn rings(name: impl Into<String>, points: Vec<([f64; 2], String)>) -> Self {
        let (at, texts): (Vec<[f64; 2]>, Vec<String>) = points.into_iter().unzip();
        let [x, y] = [0, 1].map(|k| at.iter().map(|at| at[k]).collect());
        Self { name: name.into(), x, y, marks: Marks::Rings(texts) }
    }

    /// Texts centred at points [x, y]; the name is for errors only.
    pub fn texts(name: impl Into<String>, points: Vec<([f64; 2], String)>) -> Self {
        let Self { name, x, y, marks } = Self::rings(name, points);
        let marks = if let Marks::Rings(texts) = marks { Marks::Texts(texts) } else { marks };
        Self { name, x, y, marks }
    }
}

/// How the panels of a line chart are laid out where the usual way does not serve.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct LineFrame {
    /// Height of a panel, points; the usual one depends on the number of panels.
    pub panel_height: Option<f64>,
    /// Room beside the first and the last abscissa, in units of the abscissa.
    pub beside: f64,
}

const WIDTH: f64 = 880.0;
const LEFT: f64 = 66.0;
const RIGHT: f64 = 16.0;
/// Room above a panel for its title.
const PANEL_HEAD: f64 = 22.0;
/// Least distance of a limit from the frame, as a share of the values' range.
const LIMIT_ROOM: f64 = 0.04;

/// Draws the panels of a line chart one below the other.
///
/// # Errors
/// [`ChartError`] without panels or series, for a series without points, x and y of different length, or a value
/// that is not finite; the error names the series.
pub fn line_chart(chart: &LineChart) -> Result<Svg, ChartError> {
    line_chart_in(chart, &LineFrame::default())
}

/// As [`line_chart`], in a layout of its own.
///
/// # Errors
/// Those of [`line_chart`]; [`ChartError::InvalidNumber`] for a layout that is not finite.
pub fn line_chart_in(chart: &LineChart, layout: &LineFrame) -> Result<Svg, ChartError> {
    check(chart)?;
    check_values("layout of the line chart", &[layout.panel_height.unwrap_or(0.0), layout.beside])?;
    let legend = line_legend::entries(chart);
    let usual = if chart.panels.len() == 1 { 220.0 } else { 104.0 };
    let panel_height = layout.panel_height.unwrap_or(usual);
    let places = line_legend::places(&legend);
    let rows = places.last().map_or(0.0, |at| at[1]);
    let top = 50.0 + rows;
    let height = top + chart.panels.len() as f64 * (PANEL_HEAD + panel_height + 10.0) + 36.0;
    let mut canvas = Canvas::new(WIDTH, height, &chart.title);
    canvas.heading("");
    line_legend::draw(&mut canvas, &legend, &places);
    let (lo, hi) = range(chart.panels.iter().flat_map(|p| &p.series).flat_map(|s| &s.x));
    let mut abscissae = chart.panels.iter().flat_map(|p| &p.series).flat_map(|s| &s.x);
    let whole = abscissae.all(|x| x.fract() == 0.0);
    let (lo, hi) = (lo - layout.beside, hi + layout.beside);
    let x_axis = if whole { Axis::counts(lo, hi, 10) } else { Axis::tight(lo, hi, 10) };
    for (k, panel) in chart.panels.iter().enumerate() {
        let frame = Frame {
            left: LEFT,
            top: top + k as f64 * (PANEL_HEAD + panel_height + 10.0) + PANEL_HEAD,
            width: WIDTH - LEFT - RIGHT,
            height: panel_height,
        };
        draw_panel(&mut canvas, frame, panel, &x_axis, &legend);
        if k + 1 == chart.panels.len() {
            frame.abscissa(&mut canvas, &x_axis, &chart.x_title);
        }
    }
    Ok(canvas.finish())
}

fn check(chart: &LineChart) -> Result<(), ChartError> {
    check_count("line chart panels", chart.panels.len(), 1)?;
    for panel in &chart.panels {
        check_count(&panel.y_title, panel.series.len(), 1)?;
        check_values(&panel.y_title, &[panel.least_span])?;
        for series in &panel.series {
            let quantity = format!("{}, {}", panel.y_title, series.name);
            check_count(&quantity, series.x.len(), 1)?;
            check_length(&quantity, series.x.len(), series.y.len())?;
            check_values(&format!("{quantity}, abscissa"), &series.x)?;
            check_values(&quantity, &series.y)?;
            let marks = match &series.marks {
                Marks::Each(filled) => filled.len(),
                Marks::Rings(texts) | Marks::Texts(texts) => texts.len(),
                _ => series.x.len(),
            };
            check_length(&format!("{quantity}, markers"), series.x.len(), marks)?;
        }
    }
    Ok(())
}

fn range<'a>(values: impl Iterator<Item = &'a f64>) -> (f64, f64) {
    values.fold((f64::INFINITY, f64::NEG_INFINITY), |(lo, hi), &v| (lo.min(v), hi.max(v)))
}

fn draw_panel(canvas: &mut Canvas, frame: Frame, panel: &Panel, x_axis: &Axis, legend: &[Entry<'_>]) {
    let zero = panel.series.iter().any(|series| series.marks == Marks::Bars).then_some(&0.0);
    let values = || panel.series.iter().flat_map(|series| &series.y).chain(zero);
    let count = match frame.height {
        low if low < 150.0 => 5,
        usual if usual < 300.0 => 7,
        _ => 12,
    };
    // A level keeps clear of the edges of a logarithmic panel, where the frame would hide it.
    let levels = panel.series.iter().filter(|s| matches!(s.marks, Marks::Level | Marks::Limit));
    let beside: Vec<f64> = levels.flat_map(|s| &s.y).flat_map(|y| [0.5 * y, 2.0 * y]).collect();
    let positive = range(values().chain(&beside).filter(|v| **v > 0.0));
    let y_axis = match panel.scale {
        YScale::Logarithmic if positive.1 > 0.0 => Axis::decades(positive.0, positive.1),
        _ => {
            let (lo, hi) = range(values());
            // A limit keeps clear of the frame, which would hide it.
            let room = LIMIT_ROOM * (hi - lo);
            let limits = panel.series.iter().filter(|s| s.marks == Marks::Limit).flat_map(|s| &s.y);
            let (least, greatest) = range(limits);
            Axis::rounded(lo.min(least - room), hi.max(greatest + room), count, panel.least_span)
        }
    };
    frame.grid(canvas, x_axis, &y_axis);
    if panel.scale == YScale::Linear {
        frame.zero_line(canvas, &y_axis);
    }
    let title = with_factor(&panel.y_title, &y_axis);
    canvas.text([frame.left, frame.top - 7.0], &title, TextStyle::new(TICK_SIZE, Anchor::Start).bold());
    frame.ordinate(canvas, &y_axis);
    frame.outline(canvas);
    let foot = frame.at(0.0, y_axis.share(0.0))[1];
    for series in &panel.series {
        let points: Vec<[f64; 2]> = series
            .x
            .iter()
            .zip(&series.y)
            .map(|(&x, &y)| frame.at(x_axis.share(x), y_axis.share(y)))
            .collect();
        if let Marks::Texts(texts) = &series.marks {
            draw_texts(canvas, &points, texts);
            continue;
        }
        let place = legend.iter().position(|entry| entry.name == series.name).unwrap_or(0);
        if let Some(entry) = legend.get(place) {
            draw_series(canvas, &frame, foot, (series, &points), (entry, place));
        }
    }
}

/// Draws the `place`-th series of the legend; `foot` is where bars stand.
fn draw_series(
    canvas: &mut Canvas,
    frame: &Frame,
    foot: f64,
    (series, points): (&Series, &[[f64; 2]]),
    (entry, place): (&Entry<'_>, usize),
) {
    match &series.marks {
        Marks::Points => {}
        Marks::Bars => draw_bars(canvas, points, foot, frame.width, entry.stroke().color),
        Marks::Rings(texts) => draw_rings(canvas, frame, points, texts),
        _ => canvas.polylines(&[points.to_vec()], entry.stroke()),
    }
    let Some(style) = &entry.style else { return };
    match &series.marks {
        Marks::Few => marked(points.len(), place).into_iter().for_each(|k| {
            draw_marker(canvas, points[k], style, None);
        }),
        Marks::Each(filled) => points.iter().zip(filled).for_each(|(at, filled)| {
            draw_marker(canvas, *at, style, Some(*filled));
        }),
        Marks::Points => points.iter().for_each(|at| draw_marker(canvas, *at, style, None)),
        Marks::Bare | Marks::Level | Marks::Limit | Marks::Bars | Marks::Texts(_) | Marks::Rings(_) => {}
    }
}
