//! Contradictions in `[dressing.strokes]`, `dresser.others` and `[settings.strokes]`.

use super::profile_parts;
use crate::job::{
    Dresser, DresserContact, DresserModification, DressingFlanks, Job, ProfileCrowningBy, StrokeSettings,
    Strokes,
};
use job::checks::{contradiction, dresser_diameters, not_yet};
use job::{Diagnostic, Problem, shown_number};

const STROKES: &str = "dressing.strokes";

/// Sections and areas fit together, and to the dressers that there are.
pub(super) fn check(job: &Job, findings: &mut Vec<Diagnostic>) {
    if let Some(dresser) = &job.dresser {
        others(job, dresser, findings);
        if let Some(strokes) = &job.dressing.strokes {
            parts(strokes, 1 + dresser.others.len(), findings);
            beside(job, dresser, findings);
        }
    }
    if job.catalogue.is_some() && job.dressing.strokes.is_some() {
        findings.push(
            not_yet(STROKES, "dressing in strokes with a dresser from a catalogue")
                .value("a table")
                .allowed("no key, or tables [worm] and [dresser]")
                .way_out("give worm and dresser in the job, or leave `strokes` out"),
        );
    }
    settings(job, findings);
}

/// Further dressers are there for strokes, and exist.
fn others(job: &Job, dresser: &Dresser, findings: &mut Vec<Diagnostic>) {
    if dresser.others.is_empty() {
        return;
    }
    if job.dressing.strokes.is_none() {
        findings.push(
            Diagnostic::new(Problem::InvalidJob, "further dressers are given, but no stroke uses them")
                .field("dresser.others")
                .value(format!("{} entries", dresser.others.len()))
                .allowed("no key, or a table [dressing.strokes]")
                .way_out("leave `others` out, or say in [dressing.strokes] which dresser dresses what"),
        );
    }
    for (k, other) in dresser.others.iter().enumerate() {
        let at = format!("dresser.others[{k}]");
        dresser_diameters(&at, other.pitch_diameter, other.tip_diameter, findings);
    }
}

/// Areas and sections are parts of the profile, and every number names something that there is.
fn parts(strokes: &Strokes, dressers: usize, findings: &mut Vec<Diagnostic>) {
    let areas: Vec<[f64; 2]> = strokes.areas.iter().map(|area| [area.from, area.to]).collect();
    // One place of the face is enough to find what is wrong.
    for q in [0.0, -1.0, 1.0, -0.5, 0.5] {
        let before = findings.len();
        let sections: Vec<(f64, usize)> =
            strokes.sections.iter().map(|s| (s.to.law(1.0).value(q), s.area)).collect();
        profile_parts::check(STROKES, &areas, &sections, findings);
        if findings.len() > before {
            break;
        }
    }
    for (k, area) in strokes.areas.iter().enumerate() {
        if area.dresser > dressers {
            findings.push(no_dresser(format!("{STROKES}.areas[{k}].dresser"), area.dresser, dressers));
        }
    }
}

fn no_dresser(field: String, number: usize, dressers: usize) -> Diagnostic {
    Diagnostic::new(Problem::InvalidJob, "there is no such dresser")
        .field(field)
        .value(number.to_string())
        .allowed(if dressers == 1 { "1".to_owned() } else { format!("1 to {dressers}") })
        .way_out("give 1 for [dresser], from 2 on the entries of `dresser.others`, or add one there")
}

