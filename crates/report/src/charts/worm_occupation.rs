//! What the width of a worm is used for: bars over z_1, a row a flank.

use super::axes::{Frame, TICK_SIZE};
use super::error::{ChartError, check_ascending, check_count, check_values};
use super::hatch::{Lean, hatch_lines};
use super::palette::{FAINT, INK, MUTED};
use super::scale::Axis;
use super::svg::{Anchor, Canvas, Stroke, Svg, TextStyle};
use super::text::text_width;
use serde::Serialize;

/// Areas of a worm over its width.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct WormOccupationChart {
    /// Heading of the chart.
    pub title: String,
    /// Usable z_1 from and to, mm.
    pub width_mm: [f64; 2],
    /// Rows from top to bottom.
    pub rows: Vec<OccupationRow>,
}

/// The bars of one flank.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct OccupationRow {
    /// Name, for example `Left flank`.
    pub name: String,
    /// Bars; those that overlap are drawn one below the other, modified lines inside their area.
    pub bars: Vec<OccupationBar>,
}

/// A stretch of the worm.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct OccupationBar {
    /// Use.
    pub kind: OccupationKind,
    /// Text in the bar, left out where it does not fit.
    pub label: String,
    /// z_1 from and to, mm.
    pub z_1_mm: [f64; 2],
}

/// Use of a stretch of the worm.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum OccupationKind {
    /// A finishing area, whole.
    Finishing,
    /// Modified lines in a finishing area.
    Modified,
    /// A roughing area.
    Roughing,
    /// Nothing is ground here.
    Unused,
}

impl OccupationKind {
    const ALL: [Self; 4] = [Self::Finishing, Self::Modified, Self::Roughing, Self::Unused];

    fn name(self) -> &'static str {
        match self {
            Self::Finishing => "finishing, unmodified lines",
            Self::Modified => "finishing, modified lines",
            Self::Roughing => "roughing",
            Self::Unused => "unused",
        }
    }

    fn fill(self) -> &'static str {
        match self {
            Self::Finishing => "#ffffff",
            Self::Modified => "#cddeec",
            Self::Roughing => "#f7dfbe",
            Self::Unused => "none",
        }
    }
}

const WIDTH: f64 = 880.0;
const LEFT: f64 = 16.0;
const LANE: f64 = 34.0;
const GAP: f64 = 6.0;
/// Room above the bars of a row for its name.
const ROW_HEAD: f64 = 20.0;

/// Draws the rows one below the other over a common z_1.
///
/// # Errors
/// [`ChartError`] without rows or bars, for values that are not finite, and for a width or bar whose end is not above its start; the
/// error names the row.
pub fn worm_occupation_chart(chart: &WormOccupationChart) -> Result<Svg, ChartError> {
    check(chart)?;
    let bars = || chart.rows.iter().flat_map(|row| &row.bars);
    let [from, to] = chart.width_mm;
    let ends = bars().map(|bar| bar.z_1_mm);
    let [lo, hi] = ends.fold([from, to], |[lo, hi], [a, b]| [lo.min(a), hi.max(b)]);
    let axis = Axis::tight(lo, hi, 12);
    let lanes: Vec<(Vec<usize>, usize)> = chart.rows.iter().map(lanes).collect();
    let heights: Vec<f64> = lanes.iter().map(|(_, n)| ROW_HEAD + *n as f64 * LANE + GAP).collect();
    let top = 52.0;
    let frame = Frame { left: LEFT, top, width: WIDTH - 2.0 * LEFT, height: heights.iter().sum::<f64>() };
    let mut canvas = Canvas::new(WIDTH, frame.bottom() + 40.0, &chart.title);
    canvas.heading("");
    let shown: Vec<OccupationKind> =
        OccupationKind::ALL.into_iter().filter(|kind| bars().any(|bar| bar.kind == *kind)).collect();
    draw_legend(&mut canvas, &shown);
    for (share, _) in axis.ticks() {
        canvas.line(frame.at(share, 0.0), frame.at(share, 1.0), Stroke::solid(FAINT, 0.6));
    }
    let mut y = top;
    for ((row, (lanes, _)), height) in chart.rows.iter().zip(&lanes).zip(&heights) {
        draw_row(&mut canvas, &frame, &axis, row, lanes, y);
        y += height;
        if y < frame.bottom() - 1.0 {
            canvas.line([frame.left, y], [frame.right(), y], Stroke::solid(INK, 0.6));
        }
    }
    for end in chart.width_mm {
        let share = axis.share(end);
        canvas.line(frame.at(share, 0.0), frame.at(share, 1.0), Stroke::solid(INK, 1.8));
    }
    frame.outline(&mut canvas);
    frame.abscissa(&mut canvas, &axis, "z_1 [mm], bold: ends of the usable width");
    Ok(canvas.finish())
}

