//! A worm flank dressed in strokes for a plan: DK(v) of every stroke from the wanted worm function, and what the flank grinds
//! (`docs/mathematics/dressing.md#conditions`). Knows no files and no referee.

use super::dressed::{MOST_NODES, tail};
use super::{
    GeneratingError, GrindingSetup, IdealPlan, IdealWorm, PlanningGrid, SeriesRule, StrokeLayout, StrokePlace,
};
use contact::{ContactSolution, ExactContact, ThreadFunction};
use dressing::{
    ActiveArea, DressedProfile, DresserTool, DressingError, MovingStroke, NodePlan, Stroke, StrokeAlong,
    StrokedWorm, WidthLaw, solve_stroke_node,
};
use foundation::geometry::Flank;
use foundation::kinematics::GeneratingMotion;
use foundation::numerics::{Chebyshev, equidistant, extremes};
use rayon::prelude::*;

/// One flank of the worm, dressed in strokes.
#[derive(Clone, Debug)]
pub struct StrokedFlank {
    /// What dresses which lengths of roll, one entry a stroke.
    pub places: Vec<StrokePlace>,
    /// The strokes along the worm.
    pub worm: StrokedWorm,
    /// Lengths of roll and worm z that all strokes together finish, mm.
    pub area: ([f64; 2], [f64; 2]),
}

/// Most nodes of DK(v) where polynomials tell the wanted function.
const MOST_SMOOTH_NODES: usize = 65;
/// A contact this far beyond the end of an active area, mm of its profile parameter, still belongs to the edge there: where two
/// strokes meet in a ridge, the contacts of both leave their areas and the ridge grinds.
const EDGE: f64 = 0.5;
/// Lengths of roll by which a stroke may stand off a point and still be asked for it, mm.
const NEAR: f64 = 1.0;
/// A contact stands on the finished worm if no stroke cuts deeper there by more than this, mm: rounding of two envelopes.
const STANDING: f64 = 1e-9;
/// Parameters that differ by less are the same, mm.
const ROUNDING: f64 = 1e-9;
/// Worm z at which strokes that move over the face are looked at for gaps.
const MOVING_HEIGHTS: usize = 17;
/// What is left out at both ends there, mm.
const END: f64 = 1e-5;

impl StrokedFlank {
    /// Strokes with solved or given corrections as a flank.
    ///
    /// # Errors
    /// [`DressingError::Gap`] where they leave stock; [`DressingError::NoContact`] where the end of an area touches nothing.
    pub fn new(
        layout: &StrokeLayout,
        flank: Flank,
        places: Vec<StrokePlace>,
        strokes: Vec<StrokeAlong>,
    ) -> Result<Self, GeneratingError> {
        let (mut from, mut to) = (f64::NEG_INFINITY, f64::INFINITY);
        for stroke in &strokes {
            let [low, high] = stroke.finished()?;
            (from, to) = (from.max(low), to.min(high));
        }
        let worm = StrokedWorm::of(flank, strokes)?;
        let profile = layout.profile[flank];
        let moves = places.iter().any(|place| place.over_face.is_some());
        let heights = if moves {
            // The very ends of a stroke that moves are known to rounding only.
            equidistant([from + END, to - END], MOVING_HEIGHTS)
        } else {
            vec![from, 0.5 * (from + to), to]
        };
        worm.check_cover(profile, &heights)?;
        Ok(Self { places, worm, area: (profile, [from, to]) })
    }

    /// Strokes whose corrections are given.
    ///
    /// # Errors
    /// Those of [`StrokedFlank::new`] and [`StrokeAlong::at`]; [`GeneratingError::NotDressed`] for a dresser that is not there.
    pub fn of_corrections(
        layout: &StrokeLayout,
        flank: Flank,
        strokes: Vec<(StrokePlace, [Chebyshev; 4])>,
    ) -> Result<Self, GeneratingError> {
        let mut places = Vec::with_capacity(strokes.len());
        let mut along = Vec::with_capacity(strokes.len());
        for (place, corrections) in strokes {
            let tool = layout.dressers.get(place.dresser).ok_or(GeneratingError::NotDressed)?;
            along.push(StrokeAlong::at(
                &Stroke { tool, area: place.area, range: place.range },
                flank,
                corrections,
            )?);
            places.push(place);
        }
        Self::new(layout, flank, places, along)
    }

