//! From numbers of the process to those of the result: um and degrees, by flank.

use super::measurement::Measurement;
use super::prepare::SkivingBodies;
use super::referee::{Left, UnderReferee};
use super::result::{
    CorrectionResult, MeasurementResult, MissingResult, MountingResult, PitchResult, ProfileResult,
    ResharpeningResult, SkivedFlankResult, SkivingSettings, ToothOnFlank, TrackResult,
};
use crate::evaluation::{Deviations, Evaluation, MissingSwitch};
use crate::{MeasuringTrack, Setting, SettingFit};
use foundation::geometry::{Flank, Sides};
use foundation::numerics::{extremes, power_series, root_mean_square};
use std::collections::BTreeMap;

/// How tool and workpiece stand.
pub(super) fn settings(bodies: &SkivingBodies) -> SkivingSettings {
    let motion = bodies.pair.motion();
    let tool = bodies.pair.tool();
    SkivingSettings {
        centre_distance_mm: motion.centre_distance,
        crossed_axes_angle_deg: motion.crossed_axes_angle.to_degrees(),
        tool_shift_mm: motion.tool_shift,
        ratio: motion.ratio,
        tool_pitch_radius_mm: tool.pitch_radius(),
        rounding_depth_mm: tool.rounding().depth(),
        cutting_sense: bodies.edges.left.cutting_direction(),
    }
}

/// Tracks with their poses.
pub(super) fn track_results(bodies: &SkivingBodies) -> BTreeMap<&'static str, Vec<TrackResult>> {
    let of_flank = |flank: Flank| {
        let all = bodies.flanks[flank].tracks.iter().zip(&bodies.nearest[flank]).enumerate();
        let rows = all.map(|(number, ((track, pose), nearest))| {
            let (contact, section) = (&track.contact, &track.section);
            TrackResult {
                track: number + 1,
                place: track.place,
                w_mm: contact.w,
                tool_angle_deg: contact.tool_angle.to_degrees(),
                point_mm: contact.point.into(),
                normal: contact.normal.into(),
                radius_mm: track.radius(),
                height_mm: track.height(),
                contact_angle_deg: section.contact_angle.to_degrees(),
                rounding_deg: section.range.map(f64::to_degrees),
                lever_mm_per_rad: contact.lever,
                a_deg: pose.swivel.to_degrees(),
                b_deg: pose.turn.to_degrees(),
                position_mm: pose.position.into(),
                off_flank_deg: pose.off_flank.to_degrees(),
                other_flank_gap_mm: nearest.gap,
                single_sigma_um: 1e3 * bodies.barrier.single_deviation(contact.lever),
            }
        });
        (flank.name(), rows.collect())
    };
    Flank::BOTH.into_iter().map(of_flank).collect()
}

/// The workpiece to come: predicted, under the referee, after the correction.
pub(super) fn flank_results(
    bodies: &SkivingBodies,
    measurement: Option<&Measurement>,
    left: &UnderReferee,
) -> BTreeMap<&'static str, SkivedFlankResult> {
    let of_flank = |flank: Flank| (flank.name(), flank_result(bodies, measurement, left, flank));
    Flank::BOTH.into_iter().map(of_flank).collect()
}

fn flank_result(
    bodies: &SkivingBodies,
    measurement: Option<&Measurement>,
    left: &UnderReferee,
    flank: Flank,
) -> SkivedFlankResult {
    let tracks = &bodies.flanks[flank].tracks;
    let target: Vec<f64> = tracks.iter().map(|(track, _)| 1e3 * track.contact.modification).collect();
    let zero = || vec![0.0; tracks.len()];
    // What the mean tooth leaves beyond the target, um; of every tooth what it leaves with its own mounting.
    let mean = measurement.map_or_else(zero, |m| um(&m.evaluation.profile.workpiece[flank]));
    let of_teeth: Vec<Vec<f64>> = match measurement {
        Some(m) => {
            m.evaluation.clocked.of[flank].iter().map(|f| f.iter().map(|f| -1e3 * f).collect()).collect()
        }
        None => vec![vec![0.0]; tracks.len()],
    };
    let corrected = measurement.map_or_else(zero, |m| {
        // Left first, as the rows of the fit stand.
        let from = if flank == Flank::Left { 0 } else { bodies.flanks.left.tracks.len() };
        um(&m.correction.residual[from..from + tracks.len()])
    });
    let plus = |values: &[f64]| -> Vec<f64> { values.iter().zip(&target).map(|(f, t)| f + t).collect() };
    // Broken teeth and those without a switch do not count for the mean tooth.
    let counts = |tooth: usize| measurement.is_none_or(|m| m.evaluation.counting[tooth]);
    let means = |left: &Left| -> Vec<f64> {
        let mean = |teeth: &Vec<f64>| {
            let taken: Vec<f64> =
                teeth.iter().enumerate().filter(|(tooth, _)| counts(*tooth)).map(|(_, f)| *f).collect();
            1e3 * taken.iter().sum::<f64>() / taken.len().max(1) as f64
        };
        left[flank].iter().map(mean).collect()
    };
    let simulated = means(&left.now);
    let planned = plus(&mean);
    let deviations: Vec<f64> = simulated.iter().zip(&target).map(|(f, t)| f - t).collect();
    let column = |values: &[f64]| -> Vec<Vec<f64>> { values.iter().map(|v| vec![*v]).collect() };
    SkivedFlankResult {
        w_mm: tracks.iter().map(|(track, _)| track.contact.w).collect(),
        z_mm: vec![0.0],
        planned_um: column(&planned),
        simulated_um: column(&simulated),
        teeth_um: of_teeth.iter().zip(&target).map(|(t, at)| extremes(t.iter().map(|f| f + at))).collect(),
        corrected_um: plus(&corrected),
        corrected_simulated_um: left.corrected.as_ref().map(means),
        max_deviation_um: extremes(deviations.iter().map(|f| f.abs()))[1],
        rms_deviation_um: root_mean_square(&deviations),
        model_difference_um: model_difference(bodies, measurement, &left.now, flank),
        target_um: column(&target),
    }
}

