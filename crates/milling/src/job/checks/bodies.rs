//! The workpiece and what is wanted of it: one body, and a target that fits it.

use super::exactly_one;
use crate::job::{BevelFlank, BevelGear, Blade, MillingGear, MillingJob};
use job::checks::{contradiction, drawing, not_yet};
use job::tables::Flanks;
use job::{Diagnostic, Problem, shown_number};

pub(super) fn check(job: &MillingJob, findings: &mut Vec<Diagnostic>) {
    exactly_one(
        "",
        &[("gear", job.gear.is_some()), ("bevel", job.bevel.is_some()), ("blade", job.blade.is_some())],
        "the job has no workpiece",
        "add a table [gear], [bevel] or [blade]; `flankwright new five-axis-milling` prints a complete example",
        findings,
    );
    if let Some(body) = &job.gear {
        gear(body, findings);
    }
    if let Some(body) = &job.bevel {
        bevel(body, findings);
    }
    if let Some(body) = &job.blade {
        blade(body, job.milling.flanks, findings);
        passage(job, findings);
    }
    target(job, findings);
}

fn impossible(
    message: String,
    field: &str,
    value: f64,
    allowed: String,
    way_out: &str,
    findings: &mut Vec<Diagnostic>,
) {
    findings.push(
        Diagnostic::new(Problem::InvalidGeometry, message)
            .field(field)
            .value(shown_number(value))
            .allowed(allowed)
            .way_out(way_out),
    );
}

fn gear(gear: &MillingGear, findings: &mut Vec<Diagnostic>) {
    drawing(&gear.drawing, findings);
    let cone = gear.drawing.cone_angle_deg;
    if cone != 0.0 {
        findings.push(
            not_yet("gear.cone_angle_deg", "five-axis milling of involute gears with a cone angle")
                .value(shown_number(cone))
                .allowed("0, or a table [bevel]")
                .way_out("leave the cone angle out"),
        );
    }
    let Some(halves) = gear.double_helical else { return };
    if gear.drawing.helix_angle_deg == 0.0 {
        findings.push(contradiction(
            "the halves of a double-helical gear have opposite hands, and a spur gear has none",
            "gear.double_helical",
            format!("a table beside helix_angle_deg = {}", shown_number(gear.drawing.helix_angle_deg)),
            "no key for a spur gear",
            "leave `double_helical` out, or give the helix angle of the half towards +z",
        ));
    }
    let face = gear.drawing.face_width;
    let nothing_left = |[from, to]: [f64; 2]| from >= to;
    if halves.gap >= face {
        impossible(
            format!("the gap of {} leaves nothing of the face width {face}", halves.gap),
            "gear.double_helical.gap",
            halves.gap,
            format!("< face_width = {}", shown_number(face)),
            "`face_width` is that of both halves with the gap",
            findings,
        );
    } else if halves.faces(face).into_iter().any(nothing_left) {
        let most = 0.5 * (face - halves.gap);
        impossible(
            format!("with the apex at {} one of the halves has no teeth", halves.apex),
            "gear.double_helical.apex",
            halves.apex,
            format!("between {} and {}", shown_number(-most), shown_number(most)),
            "count from the middle of the face towards +z; both halves and the gap lie within `face_width`",
            findings,
        );
    }
}

fn bevel(bevel: &BevelGear, findings: &mut Vec<Diagnostic>) {
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

fn blade(blade: &Blade, flanks: Option<Flanks>, findings: &mut Vec<Diagnostic>) {
    exactly_one(
        "blade",
        &[("ruled", blade.ruled.is_some()), ("points", blade.points.is_some())],
        "`blade` has no surface",
        "add `ruled = { .. }`, or `points = { file = \"blade.csv\", rows = .., columns = .., side = \"left\" }`",
        findings,
    );
    let widest = blade.hub_radius[0].max(blade.hub_radius[1]);
    if let Some(ruled) = blade.ruled
        && ruled.tip_radius <= widest
    {
        impossible(
            format!("the tip radius {} does not lie outside the hub", ruled.tip_radius),
            "blade.ruled.tip_radius",
            ruled.tip_radius,
            format!("> {}, the greatest hub radius", shown_number(widest)),
            "compare the radii with the drawing",
            findings,
        );
    }
    let [from, to] = blade.active_height;
    if from >= to {
        findings.push(contradiction(
            "the part of the blade that is milled has no height",
            "blade.active_height",
            format!("[{}, {}]", shown_number(from), shown_number(to)),
            "two shares from 0 to 1, the smaller one first",
            "give e.g. [0.05, 1.0]",
        ));
    }
    if let (Some(flanks), Some(side)) = (flanks, blade.side())
        && !(flanks != Flanks::Both && flanks.includes(side.flank()))
    {
        let word = match flanks {
            Flanks::Both => "both",
            Flanks::Left => "left",
            Flanks::Right => "right",
        };
        findings.push(contradiction(
            "a blade has the side that its table describes",
            "milling.flanks",
            format!("\"{word}\""),
            "no key",
            "leave `flanks` out; `side` in [blade] says which side it is",
        ));
    }
}

/// A blade has one flank, and a passage between a side and a back is not cleared here.
fn passage(job: &MillingJob, findings: &mut Vec<Diagnostic>) {
    if job.milling.roughing.is_some() {
        findings.push(contradiction(
            "passages between blades are not cleared: the space between both flanks of a gear is",
            "milling.roughing",
            "a table beside [blade]".into(),
            "no table with [blade]",
            "leave [milling.roughing] and [roughing_cutter] out, and clear the passage by another job",
        ));
    }
}

fn target(job: &MillingJob, findings: &mut Vec<Diagnostic>) {
    if job.target.modifications.is_some() && job.gear.is_none() {
        findings.push(contradiction(
            "modifications are those of a cylindrical gear",
            "target.modifications",
            "a list".into(),
            "no key without [gear]",
            "leave them out; a bevel gear has `ease_off`",
        ));
    }
    if job.target.ease_off.is_some() && job.bevel.is_none() {
        findings.push(contradiction(
            "an ease-off is that of a bevel gear",
            "target.ease_off",
            "a table".into(),
            "no key without [bevel]",
            "leave it out; a cylindrical gear has `modifications`",
        ));
    }
}
