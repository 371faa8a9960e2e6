//! Light and dark over one turn of the tool, in the pose of the left flank's middle track.

use crate::SkivingError;
use crate::measuring::{Barrier, DarkBand, RealTool, dark_band};
use crate::page::{StripView, ToothMark, ToothSignal};
use crate::workflow::run::SkivingOutcome;
use foundation::geometry::Flank;

const FLANK: Flank = Flank::Left;

/// The strip; of a real tool the ideal one's with every edge moved by its deviation. `None` where the pose does not let the other edge
/// through the beam.
pub(super) fn strip(outcome: &SkivingOutcome) -> Option<StripView> {
    let bodies = &outcome.bodies;
    let teeth = bodies.teeth();
    let middle = bodies.flanks[FLANK].tracks.len() / 2;
    let (track, pose) = &bodies.flanks[FLANK].tracks[middle];
    let barrier = Barrier { beam: &bodies.beam, pose };
    let band = |tool: &RealTool, tooth: usize| -> Result<Option<DarkBand>, SkivingError> {
        dark_band(&barrier, &bodies.edges, tool, (FLANK, track), tooth)
    };
    let ideal = RealTool::ideal(teeth);
    let first = band(&ideal, 0).ok().flatten()?;
    let pitch = 360.0 / teeth as f64;
    let zero = 0.5 * (first.measured + first.opposite);
    let simulated = outcome.measurement.as_ref().and_then(|m| m.tool.as_ref());
    let mut signals = Vec::with_capacity(teeth);
    for place in 0..teeth {
        // The spindle turns on, the teeth follow each other the other way round.
        let tooth = (teeth - place) % teeth;
        let found = band(simulated.unwrap_or(&ideal), tooth).ok()?;
        let mut ends = found.map(|found| [found.measured, found.opposite]);
        if let (Some(ends), Some(measurement), None) = (&mut ends, &outcome.measurement, simulated) {
            for (end, flank) in ends.iter_mut().zip([FLANK, FLANK.other()]) {
                let lever = bodies.flanks[flank].tracks[middle].0.contact.lever;
                *end -= measurement.evaluation.clocked.of[flank][middle][tooth] / lever;
            }
        }
        let turns = if tooth == 0 { 0.0 } else { 360.0 };
        let dark_deg = ends.map(|ends| {
            let [a, b] = ends.map(|turn| (turn - zero).to_degrees() + turns);
            [a.min(b), a.max(b)]
        });
        let out = outcome
            .measurement
            .as_ref()
            .is_some_and(|m| m.evaluation.profile.out_of_band.iter().any(|(_, found)| *found == tooth));
        let mark = match (dark_deg, out) {
            (None, _) => Some(ToothMark::Broken),
            (_, true) => Some(ToothMark::OutOfBand),
            _ => None,
        };
        signals.push(ToothSignal { tooth, middle_deg: place as f64 * pitch, dark_deg, mark });
    }
    Some(StripView { flank: FLANK, track: middle + 1, teeth: signals })
}
