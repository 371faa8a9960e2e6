//! Lines over a common abscissa, in one panel or in a stack of small panels.

use super::axes::{Frame, TICK_SIZE, with_factor};
use super::error::{ChartError, check_count, check_length, check_values};
use super::palette::{Marker, SeriesStyle, series_style};
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
}

impl Series {
    /// A line through the points (x, y).
    pub fn new(name: impl Into<String>, x: Vec<f64>, y: Vec<f64>) -> Self {
        Self { name: name.into(), x, y }
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
    let names = legend_names(chart);
    let panel_height = if chart.panels.len() == 1 { 220.0 } else { 104.0 };
    let top = 50.0;
    let height = top + chart.panels.len() as f64 * (PANEL_HEAD + panel_height + 10.0) + 36.0;
    let mut canvas = Canvas::new(WIDTH, height, &chart.title);
    canvas.heading("");
    draw_legend(&mut canvas, &names);
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
        draw_panel(&mut canvas, frame, panel, &x_axis, &names);
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
        }
    }
    Ok(())
}

/// Names in order of appearance; the place in the list gives the style.
fn legend_names(chart: &LineChart) -> Vec<&str> {
    let mut names: Vec<&str> = Vec::new();
    for series in chart.panels.iter().flat_map(|panel| &panel.series) {
        if !names.contains(&series.name.as_str()) {
            names.push(&series.name);
        }
    }
    names
}

fn range<'a>(values: impl Iterator<Item = &'a f64>) -> (f64, f64) {
    values.fold((f64::INFINITY, f64::NEG_INFINITY), |(lo, hi), &v| (lo.min(v), hi.max(v)))
}

fn draw_legend(canvas: &mut Canvas, names: &[&str]) {
    let mut x = 0.0;
    for (k, name) in names.iter().enumerate() {
        let style = series_style(k);
        let y = 38.0;
        canvas.line([x, y], [x + 34.0, y], Stroke { color: style.color, width: 1.8, dash: style.dash });
        draw_marker(canvas, [x + 17.0, y], &style);
        canvas.text([x + 40.0, y + 4.2], name, TextStyle::new(TICK_SIZE, Anchor::Start));
        x += 40.0 + text_width(name, TICK_SIZE) + 22.0;
    }
}

fn draw_panel(canvas: &mut Canvas, frame: Frame, panel: &Panel, x_axis: &Axis, names: &[&str]) {
    let values = || panel.series.iter().flat_map(|series| &series.y);
    let count = if frame.height < 150.0 { 5 } else { 7 };
    let positive = range(values().filter(|v| **v > 0.0));
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
        let place = names.iter().position(|name| *name == series.name).unwrap_or(0);
        let style = series_style(place);
        let points: Vec<[f64; 2]> = series
            .x
            .iter()
            .zip(&series.y)
            .map(|(&x, &y)| frame.at(x_axis.share(x), y_axis.share(y)))
            .collect();
        let line = Stroke { color: style.color, width: 1.8, dash: style.dash };
        canvas.polylines(std::slice::from_ref(&points), line);
        for k in marked(points.len(), place) {
            draw_marker(canvas, points[k], &style);
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

fn draw_marker(canvas: &mut Canvas, at: [f64; 2], style: &SeriesStyle) {
    let stroke = Stroke::solid(style.color, 1.4);
    let [x, y] = at;
    let r = 3.4;
    match style.marker {
        Marker::Disc => canvas.disc(at, r, style.color, stroke),
        Marker::Square => {
            canvas.rect([x - r, y - r], [2.0 * r, 2.0 * r], "#ffffff", Some(stroke));
        }
        Marker::Triangle => {
            let corners = vec![[x, y - 1.2 * r], [x + 1.1 * r, y + 0.8 * r], [x - 1.1 * r, y + 0.8 * r]];
            canvas.loops(&[corners], "#ffffff", Some(stroke));
        }
        Marker::Diamond => {
            let corners = vec![[x, y - 1.3 * r], [x + 1.3 * r, y], [x, y + 1.3 * r], [x - 1.3 * r, y]];
            canvas.loops(&[corners], style.color, Some(stroke));
        }
    }
}
