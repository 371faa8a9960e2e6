//! The strip of light and dark that a whole tool leaves in one pose: both edges of every tooth switch, only one of them is measured
//! (`docs/mathematics/skiving.md#light-barrier`).

use super::{Barrier, RealTool};
use crate::{MeasuringTrack, SkivingError, VirtualEdge};
use foundation::geometry::{Flank, Sides};

/// The dark part of one tooth, turns B in rad.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DarkBand {
    /// Where the measured edge switches.
    pub measured: f64,
    /// Where the other edge of the tooth switches.
    pub opposite: f64,
    /// Length of roll at which the other edge is met, mm; it may lie off its rounding.
    pub opposite_roll: f64,
    /// Angle of that touch on the other edge's rounding.
    pub opposite_angle: f64,
    /// What is left of the other edge's equations, mm.
    pub residual: f64,
}

/// How far outside the beam the search of the other edge begins, in radii of the beam.
const BESIDE: f64 = 4.0;

/// The dark part of a tooth; `None` of a broken one, which leaves the beam light.
///
/// # Errors
/// Those of [`Barrier::touch`]; [`SkivingError::NoTrigger`] where the other edge is not met.
pub fn dark_band(
    barrier: &Barrier,
    edges: &Sides<VirtualEdge>,
    tool: &RealTool,
    (flank, track): (Flank, &MeasuringTrack),
    tooth: usize,
) -> Result<Option<DarkBand>, SkivingError> {
    if tool.broken[tooth] {
        return Ok(None);
    }
    let radius = barrier.beam.radius;
    let measured = barrier.touch(&edges[flank], tool, track, tooth, radius)?;
    let other = &edges[flank.other()];
    // The other edge where it passes the measured one's place, a little before it meets the beam.
    let middle = MeasuringTrack::new(other, track.place)?;
    let azimuth = |track: &MeasuringTrack| track.contact.point.y.atan2(track.contact.point.x);
    let lever = middle.contact.lever;
    let start = measured.turn + azimuth(track) - azimuth(&middle) - BESIDE * radius / lever;
    let opposite = barrier.anywhere(other, tool, tooth, radius, [middle.contact.w, start])?;
    Ok(Some(DarkBand {
        measured: measured.turn,
        opposite: opposite.turn,
        opposite_roll: opposite.w,
        opposite_angle: opposite.angle,
        residual: opposite.residual,
    }))
}
