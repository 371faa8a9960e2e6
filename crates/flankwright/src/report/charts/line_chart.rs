//! Lines over a common abscissa, in one panel or in a stack of small panels.

use super::axes::{Frame, TICK_SIZE, with_factor};
use super::error::{ChartError, check_count, check_length, check_values};
use super::palette::{INK, Marker, SeriesStyle, series_style};
use super::scale::Axis;
use super::svg::{Anchor, Canvas, Stroke, Svg, TextStyle};
use super::text::text_width;

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
    /// None: the line is a level that others are compared with, thin and solid.
    Level,
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

    /// Points (x, y) that nothing joins.
    pub fn points(name: impl Into<String>, x: Vec<f64>, y: Vec<f64>) -> Self {
        Self { name: name.into(), x, y, marks: Marks::Points }
    }

    /// A level over a range of the abscissa that other lines are compared with.
    pub fn level(name: impl Into<String>, x: [f64; 2], y: f64) -> Self {
        Self { name: name.into(), x: x.to_vec(), y: vec![y; 2], marks: Marks::Level }
    }
}

const WIDTH: f64 = 880.0;
const LEFT: f64 = 66.0;
const RIGHT: f64 = 16.0;
/// Room above a panel for its title.
const PANEL_HEAD: f64 = 22.0;

/// Draws the panels of a line chart one below the other.
///
/// # Errors
/// [`ChartError`] without panels or series, for a series without points, x and y of different length, or a value
/// that is not finite; the error names the series.
pub fn line_chart(chart: &LineChart) -> Result<Svg, ChartError> {
    check(chart)?;
    let legend = legend(chart);
    let panel_height = if chart.panels.len() == 1 { 220.0 } else { 104.0 };
    let places = legend_places(&legend);
    let rows = places.last().map_or(0.0, |at| at[1]);
    let top = 50.0 + rows;
    let height = top + chart.panels.len() as f64 * (PANEL_HEAD + panel_height + 10.0) + 36.0;
    let mut canvas = Canvas::new(WIDTH, height, &chart.title);
    canvas.heading("");
    draw_legend(&mut canvas, &legend, &places);
    let (lo, hi) = range(chart.panels.iter().flat_map(|p| &p.series).flat_map(|s| &s.x));
    let mut abscissae = chart.panels.iter().flat_map(|p| &p.series).flat_map(|s| &s.x);
    let whole = abscissae.all(|x| x.fract() == 0.0);
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
            if let Marks::Each(filled) = &series.marks {
                check_length(&format!("{quantity}, markers"), series.x.len(), filled.len())?;
            }
        }
    }
    Ok(())
}

/// Name and style of the lines in order of appearance; levels have a style of their own and take none of the others.
fn legend(chart: &LineChart) -> Vec<(&str, Option<SeriesStyle>)> {
    let mut entries: Vec<(&str, Option<SeriesStyle>)> = Vec::new();
    let mut styles = 0;
    for series in chart.panels.iter().flat_map(|panel| &panel.series) {
        if entries.iter().any(|(name, _)| *name == series.name.as_str()) {
            continue;
        }
        let style = (series.marks != Marks::Level).then(|| series_style(styles));
        styles += usize::from(style.is_some());
        entries.push((&series.name, style));
    }
    entries
}

fn range<'a>(values: impl Iterator<Item = &'a f64>) -> (f64, f64) {
    values.fold((f64::INFINITY, f64::NEG_INFINITY), |(lo, hi), &v| (lo.min(v), hi.max(v)))
}

/// How a line is drawn.
fn stroke(style: Option<&SeriesStyle>) -> Stroke<'static> {
    match style {
        Some(style) => Stroke { color: style.color, width: 1.8, dash: style.dash },
        None => Stroke::solid(INK, 1.0),
    }
}

/// Line and gap of a legend entry before its name, and the gap behind it.
const LEGEND_LINE: f64 = 40.0;
const LEGEND_GAP: f64 = 22.0;
const LEGEND_ROW: f64 = 16.0;

/// Where the entries of the legend begin, relative to the first; a full row is followed by another.
fn legend_places(entries: &[(&str, Option<SeriesStyle>)]) -> Vec<[f64; 2]> {
    let (mut x, mut y) = (0.0, 0.0);
    let mut places = Vec::with_capacity(entries.len());
    for (name, _) in entries {
        let width = LEGEND_LINE + text_width(name, TICK_SIZE);
        if x > 0.0 && x + width > WIDTH {
            (x, y) = (0.0, y + LEGEND_ROW);
        }
        places.push([x, y]);
        x += width + LEGEND_GAP;
    }
    places
}

