//! A tooth seen along the tool's axis, with the virtual contact points of its tracks.

use foundation::geometry::{Flank, Sides};
use report::charts::{ChartError, Drawing, DrawingLayer, DrawingLook, DrawingNote, drawing};
use report::data::{Block, Figure};

/// Tooth 0 along the tool's axis; places [x, y] in mm, the tooth about +y.
#[derive(Clone, Debug, PartialEq)]
pub struct ToothView {
    /// Edges that cut each flank, ascending in x.
    pub edges_mm: Sides<Vec<[f64; 2]>>,
    /// Contact points of the tracks, ascending in x.
    pub contacts_mm: Sides<Vec<[f64; 2]>>,
}

impl ToothView {
    pub(super) fn blocks(&self) -> Result<Vec<Block>, ChartError> {
        let Sides { left, right } = &self.edges_mm;
        let layer = |name: &str, look, lines_mm| DrawingLayer { name: name.into(), look, lines_mm };
        let outline: Vec<[f64; 2]> = left.iter().chain(right.iter().rev()).copied().collect();
        let notes = self.contacts_mm.iter().flat_map(|(flank, points)| {
            points.iter().enumerate().map(move |(k, at)| DrawingNote {
                at_mm: *at,
                text: format!("{}{}", if flank == Flank::Left { "L" } else { "R" }, k + 1),
            })
        });
        let svg = drawing(&Drawing {
            title: "Tooth 0 with the virtual contact points".into(),
            subtitle:
                "seen along the tool's axis on the rake face; L, R: flank of the workpiece, number: track"
                    .into(),
            axes: Some(["x [mm]".into(), "y [mm]".into()]),
            layers: vec![
                layer("tooth", DrawingLook::Body, vec![outline]),
                layer("edge for the left flank", DrawingLook::Edge, vec![left.clone()]),
                layer("edge for the right flank", DrawingLook::OtherEdge, vec![right.clone()]),
            ],
            notes: notes.collect(),
        })?;
        Ok(vec![Block::Figure(Figure::new("tooth-0-with-the-virtual-contact-points", svg, ""))])
    }
}
