//! The tactile variant: a stylus of cylindrical shape runs along the edge while the axes follow, all of them or without Y and Z
//! (`docs/mathematics/skiving.md#tracks-and-poses`).

use super::pose::tangent;
use super::{Beam, MeasuringPose};
use crate::{MeasuringTrack, SkivingError, VirtualEdge};
use foundation::geometry::Flank;
use foundation::numerics::{brent, equidistant};
use std::f64::consts::FRAC_PI_2;

/// Which axes follow the edge.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum ScanAxes {
    /// A, B, X, Y; and Z where the stylus is tilted, else it stays that of the middle.
    #[default]
    All,
    /// A, B, X: Y stays where it is at the middle of the edge, and so does Z along an upright stylus.
    WithoutY,
}

/// A place of a scan.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ScanPlace {
    /// The place of the edge.
    pub track: MeasuringTrack,
    /// Where the axes stand.
    pub pose: MeasuringPose,
}

/// How far B may go from the turn in which the tool cuts to hold Y, rad.
const REACH: f64 = 0.15;

/// Poses along an edge, from x = `from` to `to` of its length.
///
/// # Errors
/// [`SkivingError::PoseNotReachable`] where the stylus cannot be tangential, or no turn holds Y; [`SkivingError::InvalidNumber`].
pub fn scan_curve(
    edge: &VirtualEdge,
    stylus: &Beam,
    axes: ScanAxes,
    [from, to]: [f64; 2],
    places: usize,
) -> Result<Vec<ScanPlace>, SkivingError> {
    if places < 2 {
        let (field, value) = ("scan.places", places as f64);
        return Err(SkivingError::InvalidNumber { field, value, allowed: "at least 2" });
    }
    let flank = edge.side();
    let at = |track: &MeasuringTrack, turn: f64, number: usize| {
        tangent(track, stylus, turn)
            .ok_or_else(|| unreachable(flank, number, "the stylus is tilted too much"))
    };
    let middle = MeasuringTrack::new(edge, 0.0)?;
    let held = at(&middle, middle.contact.tool_angle + FRAC_PI_2, 0)?.position.y;
    let mut scan = Vec::with_capacity(places);
    for (number, x) in equidistant([from, to], places).into_iter().enumerate() {
        let track = MeasuringTrack::new(edge, x)?;
        let cutting = track.contact.tool_angle + FRAC_PI_2;
        let turn = match axes {
            ScanAxes::All => cutting,
            ScanAxes::WithoutY => {
                let off = |turn: f64| tangent(&track, stylus, turn).map(|pose| pose.position.y - held);
                let ends = [cutting - REACH, cutting + REACH];
                let values = ends.map(|turn| off(turn).unwrap_or(f64::NAN));
                brent(ends, values, 0.0, off)
                    .ok_or_else(|| unreachable(flank, number, "no turn of the tool holds Y"))?
            }
        };
        scan.push(ScanPlace { pose: at(&track, turn, number)?, track });
    }
    // Along an upright stylus the height is free: it stays that of the middle.
    if stylus.direction.xy().norm() == 0.0 {
        let height = at(&middle, middle.contact.tool_angle + FRAC_PI_2, 0)?.position.z;
        scan.iter_mut().for_each(|place| place.pose.position.z = height);
    }
    Ok(scan)
}

fn unreachable(flank: Flank, track: usize, reason: &str) -> SkivingError {
    SkivingError::PoseNotReachable { flank, track, reason: reason.into() }
}
