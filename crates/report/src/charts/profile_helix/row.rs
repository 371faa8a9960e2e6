//! A row of the diagram: profiles or helix traces of both flanks about the middle column.

use super::{
    FlankSections, LABEL, ProfileHelixDiagram, RangeMark, SIMULATED, SectionTrace, TARGET, TEXT, WIDTH, along,
};
use crate::charts::magnification::words;
use crate::charts::numbers::format_fixed;
use crate::charts::palette::{FAINT, INK, MUTED};
use crate::charts::scale::Axis;
use crate::charts::svg::{Anchor, Canvas, Stroke, TextStyle};
use foundation::geometry::Flank;

/// Width of the middle column and of a field, mm.
const MIDDLE: f64 = 24.0;
const FIELD: f64 = 0.5 * (WIDTH - MIDDLE);
/// Heights from the top of a row: its title, the plot, what stands below.
const TITLE_ROOM: f64 = 5.5;
const PLOT: f64 = 40.0;
const BELOW: f64 = 4.6;
const VALUE_LINE: f64 = 3.1;
/// Between the plot's border and the ends of the traces.
const MARGIN: f64 = 2.5;
/// Share of a lane that values may fill.
pub(super) const DRAWN: f64 = 0.86;

/// Ends of the evaluated range, and of a relief.
pub(super) const RANGE: Stroke = Stroke::solid(INK, 0.3);
pub(super) const RELIEF: Stroke = Stroke { color: INK, width: 0.25, dash: "2.2 0.9 0.5 0.9" };
const THIN: Stroke = Stroke::solid(FAINT, 0.2);
const AXIS: Stroke = Stroke::solid(MUTED, 0.2);

/// Profiles or helix traces.
pub(super) struct Row<'a> {
    heading: &'static str,
    coordinate: &'static str,
    section: &'static str,
    /// Names of the upper and the lower end.
    ends: [&'static str; 2],
    /// Whether the coordinate grows upwards.
    rising: bool,
    /// Traces and marks of the flanks.
    flanks: Vec<(Flank, &'a [SectionTrace], &'a [RangeMark])>,
}

/// Where the field of a flank lies.
struct Place {
    inner: f64,
    outwards: f64,
}

impl Place {
    fn of(flank: Flank) -> Self {
        match flank {
            Flank::Left => Self { inner: FIELD, outwards: -1.0 },
            Flank::Right => Self { inner: WIDTH - FIELD, outwards: 1.0 },
        }
    }

    /// x at a distance from the middle column.
    fn outward(&self, distance: f64) -> f64 {
        self.inner + self.outwards * distance
    }
}

/// Where a coordinate lies on paper.
struct Ordinate {
    middle_mm: f64,
    centre: f64,
    /// mm of paper per mm, downwards.
    downwards: f64,
}

impl Ordinate {
    fn y(&self, at_mm: f64) -> f64 {
        self.centre + self.downwards * (at_mm - self.middle_mm)
    }
}

