//! Whether the beam passes all that it is not to touch: edges and clearance faces of the other flanks of all teeth
//! (`docs/mathematics/skiving.md#tracks-and-poses`).

use super::{Beam, MeasuringPose};
use crate::VirtualEdge;
use foundation::geometry::{Flank, Sides};
use foundation::numerics::equidistant;
use nalgebra::Vector3;
use std::f64::consts::TAU;

/// What must stay between the beam and other flanks, mm.
pub const OTHER_FLANK_GAP: f64 = 0.1;

/// The flank that comes nearest to the beam besides the measured one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NearestFlank {
    /// Which flank.
    pub flank: Flank,
    /// Of which tooth, counted from the measured one, -z1/2..z1/2.
    pub tooth: i32,
    /// Gap between it and the beam, mm.
    pub gap: f64,
}

/// Places along the edge and along the clearance face that are looked at.
const EDGE_PLACES: usize = 21;
const BODY_PLACES: usize = 11;

/// The nearest other flank in a pose, with clearance faces as deep as `depth`, mm.
pub fn nearest_other_flank(
    edges: &Sides<VirtualEdge>,
    measured: Flank,
    pose: &MeasuringPose,
    beam: &Beam,
    depth: f64,
) -> NearestFlank {
    let teeth = edges[measured].pair().tool().teeth() as i32;
    let unit = beam.unit();
    let mut nearest = NearestFlank { flank: measured, tooth: 0, gap: f64::INFINITY };
    for flank in [Flank::Left, Flank::Right] {
        let body = points(&edges[flank], depth);
        for tooth in -(teeth / 2)..teeth - teeth / 2 {
            if flank == measured && tooth == 0 {
                continue;
            }
            let turn = pose.turn + TAU * f64::from(tooth) / f64::from(teeth);
            for (point, radius) in &body {
                let off = pose.to_machine(turn, point) - beam.point;
                let gap = (off - unit * off.dot(&unit)).norm() - radius - beam.radius;
                if gap < nearest.gap {
                    nearest = NearestFlank { flank, tooth, gap };
                }
            }
        }
    }
    nearest
}

/// Gap between the beam and the own edge with its clearance face as deep as `depth`, mm: 0 where the beam is laid on it, below 0 where it
/// cuts into it elsewhere.
pub(super) fn own_edge_gap(edge: &VirtualEdge, pose: &MeasuringPose, beam: &Beam, depth: f64) -> f64 {
    let unit = beam.unit();
    let gap = |(point, radius): &(Vector3<f64>, f64)| {
        let off = pose.to_machine(pose.turn, point) - beam.point;
        (off - unit * off.dot(&unit)).norm() - radius - beam.radius
    };
    points(edge, depth).iter().map(gap).fold(f64::INFINITY, f64::min)
}

/// Centres of the rounding with its radius, and places of the clearance face.
fn points(edge: &VirtualEdge, depth: f64) -> Vec<(Vector3<f64>, f64)> {
    let radius = edge.pair().tool().rounding().radius;
    let mut points = Vec::new();
    for w in equidistant(edge.flank().range(), EDGE_PLACES) {
        let section = edge.section(w);
        points.push((section.centre, radius));
        let from = section.centre + section.clearance_normal * radius;
        points.extend(
            equidistant([0.0, depth], BODY_PLACES).into_iter().map(|t| (from + section.ruling * t, 0.0)),
        );
    }
    points
}
