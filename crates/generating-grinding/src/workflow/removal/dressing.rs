//! Figures of dressing: speeds, overlap, and how long the dresser lasts.

use super::RPM;
use super::result::DressingFiguresResult;
use crate::workflow::prepare::{Prepared, RemovalTask};
use grinding_technology::{Bodies, DressingTechnology, Rotation, TechnologyError};
use std::f64::consts::TAU;

/// Depth of a dressing stroke where the job names none, mm: no time depends on it.
const DRESSING_DEPTH: f64 = 0.03;

/// How the worm is dressed over a width; `None` for a worm that is not dressed by a disc.
pub(super) fn dressing_of(prepared: &Prepared, task: &RemovalTask, width: f64) -> Option<DressingTechnology> {
    let technology = &prepared.technology;
    let dresser = prepared.setup.input.dresser.as_ref()?;
    let stock = &technology.dressing_stock;
    let threads = prepared.setup.pair.worm.data().teeth.unsigned_abs() as usize;
    let wanted = task.dressing.map(|wanted| wanted.depth);
    Some(DressingTechnology {
        worm_speed: technology.dressing_speed / TAU,
        dresser_speed: technology.dresser_speed / TAU,
        dresser_tip_diameter: dresser.tip_diameter,
        dresser_pitch_diameter: dresser.pitch_diameter.unwrap_or(dresser.tip_diameter),
        rotation: task.dressing.map_or(Rotation::Same, |wanted| wanted.rotation),
        depth: wanted.or(stock.last().copied()).unwrap_or(DRESSING_DEPTH),
        // One pass dresses one thread.
        passes: (stock.len() + 1) * threads,
        one_flank: !prepared.dressing.two_flanks,
        worm_width: width,
    })
}

/// Figures of the last dressing stroke; `None` without `technology.dressing`, and for a worm that is not dressed by a disc in line contact.
pub(super) fn dressing_figures(
    bodies: &Bodies,
    (prepared, task): (&Prepared, &RemovalTask),
    parts_per_dressing: Option<usize>,
) -> Result<Option<DressingFiguresResult>, TechnologyError> {
    if task.dressing.is_none() || prepared.dressing.point.is_some() || prepared.setup.strokes.is_some() {
        return Ok(None);
    }
    // The figures do not depend on the width.
    let Some(dressing) = dressing_of(prepared, task, task.zone_width.unwrap_or(1.0)) else { return Ok(None) };
    let figures = dressing.figures(bodies)?;
    let dressings = task.cost.map(|cost| cost.dressings_per_dresser);
    Ok(Some(DressingFiguresResult {
        strokes: prepared.technology.dressing_stock.len() + 1,
        flanks_at_a_time: if dressing.one_flank { 1 } else { 2 },
        depth_um: 1e3 * dressing.depth,
        worm_speed_rpm: RPM * dressing.worm_speed,
        dresser_speed_rpm: RPM * dressing.dresser_speed,
        speed_ratio: figures.speed_ratio,
        traverse_per_worm_revolution_mm: bodies.thread_lead(),
        thread_per_dresser_revolution_mm: figures.advance,
        contact_length_mm: figures.contact_length,
        overlap: figures.overlap,
        parts_per_dresser: dressings
            .zip(parts_per_dressing)
            .map(|(dressings, parts)| dressings * parts as f64),
    }))
}
