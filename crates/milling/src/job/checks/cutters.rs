//! The cutters: the sizes that their shapes have, in an order that makes a tool, and a use for each.

use crate::job::{CutterForm, CutterUse, MillingCutter, MillingJob, PoleWay};
use job::checks::contradiction;
use job::{Diagnostic, Problem, shown_number};

pub(super) fn check(job: &MillingJob, findings: &mut Vec<Diagnostic>) {
    cutter("cutter", &job.cutter, findings);
    if let Some(given) = &job.bottom_cutter {
        cutter("bottom_cutter", given, findings);
        let used = job.milling.root.is_some_and(|root| root.bottom_pass);
        if !used {
            unused("bottom_cutter", "a bottom pass", "[milling.root] with bottom_pass = true", findings);
        }
    }
    if let Some(given) = &job.roughing_cutter {
        cutter("roughing_cutter", given, findings);
        if job.milling.roughing.is_none() {
            unused("roughing_cutter", "roughing", "[milling.roughing]", findings);
        }
    }
    numbers(job, findings);
    held(job, findings);
}

/// Only a ball cuts alike whichever way its axis points.
fn held(job: &MillingJob, findings: &mut Vec<Diagnostic>) {
    let cutters = [Some(&job.cutter), job.bottom_cutter.as_ref(), job.roughing_cutter.as_ref()];
    let all_balls = cutters.into_iter().flatten().all(|cutter| cutter.shape == CutterForm::Ball);
    if job.machine.as_ref().is_some_and(|machine| machine.pole == PoleWay::Hold) && !all_balls {
        findings.push(contradiction(
            "a rotary axis can only be held near the pole while a ball cuts",
            "machine.pole",
            "\"hold\"".into(),
            "\"slow\" or \"mount\", or cutters with shape = \"ball\"",
            "take pole = \"slow\"",
        ));
    }
}

fn unused(table: &str, what: &str, needs: &str, findings: &mut Vec<Diagnostic>) {
    findings.push(contradiction(
        &format!("a cutter for {what} is given, and there is none"),
        table,
        "a table".into(),
        &format!("no table, or {needs}"),
        &format!("leave [{table}] out, or add {needs}"),
    ));
}

/// Programs call tools by their numbers.
fn numbers(job: &MillingJob, findings: &mut Vec<Diagnostic>) {
    let mut seen: Vec<(u32, &str)> = vec![(job.cutter_for(CutterUse::Finishing).1, "cutter")];
    for (purpose, table, given) in [
        (CutterUse::Bottom, "bottom_cutter", job.bottom_cutter.is_some()),
        (CutterUse::Roughing, "roughing_cutter", job.roughing_cutter.is_some()),
    ] {
        if !given {
            continue;
        }
        let (cutter, number) = job.cutter_for(purpose);
        if let Some((_, other)) = seen.iter().find(|(n, _)| *n == number) {
            // The number may be that of the other table.
            let table = if cutter.number.is_some() { table } else { other };
            findings.push(contradiction(
                "two cutters have the same number",
                format!("{table}.number"),
                number.to_string(),
                "another number for each cutter; without the key 1, 2 for the bottom and 3 for roughing",
                "give each cutter a number of its own",
            ));
        }
        seen.push((number, table));
    }
}

fn cutter(table: &str, cutter: &MillingCutter, findings: &mut Vec<Diagnostic>) {
    keys(table, cutter, findings);
    sizes(table, cutter, findings);
    shank(table, cutter, findings);
}

