//! Contradictions between entries of a job that are each in range. Knows the job, no geometry beyond the order
//! of diameters.

mod catalogue;
mod explore;
mod gear_root;
mod grinding;
mod profile_parts;
mod stroke_study;
mod strokes;
mod tool;

use super::diagnostic::{Diagnostic, Problem};
use super::job::{Gear, Job};
use super::node::shown_number;

/// All contradictions in a job; without places, which the caller knows.
pub(super) fn check(job: &Job) -> Vec<Diagnostic> {
    let mut findings = Vec::new();
    name(job, &mut findings);
    thickness(&job.gear, &mut findings);
    diameters(&job.gear, &mut findings);
    evaluation(&job.gear, &mut findings);
    target(job, &mut findings);
    catalogue::check(job, &mut findings);
    // Without a worm there is nothing to say about it.
    if !job.worm.is_absent() {
        tool::check(job, &mut findings);
        gear_root::check(job, &mut findings);
    }
    strokes::check(job, &mut findings);
    grinding::check(job, &mut findings);
    explore::check(job, &mut findings);
    settings(job, &mut findings);
    grid(job, &mut findings);
    findings
}

/// Entries that are each in range and contradict each other.
fn contradiction(
    message: &str,
    field: impl Into<Box<str>>,
    value: String,
    allowed: &str,
    way_out: &str,
) -> Diagnostic {
    Diagnostic::new(Problem::InvalidJob, message).field(field).value(value).allowed(allowed).way_out(way_out)
}

/// Result points per flank: a finer grid shows nothing more and takes minutes.
const MOST_POINTS: usize = 40_401;

fn grid(job: &Job, findings: &mut Vec<Diagnostic>) {
    let points = job.grid.profile_points * job.grid.helix_points;
    if points > MOST_POINTS {
        findings.push(
            Diagnostic::new(Problem::InvalidJob, format!("the result grid has {points} points per flank"))
                .field("grid.profile_points")
                .value(job.grid.profile_points)
                .allowed(format!("profile_points x helix_points up to {MOST_POINTS} (201 x 201)"))
                .way_out("use a coarser grid, e.g. 41 x 41"),
        );
    }
}

/// Largest coefficient of a setting in its own unit: beyond it no machine follows.
const LARGEST_COEFFICIENT: f64 = 1e6;

/// Strokes that have a length, coefficients that no machine exceeds.
fn settings(job: &Job, findings: &mut Vec<Diagnostic>) {
    let Some(settings) = &job.settings else { return };
    let mut lists = vec![
        ("delta_d_um".to_owned(), &settings.delta_d_um),
        ("delta_phi_2_urad".to_owned(), &settings.delta_phi_2_urad),
    ];
    for (flank, given) in [("left", &settings.left), ("right", &settings.right)] {
        let Some(s) = given else { continue };
        for (key, list) in [
            ("d_phi_S_deg", &s.d_phi_s_deg),
            ("d_gamma_deg", &s.d_gamma_deg),
            ("d_d_mm", &s.d_d_mm),
            ("d_v_yA_mm", &s.d_v_ya_mm),
            ("profile_um", &s.profile_um),
        ] {
            lists.push((format!("{flank}.{key}"), list));
        }
    }
    let tables = &settings.strokes;
    for (flank, strokes) in [("left", &tables.left), ("right", &tables.right)] {
        for (k, s) in strokes.iter().enumerate() {
            for (key, list) in [
                ("d_phi_S_deg", &s.d_phi_s_deg),
                ("d_gamma_deg", &s.d_gamma_deg),
                ("d_d_mm", &s.d_d_mm),
                ("d_v_yA_mm", &s.d_v_ya_mm),
            ] {
                lists.push((format!("strokes.{flank}[{k}].{key}"), list));
            }
        }
    }
    for (key, list) in lists {
        for (i, c) in list.iter().enumerate().filter(|(_, c)| c.abs() > LARGEST_COEFFICIENT) {
            findings.push(
                Diagnostic::new(Problem::InvalidNumber, "a coefficient that no machine follows")
                    .field(format!("settings.{key}[{i}]"))
                    .value(shown_number(*c))
                    .allowed(format!("-{LARGEST_COEFFICIENT:e} to {LARGEST_COEFFICIENT:e}"))
                    .way_out("check the unit of the coefficient"),
            );
        }
    }
    for (flank, given) in [("left", &settings.left), ("right", &settings.right)] {
        let Some(given) = given else { continue };
        if given.v_to_mm <= given.v_from_mm {
            findings.push(
                Diagnostic::new(Problem::InvalidJob, "the dressing stroke has no length")
                    .field(format!("settings.{flank}.v_to_mm"))
                    .value(shown_number(given.v_to_mm))
                    .allowed(format!("> v_from_mm = {}", shown_number(given.v_from_mm)))
                    .way_out("give the stroke from its smaller to its larger worm position"),
            );
        }
    }
}

fn name(job: &Job, findings: &mut Vec<Diagnostic>) {
    let name = &job.job.name;
    let plain = |c: char| c.is_alphanumeric() || matches!(c, '-' | '_' | '.' | ' ');
    // The name becomes a directory: nothing that leads elsewhere or that a file system trims.
    if !name.chars().all(plain) || name.starts_with(['.', ' ']) || name.ends_with(['.', ' ']) {
        findings.push(
            Diagnostic::new(Problem::InvalidJob, "the name of the job cannot name a directory")
                .field("job.name")
                .value(format!("{name:?}"))
                .allowed("letters, digits, `-`, `_`, and inside also `.` and spaces")
                .way_out("choose a plain name such as \"twist-free-crowning\""),
        );
    }
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

fn target(job: &Job, findings: &mut Vec<Diagnostic>) {
    let allowed = "either `modifications = [ ... ]` or `file = \"grid.csv\"`";
    match (&job.target.modifications, &job.target.file) {
        (None, None) => findings.push(
            Diagnostic::new(Problem::MissingKey, "`target` does not say which flank is wanted")
                .field("target.modifications")
                .allowed(allowed)
                .way_out("add `modifications`; an empty list asks for the pure involute"),
        ),
        (Some(_), Some(file)) => findings.push(
            Diagnostic::new(Problem::InvalidJob, "the target is given twice")
                .field("target.file")
                .value(format!("{file:?}"))
                .allowed(allowed)
                .way_out("keep one of them; a grid can also be an entry of the list (kind = \"grid\")"),
        ),
        _ => {}
    }
}

fn not_yet(field: &str, what: &str) -> Diagnostic {
    Diagnostic::new(
        Problem::NotYetSupported,
        format!("{what}: part of the job format, but not yet supported"),
    )
    .field(field)
}
