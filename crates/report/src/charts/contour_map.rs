//! Filled contour maps of topographies side by side, with one scale and one colour bar.

use super::axes::{Frame, TICK_SIZE};
use super::contours::{Line, isolines, region_above};
use super::error::{ChartError, check_count, check_values};
use super::hatch::{Lean, hatch_lines};
use super::palette::{INK, MUTED, signed_color};
use super::scale::{Axis, LevelScale};
use super::svg::{Anchor, Canvas, Stroke, Svg, TextStyle};
use super::text::{Area, text_width};
use super::topography::{NamedTopography, Topography};

/// Maps to draw beside each other.
#[derive(Clone, Debug, PartialEq)]
pub struct ContourMap {
    /// Heading of the chart.
    pub title: String,
    /// What the values are, with unit, for the colour bar; for example `f_n [µm]`.
    pub quantity: String,
    /// One panel per flank.
    pub panels: Vec<NamedTopography>,
    /// Levels shared with other maps; `None` takes them from these panels.
    pub scale: Option<LevelScale>,
}

/// What the axes of maps are called, and what is marked in them.
#[derive(Clone, Debug, PartialEq)]
pub struct MapFrame {
    /// Quantity and unit to the right and upwards.
    pub titles: [String; 2],
    /// Marks of each panel, in the order of the panels; panels beyond have none.
    pub marks: Vec<Vec<MapMark>>,
    /// What the values are.
    pub values: MapValues,
}

/// What a map shows.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum MapValues {
    /// Deviations in um: isolines, hatched where material is left standing.
    Deviation,
    /// Deviations in um that rise and fall many times, between which lines have no room: grounds without isolines, hatched below zero.
    Waves,
    /// Any other quantity, with its unit: isolines, not hatched.
    Quantity(String),
}

impl MapValues {
    fn heading(&self) -> &'static str {
        match self {
            Self::Waves => "dark: far from the wanted flank; hatched: below it (gouge)",
            Self::Deviation => "isolines: solid > 0, dashed < 0, thick = 0; hatched: material left standing",
            Self::Quantity(_) => "isolines of equal values, dark: large",
        }
    }

    fn unit(&self) -> &str {
        match self {
            Self::Waves | Self::Deviation => "µm",
            Self::Quantity(unit) => unit,
        }
    }
}

/// A place in a map.
#[derive(Clone, Debug, PartialEq)]
pub struct MapMark {
    /// Coordinates to the right and upwards.
    pub at: [f64; 2],
    /// What stands beside its circle; without a text the place is crossed out.
    pub text: String,
}

const WIDTH: f64 = 880.0;
const TOP: f64 = 64.0;
const PLOT_HEIGHT: f64 = 200.0;
const LEFT: f64 = 52.0;
const BAR_SPACE: f64 = 84.0;
const GAP: f64 = 56.0;

/// Draws filled contours with labelled isolines: z in mm to the right, w in mm upwards. Negative isolines are dashed, the
/// zero line is thick, areas with material left standing (f > 0) are hatched.
///
/// # Errors
/// [`ChartError::TooFewValues`] without any panel.
pub fn contour_map(map: &ContourMap) -> Result<Svg, ChartError> {
    let titles = ["z [mm]".into(), "w [mm]".into()];
    let frame = MapFrame { titles, marks: Vec::new(), values: MapValues::Deviation };
    contour_map_in(map, &frame)
}

