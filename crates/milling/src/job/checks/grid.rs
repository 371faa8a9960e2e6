//! How many rows and columns there are: by numbers or by limits, not both, and limits that leave something.

use crate::job::{Density, Milling, MillingJob};
use job::checks::contradiction;
use job::{Diagnostic, Problem, shown_number};

/// Points of a flank that a program can hold.
const MOST_POINTS: usize = 1_000_000;

pub(super) fn check(job: &MillingJob, findings: &mut Vec<Diagnostic>) {
    let milling = &job.milling;
    let counts = [("rows", milling.rows), ("columns", milling.columns)];
    let limits = limits(milling);
    let given: Vec<&str> = counts.iter().filter_map(|(key, count)| count.map(|_| *key)).collect();
    const ALLOWED: &str = "either rows and columns, or one or more of density, scallop_um, chord_um";
    match (given.first(), limits.as_slice()) {
        (None, []) => findings.push(
            Diagnostic::new(
                Problem::MissingKey,
                "`milling` does not say how many rows and columns there are",
            )
            .field("milling.rows")
            .allowed(ALLOWED)
            .way_out("add `rows` and `columns`, or a limit such as `scallop_um = 5.0`"),
        ),
        (Some(count), limits) if !limits.is_empty() => findings.extend(limits.iter().map(|(key, value)| {
            contradiction(
                &format!("the grid is given by `{count}` and by `{key}`"),
                format!("milling.{key}"),
                value.clone(),
                ALLOWED,
                "keep the numbers or the limits",
            )
        })),
        (Some(_), _) => {
            findings.extend(counts.iter().filter(|(_, count)| count.is_none()).map(|(key, _)| {
                Diagnostic::new(Problem::MissingKey, format!("`milling` has no key `{key}`"))
                    .field(format!("milling.{key}"))
                    .allowed(ALLOWED)
                    .way_out(format!("add `{key} = ...`"))
            }))
        }
        _ => {}
    }
    if let (Some(rows), Some(columns)) = (milling.rows, milling.columns)
        && rows * columns > MOST_POINTS
    {
        findings.push(contradiction(
            &format!("the grid has {} points per flank", rows * columns),
            "milling.columns",
            columns.to_string(),
            &format!("rows x columns up to {MOST_POINTS}"),
            "take fewer rows or columns",
        ));
    }
    if let Some(density) = &milling.density {
        order(density, findings);
    }
    through_row(job, findings);
}

/// Limits that are given, with their values.
fn limits(milling: &Milling) -> Vec<(&'static str, String)> {
    [
        ("density", milling.density.map(|_| "a table".to_owned())),
        ("scallop_um", milling.scallop_um.map(shown_number)),
        ("chord_um", milling.chord_um.map(shown_number)),
    ]
    .into_iter()
    .filter_map(|(key, value)| Some((key, value?)))
    .collect()
}

/// A least distance is nowhere above a greatest one; a mean lies between both.
fn order(density: &Density, findings: &mut Vec<Diagnostic>) {
    let d = density;
    let along = [
        ("row", [d.row_max, d.row_max_mean], [d.row_min, d.row_min_mean]),
        ("column", [d.column_max, d.column_max_mean], [d.column_min, d.column_min_mean]),
    ];
    for (line, greatest, least) in along {
        let smallest = ["max", "max_mean"].into_iter().zip(greatest).filter_map(|(key, v)| Some((key, v?)));
        let Some((upper, most)) = smallest.min_by(|a, b| a.1.total_cmp(&b.1)) else { continue };
        for (lower, value) in ["min", "min_mean"].into_iter().zip(least) {
            let Some(value) = value.filter(|value| *value > most) else { continue };
            findings.push(contradiction(
                &format!("`{line}_{lower}` is above `{line}_{upper}`"),
                format!("milling.density.{line}_{lower}"),
                shown_number(value),
                &format!("<= {line}_{upper} = {}", shown_number(most)),
                "give a least distance below the greatest one, or leave one of both out",
            ));
        }
    }
    if *density == Density::default() {
        findings.push(
            Diagnostic::new(Problem::MissingKey, "`density` has no limit")
                .field("milling.density.column_max")
                .allowed("one or more of row_max, row_min, row_max_mean, row_min_mean, column_max, ..")
                .way_out("add e.g. `column_max = 1.0`, or leave `density` out"),
        );
    }
}

fn through_row(job: &MillingJob, findings: &mut Vec<Diagnostic>) {
    let Some(row) = job.milling.lead_through_row else { return };
    let field = "milling.lead_through_row";
    if job.gear.as_ref().is_none_or(|gear| gear.drawing.cone_angle_deg != 0.0) {
        findings.push(contradiction(
            "only the guide curve of a cylindrical gear can be laid through a row",
            field,
            row.to_string(),
            "no key without [gear], and none with a cone angle",
            "leave `lead_through_row` out",
        ));
    } else if let Some(rows) = job.milling.rows.filter(|rows| row >= *rows) {
        findings.push(contradiction(
            &format!("there is no row {row}: rows count from 0 at the root"),
            field,
            row.to_string(),
            &format!("0 to {}", rows - 1),
            "give the number of a row that there is",
        ));
    }
}
