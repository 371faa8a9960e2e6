//! Light and dark over one turn of the tool, in the pose of the left flank's middle track.

use crate::SkivingError;
use crate::measuring::{Barrier, DarkBand, RealTool, dark_band};
use crate::workflow::SkivingOutcome;
use foundation::geometry::Flank;
use report::charts::{ChartError, SignalStrip, StripCell, signal_strip};
use report::{Block, Figure};

const FLANK: Flank = Flank::Left;
/// Numbers of the signs.
const OUT_OF_BAND: usize = 0;
const BROKEN: usize = 1;

/// The strip; nothing where the pose does not let the other edge through the beam.
pub(super) fn blocks(outcome: &SkivingOutcome) -> Result<Vec<Block>, ChartError> {
    let middle = outcome.prepared.bodies.flanks[FLANK].tracks.len() / 2;
    let Some(cells) = cells(outcome, middle) else { return Ok(Vec::new()) };
    let strip = SignalStrip {
        title: "Light and dark over one turn of the tool".into(),
        subtitle: format!("pose of the {FLANK} flank, track {}; angle of the spindle [deg]", middle + 1),
        cells,
        signs: vec!["out of the band (dark stretch hatched)".into(), "broken: stays light".into()],
    };
    let caption = "Numbers are those of the teeth, at the middle of each ideal dark stretch. Only the edge of the pose touches at its contact point; the \
                   other end of a dark stretch is met elsewhere on the opposite edge.";
    let id = "light-and-dark-over-one-turn-of-the-tool";
    Ok(vec![Block::Figure(Figure::new(id, signal_strip(&strip)?, caption))])
}

/// Light and dark of all teeth in the pose of a track, in the order in which they pass; of a real tool the ideal one's with every edge moved by its deviation. `None` where the pose does not let the other edge
/// through the beam.
fn cells(outcome: &SkivingOutcome, middle: usize) -> Option<Vec<StripCell>> {
    let bodies = &outcome.prepared.bodies;
    let teeth = bodies.teeth();
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
    let mut cells = Vec::with_capacity(teeth);
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
        let sign = match (dark_deg, out) {
            (None, _) => Some(BROKEN),
            (_, true) => Some(OUT_OF_BAND),
            _ => None,
        };
        cells.push(StripCell { name: tooth.to_string(), middle_deg: place as f64 * pitch, dark_deg, sign });
    }
    Some(cells)
}
