//! Areas of the worm in programs: where finishing and roughing passes run, what is dressed for them, and the check from the texts that
//! every pass keeps to its area (`docs/mathematics/planning.md#choice-of-the-ratio`).

use super::area_sections::{Place, Section, Stretch, extended, sections};
use super::build::Built;
use super::judge::ReadBack;
use super::result::{AreaUse, WormUse};
use super::sought::Sought;
use super::task::ProgramTask;
use super::work::{DressingWork, GrindingWork};
use crate::workflow::execution::Execution;
use crate::workflow::partition::{Partition, ToolAreas, beside_area, passage};
use crate::workflow::prepare::Prepared;
use crate::workflow::roughing_pass::RoughingPass;
use dressing::DresserTool;
use foundation::geometry::{Flank, Sides};
use foundation::kinematics::{GeneratingMotion, MotionLaw, PiecewisePolynomial};
use foundation::numerics::{Chebyshev, equidistant, extremes};
use generating::FlankLines;
use job::Diagnostic;
use machine::Station;
use motion::{MotionError, ReadStroke, Tracked, track};
use run::RunFailure;
use verdict::Remark;

/// Rolls at which a dresser's line is looked at.
const ROLLS: usize = 9;
/// How far a pass may leave its area, mm: digits of a text and the contact that its stock moves.
const SAME_AREA: f64 = 0.05;

/// The areas of a run's programs.
#[derive(Clone, Debug)]
pub struct ProgramAreas {
    areas: ToolAreas,
    lines: Sides<Option<FlankLines>>,
    /// z_1 that the plan uses, both flanks, mm.
    planned: [f64; 2],
    /// Length of the passage between two areas, and of what lies between it and each of them, mm.
    passage: f64,
    beside: f64,
}

impl ProgramAreas {
    /// The areas of a job; `None` where all passes use the one area of the plan.
    ///
    /// # Errors
    /// Those of the partition.
    pub fn of_execution(prepared: &Prepared, execution: &Execution) -> Result<Option<Self>, RunFailure> {
        let shift = &execution.motion.shift;
        let partition = Partition::of_cycle(prepared, execution.ratio, shift)?;
        let Some(areas) = partition.and_then(|p| p.tool_areas(prepared, shift)) else { return Ok(None) };
        let setup = &prepared.setup;
        let lines = Sides::from_fn(|flank| prepared.targets[flank].as_ref().map(|_| setup.lines[flank]));
        if areas.finishing.is_empty() {
            return Ok(None);
        }
        let Some(planned) = hull(lines.iter().filter_map(|(_, l)| l.as_ref()).map(|l| l.occupation(shift)))
        else {
            return Ok(None);
        };
        Ok(Some(Self { areas, lines, planned, passage: passage(setup), beside: beside_area(setup) }))
    }

    /// What the roughing strokes do in each of their areas.
    pub fn roughing_passes(&self) -> Vec<RoughingPass> {
        self.areas.roughing.clone()
    }

    /// z_V1 of the plan in the first finishing area.
    fn first(&self) -> f64 {
        self.areas.finishing.first().copied().unwrap_or(0.0)
    }

    /// z_V1 of every finishing area less that of the first, mm.
    pub fn apart(&self) -> Vec<f64> {
        self.areas.finishing.iter().map(|at| at - self.first()).collect()
    }

    /// A grinding stroke of the plan in the first finishing area.
    pub fn placed_grinding(&self, work: &mut GrindingWork) {
        work.motion.shift = work.motion.shift.raised(self.first());
    }

    /// Worm positions v_zS that have to be dressed for a range of z_1, where `driven` belongs to the plan's own: v_zS falls as z_1
    /// grows.
    fn dressed_for(&self, driven: [f64; 2], z_1: [f64; 2]) -> [f64; 2] {
        [driven[0] + self.planned[1] - z_1[1], driven[1] + self.planned[0] - z_1[0]]
    }

