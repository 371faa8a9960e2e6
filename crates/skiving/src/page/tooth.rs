//! A tooth seen along the tool's axis, with the virtual contact points of its tracks.

use crate::MeasuringTrack;
use crate::workflow::SkivingBodies;
use foundation::geometry::{Flank, Sides};
use foundation::numerics::equidistant;
use report::charts::{ChartError, Drawing, DrawingLayer, DrawingLook, DrawingNote, drawing};
use report::{Block, Figure};

/// Places along a drawn edge.
const PLACES: usize = 41;

/// Tooth 0 along the tool's axis, about +y.
pub(super) fn block(bodies: &SkivingBodies) -> Result<Block, ChartError> {
    let point = |track: &MeasuringTrack| [track.contact.point.x, track.contact.point.y];
    let edges = Sides::from_fn(|flank| -> Vec<[f64; 2]> {
        let places = equidistant([-1.0, 1.0], PLACES).into_iter();
        places.filter_map(|x| MeasuringTrack::new(&bodies.edges[flank], x).ok()).map(|t| point(&t)).collect()
    });
    let Sides { left, right } = edges;
    let layer = |name: &str, look, lines_mm| DrawingLayer { name: name.into(), look, lines_mm };
    let outline: Vec<[f64; 2]> = left.iter().chain(right.iter().rev()).copied().collect();
    let notes = Flank::BOTH.into_iter().flat_map(|flank| {
        let letter = if flank == Flank::Left { "L" } else { "R" };
        bodies.flanks[flank].tracks.iter().enumerate().map(move |(k, (track, _))| DrawingNote {
            at_mm: point(track),
            text: format!("{letter}{}", k + 1),
        })
    });
    let svg = drawing(&Drawing {
        title: "Tooth 0 with the virtual contact points".into(),
        subtitle: "seen along the tool's axis on the rake face; L, R: flank of the workpiece, number: track"
            .into(),
        axes: Some(["x [mm]".into(), "y [mm]".into()]),
        layers: vec![
            layer("tooth", DrawingLook::Body, vec![outline]),
            layer("edge for the left flank", DrawingLook::Edge, vec![left]),
            layer("edge for the right flank", DrawingLook::OtherEdge, vec![right]),
        ],
        notes: notes.collect(),
    })?;
    Ok(Block::Figure(Figure::new("tooth-0-with-the-virtual-contact-points", svg, "")))
}
