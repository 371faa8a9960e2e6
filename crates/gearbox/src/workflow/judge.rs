//! What a run of the electronic gearbox is judged by: the errors at the flank against the tolerance of the job, the pace of the pulses,
//! the motor of the servo, and the set-ups to choose from.

use super::remarks::torque_limited;
use super::result::{
    AlongFeedResult, AngleResult, EncoderResult, EngagementResult, ExploreResult, ServoResult, SplitResult,
};
use verdict::{Remark, Verdict};

/// What was found.
pub(super) struct Judged<'a> {
    /// Alarms of the interpolator.
    pub alarms: &'a [Remark],
    /// Errors along the feed; `None` for a train of pulses.
    pub along_feed: Option<&'a AlongFeedResult>,
    /// Errors of the rotation; `None` for a train of pulses.
    pub angle: Option<&'a AngleResult>,
    /// What the servo leaves.
    pub servo: Option<&'a ServoResult>,
    /// What the encoder of the workpiece leaves on the teeth.
    pub encoder: Option<&'a EncoderResult>,
    /// Whole pulses and voltage.
    pub split: Option<&'a SplitResult>,
    /// How the workpiece came into the gap.
    pub engagement: Option<&'a EngagementResult>,
    /// The set-ups, and why none of them is accurate enough.
    pub explored: Option<(&'a ExploreResult, Option<&'a Remark>)>,
}

const COUPLING: &str = "rotation at the flank over the whole motion";
const PULSES: &str = "pace of the pulses";
const SERVO: &str = "workpiece behind its servo";
const MOTOR: &str = "torque of the servo";
const ENCODER: &str = "teeth as the encoder divides them";
const VOLTAGE: &str = "voltage of the part of a pulse";
const GAP: &str = "workpiece in the gap of the worm";
const SET_UPS: &str = "set-ups to choose from";

/// The verdict of a run against a tolerance, if there is one.
pub(super) fn verdict(tolerance_um: Option<f64>, found: &Judged<'_>) -> Verdict {
    let mut verdict = Verdict::new();
    match tolerance_um {
        Some(tolerance_um) => against(tolerance_um, found, &mut verdict),
        None => {
            let why = "the job gives no tolerance (target.tolerance_um)";
            let items = [
                Some(COUPLING),
                Some(PULSES),
                found.encoder.map(|_| ENCODER),
                found.split.map(|_| VOLTAGE),
                found.engagement.map(|_| GAP),
                found.servo.map(|_| SERVO),
                found.servo.map(|_| MOTOR),
            ];
            items.into_iter().flatten().for_each(|item| verdict.leave(item, why));
        }
    }
    if let Some((explored, reason)) = found.explored {
        let detail =
            format!("{} of {} keep to {} um", explored.feasible, explored.set_ups.len(), explored.wanted_um);
        match reason {
            Some(reason) => verdict.missed(SET_UPS, detail, reason.clone()),
            None => verdict.met(SET_UPS, detail),
        }
    }
    verdict
}

fn against(tolerance: f64, found: &Judged<'_>, verdict: &mut Verdict) {
    match found.alarms {
        [] => verdict.met(PULSES, "no alarm"),
        alarms => alarms.iter().for_each(|alarm| verdict.missed(PULSES, alarm.text.clone(), alarm.clone())),
    }
    match found.angle {
        Some(angle) => {
            let largest = angle.flank.greatest_um.max(-angle.flank.least_um);
            verdict.judge(COUPLING, largest <= tolerance, format!("{largest:.4} of {tolerance} um"), || {
                Remark::new(
                    "rotation-misses-lead",
                    format!("the rotation misses the lead by {largest:.3} um at the flank, {tolerance} um are allowed"),
                    "take a finer scale, more pulses per interval or mode = \"no-backlash\", start and stop outside the gear or accelerate more slowly, or allow more",
                )
            });
        }
        None => verdict.owe(
            COUPLING,
            Remark::new(
                "slide-not-known",
                "a train of reference pulses has no position of the slide that the rotation could be compared with",
                "give the motion of the slide (stimulus.motion), or leave target out",
            ),
        ),
    }
    let outside = |kept: Option<bool>| kept == Some(false);
    if outside(found.angle.and_then(|angle| angle.within_bound))
        || outside(found.along_feed.and_then(|along| along.within_bound))
    {
        verdict.owe(
            "limits of the error budget",
            Remark::new(
                "outside-budget",
                "the simulated errors leave the limits that their budget sets: one of the two is wrong",
                "report this job as a defect of flankwright",
            ),
        );
    }
    additions(tolerance, found, verdict);
    if let Some(servo) = found.servo {
        let peak = servo.workpiece.peak_um;
        verdict.judge(SERVO, peak <= tolerance, format!("{peak:.4} of {tolerance} um"), || {
            Remark::new(
                "servo-misses",
                format!("the workpiece misses its angle by {peak:.3} um at the flank, {tolerance} um are allowed"),
                "accelerate more slowly, take a larger bandwidth, a stronger motor or a finer encoder, or allow more",
            )
        });
        match torque_limited(servo) {
            Some(reason) => verdict.missed(MOTOR, reason.text.clone(), reason),
            None => verdict.met(MOTOR, format!("{:.2} N m at most", servo.greatest_torque_n_m)),
        }
    }
}

/// Encoder, voltage and gap against the tolerance.
fn additions(tolerance: f64, found: &Judged<'_>, verdict: &mut Verdict) {
    if let Some(encoder) = found.encoder {
        // Its mean goes away with the centring.
        let half = 0.5 * encoder.cumulative_pitch_um;
        verdict.judge(ENCODER, half <= tolerance, format!("{half:.4} of {tolerance} um"), || {
            Remark::new(
                "encoder-misses",
                format!(
                    "the encoder puts teeth off by {half:.3} um about their mean, {tolerance} um are allowed"
                ),
                "centre the disc of the encoder, take one with a larger graduation, or allow more",
            )
        });
    }
    let largest = |range: &super::result::RangeUm| range.greatest_um.max(-range.least_um);
    if let Some(split) = found.split {
        let error = largest(&split.error);
        verdict.judge(VOLTAGE, error <= tolerance, format!("{error:.4} of {tolerance} um"), || {
            Remark::new(
                "voltage-misses",
                format!("the voltage of the part of a pulse is off by {error:.3} um at the flank, {tolerance} um are allowed"),
                "take a converter with more bits, adjust its offset and slope, take an encoder with more pulses, or allow more",
            )
        });
    }
    if let Some(engagement) = found.engagement {
        let miss = largest(&engagement.miss);
        verdict.judge(GAP, miss <= tolerance, format!("{miss:.4} of {tolerance} um"), || {
            Remark::new(
                "gap-missed",
                format!(
                    "the workpiece misses the gap by {miss:.3} um at the flank, {tolerance} um are allowed"
                ),
                "take an encoder of the worm with more pulses, or allow more",
            )
        });
    }
}
