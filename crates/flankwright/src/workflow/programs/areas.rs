//! Areas of the worm in programs: where roughing passes run, what is dressed for them, and the check from the texts that every pass
//! keeps to its area (spec 25 section 8).

use super::build::Built;
use super::proof::{ReadBack, Sought};
use super::result::WormUse;
use super::task::{DressingWork, GrindingWork, ProgramTask};
use crate::exchange::Diagnostic;
use crate::exchange::job::Job;
use crate::geometry::Sides;
use crate::kinematics::{GeneratingMotion, LawError, MotionLaw, PiecewisePolynomial};
use crate::machine::Station;
use crate::motion::{MotionError, ReadStroke, Tracked, track};
use crate::numerics::equidistant;
use crate::process::generating::FlankLines;
use crate::verdict::Remark;
use crate::workflow::execution::Execution;
use crate::workflow::finding::RunFailure;
use crate::workflow::partition::{Partition, ToolAreas};
use crate::workflow::prepare::Prepared;

/// Points of a law over the finishing area, and over the passage to a roughing area.
const POINTS: [usize; 2] = [513, 65];
/// Distance of the points where the dresser stands still, mm.
const APART: f64 = 2.0;
/// How far a pass may leave its area, mm: digits of a text and the contact that its stock moves.
const SAME_AREA: f64 = 0.05;

/// The areas of a run's programs.
#[derive(Clone, Debug)]
pub(super) struct ProgramAreas {
    areas: ToolAreas,
    lines: Sides<Option<FlankLines>>,
    /// z_1 that the plan uses, both flanks, mm.
    planned: [f64; 2],
    /// Length of the passage between finishing and roughing area, mm.
    passage: f64,
}

impl ProgramAreas {
    /// The areas of a job; `None` where all passes use the one area of the plan.
    ///
    /// # Errors
    /// Those of the partition.
    pub fn of_job(job: &Job, prepared: &Prepared, execution: &Execution) -> Result<Option<Self>, RunFailure> {
        let shift = &execution.motion.shift;
        let partition = Partition::of_job(job, prepared, execution.ratio, shift)?;
        let Some(areas) = partition.and_then(|p| p.tool_areas(job, prepared, shift)) else { return Ok(None) };
        let setup = &prepared.setup;
        let lines = Sides::from_fn(|flank| prepared.targets[flank].as_ref().map(|_| setup.lines[flank]));
        let Some(planned) = hull(lines.iter().filter_map(|(_, l)| l.as_ref()).map(|l| l.occupation(shift)))
        else {
            return Ok(None);
        };
        Ok(Some(Self { areas, lines, planned, passage: setup.run_in() }))
    }

    /// z_V1 over z_V2 of the roughing strokes, one law for each area.
    pub fn roughing_shift(&self) -> Vec<MotionLaw> {
        self.areas.roughing.clone()
    }

    /// A grinding stroke of the plan in the finishing area.
    pub fn placed_grinding(&self, work: &mut GrindingWork) {
        work.motion.shift = work.motion.shift.raised(self.areas.finishing);
    }

    /// Worm positions v_zS that have to be dressed for a range of z_1, where `driven` belongs to the plan's own: v_zS falls as z_1
    /// grows.
    fn dressed_for(&self, driven: [f64; 2], z_1: [f64; 2]) -> [f64; 2] {
        [driven[0] + self.planned[1] - z_1[1], driven[1] + self.planned[0] - z_1[0]]
    }

    /// A dressing stroke of the plan in the finishing area, driven on over the roughing areas. These are dressed with the dresser where
    /// it stands in the middle of the finishing area; from there to here it goes without a jump.
    ///
    /// # Errors
    /// None for laws that a plan makes.
    pub fn placed_dressing(&self, work: &mut DressingWork) -> Result<(), RunFailure> {
        let driven = work.interval;
        let ranges = self.areas.roughing.iter().filter_map(|law| self.touched(law)).collect::<Vec<_>>();
        let own = driven.map(|v| v + self.areas.finishing);
        let whole = ranges.iter().map(|&z_1| self.dressed_for(driven, z_1)).chain([own]);
        let whole = hull(whole).unwrap_or(own);
        let middle = 0.5 * (driven[0] + driven[1]);
        for law in &mut work.motion.correction {
            let constant = law.value(middle);
            let extended = extended(law, driven, self.areas.finishing, whole, (constant, self.passage));
            *law = extended.map_err(|error| {
                let finding = Diagnostic::with_code(error.code(), error.to_string());
                RunFailure::not_producible(finding.field("grinding.roughing_areas").way_out(error.way_out()))
            })?;
        }
        work.interval = whole;
        Ok(())
    }

    /// z_1 that a law touches, both flanks.
    fn touched(&self, law: &MotionLaw) -> Option<[f64; 2]> {
        hull(self.lines.iter().filter_map(|(_, lines)| lines.as_ref()).map(|lines| lines.occupation(law)))
    }

