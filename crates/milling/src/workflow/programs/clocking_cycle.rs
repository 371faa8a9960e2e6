//! The program that finds the clocking angle of a workpiece whose teeth are cut already: a ball stands in a space, the table turns until
//! either flank touches it, and the mean of both positions less what it would be otherwise goes into the work offset
//! (`docs/mathematics/programs.md#clocking`). Written, read back, followed, and proven by the referee's rays of flanks that are turned.

use super::failure::{not_proven, of_milling, of_motion, of_removal, of_writer};
use super::held::{Held, length_number};
use super::held_clocking::{HeldClocking, turned};
use super::links::DIP;
use super::probe_tool::ProbeTool;
use super::safe_room::SafeRoom;
use super::task::{MillingMachining, MillingWork, clamping};
use crate::workflow::prepare::{MillingBodies, WorkpieceKind};
use crate::{CutterPlace, Space};
use foundation::geometry::Cutter;
use foundation::kinematics::{Direction, Point};
use foundation::numerics::{Silent, brent, equidistant, extremes};
use job::Diagnostic;
use machine::Positions;
use motion::milling::{CutterPlace as Place, MillingSetup, PoleStrategy, choose};
use motion::{AxisWords, MotionError};
use nc::{Block, Dialect, Header, OffsetShift, ProbeMove, Program, Targets, write_checked};
use referee::{MillPath, Milling, NormalRay, mill};
use run::program_check::{control_of, dialect_of, ending_of};
use run::{RunFailure, geometry_finding};
use std::f64::consts::TAU;

/// A program with what it finds.
#[derive(Clone, Debug)]
pub struct ClockingCycle {
    /// The control.
    pub dialect: Dialect,
    /// Path below the directory of the run.
    pub file: String,
    /// The text.
    pub text: String,
    /// Name of the axis that turns.
    pub axis: String,
    /// Where it touches both flanks of a workpiece without an error, as the control counts, rad.
    pub touches: [f64; 2],
    /// Their mean.
    pub middle: f64,
    /// Clocking errors that were tried on the text, either way, rad.
    pub tried: f64,
    /// How far what the text makes of them is off at most, rad.
    pub off: f64,
}

/// Steps in which a touch is looked for, rad.
const STEP: f64 = 0.004;
/// How exactly a touch is known, rad.
const EXACT: f64 = 1e-10;
/// How far what a text finds may be off: two angles of five decimals, and what rays between others hide, rad.
const ALLOWED: f64 = 3.5e-6;
/// Rays on a flank in either direction, and how often they are laid closer about the nearest one.
const RAYS: usize = 13;
const CLOSER: usize = 4;
/// How far outside the flank rays begin, and how deep they go, mm.
const REACH: f64 = 5.0;
const DEPTH: f64 = 1.0;

/// Where the ball stands: outside, at the edge of the body, in the space, with the positions of the axes.
struct Standing {
    nodes: Vec<Positions>,
    axis: usize,
}

