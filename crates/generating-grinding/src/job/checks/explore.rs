//! Contradictions in `[explore]`.

use super::stroke_study;
use crate::job::{DressingStudy, Explore, Job, Steps, StudyOver, Tool};
use job::{Diagnostic, Problem, shown_number};

pub(super) fn check(job: &Job, findings: &mut Vec<Diagnostic>) {
    let Some(explore) = &job.explore else { return };
    if *explore == Explore::default() {
        findings.push(
            Diagnostic::new(Problem::MissingKey, "`explore` does not say what varies")
                .field("explore.diagonal_ratio")
                .allowed(
                    "one or more of diagonal_ratio, worm_cone_angle_deg, crossed_axes_angle_deg; or dressing, worm_life or catalogue",
                )
                .way_out("add one, e.g. diagonal_ratio = { from = -3.0, to = 3.0, count = 61 }"),
        );
    }
    for (key, steps) in [
        ("diagonal_ratio", explore.diagonal_ratio),
        ("worm_cone_angle_deg", explore.worm_cone_angle_deg),
        ("crossed_axes_angle_deg", explore.crossed_axes_angle_deg),
    ] {
        ascending(key, steps, findings);
    }
    if explore.worm_life.is_some() {
        worm_life(job, explore, findings);
    }
    if let Some(study) = &explore.dressing {
        if (Explore { dressing: None, ..explore.clone() }) != Explore::default() {
            findings.push(
                Diagnostic::new(Problem::InvalidJob, "a study of dressing stands alone")
                    .field("explore.dressing")
                    .value("beside other keys")
                    .allowed(
                        "either `dressing` or diagonal_ratio, worm_cone_angle_deg, crossed_axes_angle_deg",
                    )
                    .way_out("make two jobs of it"),
            );
        }
        dressing(study, findings);
        stroke_study::check(study, findings);
        if job.dresser.as_ref().is_some_and(|d| d.designed_for.is_some()) {
            findings.push(
                Diagnostic::new(
                    Problem::InvalidJob,
                    "a study of dressing looks at the dresser that is made for `[worm]`, and puts that one on other worms",
                )
                .field("dresser.designed_for")
                .value("a table")
                .allowed("no key beside explore.dressing")
                .way_out("describe the worm that the dresser was designed for in `[worm]`"),
            );
        }
        if job.point_dresser().is_some() {
            findings.push(
                Diagnostic::new(
                    Problem::InvalidJob,
                    "a study of dressing looks at corrections of a disc in line contact; a disc in point contact has none",
                )
                .field("dresser.contact")
                .value("\"point\"")
                .allowed("\"line\" beside explore.dressing")
                .way_out("leave `contact` out, or plan the job"),
            );
        }
        if job.worm.tool != Tool::Dressed {
            findings.push(
                Diagnostic::new(Problem::InvalidJob, "a tool that is not dressed has no study of dressing")
                    .field("explore.dressing")
                    .value(format!("beside worm.tool = \"{}\"", job.worm.tool.name()))
                    .allowed("worm.tool = \"dressed\"")
                    .way_out("leave `worm.tool` out and describe the `[dresser]`"),
            );
        }
    }
}

/// A worm over its life: a cylindrical one, dressed anew in one stroke by a dresser that is the same for all its diameters.
fn worm_life(job: &Job, explore: &Explore, findings: &mut Vec<Diagnostic>) {
    let mut refuse =
        |field: &str, value: String, text: &'static str, allowed: &'static str, way_out: &'static str| {
            findings.push(
                Diagnostic::new(Problem::InvalidJob, text)
                    .field(field)
                    .value(value)
                    .allowed(allowed)
                    .way_out(way_out),
            );
        };
    if (Explore { worm_life: None, ..explore.clone() }) != Explore::default() {
        refuse(
            "explore.worm_life",
            "beside other keys".into(),
            "a study of the worm's life stands alone",
            "worm_life, or the other keys of [explore]",
            "make two jobs of it",
        );
    }
    if job.worm.tool != Tool::Dressed || job.dresser.is_none() || job.point_dresser().is_some() {
        refuse(
            "explore.worm_life",
            "without a disc in line contact".into(),
            "over its life a worm is dressed by one disc in line contact; this one is not",
            "worm.tool = \"dressed\" and a [dresser] with contact = \"line\"",
            "describe the disc in [dresser], or leave worm_life out",
        );
    }
    let cone = job.worm.cone_angle_deg;
    if cone != 0.0 {
        refuse(
            "worm.cone_angle_deg",
            shown_number(cone),
            "the life of a conical worm is not followed",
            "0 beside explore.worm_life",
            "leave worm_life out",
        );
    }
    if job.dressing.strokes.is_some() {
        refuse(
            "dressing.strokes",
            "a table".into(),
            "over its life a worm is dressed in one stroke of each flank",
            "no strokes beside explore.worm_life",
            "leave `strokes` out",
        );
    }
    if !job.dressing.has_usual_conditions() {
        refuse(
            "dressing.conditions",
            format!("{} conditions", job.dressing.rows()),
            "the dresser of the new worm is settled on a smaller one by three points and the radius map",
            "no conditions and no degrees_of_freedom beside explore.worm_life",
            "leave `conditions` and `degrees_of_freedom` out",
        );
    }
}