    /// Solves every stroke of a flank for the worm function of a plan, `margin` mm beyond the used worm width at each end.
    ///
    /// # Errors
    /// Those of [`StrokeAlong::solve`] of the first stroke that fails, and of [`StrokedFlank::new`].
    pub fn solve(
        setup: &GrindingSetup,
        layout: &StrokeLayout,
        plan: &IdealPlan,
        flank: Flank,
        margin: f64,
    ) -> Result<Self, GeneratingError> {
        let worm = plan.worms[flank].as_ref().ok_or(GeneratingError::NoFlank)?;
        let occupied = setup.lines[flank].occupation(&plan.motion.shift);
        let ends = [occupied[0] - margin, occupied[1] + margin];
        let places = layout.strokes[flank].clone();
        let solved: Vec<_> =
            places.par_iter().map(|place| along(setup, layout, worm, flank, place, ends)).collect();
        // The first of the strokes that fail is named, on any number of threads.
        let numbered = solved.into_iter().zip(1..).map(|(solved, number)| {
            solved.map_err(|error| match error {
                GeneratingError::Dressing(error) => GeneratingError::Stroke { number, error },
                other => other,
            })
        });
        let strokes = numbered.collect::<Result<Vec<_>, _>>()?;
        Self::new(layout, flank, places, strokes)
    }

    /// The exact flank that the strokes leave on the workpiece, by grid point, from the contacts with every stroke: those count that
    /// stand on the finished worm, the least of all strokes. Tool parameters of the solutions are (w_1, z_1).
    ///
    /// # Errors
    /// Those of the exact contact where no stroke grinds a point; [`DressingError::Gap`].
    pub fn ground(
        &self,
        setup: &GrindingSetup,
        flank: Flank,
        grid: &PlanningGrid,
        motion: &GeneratingMotion,
    ) -> Result<Vec<ContactSolution>, GeneratingError> {
        let surfaces: Vec<_> = self.worm.strokes().iter().map(StrokeAlong::surface).collect();
        let contacts: Vec<_> =
            surfaces.iter().map(|surface| ExactContact::new(&setup.pair, flank, motion, surface)).collect();
        let reaches: Vec<[f64; 2]> = self.places.iter().map(reach).collect();
        let point = |w_2: f64, z_2: f64| {
            let (w_1, z_1) = setup.lines[flank].worm_point(w_2, z_2, &motion.shift);
            let (mut found, mut failure) = (Vec::new(), None);
            for ((stroke, contact), near) in self.worm.strokes().iter().zip(&contacts).zip(&reaches) {
                if w_1 < near[0] - NEAR || w_1 > near[1] + NEAR {
                    continue;
                }
                match contact.solve(w_2, z_2) {
                    Ok(solution) => found.extend(Touch::new(stroke, solution)),
                    Err(error) => {
                        failure.get_or_insert(error);
                    }
                }
            }
            match (self.what_grinds(found), failure) {
                (Some(solution), _) => Ok(solution),
                (None, Some(error)) => Err(error.into()),
                (None, None) => Err(GeneratingError::from(DressingError::Gap {
                    flank,
                    from: w_1,
                    to: w_1,
                    beside: [None, None],
                    b: Some(z_1),
                })),
            }
        };
        let rows: Vec<Result<Vec<ContactSolution>, GeneratingError>> = grid.w[flank]
            .par_iter()
            .map(|&w_2| grid.z.iter().map(|&z_2| point(w_2, z_2)).collect())
            .collect();
        let mut solutions = Vec::with_capacity(grid.w[flank].len() * grid.z.len());
        for row in rows {
            solutions.extend(row?);
        }
        Ok(solutions)
    }

    /// The contact that leaves least among those on the finished worm. Where there is none, a ridge between two strokes grinds, which
    /// lies beside the contacts of both: the one that leaves more is nearer to it.
    fn what_grinds(&self, touches: Vec<Touch>) -> Option<ContactSolution> {
        let inside: Vec<&Touch> = touches.iter().filter(|touch| touch.beyond == 0.0).collect();
        if let [only] = inside.as_slice() {
            return Some(only.solution);
        }
        let stands = |touch: &&&Touch| {
            let (w, b) = touch.solution.tool;
            self.worm.modification(w, b).is_ok_and(|least| touch.f <= least.f + STANDING)
        };
        let by_height = |a: &&&Touch, b: &&&Touch| a.solution.f_n.total_cmp(&b.solution.f_n);
        let on_worm = inside.iter().filter(stands).min_by(by_height);
        let nearest = || touches.iter().min_by(|a, b| a.beyond.total_cmp(&b.beyond));
        on_worm
            .or_else(|| inside.iter().max_by(by_height))
            .copied()
            .or_else(nearest)
            .map(|touch| touch.solution)
    }
}

/// A contact of the workpiece with the envelope of one stroke.
struct Touch {
    /// The contact; its tool parameters are (w_1, z_1).
    solution: ContactSolution,
    /// Modification of the stroke there, mm.
    f: f64,
    /// How far beyond the active area it lies, mm of the profile parameter.
    beyond: f64,
}

