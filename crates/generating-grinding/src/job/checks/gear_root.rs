//! Contradictions around `[dressing.gear_root]`: the head of the dresser makes the worm's tip, and the tip follows from the gear.

use crate::job::{DressingFlanks, Job, Tool};
use job::checks::contradiction;
use job::{Diagnostic, shown_number};

pub(super) fn check(job: &Job, findings: &mut Vec<Diagnostic>) {
    if job.dressing.gear_root.is_none() {
        return;
    }
    let mut refuse = |message: &str, field: &str, value: String, allowed: &str, way_out: &str| {
        findings.push(contradiction(message, field, value, allowed, way_out));
    };
    const WITHOUT: &str = "leave `dressing.gear_root` out";
    if job.worm.tool != Tool::Dressed {
        refuse(
            "only a dressed worm has a head that the dresser makes",
            "dressing.gear_root",
            "a table".into(),
            "no key, or worm.tool = \"dressed\"",
            WITHOUT,
        );
    }
    if job.dressing.flanks == DressingFlanks::Two || !job.dressing.dresses_head() {
        refuse(
            "the root of the gear is ground by the worm's tip, which the conditions of dressing do not hold",
            "dressing.conditions",
            format!("{} conditions", job.dressing.conditions.len()),
            "[\"three-point\", \"head\"], or others with a head without weight, and dressing.flanks = \"one\"",
            "set dressing.conditions = [\"three-point\", \"head\"], or leave `dressing.gear_root` out",
        );
    }
    for (field, angle) in
        [("gear.cone_angle_deg", job.gear.cone_angle_deg), ("worm.cone_angle_deg", job.worm.cone_angle_deg)]
    {
        if angle != 0.0 {
            refuse(
                "the root is ground on cylindrical gears by cylindrical worms",
                field,
                shown_number(angle),
                "0, or no dressing.gear_root",
                WITHOUT,
            );
        }
    }
    if let Some(tip) = job.worm.tip_diameter {
        refuse(
            "the tip diameter of the worm follows from the root diameter of the gear",
            "worm.tip_diameter",
            shown_number(tip),
            "no key: give worm.pitch_diameter",
            "give worm.pitch_diameter instead, or leave `dressing.gear_root` out",
        );
    }
}
