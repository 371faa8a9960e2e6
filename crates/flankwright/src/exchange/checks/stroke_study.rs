//! Contradictions in `[explore.dressing.strokes]` and `[explore.dressing.deviations]`.

use crate::exchange::diagnostic::{Diagnostic, Problem};
use crate::exchange::job::{DressingStudy, StrokeStudy, StudyOver};
use crate::exchange::node::shown_number;

/// The tables stand with their abscissa and nowhere else; what they hold fits together.
pub(super) fn check(study: &DressingStudy, findings: &mut Vec<Diagnostic>) {
    let over = study.over;
    for (key, given, use_) in [
        ("strokes", study.strokes.is_some(), StudyOver::Strokes),
        ("deviations", study.deviations.is_some(), StudyOver::Deviations),
    ] {
        let field = format!("explore.dressing.{key}");
        if given && over != use_ {
            let text = format!("a study over \"{}\" does not use `{key}`", over.name());
            findings.push(
                Diagnostic::new(Problem::InvalidJob, text)
                    .field(field)
                    .value("a table")
                    .allowed(format!("no table, or over = \"{}\"", use_.name()))
                    .way_out("remove it, or change `over`"),
            );
        } else if !given && over == use_ {
            let text = format!("a study over \"{}\" needs the table `{key}`", over.name());
            findings.push(
                Diagnostic::new(Problem::MissingKey, text)
                    .field(field)
                    .allowed("a table")
                    .way_out("add it; examples/dressing shows how"),
            );
        }
    }
    if let Some(strokes) = &study.strokes {
        check_strokes(strokes, findings);
    }
    if study.deviations.is_some_and(|d| d.values() == [0.0; 4]) {
        findings.push(
            Diagnostic::new(Problem::InvalidJob, "no axis deviates")
                .field("explore.dressing.deviations")
                .value("0 for all axes")
                .allowed("one or more of d_phi_S_deg, d_gamma_deg, d_d_mm, d_v_yA_mm above 0")
                .way_out("give the deviation of an axis, e.g. d_d_mm = 0.01"),
        );
    }
}

fn check_strokes(strokes: &StrokeStudy, findings: &mut Vec<Diagnostic>) {
    let mut ascending = |field: String, from: f64, to: f64| {
        if to <= from {
            findings.push(
                Diagnostic::new(Problem::InvalidJob, "a part of the profile ends before it begins")
                    .field(field)
                    .value(shown_number(to))
                    .allowed(format!("> {}", shown_number(from)))
                    .way_out("give the shares in ascending order"),
            );
        }
    };
    for (k, area) in strokes.areas.iter().enumerate() {
        ascending(format!("explore.dressing.strokes.areas[{k}].to"), area.from, area.to);
    }
    let mut start = 0.0;
    for (k, section) in strokes.sections.iter().enumerate() {
        ascending(format!("explore.dressing.strokes.sections[{k}].to"), start, section.to);
        start = section.to;
    }
    let last = strokes.sections.len().saturating_sub(1);
    if start != 1.0 {
        findings.push(
            Diagnostic::new(Problem::InvalidJob, "the sections do not end with the profile")
                .field(format!("explore.dressing.strokes.sections[{last}].to"))
                .value(shown_number(start))
                .allowed("1")
                .way_out("let the last section end at 1.0"),
        );
    }
    for (k, section) in strokes.sections.iter().enumerate() {
        if section.area > strokes.areas.len() {
            findings.push(
                Diagnostic::new(Problem::InvalidJob, "there is no such active area")
                    .field(format!("explore.dressing.strokes.sections[{k}].area"))
                    .value(section.area.to_string())
                    .allowed(format!("1 to {}", strokes.areas.len()))
                    .way_out("give the number of an entry of `areas`, or add one"),
            );
        }
    }
}