    /// What was read from a text as if the finishing area lay where the plan has it: a worm is a screw, so that its area, its dressing
    /// and its grinding may be moved along it together.
    pub fn as_planned(&self, read: &ReadBack) -> ReadBack {
        let by = self.areas.finishing;
        let mut read = read.clone();
        for stroke in &mut read.grinding {
            stroke.motion.shift = stroke.motion.shift.raised(-by);
        }
        for stroke in &mut read.dressing {
            for law in &mut stroke.motion.correction {
                *law = moved(law, -by);
            }
            stroke.range = stroke.range.map(|v| v - by);
        }
        read
    }

    /// Which part of the worm each pass of the texts touches, from their motions alone. `driven`: worm positions v_zS that the plan
    /// dresses, one range for each dressing stroke.
    ///
    /// # Errors
    /// A roughing pass on lines of the finishing area; a pass outside its area; an area that is not dressed.
    pub fn check(
        &self,
        task: &ProgramTask<'_>,
        built: &Built,
        driven: &[[f64; 2]],
    ) -> Result<Vec<WormUse>, RunFailure> {
        let sought = Sought::of_task(task);
        let mut uses = Vec::new();
        for program in &built.programs {
            let refused = |error: MotionError| {
                let finding = Diagnostic::with_code(error.code(), format!("{}: {error}", program.file));
                RunFailure::not_producible(finding.field("machine").way_out(error.way_out()))
            };
            let tracked =
                track(&program.read, sought.machine, &program.words, &program.start).map_err(refused)?;
            let faults = match program.station {
                Station::Dresser => self.undressed(&sought, &tracked, driven).map_err(refused)?,
                Station::Work => {
                    let (found, faults) = self.ground(&sought, &tracked).map_err(refused)?;
                    uses.extend(found.into_iter().map(|found| WormUse { file: program.file.clone(), ..found }));
                    faults
                }
            };
            if let Some(fault) = faults.first() {
                let finding =
                    Diagnostic::with_code("program-not-proven", format!("{}: {}", program.file, fault.text));
                let way_out = format!("{}; nothing was written", fault.way_out);
                return Err(RunFailure::not_producible(finding.field("machine").way_out(way_out)));
            }
        }
        Ok(uses)
    }

    /// Ranges of the worm that passes use and no stroke of a dressing program dresses.
    ///
    /// # Errors
    /// [`MotionError::NotFollowed`].
    pub fn undressed(
        &self,
        sought: &Sought<'_>,
        tracked: &Tracked,
        driven: &[[f64; 2]],
    ) -> Result<Vec<Remark>, MotionError> {
        let mut faults = Vec::new();
        for (work, &driven) in sought.dressing.iter().zip(driven) {
            let roughing = self.areas.roughing.iter().filter_map(|law| self.touched(law));
            let wanted = roughing.map(|z_1| self.dressed_for(driven, z_1));
            let wanted: Vec<[f64; 2]> = wanted.chain([driven.map(|v| v + self.areas.finishing)]).collect();
            let strokes =
                tracked.dressing(sought.machine, &sought.technology.dressing, &work.motion.chain)?;
            for [from, to] in wanted {
                let covers = |[a, b]: [f64; 2]| a <= from + SAME_AREA && b >= to - SAME_AREA;
                if !strokes.iter().any(|stroke| covers(stroke.range)) {
                    let text = format!(
                        "no stroke dresses the worm over v_zS {from:.3} to {to:.3} mm, where a pass grinds"
                    );
                    faults.push(off_area("area-not-dressed", text));
                }
            }
        }
        Ok(faults)
    }

    /// What the passes of a grinding program touch, and which of them leave their areas.
    ///
    /// # Errors
    /// [`MotionError::NotFollowed`].
    pub fn ground(
        &self,
        sought: &Sought<'_>,
        tracked: &Tracked,
    ) -> Result<(Vec<WormUse>, Vec<Remark>), MotionError> {
        let (mut uses, mut faults) = (Vec::new(), Vec::new());
        for work in &sought.grinding {
            let mounts = &sought.technology.grinding;
            let strokes = tracked.grinding(sought.machine, mounts, &work.motion, work.phase)?;
            for stroke in &strokes {
                self.touches(stroke, work, &sought.technology.roughing, &mut uses, &mut faults);
            }
        }
        Ok((uses, faults))
    }

