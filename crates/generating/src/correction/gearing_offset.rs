//! What another crossing angle or centre distance does under an unchanged gearbox: with involute flanks an offset and nothing else, so that
//! neither ever corrects a profile or helix angle.

use super::CorrectionError;
use crate::GeneratingError;
use contact::Pair;
use foundation::geometry::Sides;

/// Exact offset of both flanks (f_n2, mm, > 0 material left) when the pair stands at another centre distance (+ `delta_d`, mm) and crossing
/// angle (+ `delta_gamma`, rad) than the gearbox was set for.
///
/// # Errors
/// Those of [`Pair::new`].
pub fn offset_of_gearing(pair: &Pair, delta_d: f64, delta_gamma: f64) -> Result<Sides<f64>, CorrectionError> {
    let mut chain = pair.chain;
    chain.centre_distance += delta_d;
    chain.crossed_axes_angle += delta_gamma;
    let moved = Pair::new(pair.worm, pair.work, chain).map_err(GeneratingError::from)?;
    Ok(pair.flanks.map(|flank, before| {
        // Angles of the workpiece at which the flanks touch without shift and feed.
        let turned = (moved.flanks[flank].phase - before.phase) / pair.work.tooth_count();
        let lever = before.work.base_radius * before.work.base_helix_angle.cos();
        flank.sign() * lever * turned
    }))
}