fn draw_legend(canvas: &mut Canvas, entries: &[(&str, Option<SeriesStyle>)], places: &[[f64; 2]]) {
    for ((name, style), [x, row]) in entries.iter().zip(places) {
        let y = 38.0 + row;
        canvas.line([*x, y], [x + 34.0, y], stroke(style.as_ref()));
        if let Some(style) = style {
            draw_marker(canvas, [x + 17.0, y], style, None);
        }
        canvas.text([x + LEGEND_LINE, y + 4.2], name, TextStyle::new(TICK_SIZE, Anchor::Start));
    }
}

fn draw_panel(
    canvas: &mut Canvas,
    frame: Frame,
    panel: &Panel,
    x_axis: &Axis,
    legend: &[(&str, Option<SeriesStyle>)],
) {
    let values = || panel.series.iter().flat_map(|series| &series.y);
    let count = if frame.height < 150.0 { 5 } else { 7 };
    // A level keeps clear of the edges of a logarithmic panel, where the frame would hide it.
    let levels = panel.series.iter().filter(|s| s.marks == Marks::Level).flat_map(|s| &s.y);
    let beside: Vec<f64> = levels.flat_map(|y| [0.5 * y, 2.0 * y]).collect();
    let positive = range(values().chain(&beside).filter(|v| **v > 0.0));
    let y_axis = match panel.scale {
        YScale::Logarithmic if positive.1 > 0.0 => Axis::decades(positive.0, positive.1),
        _ => {
            let (lo, hi) = range(values());
            Axis::rounded(lo, hi, count, panel.least_span)
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
    for series in &panel.series {
        let place = legend.iter().position(|(name, _)| *name == series.name).unwrap_or(0);
        let style = legend.get(place).and_then(|(_, style)| style.as_ref());
        let points: Vec<[f64; 2]> = series
            .x
            .iter()
            .zip(&series.y)
            .map(|(&x, &y)| frame.at(x_axis.share(x), y_axis.share(y)))
            .collect();
        if series.marks != Marks::Points {
            canvas.polylines(std::slice::from_ref(&points), stroke(style));
        }
        match (style, &series.marks) {
            (Some(style), Marks::Few) => {
                for k in marked(points.len(), place) {
                    draw_marker(canvas, points[k], style, None);
                }
            }
            (Some(style), Marks::Each(filled)) => {
                for (at, filled) in points.iter().zip(filled) {
                    draw_marker(canvas, *at, style, Some(*filled));
                }
            }
            (Some(style), Marks::Points) => {
                for at in &points {
                    draw_marker(canvas, *at, style, None);
                }
            }
            (_, Marks::Level) | (None, _) => {}
        }
    }
}

/// Few points carry a marker, so that the line stays visible: at most nine, evenly spread. Neighbouring series mark
/// different points, so that coinciding lines show both markers.
fn marked(count: usize, series: usize) -> Vec<usize> {
    if count <= 9 {
        return (0..count).collect();
    }
    let shift = (series % 2) * (count - 1) / 16;
    (0..9).map(|k| k * (count - 1) / 8 + shift).filter(|k| *k < count).collect()
}

/// A marker; `filled` overrides what its shape has by itself.
fn draw_marker(canvas: &mut Canvas, at: [f64; 2], style: &SeriesStyle, filled: Option<bool>) {
    let stroke = Stroke::solid(style.color, 1.4);
    let [x, y] = at;
    let r = 3.4;
    let own = matches!(style.marker, Marker::Disc | Marker::Diamond);
    let fill = if filled.unwrap_or(own) { style.color } else { "#ffffff" };
    match style.marker {
        Marker::Disc => canvas.disc(at, r, fill, stroke),
        Marker::Square => canvas.rect([x - r, y - r], [2.0 * r, 2.0 * r], fill, Some(stroke)),
        Marker::Bar => canvas.rect([x - 0.5 * r, y - 1.3 * r], [r, 2.6 * r], fill, Some(stroke)),
        Marker::Triangle => {
            let corners = vec![[x, y - 1.2 * r], [x + 1.1 * r, y + 0.8 * r], [x - 1.1 * r, y + 0.8 * r]];
            canvas.loops(&[corners], fill, Some(stroke));
        }
        Marker::TriangleDown => {
            let corners = vec![[x, y + 1.2 * r], [x + 1.1 * r, y - 0.8 * r], [x - 1.1 * r, y - 0.8 * r]];
            canvas.loops(&[corners], fill, Some(stroke));
        }
        Marker::Diamond => {
            let corners = vec![[x, y - 1.3 * r], [x + 1.3 * r, y], [x, y + 1.3 * r], [x - 1.3 * r, y]];
            canvas.loops(&[corners], fill, Some(stroke));
        }
    }
}
