//! What stands at the points of a line: markers, bars, rings with their texts. Knows places on the page only.

use super::axes::{Frame, TICK_SIZE};
use super::palette::{INK, Marker, SeriesStyle};
use super::svg::{Anchor, Canvas, Stroke, TextStyle};
use super::text::{Area, text_width};

/// Few points carry a marker, so that the line stays visible: at most nine, evenly spread. Neighbouring series mark
/// different points, so that coinciding lines show both markers.
pub(super) fn marked(count: usize, series: usize) -> Vec<usize> {
    if count <= 9 {
        return (0..count).collect();
    }
    let shift = (series % 2) * (count - 1) / 16;
    (0..9).map(|k| k * (count - 1) / 8 + shift).filter(|k| *k < count).collect()
}

/// A marker; `filled` overrides what its shape has by itself.
pub(super) fn draw_marker(canvas: &mut Canvas, at: [f64; 2], style: &SeriesStyle, filled: Option<bool>) {
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

/// Share of the distance of neighbours that a bar fills, and its greatest width.
const BAR_SHARE: f64 = 0.62;
const WIDEST_BAR: f64 = 26.0;

/// Ground of a bar.
pub(super) const fn bar_ground() -> &'static str {
    "#d5dde6"
}

/// Bars from `foot` to points that go from left to right.
pub(super) fn draw_bars(canvas: &mut Canvas, points: &[[f64; 2]], foot: f64, room: f64, color: &str) {
    let gap = points.windows(2).map(|pair| (pair[1][0] - pair[0][0]).abs()).fold(room, f64::min);
    let width = (BAR_SHARE * gap).min(WIDEST_BAR);
    for [x, y] in points {
        let corner = [x - 0.5 * width, y.min(foot)];
        canvas.rect(corner, [width, (y - foot).abs()], bar_ground(), Some(Stroke::solid(color, 1.0)));
    }
}

/// Texts centred at points.
pub(super) fn draw_texts(canvas: &mut Canvas, points: &[[f64; 2]], texts: &[String]) {
    for ([x, y], text) in points.iter().zip(texts) {
        canvas.text([*x, y + 4.0], text, TextStyle::new(RING_TEXT, Anchor::Middle).halo());
    }
}

const RING: f64 = 6.5;
const RING_TEXT: f64 = 11.0;

/// A ring about a point of another line.
pub(super) fn draw_ring(canvas: &mut Canvas, at: [f64; 2]) {
    canvas.disc(at, RING, "none", Stroke::solid(INK, 1.6));
}

/// Rings, each with its text above, below, to the right or to the left: where it stays inside the frame and free of the rings and
/// of texts before it.
pub(super) fn draw_rings(canvas: &mut Canvas, frame: &Frame, points: &[[f64; 2]], texts: &[String]) {
    let inside = Area { x: frame.left, y: frame.top, width: frame.width, height: frame.height };
    let mut taken: Vec<Area> =
        points.iter().map(|[x, y]| Area::around(*x, *y, 2.0 * RING, 2.0 * RING)).collect();
    for (at, text) in points.iter().zip(texts) {
        draw_ring(canvas, *at);
        let (width, height) = (text_width(text, RING_TEXT), TICK_SIZE);
        let (aside, above) = (RING + 3.0 + 0.5 * width, RING + 1.0 + 0.5 * height);
        let shifts = [[0.0, -above], [0.0, above], [aside, 0.0], [-aside, 0.0]];
        let areas = shifts.map(|[dx, dy]| Area::around(at[0] + dx, at[1] + dy, width, height));
        let free = |area: &&Area| inside.contains(area) && !taken.iter().any(|other| other.overlaps(area));
        let Some(area) = areas.iter().find(free).copied() else { continue };
        let style = TextStyle::new(RING_TEXT, Anchor::Middle).bold().halo();
        canvas.text([area.x + 0.5 * width, area.y + 0.5 * height + 4.0], text, style);
        taken.push(area);
    }
}
