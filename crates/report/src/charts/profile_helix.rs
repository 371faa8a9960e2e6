//! Profile and helix diagrams as a gear measuring machine prints them: traces side by side, the coordinate upwards,
//! the value to the right, scale bars, characteristic values below each trace.

use serde::Serialize;

use super::axes::{Frame, TICK_SIZE, horizontal_bar};
use super::error::{ChartError, LEAST_SPAN, check_ascending, check_count, check_length, check_values};
use super::numbers::{format_fixed, format_significant};
use super::palette::{BLUE, FAINT, GRID, INK};
use super::scale::{Axis, decimals_of, round_below, round_step};
use super::svg::{Anchor, Canvas, Stroke, Svg, TextStyle};
use super::topography::Topography;

/// The diagrams of one gear.
#[derive(Clone, Debug, PartialEq)]
pub struct ProfileHelixDiagram {
    /// Heading of the chart.
    pub title: String,
    /// One column per flank.
    pub flanks: Vec<FlankSections>,
    /// Name of the dashed curve, for example "target".
    pub target_name: String,
    /// Name of the solid curve, for example "simulated".
    pub simulated_name: String,
}

/// The traces of one flank.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct FlankSections {
    /// Heading, for example "Left flank".
    pub name: String,
    /// Traces over the length of roll w (mm) at fixed z.
    pub profiles: Vec<SectionTrace>,
    /// Traces over the face width z (mm) at fixed w.
    pub helices: Vec<SectionTrace>,
}

/// One profile or helix trace.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct SectionTrace {
    /// Where the section lies, mm: z of a profile, w of a helix.
    pub position_mm: f64,
    /// Coordinate along the trace, ascending, mm: w of a profile, z of a helix.
    pub coordinate_mm: Vec<f64>,
    /// Wanted values, um, as many as coordinates; `None` draws no dashed curve.
    pub target_um: Option<Vec<f64>>,
    /// Values that come out, um, as many as coordinates.
    pub simulated_um: Vec<f64>,
    /// Values to print below the trace with their symbols, for example ("C_α", 5.0), um.
    pub values_um: Vec<(String, f64)>,
}

impl SectionTrace {
    /// The profile at helix index `j` of a topography, without printed values. The target must have the same grid,
    /// otherwise it is left out.
    ///
    /// # Panics
    /// If `j` is not an index of the grid.
    pub fn profile(simulated: &Topography, target: Option<&Topography>, j: usize) -> Self {
        Self {
            position_mm: simulated.z_mm()[j],
            coordinate_mm: simulated.w_mm().to_vec(),
            target_um: target.filter(|t| same_grid(t, simulated)).map(|t| t.profile(j)),
            simulated_um: simulated.profile(j),
            values_um: Vec::new(),
        }
    }

    /// The helix trace at profile index `i`; otherwise as [`SectionTrace::profile`].
    ///
    /// # Panics
    /// If `i` is not an index of the grid.
    pub fn helix(simulated: &Topography, target: Option<&Topography>, i: usize) -> Self {
        Self {
            position_mm: simulated.w_mm()[i],
            coordinate_mm: simulated.z_mm().to_vec(),
            target_um: target.filter(|t| same_grid(t, simulated)).map(|t| t.f_um()[i].clone()),
            simulated_um: simulated.f_um()[i].clone(),
            values_um: Vec::new(),
        }
    }
}

fn same_grid(a: &Topography, b: &Topography) -> bool {
    a.w_mm().len() == b.w_mm().len() && a.z_mm().len() == b.z_mm().len()
}

const WIDTH: f64 = 880.0;
const GAP: f64 = 40.0;
const PLOT_HEIGHT: f64 = 170.0;
const LINE: f64 = 15.0;

