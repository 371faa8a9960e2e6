//! The stage of a worm that a narrow disc writes line by line, in point contact. Knows no gear.

use super::dressing::{Parked, WormExtent, dressing_frame};
use crate::workflow::line_dressing::WrittenFlank;
use contact::Pair;
use foundation::geometry::Flank;
use scene::{Coordinate, Stage};

/// Frames over all lines of a flank at most.
const FRAMES: usize = 241;

/// The stage of a flank that a narrow disc writes line by line: frames spread over all lines.
pub fn written_stage(
    flank: Flank,
    written: &WrittenFlank,
    pair: &Pair,
    extent: &WormExtent,
    parked: &[Parked],
) -> Option<Stage> {
    let worm = pair.worm.flank(flank);
    let driven: Vec<_> = written
        .plan
        .lines
        .iter()
        .zip(&written.positions)
        .enumerate()
        .flat_map(|(number, (line, positions))| {
            let count = positions.len() as f64;
            positions
                .iter()
                .enumerate()
                .map(move |(k, (t, position))| (number as f64 + k as f64 / count, line.point(*t), *position))
        })
        .collect();
    let last = driven.len().checked_sub(1)?;
    let frames = FRAMES.min(driven.len());
    let chosen = (0..frames).map(|k| k * last / (frames - 1).max(1));
    let frame = |k: usize| {
        let (at, (w, z), position) = &driven[k];
        let contact: Vec<_> =
            Some(worm.point(*w, *z)).into_iter().filter(|point| extent.holds(point)).collect();
        dressing_frame(*at, position, ("dresser", 0.0), &contact, parked)
    };
    Some(Stage {
        id: format!("dressing-{flank}"),
        title: format!("Writing the {flank} flank of the worm line by line"),
        coordinate: Coordinate { label: "lines", unit: "1" },
        frames: chosen.map(frame).collect(),
    })
}
