//! Contradictions in `[explore.dressing.strokes]` and `[explore.dressing.deviations]`.

use super::profile_parts;
use crate::job::{DressingStudy, StrokeStudy, StudyOver};
use job::{Diagnostic, Problem};

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
    let areas: Vec<[f64; 2]> = strokes.areas.iter().map(|area| [area.from, area.to]).collect();
    let sections: Vec<(f64, usize)> = strokes.sections.iter().map(|s| (s.to, s.area)).collect();
    profile_parts::check("explore.dressing.strokes", &areas, &sections, findings);
}