/// As [`contour_map`], over coordinates of other names and with places marked.
///
/// # Errors
/// As [`contour_map`]; [`ChartError::InvalidNumber`] for a mark that is nowhere.
pub fn contour_map_in(map: &ContourMap, around: &MapFrame) -> Result<Svg, ChartError> {
    for mark in around.marks.iter().flatten() {
        check_values("mark in a contour map", &mark.at)?;
    }
    check_count("contour map panels", map.panels.len(), 1)?;
    let scale =
        map.scale.unwrap_or_else(|| LevelScale::covering(map.panels.iter().map(|panel| &panel.topography)));
    let mut canvas = Canvas::new(WIDTH, TOP + PLOT_HEIGHT + 64.0, &map.title);
    canvas.heading(around.values.heading());
    // Two places even for one panel, so that maps on one page have one size.
    let places = map.panels.len().max(2) as f64;
    let width = (WIDTH - LEFT - BAR_SPACE - GAP * (places - 1.0)) / places;
    for (k, panel) in map.panels.iter().enumerate() {
        let left = LEFT + k as f64 * (width + GAP);
        let frame = Frame { left, top: TOP, width, height: PLOT_HEIGHT };
        let marks = around.marks.get(k).map_or(&[][..], Vec::as_slice);
        draw_panel(&mut canvas, frame, panel, &scale, (around, marks));
    }
    let end = LEFT + map.panels.len().max(2) as f64 * (width + GAP) - GAP;
    let bar = Frame { left: end + 18.0, top: TOP, width: 16.0, height: PLOT_HEIGHT };
    draw_colour_bar(&mut canvas, bar, &scale, &map.quantity, &around.values);
    Ok(canvas.finish())
}

fn draw_panel(
    canvas: &mut Canvas,
    frame: Frame,
    panel: &NamedTopography,
    scale: &LevelScale,
    (around, marks): (&MapFrame, &[MapMark]),
) {
    let field = &panel.topography;
    let (z, w) = (field.z_mm(), field.w_mm());
    let x_axis = Axis::tight(z[0], z[z.len() - 1], 7);
    let y_axis = Axis::tight(w[0], w[w.len() - 1], 7);
    let place = |lines: Vec<Line>| -> Vec<Line> {
        let point = |p: &[f64; 2]| frame.at(x_axis.share(p[0]), y_axis.share(p[1]));
        lines.iter().map(|line| line.iter().map(point).collect()).collect()
    };
    let heading = TextStyle::new(13.0, Anchor::Start).bold();
    canvas.text([frame.left, frame.top - 8.0], &panel.name, heading);
    draw_bands(canvas, frame, field, scale, (&around.values, &place));
    if scale.is_flat() {
        let centre = [frame.left + 0.5 * frame.width, frame.top + 0.5 * frame.height];
        canvas.text(centre, "0 everywhere", TextStyle::new(13.0, Anchor::Middle));
    }
    if around.values != MapValues::Waves {
        draw_isolines(canvas, frame, field, scale, &place);
    }
    let [right, up] = &around.titles;
    for mark in marks {
        draw_mark(canvas, frame, frame.at(x_axis.share(mark.at[0]), y_axis.share(mark.at[1])), &mark.text);
    }
    frame.outline(canvas);
    frame.abscissa(canvas, &x_axis, right);
    frame.ordinate(canvas, &y_axis);
    frame.ordinate_title(canvas, &y_axis, up, 36.0);
    let (lo, hi) = field.range_um();
    let unit = around.values.unit();
    let text = format!("min {} {unit} · max {} {unit}", scale.precise_label(lo), scale.precise_label(hi));
    let at = [frame.left + 0.5 * frame.width, frame.bottom() + 52.0];
    canvas.text(at, &text, TextStyle::new(TICK_SIZE, Anchor::Middle).muted());
}

/// A circle with its text on the side that has room, or a cross.
fn draw_mark(canvas: &mut Canvas, frame: Frame, [x, y]: [f64; 2], text: &str) {
    let stroke = Stroke::solid(INK, 1.4);
    if text.is_empty() {
        let r = 2.2;
        canvas
            .polylines(&[vec![[x - r, y - r], [x + r, y + r]], vec![[x - r, y + r], [x + r, y - r]]], stroke);
        return;
    }
    canvas.disc([x, y], 4.2, "none", Stroke::solid("#ffffff", 3.4));
    canvas.disc([x, y], 4.2, "none", stroke);
    let width = text_width(text, 11.0);
    let before = x + 9.0 + width > frame.right();
    let (at, anchor) = if before { (x - 9.0, Anchor::End) } else { (x + 9.0, Anchor::Start) };
    let y = (y + 4.0).clamp(frame.top + 12.0, frame.bottom() - 4.0);
    canvas.text([at, y], text, TextStyle::new(11.0, anchor).bold().halo());
}

