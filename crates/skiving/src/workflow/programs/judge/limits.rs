//! Travel and speed of every axis, with the block that leaves them.

use super::{Followed, fault};
use machine::Machine;
use verdict::Remark;

/// What digits of a feed add to a speed, as a share.
const ROUNDING: f64 = 1e-6;

/// The first block of every axis beyond its travel and beyond its speed.
pub(in super::super) fn limits(followed: &Followed, machine: &Machine) -> Vec<Remark> {
    let mut faults = Vec::new();
    for (number, axis) in machine.axes().iter().enumerate() {
        let beyond = followed.motions.iter().find_map(|m| Some((m.block, axis.beyond(m.to[number])?)));
        if let Some((block, error)) = beyond {
            faults.push(fault(error.code(), block, &error.to_string(), "keep the axis within its travel"));
        }
        let Some(most) = axis.limits.velocity else { continue };
        let too_fast = followed.motions.iter().find_map(|m| {
            let speed = (m.to[number] - m.from?[number]).abs() / m.seconds?;
            (speed > most * (1.0 + ROUNDING)).then_some((m.block, speed))
        });
        if let Some((block, speed)) = too_fast {
            let [moves, allows] = [speed, most].map(|value| axis.joint.shown(value));
            let (name, unit) = (&axis.name, axis.joint.unit());
            let text =
                format!("{name} would move at {moves:.4} {unit}/s; the machine allows {allows:.4} {unit}/s");
            faults.push(fault("axis-too-fast", block, &text, "give the block more time"));
        }
    }
    faults
}
