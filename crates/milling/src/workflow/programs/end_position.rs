//! The moves at the end of a program: one axis after the other to where the job wants it, from where the last path has left the cutter.
//! Whether they stay clear of the part is proven with all other rapid moves of the text.

use super::drive::rapid_seconds;
use super::failure::of_motion;
use super::steps::{Step, StepKind};
use crate::job::EndMove;
use job::{Diagnostic, Problem, shown_number};
use machine::{Axis, Joint};
use motion::milling::{CutterPlace as Place, MillingSetup};
use run::RunFailure;
use std::f64::consts::TAU;

/// An axis stands where it is to go, mm or rad.
const THERE: f64 = 1e-9;

/// The blocks behind the last one of a program.
///
/// # Errors
/// [`RunFailure`]: an axis that the machine does not have, a position beyond its travel.
pub(super) fn end_steps(
    setup: &MillingSetup<'_>,
    moves: &[EndMove],
    last: Option<&Step>,
) -> Result<Vec<Step>, RunFailure> {
    let mut steps: Vec<Step> = Vec::new();
    let Some(last) = last else { return Ok(steps) };
    for (number, wanted) in moves.iter().enumerate() {
        let before = steps.last().unwrap_or(last);
        let (axis, described) = axis_of(setup, number, &wanted.axis)?;
        let position = position(described, number, wanted.position, before.at[axis])?;
        if (position - before.at[axis]).abs() <= THERE {
            continue;
        }
        let mut at = before.at;
        at[axis] = position;
        let (tip, pointing) =
            setup.stands(&at).map_err(|error| of_motion(&error.into(), "end of the program"))?;
        let place = Place { contact: tip, tip, axis: pointing };
        let seconds = rapid_seconds(setup, &before.at, &at);
        let kind = StepKind::End;
        let step = Step { kind, place, at, seconds, limit: None, guided: false, ..before.clone() };
        steps.push(step);
    }
    Ok(steps)
}

fn axis_of<'a>(
    setup: &'a MillingSetup<'_>,
    number: usize,
    name: &str,
) -> Result<(usize, &'a Axis), RunFailure> {
    let axes = setup.machine().axes();
    let five = || setup.axes().linear.into_iter().chain(setup.axes().rotary);
    if let Some(axis) = five().find(|&axis| axes[axis].name == name) {
        return Ok((axis, &axes[axis]));
    }
    let known: Vec<&str> = five().map(|axis| axes[axis].name.as_str()).collect();
    let finding = Diagnostic::new(Problem::UnknownValue, format!("the machine does not move an axis {name}"))
        .field(format!("machine.end_position[{number}].axis"))
        .value(format!("\"{name}\""))
        .allowed(known.join(", "))
        .way_out("give the name that the axis has in the machine description");
    Err(RunFailure::bad_input(finding))
}

/// Within the travel, or in the turn that is nearest to where the axis stands, mm or rad.
fn position(axis: &Axis, number: usize, given: f64, stands: f64) -> Result<f64, RunFailure> {
    let rotary = axis.joint == Joint::Rotary;
    let value = if rotary { given.to_radians() } else { given };
    if rotary && axis.travel.is_none() {
        return Ok(value + TAU * ((stands - value) / TAU).round());
    }
    let Some(error) = axis.beyond(value) else { return Ok(value) };
    let finding = Diagnostic::of(&error)
        .field(format!("machine.end_position[{number}].position"))
        .value(shown_number(given))
        .way_out("give a position within the travel of the axis");
    let ends = axis.travel.map(|ends| ends.map(|end| rounded(axis.joint.shown(end))));
    let finding = match ends {
        Some([from, to]) => finding.allowed(format!("{from} to {to} {}", axis.joint.unit())),
        None => finding,
    };
    Err(RunFailure::bad_input(finding))
}

/// Degrees through radians and back miss a whole number by the last digit.
fn rounded(shown: f64) -> String {
    shown_number((shown * DIGITS).round() / DIGITS)
}

/// Digits of a travel that are shown.
const DIGITS: f64 = 1e6;
