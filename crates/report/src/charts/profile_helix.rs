//! Profile and helix diagrams as a gear measuring machine prints them, in millimetres of paper: left and right flank mirrored about a
//! middle column, material outwards, the magnification stated, both ends of the coordinate named, the evaluated range marked,
//! characteristic values below each trace.

mod row;

use foundation::geometry::Flank;
use serde::Serialize;

use super::error::{ChartError, LEAST_SPAN, check_ascending, check_count, check_length, check_values};
use super::magnification::{largest, of_traces};
use super::palette::BLUE;
use super::svg::{Anchor, Canvas, Stroke, Svg, TextStyle};
use super::topography::Topography;
use row::Row;

/// The diagrams of one gear.
#[derive(Clone, Debug, PartialEq)]
pub struct ProfileHelixDiagram {
    /// Heading of the chart.
    pub title: String,
    /// One or both flanks.
    pub flanks: Vec<FlankSections>,
    /// Whether the gear is external, so that lengths of roll grow towards the tip.
    pub external: bool,
    /// Name of the dashed curve, for example "target"; empty where there is none.
    pub target_name: String,
    /// Name of the solid curve, for example "simulated".
    pub simulated_name: String,
}

/// The traces of one flank.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct FlankSections {
    /// The flank: the left one stands left of the middle, the right one right of it.
    pub flank: Flank,
    /// Traces over the length of roll w (mm) at fixed z.
    pub profiles: Vec<SectionTrace>,
    /// Traces over the face width z (mm) at fixed w.
    pub helices: Vec<SectionTrace>,
    /// Where the evaluated profile begins and ends, and where its part without reliefs does.
    pub profile_marks: Vec<RangeMark>,
    /// The same of the helix.
    pub helix_marks: Vec<RangeMark>,
}

/// A line across the traces at a place of their coordinate.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct RangeMark {
    /// The place, mm.
    pub at_mm: f64,
    /// Whether the evaluated range ends there; else a zone of relief does.
    pub ends_range: bool,
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

/// Width of the diagram on paper, mm: that of a printed page of A4 between its margins.
const WIDTH: f64 = 182.0;
/// Heights of heading and legend, mm.
const HEAD: f64 = 11.0;
/// Sizes of letters, mm.
const TITLE: f64 = 3.4;
const TEXT: f64 = 2.7;
const LABEL: f64 = 2.3;

/// Thin over broad, so that both are seen where they coincide.
const SIMULATED: Stroke = Stroke::solid(BLUE, 0.3);
const TARGET: Stroke = Stroke { color: "#dd9a66", width: 0.8, dash: "1.6 1" };

/// Draws profile traces above helix traces, the left flank mirrored beside the right one, target dashed and simulated solid, with one
/// magnification for all values.
///
/// # Errors
/// [`ChartError`] without traces, for lists of different length, unsorted coordinates or values that are not finite.
pub fn profile_helix_diagram(diagram: &ProfileHelixDiagram) -> Result<Svg, ChartError> {
    let traces = || diagram.flanks.iter().flat_map(|flank| flank.profiles.iter().chain(&flank.helices));
    check_count("profile and helix traces", traces().count(), 1)?;
    traces().try_for_each(check_trace)?;
    let marks = diagram.flanks.iter().flat_map(|flank| flank.profile_marks.iter().chain(&flank.helix_marks));
    check_values("mark of a range", &marks.map(|mark| mark.at_mm).collect::<Vec<f64>>())?;
    let (lo, hi) = traces()
        .flat_map(|trace| trace.simulated_um.iter().chain(trace.target_um.iter().flatten()))
        .fold((0.0_f64, 0.0_f64), |(lo, hi), &f| (lo.min(f), hi.max(f)));
    let values = if hi - lo > LEAST_SPAN { [lo, hi] } else { [-0.5, 0.5] };
    let rows = Row::of(diagram);
    let lane = rows.iter().map(Row::lane).fold(f64::INFINITY, f64::min);
    let magnification = of_traces(values[1] - values[0], row::DRAWN * lane);
    let height = HEAD + rows.iter().map(Row::height).sum::<f64>();
    let mut canvas = Canvas::millimetres(WIDTH, height, &diagram.title);
    draw_head(&mut canvas, diagram);
    let mut top = HEAD;
    for row in &rows {
        row.draw(&mut canvas, top, values, magnification);
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

/// Title, legend, and how the lines across are drawn.
fn draw_head(canvas: &mut Canvas, diagram: &ProfileHelixDiagram) {
    let title = diagram.title.clone();
    canvas.text([0.0, 3.6], &title, TextStyle::new(TITLE, Anchor::Start).bold());
    let style = TextStyle::new(LABEL, Anchor::Start);
    let y = 8.2;
    let mut x = 0.0;
    let mut entry = |name: &str, strokes: &[Stroke], room: f64| {
        for stroke in strokes {
            canvas.line([x, y - 0.8], [x + 8.0, y - 0.8], *stroke);
        }
        canvas.text([x + 9.2, y], name, style);
        x += room;
    };
    entry(&diagram.simulated_name, &[SIMULATED], 32.0);
    if !diagram.target_name.is_empty() {
        entry(&diagram.target_name, &[TARGET], 27.0);
    }
    entry("evaluated range", &[row::RANGE], 34.0);
    entry("end of a relief", &[row::RELIEF], 34.0);
    canvas.text([WIDTH, y], "outwards: + material left standing", TextStyle::new(LABEL, Anchor::End).muted());
}

/// The magnification of a coordinate that fills its height.
fn along(length: f64, height: f64) -> f64 {
    if length > 0.0 { largest(length, height) } else { 1.0 }
}
