//! Several strokes along the worm: each has its DK(v), its range may change over the width, and the flank is the least of the
//! exact envelopes (`docs/mathematics/dressing.md#conditions`). Knows no files.

use crate::conditions::topological::follow_nodes;
use crate::strokes::multi_stroke::{ROUNDING, at_least_one, first_gap};
use crate::strokes::stroke::check_range;
use crate::{
    ActiveArea, DressedProfile, DressedWorm, DresserTool, DressingError, EnvelopePoint, NodePlan,
    NodeSolution, Stroke, StrokeSurface, pitch_rolls,
};
use foundation::geometry::Flank;
use foundation::kinematics::DressingCorrection;
use foundation::numerics::Chebyshev;
use rayon::prelude::*;

/// A stroke whose range [w_a, w_b] (lengths of roll, mm) is a function of worm z (mm): a relief that begins elsewhere over the width.
#[derive(Clone, Copy)]
pub struct MovingStroke<'a> {
    /// The dresser, in nominal kinematics on the worm.
    pub tool: &'a DresserTool,
    /// What of it cuts.
    pub area: ActiveArea,
    /// [w_a, w_b] at worm z.
    pub range: &'a (dyn Fn(f64) -> [f64; 2] + Sync),
}

/// Wanted modification f*(w, b), mm normal.
pub type StrokeWish<'a> = &'a (dyn Fn(f64, f64) -> f64 + Sync);

/// Rounds of the fixed point on ranges and targets and their tolerance in w and b, mm.
const ROUNDS: usize = 40;
const ROUND_TOLERANCE: f64 = 1e-9;

/// The correction of a stroke at worm position v: f(w_i) = wanted(w_i, b_i - v) at both ends and in the middle of the range that belongs
/// to the places of its ends, t_b on w_b there.
///
/// # Errors
/// Those of [`Stroke::solve`] with v filled in; [`DressingError::NotConverged`] where the range changes too fast over the width.
pub fn solve_stroke_node(
    stroke: &MovingStroke<'_>,
    flank: Flank,
    reference_radius: f64,
    v: f64,
    start: &DressingCorrection,
    wanted: StrokeWish<'_>,
) -> Result<DressingCorrection, DressingError> {
    let mut dk = *start;
    let mut b = [first_height(stroke, flank); 3];
    let mut ends = [f64::NAN; 2];
    let mut moved = f64::INFINITY;
    for _ in 0..ROUNDS {
        let range = [(stroke.range)(b[0] - v)[0], (stroke.range)(b[2] - v)[1]];
        check_range(range)?;
        let rolls = [range[0], 0.5 * (range[0] + range[1]), range[1]];
        let f: [f64; 3] = std::array::from_fn(|i| wanted(rolls[i], b[i] - v));
        let one = Stroke { tool: stroke.tool, area: stroke.area, range };
        dk = one.solve(flank, reference_radius, f, &dk).map_err(|error| error.at_position(v))?;
        let seated = stroke.area.seated(stroke.tool, flank, range);
        let profile = DressedProfile::new(&seated, flank, dk);
        let pitch = pitch_rolls(&seated, flank);
        let next = [profile.at_roll(pitch[0])?.b, profile.at_roll(pitch[1])?.b, profile.at_roll(pitch[2])?.b];
        let apart = |old: &[f64], new: &[f64]| {
            old.iter().zip(new).fold(0.0_f64, |m, (x, y)| if (x - y).abs() <= m { m } else { (x - y).abs() })
        };
        moved = apart(&b, &next).max(apart(&ends, &range));
        (b, ends) = (next, range);
        if moved < ROUND_TOLERANCE {
            return Ok(dk);
        }
    }
    Err(DressingError::NotConverged { what: "places of the pitch points of a stroke", last: moved })
}

/// Worm z at v = 0 of the nominal contact of the active part's start.
fn first_height(stroke: &MovingStroke<'_>, flank: Flank) -> f64 {
    let line = &stroke.tool.flanks[flank].line;
    let (from, to) = line.interval();
    line.value(stroke.area.part()[0].clamp(from, to))
}

/// One stroke along the worm.
#[derive(Clone, Debug)]
pub struct StrokeAlong {
    /// DK(v), rad, rad, mm, mm.
    pub corrections: [Chebyshev; 4],
    /// The nodes through which it was laid; none where the corrections were given.
    pub nodes: Vec<NodeSolution>,
    touching: [f64; 2],
    seated: DresserTool,
    flank: Flank,
    worm: DressedWorm,
}

