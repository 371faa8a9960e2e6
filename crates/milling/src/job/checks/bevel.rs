//! A bevel gear: cones that enclose teeth, a flank line with what it needs, halves of opposite hand.

use super::impossible;
use crate::job::{BevelFlank, BevelGear, BevelSpiral, DoubleHelicalBevel, SpiralLine};
use job::checks::contradiction;
use job::{Diagnostic, Problem, shown_number};

pub(super) fn check(bevel: &BevelGear, findings: &mut Vec<Diagnostic>) {
    let outer = bevel.outer_cone_distance();
    if bevel.face_width >= outer {
        impossible(
            format!("teeth of a width of {} reach to the apex", bevel.face_width),
            "bevel.face_width",
            bevel.face_width,
            format!("< {}, the outer cone distance", shown_number(outer)),
            "compare module, teeth, cone angle and face width with the drawing",
            findings,
        );
    }
    if bevel.flank == BevelFlank::Octoid && bevel.spiral.is_some() {
        findings.push(contradiction(
            "octoid teeth are straight",
            "bevel.spiral",
            "a table beside flank = \"octoid\"".into(),
            "no key, or flank = \"spherical-involute\"",
            "leave `spiral` out, or take the spherical involute",
        ));
    }
    if let Some(spiral) = &bevel.spiral {
        flank_line(spiral, findings);
    }
    if let Some(given) = bevel.double_helical {
        halves(bevel, given, findings);
    }
    let [root, tip] = bevel.cone_angles_deg();
    if root <= 0.0 {
        impossible(
            format!("the root cone has an angle of {root:.4} degrees"),
            "bevel.dedendum_factor",
            bevel.dedendum_factor,
            "a dedendum with which the root cone stays open".into(),
            "compare pitch cone angle, teeth and dedendum with the drawing",
            findings,
        );
        return;
    }
    let most = bevel.end_of_involute_deg();
    if tip >= most {
        impossible(
            format!("the tip cone has an angle of {tip:.4} degrees, beyond the end of the flank"),
            "bevel.addendum_factor",
            bevel.addendum_factor,
            format!("an addendum with which the tip cone has less than {} degrees", shown_number(most)),
            "compare module, teeth, pitch cone angle and addendum with the drawing",
            findings,
        );
        return;
    }
    if let Some(start) = bevel.start_polar_angle_deg
        && !(root..tip).contains(&start)
    {
        impossible(
            format!("the active flank begins at {start} degrees, not between root and tip"),
            "bevel.start_polar_angle_deg",
            start,
            format!(
                "from {} (root cone) to below {} (tip cone) degrees",
                shown_number(root),
                shown_number(tip)
            ),
            "give an angle between both cones, or leave it out",
            findings,
        );
    }
}

/// Halves of opposite hand, both with teeth.
fn halves(bevel: &BevelGear, halves: DoubleHelicalBevel, findings: &mut Vec<Diagnostic>) {
    if bevel.spiral.is_none_or(|spiral| spiral.mean_spiral_angle_deg == 0.0) {
        findings.push(contradiction(
            "the halves of a double-helical gear have opposite hands, and teeth without a spiral angle have none",
            "bevel.double_helical",
            if bevel.spiral.is_none() { "a table without `spiral`" } else { "a table beside mean_spiral_angle_deg = 0" }
                .into(),
            "no key without `spiral` and its angle",
            "leave `double_helical` out, or give the `spiral` of the half at the heel",
        ));
    }
    let face = bevel.face_width;
    if halves.gap >= face {
        impossible(
            format!("the gap of {} leaves nothing of the face width {face}", halves.gap),
            "bevel.double_helical.gap",
            halves.gap,
            format!("< face_width = {}", shown_number(face)),
            "`face_width` is that of both halves with the gap",
            findings,
        );
    } else if halves.middle.abs() >= 0.5 * (face - halves.gap) {
        let most = 0.5 * (face - halves.gap);
        impossible(
            format!("with the middle at {} one of the halves has no teeth", halves.middle),
            "bevel.double_helical.middle",
            halves.middle,
            format!("between {} and {}", shown_number(-most), shown_number(most)),
            "count from the middle of the face towards the heel; both halves and the gap lie within `face_width`",
            findings,
        );
    }
}

/// What a flank line needs and what it has no use for.
fn flank_line(spiral: &BevelSpiral, findings: &mut Vec<Diagnostic>) {
    let of_head = spiral.line.of_head();
    let hobbed = spiral.line == SpiralLine::Epicycloid;
    for (key, given, needed, what) in [
        ("cutter_radius", spiral.cutter_radius.is_some(), of_head, "the radius of its cutter head"),
        (
            "blade_groups",
            spiral.blade_groups.is_some(),
            hobbed,
            "the number of blade groups of its cutter head",
        ),
    ] {
        let field = format!("bevel.spiral.{key}");
        if needed && !given {
            findings.push(
                Diagnostic::new(Problem::MissingKey, format!("the flank line needs {what}"))
                    .field(field)
                    .allowed(if hobbed && key == "blade_groups" {
                        "a whole number, 1 or more"
                    } else {
                        "a radius in mm"
                    })
                    .way_out(format!("add `{key}`")),
            );
        } else if given && !needed {
            findings.push(contradiction(
                &format!("this flank line does not come from {what}"),
                field,
                "a value".into(),
                if key == "blade_groups" {
                    "no key but with line = \"epicycloid\""
                } else {
                    "no key with line = \"skew\" or \"involute\""
                },
                "leave it out, or name the line that it belongs to",
            ));
        }
    }
}