/// Largest difference between referee and prediction without noise: of the mean tooth, and of any whole tooth, um. A broken one is off
/// by more than a linear prediction tells.
fn model_difference(
    bodies: &SkivingBodies,
    measurement: Option<&Measurement>,
    left: &Left,
    flank: Flank,
) -> [f64; 2] {
    let (mut of_mean, mut each) = (0.0f64, 0.0f64);
    for (number, (track, _)) in bodies.flanks[flank].tracks.iter().enumerate() {
        let contact = &track.contact;
        let told = |tooth: usize| {
            let f = measurement.map_or(0.0, |m| m.told.of[flank][number][tooth]);
            contact.modification - f
        };
        let counts = |tooth: &usize| measurement.is_none_or(|m| m.evaluation.counting[*tooth]);
        let teeth = left[flank][number].iter().enumerate().filter(|(tooth, _)| counts(tooth));
        let differences: Vec<f64> = teeth.map(|(tooth, found)| 1e3 * (found - told(tooth))).collect();
        each = each.max(extremes(differences.iter().map(|d| d.abs()))[1]);
        of_mean = of_mean.max((differences.iter().sum::<f64>() / differences.len().max(1) as f64).abs());
    }
    [of_mean, each]
}

/// Figures of a measured tool.
pub(super) fn measurement_result(bodies: &SkivingBodies, m: &Measurement) -> MeasurementResult {
    let by_flank = |of: &Sides<Vec<f64>>| Flank::BOTH.into_iter().map(|f| (f.name(), um(&of[f]))).collect();
    let evaluation = &m.evaluation;
    let missing = &m.measured.missing;
    let sigma = m.deviations(bodies);
    MeasurementResult {
        readings: m.readings.len(),
        readings_each: m.measured.readings_each,
        deviation_um: of_teeth(&m.measured.deviations, missing),
        remaining_um: of_teeth(&evaluation.remaining, missing),
        missing: missing
            .iter()
            .map(|s| MissingResult { flank: s.flank.name(), track: s.track + 1, tooth: s.tooth })
            .collect(),
        sense_difference_um: m.measured.sense_difference.as_ref().map(by_flank),
        clocking_deg: evaluation.clocking.to_degrees(),
        pitch: pitch(bodies, evaluation, &m.measured.incomplete()),
        mounting: mounting(evaluation),
        profile: profile(bodies, evaluation),
        correction: correction(bodies, &m.correction, &evaluation.profile.workpiece),
        resharpening: ResharpeningResult {
            depth_mm: m.resharpening.depth_mm,
            axial_depth_mm: m.resharpening.axial_depth_mm,
            without_broken: m.resharpening.without_broken,
            broken: m.resharpening.broken.clone(),
            not_covered: m.resharpening.not_covered.clone(),
        },
        sigma_um: by_flank(&sigma),
    }
}

fn um(values: &[f64]) -> Vec<f64> {
    values.iter().map(|mm| 1e3 * mm).collect()
}

fn of_teeth(
    deviations: &Deviations,
    missing: &[MissingSwitch],
) -> BTreeMap<&'static str, Vec<Vec<Option<f64>>>> {
    let of_flank = |flank: Flank| {
        let of_track = |(track, teeth): (usize, &Vec<f64>)| {
            let there = |tooth: usize| !missing.contains(&MissingSwitch { flank, track, tooth });
            teeth.iter().enumerate().map(|(tooth, mm)| there(tooth).then_some(1e3 * mm)).collect()
        };
        (flank.name(), deviations.of[flank].iter().enumerate().map(of_track).collect())
    };
    Flank::BOTH.into_iter().map(of_flank).collect()
}

