//! The proof of a scan: with the axes where the text puts them the stylus touches the ideal edge at every place, and what straight
//! blocks leave between the places is stated.

use super::failure::{not_proven, of_skiving};
use super::proof::{Proof, off_axis};
use super::replay::Move;
use super::scan::{ScanCourse, Scanned};
use super::stand::Stander;
use super::task::ScanWork;
use crate::measuring::{Barrier, RealTool, ScanPlace};
use machine::Positions;
use run::RunFailure;
use std::f64::consts::TAU;

/// Proves the scans of a text.
///
/// # Errors
/// A text that scans something else.
pub(super) fn prove_scans(
    laid: &ScanCourse<'_>,
    work: &ScanWork<'_>,
    found: &[Vec<Move>],
    allowed: f64,
) -> Result<Proof, RunFailure> {
    if found.len() != laid.scanned.len() {
        let text = format!("{} scans in the text, {} planned", found.len(), laid.scanned.len());
        return Err(not_proven(text));
    }
    let ideal = RealTool::ideal(work.count());
    let stander = &laid.course.stander;
    let radius = work.stylus.radius;
    let (mut proof, mut between) = (Proof::new(allowed), 0.0f64);
    for (scanned, moves) in laid.scanned.iter().zip(found) {
        let name = format!("{} flank, tooth {}", scanned.flank, scanned.tooth);
        let edge = &work.edges[scanned.flank];
        let Some(first) = moves.first().filter(|_| moves.len() + 1 == scanned.places.len()) else {
            let text = format!("{name}: {} blocks for {} places", moves.len(), scanned.places.len());
            return Err(not_proven(text));
        };
        let stands = std::iter::once(&first.from).chain(moves.iter().map(|part| &part.to));
        for (k, (at, place)) in stands.zip(&scanned.places).enumerate() {
            proof.add(off_edge(stander, work, scanned, place, at)?, &format!("{name}, place {}", k + 1))?;
        }
        for (part, places) in moves.iter().zip(scanned.places.windows(2)) {
            let mut middle = part.from;
            for &axis in &stander.axes {
                middle[axis] = 0.5 * (part.from[axis] + part.to[axis]);
            }
            let stands = stander.tool(&middle)?;
            let pose = stands.pose(&places[0].pose);
            let barrier = Barrier { beam: work.stylus, pose: &pose };
            let w = 0.5 * (places[0].track.contact.w + places[1].track.contact.w);
            let touch = barrier.anywhere(edge, &ideal, scanned.tooth, radius, [w, pose.turn]);
            let touch = touch.map_err(|error| of_skiving(&error))?;
            between = between.max((places[0].track.contact.lever * (touch.turn - pose.turn)).abs());
        }
    }
    proof.between_places = Some(between);
    Ok(proof)
}

/// How far a place of a scan is off with the axes as they stand, mm: the gap between edge and stylus, and the stylus' axis from where the
/// contact wants it.
///
/// # Errors
/// Positions that are not finite.
pub(super) fn off_edge(
    stander: &Stander<'_>,
    work: &ScanWork<'_>,
    scanned: &Scanned,
    place: &ScanPlace,
    at: &Positions,
) -> Result<[f64; 2], RunFailure> {
    let radius = work.stylus.radius;
    let tooth_turn = TAU * scanned.tooth as f64 / work.count() as f64;
    let (stands, contact) = (stander.tool(at)?, &place.track.contact);
    let pose = stands.pose(&place.pose);
    let barrier = Barrier { beam: work.stylus, pose: &pose };
    let (edge, ideal) = (&work.edges[scanned.flank], RealTool::ideal(work.count()));
    let (gap, _) = barrier.distance(edge, &ideal, scanned.tooth, [contact.w, pose.turn]);
    let axis = pose.to_machine(pose.turn + tooth_turn, &(contact.point + contact.normal * radius));
    let lean = stands.lean.abs() * contact.point.norm();
    Ok([gap - radius, off_axis(work.stylus, &axis) + lean])
}