impl Touch {
    /// `None` for a contact far beyond the active area.
    fn new(stroke: &StrokeAlong, found: ContactSolution) -> Option<Self> {
        let (t, v) = found.tool;
        let [from, to] = stroke.touching();
        let beyond = (from - t).max(t - to);
        let beyond = if beyond <= ROUNDING { 0.0 } else { beyond };
        let foot = stroke.envelope_point(t, v).filter(|_| beyond <= EDGE)?;
        Some(Self { solution: ContactSolution { tool: (foot.w, foot.b), ..found }, f: foot.f, beyond })
    }
}

/// Lengths of roll that a stroke dresses, as far as its range tells, mm.
fn reach(place: &StrokePlace) -> [f64; 2] {
    let (part, range) = (place.area.part(), place.reach());
    let slope = (range[1] - range[0]) / (part[1] - part[0]);
    place.area.touching().map(|t| range[0] + (t - part[0]) * slope)
}

/// DK(v) of one stroke, with as many nodes as it takes, so that it finishes the worm between `ends`, mm.
fn along(
    setup: &GrindingSetup,
    layout: &StrokeLayout,
    worm: &IdealWorm,
    flank: Flank,
    place: &StrokePlace,
    ends: [f64; 2],
) -> Result<StrokeAlong, GeneratingError> {
    let tool = layout.dressers.get(place.dresser).ok_or(GeneratingError::NotDressed)?;
    let range = |b: f64| place.over_face.map_or(place.range, |laws| range_at(worm, tool, flank, &laws, b));
    let stroke = MovingStroke { tool, area: place.area, range: &range };
    let wanted = |w: f64, b: f64| worm.jet(w, b).map_or(f64::NAN, |jet| jet.f);
    let radius = setup.worm_pitch_radius;
    // Where the stroke touches tells between which positions it finishes the length.
    let line = &tool.flanks[flank].line;
    let middle = line.value(tool.flanks[flank].range.middle()) - 0.5 * (ends[0] + ends[1]);
    let dk = solve_stroke_node(&stroke, flank, radius, middle, &[0.0; 4], &wanted)?;
    let profile = DressedProfile::new(tool, flank, dk);
    let touched = edges(&place.area, &profile)?;
    let interval = (touched[0] - ends[1], touched[1] - ends[0]);
    if worm.is_radial() && place.over_face.is_none() {
        let corrections = dk.map(|x| Chebyshev::constant(interval.0, interval.1, x));
        return Ok(StrokeAlong::at(
            &Stroke { tool, area: place.area, range: place.range },
            flank,
            corrections,
        )?);
    }
    let most =
        if worm.carried.is_empty() && place.over_face.is_none() { MOST_SMOOTH_NODES } else { MOST_NODES };
    let lever = [worm.lines.cos_b1 * setup.pair.worm.flank(flank).base_radius, 10.0, 1.0, 0.1];
    let SeriesRule { nodes: mut count, tolerance } = SeriesRule::default();
    loop {
        let plan = NodePlan { interval, nodes: count };
        let solved = StrokeAlong::solve(&stroke, flank, radius, &plan, &wanted)?;
        if 2 * count - 1 > most || tail(&solved.corrections, lever) < tolerance {
            return Ok(solved);
        }
        count = 2 * count - 1;
    }
}

/// Steps in which the place on the gear of an end that moves over the face is found; each leaves a small share of the error.
const PLACE_STEPS: usize = 60;

/// Lengths of roll of a stroke at worm z = b, mm: where the ends that move over the face of the gear lie on the worm.
fn range_at(worm: &IdealWorm, tool: &DresserTool, flank: Flank, laws: &[WidthLaw; 2], b: f64) -> [f64; 2] {
    let lines = &worm.lines;
    let [from, to] = lines.face;
    let middle = tool.flanks[flank].range.middle();
    laws.map(|law| {
        let mut w = middle;
        for _ in 0..PLACE_STEPS {
            let [_, z] = lines.work_point(w, b, &worm.shift);
            let next = law.value((2.0 * z.f - from - to) / (to - from));
            let step = next - w;
            w = next;
            if step.abs() < ROUNDING {
                return w;
            }
        }
        // An end that runs along the lines of the tool has no place of its own on them.
        f64::NAN
    })
}

/// Least and largest worm z at v = 0 of the line in which an area touches the worm.
fn edges(area: &ActiveArea, profile: &DressedProfile<'_>) -> Result<[f64; 2], DressingError> {
    let [from, to] = area.touching();
    let b = [from, 0.5 * (from + to), to].map(|t| profile.at_parameter(t).map(|at| at.b));
    let [first, middle, last] = b;
    Ok(extremes([first?, middle?, last?]))
}
