//! The legend of a line chart: every name once, with the style that its lines share.

use super::axes::TICK_SIZE;
use super::line_marks::{bar_ground, draw_marker, draw_ring};
use super::line_series::{LineChart, Marks};
use super::palette::{INK, SeriesStyle, series_style};
use super::svg::{Anchor, Canvas, Stroke, TextStyle};
use super::text::text_width;

/// A name of the legend and how its lines look.
pub(super) struct Entry<'a> {
    pub(super) name: &'a str,
    /// One of the styles that tell series apart; levels, limits and rings have a look of their own.
    pub(super) style: Option<SeriesStyle>,
    marks: &'a Marks,
}

impl Entry<'_> {
    /// How its line is drawn.
    pub(super) fn stroke(&self) -> Stroke<'static> {
        match (&self.style, self.marks) {
            (Some(style), _) => Stroke { color: style.color, width: 1.8, dash: style.dash },
            (None, Marks::Limit) => Stroke { color: INK, width: 1.2, dash: "5 3" },
            (None, _) => Stroke::solid(INK, 1.0),
        }
    }
}

/// Line and gap of an entry before its name, and the gap behind it.
const LINE: f64 = 40.0;
const GAP: f64 = 22.0;
const ROW: f64 = 16.0;
/// Width that the entries share.
const WIDTH: f64 = 880.0;

/// Entries in order of appearance; levels, limits and rings take none of the styles.
pub(super) fn entries(chart: &LineChart) -> Vec<Entry<'_>> {
    let mut entries: Vec<Entry<'_>> = Vec::new();
    let mut styles = 0;
    for series in chart.panels.iter().flat_map(|panel| &panel.series) {
        if matches!(series.marks, Marks::Texts(_))
            || entries.iter().any(|entry| entry.name == series.name.as_str())
        {
            continue;
        }
        let plain = matches!(series.marks, Marks::Level | Marks::Limit | Marks::Rings(_));
        let style = (!plain).then(|| series_style(styles));
        styles += usize::from(style.is_some());
        entries.push(Entry { name: &series.name, style, marks: &series.marks });
    }
    entries
}

/// Where the entries begin, relative to the first; a full row is followed by another.
pub(super) fn places(entries: &[Entry<'_>]) -> Vec<[f64; 2]> {
    let (mut x, mut y) = (0.0, 0.0);
    let mut places = Vec::with_capacity(entries.len());
    for entry in entries {
        let width = LINE + text_width(entry.name, TICK_SIZE);
        if x > 0.0 && x + width > WIDTH {
            (x, y) = (0.0, y + ROW);
        }
        places.push([x, y]);
        x += width + GAP;
    }
    places
}

/// Draws the entries at their places.
pub(super) fn draw(canvas: &mut Canvas, entries: &[Entry<'_>], places: &[[f64; 2]]) {
    for (entry, [x, row]) in entries.iter().zip(places) {
        let y = 38.0 + row;
        let middle = [x + 17.0, y];
        match (entry.marks, &entry.style) {
            (Marks::Rings(_), _) => draw_ring(canvas, middle),
            (Marks::Bars, _) => {
                let color = entry.stroke().color;
                canvas.rect([x + 8.0, y - 5.0], [18.0, 10.0], bar_ground(), Some(Stroke::solid(color, 1.0)));
            }
            (marks, style) => {
                if *marks != Marks::Points {
                    canvas.line([*x, y], [x + 34.0, y], entry.stroke());
                }
                if let (Some(style), false) = (style, *entry.marks == Marks::Bare) {
                    draw_marker(canvas, middle, style, None);
                }
            }
        }
        canvas.text([x + LINE, y + 4.2], entry.name, TextStyle::new(TICK_SIZE, Anchor::Start));
    }
}