/// From the lowest band upwards, each region painted over the ones below it: no seams between bands.
fn draw_bands(
    canvas: &mut Canvas,
    frame: Frame,
    field: &Topography,
    scale: &LevelScale,
    (values, place): (&MapValues, &impl Fn(Vec<Line>) -> Vec<Line>),
) {
    let edges = scale.edges_um();
    canvas.rect([frame.left, frame.top], [frame.width, frame.height], &signed_color(0.0), None);
    for (k, band) in edges.windows(2).enumerate() {
        let fill = signed_color(0.5 * (band[0] + band[1]) / scale.size());
        if k == 0 {
            canvas.rect([frame.left, frame.top], [frame.width, frame.height], &fill, None);
        } else {
            canvas.loops(&place(region_above(field, band[0])), &fill, None);
        }
    }
    // A region that exceeds zero by rounding only is not material left standing.
    let (lo, hi) = field.range_um();
    let least = 0.02 * scale.step_um();
    match values {
        MapValues::Waves if lo < -least => {
            let hatch = hatch_lines(&place(region_above(&field.negated(), least)), 5.0, Lean::Backward);
            canvas.polylines(&hatch, Stroke::solid(INK, 0.7));
        }
        MapValues::Deviation if hi > least => {
            let hatch = hatch_lines(&place(region_above(field, 0.0)), 7.0, Lean::Forward);
            canvas.polylines(&hatch, Stroke::solid(MUTED, 0.5));
        }
        MapValues::Waves | MapValues::Deviation | MapValues::Quantity(_) => {}
    }
}

fn draw_isolines(
    canvas: &mut Canvas,
    frame: Frame,
    field: &Topography,
    scale: &LevelScale,
    place: &impl Fn(Vec<Line>) -> Vec<Line>,
) {
    let border = Area { x: frame.left, y: frame.top, width: frame.width, height: frame.height };
    let mut taken: Vec<Area> = Vec::new();
    let mut labels = Vec::new();
    for level in scale.edges_um() {
        // Specks are rounding noise around a summit that just touches the level.
        let mut lines = place(isolines(field, level));
        lines.retain(|line| arc_lengths(line).iter().sum::<f64>() > 12.0);
        let (width, dash) =
            if level == 0.0 { (1.9, "") } else { (0.9, if level < 0.0 { "5 2.5" } else { "" }) };
        canvas.polylines(&lines, Stroke { color: INK, width, dash });
        let text = scale.label(level);
        for line in &lines {
            if let Some((at, turn, area)) = label_place(line, &text, &border, &taken) {
                taken.push(area);
                labels.push((at, text.clone(), turn));
            }
        }
    }
    for (at, text, turn) in labels {
        canvas.text(at, &text, TextStyle::new(11.0, Anchor::Middle).turned(turn).halo());
    }
}