    /// Worm positions v_zS at which a dresser touches the lines that the plan grinds with on these flanks.
    fn core(&self, tool: &DresserTool, flanks: &[Flank], shift: &MotionLaw) -> Option<[f64; 2]> {
        hull(flanks.iter().filter_map(|&flank| {
            let lines = self.lines[flank].as_ref()?;
            let used = lines.line_range(shift);
            // It touches the roll w at z_1 = b(w) - v_zS, which lies on the line z_1 + t_1 w.
            let of = |w: f64| tool.flanks[flank].line.value(w) + lines.t_1 * w;
            let rolls = equidistant(lines.worm_rolls(shift), ROLLS);
            let [least, most] = extremes(rolls.into_iter().map(of));
            Some([least - used[1], most - used[0]])
        }))
    }

    /// The worm positions of a roughing area against those of the plan: each dressed like the place of the plan that grinds the same place of
    /// the gear, as far as the area has a modification of its own.
    fn stretch(
        &self,
        pass: &RoughingPass,
        (tool, flanks): (&DresserTool, &[Flank]),
        shift: &MotionLaw,
        ratio: f64,
    ) -> Option<Stretch> {
        let middles = flanks.iter().filter_map(|&flank| {
            let lines = self.lines[flank].as_ref()?;
            let [own, planned] = [&pass.shift, shift].map(|law| {
                let [from, to] = lines.line_range(law);
                0.5 * (from + to)
            });
            let rolls = equidistant(lines.worm_rolls(shift), ROLLS);
            let of = |w: f64| tool.flanks[flank].line.value(w) + lines.t_1 * w;
            let [least, most] = extremes(rolls.into_iter().map(of));
            let touched = 0.5 * (least + most);
            Some([touched - own, touched - planned])
        });
        let middles: Vec<[f64; 2]> = middles.collect();
        let mean = |k: usize| middles.iter().map(|of| of[k]).sum::<f64>() / middles.len() as f64;
        let slope = if pass.area.ratio == 0.0 { 0.0 } else { ratio / pass.area.ratio };
        (!middles.is_empty()).then(|| Stretch {
            own: mean(0),
            planned: mean(1),
            slope,
            share: pass.area.share.unwrap_or(0.0),
        })
    }

    /// Corrections of a flank's dressing in a roughing area, over all that its strokes use and the margin that the plan drives; `None` for a
    /// flank that is not ground.
    pub fn roughed(
        &self,
        pass: &RoughingPass,
        of: (&DresserTool, &[Flank]),
        (shift, ratio): (&MotionLaw, f64),
        planned: &[Chebyshev; 4],
    ) -> Option<[Chebyshev; 4]> {
        let (first, last) = planned[0].interval();
        let core = self.core(of.0, of.1, shift)?;
        let own = self.core(of.0, of.1, &pass.shift)?;
        let range = [own[0] - (core[0] - first), own[1] + (last - core[1])];
        Some(self.stretch(pass, of, shift, ratio)?.corrections(planned, range))
    }

    /// The stretches of v_zS that roughing areas with a modification of their own take, where the job has some.
    fn roughing_sections(&self, of: (&DresserTool, &[Flank]), shift: &MotionLaw, ratio: f64) -> Vec<Section> {
        if self.areas.roughing.iter().all(|pass| pass.area.share.is_none()) {
            return Vec::new();
        }
        let section = |pass: &RoughingPass| {
            let [from, to] = self.core(of.0, of.1, &pass.shift)?;
            let range = [from - self.beside, to + self.beside];
            Some(Section {
                needed: range,
                range,
                place: Place::Roughing(self.stretch(pass, of, shift, ratio)?),
            })
        };
        self.areas.roughing.iter().filter_map(section).collect()
    }

