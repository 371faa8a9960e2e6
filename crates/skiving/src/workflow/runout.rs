//! The run-out of a measured tool: the law that answers it, what prediction and referee say of it, the stroke that is driven with it.

use super::finding::failure;
use super::measurement::Measurement;
use super::prepare::PreparedSkiving;
use super::programs::SkivingWork;
use super::referee::{Left, UnderReferee, corrected};
use super::result::RunoutResult;
use crate::runout::{RunoutFit, angle_of, fit_runout, spread};
use crate::setting_sensitivity;
use foundation::geometry::Flank;
use run::RunFailure;

/// The law of a job, fitted to its measured teeth; none without both.
///
/// # Errors
/// [`RunFailure`]: more orders than the teeth tell.
pub(super) fn fitted(
    prepared: &PreparedSkiving,
    measurement: Option<&Measurement>,
) -> Result<Option<RunoutFit>, RunFailure> {
    let (Some(given), Some(measurement)) = (&prepared.runout, measurement) else { return Ok(None) };
    let fit = fit_runout(&prepared.bodies.flanks, &measurement.evaluation, given.law.axes(), given.orders);
    Ok(Some(fit.map_err(|error| failure(&error))?))
}

/// Figures of a law.
pub(super) fn result(
    prepared: &PreparedSkiving,
    measurement: &Measurement,
    fit: &RunoutFit,
    left: &UnderReferee,
) -> RunoutResult {
    let counting = &measurement.evaluation.counting;
    let simulated = |left: &Left| 1e3 * spread(left, counting);
    let [distance, turn] = fit.law.amplitudes();
    RunoutResult {
        centre_distance_um: fit.law.centre_distance.iter().map(|term| term.map(|mm| 1e3 * mm)).collect(),
        work_angle_deg: fit.law.work_angle.iter().map(|term| term.map(f64::to_degrees)).collect(),
        centre_distance_amplitude_um: 1e3 * distance,
        work_angle_amplitude_deg: turn.to_degrees(),
        spread_um: fit.spread.map(|mm| 1e3 * mm),
        simulated_spread_um: [simulated(&left.now), left.corrected.as_ref().map_or(f64::NAN, simulated)],
        model_difference_um: left
            .corrected
            .as_ref()
            .map_or(f64::NAN, |after| 1e3 * model_difference(prepared, measurement, fit, after)),
    }
}

/// Greatest difference of any counting tooth between the referee and the prediction with law and correction, mm.
fn model_difference(
    prepared: &PreparedSkiving,
    measurement: &Measurement,
    fit: &RunoutFit,
    after: &Left,
) -> f64 {
    let bodies = &prepared.bodies;
    let (motion, teeth) = (bodies.pair.motion(), bodies.teeth());
    let mut most = 0.0f64;
    for flank in Flank::BOTH {
        for (number, (track, _)) in bodies.flanks[flank].tracks.iter().enumerate() {
            let contact = &track.contact;
            let by = setting_sensitivity(motion, contact);
            let moved: f64 = by.iter().zip(&measurement.correction.change).map(|(s, x)| s * x).sum();
            for tooth in (0..teeth).filter(|tooth| measurement.evaluation.counting[*tooth]) {
                let [distance, turn] = fit.law.at(angle_of(contact.tool_angle, tooth, teeth));
                let law = by[0] * distance - by[3] * turn / motion.ratio;
                let told = contact.modification - measurement.told.of[flank][number][tooth] + moved + law;
                most = most.max((after[flank][number][tooth] - told).abs());
            }
        }
    }
    most
}

/// The stroke that a job wants written.
pub(super) fn stroke<'a>(
    prepared: &'a PreparedSkiving,
    measurement: Option<&'a Measurement>,
    fit: Option<&'a RunoutFit>,
    after: Option<&'a Left>,
) -> Option<SkivingWork<'a>> {
    let (measurement, fit) = (measurement?, fit?);
    let bodies = &prepared.bodies;
    let stroke = prepared.runout?.stroke?;
    let heights: Vec<f64> = bodies
        .edges
        .iter()
        .flat_map(|(_, edge)| edge.flank().range().map(|w| edge.contact(w)))
        .filter_map(|contact| contact.ok().map(|contact| contact.engagement.z))
        .collect();
    let half = 0.5 * prepared.drawn.gear.face_width;
    Some(SkivingWork {
        name: &prepared.info.name,
        bodies,
        measurement,
        motion: corrected(bodies.pair.motion(), &measurement.correction.change),
        law: &fit.law,
        after,
        clocking: measurement.evaluation.clocking,
        engagement: [
            heights.iter().copied().fold(f64::INFINITY, f64::min),
            heights.iter().copied().fold(f64::NEG_INFINITY, f64::max),
        ],
        face: [-half, half],
        speed: stroke.tool_speed_rpm * std::f64::consts::TAU / 60.0,
        feed: stroke.feed,
        overrun: stroke.overrun,
        blocks_per_turn: stroke.blocks_per_turn,
        work_height: stroke.work_height,
    })
}