/// Refuses steps of `explore` whose values do not ascend.
pub fn ascending(key: &str, steps: Option<Steps>, findings: &mut Vec<Diagnostic>) {
    let Some(steps) = steps.filter(|steps| steps.to <= steps.from) else { return };
    findings.push(
        Diagnostic::new(Problem::InvalidJob, format!("the values of `{key}` do not ascend"))
            .field(format!("explore.{key}.to"))
            .value(shown_number(steps.to))
            .allowed(format!("> from = {}", shown_number(steps.from)))
            .way_out("give the smaller value as `from`"),
    );
}

/// Each abscissa has keys of its own.
fn dressing(study: &DressingStudy, findings: &mut Vec<Diagnostic>) {
    let over = study.over;
    let keys = [
        ("crowning_um", study.crowning_um, [StudyOver::Crowning, StudyOver::Profile]),
        ("worm_pitch_diameter", study.worm_pitch_diameter, [StudyOver::WormDiameter; 2]),
        ("normal_pressure_angle_deg", study.normal_pressure_angle_deg, [StudyOver::PressureAngle; 2]),
    ];
    for (key, steps, uses) in keys {
        ascending(&format!("dressing.{key}"), steps, findings);
        let field = format!("explore.dressing.{key}");
        if steps.is_some() && !uses.contains(&over) {
            findings.push(
                Diagnostic::new(
                    Problem::InvalidJob,
                    format!("a study over \"{}\" does not use `{key}`", over.name()),
                )
                .field(field)
                .value("a table")
                .allowed("no key, or another `over`")
                .way_out("remove it, or change `over`"),
            );
        } else if steps.is_none() && uses.contains(&over) && over != StudyOver::Crowning {
            findings.push(
                Diagnostic::new(
                    Problem::MissingKey,
                    format!("a study over \"{}\" needs `{key}`", over.name()),
                )
                .field(field)
                .allowed("{ from = .., to = .., count = .. }")
                .way_out("add the values, e.g. { from = .., to = .., count = 21 }"),
            );
        }
    }
    if let Some(diameter) = study.at_worm_pitch_diameter
        && over != StudyOver::PressureAngle
    {
        findings.push(
            Diagnostic::new(
                Problem::InvalidJob,
                format!("a study over \"{}\" does not use `at_worm_pitch_diameter`", over.name()),
            )
            .field("explore.dressing.at_worm_pitch_diameter")
            .value(shown_number(diameter))
            .allowed("no key, or over = \"pressure-angle\"")
            .way_out("remove it, or change `over`"),
        );
    }
    if let Some(compare) = &study.compare {
        let given = compare.given();
        if given.len() != 1 {
            findings.push(
                Diagnostic::new(Problem::InvalidJob, format!("`compare` has {} keys", given.len()))
                    .field("explore.dressing.compare")
                    .value(given.join(", "))
                    .allowed("exactly one of threads, worm_pitch_diameter, dresser_tip_diameter, normal_pressure_angle_deg")
                    .way_out("keep one; the others are studies of their own"),
            );
        }
        let same = match over {
            StudyOver::WormDiameter => Some("worm_pitch_diameter"),
            StudyOver::PressureAngle => Some("normal_pressure_angle_deg"),
            StudyOver::Crowning | StudyOver::Profile | StudyOver::Strokes | StudyOver::Deviations => None,
        };
        if same.is_some_and(|key| given.contains(&key)) {
            findings.push(
                Diagnostic::new(Problem::InvalidJob, "the abscissa and the curves are the same quantity")
                    .field("explore.dressing.compare")
                    .value(given.join(", "))
                    .allowed("another quantity than the abscissa")
                    .way_out("compare e.g. threads"),
            );
        }
    }
}