fn check(chart: &WormOccupationChart) -> Result<(), ChartError> {
    check_values("usable width", &chart.width_mm)?;
    check_ascending("usable width", &chart.width_mm)?;
    check_count("rows of the used worm width", chart.rows.len(), 1)?;
    for row in &chart.rows {
        check_count(&row.name, row.bars.len(), 1)?;
        for bar in &row.bars {
            check_values(&row.name, &bar.z_1_mm)?;
            check_ascending(&row.name, &bar.z_1_mm)?;
        }
    }
    Ok(())
}

/// The lane of every bar and how many lanes there are. Bars that do not overlap share a lane.
fn lanes(row: &OccupationRow) -> (Vec<usize>, usize) {
    let mut order: Vec<usize> = (0..row.bars.len()).collect();
    // Whole areas first, so that modified lines find theirs.
    order.sort_by(|&a, &b| {
        let (a, b) = (&row.bars[a], &row.bars[b]);
        let inner = |bar: &OccupationBar| bar.kind == OccupationKind::Modified;
        inner(a).cmp(&inner(b)).then(a.z_1_mm[0].total_cmp(&b.z_1_mm[0]))
    });
    // Touching bars differ by rounding only.
    let slack = 1e-6;
    let mut ends: Vec<f64> = Vec::new();
    let mut lane = vec![0; row.bars.len()];
    for (place, &k) in order.iter().enumerate() {
        let bar = &row.bars[k];
        let [from, to] = bar.z_1_mm;
        let holds = |other: &&usize| {
            let area = &row.bars[**other];
            area.kind == OccupationKind::Finishing
                && area.z_1_mm[0] <= from + slack
                && to <= area.z_1_mm[1] + slack
                && bar.label == area.label
        };
        if bar.kind == OccupationKind::Modified
            && let Some(&area) = order[..place].iter().find(holds)
        {
            lane[k] = lane[area];
            continue;
        }
        let free = ends.iter().position(|&end| end <= from + slack);
        lane[k] = free.unwrap_or(ends.len());
        match free {
            Some(n) => ends[n] = to,
            None => ends.push(to),
        }
    }
    (lane, ends.len())
}

fn draw_row(canvas: &mut Canvas, frame: &Frame, axis: &Axis, row: &OccupationRow, lanes: &[usize], top: f64) {
    let heading = TextStyle::new(TICK_SIZE, Anchor::Start).bold().halo();
    canvas.text([frame.left + 6.0, top + 14.5], &row.name, heading);
    let place = |bar: &OccupationBar, lane: usize| {
        let [a, b] = bar.z_1_mm.map(|z| frame.at(axis.share(z), 0.0)[0]);
        ([a, top + ROW_HEAD + lane as f64 * LANE], [b - a, LANE - 6.0])
    };
    let inner = |bar: &OccupationBar| bar.kind == OccupationKind::Modified;
    for modified in [false, true] {
        for (bar, &lane) in row.bars.iter().zip(lanes).filter(|(bar, _)| inner(bar) == modified) {
            let (corner, size) = place(bar, lane);
            draw_bar(canvas, bar.kind, corner, size);
        }
    }
    for (bar, &lane) in row.bars.iter().zip(lanes).filter(|(bar, _)| !inner(bar)) {
        let ([x, y], [width, height]) = place(bar, lane);
        if text_width(&bar.label, TICK_SIZE) + 6.0 <= width {
            let style = TextStyle::new(TICK_SIZE, Anchor::Middle).bold().halo();
            canvas.text([x + 0.5 * width, y + 0.5 * height + 4.2], &bar.label, style);
        }
    }
}

fn draw_bar(canvas: &mut Canvas, kind: OccupationKind, [x, y]: [f64; 2], [width, height]: [f64; 2]) {
    let outline = match kind {
        OccupationKind::Unused => Stroke { color: MUTED, width: 0.8, dash: "3 3" },
        _ => Stroke::solid(INK, 1.0),
    };
    canvas.rect([x, y], [width, height], kind.fill(), Some(outline));
    let lean = match kind {
        OccupationKind::Modified => Lean::Forward,
        OccupationKind::Roughing => Lean::Backward,
        OccupationKind::Finishing | OccupationKind::Unused => return,
    };
    let (right, bottom) = (x + width, y + height);
    let corners = vec![[x, y], [right, y], [right, bottom], [x, bottom], [x, y]];
    let pitch = if lean == Lean::Forward { 6.0 } else { 10.0 };
    canvas.polylines(&hatch_lines(&[corners], pitch, lean), Stroke::solid(MUTED, 0.7));
}

fn draw_legend(canvas: &mut Canvas, kinds: &[OccupationKind]) {
    let mut x = 0.0;
    for kind in kinds {
        draw_bar(canvas, *kind, [x, 29.0], [30.0, 14.0]);
        canvas.text([x + 37.0, 40.2], kind.name(), TextStyle::new(TICK_SIZE, Anchor::Start));
        x += 37.0 + text_width(kind.name(), TICK_SIZE) + 22.0;
    }
}