impl MillingMachining<'_> {
    /// The programs of all dialects.
    ///
    /// # Errors
    /// [`RunFailure`]: a ball that does not fit, places that the machine does not reach, a text that finds another angle.
    pub fn clocking_cycles(
        &self,
        work: &MillingWork<'_>,
        bodies: &MillingBodies,
        probe: &ProbeTool,
    ) -> Result<Vec<ClockingCycle>, RunFailure> {
        let Some(space) = bodies.parts.first().filter(|space| space.flanks.len() == 2) else {
            return Ok(Vec::new());
        };
        let setup = MillingSetup::new(&self.machine.machine, clamping(&self.mount), probe.length)
            .map_err(|error| of_motion(&error, "probe"))?;
        let held = HeldClocking::of(&setup, 0.0)?;
        let ball =
            probe.body().map_err(|error| RunFailure::bad_input(geometry_finding(&error, "machine.probe")))?;
        let standing = stand(&setup, (space, bodies), work, (probe, &ball), held.axis)?;
        let at = standing.nodes[standing.nodes.len() - 1];
        let touch = |sense: f64| touch(&setup, space, &ball, &at, (held.axis, sense));
        let touched = [touch(1.0)?, touch(-1.0)?];
        let make =
            |name| self.clocking_cycle((work, probe, &ball), (&setup, space, &standing), touched, name);
        self.dialects.iter().map(|name| make(*name)).collect()
    }

    fn clocking_cycle(
        &self,
        (work, probe, ball): (&MillingWork<'_>, &ProbeTool, &Cutter),
        (setup, space, standing): (&MillingSetup<'_>, &Space, &Standing),
        touched: [f64; 2],
        name: job::tables::Program,
    ) -> Result<ClockingCycle, RunFailure> {
        let (control, dialect) = (control_of(self.machine, name)?, dialect_of(name));
        let words = self.words(setup, control)?;
        let held = Held::of(self, setup, &words)?;
        let axis = &setup.machine().axes()[standing.axis];
        let sign = axis.nc_sign;
        let touches = touched.map(|place| sign * place);
        let middle = 0.5 * (touches[0] + touches[1]);
        if control.modulo {
            stays_in_a_turn(touches, probe.search, &axis.name)?;
        }
        let blocks = self.probing_blocks((work, probe), setup, standing, touches, (&words, &held, dialect));
        let refused = |error| of_writer(&error, Some(dialect));
        let header = Header {
            name: super::build::program_name(work.name).replace("_M", "_CLOCKING"),
            axes: words.words.clone(),
            chord_tolerance: self.position_tolerance,
        };
        let header = Header { name: header.name.chars().take(24).collect(), ..header };
        let program = Program::new(header, blocks).map_err(refused)?;
        let checked =
            write_checked(&program, dialect, &super::build::write_options(control)).map_err(refused)?;
        let found = Followed { setup, words: &words, held: &held, probe };
        let tried = 0.5 * probe.search;
        let mut off = 0.0f64;
        for error in [tried, -tried] {
            let shift = found.shift(&checked.read.blocks, space, ball, error)?;
            let wanted = HeldClocking::of(setup, error)?.value;
            off = off.max((shift - wanted).abs());
        }
        // Written so that NaN fails.
        let right = off <= ALLOWED;
        if !right {
            return Err(not_proven(format!(
                "clocking program for {}: of a workpiece turned by {:.4} deg it finds an angle {:.2e} deg beside",
                dialect.name(),
                tried.to_degrees(),
                off.to_degrees()
            )));
        }
        Ok(ClockingCycle {
            dialect,
            file: format!("programs/clocking-{}.{}", dialect.name(), ending_of(dialect)),
            text: checked.written.text,
            axis: axis.name.clone(),
            touches,
            middle,
            tried,
            off,
        })
    }

    /// The blocks: into the space, both flanks, out, and the work offset.
    fn probing_blocks(
        &self,
        (work, probe): (&MillingWork<'_>, &ProbeTool),
        setup: &MillingSetup<'_>,
        standing: &Standing,
        touches: [f64; 2],
        (words, held, dialect): (&AxisWords, &Held, Dialect),
    ) -> Vec<Block> {
        let machine = setup.machine();
        let number = self.work_offset.map_or(1, |offset| offset.number);
        let length = if held.lengthened.is_some() { probe.length } else { 0.0 };
        let targets = |at: &Positions, which: &dyn Fn(usize) -> bool| {
            held.written(words, &words.targets(machine, at, which), length)
        };
        let text = |line: &str| Block::Comment(line.into());
        let mut blocks: Vec<Block> =
            super::build::comments(work.name, Some(self)).iter().map(|line| text(line)).collect();
        blocks.push(text("FINDS THE CLOCKING ANGLE OF CUT TEETH"));
        blocks.push(Block::WorkOffset(number));
        blocks.push(Block::Tool { number: probe.number, length_offset: None });
        if held.lengthened.is_some() {
            blocks.push(Block::LengthOffset(Some(length_number(&probe.tool(), dialect))));
        }
        let rotary = setup.axes().rotary;
        let [outside, inside @ ..] = &standing.nodes[..] else { return blocks };
        blocks.push(Block::Rapid(targets(outside, &|axis| rotary.contains(&axis))));
        blocks.push(Block::Rapid(targets(outside, &|_| true)));
        let mut from = *outside;
        let mut go = |to: &Positions, blocks: &mut Vec<Block>| {
            let linear = setup.axes().linear;
            let way = linear.iter().map(|axis| (to[*axis] - from[*axis]).powi(2)).sum::<f64>().sqrt();
            from = *to;
            if way > 0.0 {
                blocks.push(Block::Linear { target: targets(to, &|_| true), duration: way / probe.feed });
            }
        };
        inside.iter().for_each(|to| go(to, &mut blocks));
        let Some(at) = standing.nodes.last() else { return blocks };
        let Some(axis) = words.place(standing.axis) else { return blocks };
        let back = targets(at, &|number| number == standing.axis);
        let sign = machine.axes()[standing.axis].nc_sign;
        for (slot, (touch, sense)) in (1u8..).zip(touches.into_iter().zip([sign, -sign])) {
            let to = touch + sense * probe.search;
            blocks.push(Block::Probe(ProbeMove { axis, to, speed: probe.turn_speed, slot }));
            blocks.push(Block::Rapid(back));
        }
        for to in standing.nodes.iter().rev().skip(1) {
            go(to, &mut blocks);
        }
        if held.lengthened.is_some() {
            blocks.push(Block::LengthOffset(None));
        }
        let middle = 0.5 * (touches[0] + touches[1]);
        blocks.push(Block::ShiftOffset(OffsetShift { number, axis, slots: [1, 2], middle }));
        blocks.push(Block::End);
        blocks
    }
}

/// An axis that counts modulo a turn goes back through all of it where its count starts anew between two places: with the ball between
/// the flanks it may not.
fn stays_in_a_turn(touches: [f64; 2], search: f64, axis: &str) -> Result<(), RunFailure> {
    let [least, most] = extremes(touches);
    let (from, to) = (least - search, most + search);
    if from >= 0.0 && to <= TAU {
        return Ok(());
    }
    let text = format!(
        "{axis} counts modulo 360 deg and would be probed from {:.3} to {:.3} deg, across where its count starts anew",
        from.to_degrees(),
        to.to_degrees()
    );
    let finding = Diagnostic::with_code("modulo-crossed", text).field("machine.mount.clocking_deg");
    let way_out = "turn the workpiece on the table, or describe a control that counts on beyond a turn";
    Err(RunFailure::not_producible(finding.allowed("0 to 360 deg").way_out(way_out)))
}

/// The ball in the middle of the space, and how it comes there along its axis.
fn stand(
    setup: &MillingSetup<'_>,
    (space, bodies): (&Space, &MillingBodies),
    work: &MillingWork<'_>,
    (probe, ball): (&ProbeTool, &Cutter),
    axis: usize,
) -> Result<Standing, RunFailure> {
    let active = &space.flanks[0].active;
    let [[low, high], [from, to]] = [active.height_span(), active.face];
    let lead = space.lead.at(0.5 * (from + to)).map_err(|error| of_milling(&error, "probe"))?;
    let middle = active.surface.point(0.5 * (low + high), 0.5 * (from + to));
    // The guide curve of a cylindrical gear may lie on another cylinder than that of the root.
    let radial = lead.point.xy().norm();
    let root = if bodies.kind == WorkpieceKind::Cylindrical { bodies.floor.radii[0] } else { radial };
    let below = (radial - root) * lead.base_normal.xy().dot(&lead.point.xy().normalize());
    let height = probe.height.unwrap_or(lead.in_plane(&middle)[1] + below);
    let tip = lead.point + lead.base_normal * (height - below - probe.radii[0]);
    let inside = CutterPlace { tip, axis: lead.base_normal, contact: None };
    let room = SafeRoom::new(work.retraction, ball);
    let [edge, outside] = room.drawn_back(&inside, DIP).map_err(|error| of_milling(&error, "probe"))?;
    let place = |at: &CutterPlace| {
        let tip = Point::from_vector(at.tip);
        Place { contact: tip, tip, axis: Direction::from_vector(at.axis) }
    };
    let mut places = vec![place(&outside)];
    if (edge.tip - outside.tip).norm() > 1e-9 {
        places.push(place(&edge));
    }
    places.push(place(&inside));
    let course = choose(setup, &places, &Positions::default(), PoleStrategy::Slow)
        .map_err(|error| of_motion(&error, "probe"))?;
    let nodes = course.nodes;
    let free = clearance(setup, space, ball, &nodes[nodes.len() - 1]).unwrap_or(f64::NAN);
    // Written so that NaN fails.
    let fits = free > 0.0;
    if !fits {
        let diameter = 2.0 * probe.radii[0];
        let text = format!(
            "a ball of {diameter} mm does not fit between the flanks at {height:.3} mm above the root body"
        );
        let finding =
            Diagnostic::with_code("probe-too-large", text).field("machine.probe.diameter").value(diameter);
        let finding = finding.allowed(format!("< {:.3} mm", diameter + 2.0 * free));
        return Err(RunFailure::not_producible(
            finding.way_out("take a smaller ball, or another machine.probe.height"),
        ));
    }
    Ok(Standing { nodes, axis })
}

/// Distance of the probe from the flanks of its space with the axes there, mm.
fn clearance(setup: &MillingSetup<'_>, space: &Space, ball: &Cutter, at: &Positions) -> Option<f64> {
    let (tip, axis) = setup.stands(at).ok()?;
    let of =
        |flank: &crate::SpaceFlank| flank.patch(0.0).clearance(ball, &tip.xyz, &axis.xyz.normalize()).value;
    space.flanks.iter().map(of).reduce(f64::min)
}

/// Where the axis stands when a flank touches the ball, turned in a sense.
fn touch(
    setup: &MillingSetup<'_>,
    space: &Space,
    ball: &Cutter,
    at: &Positions,
    (axis, sense): (usize, f64),
) -> Result<f64, RunFailure> {
    let free = |angle: f64| {
        let mut turned = *at;
        turned[axis] += sense * angle;
        clearance(setup, space, ball, &turned)
    };
    let mut before = (0.0, free(0.0).unwrap_or(f64::NAN));
    while before.0 < space.pitch {
        let angle = before.0 + STEP;
        let now = free(angle).unwrap_or(f64::NAN);
        if now <= 0.0 {
            let found = brent([before.0, angle], [before.1, now], EXACT, free);
            return found.map(|angle| at[axis] + sense * angle).ok_or_else(nothing_touched);
        }
        before = (angle, now);
    }
    Err(nothing_touched())
}

fn nothing_touched() -> RunFailure {
    let text = "the ball of the probe touches no flank while the workpiece turns by a pitch";
    let finding = Diagnostic::with_code("probe-touches-nothing", text).field("machine.probe.height");
    RunFailure::not_producible(finding.way_out("set machine.probe.height to where the flanks are"))
}

/// A text that is followed on a workpiece.
struct Followed<'a> {
    setup: &'a MillingSetup<'a>,
    words: &'a AxisWords,
    held: &'a Held,
    probe: &'a ProbeTool,
}

impl Followed<'_> {
    /// What the text adds to the work offset of a workpiece that is turned by an angle, rad.
    fn shift(&self, blocks: &[Block], space: &Space, ball: &Cutter, error: f64) -> Result<f64, RunFailure> {
        let refused = |block: usize, reason: &str| {
            let error = MotionError::NotFollowed { block: block + 1, reason: reason.into() };
            not_proven(format!("clocking program: {error}"))
        };
        let clocked = turned(self.setup, error);
        let machine = self.setup.machine();
        let mut at = Positions::default();
        let mut length = 0.0;
        let mut kept = [f64::NAN; 10];
        let mut shift = None;
        for (k, block) in blocks.iter().enumerate() {
            match block {
                Block::LengthOffset(number) => length = number.map_or(0.0, |_| self.probe.length),
                Block::Rapid(target) | Block::Linear { target, .. } => {
                    let target: Targets = self.held.meant(self.words, target, length);
                    at = self.words.positions(machine, &at, &target);
                }
                Block::Probe(motion) => {
                    let number =
                        *self.words.numbers.get(motion.axis).ok_or_else(|| refused(k, "an unknown axis"))?;
                    let sign = machine.axes()[number].nc_sign;
                    let end = sign * motion.to;
                    let place = rays_touch(&clocked, space, ball, &at, (number, end));
                    let place = place.ok_or_else(|| refused(k, "the probe touches nothing on its way"))?;
                    kept[usize::from(motion.slot)] = sign * place;
                    at[number] = place;
                }
                Block::ShiftOffset(by) => {
                    let [a, b] = by.slots.map(|slot| kept[usize::from(slot)]);
                    shift = Some(0.5 * (a + b) - by.middle);
                }
                Block::Spindle { speed, .. } if *speed == 0.0 => {}
                Block::Comment(_) | Block::WorkOffset(_) | Block::Tool { .. } | Block::End => {}
                _ => return Err(refused(k, "no block of a clocking program")),
            }
        }
        shift.ok_or_else(|| refused(blocks.len(), "it sets no work offset"))
    }
}

