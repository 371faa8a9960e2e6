//! Where both edges of a tooth switch the beam, over the radius of the tracks: nominal, measured, compensation curve, tolerance band.

mod chart;
mod switching_angles;
mod table;

use crate::workflow::SkivingOutcome;
use report::charts::{ChartError, format_significant};
use report::{Block, Figure};
use switching_angles::SwitchingAngles;

/// Tooth 0, and the tooth that leaves its band the farthest, if one does; nothing where nothing is measured.
pub(super) fn blocks(outcome: &SkivingOutcome) -> Result<Vec<Block>, ChartError> {
    let (Some(measurement), Some(measured)) = (&outcome.measurement, &outcome.result.measurement) else {
        return Ok(Vec::new());
    };
    let out = &measured.profile.out_of_band;
    let farthest = out.iter().max_by(|a, b| a.off_um.total_cmp(&b.off_um)).map(|found| found.tooth);
    let mut blocks = Vec::new();
    for tooth in [0].into_iter().chain(farthest.filter(|tooth| *tooth != 0)) {
        let angles = SwitchingAngles::new(&outcome.prepared.bodies, &measurement.evaluation, tooth);
        let factor = angles.magnification()?;
        let caption = format!(
            "Angles at which the beam switches, about the middle of the nominal tooth; deviations from the nominal edge are drawn {} times as \
             large. Dashed: the band D = {} µm about the compensation curve.",
            format_significant(factor, 6),
            format_significant(angles.band_um, 4)
        );
        let id = format!("angular-positions-of-the-edges-of-tooth-{tooth}");
        blocks.push(Block::Figure(Figure::new(id, chart::chart(&angles, factor)?, caption)));
        blocks.push(Block::Table(table::table(&angles)?));
    }
    Ok(blocks)
}
