//! Contradictions between entries of a job of the electronic gearbox that are each in range.

use super::{
    AddedRotation, CorrectionAxis, GearboxCorrection, GearboxExplore, GearboxJob, Move, Stimulus, TableEnds,
    extent,
};
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
    measured(job, &mut findings);
    corrections(job, &mut findings);
    engagement(job, &mut findings);
    if job.output.split_trace && job.split.is_none() {
        findings.push(contradiction(
            "there is no voltage to trace",
            "output.split_trace",
            "true".into(),
            "false, or a table `split`",
            "add `[split]` with volts_per_pulse, or leave `split_trace` out",
        ));
    }
    if let Some(explore) = &job.explore {
        exploration(explore, &job.stimulus, &mut findings);
    }
    findings
}

/// What belongs to a motion or to one of two readings.
fn measured(job: &GearboxJob, findings: &mut Vec<Diagnostic>) {
    let motion = job.stimulus.motion.is_some();
    let nothing = |field: &str, allowed: &str, example: &str| {
        Diagnostic::new(Problem::MissingKey, format!("`{field}` says nothing"))
            .field(format!("{field}.{}", allowed.split(',').next().unwrap_or(allowed)))
            .allowed(format!("one or more of {allowed}"))
            .way_out(format!("add one, e.g. {example}, or leave the table out"))
    };
    if let Some(errors) = &job.errors {
        if errors.scale.is_none() && errors.ball_screw.is_none() && errors.encoder.is_none() {
            findings.push(nothing(
                "errors",
                "scale, ball_screw, encoder",
                "scale = { slope_um_per_m = 3.0 }",
            ));
        }
        if errors.scale.is_some() && errors.ball_screw.is_some() {
            findings.push(contradiction(
                "reference pulses come from a scale or from a ball screw, not from both",
                "errors.ball_screw",
                "beside `scale`".into(),
                "no key beside `scale`",
                "keep the one that the slide is measured by",
            ));
        }
        for (key, given) in [("scale", errors.scale.is_some()), ("ball_screw", errors.ball_screw.is_some())] {
            if given && !motion {
                findings.push(contradiction(
                    "a train of pulses has no position that lines could be off",
                    format!("errors.{key}"),
                    "beside a train of pulses".into(),
                    "no key without `stimulus.motion`",
                    "give the motion of the slide, or leave it out: the train has its errors in its ticks",
                ));
            }
        }
    }
    if let Some(compare) = &job.compare {
        if compare.pll.is_none() && compare.amplitude.is_none() {
            findings.push(nothing("compare", "pll, amplitude", "pll = { bandwidth_hz = 50.0 }"));
        }
        if !motion {
            findings.push(contradiction(
                "a train of pulses has no position that a multiplier could be compared with",
                "compare",
                "beside a train of pulses".into(),
                "no table without `stimulus.motion`",
                "give the motion of the slide, or leave `compare` out",
            ));
        }
    }
}

fn corrections(job: &GearboxJob, findings: &mut Vec<Diagnostic>) {
    for (i, correction) in GearboxCorrection::curves(job.correction.as_ref()).iter().enumerate() {
        let AddedRotation::Table { axis, values_um, ends, .. } = correction else { continue };
        if *axis == CorrectionAxis::Worm && job.worm.is_none() {
            findings.push(contradiction(
                "the correction follows a worm, and there is none",
                format!("correction.curves[{i}].axis"),
                "worm".into(),
                "feed, or worm with a table `worm`",
                "add `[worm]`, or take axis = \"feed\"",
            ));
        }
        if *axis == CorrectionAxis::Worm && *ends == TableEnds::Natural {
            findings.push(contradiction(
                "a worm turns without end, its table has ends",
                format!("correction.curves[{i}].ends"),
                "natural".into(),
                "periodic for axis = \"worm\"",
                "give the values of whole turns, the last as the first, and ends = \"periodic\"",
            ));
        }
        if let (TableEnds::Periodic, Some(first), Some(last)) = (ends, values_um.first(), values_um.last())
            && first != last
        {
            findings.push(contradiction(
                "a table that repeats ends with another value than it begins with",
                format!("correction.curves[{i}].values_um[{}]", values_um.len() - 1),
                shown_number(*last),
                &format!("{}, the first value", shown_number(*first)),
                "repeat the first value as the last, or take ends = \"natural\"",
            ));
        }
    }
}

/// An engagement needs a worm, and its counter has to be read before it has gone half its range.
fn engagement(job: &GearboxJob, findings: &mut Vec<Diagnostic>) {
    let Some(engagement) = &job.engagement else { return };
    let Some(worm) = &job.worm else {
        findings.push(contradiction(
            "there is no worm to engage with",
            "engagement",
            "beside no worm".into(),
            "no table without `worm`",
            "add `[worm]`, or leave `engagement` out",
        ));
        return;
    };
    let counts = worm.speed_rpm / 60.0 * f64::from(worm.pulses_per_revolution) * 1e-6 * engagement.cycle_us;
    let least = counts.ceil().max(1.0).log2().floor() as u32 + 2;
    if engagement.counter_bits < least {
        findings.push(contradiction(
            &format!(
                "the worm makes {counts:.1} counts a cycle, half the range of its counter and more: no reading tells which way"
            ),
            "engagement.counter_bits",
            engagement.counter_bits.to_string(),
            &format!("{least} to 63"),
            "take a wider counter, or a shorter cycle",
        ));
    }
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