impl<'a> Row<'a> {
    /// The rows that a diagram has.
    pub(super) fn of(diagram: &'a ProfileHelixDiagram) -> Vec<Self> {
        type Pick = fn(&FlankSections) -> (&[SectionTrace], &[RangeMark]);
        let of = |pick: Pick| -> Vec<(Flank, &'a [SectionTrace], &'a [RangeMark])> {
            let one = |flank: &'a FlankSections| {
                let (traces, marks) = pick(flank);
                (!traces.is_empty()).then_some((flank.flank, traces, marks))
            };
            diagram.flanks.iter().filter_map(one).collect()
        };
        let profile = Self {
            heading: "Profile",
            coordinate: "w",
            section: "z",
            ends: ["tip", "root"],
            rising: diagram.external,
            flanks: of(|flank| (&flank.profiles, &flank.profile_marks)),
        };
        let helix = Self {
            heading: "Helix",
            coordinate: "z",
            section: "w",
            // As inspection sheets have it: the datum face below.
            ends: ["face I (not datum)", "face II (datum)"],
            rising: false,
            flanks: of(|flank| (&flank.helices, &flank.helix_marks)),
        };
        [profile, helix].into_iter().filter(|row| !row.flanks.is_empty()).collect()
    }

    fn lanes(&self) -> usize {
        self.flanks.iter().map(|(_, traces, _)| traces.len()).max().unwrap_or(1).max(1)
    }

    /// Width of the lane of a trace, mm.
    pub(super) fn lane(&self) -> f64 {
        FIELD / self.lanes() as f64
    }

    fn value_lines(&self) -> usize {
        let traces = self.flanks.iter().flat_map(|(_, traces, _)| traces.iter());
        traces.map(|trace| trace.values_um.len()).max().unwrap_or(0)
    }

    pub(super) fn height(&self) -> f64 {
        TITLE_ROOM + PLOT + BELOW + VALUE_LINE * self.value_lines() as f64 + 2.0
    }

    pub(super) fn draw(&self, canvas: &mut Canvas, top: f64, values: [f64; 2], magnification: f64) {
        let plot = top + TITLE_ROOM;
        let places = self.flanks.iter().flat_map(|(_, traces, marks)| {
            let ends =
                traces.iter().flat_map(|t| t.coordinate_mm.first().into_iter().chain(t.coordinate_mm.last()));
            ends.chain(marks.iter().map(|mark| &mark.at_mm)).copied()
        });
        let [lo, hi] = places.fold([f64::INFINITY, f64::NEG_INFINITY], |[lo, hi], x| [lo.min(x), hi.max(x)]);
        let scale = along(hi - lo, PLOT - 2.0 * MARGIN);
        let ordinate = Ordinate {
            middle_mm: 0.5 * (lo + hi),
            centre: plot + 0.5 * PLOT,
            downwards: if self.rising { -scale } else { scale },
        };
        for (flank, traces, marks) in &self.flanks {
            self.field(canvas, (*flank, traces, marks), plot, &ordinate, (values, magnification));
        }
        self.middle(canvas, plot, &ordinate, [lo, hi], (magnification, scale));
    }

    fn field(
        &self,
        canvas: &mut Canvas,
        (flank, traces, marks): (Flank, &[SectionTrace], &[RangeMark]),
        plot: f64,
        ordinate: &Ordinate,
        ([lo, hi], magnification): ([f64; 2], f64),
    ) {
        let place = Place::of(flank);
        let left = place.outward(0.0).min(place.outward(FIELD));
        let name = match flank {
            Flank::Left => "left flank",
            Flank::Right => "right flank",
        };
        let (near, far) = match flank {
            Flank::Left => (Anchor::End, Anchor::Start),
            Flank::Right => (Anchor::Start, Anchor::End),
        };
        let heading = format!("{}, {name}", self.heading);
        canvas.text([place.outward(1.0), plot - 1.6], &heading, TextStyle::new(TEXT, near).bold());
        canvas.text([place.outward(FIELD - 7.0), plot - 1.6], "material", TextStyle::new(LABEL, far).muted());
        let [tail, tip, barb] = [6.0, 1.0, 2.4].map(|d| place.outward(FIELD - d));
        let y = plot - 2.4;
        canvas.line([tail, y], [tip, y], SIMULATED);
        canvas.polylines(&[vec![[barb, y - 0.7], [tip, y], [barb, y + 0.7]]], SIMULATED);
        for mark in marks {
            let y = ordinate.y(mark.at_mm);
            canvas.line([left, y], [left + FIELD, y], if mark.ends_range { RANGE } else { RELIEF });
        }
        let lane = self.lane();
        let per_um = 1e-3 * magnification;
        for (k, trace) in traces.iter().enumerate() {
            if k > 0 {
                let x = place.outward(k as f64 * lane);
                canvas.line([x, plot], [x, plot + PLOT], THIN);
            }
            let centre = (k as f64 + 0.5) * lane;
            let at = |x: f64, f: f64| [place.outward(centre + per_um * (f - 0.5 * (lo + hi))), ordinate.y(x)];
            let zero = at(0.0, 0.0)[0];
            canvas.line([zero, plot], [zero, plot + PLOT], AXIS);
            let curve = |values: &[f64]| -> Vec<[f64; 2]> {
                trace.coordinate_mm.iter().zip(values).map(|(&x, &f)| at(x, f)).collect()
            };
            if let Some(target) = &trace.target_um {
                canvas.polylines(&[curve(target)], TARGET);
            }
            canvas.polylines(&[curve(&trace.simulated_um)], SIMULATED);
            self.values(canvas, [place.outward(centre), plot + PLOT], trace);
        }
        canvas.rect([left, plot], [FIELD, PLOT], "none", Some(Stroke::solid(INK, 0.25)));
    }

    fn values(&self, canvas: &mut Canvas, [x, y]: [f64; 2], trace: &SectionTrace) {
        let position = format!("{} = {} mm", self.section, format_fixed(trace.position_mm, 2));
        let centred = TextStyle::new(LABEL, Anchor::Middle);
        canvas.text([x, y + 3.2], &position, centred.bold());
        for (k, (name, value)) in trace.values_um.iter().enumerate() {
            let text = format!("{name} = {} µm", format_fixed(*value, 2));
            canvas.text([x, y + 3.2 + VALUE_LINE * (k + 1) as f64], &text, centred);
        }
    }

    /// Magnifications, names of the ends, ticks of the coordinate, a bar for the values.
    fn middle(
        &self,
        canvas: &mut Canvas,
        plot: f64,
        ordinate: &Ordinate,
        [lo, hi]: [f64; 2],
        (magnification, scale): (f64, f64),
    ) {
        let middle = 0.5 * WIDTH;
        let centred = TextStyle::new(LABEL, Anchor::Middle);
        let [upper, lower] = self.ends;
        canvas.text([middle, plot - 1.6], upper, centred.bold());
        canvas.text([middle, plot + PLOT + 3.2], lower, centred.bold());
        for (share, label) in Axis::tight(lo, hi, 6).ticks() {
            let y = ordinate.y(lo + share * (hi - lo));
            for flank in Flank::BOTH {
                let place = Place::of(flank);
                canvas.line([place.outward(0.0), y], [place.outward(-1.2), y], AXIS);
            }
            canvas.text([middle, y + 0.8], &label, centred);
        }
        let title = format!("{} [mm]", self.coordinate);
        let aside = TextStyle::new(LABEL, Anchor::Middle).muted().turned(-90.0);
        canvas.text([0.5 * WIDTH - 8.0, plot + 0.5 * PLOT], &title, aside);
        let scales = format!("f {}, {} {}", words(magnification), self.coordinate, words(scale));
        canvas.text([middle, plot + PLOT + 6.4], &scales, centred);
    }
}
