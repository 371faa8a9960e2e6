//! What resharpening has to take off the rake faces of a tool, all of them in common, until every edge can be rounded like a fresh one:
//! by the growth of its rounding where it is worn, by the depth of its chip where it is broken.

use super::{WearError, chip_depth, recession, renewing_depth};
use crate::MeasuringTrack;
use crate::measuring::FlankTracks;
use foundation::geometry::{Flank, Sides};

/// How an edge is.
#[derive(Clone, Debug, PartialEq)]
pub enum EdgeState {
    /// Its rounding has grown by so much, mm.
    Worn(f64),
    /// It is broken: material that is missing on every track, normal to the flank, mm; < 0 where it stands out.
    Chipped(Vec<f64>),
    /// The measurement does not tell: it asks for nothing.
    Unknown,
}

/// Why an edge asks for a depth.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum RegrindCause {
    /// Growth of its rounding, mm.
    Wear(f64),
    /// Material that a chip has taken, normal to the flank, mm.
    Chip(f64),
}

/// The place that asks for most.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DecidingPlace {
    /// Flank of the workpiece that the edge makes.
    pub flank: Flank,
    /// Track, from 0.
    pub track: usize,
    /// Tooth, from 0.
    pub tooth: usize,
    /// Why.
    pub cause: RegrindCause,
}

/// A depth off the rake faces, mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GroundDepth {
    /// Along the rake face's normal at the deciding place.
    pub depth: f64,
    /// The same along the tool's axis: `depth` over the z of the normal there.
    pub axial_depth: f64,
}

/// What has to be ground off. mm. The teeth are ground along the tool's axis in common; a plane or a cone as rake face is then lower by
/// the same depth everywhere, a hollow sphere to the first order of the depth.
#[derive(Clone, Debug, PartialEq)]
pub struct Regrind {
    /// Depth along the rake face's normal at the deciding place; 0 where no edge has grown.
    pub depth: f64,
    /// The same along the tool's axis: `depth` over the z of the normal there.
    pub axial_depth: f64,
    /// The same without the broken edges, for a tool whose chips stay.
    pub whole: GroundDepth,
    /// The place that decides; `None` where no edge has grown.
    pub decides: Option<DecidingPlace>,
    /// Depth that every tooth's edge would ask for by itself, along the normal; `None` where the measurement does not tell.
    pub each: Sides<Vec<Option<f64>>>,
    /// Deviation of every track of the resharpened tool from the nominal edge in the setting so far: it stands back along its clearance
    /// face. To the first order of the depth.
    pub recession: Sides<Vec<f64>>,
}

/// The depth for whole edges whose roundings have grown by `growths` (of each tooth, mm).
///
/// # Errors
/// As [`regrind_edges`].
pub fn regrind(flanks: &Sides<FlankTracks>, growths: &Sides<Vec<f64>>) -> Result<Regrind, WearError> {
    regrind_edges(flanks, &growths.map(|_, of| of.iter().map(|growth| EdgeState::Worn(*growth)).collect()))
}

/// The depth for worn and broken edges, of each tooth. A measurement of edges shows no chip beneath the place at which it is widest: what
/// a broken edge asks for is the least that takes away what is seen of it.
///
/// # Errors
/// [`WearError::OtherShape`], [`WearError::InvalidNumber`].
pub fn regrind_edges(
    flanks: &Sides<FlankTracks>,
    edges: &Sides<Vec<EdgeState>>,
) -> Result<Regrind, WearError> {
    let (left, right) = (edges.left.len(), edges.right.len());
    if left != right {
        return Err(WearError::OtherShape { field: "teeth", found: right, wanted: left });
    }
    for (flank, of) in edges.iter() {
        of.iter().try_for_each(|edge| check(edge, flanks[flank].tracks.len()))?;
    }
    let (mut most, mut whole) = (Most::default(), Most::default());
    for (flank, of) in edges.iter() {
        for (tooth, edge) in of.iter().enumerate() {
            for (track, (at, _)) in flanks[flank].tracks.iter().enumerate() {
                let Some((depth, cause)) = asked(at, track, edge) else { continue };
                if !depth.is_finite() {
                    let allowed = "a contact before the end of the clearance face";
                    return Err(WearError::InvalidNumber { field: "depth", value: depth, allowed });
                }
                let axial = depth / at.section.rake_normal.z;
                let place = DecidingPlace { flank, track, tooth, cause };
                most.take(depth, axial, place);
                if matches!(cause, RegrindCause::Wear(_)) {
                    whole.take(depth, axial, place);
                }
            }
        }
    }
    let tracks = |flank: Flank| flanks[flank].tracks.iter().map(|(track, _): &(MeasuringTrack, _)| track);
    Ok(Regrind {
        depth: most.depth,
        axial_depth: most.axial,
        whole: GroundDepth { depth: whole.depth, axial_depth: whole.axial },
        decides: most.place,
        each: edges.map(|flank, of| {
            let needed = |edge: &EdgeState| {
                let asked = tracks(flank).enumerate().filter_map(|(k, track)| asked(track, k, edge));
                asked.map(|(depth, _)| depth).reduce(f64::max)
            };
            of.iter().map(needed).collect()
        }),
        recession: Sides::from_fn(|flank| {
            let back = |track: &MeasuringTrack| {
                let section = &track.section;
                recession(section, section.contact_angle, most.axial * section.rake_normal.z)
            };
            tracks(flank).map(back).collect()
        }),
    })
}

/// What asks for most so far.
#[derive(Default)]
struct Most {
    depth: f64,
    axial: f64,
    place: Option<DecidingPlace>,
}

impl Most {
    fn take(&mut self, depth: f64, axial: f64, place: DecidingPlace) {
        if axial > self.axial {
            *self = Self { depth, axial, place: Some(place) };
        }
    }
}

/// The depth that an edge asks for on a track, and why.
fn asked(at: &MeasuringTrack, track: usize, edge: &EdgeState) -> Option<(f64, RegrindCause)> {
    match edge {
        EdgeState::Worn(growth) => Some((renewing_depth(&at.section, *growth), RegrindCause::Wear(*growth))),
        EdgeState::Chipped(missing) => {
            Some((chip_depth(&at.section, missing[track]), RegrindCause::Chip(missing[track])))
        }
        EdgeState::Unknown => None,
    }
}

fn check(edge: &EdgeState, tracks: usize) -> Result<(), WearError> {
    let finite = |field: &'static str, value: f64| {
        let wrong = WearError::InvalidNumber { field, value, allowed: "finite numbers" };
        if value.is_finite() { Ok(()) } else { Err(wrong) }
    };
    match edge {
        EdgeState::Worn(growth) => finite("growth", *growth),
        EdgeState::Chipped(missing) if missing.len() != tracks => {
            Err(WearError::OtherShape { field: "tracks", found: missing.len(), wanted: tracks })
        }
        EdgeState::Chipped(missing) => missing.iter().try_for_each(|f| finite("deviation", *f)),
        EdgeState::Unknown => Ok(()),
    }
}
