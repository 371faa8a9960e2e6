//! Whether a measured tool is fit, and why not.

use super::measurement::Measurement;
use super::prepare::SkivingBodies;
use super::result::{MeasurementResult, SkivedFlankResult};
use crate::process::skiving::measuring::FlankTracks;
use crate::workflow::finding::Remark;
use std::collections::BTreeMap;

/// Why the target is missed, the gravest first.
pub(super) fn reason(
    bodies: &SkivingBodies,
    measured: Option<(&Measurement, &MeasurementResult)>,
    flanks: &BTreeMap<&'static str, SkivedFlankResult>,
    tolerance_um: f64,
) -> Option<Remark> {
    let of_tool = measured.and_then(|(measurement, result)| {
        let teeth = standing_out(result);
        // A single tooth that is chipped makes no worn tool.
        let worn_anyway = !teeth.is_empty() && !worn_without(bodies, measurement, &teeth);
        if worn_anyway {
            out_of_band(result).or_else(|| worn(result))
        } else {
            worn(result).or_else(|| out_of_band(result))
        }
    });
    of_tool.or_else(|| above_tolerance(flanks, tolerance_um))
}

/// Teeth outside their band.
fn standing_out(measurement: &MeasurementResult) -> Vec<usize> {
    let mut teeth: Vec<usize> = measurement.profile.out_of_band.iter().map(|edge| edge.tooth).collect();
    teeth.dedup();
    teeth
}

/// Whether the tool is worn if some of its teeth do not count, neither for the clocking nor for the means of the tracks.
fn worn_without(bodies: &SkivingBodies, measurement: &Measurement, teeth: &[usize]) -> bool {
    let lever = |flank, track: usize| {
        let of: &FlankTracks = &bodies.flanks[flank];
        of.tracks[track].0.contact.lever
    };
    let remaining = &measurement.evaluation.remaining;
    let good = || remaining.iter().filter(|(_, _, tooth, _)| !teeth.contains(tooth));
    let count = good().count().max(1) as f64;
    let clocking = good().map(|(flank, track, _, f)| f / lever(flank, track)).sum::<f64>() / count;
    remaining.of.iter().any(|(flank, tracks)| {
        tracks.iter().enumerate().any(|(track, all)| {
            let left: Vec<f64> =
                all.iter().enumerate().filter(|(k, _)| !teeth.contains(k)).map(|(_, f)| *f).collect();
            let mean = left.iter().sum::<f64>() / left.len().max(1) as f64;
            mean - lever(flank, track) * clocking < -bodies.options.wear_limit
        })
    })
}

fn worn(measurement: &MeasurementResult) -> Option<Remark> {
    let profile = &measurement.profile;
    let worn: Vec<&str> = profile.worn.iter().filter(|(_, worn)| **worn).map(|(flank, _)| *flank).collect();
    let deepest = profile.track_mean_um.values().flatten().copied().fold(0.0, f64::min);
    (!worn.is_empty()).then(|| Remark {
        code: "tool-worn",
        text: format!(
            "the tool is worn ({} flank): {:.2} um are missing on a track in the mean, {} um are allowed",
            worn.join(" and "),
            -deepest,
            profile.wear_limit_um
        ),
        way_out: "grind the tool again; resharpening.csv tells how deep".into(),
    })
}

fn out_of_band(measurement: &MeasurementResult) -> Option<Remark> {
    let profile = &measurement.profile;
    let worst = profile.out_of_band.iter().max_by(|a, b| a.off_um.total_cmp(&b.off_um))?;
    Some(Remark {
        code: "teeth-out-of-band",
        text: format!(
            "{} leave the band of {} um, most of all that of tooth {} ({} flank, {:.2} um off the curve)",
            counted(profile.out_of_band.len(), "edge"),
            profile.band_um,
            worst.tooth,
            worst.flank,
            worst.off_um
        ),
        way_out: "look at these teeth for chips and built-up edges, and measure again".into(),
    })
}

fn above_tolerance(flanks: &BTreeMap<&'static str, SkivedFlankResult>, tolerance_um: f64) -> Option<Remark> {
    let worst = flanks.values().map(|flank| flank.max_deviation_um).fold(0.0, f64::max);
    let after = |flank: &SkivedFlankResult| {
        let target = flank.target_um.iter().flatten();
        let off = |found: &Vec<f64>| found.iter().zip(target).map(|(f, t)| (f - t).abs()).fold(0.0, f64::max);
        flank.corrected_simulated_um.as_ref().map(off)
    };
    let corrected = flanks.values().filter_map(after).reduce(f64::max);
    (worst > tolerance_um).then(|| Remark {
        code: "above-tolerance",
        text: format!("the profile will deviate by {worst:.2} um, the tolerance is {tolerance_um} um"),
        way_out: match corrected {
            Some(after) if after <= tolerance_um => {
                format!("correct the setting as told: {after:.2} um remain")
            }
            Some(after) => {
                format!("correct the setting as told ({after:.2} um remain), or grind the tool again")
            }
            None => "check the tool against the workpiece: another part of its edge cuts the flank".into(),
        },
    })
}

fn counted(count: usize, what: &str) -> String {
    if count == 1 { format!("one {what}") } else { format!("{count} {what}s") }
}
