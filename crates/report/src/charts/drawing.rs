//! Drawings of bodies and paths: lines with equal scales on both axes, distinguished by width, dash and background.

use super::axes::{Frame, TICK_SIZE, horizontal_bar};
use super::error::{ChartError, check_count, check_values};
use super::hatch::{Lean, hatch_lines};
use super::numbers::format_fixed;
use super::palette::{FAINT, INK, MUTED, series_style};
use super::scale::{Axis, decimals_of, round_below};
use super::svg::{Anchor, Canvas, Stroke, Svg, TextStyle};
use super::text::text_width;
use serde::Serialize;

/// A drawing. Places are [to the right, upwards], mm.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Drawing {
    /// Heading.
    pub title: String,
    /// Line below it, for example from where the view is.
    pub subtitle: String,
    /// Titles of both axes; without them a bar tells the scale, as views askew need it.
    pub axes: Option<[String; 2]>,
    /// From the ground upwards.
    pub layers: Vec<DrawingLayer>,
    /// Places with a name.
    pub notes: Vec<DrawingNote>,
}

/// Lines that look alike.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct DrawingLayer {
    /// Name in the legend.
    pub name: String,
    /// How they look.
    pub look: DrawingLook,
    /// The lines; bodies and materials are closed by the drawing.
    pub lines_mm: Vec<Vec<[f64; 2]>>,
}

/// How a layer looks.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum DrawingLook {
    /// Closed outlines with a light ground.
    Body,
    /// As a body, its outline dashed.
    OtherBody,
    /// Closed areas, hatched.
    Material,
    /// Lines on a surface that faces the viewer.
    Net,
    /// Lines on a surface that is seen from behind, through its material.
    HiddenNet,
    /// Thick lines.
    Edge,
    /// Thick lines, dashed.
    OtherEdge,
    /// Thick lines, dotted.
    DottedEdge,
    /// Paths of the k-th kind, each with a dot where it begins.
    Path(usize),
}

/// A place with a name.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct DrawingNote {
    /// Where.
    pub at_mm: [f64; 2],
    /// What stands beside it.
    pub text: String,
}

const WIDTH: f64 = 880.0;
const LEFT: f64 = 62.0;
const RIGHT: f64 = 14.0;
const TALLEST: f64 = 430.0;
const LEAST_HEIGHT: f64 = 150.0;
/// Room beside what is drawn, as a share of its size.
const BESIDE: f64 = 0.04;
const BODY: &str = "#e8edf2";
const LEGEND_ROW: f64 = 18.0;
const LEGEND_LINE: f64 = 37.0;

impl DrawingLook {
    fn stroke(self) -> Stroke<'static> {
        match self {
            Self::Body => Stroke::solid(INK, 1.3),
            Self::OtherBody => Stroke { color: INK, width: 1.3, dash: "6 3" },
            Self::Material => Stroke::solid(INK, 0.9),
            Self::Net => Stroke::solid(MUTED, 0.7),
            Self::HiddenNet => Stroke { color: FAINT, width: 0.6, dash: "3 2" },
            Self::Edge => Stroke::solid(INK, 2.4),
            Self::OtherEdge => Stroke { color: INK, width: 2.4, dash: "9 3" },
            Self::DottedEdge => Stroke { color: INK, width: 2.4, dash: "2 2.5" },
            Self::Path(kind) => {
                let style = series_style(kind);
                Stroke { color: style.color, width: 1.2, dash: style.dash }
            }
        }
    }

    fn is_closed(self) -> bool {
        matches!(self, Self::Body | Self::OtherBody | Self::Material)
    }
}

/// Draws with equal scales on both axes.
///
/// # Errors
/// [`ChartError`] without any point, and for values that are not finite; the error names the layer.
pub fn drawing(chart: &Drawing) -> Result<Svg, ChartError> {
    let layers: Vec<&DrawingLayer> =
        chart.layers.iter().filter(|layer| layer.lines_mm.iter().any(|line| !line.is_empty())).collect();
    check_count(&chart.title, layers.len(), 1)?;
    for layer in &layers {
        layer.lines_mm.iter().try_for_each(|line| check_values(&layer.name, line.as_flattened()))?;
    }
    chart.notes.iter().try_for_each(|note| check_values(&note.text, &note.at_mm))?;
    let legend = legend_places(&layers);
    let top = 62.0 + legend.last().map_or(0.0, |at| at[1]);
    let window = Window::around(chart, &layers, top);
    let foot = if chart.axes.is_some() { 42.0 } else { 30.0 };
    let mut canvas = Canvas::new(WIDTH, window.frame.bottom() + foot, &chart.title);
    canvas.heading(&chart.subtitle);
    for (layer, at) in layers.iter().zip(&legend) {
        draw_entry(&mut canvas, layer, [at[0], at[1] + 50.0]);
    }
    if chart.axes.is_some() {
        window.frame.grid(&mut canvas, &window.right, &window.up);
    }
    layers.iter().for_each(|layer| draw_layer(&mut canvas, &window, layer));
    for note in &chart.notes {
        let at = window.place(&note.at_mm);
        canvas.disc(at, 2.6, "#ffffff", Stroke::solid(INK, 1.2));
        let style = TextStyle::new(TICK_SIZE, Anchor::Start).halo();
        canvas.text([at[0] + 6.0, at[1] - 5.0], &note.text, style);
    }
    match &chart.axes {
        Some([right, up]) => {
            window.frame.outline(&mut canvas);
            window.frame.abscissa(&mut canvas, &window.right, right);
            window.frame.ordinate(&mut canvas, &window.up);
            window.frame.ordinate_title(&mut canvas, &window.up, up, 46.0);
        }
        None => {
            let mm = round_below(120.0 / window.scale);
            let label = format!("{} mm", format_fixed(mm, decimals_of(mm)));
            horizontal_bar(&mut canvas, LEFT, window.frame.bottom() + 14.0, mm * window.scale, &label);
        }
    }
    Ok(canvas.finish())
}

