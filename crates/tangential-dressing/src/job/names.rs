//! Names of variables in a document, before there is a typed job: a wrong one is reported with its place and the nearest name.
//! Knows which keys hold such names, and nothing else of the job.

use super::channel::Channel;
use super::variable::{Variable, VariableError};
use job::shape::shortened;
use job::{Diagnostic, JobError, Kind, Node, Problem};

/// All findings about names; values of another type than a name are reported by the check of the shape.
pub(crate) fn variable_names(root: &Node) -> Vec<Diagnostic> {
    let mut findings = Vec::new();
    if let Some((Node { kind: Kind::List(items), .. }, _)) = root.follow("dressing.variables") {
        for (i, item) in items.iter().enumerate() {
            // Each finding looks through all names; a long list of wrong ones is told by its beginning.
            if findings.len() >= JobError::MAXIMUM_FINDINGS {
                break;
            }
            let Kind::Text(name) = &item.kind else { continue };
            let Err(error) = name.parse::<Variable>() else { continue };
            findings.push(
                refused(Problem::UnknownValue, &error)
                    .field(format!("dressing.variables[{i}]"))
                    .value(item.shown())
                    .span(Some(item.span.clone())),
            );
        }
    }
    for table in ["both", "left", "right"] {
        let place = format!("settings.{table}.values");
        let Some((Node { kind: Kind::Table(entries), .. }, _)) = root.follow(&place) else { continue };
        for entry in entries {
            if findings.len() >= JobError::MAXIMUM_FINDINGS {
                break;
            }
            let finding = match entry.key.parse::<Variable>() {
                Ok(variable) if variable.channel() == Channel::ShiftRatio => {
                    Diagnostic::new(Problem::UnknownKey, "the shift ratio stands beside `values`, not in it")
                        .allowed(NAMES)
                        .way_out(format!("write it as `kap = ..` into `settings.{table}`"))
                }
                Ok(_) => continue,
                Err(error) => refused(Problem::UnknownKey, &error),
            };
            findings.push(
                finding
                    .field(shortened(&format!("{place}.{}", entry.key)))
                    .value(entry.value.shown())
                    .span(Some(entry.key_span.clone())),
            );
        }
    }
    findings
}

const NAMES: &str = "Fp1..Fp9 (FpL, FpR: one side of the dresser); Fz, dX, dA, gA, gam, dist, FC, FT with an exponent 0..9; kap";

fn refused(problem: Problem, error: &VariableError) -> Diagnostic {
    let way_out = match error {
        VariableError::ConstantProfile => "use dist0 in its place".to_owned(),
        VariableError::Unknown(Some(near)) => format!("did you mean \"{near}\"?"),
        VariableError::Unknown(None) => "write a channel and an exponent, e.g. \"dX2\"".to_owned(),
    };
    Diagnostic::new(problem, error.to_string()).allowed(NAMES).way_out(way_out)
}