fn pitch(bodies: &SkivingBodies, evaluation: &Evaluation, incomplete: &[usize]) -> PitchResult {
    let p = &evaluation.pitch;
    let middle = bodies.flanks.left.tracks.len() / 2;
    let radius = |flank: Flank| bodies.flanks[flank].tracks[middle].0.radius();
    let radius = 0.5 * (radius(Flank::Left) + radius(Flank::Right));
    let [cos, sin] = p.first_harmonic;
    let teeth = bodies.teeth();
    let known = |tooth: usize| !incomplete.contains(&tooth);
    let of_known = |values: &[f64], known: &dyn Fn(usize) -> bool| -> Vec<Option<f64>> {
        values.iter().enumerate().map(|(tooth, mm)| known(tooth).then_some(1e3 * mm)).collect()
    };
    PitchResult {
        single_um: (0..teeth)
            .map(|tooth| (known(tooth) && known((tooth + 1) % teeth)).then_some(1e3 * p.single[tooth]))
            .collect(),
        // Tooth 0 is where it counts from.
        cumulative_um: of_known(&p.cumulative, &|tooth| known(tooth) && known(0)),
        largest_single_um: 1e3 * p.largest_single,
        total_um: 1e3 * p.total,
        first_harmonic_um: 1e3 * radius * cos.hypot(sin),
        first_harmonic_deg: sin.atan2(cos).to_degrees(),
        thickness_um: of_known(&p.thickness, &known),
        centre_deg: p.centres[middle]
            .iter()
            .enumerate()
            .map(|(tooth, angle)| known(tooth).then_some(angle.to_degrees()))
            .collect(),
    }
}

fn mounting(evaluation: &Evaluation) -> MountingResult {
    let m = &evaluation.mounting;
    let [x, y, about_x, about_y] = m.deviation;
    let told = |values: [f64; 2], scale: f64| {
        values.iter().all(|v| v.is_finite()).then(|| values.map(|v| scale * v))
    };
    MountingResult {
        eccentricity_um: m.eccentricity.map(|mm| 1e3 * mm),
        eccentricity_sigma_um: told([x, y], 1e3),
        wobble_urad: m.wobble.map(|rad| 1e6 * rad),
        wobble_sigma_urad: told([about_x, about_y], 1e6),
        left_out: m.left_out.clone(),
    }
}

fn profile(bodies: &SkivingBodies, evaluation: &Evaluation) -> ProfileResult {
    let p = &evaluation.profile;
    let by_flank = |of: &Sides<Vec<f64>>| Flank::BOTH.into_iter().map(|f| (f.name(), um(&of[f]))).collect();
    let off = |flank: Flank, tooth: usize| {
        let of_track = |(number, (track, _)): (usize, &(MeasuringTrack, _))| {
            let f = evaluation.remaining.of[flank][number][tooth];
            (f - power_series(&p.curve[flank], track.place)[0]).abs()
        };
        1e3 * extremes(bodies.flanks[flank].tracks.iter().enumerate().map(of_track))[1]
    };
    let tooth = |(flank, tooth): &(Flank, usize)| ToothOnFlank {
        flank: flank.name(),
        tooth: *tooth,
        off_um: off(*flank, *tooth),
    };
    ProfileResult {
        track_mean_um: by_flank(&p.track_means),
        curve_um: by_flank(&p.curve),
        band_um: 1e3 * bodies.options.band,
        out_of_band: p.out_of_band.iter().map(tooth).collect(),
        wear_limit_um: 1e3 * bodies.options.wear_limit,
        worn: Flank::BOTH.into_iter().map(|flank| (flank.name(), p.worn[flank])).collect(),
    }
}

pub(super) fn correction(
    bodies: &SkivingBodies,
    fit: &SettingFit,
    before: &Sides<Vec<f64>>,
) -> CorrectionResult {
    let [distance, angle, shift, turn] = fit.change;
    let largest = |values: &mut dyn Iterator<Item = f64>| values.map(f64::abs).fold(0.0, f64::max);
    let mut before = before.iter().flat_map(|(_, of)| of.iter().copied());
    CorrectionResult {
        centre_distance_um: 1e3 * distance,
        crossed_axes_angle_deg: angle.to_degrees(),
        tool_shift_um: 1e3 * shift,
        tool_angle_deg: turn.to_degrees(),
        settings: bodies.free.iter().map(|setting| setting_name(*setting)).collect(),
        at_limit: fit.limited.iter().map(|setting| setting_name(*setting)).collect(),
        rms_um: fit.rms.map(|mm| 1e3 * mm),
        largest_um: [1e3 * largest(&mut before), 1e3 * largest(&mut fit.residual.iter().copied())],
    }
}

/// A setting in words.
fn setting_name(setting: Setting) -> &'static str {
    match setting {
        Setting::CentreDistance => "centre distance",
        Setting::CrossedAxesAngle => "crossed-axes angle",
        Setting::ToolShift => "tool shift",
        Setting::ToolAngle => "tool angle",
    }
}
