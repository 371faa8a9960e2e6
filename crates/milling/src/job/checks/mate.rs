//! The mate: what a bevel and a cylindrical one have, and whether it fits the gear.

use crate::job::{BevelGear, Mate, MillingGear, MillingJob};
use job::checks::{contradiction, drawing, not_yet};
use job::{Diagnostic, Problem, shown_number};

pub(super) fn check(job: &MillingJob, findings: &mut Vec<Diagnostic>) {
    let Some(mate) = &job.mate else { return };
    match (&job.bevel, &job.gear) {
        (Some(bevel), _) => {
            of_the_other(&cylindrical_keys(mate), "bevel gear", findings);
            conical(mate, bevel, findings);
        }
        (None, Some(gear)) => {
            of_the_other(&conical_keys(mate), "cylindrical gear", findings);
            cylindrical(mate, gear, findings);
        }
        (None, None) => findings.push(contradiction(
            "blades and gears by points have no mate here",
            "mate",
            "a table".into(),
            "no table without [gear] or [bevel]",
            "leave `[mate]` out",
        )),
    }
}

fn cylindrical_keys(mate: &Mate) -> [(&'static str, bool); 2] {
    [("gear", mate.gear.is_some()), ("centre_distance", mate.centre_distance.is_some())]
}

fn conical_keys(mate: &Mate) -> [(&'static str, bool); 4] {
    [
        ("teeth", mate.teeth.is_some()),
        ("pitch_cone_angle_deg", mate.pitch_cone_angle_deg.is_some()),
        ("shaft_angle_deg", mate.shaft_angle_deg.is_some()),
        ("ease_off", mate.ease_off.is_some()),
    ]
}

/// Keys that the mate of the other kind of gear has.
fn of_the_other(keys: &[(&'static str, bool)], body: &str, findings: &mut Vec<Diagnostic>) {
    for (key, _) in keys.iter().filter(|(_, given)| *given) {
        findings.push(contradiction(
            &format!("the mate of a {body} has no `{key}`"),
            format!("mate.{key}"),
            "a value".into(),
            "no key",
            "leave it out: the mate of a bevel gear is given by `teeth`, that of a cylindrical one by `gear` and `centre_distance`",
        ));
    }
}

fn missing(key: &str, message: &str, allowed: &str, way_out: &str, findings: &mut Vec<Diagnostic>) {
    findings.push(Diagnostic::new(Problem::MissingKey, message).field(key).allowed(allowed).way_out(way_out));
}

fn cylindrical(mate: &Mate, own: &MillingGear, findings: &mut Vec<Diagnostic>) {
    if own.double_helical.is_some() {
        findings.push(contradiction(
            "the halves of a double-helical gear are not rolled together",
            "mate",
            "a table beside gear.double_helical".into(),
            "no table with gear.double_helical",
            "roll a half as a job of its own, with the face of that half and its hand",
        ));
    }
    if mate.centre_distance.is_none() {
        missing(
            "mate.centre_distance",
            "a cylindrical pair has a centre distance",
            "a length in mm",
            "add `centre_distance` in mm",
            findings,
        );
    }
    let Some(other) = &mate.gear else {
        missing(
            "mate.gear",
            "the mate of a cylindrical gear has a drawing",
            "a table as [gear]",
            "add `[mate.gear]` with its drawing",
            findings,
        );
        return;
    };
    let mut of_drawing = Vec::new();
    drawing(other, &mut of_drawing);
    findings.extend(of_drawing.into_iter().map(|finding| {
        let field = finding.field.as_deref().map(|field| format!("mate.{field}"));
        match field {
            Some(field) => finding.field(field),
            None => finding,
        }
    }));
    let own = &own.drawing;
    let both_internal = own.teeth < 0 && other.teeth < 0;
    if both_internal {
        findings.push(contradiction(
            "two internal gears do not mesh",
            "mate.gear.teeth",
            other.teeth.to_string(),
            "> 0 beside an internal gear",
            "compare the numbers of teeth with the drawings",
        ));
    }
    for (field, gear) in [("gear.cone_angle_deg", own), ("mate.gear.cone_angle_deg", other)] {
        if gear.cone_angle_deg != 0.0 {
            findings.push(
                not_yet(field, "rolling gears with a cone angle against each other")
                    .value(shown_number(gear.cone_angle_deg))
                    .allowed("0 beside `[mate]`")
                    .way_out("leave `[mate]` out"),
            );
        }
    }
    let inside = (own.teeth < 0) != (other.teeth < 0);
    let wanted = if inside { own.helix_angle_deg } else { -own.helix_angle_deg };
    for (key, given, wanted) in [
        ("mate.gear.helix_angle_deg", other.helix_angle_deg, wanted),
        ("mate.gear.normal_module", other.normal_module, own.normal_module),
    ] {
        // A drawing rounds angles to seconds.
        if (given - wanted).abs() > 1e-4 {
            findings.push(contradiction(
                "gears on parallel axes have one base pitch, and helices that fit each other",
                key,
                shown_number(given),
                &shown_number(wanted),
                "compare module and helix angle of both gears with the drawings",
            ));
        }
    }
}

fn conical(mate: &Mate, bevel: &BevelGear, findings: &mut Vec<Diagnostic>) {
    if bevel.double_helical.is_some() {
        findings.push(contradiction(
            "the halves of a double-helical gear are not rolled together",
            "mate",
            "a table beside bevel.double_helical".into(),
            "no table with bevel.double_helical",
            "roll a half as a job of its own, with the cones of the gear, the face of that half and its hand",
        ));
    }
    let Some(teeth) = mate.teeth else {
        missing(
            "mate.teeth",
            "the mate of a bevel gear has a number of teeth",
            "a whole number, 3 or more",
            "add `teeth`",
            findings,
        );
        return;
    };
    if mate.pitch_cone_angle_deg.is_some() && mate.shaft_angle_deg.is_some() {
        findings.push(contradiction(
            "the shaft angle is the sum of both pitch cone angles",
            "mate.shaft_angle_deg",
            "beside `pitch_cone_angle_deg`".into(),
            "at most one of pitch_cone_angle_deg, shaft_angle_deg",
            "keep one of them",
        ));
    }
    if mate.conjugate_angle_deg(bevel).is_none() {
        let most = f64::from(bevel.teeth) / bevel.pitch_cone_angle_deg.to_radians().sin();
        findings.push(contradiction(
            &format!("no pitch cone up to 90 degrees has {teeth} teeth beside this gear"),
            "mate.teeth",
            teeth.to_string(),
            &format!("<= {}", shown_number(most)),
            "compare the teeth and the pitch cone angle of both gears with the drawing",
        ));
    } else if let Some(misfit) = mate.misfit(bevel) {
        let by_default = misfit.key == "mate.teeth";
        findings.push(contradiction(
            &format!(
                "{} and {} teeth roll on this pitch cone with an angle of {:.4} degrees, not {}",
                bevel.teeth, teeth, misfit.wanted, misfit.given
            ),
            misfit.key,
            if by_default { teeth.to_string() } else { shown_number(misfit.given) },
            &if by_default {
                format!("teeth for axes at 90 degrees, or shaft_angle_deg = {}", shown_number(misfit.wanted))
            } else {
                shown_number(misfit.wanted)
            },
            "compare the teeth and the angles of both gears with the drawing",
        ));
    }
}
