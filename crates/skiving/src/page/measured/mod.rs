//! Deviations of all teeth on all tracks, the band about the compensation curve, and the teeth that leave it. Deviations are normal to the
//! flank at the virtual contact points, > 0 = material beyond the nominal edge.

mod over_edge;
mod over_teeth;
mod shown_teeth;
mod worst_teeth;

use crate::workflow::SkivingOutcome;
use over_teeth::over_teeth;
use report::charts::{ChartError, Svg};
use report::{Block, Figure};
use shown_teeth::ShownTeeth;
use worst_teeth::WorstTooth;

/// Charts and the teeth to look at; nothing where nothing is measured.
pub(super) fn blocks(outcome: &SkivingOutcome) -> Result<Vec<Block>, ChartError> {
    let (Some(measurement), Some(result)) = (&outcome.measurement, &outcome.result.measurement) else {
        return Ok(Vec::new());
    };
    let teeth = ShownTeeth::new(&outcome.prepared.bodies, measurement, result.profile.band_um);
    let worst = WorstTooth::all(&teeth);
    let figure = |id: &str, svg: Svg, caption: &str| Block::Figure(Figure::new(id, svg, caption));
    let mut blocks = vec![
        figure(
            "deviation-as-measured",
            over_teeth(
                "Deviation as measured",
                &teeth,
                |flank, track, tooth| teeth.measured_um(flank, track, tooth),
                None,
            )?,
            "Normal to the flank at the virtual contact points, without the clocking of the tool; positive is material beyond the nominal edge. \
             The wave over one turn is the mounting.",
        ),
        figure(
            "without-eccentricity-and-wobble-distance-from-the-compensation-curve",
            over_teeth(
                "Without eccentricity and wobble: distance from the compensation curve",
                &teeth,
                |flank, track, tooth| teeth.remaining_um(flank, track, tooth) - teeth.curve_um(flank, track),
                Some(&worst),
            )?,
            "What the teeth themselves are. Dashed: the band of ± D/2 about the compensation curve. A ring marks a tooth that the table names.",
        ),
        figure(
            "shape-of-the-edge",
            over_edge::chart(&teeth)?,
            "The same over the edge, from the smaller to the larger length of roll of the workpiece: mean, least and greatest of all teeth at every track.",
        ),
    ];
    if !worst.is_empty() {
        blocks.push(Block::Table(worst_teeth::table(&worst, teeth.band_um)?));
    }
    Ok(blocks)
}
