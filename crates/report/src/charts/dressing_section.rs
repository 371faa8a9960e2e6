//! The dresser in the worm's thread space: what its section sweeps in a plane through the worm axis, and how close it comes to
//! the flanks.

use super::axes::{Frame, TICK_SIZE};
use super::error::{ChartError, check_ascending, check_count, check_values};
use super::hatch::{Lean, hatch_lines};
use super::numbers::format_fixed;
use super::palette::{BLUE, FAINT, INK, MUTED, RUST};
use super::scale::Axis;
use super::svg::{Anchor, Canvas, Stroke, Svg, TextStyle};
use super::text::text_width;
use serde::Serialize;

/// A thread space with the dresser in it. Points are [axial position, radius of the worm], mm.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct DressingSectionChart {
    /// Heading of the chart.
    pub title: String,
    /// Line below it, for example the bodies and the tip land.
    pub subtitle: String,
    /// The two flanks of the thread space, that at smaller axial positions first.
    pub flanks: [SpaceFlank; 2],
    /// Boundary of what the dresser sweeps, around its tip from one outside to the other; stretches follow each other.
    pub dresser: Vec<SectionStretch>,
}

/// A flank of the thread space.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct SpaceFlank {
    /// Name, for example `left flank, dressed`.
    pub name: String,
    /// From the root to the outside radius.
    pub line_mm: Vec<[f64; 2]>,
    /// Radii between which it is used, mm.
    pub used_radius_mm: [f64; 2],
    /// Least clearance to be marked.
    pub clearance: Option<MarkedClearance>,
}

/// A least clearance.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct MarkedClearance {
    /// Amount normal to the flank, mm; < 0 is a collision.
    pub normal_mm: f64,
    /// Its end on the dresser.
    pub dresser_mm: [f64; 2],
    /// Its end on the flank.
    pub flank_mm: [f64; 2],
    /// Radius of the dresser there, mm.
    pub dresser_radius_mm: f64,
}

/// A stretch of the boundary that one part of the dresser leaves.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct SectionStretch {
    /// Part of the dresser.
    pub kind: SectionKind,
    /// Its line.
    pub line_mm: Vec<[f64; 2]>,
}

/// Part of a dresser's section.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum SectionKind {
    /// The flank that dresses.
    ActiveFlank,
    /// The land at the tip.
    TipLand,
    /// The flank across.
    CounterFlank,
}

impl SectionKind {
    const ALL: [Self; 3] = [Self::ActiveFlank, Self::TipLand, Self::CounterFlank];

    fn name(self) -> &'static str {
        match self {
            Self::ActiveFlank => "dresser: active flank",
            Self::TipLand => "tip land",
            Self::CounterFlank => "opposite flank",
        }
    }

    fn stroke(self) -> Stroke<'static> {
        match self {
            Self::ActiveFlank => Stroke::solid(BLUE, 2.2),
            Self::TipLand => Stroke { color: INK, width: 2.2, dash: "2 2.5" },
            Self::CounterFlank => Stroke { color: RUST, width: 2.2, dash: "9 4" },
        }
    }
}

const WIDTH: f64 = 880.0;
const LEFT: f64 = 62.0;
const RIGHT: f64 = 14.0;
const TOP: f64 = 66.0;
const TALLEST: f64 = 560.0;
/// Ground of the dresser: light enough for hatching and letters on it.
const BODY: &str = "#e8edf2";
/// Room for a note in the thread beside the space.
const BESIDE: f64 = 185.0;
/// Worm shown below its root, as a share of the depth of the space.
const BELOW: f64 = 0.12;
/// Distances shorter than this on the page get their arrows from outside.
const SHORT: f64 = 30.0;

/// Draws the section with equal scales on both axes.
///
/// # Errors
/// [`ChartError`] for lines of less than two points, values that are not finite, and radii of a flank that do not ascend; the
/// error names the line.
pub fn dressing_section_chart(chart: &DressingSectionChart) -> Result<Svg, ChartError> {
    check(chart)?;
    let window = Window::around(chart);
    let mut canvas = Canvas::new(WIDTH, window.frame.bottom() + 42.0, &chart.title);
    canvas.heading(&chart.subtitle);
    draw_legend(&mut canvas);
    for (share, _) in window.radius.ticks() {
        canvas.line(window.frame.at(0.0, share), window.frame.at(1.0, share), Stroke::solid(FAINT, 0.6));
    }
    let body: Vec<[f64; 2]> =
        chart.dresser.iter().flat_map(|s| &s.line_mm).map(|&p| window.place(p)).collect();
    canvas.loops(&[body], BODY, None);
    let threads = window.threads(chart);
    canvas.polylines(&hatch_lines(&threads, 9.0, Lean::Forward), Stroke::solid(MUTED, 0.7));
    canvas.loops(&threads, "none", Some(Stroke::solid(INK, 0.9)));
    for flank in &chart.flanks {
        let [from, to] = flank.used_radius_mm;
        let used = flank.line_mm.iter().filter(|p| p[1] >= from && p[1] <= to);
        canvas.polylines(&[used.map(|&p| window.place(p)).collect()], Stroke::solid(INK, 3.0));
    }
    for stretch in &chart.dresser {
        let line = stretch.line_mm.iter().map(|&p| window.place(p)).collect();
        canvas.polylines(&[line], stretch.kind.stroke());
    }
    window.frame.outline(&mut canvas);
    for (flank, side) in chart.flanks.iter().zip([-1.0, 1.0]) {
        draw_flank_note(&mut canvas, &window, flank, side);
    }
    window.frame.abscissa(&mut canvas, &window.axial, "axial position [mm]");
    window.frame.ordinate(&mut canvas, &window.radius);
    window.frame.ordinate_title(&mut canvas, &window.radius, "radius of the worm [mm]", 46.0);
    Ok(canvas.finish())
}

