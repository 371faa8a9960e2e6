//! Active areas of a dresser and sections of a profile, given by shares: wherever a job names them.

use job::{Diagnostic, Problem, shown_number};

/// Areas and sections have a length, the sections end with the profile, and every section names an area that there is. `areas`
/// are [from, to], `sections` their ends with the number of their area; `table` is the key of the table that holds both lists.
pub(super) fn check(
    table: &str,
    areas: &[[f64; 2]],
    sections: &[(f64, usize)],
    findings: &mut Vec<Diagnostic>,
) {
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
    for (k, [from, to]) in areas.iter().enumerate() {
        ascending(format!("{table}.areas[{k}].to"), *from, *to);
    }
    let mut start = 0.0;
    for (k, (to, _)) in sections.iter().enumerate() {
        ascending(format!("{table}.sections[{k}].to"), start, *to);
        start = *to;
    }
    if start != 1.0 {
        let last = sections.len().saturating_sub(1);
        findings.push(
            Diagnostic::new(Problem::InvalidJob, "the sections do not end with the profile")
                .field(format!("{table}.sections[{last}].to"))
                .value(shown_number(start))
                .allowed("1")
                .way_out("let the last section end at 1.0"),
        );
    }
    for (k, (_, area)) in sections.iter().enumerate() {
        if *area > areas.len() {
            findings.push(
                Diagnostic::new(Problem::InvalidJob, "there is no such active area")
                    .field(format!("{table}.sections[{k}].area"))
                    .value(area.to_string())
                    .allowed(format!("1 to {}", areas.len()))
                    .way_out("give the number of an entry of `areas`, or add one"),
            );
        }
    }
}
