//! What a measurement is to find: the errors of a real tool at a contact point, to the first order (`docs/mathematics/skiving.md`).

use super::{RealTool, turned};
use crate::{MeasuringTrack, VirtualEdge};
use nalgebra::Vector3;
use std::f64::consts::TAU;

/// Deviation normal to the flank at the contact point of a track, mm: profile, growth of the rounding, pitch and mounting.
pub fn first_order_deviation(
    edge: &VirtualEdge,
    tool: &RealTool,
    track: &MeasuringTrack,
    tooth: usize,
) -> f64 {
    let errors = &tool.edges[edge.side()][tooth];
    let growth = errors.growth_at(track.place) * track.section.growth_at(track.section.contact_angle);
    let turn = TAU * tooth as f64 / tool.teeth() as f64;
    let (m, n) = (turned(turn, &track.contact.point), turned(turn, &track.contact.normal));
    let [e, om] = [tool.eccentricity, tool.wobble].map(|[x, y]| Vector3::new(x, y, 0.0));
    errors.profile_at(track.place)
        + growth
        + track.contact.lever * tool.pitch[tooth]
        + n.dot(&e)
        + om.dot(&m.cross(&n))
}
