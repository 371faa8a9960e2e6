//! Tooth 0 with its contact points, sections across its edges, and the poses for the page.

use crate::MeasuringTrack;
use crate::measuring::{RealTool, conventional_reading};
use crate::page::{EdgeSectionView, PoseRow, ToothView};
use crate::workflow::prepare::SkivingBodies;
use crate::workflow::result::SkivingResult;
use foundation::geometry::{Flank, Sides};
use foundation::numerics::equidistant;

/// Places along a drawn edge.
const PLACES: usize = 41;

/// Edges and contact points along the tool's axis.
pub(super) fn tooth(bodies: &SkivingBodies) -> ToothView {
    let point = |track: &MeasuringTrack| [track.contact.point.x, track.contact.point.y];
    let edge = |flank: Flank| {
        let places = equidistant([-1.0, 1.0], PLACES).into_iter();
        places.filter_map(|x| MeasuringTrack::new(&bodies.edges[flank], x).ok()).map(|t| point(&t)).collect()
    };
    let contacts = |flank: Flank| bodies.flanks[flank].tracks.iter().map(|(t, _)| point(t)).collect();
    ToothView { edges_mm: Sides::from_fn(edge), contacts_mm: Sides::from_fn(contacts) }
}

/// The section across each edge at its middle track.
pub(super) fn sections(bodies: &SkivingBodies) -> Vec<EdgeSectionView> {
    let rounding = bodies.pair.tool().rounding();
    if rounding.radius == 0.0 {
        return Vec::new();
    }
    let of_flank = |flank: Flank| {
        let tracks = &bodies.flanks[flank].tracks;
        let middle = tracks.len() / 2;
        let (track, pose) = &tracks[middle];
        let ideal = RealTool::ideal(bodies.teeth());
        let usual = conventional_reading(&bodies.edges[flank], &ideal, track, &bodies.beam, 0);
        let section = &track.section;
        EdgeSectionView {
            flank,
            track: middle + 1,
            rounding_um: 1e3 * rounding.radius,
            contact_deg: section.contact_angle.to_degrees(),
            range_deg: section.range.map(f64::to_degrees),
            clearance_deg: section.clearance_angle.to_degrees(),
            rake_chamfer_um: 1e3 * rounding.rake_chamfer_width,
            clearance_chamfer_um: 0.0,
            beam_um: Some(1e3 * bodies.beam.radius),
            beam_across_deg: pose.beam_in_tool.dot(&section.tangent).abs().min(1.0).asin().to_degrees(),
            conventional_deg: usual.ok().map(|found| found.angle.to_degrees()),
        }
    };
    Flank::BOTH.into_iter().map(of_flank).collect()
}

/// Tracks and poses.
pub(super) fn poses(result: &SkivingResult) -> Vec<PoseRow> {
    let of_flank = |flank: Flank| {
        result.tracks.get(flank.name()).into_iter().flatten().map(move |t| PoseRow {
            flank,
            track: t.track,
            place: t.place,
            roll_mm: t.w_mm,
            radius_mm: t.radius_mm,
            height_mm: t.height_mm,
            tool_angle_deg: t.tool_angle_deg,
            contact_deg: t.contact_angle_deg,
            lever_mm: t.lever_mm_per_rad,
            swivel_deg: t.a_deg,
            turn_deg: t.b_deg,
            position_mm: t.position_mm,
            off_flank_deg: t.off_flank_deg,
            gap_mm: t.other_flank_gap_mm.is_finite().then_some(t.other_flank_gap_mm),
            sigma_um: Some(t.single_sigma_um),
        })
    };
    Flank::BOTH.into_iter().flat_map(of_flank).collect()
}