/// What cannot stand beside strokes.
fn beside(job: &Job, dresser: &Dresser, findings: &mut Vec<Diagnostic>) {
    let mut refuse = |message: &str, field: String, value: String, allowed: &str, way_out: &str| {
        findings.push(contradiction(message, field, value, allowed, way_out));
    };
    let modifications = std::iter::once(("dresser.modification".to_owned(), &dresser.modification));
    let further = dresser.others.iter().enumerate();
    let further = further.map(|(k, d)| (format!("dresser.others[{k}].modification"), &d.modification));
    for (field, modification) in modifications.chain(further) {
        if modification.given().is_none() {
            refuse(
                "the corrections of the strokes make the profile of the target; their dressers exist",
                field.clone(),
                "\"target\"".into(),
                "\"none\", or a table { kind = .. } of the modification that the dresser carries",
                "say what profile the dresser has: modification = \"none\" for a plain one",
            );
        }
        for (i, entry) in modification.given().unwrap_or_default().iter().enumerate() {
            // The first dresser is looked at with or without strokes.
            if field != "dresser.modification" && !super::tool::of_profile(entry) {
                let place = match modification {
                    DresserModification::Sum(_) => format!("{field}[{i}].kind"),
                    _ => format!("{field}.kind"),
                };
                refuse(
                    "a dresser carries a profile only, the same all round",
                    place,
                    format!("{:?}", entry.kind()),
                    super::tool::OF_PROFILE,
                    "use a profile kind, e.g. \"profile_crowning\"",
                );
            }
        }
    }
    if dresser.designed_for.is_some() {
        refuse(
            "the dressers of strokes are made for the worm of the job",
            "dresser.designed_for".into(),
            "a table".into(),
            "no key, or no [dressing.strokes]",
            "leave `designed_for` out, or dress in one stroke",
        );
    }
    let dressing = &job.dressing;
    if dresser.contact == DresserContact::Point {
        refuse(
            "a disc in point contact writes lines and has no active areas",
            "dresser.contact".into(),
            "\"point\"".into(),
            "\"line\", or no [dressing.strokes]",
            "leave `contact` out, or leave [dressing.strokes] out",
        );
    }
    if dressing.gear_root.is_some() {
        refuse(
            "the head of a dresser and strokes are not planned together",
            "dressing.gear_root".into(),
            "a table".into(),
            "no key, or no [dressing.strokes]",
            "leave `gear_root` out, or dress in one stroke",
        );
    }
    if dressing.flanks == DressingFlanks::Two {
        refuse(
            "strokes have motions of their own on each flank",
            "dressing.flanks".into(),
            "\"two\"".into(),
            "\"one\", or no [dressing.strokes]",
            "dress one flank after the other: dressing.flanks = \"one\"",
        );
    }
    if !dressing.has_usual_conditions() {
        refuse(
            "every stroke meets three points of its section and lays the end of its area on the end of the section",
            "dressing.conditions".into(),
            "given beside [dressing.strokes]".into(),
            "no conditions and no degrees_of_freedom, or no [dressing.strokes]",
            "leave `conditions` and `degrees_of_freedom` out",
        );
    }
    if dressing.profile_crowning_by != ProfileCrowningBy::Auto {
        refuse(
            "in strokes the corrections make the whole profile",
            "dressing.profile_crowning_by".into(),
            format!("{:?}", dressing.profile_crowning_by).to_lowercase(),
            "\"auto\", or no [dressing.strokes]",
            "leave `profile_crowning_by` out",
        );
    }
    if job.worm.cone_angle_deg != 0.0 {
        findings.push(
            not_yet(STROKES, "dressing a conical worm in strokes")
                .value("a table")
                .allowed("no key, or worm.cone_angle_deg = 0")
                .way_out("take a cylindrical worm, or dress in one stroke"),
        );
    }
}

/// The strokes of the settings belong to those of the dressing.
fn settings(job: &Job, findings: &mut Vec<Diagnostic>) {
    let Some(settings) = &job.settings else { return };
    let dressers = 1 + job.dresser.as_ref().map_or(0, |dresser| dresser.others.len());
    if job.dressing.strokes.is_none() && !settings.strokes.is_empty() {
        findings.push(
            Diagnostic::new(
                Problem::InvalidJob,
                "settings of strokes are given, but the worm is dressed in one",
            )
            .field("settings.strokes")
            .value("a table")
            .allowed("no key, or a table [dressing.strokes]")
            .way_out("remove them, or add [dressing.strokes]"),
        );
    }
    if job.dressing.strokes.is_some() {
        for (flank, given) in [("left", &settings.left), ("right", &settings.right)] {
            if given.is_some() {
                findings.push(
                    Diagnostic::new(
                        Problem::InvalidJob,
                        "one motion is given for a flank that is dressed in strokes",
                    )
                    .field(format!("settings.{flank}"))
                    .value("a table")
                    .allowed(format!("settings.strokes.{flank}"))
                    .way_out("plan the job again, or leave [dressing.strokes] out"),
                );
            }
        }
    }
    for (flank, strokes) in [("left", &settings.strokes.left), ("right", &settings.strokes.right)] {
        for (k, stroke) in strokes.iter().enumerate() {
            let place = format!("settings.strokes.{flank}[{k}]");
            if stroke.dresser > dressers {
                findings.push(no_dresser(format!("{place}.dresser"), stroke.dresser, dressers));
            }
            lengths(&place, stroke, findings);
        }
    }
}

/// Areas, ranges and strokes with a length; an area that touches with all of itself.
fn lengths(place: &str, stroke: &StrokeSettings, findings: &mut Vec<Diagnostic>) {
    let mut refuse = |key: &str, value: f64, allowed: String| {
        findings.push(
            Diagnostic::new(Problem::InvalidJob, "a stroke whose numbers do not fit together")
                .field(format!("{place}.{key}"))
                .value(shown_number(value))
                .allowed(allowed)
                .way_out("plan the job again"),
        );
    };
    let StrokeSettings { area_mm, touching_mm, range_mm, v_from_mm, v_to_mm, .. } = stroke;
    for (key, [from, to]) in [("area_mm", area_mm), ("range_mm", range_mm)] {
        if *from <= 0.0 {
            refuse(&format!("{key}[0]"), *from, "> 0".into());
        } else if to <= from {
            refuse(&format!("{key}[1]"), *to, format!("> {}", shown_number(*from)));
        }
    }
    if touching_mm[0] > area_mm[0] {
        refuse("touching_mm[0]", touching_mm[0], format!("<= {}", shown_number(area_mm[0])));
    }
    if touching_mm[1] < area_mm[1] {
        refuse("touching_mm[1]", touching_mm[1], format!(">= {}", shown_number(area_mm[1])));
    }
    if v_to_mm <= v_from_mm {
        refuse("v_to_mm", *v_to_mm, format!("> v_from_mm = {}", shown_number(*v_from_mm)));
    }
}