/// Where an axis stands on its way to `end` when a ray of a flank is as long as nothing: the referee's touch.
fn rays_touch(
    setup: &MillingSetup<'_>,
    space: &Space,
    ball: &Cutter,
    at: &Positions,
    (axis, end): (usize, f64),
) -> Option<f64> {
    let begin = at[axis];
    let of_flank = |flank: &crate::SpaceFlank| -> Option<f64> {
        let active = &flank.active;
        let [[low, high], [from, to]] = [active.height_span(), active.face];
        let mut window = [[low.min(high), low.max(high)], [from, to]];
        let whole = window;
        let mut found = None;
        for _ in 0..CLOSER {
            let [heights, lengths] = window.map(|ends| equidistant(ends, RAYS));
            let places: Vec<[f64; 2]> =
                heights.iter().flat_map(|a| lengths.iter().map(move |b| [*a, *b])).collect();
            let rays: Vec<NormalRay> = places
                .iter()
                .map(|[a, b]| active.surface.jet(*a, *b))
                .map(|jet| NormalRay { point: jet.point, normal: jet.normal })
                .collect();
            let nearest = |share: f64| {
                let mut turned = *at;
                turned[axis] = begin + (end - begin) * share;
                nearest_ray(setup, ball, &rays, &turned)
            };
            let free = |share: f64| nearest(share).map(|(_, length)| length);
            let [first, last] = [free(0.0)?, free(1.0)?];
            if first <= 0.0 || last > 0.0 {
                return None;
            }
            let share = brent([0.0, 1.0], [first, last], EXACT, free)?;
            found = Some(share);
            let (ray, _) = nearest(share)?;
            // Twice as wide as the rays lie apart.
            window = std::array::from_fn(|part| {
                let half = 1.5 * (window[part][1] - window[part][0]) / (RAYS - 1) as f64;
                let [least, most] = whole[part];
                [(places[ray][part] - half).max(least), (places[ray][part] + half).min(most)]
            });
        }
        found
    };
    let shares: Vec<f64> = space.flanks.iter().filter_map(of_flank).collect();
    shares.into_iter().reduce(f64::min).map(|share| begin + (end - begin) * share)
}

