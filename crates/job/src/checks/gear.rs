//! Contradictions in `[gear]`, for whatever process: thickness given once, diameters in their order, an evaluated field on
//! the flank. Knows no geometry beyond that order.

use crate::diagnostic::{Diagnostic, Problem};
use crate::node::shown_number;
use crate::tables::Gear;

/// What contradicts itself in `[gear]`.
pub fn check(gear: &Gear, findings: &mut Vec<Diagnostic>) {
    thickness(gear, findings);
    allowances(gear, findings);
    diameters(gear, findings);
    evaluation(gear, findings);
}

fn thickness(gear: &Gear, findings: &mut Vec<Diagnostic>) {
    let forms = [
        ("profile_shift", gear.profile_shift.is_some()),
        ("normal_tooth_thickness", gear.normal_tooth_thickness.is_some()),
        ("span", gear.span.is_some()),
        ("over_balls", gear.over_balls.is_some()),
    ];
    let given: Vec<&str> = forms.iter().filter(|(_, given)| *given).map(|(key, _)| *key).collect();
    let allowed = "exactly one of profile_shift, normal_tooth_thickness, span, over_balls";
    match given.as_slice() {
        [_] => {}
        [] => findings.push(
            Diagnostic::new(Problem::MissingKey, "`gear` does not say how thick the teeth are")
                .field("gear.profile_shift")
                .allowed(allowed)
                .way_out("add one of them; `profile_shift = 0.0` for standard teeth"),
        ),
        [_, more @ ..] => findings.extend(more.iter().map(|key| {
            Diagnostic::new(Problem::InvalidJob, "the tooth thickness is given more than once")
                .field(format!("gear.{key}"))
                .value(given.join(", "))
                .allowed(allowed)
                .way_out("keep the one that the drawing gives")
        })),
    }
}

fn allowances(gear: &Gear, findings: &mut Vec<Diagnostic>) {
    let Some(given) = gear.allowances_um.filter(|given| given.lower > given.upper) else { return };
    findings.push(
        Diagnostic::new(Problem::InvalidJob, "the lower allowance lies above the upper one")
            .field("gear.allowances_um.lower")
            .value(shown_number(given.lower))
            .allowed(format!("up to {}, the upper allowance", shown_number(given.upper)))
            .way_out("exchange both, with their signs: -90 lies below -50"),
    );
}

/// Diameters in the order in which they must grow from the tooth root towards its tip.
fn diameters(gear: &Gear, findings: &mut Vec<Diagnostic>) {
    let start = gear.evaluation.and_then(|e| e.start_diameter);
    let form = match (gear.form_diameter, start) {
        (Some(form), _) => ("form_diameter", form),
        (None, Some(start)) => ("evaluation.start_diameter", start),
        (None, None) => {
            findings.push(
                Diagnostic::new(Problem::MissingKey, "`gear` does not say where the involute begins")
                    .field("gear.form_diameter")
                    .allowed("form_diameter, or evaluation = { start_diameter = .. }")
                    .way_out("add the root form diameter of the drawing in mm"),
            );
            return;
        }
    };
    let internal = gear.teeth < 0;
    let order = if internal {
        "internal gear: root diameter >= form diameter > tip diameter"
    } else {
        "root diameter <= form diameter < tip diameter"
    };
    // Towards the tip diameters grow, in internal gears they shrink.
    let outwards = if internal { -1.0 } else { 1.0 };
    let (root, tip) = (gear.root_diameter, gear.tip_diameter);
    let mut refuse = |key: &str, value: f64, message: String| {
        findings.push(
            Diagnostic::new(Problem::InvalidGeometry, message)
                .field(format!("gear.{key}"))
                .value(shown_number(value))
                .allowed(order)
                .way_out("compare the diameters with the drawing"),
        );
    };
    if outwards * (tip - root) <= 0.0 {
        refuse(
            "tip_diameter",
            tip,
            format!("the tip diameter {tip} does not lie outside the root diameter {root}"),
        );
        return;
    }
    let (key, value) = form;
    if outwards * (value - root) < 0.0 {
        refuse(key, value, format!("the involute begins at {value}, below the root diameter {root}"));
    } else if outwards * (tip - value) <= 0.0 {
        refuse(key, value, format!("the involute begins at {value}, not before the tip diameter {tip}"));
    }
}

fn evaluation(gear: &Gear, findings: &mut Vec<Diagnostic>) {
    let range = gear.evaluation_range();
    let form = gear.root_form_diameter();
    let outwards = if gear.teeth < 0 { -1.0 } else { 1.0 };
    let half = gear.face_width / 2.0;
    let mut refuse = |key: &str, value: f64, message: String, allowed: String, way_out: &str| {
        findings.push(
            Diagnostic::new(Problem::InvalidGeometry, message)
                .field(format!("gear.evaluation.{key}"))
                .value(shown_number(value))
                .allowed(allowed)
                .way_out(way_out),
        );
    };
    let diameters = format!("from the form diameter {form} to the tip diameter {}", gear.tip_diameter);
    let (start, end) = (range.start_diameter, range.end_diameter);
    if outwards * (start - form) < 0.0 {
        refuse(
            "start_diameter",
            start,
            format!("the evaluation begins at {start}, below the involute"),
            diameters,
            "leave `start_diameter` out to begin at the form diameter",
        );
    } else if outwards * (gear.tip_diameter - end) < 0.0 {
        refuse(
            "end_diameter",
            end,
            format!("the evaluation ends at {end}, beyond the tip"),
            diameters,
            "leave `end_diameter` out to end at the tip diameter",
        );
    } else if outwards * (end - start) <= 0.0 {
        refuse(
            "end_diameter",
            end,
            format!("the evaluation ends at {end}, not beyond its start {start}"),
            diameters,
            "exchange start and end",
        );
    }
    let faces = format!("from {} to {} (z = 0 is the middle of the face width)", -half, half);
    // A face given as decimal and half a face width computed may differ in the last digit.
    let slack = 1e-9 * gear.face_width;
    let (lower, upper) = (range.z_start, range.z_end);
    if lower < -half - slack || lower > half {
        refuse(
            "z_start",
            lower,
            format!("the evaluation begins at z = {lower}, outside the face width"),
            faces.clone(),
            "leave `z_start` out to begin at the lower face",
        );
    }
    if upper > half + slack || upper < -half {
        refuse(
            "z_end",
            upper,
            format!("the evaluation ends at z = {upper}, outside the face width"),
            faces.clone(),
            "leave `z_end` out to end at the upper face",
        );
    }
    if upper <= lower {
        refuse(
            "z_end",
            upper,
            format!("the evaluation ends at z = {upper}, not above its start z = {lower}"),
            faces,
            "exchange `z_start` and `z_end`",
        );
    }
}
