//! Records of one tool in their order: time goes on, workpieces are counted on until the tool is resharpened.

use super::line::Line;
use std::collections::HashMap;

use job::Diagnostic;

/// Code of records that contradict each other.
pub(super) const CODE: &str = "invalid-history";

/// All contradictions between a tool's record and the one before it.
pub(super) fn check(lines: &[Line]) -> Vec<Diagnostic> {
    let mut last: HashMap<&str, &Line> = HashMap::new();
    let mut findings = Vec::new();
    for line in lines {
        if let Some(before) = last.insert(&line.record.tool, line) {
            findings.extend(after(before, line));
        }
    }
    findings
}

fn after(before: &Line, line: &Line) -> Option<Diagnostic> {
    let (old, new) = (&before.record, &line.record);
    let finding = |field: &str, message: String| {
        Diagnostic::with_code(CODE, message).field(field).span(Some(line.span(field)))
    };
    if line.moment <= before.moment {
        let message = if line.moment == before.moment {
            format!("the tool `{}` has two measurements of the time {}", new.tool, new.time)
        } else {
            format!("the measurement of the tool `{}` comes after one of {}", new.tool, old.time)
        };
        return Some(
            finding("time", message)
                .value(&new.time)
                .allowed(format!("later than {}", old.time))
                .way_out("put the lines in the order of their times, each time once"),
        );
    }
    if new.resharpened < old.resharpened {
        let message =
            format!("the tool `{}` had been resharpened {} times before", new.tool, old.resharpened);
        return Some(
            finding("resharpened", message)
                .value(new.resharpened)
                .allowed(format!(">= {}", old.resharpened))
                .way_out("count every resharpening of the tool, or give a new tool a name of its own"),
        );
    }
    if new.resharpened == old.resharpened && new.parts < old.parts {
        let message = format!("the tool `{}` had cut {} workpieces before", new.tool, old.parts);
        return Some(
            finding("parts", message)
                .value(new.parts)
                .allowed(format!(">= {}, or a higher `resharpened`", old.parts))
                .way_out("raise `resharpened` if the tool was ground again, else correct the count"),
        );
    }
    None
}