fn draw_layer(canvas: &mut Canvas, window: &Window, layer: &DrawingLayer) {
    let stroke = layer.look.stroke();
    let lines: Vec<Vec<[f64; 2]>> =
        layer.lines_mm.iter().map(|line| line.iter().map(|p| window.place(p)).collect()).collect();
    if !layer.look.is_closed() {
        canvas.polylines(&lines, stroke);
        if matches!(layer.look, DrawingLook::Path(_)) {
            for start in lines.iter().filter_map(|line| line.first()) {
                canvas.disc(*start, 1.5, stroke.color, Stroke::solid(stroke.color, 0.5));
            }
        }
        return;
    }
    for line in lines {
        let ring = closed(line);
        match layer.look {
            DrawingLook::Material => {
                let hatch = hatch_lines(std::slice::from_ref(&ring), 9.0, Lean::Forward);
                canvas.polylines(&hatch, Stroke::solid(MUTED, 0.6));
                canvas.loops(&[ring], "none", Some(stroke));
            }
            _ => canvas.loops(&[ring], BODY, Some(stroke)),
        }
    }
}

fn closed(mut line: Vec<[f64; 2]>) -> Vec<[f64; 2]> {
    line.extend(line.first().copied());
    line
}

/// Where the entries of the legend begin, relative to the first.
fn legend_places(layers: &[&DrawingLayer]) -> Vec<[f64; 2]> {
    let (mut x, mut y) = (0.0, 0.0);
    let mut places = Vec::with_capacity(layers.len());
    for layer in layers {
        let width = LEGEND_LINE + text_width(&layer.name, TICK_SIZE);
        if x > 0.0 && x + width > WIDTH {
            (x, y) = (0.0, y + LEGEND_ROW);
        }
        places.push([x, y]);
        x += width + 20.0;
    }
    places
}

fn draw_entry(canvas: &mut Canvas, layer: &DrawingLayer, [x, y]: [f64; 2]) {
    let stroke = layer.look.stroke();
    if layer.look.is_closed() {
        let ring = closed(vec![[x, y - 6.0], [x + 30.0, y - 6.0], [x + 30.0, y + 6.0], [x, y + 6.0]]);
        if layer.look == DrawingLook::Material {
            let hatch = hatch_lines(std::slice::from_ref(&ring), 9.0, Lean::Forward);
            canvas.polylines(&hatch, Stroke::solid(MUTED, 0.6));
            canvas.loops(&[ring], "none", Some(stroke));
        } else {
            canvas.loops(&[ring], BODY, Some(stroke));
        }
    } else {
        canvas.line([x, y], [x + 30.0, y], stroke);
        if matches!(layer.look, DrawingLook::Path(_)) {
            canvas.disc([x, y], 1.5, stroke.color, Stroke::solid(stroke.color, 0.5));
        }
    }
    canvas.text([x + LEGEND_LINE, y + 4.2], &layer.name, TextStyle::new(TICK_SIZE, Anchor::Start));
}

/// The part of the plane that is drawn.
struct Window {
    frame: Frame,
    right: Axis,
    up: Axis,
    corner: [f64; 2],
    scale: f64,
}

impl Window {
    fn around(chart: &Drawing, layers: &[&DrawingLayer], top: f64) -> Self {
        let points = || {
            let lines = layers.iter().flat_map(|layer| layer.lines_mm.iter().flatten());
            lines.chain(chart.notes.iter().map(|note| &note.at_mm))
        };
        let span = |k: usize| {
            points().fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], p| [a.min(p[k]), b.max(p[k])])
        };
        let ([from, to], [low, high]) = (span(0), span(1));
        // A single point is drawn in the middle of a millimetre; what is smaller than that fills the frame.
        let size = (to - from).max(high - low);
        let beside = if size > 0.0 && size < 1.0 { BESIDE * size } else { (BESIDE * size).max(0.5) };
        let (from, to, low, high) = (from - beside, to + beside, low - beside, high + beside);
        let width = WIDTH - LEFT - RIGHT;
        let scale = (width / (to - from)).min(TALLEST / (high - low));
        let height = (scale * (high - low)).max(LEAST_HEIGHT);
        // The rest of the frame shows more of what is beside.
        let [aside, above] = [0.5 * (width / scale - (to - from)), 0.5 * (height / scale - (high - low))];
        let (from, to, low, high) = (from - aside, to + aside, low - above, high + above);
        Self {
            frame: Frame { left: LEFT, top, width, height },
            right: Axis::tight(from, to, 14),
            up: Axis::tight(low, high, 8),
            corner: [from, low],
            scale,
        }
    }

    fn place(&self, [right, up]: &[f64; 2]) -> [f64; 2] {
        [
            self.frame.left + (right - self.corner[0]) * self.scale,
            self.frame.bottom() - (up - self.corner[1]) * self.scale,
        ]
    }
}
