//! A tool rebuilt from its measurement: every edge with the profile that its deviations on the tracks tell. Pitch, mounting and wear are
//! all in those profiles; what they come from does not matter to what the edge leaves.

use super::Deviations;
use super::profile::polynomial;
use crate::SkivingError;
use crate::measuring::{EdgeErrors, FlankTracks, RealTool};
use foundation::geometry::Sides;

/// Largest degree of a rebuilt profile: beyond it follows noise rather than edges.
const DEGREE: usize = 4;

/// The tool that has these deviations, as polynomials through or, of more than five tracks, nearest to them.
///
/// # Errors
/// [`SkivingError::TooFewTracks`].
pub fn tool_as_measured(
    flanks: &Sides<FlankTracks>,
    deviations: &Deviations,
) -> Result<RealTool, SkivingError> {
    let teeth = deviations.teeth();
    let edges = Sides::try_from_fn(|flank| {
        let places: Vec<f64> = flanks[flank].tracks.iter().map(|(track, _)| track.place).collect();
        let degree = DEGREE.min(places.len().saturating_sub(1));
        let edge = |tooth: usize| {
            let values: Vec<f64> = deviations.of[flank].iter().map(|teeth| teeth[tooth]).collect();
            let profile = polynomial(&places, &values, degree)?;
            Ok(EdgeErrors { profile, growth: Vec::new() })
        };
        (0..teeth).map(edge).collect::<Result<Vec<_>, SkivingError>>()
    })?;
    Ok(RealTool { edges, ..RealTool::ideal(teeth) })
}
