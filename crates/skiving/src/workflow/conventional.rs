//! What the usual way of measuring, the beam parallel to the tool's axis in every pose, would report of the same tool.

use super::measurement::Measurement;
use super::prepare::SkivingBodies;
use super::result::ConventionalResult;
use crate::measuring::{RealTool, conventional_reading};
use crate::{MeasuringTrack, SkivingError, VirtualEdge};
use foundation::geometry::Flank;

/// Track by track; empty with a tilted beam, for which there is no usual way, and for a real tool, whose edges are not known.
pub(super) fn conventional(
    bodies: &SkivingBodies,
    measurement: Option<&Measurement>,
) -> Vec<ConventionalResult> {
    if bodies.beam.direction.xy().norm() != 0.0 {
        return Vec::new();
    }
    let ideal = RealTool::ideal(bodies.teeth());
    let mut rows = Vec::new();
    for flank in Flank::BOTH {
        let of = &bodies.flanks[flank];
        for (number, (track, _)) in of.tracks.iter().enumerate() {
            let of_ideal = mean_reading(bodies, &of.edge, &ideal, track);
            let simulated = measurement.and_then(|m| m.tool.as_ref());
            let of_tool = simulated.map(|tool| mean_reading(bodies, &of.edge, tool, track));
            let teeth = |m: &Measurement| {
                let all = &m.measured.deviations.of[flank][number];
                all.iter().sum::<f64>() / all.len() as f64
            };
            rows.push(ConventionalResult {
                flank: flank.name(),
                track: number + 1,
                rests_on: of_ideal.as_ref().err().map(|error| error.code()),
                ideal_um: of_ideal.as_ref().ok().map(|mm| 1e3 * mm),
                touch_deg: touch(bodies, &of.edge, &ideal, track),
                reported_um: of_tool.and_then(Result::ok).map(|mm| 1e3 * mm),
                measured_um: measurement.map(|m| 1e3 * teeth(m)),
            });
        }
    }
    rows
}

/// Where its beam touches the ideal tool, deg.
fn touch(
    bodies: &SkivingBodies,
    edge: &VirtualEdge,
    ideal: &RealTool,
    track: &MeasuringTrack,
) -> Option<f64> {
    conventional_reading(edge, ideal, track, &bodies.beam, 0).ok().map(|found| found.angle.to_degrees())
}

/// Mean over the teeth of what it reports; an ideal tool has but one kind of tooth.
fn mean_reading(
    bodies: &SkivingBodies,
    edge: &VirtualEdge,
    tool: &RealTool,
    track: &MeasuringTrack,
) -> Result<f64, SkivingError> {
    let read = |tooth: usize| conventional_reading(edge, tool, track, &bodies.beam, tooth);
    let teeth = if *tool == RealTool::ideal(tool.teeth()) { 1 } else { tool.teeth() };
    let sum = (0..teeth).map(|tooth| read(tooth).map(|found| found.deviation)).sum::<Result<f64, _>>()?;
    Ok(sum / teeth as f64)
}
