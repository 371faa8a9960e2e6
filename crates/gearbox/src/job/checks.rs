//! Contradictions between entries of a job of the electronic gearbox that are each in range.

use super::{GearboxExplore, GearboxJob, Move, Stimulus, extent};
use job::checks::{contradiction, name};
use job::control::check_servo;
use job::{Diagnostic, Problem, shown_number};

/// All contradictions in a job; without places, which the caller knows.
pub(crate) fn check(job: &GearboxJob) -> Vec<Diagnostic> {
    let mut findings = Vec::new();
    name(&job.job, &mut findings);
    one_stimulus(&job.stimulus, &mut findings);
    train(&job.stimulus, &mut findings);
    if let Some(moves) = &job.stimulus.motion {
        motion(&job.stimulus, moves, &mut findings);
        extent::check_motion(job, moves, &mut findings);
    }
    if let Some(servo) = &job.servo {
        check_servo("servo", servo, job.worm.is_some(), &mut findings);
    }
    if let Some(explore) = &job.explore {
        exploration(explore, &job.stimulus, &mut findings);
    }
    findings
}

fn one_stimulus(stimulus: &Stimulus, findings: &mut Vec<Diagnostic>) {
    const ALLOWED: &str = "exactly one of references, reference_ticks, motion";
    let given: Vec<&str> = [
        ("references", stimulus.references.is_some()),
        ("reference_ticks", stimulus.reference_ticks.is_some()),
        ("motion", stimulus.motion.is_some()),
    ]
    .into_iter()
    .filter_map(|(key, given)| given.then_some(key))
    .collect();
    match given.split_first() {
        None => findings.push(
            Diagnostic::new(Problem::MissingKey, "`stimulus` does not say what the slide does")
                .field("stimulus.motion")
                .allowed(ALLOWED)
                .way_out(
                    "add e.g. motion = [{ to = 30.0, speed_mm_per_min = 300.0, acceleration_mm_per_s2 = 200.0 }]",
                ),
        ),
        Some((first, others)) => findings.extend(others.iter().map(|key| {
            contradiction(
                "what the slide does is given twice",
                format!("stimulus.{key}"),
                format!("beside `{first}`"),
                ALLOWED,
                "keep one of them",
            )
        })),
    }
}

/// Signs go with ticks; a train has no position and no rest, a motion no last tick.
fn train(stimulus: &Stimulus, findings: &mut Vec<Diagnostic>) {
    match (&stimulus.reference_ticks, &stimulus.reference_signs) {
        (Some(ticks), None) => findings.push(
            Diagnostic::new(Problem::MissingKey, "the reference pulses have no signs")
                .field("stimulus.reference_signs")
                .allowed(format!("a list of {} signs, +1 or -1", ticks.len()))
                .way_out("add `reference_signs = [1, 1, ..]`"),
        ),
        (None, Some(signs)) => findings.push(contradiction(
            "signs of reference pulses are given, but not their ticks",
            "stimulus.reference_signs",
            format!("a list of {}", signs.len()),
            "no key, or `reference_ticks` of the same length",
            "add `reference_ticks`, or leave `reference_signs` out",
        )),
        (Some(ticks), Some(signs)) if ticks.len() != signs.len() => findings.push(
            Diagnostic::new(
                Problem::InvalidList,
                format!("{} signs for {} reference pulses", signs.len(), ticks.len()),
            )
            .field("stimulus.reference_signs")
            .value(format!("{} entries", signs.len()))
            .allowed(format!("{} entries, as many as `reference_ticks`", ticks.len()))
            .way_out("give both lists the same length"),
        ),
        _ => {}
    }
    if stimulus.motion.is_some() {
        findings.extend(stimulus.last_tick.map(|tick| {
            contradiction(
                "a motion ends by itself and has no last tick",
                "stimulus.last_tick",
                tick.to_string(),
                "no key beside `motion`",
                "leave `last_tick` out; `rest_s` is the time after the motion",
            )
        }));
        return;
    }
    for (key, given, way_out) in [
        ("start", stimulus.start, "leave it out, or give a `motion`"),
        ("rest_s", stimulus.rest_s, "leave it out; `last_tick` says how long a train runs"),
    ] {
        findings.extend(given.map(|value| {
            contradiction(
                &format!("`{key}` belongs to a motion, and there is none"),
                format!("stimulus.{key}"),
                shown_number(value),
                "no key, or `motion`",
                way_out,
            )
        }));
    }
}

fn motion(stimulus: &Stimulus, moves: &[Move], findings: &mut Vec<Diagnostic>) {
    if moves.iter().all(|step| matches!(step, Move::Dwell(_))) {
        findings.push(contradiction(
            "the motion goes nowhere",
            "stimulus.motion",
            format!("{} dwells", moves.len()),
            "at least one travel { to, speed_mm_per_min, acceleration_mm_per_s2 }",
            "add a travel",
        ));
    }
    let mut position = stimulus.start_or_default();
    for (i, step) in moves.iter().enumerate() {
        let Move::Travel(travel) = step else { continue };
        if travel.to == position {
            findings.push(contradiction(
                "a travel goes nowhere: the slide already stands there",
                format!("stimulus.motion[{i}].to"),
                shown_number(travel.to),
                &format!("another position than {}", shown_number(position)),
                "give another position, or let the slide stand with { dwell_s = .. }",
            ));
        }
        position = travel.to;
    }
}

fn exploration(explore: &GearboxExplore, stimulus: &Stimulus, findings: &mut Vec<Diagnostic>) {
    if explore.is_fixed() {
        findings.push(
            Diagnostic::new(Problem::MissingKey, "`explore` does not say what there is to choose from")
                .field("explore.scales")
                .allowed("one or more of scales, clocks, interpolations, encoders")
                .way_out("add one, e.g. scales = [{ pulses_per_metre = 1e5, cost = 1.0 }]"),
        );
    }
    let travels = stimulus.motion.iter().flatten().any(|step| matches!(step, Move::Travel(_)));
    if travels {
        return;
    }
    for (key, given, example) in [
        ("speed_mm_per_min", explore.speed_mm_per_min, "300.0"),
        ("acceleration_mm_per_s2", explore.acceleration_mm_per_s2, "200.0"),
    ] {
        if given.is_none() {
            findings.push(
                Diagnostic::new(
                    Problem::MissingKey,
                    format!("`explore` needs `{key}`: the stimulus has no motion to take it from"),
                )
                .field(format!("explore.{key}"))
                .allowed("a number > 0")
                .way_out(format!("add it, e.g. {key} = {example}")),
            );
        }
    }
}