/// The shortest ray beside a probe that stands there, mm.
fn nearest_ray(
    setup: &MillingSetup<'_>,
    ball: &Cutter,
    rays: &[NormalRay],
    at: &Positions,
) -> Option<(usize, f64)> {
    let (tip, axis) = setup.stands(at).ok()?;
    let place = referee::CutterPlace { tip: tip.xyz, axis: axis.xyz.normalize() };
    let cutters = [ball.clone()];
    let paths = [MillPath { cutter: 0, places: vec![place] }];
    let standing = Milling { cutters: &cutters, paths: &paths, stock: REACH, depth: DEPTH };
    let milled = mill(&standing, rays, &Silent).map_err(|error| of_removal(&error)).ok()?;
    let length = |ray: &Result<referee::MilledRay, referee::Unmilled>| match ray {
        Ok(ray) => ray.length,
        Err(referee::Unmilled::TooDeep { .. }) => -DEPTH,
        Err(_) => REACH,
    };
    milled.rays.iter().map(length).enumerate().min_by(|a, b| a.1.total_cmp(&b.1))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_axis_that_counts_anew_is_not_led_across() {
        let deg = |angles: [f64; 2]| angles.map(f64::to_radians);
        assert!(stays_in_a_turn(deg([93.0, 87.0]), 2f64.to_radians(), "C").is_ok());
        for touches in [[3.0, -3.0], [1.5, 7.0], [359.0, 353.0]] {
            let Err(RunFailure::NotProducible(finding)) =
                stays_in_a_turn(deg(touches), 2f64.to_radians(), "C")
            else {
                panic!("{touches:?} is taken")
            };
            assert_eq!(finding.code, "modulo-crossed");
        }
    }
}
