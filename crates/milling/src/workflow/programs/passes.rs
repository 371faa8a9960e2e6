//! The passes of a job in their order: every path of every space with the places at which the cutter is outside before and after,
//! one tool after the other.

use super::failure::{in_pass, invalid, of_milling};
use super::links::DIP;
use super::safe_room::SafeRoom;
use super::task::{MillingWork, ToolWork};
use crate::workflow::prepare::ToolData;
use crate::{CutterPath, CutterPlace, OperationKind};
use foundation::kinematics::{Direction, Point};
use motion::milling::CutterPlace as Place;
use nalgebra::{Rotation3, Vector3};
use run::RunFailure;
use std::ops::Range;

/// One path in one space.
#[derive(Clone, Debug)]
pub(super) struct CutterPass {
    /// Which of the operations, space and path, from 0.
    pub operation: usize,
    pub space: usize,
    pub path: usize,
    /// Outside, at the edge of the body, on the path, outside again.
    pub places: Vec<Place>,
}

/// Places before the first and behind the last one of the path.
pub(super) const BEFORE: usize = 2;
pub(super) const BEHIND: usize = 1;

impl CutterPass {
    /// The places of the path itself.
    pub fn cut(&self) -> Range<usize> {
        BEFORE..self.places.len() - BEHIND
    }
}

/// What is done with one tool before the next.
#[derive(Clone, Debug)]
pub(super) struct ToolPasses {
    pub tool: ToolData,
    pub room: SafeRoom,
    pub passes: Vec<CutterPass>,
}

/// An operation in words.
pub(super) fn name_of(kind: OperationKind) -> String {
    match kind {
        OperationKind::Roughing => "roughing".into(),
        OperationKind::Flank(side) => format!("{side} flank"),
        OperationKind::Fillet(side) => format!("{side} fillet"),
        OperationKind::Bottom => "bottom".into(),
    }
}

/// A place with what the motion wants to know; a place without contact is led by its tip.
fn place(at: &CutterPlace, touches: bool) -> Place {
    let contact = at.contact.filter(|_| touches).unwrap_or(at.tip);
    Place {
        contact: Point::from_vector(contact),
        tip: Point::from_vector(at.tip),
        axis: Direction::from_vector(at.axis),
    }
}

fn turned(path: &CutterPath, angle: f64) -> Vec<CutterPlace> {
    let turn = Rotation3::from_axis_angle(&Vector3::z_axis(), angle);
    let turned = |at: &CutterPlace| CutterPlace {
        tip: turn * at.tip,
        axis: turn * at.axis,
        contact: at.contact.map(|contact| turn * contact),
    };
    path.places.iter().map(turned).collect()
}

/// A path between its places outside.
fn pass(
    work: &ToolWork,
    room: &SafeRoom,
    [operation, space, path]: [usize; 3],
    pitch: f64,
) -> Result<CutterPass, RunFailure> {
    let places = turned(&work.paths[path], pitch * space as f64);
    let what = || in_pass(&name_of(work.kind), space, path);
    let (Some(first), Some(last)) = (places.first(), places.last()) else {
        return Err(invalid("milling", 0.0, "paths with one place or more"));
    };
    let back = |at: &CutterPlace| room.drawn_back(at, DIP).map_err(|error| of_milling(&error, &what()));
    let ([edge, begin], [_, end]) = (back(first)?, back(last)?);
    let touches = places.iter().all(|at| at.contact.is_some());
    let before = [place(&begin, false), place(&edge, false)];
    let along = places.iter().map(|at| place(at, touches));
    let places = before.into_iter().chain(along).chain([place(&end, false)]).collect();
    Ok(CutterPass { operation, space, path, places })
}

fn check(work: &MillingWork<'_>) -> Result<(), RunFailure> {
    if work.spaces == 0 {
        return Err(invalid("milling.teeth", 0.0, "one space or more"));
    }
    if !work.pitch.is_finite() {
        return Err(invalid("gear.teeth", work.pitch, "a finite pitch"));
    }
    for tool in &work.tools {
        let speeds = [
            ("milling.feed_mm_per_min", tool.tool.feed),
            ("milling.plunge_feed_mm_per_min", tool.tool.plunge_feed),
            ("milling.spindle_rpm", tool.tool.spindle_rpm),
        ];
        for (field, value) in speeds {
            if !(value.is_finite() && value > 0.0) {
                return Err(invalid(field, value, "above 0"));
            }
        }
    }
    Ok(())
}

/// All passes: with one tool all spaces, then the next tool. Operations that follow each other with the same tool at the same speed
/// share it.
///
/// # Errors
/// [`RunFailure`] for numbers that are not usable and places from which the cutter cannot be drawn back.
pub(super) fn all_passes(work: &MillingWork<'_>) -> Result<Vec<ToolPasses>, RunFailure> {
    check(work)?;
    let mut tools = Vec::new();
    let mut from = 0;
    while let Some(first) = work.tools.get(from) {
        let same = |other: &&ToolWork| {
            other.tool.number == first.tool.number && other.tool.spindle_rpm == first.tool.spindle_rpm
        };
        let to = from + work.tools[from..].iter().take_while(same).count();
        let room = SafeRoom::new(work.retraction, &first.cutter);
        let mut passes = Vec::new();
        for space in 0..work.spaces {
            for (operation, tool) in work.tools.iter().enumerate().take(to).skip(from) {
                for path in 0..tool.paths.len() {
                    passes.push(pass(tool, &room, [operation, space, path], work.pitch)?);
                }
            }
        }
        if !passes.is_empty() {
            tools.push(ToolPasses { tool: first.tool, room, passes });
        }
        from = to;
    }
    Ok(tools)
}
