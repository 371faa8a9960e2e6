//! Measuring tracks: places along the edge at which every tooth is measured (`docs/mathematics/skiving.md#tracks-and-poses`).

use super::{ContactPlace, EdgeSection, SkivingError, VirtualEdge};

/// A track with all that a measurement needs of it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MeasuringTrack {
    /// x = -1..1 along the edge.
    pub place: f64,
    /// The contact of the ideal tool.
    pub contact: ContactPlace,
    /// The edge around it.
    pub section: EdgeSection,
}

/// Places x of five tracks.
pub fn default_track_places() -> Vec<f64> {
    vec![-0.8, -0.4, 0.0, 0.4, 0.8]
}

impl MeasuringTrack {
    /// The track at x of an edge.
    ///
    /// # Errors
    /// [`SkivingError::InvalidNumber`] for x outside of -1..1; [`SkivingError::NoContact`].
    pub fn new(edge: &VirtualEdge, place: f64) -> Result<Self, SkivingError> {
        if !(-1.0..=1.0).contains(&place) {
            let field = "track_places";
            return Err(SkivingError::InvalidNumber { field, value: place, allowed: "-1 to 1" });
        }
        let w = edge.flank().length_of_roll(place);
        let contact = edge.contact(w)?;
        Ok(Self { place, contact, section: edge.section(w) })
    }

    /// R: radius of the track about the tool's axis, mm.
    pub fn radius(&self) -> f64 {
        self.contact.point.x.hypot(self.contact.point.y)
    }

    /// Z: height of the track, mm.
    pub fn height(&self) -> f64 {
        self.contact.point.z
    }
}