/// Where on a line its label stands best: long enough, inside, clear of other labels, straight, near the middle.
fn label_place(
    line: &[[f64; 2]],
    text: &str,
    border: &Area,
    taken: &[Area],
) -> Option<([f64; 2], f64, Area)> {
    const SIZE: f64 = 11.0;
    let lengths = arc_lengths(line);
    let total: f64 = lengths.iter().sum();
    let width = text_width(text, SIZE) + 4.0;
    if total < 1.6 * width {
        return None;
    }
    let mut best: Option<(f64, [f64; 2], f64, Area)> = None;
    for k in 1..20 {
        let share = f64::from(k) / 20.0;
        let here = along(line, &lengths, share * total);
        let before = along(line, &lengths, share * total - 0.5 * width);
        let after = along(line, &lengths, share * total + 0.5 * width);
        let chord = distance(before, after);
        let mut turn = (after[1] - before[1]).atan2(after[0] - before[0]).to_degrees();
        if turn > 90.0 {
            turn -= 180.0;
        } else if turn <= -90.0 {
            turn += 180.0;
        }
        let (sine, cosine) = turn.to_radians().sin_cos();
        let area = Area::around(
            here[0],
            here[1],
            width * cosine.abs() + 1.2 * SIZE * sine.abs(),
            width * sine.abs() + 1.2 * SIZE * cosine.abs(),
        );
        if !border.contains(&area) || taken.iter().any(|other| other.overlaps(&area)) {
            continue;
        }
        let bend = 1.0 - chord / width;
        let cost = 4.0 * bend + (share - 0.5).abs() + 0.4 * sine.abs();
        if best.as_ref().is_none_or(|(least, ..)| cost < *least) {
            // The baseline lies a third of the size beside the line, at right angles to it.
            let at = [here[0] - 0.35 * SIZE * sine, here[1] + 0.35 * SIZE * cosine];
            best = Some((cost, at, turn, area));
        }
    }
    best.map(|(_, at, turn, area)| (at, turn, area))
}

fn arc_lengths(line: &[[f64; 2]]) -> Vec<f64> {
    line.windows(2).map(|pair| distance(pair[0], pair[1])).collect()
}

fn distance(a: [f64; 2], b: [f64; 2]) -> f64 {
    (b[0] - a[0]).hypot(b[1] - a[1])
}

/// The point at an arc length from the beginning of a polyline.
fn along(line: &[[f64; 2]], lengths: &[f64], at: f64) -> [f64; 2] {
    let mut rest = at.max(0.0);
    for (k, &length) in lengths.iter().enumerate() {
        if rest <= length && length > 0.0 {
            let t = rest / length;
            let (a, b) = (line[k], line[k + 1]);
            return [a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])];
        }
        rest -= length;
    }
    line[line.len() - 1]
}

fn draw_colour_bar(canvas: &mut Canvas, bar: Frame, scale: &LevelScale, quantity: &str, values: &MapValues) {
    let edges = scale.edges_um();
    canvas.text([bar.left - 4.0, bar.top - 14.0], quantity, TextStyle::new(TICK_SIZE, Anchor::Start));
    let label = TextStyle::new(11.0, Anchor::Start);
    if edges.len() < 2 {
        canvas.rect([bar.left, bar.top], [bar.width, bar.height], &signed_color(0.0), None);
        bar.outline(canvas);
        canvas.text([bar.right() + 6.0, bar.top + 0.5 * bar.height + 4.0], "0", label);
        return;
    }
    let height = bar.height / (edges.len() - 1) as f64;
    for (k, band) in edges.windows(2).enumerate() {
        let middle = 0.5 * (band[0] + band[1]);
        let top = bar.bottom() - (k + 1) as f64 * height;
        canvas.rect([bar.left, top], [bar.width, height], &signed_color(middle / scale.size()), None);
        let hatched = match values {
            MapValues::Deviation => middle > 0.0,
            MapValues::Waves => middle <= 0.0,
            MapValues::Quantity(_) => false,
        };
        if hatched {
            let (l, r, t, b) = (bar.left, bar.right(), top, top + height);
            let corners = vec![[l, t], [r, t], [r, b], [l, b], [l, t]];
            let (pitch, lean, stroke) = if *values == MapValues::Waves {
                (5.0, Lean::Backward, Stroke::solid(INK, 0.7))
            } else {
                (7.0, Lean::Forward, Stroke::solid(MUTED, 0.5))
            };
            canvas.polylines(&hatch_lines(&[corners], pitch, lean), stroke);
        }
    }
    bar.outline(canvas);
    for (k, &edge) in edges.iter().enumerate() {
        let y = bar.bottom() - k as f64 * height;
        canvas.line([bar.left, y], [bar.right() + 3.0, y], Stroke::solid(INK, 0.7));
        canvas.text([bar.right() + 6.0, y + 4.0], &scale.label(edge), label);
    }
}
