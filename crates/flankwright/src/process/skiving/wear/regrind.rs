//! What resharpening has to take off the rake faces of a tool, all of them in common, until every edge can be rounded like a fresh one.

use super::{WearError, recession, renewing_depth};
use crate::geometry::{Flank, Sides};
use crate::process::skiving::MeasuringTrack;
use crate::process::skiving::measuring::FlankTracks;

/// The place that asks for most.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DecidingPlace {
    /// Flank of the workpiece that the edge makes.
    pub flank: Flank,
    /// Track, from 0.
    pub track: usize,
    /// Tooth, from 0.
    pub tooth: usize,
    /// Growth of its rounding, mm.
    pub growth: f64,
}

/// What has to be ground off. mm. The teeth are ground along the tool's axis in common; a plane or a cone as rake face is then lower by
/// the same depth everywhere, a hollow sphere to the first order of the depth.
#[derive(Clone, Debug, PartialEq)]
pub struct Regrind {
    /// Depth along the rake face's normal at the deciding place; 0 where no edge has grown.
    pub depth: f64,
    /// The same along the tool's axis: `depth` over the z of the normal there.
    pub axial_depth: f64,
    /// The place that decides; `None` where no edge has grown.
    pub decides: Option<DecidingPlace>,
    /// Depth that every tooth's edge would ask for by itself, along the normal.
    pub each: Sides<Vec<f64>>,
    /// Deviation of every track of the resharpened tool from the nominal edge in the setting so far: it stands back along its clearance
    /// face. To the first order of the depth.
    pub recession: Sides<Vec<f64>>,
}

/// The depth for edges whose roundings have grown by `growths` (of each tooth, mm).
///
/// # Errors
/// [`WearError::OtherShape`], [`WearError::InvalidNumber`].
pub fn regrind(flanks: &Sides<FlankTracks>, growths: &Sides<Vec<f64>>) -> Result<Regrind, WearError> {
    let (left, right) = (growths.left.len(), growths.right.len());
    if left != right {
        return Err(WearError::OtherShape { field: "teeth", found: right, wanted: left });
    }
    if let Some(&value) = growths.left.iter().chain(&growths.right).find(|x| !x.is_finite()) {
        return Err(WearError::InvalidNumber { field: "growth", value, allowed: "finite numbers" });
    }
    let mut most = (0.0, 0.0, None);
    for (flank, of) in growths.iter() {
        for (tooth, &growth) in of.iter().enumerate() {
            for (number, (track, _)) in flanks[flank].tracks.iter().enumerate() {
                let depth = renewing_depth(&track.section, growth);
                let axial = depth / track.section.rake_normal.z;
                if axial > most.1 {
                    most = (depth, axial, Some(DecidingPlace { flank, track: number, tooth, growth }));
                }
            }
        }
    }
    let (depth, axial_depth, decides) = most;
    let tracks = |flank: Flank| flanks[flank].tracks.iter().map(|(track, _): &(MeasuringTrack, _)| track);
    Ok(Regrind {
        depth,
        axial_depth,
        decides,
        each: growths.map(|flank, of| {
            let needed = |growth: &f64| {
                tracks(flank).map(|track| renewing_depth(&track.section, *growth)).fold(0.0, f64::max)
            };
            of.iter().map(needed).collect()
        }),
        recession: Sides::from_fn(|flank| {
            let back = |track: &MeasuringTrack| {
                let section = &track.section;
                recession(section, section.contact_angle, axial_depth * section.rake_normal.z)
            };
            tracks(flank).map(back).collect()
        }),
    })
}
