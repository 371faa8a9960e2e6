//! Contradictions between entries of a job of five-axis milling that are each in range; what it shares with other processes is
//! checked by their code. Knows the job, no geometry beyond the order of sizes.

mod bevel;
mod bodies;
mod contact;
mod cutters;
mod grid;
mod mate;
mod shop;

use super::MillingJob;
use job::checks::{clamping_bodies, contradiction, name};
use job::{Diagnostic, Problem, shown_number};

/// All contradictions in a job; without places, which the caller knows.
pub(crate) fn check(job: &MillingJob) -> Vec<Diagnostic> {
    let mut findings = Vec::new();
    name(&job.job, &mut findings);
    bodies::check(job, &mut findings);
    cutters::check(job, &mut findings);
    grid::check(job, &mut findings);
    contact::check(job, &mut findings);
    mate::check(job, &mut findings);
    shop::check(job, &mut findings);
    clamping_bodies(job.machine.as_ref().map_or(&[], |machine| &machine.clamping), &mut findings);
    rays(job, &mut findings);
    if !job.output.programs.is_empty() && job.machine.is_none() {
        findings.push(contradiction(
            "programs are wanted, and no machine is given",
            "output.programs",
            format!("a list of {}", job.output.programs.len()),
            "no programs, or a table [machine] with `file` and `tool_length`",
            "add `[machine]`, or leave `programs` out",
        ));
    }
    findings
}

/// Rays of the simulation: more show nothing more and take hours.
const MOST_RAYS: usize = 250_000;

fn rays(job: &MillingJob, findings: &mut Vec<Diagnostic>) {
    let [profile, length] = [job.simulation.rays_profile, job.simulation.rays_length];
    if profile * length > MOST_RAYS {
        findings.push(contradiction(
            &format!("the simulation has {} rays per flank", profile * length),
            "simulation.rays_profile",
            profile.to_string(),
            &format!("rays_profile x rays_length up to {MOST_RAYS}"),
            "use fewer rays, e.g. 81 x 61",
        ));
    }
}

/// A value that makes no body.
fn impossible(
    message: String,
    field: &str,
    value: f64,
    allowed: String,
    way_out: &str,
    findings: &mut Vec<Diagnostic>,
) {
    findings.push(
        Diagnostic::new(Problem::InvalidGeometry, message)
            .field(field)
            .value(shown_number(value))
            .allowed(allowed)
            .way_out(way_out),
    );
}

/// Of several keys exactly one: none is missing, each further one a contradiction.
fn exactly_one(
    table: &str,
    keys: &[(&str, bool)],
    lacks: &str,
    way_out: &str,
    findings: &mut Vec<Diagnostic>,
) {
    let names: Vec<&str> = keys.iter().map(|(key, _)| *key).collect();
    let allowed = format!("exactly one of {}", names.join(", "));
    let given: Vec<&str> = keys.iter().filter_map(|(key, given)| given.then_some(*key)).collect();
    let field = |key: &str| if table.is_empty() { key.to_owned() } else { format!("{table}.{key}") };
    match given.split_first() {
        None => findings.push(
            Diagnostic::new(Problem::MissingKey, lacks)
                .field(field(names[0]))
                .allowed(allowed)
                .way_out(way_out),
        ),
        Some((first, others)) => findings.extend(others.iter().map(|key| {
            contradiction(
                &format!("`{key}` stands beside `{first}`"),
                field(key),
                format!("beside `{first}`"),
                &allowed,
                "keep one of them",
            )
        })),
    }
}
