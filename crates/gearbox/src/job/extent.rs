//! How much a stimulus may ask for, so that every job ends within minutes.

use super::{GearboxJob, Move};
use job::checks::contradiction;
use job::{Diagnostic, shown_number};

/// Longest stimulus: a day, s.
const LONGEST_S: f64 = 86_400.0;

/// Most interpolated pulses of a motion: half a minute at the 30 million pulses a second of `docs/mathematics/gearbox.md`.
const MOST_PULSES: f64 = 1e9;

/// Most samples of the servo: half a minute at the 35 million samples a second of `docs/mathematics/gearbox.md`.
const MOST_SAMPLES: f64 = 1e9;

/// A motion that asks for too much.
pub(super) fn check_motion(job: &GearboxJob, moves: &[Move], findings: &mut Vec<Diagnostic>) {
    let (mut position, mut length, mut time) =
        (job.stimulus.start_or_default(), 0.0, job.stimulus.rest_or_default());
    for step in moves {
        match step {
            Move::Travel(travel) => {
                time += travel.duration_s(position);
                length += (travel.to - position).abs();
                position = travel.to;
            }
            Move::Dwell(dwell) => time += dwell.dwell_s,
        }
    }
    let pulses = length / job.feed.pitch_mm() * f64::from(job.feed.pulses_per_interval);
    if pulses > MOST_PULSES {
        findings.push(contradiction(
            "the motion makes more pulses than a run can count",
            "stimulus.motion",
            format!("{} pulses", shown_number(pulses.round())),
            &format!("up to {MOST_PULSES:e} pulses, feed x pulses_per_metre x pulses_per_interval"),
            "shorten the motion, or take a coarser scale",
        ));
    }
    findings.extend(too_long(job, time, "stimulus.motion"));
}

/// A stimulus of this time in s, given at `field`, that lasts too long.
pub(super) fn too_long(job: &GearboxJob, time: f64, field: &str) -> Option<Diagnostic> {
    if time > LONGEST_S {
        return Some(contradiction(
            "the stimulus lasts longer than a day",
            field,
            format!("{} s", shown_number(time)),
            &format!("up to {LONGEST_S} s"),
            "shorten it, or check the units of speed and clock",
        ));
    }
    let samples = time / (1e-6 * job.servo.as_ref()?.sample_time_us);
    (samples > MOST_SAMPLES).then(|| {
        contradiction(
            "the stimulus lasts for more samples of the servo than a run can take",
            field,
            format!("{} samples", shown_number(samples.round())),
            &format!("up to {MOST_SAMPLES:e} samples of servo.sample_time_us"),
            "shorten it, or give a longer sample time",
        )
    })
}