    /// The areas that one stroke touches.
    fn touches(
        &self,
        stroke: &ReadStroke<GeneratingMotion>,
        work: &GrindingWork,
        stock: &[f64],
        uses: &mut Vec<WormUse>,
        faults: &mut Vec<Remark>,
    ) {
        let least = stock.iter().copied().fold(f64::INFINITY, f64::min);
        let middle = 0.5 * (work.feeds[0] + work.feeds[1]);
        let stands_off =
            (stroke.motion.delta_d.value(middle) - work.motion.delta_d.value(middle)) * work.per_distance;
        let roughing = stands_off > 0.5 * least;
        let laws: Vec<&MotionLaw> =
            if roughing { self.areas.roughing.iter().collect() } else { vec![&work.motion.shift] };
        let [first, last] = stroke.blocks;
        for (flank, lines) in self.lines.iter() {
            let Some(lines) = lines else { continue };
            let found = lines.line_range(&stroke.motion.shift);
            let touched =
                format!("touches worm lines {:.3} to {:.3} mm of the {flank} flank", found[0], found[1]);
            let finishing = lines.line_range(&work.motion.shift);
            let overlap = found[1].min(finishing[1]) - found[0].max(finishing[0]);
            if roughing && overlap > SAME_AREA {
                let text = format!(
                    "the roughing pass of blocks {first} to {last} {touched}, {overlap:.3} mm of which belong to the finishing area"
                );
                faults.push(off_area("pass-on-wrong-area", text));
                continue;
            }
            let apart = |law: &&MotionLaw| {
                let wanted = lines.line_range(law);
                (wanted[0] - found[0]).abs().max((wanted[1] - found[1]).abs())
            };
            let Some(area) = laws.iter().position(|law| apart(law) <= SAME_AREA) else {
                let text = format!(
                    "the pass of blocks {first} to {last} {touched}, which is no area of the layout"
                );
                faults.push(off_area("pass-on-wrong-area", text));
                continue;
            };
            uses.push(WormUse {
                file: String::new(),
                blocks: stroke.blocks,
                flank: flank.name(),
                area: if roughing { format!("roughing {}", area + 1) } else { "finishing 1".to_owned() },
                z_1_mm: lines.occupation(&stroke.motion.shift),
                lines_mm: found,
            });
        }
    }
}

fn off_area(code: &'static str, text: String) -> Remark {
    Remark::new(code, text, "let the program keep to the areas of the layout")
}

/// The smallest range that holds all.
fn hull(ranges: impl Iterator<Item = [f64; 2]>) -> Option<[f64; 2]> {
    ranges.reduce(|a, b| [a[0].min(b[0]), a[1].max(b[1])])
}

/// A law of the range `driven` moved along by `by`, and on over `whole`: over a passage to a constant value, with two continuous
/// derivatives.
fn extended(
    law: &MotionLaw,
    driven: [f64; 2],
    by: f64,
    whole: [f64; 2],
    (constant, passage): (f64, f64),
) -> Result<MotionLaw, LawError> {
    let own = driven.map(|v| v + by);
    let beyond = |end: usize, x: f64| {
        let [value, slope, _] = law.jet(driven[end]);
        let u = ((x - own[end]).abs() / passage).min(1.0);
        let share = 1.0 - u * u * u * (10.0 + u * (6.0 * u - 15.0));
        constant + share * (value + slope * (x - own[end]) - constant)
    };
    let mut x: Vec<f64> = equidistant(own, POINTS[0]);
    let value = |v: f64| match v {
        v if v < own[0] => beyond(0, v),
        v if v > own[1] => beyond(1, v),
        v => law.value(v - by),
    };
    for (end, sense) in [(0, -1.0), (1, 1.0)] {
        let length = sense * (whole[end] - own[end]);
        if length <= 0.0 {
            continue;
        }
        let near = length.min(passage);
        x.extend(equidistant([0.0, near], POINTS[1]).into_iter().skip(1).map(|d| own[end] + sense * d));
        if length > near {
            let far = ((length - near) / APART).ceil() as usize;
            x.extend((1..=far).map(|k| own[end] + sense * (near + (length - near) * k as f64 / far as f64)));
        }
    }
    x.sort_by(f64::total_cmp);
    let y: Vec<f64> = x.iter().map(|&v| value(v)).collect();
    MotionLaw::spline(&x, &y)
}

/// A law as read from a text, moved along its argument: x -> law(x - by).
fn moved(law: &MotionLaw, by: f64) -> MotionLaw {
    match law {
        MotionLaw::Polynomial { origin, coefficients } => {
            MotionLaw::polynomial(origin + by, coefficients.clone())
        }
        MotionLaw::Series(series) => {
            let (from, to) = series[0].interval();
            MotionLaw::series(crate::numerics::Chebyshev::from_coefficients(
                from + by,
                to + by,
                series[0].coefficients().to_vec(),
            ))
        }
        MotionLaw::Pieces(pieces) => {
            let breaks = pieces.breaks().iter().map(|x| x + by).collect();
            PiecewisePolynomial::new(breaks, pieces.pieces().to_vec())
                .map_or_else(|_| law.clone(), MotionLaw::Pieces)
        }
        MotionLaw::Sum(laws) => MotionLaw::Sum(laws.iter().map(|law| moved(law, by)).collect()),
        // Nothing that is read from a text has this form.
        MotionLaw::BSpline { .. } => law.clone(),
    }
}
