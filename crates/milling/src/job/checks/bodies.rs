//! The workpiece and what is wanted of it: one body, and a target that fits it.

use super::{bevel, exactly_one, impossible};
use crate::job::{Blade, FourDigits, GridGear, MillingGear, MillingJob, NacaBlade};
use job::checks::{contradiction, drawing};
use job::tables::Flanks;
use job::{Diagnostic, Problem, shown_number};

pub(super) fn check(job: &MillingJob, findings: &mut Vec<Diagnostic>) {
    exactly_one(
        "",
        &[
            ("gear", job.gear.is_some()),
            ("bevel", job.bevel.is_some()),
            ("blade", job.blade.is_some()),
            ("grid_gear", job.grid_gear.is_some()),
        ],
        "the job has no workpiece",
        "add a table [gear], [bevel], [blade] or [grid_gear]; `flankwright new five-axis-milling` prints a complete example",
        findings,
    );
    if let Some(body) = &job.gear {
        gear(body, findings);
    }
    if let Some(body) = &job.bevel {
        bevel::check(body, findings);
    }
    if let Some(body) = &job.blade {
        blade(body, job.milling.flanks, findings);
        passage(job, findings);
    }
    if let Some(body) = &job.grid_gear {
        grid_gear(body, findings);
    }
    target(job, findings);
}

/// Lines of root and tip that are the ends of a face, the tip farther out.
fn grid_gear(gear: &GridGear, findings: &mut Vec<Diagnostic>) {
    for (key, line) in [("root", &gear.root), ("tip", &gear.tip)] {
        let [from, to] = line.positions;
        let across = (line.radii[1] - line.radii[0]).abs();
        // Flatter than this a cutter that is drawn back along its axis does not leave the body.
        let most = (to - from).abs() * FLATTEST_DEG.to_radians().tan();
        if from == to || across > most {
            impossible(
                format!("the {key} body is flatter than a cone of {FLATTEST_DEG} degrees"),
                &format!("grid_gear.{key}.positions[1]"),
                to,
                format!(
                    "farther than {} from the first position",
                    shown_number(across / FLATTEST_DEG.to_radians().tan())
                ),
                "compare radii and positions with the drawing: z is the gear's axis",
                findings,
            );
        }
    }
    let heights = [0, 1].map(|k| {
        let [root, tip] = [gear.root.ends()[k], gear.tip.ends()[k]];
        let [from, to] = gear.root.ends();
        let (radial, axial) = (to[0] - from[0], to[1] - from[1]);
        // Outwards across the root line.
        let sense = axial.signum();
        sense * ((tip[0] - root[0]) * axial - (tip[1] - root[1]) * radial)
    });
    if let Some(k) = heights.iter().position(|height| *height <= 0.0) {
        impossible(
            "the tip does not lie outside of the root body".into(),
            &format!("grid_gear.tip.radii[{k}]"),
            gear.tip.radii[k],
            "radii and positions outside of the root body".into(),
            "compare both bodies with the drawing; both begin at the same end of the face",
            findings,
        );
    }
}

/// Half angle of the flattest cone, degrees.
const FLATTEST_DEG: f64 = 85.0;

fn gear(gear: &MillingGear, findings: &mut Vec<Diagnostic>) {
    drawing(&gear.drawing, findings);
    let cone = gear.drawing.cone_angle_deg;
    if cone != 0.0 && gear.double_helical.is_some() {
        findings.push(contradiction(
            "the halves of a double-helical gear are cylindrical",
            "gear.cone_angle_deg",
            shown_number(cone),
            "0 beside `double_helical`",
            "leave the cone angle or `double_helical` out",
        ));
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

fn blade(blade: &Blade, flanks: Option<Flanks>, findings: &mut Vec<Diagnostic>) {
    exactly_one(
        "blade",
        &[
            ("ruled", blade.ruled.is_some()),
            ("points", blade.points.is_some()),
            ("naca", blade.naca.is_some()),
        ],
        "`blade` has no surface",
        "add `ruled = { .. }`, or `points = { file = \"blade.csv\", rows = .., columns = .., side = \"left\" }`, or `naca = { .. }`",
        findings,
    );
    if let Some(given) = &blade.naca {
        naca(blade, given, findings);
    }
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

/// Sections of four digits, and a blade that has no thickness beside them.
fn naca(blade: &Blade, naca: &NacaBlade, findings: &mut Vec<Diagnostic>) {
    for (k, text) in naca.sections.iter().enumerate() {
        if FourDigits::new(text).is_none() {
            findings.push(
                Diagnostic::new(Problem::UnknownValue, "a section is none of four digits")
                    .field(format!("blade.naca.sections[{k}]"))
                    .value(format!("\"{text}\""))
                    .allowed("four digits: camber and its place, both 0 or neither, and a thickness above 0")
                    .way_out("give e.g. \"4412\", or \"0012\" for a section without camber"),
            );
        }
    }
    let widest = blade.hub_radius[0].max(blade.hub_radius[1]);
    if naca.tip_radius <= widest {
        impossible(
            format!("the tip radius {} does not lie outside the hub", naca.tip_radius),
            "blade.naca.tip_radius",
            naca.tip_radius,
            format!("> {}, the greatest hub radius", shown_number(widest)),
            "compare the radii with the drawing",
            findings,
        );
    }
    if let Some([hub, tip]) = blade.thickness {
        findings.push(contradiction(
            "sections of four digits have a thickness of their own",
            "blade.thickness",
            format!("[{}, {}]", shown_number(hub), shown_number(tip)),
            "no key beside `naca`",
            "leave `thickness` out",
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
    if job.target.modifications.is_some() && job.gear.is_none() && job.bevel.is_none() {
        findings.push(contradiction(
            "modifications are those of a gear by its drawing",
            "target.modifications",
            "a list".into(),
            "no key without [gear] or [bevel]",
            "leave them out: a surface through points is what its table gives",
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