/// Nodes of the line in which a stroke touches the worm.
const LINE_NODES: usize = 8;
/// Share of a stroke's range by which that line is continued at each end.
const LINE_BEYOND: f64 = 0.3;

impl StrokeAlong {
    /// Solves DK(v) of one stroke for the wanted f*(w, b).
    ///
    /// # Errors
    /// [`DressingError::InvalidNumber`] for the plan; those of [`solve_stroke_node`].
    pub fn solve(
        stroke: &MovingStroke<'_>,
        flank: Flank,
        reference_radius: f64,
        plan: &NodePlan,
        wanted: StrokeWish<'_>,
    ) -> Result<Self, DressingError> {
        let (from, to) = plan.interval;
        let invalid = |field, value, allowed| Err(DressingError::InvalidNumber { field, value, allowed });
        if !(from.is_finite() && to.is_finite() && from < to) {
            return invalid("end of the interval of v_zS", to, "finite and above its start");
        }
        if plan.nodes < 2 {
            return invalid("nodes of DK(v)", plan.nodes as f64, "at least 2");
        }
        let (corrections, nodes) = follow_nodes(plan, |v, start| {
            solve_stroke_node(stroke, flank, reference_radius, v, start, wanted)
        })?;
        // Start values of the envelope come from the range in the middle of the motion.
        let range = (stroke.range)(first_height(stroke, flank) - 0.5 * (from + to));
        let still = Stroke { tool: stroke.tool, area: stroke.area, range };
        Ok(Self { nodes, ..Self::at(&still, flank, corrections)? })
    }

    /// A stroke with given corrections over v; its range only tells where to begin to look for contacts.
    ///
    /// # Errors
    /// [`DressingError::InvalidNumber`] for an area that the dresser does not have, and for the range.
    pub fn at(stroke: &Stroke<'_>, flank: Flank, corrections: [Chebyshev; 4]) -> Result<Self, DressingError> {
        stroke.area.check(stroke.tool, flank)?;
        check_range(stroke.range)?;
        let mut seated = stroke.area.seated(stroke.tool, flank, stroke.range);
        let (from, to) = corrections[0].interval();
        let dk: DressingCorrection = std::array::from_fn(|j| corrections[j].value(0.5 * (from + to)));
        let beyond = LINE_BEYOND * (stroke.range[1] - stroke.range[0]);
        let start = (stroke.range[0] - beyond).max(0.5 * stroke.range[0]);
        let line = {
            let profile = DressedProfile::new(&seated, flank, dk);
            Chebyshev::fit(start, stroke.range[1] + beyond, LINE_NODES, |w| profile.at_roll(w).map(|at| at.b))
        };
        // A line that cannot be followed leaves the nominal one, from which contacts are found as well, only later.
        if let Ok(line) = line {
            seated.flanks[flank].line = line;
        }
        let worm = DressedWorm::new(&seated, flank, &corrections);
        Ok(Self { corrections, nodes: Vec::new(), touching: stroke.area.touching(), seated, flank, worm })
    }

    /// Parameters of the dresser's profile between which it touches the worm, mm.
    pub fn touching(&self) -> [f64; 2] {
        self.touching
    }

    /// Worm z between which the stroke dresses all of its lengths of roll, mm.
    ///
    /// # Errors
    /// [`DressingError::NoContact`] where an end of the active area touches nothing.
    pub fn finished(&self) -> Result<[f64; 2], DressingError> {
        let (from, to) = self.corrections[0].interval();
        let at = |t: f64, v: f64| {
            let point = self.worm.envelope_point(t, v).map(|at| at.b);
            point.ok_or(DressingError::NoContact { flank: self.flank, t })
        };
        let [a, b] = self.touching;
        Ok([f64::max(at(a, to)?, at(b, to)?), f64::min(at(a, from)?, at(b, from)?)])
    }

    /// The exact envelope as a tool surface, also beyond what touches.
    pub fn surface(&self) -> StrokeSurface<'_> {
        StrokeSurface::new(&self.worm, &self.seated, self.flank)
    }

    /// The exact envelope at the profile parameter t and the worm position v; `None` where there is none.
    pub fn envelope_point(&self, t: f64, v: f64) -> Option<EnvelopePoint> {
        self.worm.envelope_point(t, v)
    }
}