    /// A dressing stroke of the plan in every finishing area, driven on over the roughing areas. These have a share of the modification, or are
    /// dressed with the dresser where it stands in the middle of the finishing area; from one area to the next it goes without a jump.
    ///
    /// # Errors
    /// Areas so near to each other that the dresser has no way from one to the next.
    pub fn placed_dressing(
        &self,
        work: &mut DressingWork,
        (tool, flanks): (&DresserTool, &[Flank]),
        (shift, ratio): (&MotionLaw, f64),
    ) -> Result<(), RunFailure> {
        let driven = work.interval;
        let refused = |code: &'static str, text: String, way_out: String| {
            let finding = Diagnostic::with_code(code, text);
            RunFailure::not_producible(finding.field("grinding.areas").way_out(way_out))
        };
        let core = self.core(tool, flanks, shift).unwrap_or(driven);
        let core = [core[0] - self.beside, core[1] + self.beside];
        let finishing = self.areas.finishing.iter().map(|&by| Section {
            needed: core.map(|v| v + by),
            range: driven.map(|v| v + by),
            place: Place::Finishing(by),
        });
        let all = finishing.chain(self.roughing_sections((tool, flanks), shift, ratio)).collect();
        let sections = sections(all, self.passage).ok_or_else(|| {
            refused(
                "areas-too-near",
                "neighbouring areas leave the dresser no way from one to the next".into(),
                "take a wider worm or fewer areas".into(),
            )
        })?;
        let ranges =
            self.areas.roughing.iter().filter_map(|pass| self.touched(&pass.shift)).collect::<Vec<_>>();
        let own = hull(sections.iter().map(|section| section.range)).unwrap_or(driven);
        let whole = ranges.iter().map(|&z_1| self.dressed_for(driven, z_1)).chain([own]);
        let whole = hull(whole).unwrap_or(own);
        let middle = 0.5 * (driven[0] + driven[1]);
        for law in &mut work.motion.correction {
            let constant = law.value(middle);
            let extended = extended(law, driven, &sections, whole, (constant, self.passage));
            *law = extended
                .map_err(|error| refused(error.code(), error.to_string(), error.way_out().into_owned()))?;
        }
        work.interval = whole;
        Ok(())
    }

    /// z_1 that a law touches, both flanks.
    fn touched(&self, law: &MotionLaw) -> Option<[f64; 2]> {
        hull(self.lines.iter().filter_map(|(_, lines)| lines.as_ref()).map(|lines| lines.occupation(law)))
    }

    /// What was read from a text as if its finishing area, `apart` of the first, lay where the plan has it: a worm is a screw, so that
    /// its area, its dressing and its grinding may be moved along it together.
    pub fn as_planned(&self, read: &ReadBack, apart: f64) -> ReadBack {
        let by = self.first() + apart;
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
                    let (found, faults) =
                        self.ground(&sought, &tracked, Some(program.area)).map_err(refused)?;
                    uses.extend(
                        found.into_iter().map(|found| WormUse { file: program.file.clone(), ..found }),
                    );
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
            let roughing = self.areas.roughing.iter().filter_map(|pass| self.touched(&pass.shift));
            let wanted = roughing.map(|z_1| self.dressed_for(driven, z_1));
            // Between two finishing areas nothing is ground; at the ends of all the plan's own margin belongs to it.
            let finishing = hull(self.areas.finishing.iter().map(|by| driven.map(|v| v + by)));
            let wanted: Vec<[f64; 2]> = wanted.chain(finishing).collect();
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

    /// What the passes of a grinding program touch, and which of them leave their areas. `area`: the finishing area, from 0, that it
    /// is for; `None`: that of its first finishing pass.
    ///
    /// # Errors
    /// [`MotionError::NotFollowed`].
    pub fn ground(
        &self,
        sought: &Sought<'_>,
        tracked: &Tracked,
        area: Option<usize>,
    ) -> Result<(Vec<WormUse>, Vec<Remark>), MotionError> {
        let (mut uses, mut faults) = (Vec::new(), Vec::new());
        let least = sought.technology.least_roughing();
        for work in &sought.grinding {
            let mounts = &sought.technology.grinding;
            let strokes = tracked.grinding(sought.machine, mounts, &work.motion, work.phase)?;
            for stroke in &strokes {
                self.touches(stroke, work, least, &mut uses, &mut faults);
            }
        }
        let finishing = |used: &&WormUse| used.kind == AreaUse::Finishing;
        let own = area.or(uses.iter().find(finishing).map(|used| used.number));
        for used in uses.iter().filter(finishing).filter(|used| Some(used.number) != own) {
            let text = format!(
                "the pass of blocks {} to {} grinds on finishing area {} of the worm, the program on area {}",
                used.blocks[0],
                used.blocks[1],
                used.number + 1,
                own.map_or(1, |own| own + 1)
            );
            faults.push(off_area("pass-on-wrong-area", text));
        }
        Ok((uses, faults))
    }

    /// The areas that one stroke touches.
    fn touches(
        &self,
        stroke: &ReadStroke<GeneratingMotion>,
        work: &GrindingWork,
        least: f64,
        uses: &mut Vec<WormUse>,
        faults: &mut Vec<Remark>,
    ) {
        let middle = 0.5 * (work.feeds[0] + work.feeds[1]);
        let stands_off =
            (stroke.motion.delta_d.value(middle) - work.motion.delta_d.value(middle)) * work.per_distance();
        let roughing = stands_off > 0.5 * least;
        let finishing: Vec<MotionLaw> =
            self.apart().into_iter().map(|by| work.motion.shift.raised(by)).collect();
        // Without areas of their own roughing passes use the finishing area.
        let apart_from = roughing && !self.areas.roughing.is_empty();
        let laws: Vec<MotionLaw> = if apart_from {
            self.areas.roughing.iter().map(|pass| pass.shift.clone()).collect()
        } else {
            finishing.clone()
        };
        let [first, last] = stroke.blocks;
        for (flank, lines) in self.lines.iter() {
            let Some(lines) = lines else { continue };
            let found = lines.line_range(&stroke.motion.shift);
            let touched =
                format!("touches worm lines {:.3} to {:.3} mm of the {flank} flank", found[0], found[1]);
            let overlap = finishing.iter().map(|law| {
                let lines = lines.line_range(law);
                found[1].min(lines[1]) - found[0].max(lines[0])
            });
            let overlap = overlap.fold(f64::NEG_INFINITY, f64::max);
            if apart_from && overlap > SAME_AREA {
                let text = format!(
                    "the roughing pass of blocks {first} to {last} {touched}, {overlap:.3} mm of which belong to the finishing area"
                );
                faults.push(off_area("pass-on-wrong-area", text));
                continue;
            }
            let apart = |law: &MotionLaw| {
                let wanted = lines.line_range(law);
                (wanted[0] - found[0]).abs().max((wanted[1] - found[1]).abs())
            };
            let Some(area) = laws.iter().position(|law| apart(law) <= SAME_AREA) else {
                let text =
                    format!("the pass of blocks {first} to {last} {touched}, which is no area of the layout");
                faults.push(off_area("pass-on-wrong-area", text));
                continue;
            };
            uses.push(WormUse {
                file: String::new(),
                blocks: stroke.blocks,
                flank: flank.name(),
                area: format!("{} {}", if apart_from { "roughing" } else { "finishing" }, area + 1),
                kind: if apart_from { AreaUse::Roughing } else { AreaUse::Finishing },
                number: area,
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

/// A law as read from a text, moved along its argument: x -> law(x - by).
fn moved(law: &MotionLaw, by: f64) -> MotionLaw {
    match law {
        MotionLaw::Polynomial { origin, coefficients } => {
            MotionLaw::polynomial(origin + by, coefficients.clone())
        }
        MotionLaw::Series(series) => {
            let (from, to) = series[0].interval();
            MotionLaw::series(Chebyshev::from_coefficients(
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