fn check(chart: &DressingSectionChart) -> Result<(), ChartError> {
    check_count("dresser boundary", chart.dresser.len(), 1)?;
    let line = |name: &str, points: &[[f64; 2]]| {
        check_count(name, points.len(), 2)?;
        check_values(name, points.as_flattened())
    };
    for stretch in &chart.dresser {
        // A stretch may be a single point where a part is only just in sight.
        check_count(stretch.kind.name(), stretch.line_mm.len(), 1)?;
        check_values(stretch.kind.name(), stretch.line_mm.as_flattened())?;
    }
    for flank in &chart.flanks {
        line(&flank.name, &flank.line_mm)?;
        let radii: Vec<f64> = flank.line_mm.iter().map(|p| p[1]).collect();
        check_ascending(&format!("{}, radius", flank.name), &radii)?;
        check_values(&format!("{}, used radius", flank.name), &flank.used_radius_mm)?;
        check_ascending(&format!("{}, used radius", flank.name), &flank.used_radius_mm)?;
        if let Some(mark) = &flank.clearance {
            let numbers = [[mark.normal_mm, mark.dresser_radius_mm], mark.dresser_mm, mark.flank_mm];
            check_values(&format!("{}, clearance", flank.name), numbers.as_flattened())?;
        }
    }
    Ok(())
}

/// The part of the plane that is drawn.
struct Window {
    frame: Frame,
    axial: Axis,
    radius: Axis,
    corner: [f64; 2],
    scale: f64,
}

impl Window {
    fn around(chart: &DressingSectionChart) -> Self {
        let span = |k: usize, points: &mut dyn Iterator<Item = &[f64; 2]>| {
            points.fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], p| [a.min(p[k]), b.max(p[k])])
        };
        let flanks = || chart.flanks.iter().flat_map(|f| &f.line_mm);
        let marks = || chart.flanks.iter().filter_map(|f| f.clearance.as_ref());
        let ends = || marks().flat_map(|mark| [&mark.dresser_mm, &mark.flank_mm]);
        let all = || flanks().chain(chart.dresser.iter().flat_map(|s| &s.line_mm)).chain(ends());
        let [root, outside] = span(1, &mut flanks());
        let [lowest, highest] = span(1, &mut all());
        let [from, to] = span(0, &mut all());
        let depth = outside - root;
        let (low, high) = (lowest - BELOW * depth, highest + 0.3 * BELOW * depth);
        let width = WIDTH - LEFT - RIGHT;
        let scale = ((width - 2.0 * BESIDE) / (to - from)).min(TALLEST / (high - low));
        // The rest of the width shows more of the neighbouring threads.
        let spare = 0.5 * (width / scale - (to - from));
        let (from, to) = (from - spare, to + spare);
        Self {
            frame: Frame { left: LEFT, top: TOP, width, height: (high - low) * scale },
            axial: Axis::tight(from, to, 14),
            radius: Axis::tight(low, high, 10),
            corner: [from, low],
            scale,
        }
    }

    fn place(&self, [axial, radius]: [f64; 2]) -> [f64; 2] {
        [
            self.frame.left + (axial - self.corner[0]) * self.scale,
            self.frame.bottom() - (radius - self.corner[1]) * self.scale,
        ]
    }

    /// The material of the worm in sight: both threads and what is below the root.
    fn threads(&self, chart: &DressingSectionChart) -> Vec<Vec<[f64; 2]>> {
        let [a, b] = [0, 1].map(|k| chart.flanks[k].line_mm.iter().map(|&p| self.place(p)));
        let a: Vec<_> = a.collect();
        let (top_a, top_b) = (a[a.len() - 1][1], b.clone().next_back().map_or(0.0, |p| p[1]));
        let (left, right, bottom) = (self.frame.left, self.frame.right(), self.frame.bottom());
        let mut outline = vec![[left, bottom], [left, top_a]];
        outline.extend(a.into_iter().rev());
        outline.extend(b);
        outline.extend([[right, top_b], [right, bottom], [left, bottom]]);
        vec![outline]
    }
}

