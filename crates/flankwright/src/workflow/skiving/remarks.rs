//! What is to be said of a measured tool: the verdict, and warnings.

use super::measurement::Measurement;
use super::prepare::SkivingBodies;
use super::result::{MeasurementResult, SkivedFlankResult};
use crate::exchange::skiving_job::SkivingJob;
use crate::workflow::finding::Remark;
use crate::workflow::run::parquet_warning;
use std::collections::BTreeMap;

/// Why the target is missed, the gravest first.
pub(super) fn reason(
    measurement: &MeasurementResult,
    flanks: &BTreeMap<&'static str, SkivedFlankResult>,
    tolerance_um: f64,
) -> Option<Remark> {
    let profile = &measurement.profile;
    let worn: Vec<&str> = profile.worn.iter().filter(|(_, worn)| **worn).map(|(flank, _)| *flank).collect();
    if !worn.is_empty() {
        let deepest = profile.track_mean_um.values().flatten().copied().fold(0.0, f64::min);
        return Some(Remark {
            code: "tool-worn",
            text: format!(
                "the tool is worn ({} flank): {:.2} um are missing on a track in the mean, {} um are allowed",
                worn.join(" and "),
                -deepest,
                profile.wear_limit_um
            ),
            way_out: "grind the tool again; resharpening.csv tells how deep".into(),
        });
    }
    if let Some(first) = profile.out_of_band.first() {
        return Some(Remark {
            code: "teeth-out-of-band",
            text: format!(
                "{} edges leave the band of {} um, the first on tooth {} ({} flank, {:.2} um off the curve)",
                profile.out_of_band.len(),
                profile.band_um,
                first.tooth,
                first.flank,
                first.off_um
            ),
            way_out: "look at these teeth for chips and built-up edges, and measure again".into(),
        });
    }
    let worst = flanks.values().map(|flank| flank.max_deviation_um).fold(0.0, f64::max);
    (worst > tolerance_um).then(|| {
        let after = measurement.correction.largest_um[1];
        let way_out = if after <= tolerance_um {
            format!("correct the setting as told: {after:.2} um remain")
        } else {
            format!("correct the setting as told ({after:.2} um remain), or grind the tool again")
        };
        Remark {
            code: "above-tolerance",
            text: format!("the profile will deviate by {worst:.2} um, the tolerance is {tolerance_um} um"),
            way_out,
        }
    })
}

/// Warnings about poses, readings and results.
pub(super) fn warnings(
    job: &SkivingJob,
    bodies: &SkivingBodies,
    measurement: Option<&Measurement>,
    corrected_at_limit: &[&'static str],
) -> Vec<Remark> {
    let mut warnings: Vec<Remark> = parquet_warning(&job.output.tables).into_iter().collect();
    let one_sense = job.measuring.senses.list().len() == 1;
    if one_sense && bodies.barrier.latency > 0.0 {
        let lever = bodies.flanks.left.tracks[0].0.contact.lever.abs();
        warnings.push(Remark {
            code: "latency-not-removed",
            text: format!(
                "in one sense the delay of the barrier shifts every deviation by {:.2} um",
                1e3 * lever * bodies.barrier.speed * bodies.barrier.latency
            ),
            way_out: "measure in both senses, or more slowly".into(),
        });
    }
    if job.measuring.tracks.len() < 5 {
        warnings.push(Remark {
            code: "few-tracks",
            text: format!(
                "{} tracks tell pitch and mounting, but little of the profile",
                job.measuring.tracks.len()
            ),
            way_out: "measure five tracks or more".into(),
        });
    }
    let Some(measurement) = measurement else { return warnings };
    let mounting = &measurement.evaluation.mounting;
    if mounting.deviation_per_noise.iter().any(|d| !d.is_finite()) {
        warnings.push(Remark {
            code: "wobble-not-observed",
            text: "the tracks do not tell the wobble of this tool from its eccentricity".into(),
            way_out: "take the wobble as unknown, or measure it at the shank".into(),
        });
    }
    if !mounting.left_out.is_empty() {
        let teeth: Vec<String> = mounting.left_out.iter().map(ToString::to_string).collect();
        warnings.push(Remark {
            code: "teeth-left-out",
            text: format!("teeth {} stand out and do not count for the mounting", teeth.join(", ")),
            way_out: "look at these teeth".into(),
        });
    }
    if !corrected_at_limit.is_empty() {
        warnings.push(Remark {
            code: "correction-at-limit",
            text: format!("the correction ends at the limit of {}", corrected_at_limit.join(", ")),
            way_out:
                "leave out of `evaluation.settings` what gains little there, or widen `evaluation.limits`"
                    .into(),
        });
    }
    warnings
}