/// A key, its value, the shapes that have it and those that need it.
type ShapeKey = (&'static str, Option<f64>, &'static [CutterForm], &'static [CutterForm]);

/// Keys that a shape needs and keys that it does not have.
fn keys(table: &str, cutter: &MillingCutter, findings: &mut Vec<Diagnostic>) {
    use CutterForm::{Barrel, Cone, Drum, EndMill, Torus};
    let shape = cutter.shape;
    let name = shape.name();
    let rows: [ShapeKey; 4] = [
        ("corner_radius", cutter.corner_radius, &[EndMill, Torus, Cone], &[Torus]),
        ("half_angle_deg", cutter.half_angle_deg, &[Cone], &[Cone]),
        ("profile_radius", cutter.profile_radius, &[Barrel, Drum], &[Barrel, Drum]),
        ("largest_diameter_height", cutter.largest_diameter_height, &[Barrel, Drum], &[Barrel, Drum]),
    ];
    for (key, given, of, needed_by) in rows {
        match given {
            None if needed_by.contains(&shape) => findings.push(
                Diagnostic::new(
                    Problem::MissingKey,
                    format!("a cutter of the shape \"{name}\" needs `{key}`"),
                )
                .field(format!("{table}.{key}"))
                .allowed("a number")
                .way_out(format!("add `{key} = ...` to [{table}], or choose another shape")),
            ),
            Some(value) if !of.contains(&shape) => {
                let shapes: Vec<String> = of.iter().map(|form| format!("\"{}\"", form.name())).collect();
                findings.push(contradiction(
                    &format!("a cutter of the shape \"{name}\" has no `{key}`"),
                    format!("{table}.{key}"),
                    shown_number(value),
                    &format!("no key, or a shape out of {}", shapes.join(", ")),
                    &format!("leave `{key}` out"),
                ));
            }
            _ => {}
        }
    }
}

fn sizes(table: &str, cutter: &MillingCutter, findings: &mut Vec<Diagnostic>) {
    let mut refuse = |key: &str, value: f64, message: String, allowed: String, way_out: &str| {
        findings.push(
            Diagnostic::new(Problem::InvalidGeometry, message)
                .field(format!("{table}.{key}"))
                .value(shown_number(value))
                .allowed(allowed)
                .way_out(way_out),
        );
    };
    let length = cutter.cutting_length;
    match cutter.shape {
        CutterForm::EndMill | CutterForm::Torus | CutterForm::Cone => {
            let Some(corner) = cutter.corner_radius else { return };
            let largest = cutter.largest_corner_radius();
            // A radius given as decimal and half a diameter computed may differ in the last digit.
            if corner > largest * (1.0 + 1e-12) {
                refuse(
                    "corner_radius",
                    corner,
                    format!("a corner radius of {corner} is more than the tip has room for"),
                    format!("0 to {}", shown_number(largest)),
                    "compare the cutter with its drawing: `diameter` is no radius",
                );
            } else if cutter.shape == CutterForm::Torus && corner == 0.0 {
                refuse(
                    "corner_radius",
                    corner,
                    "a torus has a rounded corner".to_owned(),
                    format!("> 0 and <= {}", shown_number(largest)),
                    "give the radius of the corner, or take shape = \"end-mill\"",
                );
            } else if cutter.side_from() > length {
                refuse(
                    "cutting_length",
                    length,
                    format!("the edges end within the corner, which is {} high", cutter.side_from()),
                    format!(">= {}", shown_number(cutter.side_from())),
                    "give the height above the tip up to which the cutter cuts",
                );
            }
        }
        CutterForm::Barrel | CutterForm::Drum => {
            if let Some(height) = cutter.largest_diameter_height
                && height > length
            {
                refuse(
                    "largest_diameter_height",
                    height,
                    format!("the largest diameter lies at {height}, above the edges"),
                    format!("0 to {}, the cutting length", shown_number(length)),
                    "compare the cutter with its drawing",
                );
            }
        }
        CutterForm::Ball => {}
    }
}

/// What is behind the edges begins where they end, one part after the other.
fn shank(table: &str, cutter: &MillingCutter, findings: &mut Vec<Diagnostic>) {
    let mut least = (cutter.cutting_length, "the cutting length");
    for (i, part) in cutter.shank.iter().enumerate() {
        if part.from < least.0 || (i > 0 && part.from == least.0) {
            findings.push(
                Diagnostic::new(
                    Problem::InvalidGeometry,
                    format!("a part of the shank begins at {}, below {}", part.from, least.1),
                )
                .field(format!("{table}.shank[{i}].from"))
                .value(shown_number(part.from))
                .allowed(format!(">= {}, {}; each part above the one before", shown_number(least.0), least.1))
                .way_out("list neck, shank and holder from the edges upwards, heights above the tip"),
            );
        }
        least = (part.from, "the part before");
    }
}