/// Lines of a note and the room around them.
const NOTE_LINE: f64 = 16.0;
const NOTE_MARGIN: f64 = 8.0;

/// Name of a flank in its thread and, if it is marked, its clearance: the ray itself and its amount. `side` is -1 on the left of
/// the space.
fn draw_flank_note(canvas: &mut Canvas, window: &Window, flank: &SpaceFlank, side: f64) {
    let mut lines = vec![flank.name.clone()];
    if let Some(mark) = &flank.clearance {
        let kind = if mark.normal_mm < 0.0 { "collision" } else { "clearance" };
        lines.push(format!("{kind} {} mm", format_fixed(mark.normal_mm.abs(), 3)));
        lines.push(format!("at dresser radius {} mm,", format_fixed(mark.dresser_radius_mm, 2)));
        lines.push(format!("worm radius {} mm", format_fixed(mark.flank_mm[1], 2)));
    }
    let size = [
        lines.iter().map(|line| text_width(line, TICK_SIZE)).fold(0.0, f64::max) + 2.0 * NOTE_MARGIN,
        lines.len() as f64 * NOTE_LINE + NOTE_MARGIN,
    ];
    // The thread is widest at its root.
    let bottom = window.place(flank.line_mm[0])[1] - 10.0;
    let left = if side < 0.0 { window.frame.left + 10.0 } else { window.frame.right() - 10.0 - size[0] };
    let corner = [left, bottom - size[1]];
    if let Some(mark) = &flank.clearance {
        draw_ray(
            canvas,
            window.place(mark.dresser_mm),
            window.place(mark.flank_mm),
            [left + 0.5 * size[0], corner[1]],
        );
    }
    canvas.rect(corner, size, "#ffffff", Some(Stroke::solid(MUTED, 0.8)));
    for (k, line) in lines.iter().enumerate() {
        let style = TextStyle::new(TICK_SIZE, Anchor::Start);
        let style = if k < 2 { style.bold() } else { style };
        canvas.text([left + NOTE_MARGIN, corner[1] + (k as f64 + 1.0) * NOTE_LINE - 2.0], line, style);
    }
}

/// A ray between dresser and flank as a dimension, with a leader from its end on the flank.
fn draw_ray(canvas: &mut Canvas, dresser: [f64; 2], flank: [f64; 2], note: [f64; 2]) {
    let stroke = Stroke::solid(INK, 1.2);
    let (dx, dy) = (flank[0] - dresser[0], flank[1] - dresser[1]);
    let length = dx.hypot(dy);
    // A ray of no length on the page is a contact: a disc shows where.
    canvas.disc(flank, 3.4, "#ffffff", stroke);
    canvas.line(flank, note, Stroke { color: INK, width: 0.9, dash: "4 3" });
    if length < 1.0 {
        return;
    }
    let along = [dx / length, dy / length];
    let step = |from: [f64; 2], by: f64| [from[0] + by * along[0], from[1] + by * along[1]];
    let arrow = |canvas: &mut Canvas, tip: [f64; 2], by: f64| {
        let base = step(tip, by);
        let (across, half) = ([-along[1], along[0]], 3.2);
        let corner = |sign: f64| [base[0] + sign * half * across[0], base[1] + sign * half * across[1]];
        canvas.loops(&[vec![tip, corner(1.0), corner(-1.0)]], INK, None);
    };
    if length < SHORT {
        canvas.line(step(dresser, -18.0), dresser, stroke);
        canvas.line(flank, step(flank, 18.0), stroke);
        arrow(canvas, dresser, -8.0);
        arrow(canvas, flank, 8.0);
    } else {
        canvas.line(dresser, flank, stroke);
        arrow(canvas, dresser, 8.0);
        arrow(canvas, flank, -8.0);
    }
}

fn draw_legend(canvas: &mut Canvas) {
    let y = 52.0;
    let mut x = 0.0;
    let mut named = |canvas: &mut Canvas, name: &str| {
        canvas.text([x + 37.0, y + 4.2], name, TextStyle::new(TICK_SIZE, Anchor::Start));
        let here = x;
        x += 37.0 + text_width(name, TICK_SIZE) + 20.0;
        here
    };
    let at = named(canvas, "worm");
    let corners =
        vec![[at, y - 7.0], [at + 30.0, y - 7.0], [at + 30.0, y + 7.0], [at, y + 7.0], [at, y - 7.0]];
    canvas.polylines(
        &hatch_lines(std::slice::from_ref(&corners), 9.0, Lean::Forward),
        Stroke::solid(MUTED, 0.7),
    );
    canvas.loops(&[corners], "none", Some(Stroke::solid(INK, 0.9)));
    let at = named(canvas, "used part of its flanks");
    canvas.line([at, y], [at + 30.0, y], Stroke::solid(INK, 3.0));
    for kind in SectionKind::ALL {
        let at = named(canvas, kind.name());
        canvas.rect([at, y - 7.0], [30.0, 14.0], BODY, None);
        canvas.line([at, y], [at + 30.0, y], kind.stroke());
    }
}