/// One row of the sheet: profiles or helices.
struct Row<'a> {
    heading: &'static str,
    coordinate: &'static str,
    section: &'static str,
    /// Name of that end and what it is.
    lower: [&'static str; 2],
    upper: [&'static str; 2],
    traces: Vec<(&'a str, &'a [SectionTrace])>,
}

/// Draws profile traces above helix traces, flanks side by side, target dashed and simulated solid, with one scale for
/// all values.
///
/// # Errors
/// [`ChartError`] without traces, for lists of different length, unsorted coordinates or values that are not finite.
pub fn profile_helix_diagram(diagram: &ProfileHelixDiagram) -> Result<Svg, ChartError> {
    let traces = || diagram.flanks.iter().flat_map(|flank| flank.profiles.iter().chain(&flank.helices));
    check_count("profile and helix traces", traces().count(), 1)?;
    traces().try_for_each(check_trace)?;
    let (lo, hi) = traces()
        .flat_map(|trace| trace.simulated_um.iter().chain(trace.target_um.iter().flatten()))
        .fold((0.0_f64, 0.0_f64), |(lo, hi), &f| (lo.min(f), hi.max(f)));
    let (lo, hi) = if hi - lo > LEAST_SPAN { (lo, hi) } else { (-0.5, 0.5) };

    let row = |heading, coordinate, section, ends: [[&'static str; 2]; 2], helices: bool| Row {
        heading,
        coordinate,
        section,
        lower: ends[0],
        upper: ends[1],
        traces: diagram
            .flanks
            .iter()
            .map(|f| (f.name.as_str(), if helices { &f.helices[..] } else { &f.profiles[..] }))
            .collect(),
    };
    let rows: Vec<Row> = [
        row("Profile", "w [mm]", "z", [["", "root"], ["tip", ""]], false),
        row("Helix", "z [mm]", "w", [["face I", "(not datum)"], ["face II", "(datum)"]], true),
    ]
    .into_iter()
    .filter(|row| row.traces.iter().any(|(_, traces)| !traces.is_empty()))
    .collect();
    let height = 50.0 + rows.iter().map(Row::height).sum::<f64>();
    let mut canvas = Canvas::new(WIDTH, height, &diagram.title);
    canvas.heading("");
    draw_legend(&mut canvas, diagram);
    let mut top = 50.0;
    for row in &rows {
        row.draw(&mut canvas, top, (lo, hi));
        top += row.height();
    }
    Ok(canvas.finish())
}

fn check_trace(trace: &SectionTrace) -> Result<(), ChartError> {
    check_values("trace position", &[trace.position_mm])?;
    check_count("trace", trace.coordinate_mm.len(), 2)?;
    check_values("trace coordinate", &trace.coordinate_mm)?;
    check_ascending("trace coordinate", &trace.coordinate_mm)?;
    for (name, values) in
        [("simulated trace", Some(&trace.simulated_um)), ("target trace", trace.target_um.as_ref())]
    {
        let Some(values) = values else { continue };
        check_length(name, trace.coordinate_mm.len(), values.len())?;
        check_values(name, values)?;
    }
    trace.values_um.iter().try_for_each(|(name, value)| check_values(name, &[*value]))
}

fn draw_legend(canvas: &mut Canvas, diagram: &ProfileHelixDiagram) {
    let style = TextStyle::new(TICK_SIZE, Anchor::Start);
    canvas.line([0.0, 36.0], [34.0, 36.0], SIMULATED);
    canvas.text([40.0, 40.0], &diagram.simulated_name, style);
    canvas.line([150.0, 36.0], [184.0, 36.0], TARGET);
    canvas.text([190.0, 40.0], &diagram.target_name, style);
    canvas.text([300.0, 40.0], "to the right: + material left standing", style.muted());
}

/// Thin over broad, so that both are seen where they coincide.
const SIMULATED: Stroke = Stroke::solid(BLUE, 1.2);
const TARGET: Stroke = Stroke { color: "#dd9a66", width: 3.6, dash: "7 4" };

impl Row<'_> {
    fn value_lines(&self) -> usize {
        self.traces.iter().flat_map(|(_, t)| t.iter()).map(|t| t.values_um.len()).max().unwrap_or(0)
    }

    fn height(&self) -> f64 {
        30.0 + PLOT_HEIGHT + 22.0 + LINE * self.value_lines() as f64 + 34.0
    }

    fn draw(&self, canvas: &mut Canvas, top: f64, (lo, hi): (f64, f64)) {
        let places = self.traces.len().max(2) as f64;
        let width = (WIDTH - GAP * (places - 1.0)) / places;
        for (k, (name, traces)) in self.traces.iter().enumerate() {
            if traces.is_empty() {
                continue;
            }
            let left = k as f64 * (width + GAP);
            let heading = format!("{}, {}", self.heading, lower_first(name));
            canvas.text([left, top + 20.0], &heading, TextStyle::new(13.0, Anchor::Start).bold());
            let frame =
                Frame { left: left + 48.0, top: top + 30.0, width: width - 96.0, height: PLOT_HEIGHT };
            self.draw_block(canvas, frame, traces, (lo, hi));
        }
    }

    fn draw_block(&self, canvas: &mut Canvas, frame: Frame, traces: &[SectionTrace], (lo, hi): (f64, f64)) {
        let first = traces.iter().map(|t| t.coordinate_mm[0]).fold(f64::INFINITY, f64::min);
        let last = traces
            .iter()
            .map(|t| t.coordinate_mm[t.coordinate_mm.len() - 1])
            .fold(f64::NEG_INFINITY, f64::max);
        let axis = Axis::tight(first, last, 6);
        for (share, _) in axis.ticks() {
            canvas.line(frame.at(0.0, share), frame.at(1.0, share), Stroke::solid(GRID, 0.8));
        }
        frame.ordinate(canvas, &axis);
        frame.ordinate_title(canvas, &axis, self.coordinate, 36.0);
        let end = TextStyle::new(11.0, Anchor::Start).muted();
        for (lines, below) in [(self.upper, frame.top + 9.0), (self.lower, frame.bottom() - 13.0)] {
            for (text, y) in lines.into_iter().zip([below, below + 13.0]).filter(|(text, _)| !text.is_empty())
            {
                canvas.text([frame.right() + 5.0, y], text, end);
            }
        }

        let slot = frame.width / traces.len() as f64;
        let margin = (0.14 * slot).clamp(6.0, 24.0);
        let per_um = (slot - 2.0 * margin) / (hi - lo);
        for (k, trace) in traces.iter().enumerate() {
            let slot_left = frame.left + k as f64 * slot;
            if k > 0 {
                let stroke = Stroke::solid(FAINT, 0.8);
                canvas.line([slot_left, frame.top], [slot_left, frame.bottom()], stroke);
            }
            let zero = slot_left + margin - per_um * lo;
            let point = |x: f64, f: f64| [zero + per_um * f, frame.bottom() - axis.share(x) * frame.height];
            canvas.line([zero, frame.top], [zero, frame.bottom()], Stroke::solid(INK, 0.9));
            let curve = |values: &[f64]| -> Vec<[f64; 2]> {
                trace.coordinate_mm.iter().zip(values).map(|(&x, &f)| point(x, f)).collect()
            };
            if let Some(target) = &trace.target_um {
                canvas.polylines(&[curve(target)], TARGET);
            }
            canvas.polylines(&[curve(&trace.simulated_um)], SIMULATED);
            self.draw_values(canvas, [slot_left + 0.5 * slot, frame.bottom()], trace);
        }
        frame.outline(canvas);
        self.draw_bars(canvas, frame, per_um, frame.height / (last - first));
    }

    fn draw_values(&self, canvas: &mut Canvas, at: [f64; 2], trace: &SectionTrace) {
        let position = format!("{} = {} mm", self.section, format_fixed(trace.position_mm, 2));
        let centred = TextStyle::new(TICK_SIZE, Anchor::Middle);
        canvas.text([at[0], at[1] + 17.0], &position, centred.bold());
        for (k, (name, value)) in trace.values_um.iter().enumerate() {
            let text = format!("{name} = {} µm", format_fixed(*value, 2));
            canvas.text([at[0], at[1] + 17.0 + LINE * (k + 1) as f64], &text, centred);
        }
    }

    /// Bars of a round length in um (value) and mm (coordinate) below the block.
    fn draw_bars(&self, canvas: &mut Canvas, frame: Frame, per_um: f64, per_mm: f64) {
        let y = frame.bottom() + 22.0 + LINE * self.value_lines() as f64 + 14.0;
        let um = round_step(30.0 / per_um, 1);
        let text = if um < 1e-3 { format_significant(um, 1) } else { format_fixed(um, decimals_of(um)) };
        horizontal_bar(canvas, frame.left, y, per_um * um, &format!("{text} µm (value)"));
        let mm = round_below(60.0 / per_mm);
        let text = format!("{} mm ({}, upwards)", format_fixed(mm, decimals_of(mm)), &self.coordinate[..1]);
        horizontal_bar(canvas, frame.left + 0.5 * frame.width, y, per_mm * mm, &text);
    }
}

fn lower_first(text: &str) -> String {
    let mut chars = text.chars();
    chars.next().map(|c| c.to_lowercase().chain(chars).collect()).unwrap_or_default()
}