/// A worm flank dressed in several strokes.
#[derive(Clone, Debug)]
pub struct StrokedWorm {
    flank: Flank,
    strokes: Vec<StrokeAlong>,
}

/// A point of the worm and the stroke that finishes it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StrokedPoint {
    /// Normal modification, mm.
    pub f: f64,
    /// Number of the stroke, from 0.
    pub stroke: usize,
    /// Dresser parameter of the contact, mm.
    pub t: f64,
    /// Worm position of the contact, mm.
    pub v: f64,
}

impl StrokedWorm {
    /// Solves DK(v) of every stroke for the wanted f*(w, b).
    ///
    /// # Errors
    /// [`DressingError::InvalidNumber`] without strokes or for the plan; those of [`solve_stroke_node`] of the first stroke that fails.
    pub fn solve(
        strokes: &[MovingStroke<'_>],
        flank: Flank,
        reference_radius: f64,
        plan: &NodePlan,
        wanted: StrokeWish<'_>,
    ) -> Result<Self, DressingError> {
        at_least_one(strokes.len())?;
        let solved = strokes
            .par_iter()
            .map(|stroke| StrokeAlong::solve(stroke, flank, reference_radius, plan, wanted));
        // The first of the strokes that fail is named, on any number of threads.
        Self::of(flank, solved.collect::<Vec<_>>().into_iter().collect::<Result<_, _>>()?)
    }

    /// A flank of strokes that stand already.
    ///
    /// # Errors
    /// [`DressingError::InvalidNumber`] without strokes.
    pub fn of(flank: Flank, strokes: Vec<StrokeAlong>) -> Result<Self, DressingError> {
        at_least_one(strokes.len())?;
        Ok(Self { flank, strokes })
    }

    /// The strokes in the order in which they were given.
    pub fn strokes(&self) -> &[StrokeAlong] {
        &self.strokes
    }

    /// Lengths of roll that each stroke dresses at worm z = b, mm; `None` for a stroke whose motion does not reach that far.
    pub fn covers(&self, b: f64) -> Vec<Option<[f64; 2]>> {
        let end = |stroke: &StrokeAlong, k: usize| stroke.worm.at_height(stroke.touching[k], b);
        let of = |stroke: &StrokeAlong| Some([end(stroke, 0)?.0.w, end(stroke, 1)?.0.w]);
        self.strokes.iter().map(of).collect()
    }

    /// Refuses a flank on which stock is left within `range` (lengths of roll, mm) at one of the worm z in `heights` (mm).
    ///
    /// # Errors
    /// [`DressingError::Gap`] with the first place that no stroke reaches; [`DressingError::InvalidNumber`] for range or heights.
    pub fn check_cover(&self, range: [f64; 2], heights: &[f64]) -> Result<(), DressingError> {
        check_range(range)?;
        if let Some(&value) = heights.iter().find(|b| !b.is_finite()) {
            return Err(DressingError::InvalidNumber { field: "worm z", value, allowed: "finite numbers" });
        }
        for &b in heights {
            if let Some(gap) = first_gap(&self.reached(b), range) {
                return Err(gap.error(self.flank, Some(b)));
            }
        }
        Ok(())
    }

    /// Covered ranges with the numbers of their strokes kept: a stroke that does not reach b covers nothing.
    fn reached(&self, b: f64) -> Vec<[f64; 2]> {
        self.covers(b).into_iter().map(|c| c.unwrap_or([f64::INFINITY, f64::NEG_INFINITY])).collect()
    }

    /// The finished flank at (w, b): the least of the exact envelopes of the strokes whose active area reaches that point.
    ///
    /// # Errors
    /// [`DressingError::Gap`] where none does.
    pub fn modification(&self, w: f64, b: f64) -> Result<StrokedPoint, DressingError> {
        let mut least: Option<StrokedPoint> = None;
        for (number, stroke) in self.strokes.iter().enumerate() {
            let [from, to] = stroke.touching;
            let Some((f, t, v)) = stroke.worm.modification(w, b) else { continue };
            if t < from - ROUNDING || t > to + ROUNDING || least.is_some_and(|other| other.f <= f) {
                continue;
            }
            least = Some(StrokedPoint { f, stroke: number, t, v });
        }
        least.ok_or_else(|| {
            crate::strokes::multi_stroke::Gap::around(&self.reached(b), w).error(self.flank, Some(b))
        })
    }
}
