//! Positions of the axes along all passes and the links between them, with the time of every block
//! (`docs/mathematics/milling.md#positions-of-five-axes`).

use super::at_pole::AtPole;
use super::end_position::end_steps;
use super::failure::{in_pass, of_milling, of_motion};
use super::figures::Figures;
use super::links::DIP;
use super::operation_figures::{OperationFigures, StraightKept};
use super::passes::{BEFORE, BEHIND, CutterPass, ToolPasses, name_of};
use super::pole::bulge;
use super::safe_room::SafeRoom;
use super::steps::{DrivenMotion, Step, StepKind, ToolRun};
use super::task::MillingWork;
use crate::CutterPlace;
use crate::job::EndMove;
use foundation::geometry::CutterShape;
use job::Diagnostic;
use machine::Positions;
use motion::MotionError;
use motion::milling::{
    AxisCourse, BlockLimit, BlockTime, CutterPlace as Place, MillingSetup, block_time, choose, pole_passages,
    refine, section_feeds, straight_error, straight_runs,
};
use run::RunFailure;

/// Speeds of axes that the machine's description does not limit: mm/s, rad/s.
const RAPID_UNKNOWN: [f64; 2] = [150.0, std::f64::consts::FRAC_PI_2];
/// Ways shorter than this (mm) are none.
pub(super) const NOWHERE: f64 = 1e-9;

/// Who leads the tip.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Lead {
    /// The control, else positions of the axes.
    pub by_control: bool,
    /// Rows that are one screw block are positions of the axes.
    pub screw_rows: bool,
}

/// The machine with its tolerances: mm, rad.
#[derive(Clone, Copy)]
pub(super) struct Driver<'a> {
    pub setup: &'a MillingSetup<'a>,
    pub work: &'a MillingWork<'a>,
    pub lead: Lead,
    pub tip_tolerance: f64,
    pub at_pole: AtPole,
    /// Where the axes go at the end.
    pub end: &'a [EndMove],
}

/// A place, the axes there, and whether the block to it is guided.
pub(super) type Node = (Place, Positions);

