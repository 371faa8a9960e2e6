//! Lines over a common abscissa, in one panel or in a stack of small panels.

use super::axes::{Frame, TICK_SIZE, with_factor};
use super::error::{ChartError, check_count, check_length, check_values};
use super::line_legend::{self, Entry};
use super::line_marks::{draw_bars, draw_marker, draw_rings, draw_texts, marked};
use super::line_series::{LineChart, LineFrame, Marks, Panel, Series, YScale};
use super::scale::Axis;
use super::svg::{Anchor, Canvas, Svg, TextStyle};

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