impl Driver<'_> {
    /// Drives all passes.
    ///
    /// # Errors
    /// [`RunFailure`]: places that the machine does not reach, links that cannot stay outside.
    pub fn drive(&self, tools: &[ToolPasses]) -> Result<DrivenMotion, RunFailure> {
        let mut figures = Figures::new(self.setup, self.work);
        let mut at = None;
        let mut runs = Vec::new();
        for tool in tools {
            let setup = self.setup.with_tool_length(tool.tool.length);
            let steps = Driver { setup: &setup, ..*self }.tool(tool, &mut at, &mut figures)?;
            runs.push(ToolRun { tool: tool.tool, steps });
        }
        if let Some(run) = runs.last_mut() {
            let setup = self.setup.with_tool_length(run.tool.length);
            run.steps.extend(end_steps(&setup, self.end, run.steps.last())?);
        }
        let (operations, straight) = figures.finish(&runs);
        let cycle_time = operations.iter().map(OperationFigures::seconds).sum();
        Ok(DrivenMotion { tools: runs, operations, cycle_time, straight })
    }

    /// The blocks of one tool, from where the axes stand; of the first tool that is not known.
    fn tool(
        &self,
        tool: &ToolPasses,
        at: &mut Option<Positions>,
        figures: &mut Figures<'_>,
    ) -> Result<Vec<Step>, RunFailure> {
        let mut steps: Vec<Step> = Vec::new();
        for pass in &tool.passes {
            for (piece, course) in self.without_rewinds(pass, &tool.room, &at.unwrap_or_default())? {
                let made = self.pass(&piece, &course, figures)?;
                let begin = (course.places[0], course.nodes[0]);
                match steps.last() {
                    None => {
                        let seconds = at.map_or(0.0, |at| rapid_seconds(self.setup, &at, &begin.1));
                        steps.push(step(&piece, StepKind::Position, begin, seconds, false));
                    }
                    Some(last) => {
                        let guided = last.guided && made.first().is_none_or(|step| step.guided);
                        let from = (last.place, last.at);
                        steps.extend(self.link(&piece, &tool.room, [&from, &begin], guided)?);
                    }
                }
                steps.extend(made);
                *at = steps.last().map(|last| last.at);
            }
        }
        Ok(steps)
    }

    pub(super) fn what(&self, pass: &CutterPass) -> String {
        let name = self.work.tools.get(pass.operation).map_or_else(String::new, |tool| name_of(tool.kind));
        in_pass(&name, pass.space, pass.path)
    }

    fn failed(&self, pass: &CutterPass) -> impl Fn(MotionError) -> RunFailure {
        let what = self.what(pass);
        move |error| of_motion(&error, &what)
    }

    fn chosen(&self, pass: &CutterPass, from: &Positions) -> Result<AxisCourse, RunFailure> {
        let cutter = self.work.tools.get(pass.operation).map(|tool| &tool.cutter);
        choose(self.setup, &pass.places, from, self.at_pole.strategy(cutter)).map_err(self.failed(pass))
    }

    /// A pass in as many pieces as its axes have to be turned back, between which the cutter is outside; commonly one.
    fn without_rewinds(
        &self,
        pass: &CutterPass,
        room: &SafeRoom,
        from: &Positions,
    ) -> Result<Vec<(CutterPass, AxisCourse)>, RunFailure> {
        let mut pieces = Vec::new();
        let (mut rest, mut from) = (pass.clone(), *from);
        loop {
            let course = self.chosen(&rest, &from)?;
            let Some(&place) = course.rewinds.first() else {
                pieces.push((rest, course));
                return Ok(pieces);
            };
            if !(BEFORE + 1 + usize::from(!pieces.is_empty())..rest.places.len() - BEHIND).contains(&place) {
                let text = format!(
                    "{}: after place {} an axis comes to the end of its travel and cannot go on in another turn",
                    self.what(pass),
                    place
                );
                let finding = Diagnostic::with_code("axis-limit", text).field("machine.mount");
                let way_out =
                    "turn the workpiece on the table, mount it otherwise, or take a machine with more travel";
                return Err(RunFailure::not_producible(finding.way_out(way_out)));
            }
            // The cutter goes out where the turn ends, and comes back to the same place.
            let stop = rest.places[place - 1];
            let out = CutterPlace { tip: stop.tip.xyz, axis: stop.axis.xyz, contact: None };
            let [edge, outside] = room
                .drawn_back(&out, DIP)
                .map_err(|error| of_milling(&error, &self.what(pass)))?
                .map(|at| outside_place(&at));
            let tail = rest.places.split_off(place);
            rest.places.push(outside);
            let places = [outside, edge, stop].into_iter().chain(tail).collect();
            let next = CutterPass { places, ..rest.clone() };
            let course = self.chosen(&rest, &from)?;
            if !course.rewinds.is_empty() {
                return Err(of_motion(
                    &MotionError::NotFollowed { block: place, reason: "its axes turn back twice".into() },
                    &self.what(pass),
                ));
            }
            from = course.nodes.last().copied().unwrap_or(from);
            pieces.push((rest, course));
            rest = next;
        }
    }

    /// The blocks of a pass behind its first place.
    fn pass(
        &self,
        pass: &CutterPass,
        course: &AxisCourse,
        figures: &mut Figures<'_>,
    ) -> Result<Vec<Step>, RunFailure> {
        let failed = self.failed(pass);
        let screw = if self.lead.screw_rows { self.screw(pass, course).map_err(&failed)? } else { None };
        let guided = self.lead.by_control && screw.is_none();
        let feeds = self.feeds(pass, course, figures).map_err(&failed)?;
        let cut = pass.cut();
        let mut steps = Vec::new();
        let refined = if guided || screw.is_some() {
            None
        } else {
            let axis = self.axis_tolerance(pass.operation);
            let refined = refine(self.setup, course, self.tip_tolerance, axis).map_err(&failed)?;
            figures.keep(StraightKept { tip: refined.tip, axis: refined.axis });
            Some(refined)
        };
        if let Some(kept) = screw {
            figures.keep(kept);
        }
        if let AtPole::Hold { .. } = self.at_pole {
            figures.keep(StraightKept { tip: bulge(course, self.radius(pass.operation)), axis: 0.0 });
            figures.held(pass, course);
        }
        for k in 1..course.places.len() {
            let kind = match k {
                1 => StepKind::Approach,
                BEFORE => StepKind::Plunge,
                _ if k < cut.end => StepKind::Cut,
                _ => StepKind::Retract,
            };
            let ends: Vec<Node> = match &refined {
                Some(fine) => (fine.given[k - 1]..=fine.given[k])
                    .map(|place| (fine.places[place], fine.nodes[place]))
                    .collect(),
                None => [k - 1, k].map(|place| (course.places[place], course.nodes[place])).into(),
            };
            for pair in ends.windows(2) {
                let time = self.time(pass, kind, [&pair[0], &pair[1]], feeds[k]).map_err(&failed)?;
                let Some(time) = time else { continue };
                let mut made = step(pass, kind, pair[1], time.seconds, guided);
                made.limit = (kind == StepKind::Cut).then_some(time.limit);
                steps.push(made);
            }
        }
        Ok(if screw.is_some() { self.one_block(steps) } else { steps })
    }

    /// All cuts of a pass as one block: the time is that of all of them, or what the axes need.
    fn one_block(&self, steps: Vec<Step>) -> Vec<Step> {
        let mut joined: Vec<Step> = Vec::new();
        for step in steps {
            match joined.last_mut() {
                Some(last) if last.kind == StepKind::Cut && step.kind == StepKind::Cut => {
                    let seconds = last.seconds + step.seconds;
                    *last = Step { seconds, ..step };
                }
                _ => joined.push(step),
            }
        }
        joined
    }

    /// What one block over the whole path leaves, if the axes go through it as a screw.
    fn screw(&self, pass: &CutterPass, course: &AxisCourse) -> Result<Option<StraightKept>, MotionError> {
        let cut = pass.cut();
        let places = course.places[cut.clone()].to_vec();
        let count = places.len();
        let row = AxisCourse {
            nodes: course.nodes[cut].to_vec(),
            axis_errors: vec![0.0; count],
            places,
            inherited: Vec::new(),
            rewinds: Vec::new(),
            cost: 0.0,
        };
        let axis = self.axis_tolerance(pass.operation);
        let runs = straight_runs(self.setup, &row, self.tip_tolerance, axis)?;
        let [run] = runs[..] else { return Ok(None) };
        let mut kept = StraightKept { tip: run.tip, axis: run.axis };
        for k in 1..count {
            let ends = [k - 1, k].map(|place| (&row.places[place], &row.nodes[place]));
            let off =
                straight_error(self.setup, ends).map_err(|error| MotionError::Place { place: k, error })?;
            kept = kept.larger(StraightKept { tip: off.tip + run.tip, axis: off.axis + run.axis });
        }
        Ok(Some(kept))
    }

    fn radius(&self, operation: usize) -> f64 {
        match self.work.tools.get(operation).map(|tool| tool.cutter.shape()) {
            Some(CutterShape::Conical { radius, .. }) => *radius,
            _ => 0.0,
        }
    }

    /// Axis error that moves the cutter's upper end by the tolerance of the tip, rad.
    fn axis_tolerance(&self, operation: usize) -> f64 {
        let length = self.work.tools.get(operation).map_or(1.0, |tool| tool.cutter.cutting_length());
        self.tip_tolerance / length.max(1.0)
    }

    /// Feeds (mm/min) of the blocks that end at each place: near the pole what the axes allow for the whole part.
    fn feeds(
        &self,
        pass: &CutterPass,
        course: &AxisCourse,
        figures: &mut Figures<'_>,
    ) -> Result<Vec<f64>, MotionError> {
        let Some(tool) = self.work.tools.get(pass.operation).map(|work| work.tool) else {
            return Ok(Vec::new());
        };
        let cut = pass.cut();
        let mut feeds = vec![tool.feed; course.places.len()];
        feeds[..=BEFORE].fill(tool.plunge_feed);
        let (places, nodes) = (&course.places[cut.clone()], &course.nodes[cut.clone()]);
        figures.row(pass, places, nodes);
        let passages = pole_passages(self.setup, places, self.at_pole.cap())?;
        if passages.is_empty() {
            return Ok(feeds);
        }
        let mut times = Vec::with_capacity(places.len());
        for k in 1..places.len() {
            let ends = [k - 1, k].map(|place| (places[place], nodes[place]));
            let time = self.time(pass, StepKind::Cut, [&ends[0], &ends[1]], tool.feed)?;
            // Where nothing moves nothing slows down.
            times.push(time.unwrap_or(BlockTime {
                seconds: 0.0,
                limit: BlockLimit::Feed,
                tip_feed: 0.0,
                inverse_time: 0.0,
                share: 1.0,
            }));
        }
        for section in section_feeds(&times, &passages, tool.feed) {
            let touched = section.passage.from.max(1)..=(section.passage.to + 1).min(places.len() - 1);
            for place in touched {
                let feed = &mut feeds[cut.start + place];
                *feed = feed.min(section.feed);
            }
            figures.passage(pass, &section);
        }
        Ok(feeds)
    }

    /// The time of a block; `None` where nothing moves.
    fn time(
        &self,
        pass: &CutterPass,
        kind: StepKind,
        [from, to]: [&Node; 2],
        feed: f64,
    ) -> Result<Option<BlockTime>, MotionError> {
        let tip = (to.0.tip.xyz - from.0.tip.xyz).norm();
        let turned = self.setup.axes().rotary.iter().any(|&axis| (to.1[axis] - from.1[axis]).abs() > NOWHERE);
        if tip <= NOWHERE && !turned {
            return Ok(None);
        }
        if matches!(kind, StepKind::Approach | StepKind::Retract) {
            let seconds = rapid_seconds(self.setup, &from.1, &to.1);
            let limit = BlockLimit::Feed;
            let tip_feed = 60.0 * tip / seconds;
            return Ok(Some(BlockTime {
                seconds,
                limit,
                tip_feed,
                inverse_time: 60.0 / seconds,
                share: 1.0,
            }));
        }
        let contact = (to.0.contact.xyz - from.0.contact.xyz).norm();
        // A cutter that turns about its contact is led by its tip, or it would turn as fast as the axes can.
        let on_path = kind == StepKind::Cut && contact > NOWHERE;
        let mut way = if on_path { contact } else { tip };
        if way <= NOWHERE {
            let length = self.work.tools.get(pass.operation).map_or(1.0, |tool| tool.cutter.cutting_length());
            way = length * from.0.axis.xyz.cross(&to.0.axis.xyz).norm();
        }
        block_time(self.setup, [(&from.0, &from.1), (&to.0, &to.1)], way, feed)
    }
}

pub(super) fn step(pass: &CutterPass, kind: StepKind, (place, at): Node, seconds: f64, guided: bool) -> Step {
    let CutterPass { operation, space, path, .. } = *pass;
    Step { kind, operation, space, path, place, at, seconds, limit: None, guided }
}

/// Time that the axes need at their greatest speeds, s.
pub(super) fn rapid_seconds(setup: &MillingSetup<'_>, from: &Positions, to: &Positions) -> f64 {
    let axes = setup.axes();
    let needed = |axis: usize, unknown: f64| {
        let most = setup.machine().axes()[axis].limits.velocity.unwrap_or(unknown);
        (to[axis] - from[axis]).abs() / most
    };
    let linear = axes.linear.iter().map(|&axis| needed(axis, RAPID_UNKNOWN[0]));
    let rotary = axes.rotary.iter().map(|&axis| needed(axis, RAPID_UNKNOWN[1]));
    linear.chain(rotary).fold(0.0, f64::max)
}

/// A place outside as the motion takes it.
fn outside_place(at: &CutterPlace) -> Place {
    use foundation::kinematics::{Direction, Point};
    let tip = Point::from_vector(at.tip);
    Place { contact: tip, tip, axis: Direction::from_vector(at.axis) }
}
