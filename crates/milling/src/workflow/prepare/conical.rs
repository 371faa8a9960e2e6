//! Bevel gears of a job as spaces to be milled (`docs/mathematics/milling.md#flanks-as-patches`).

use super::bevel_offset::{Wanted, heights};
use super::bevel_pair::BevelPair;
use super::body::{Body, CLEARANCE, floor, part, with_offset};
use super::lands::lands;
use super::walls::{below_root_body, root_cone};
use crate::job::{BevelFlank, LoadedMillingJob};
use crate::{ActiveFlank, CurveOnCone, HeightLimits, Retraction, SpaceFlank, job as drawn};
use foundation::geometry::{BevelGear, Flank, NormalOffset, Octoid, SphericalInvolute, Surface};
use foundation::numerics::equidistant;
use run::{RunFailure, geometry_finding};
use std::sync::Arc;

/// Pieces of a bevel gear's land, between which the turn of the teeth is linear.
const LAND_PIECES: usize = 8;

/// The gear of a drawing, its flank as long as the mate needs it where there is one.
///
/// # Errors
/// [`RunFailure`] with a finding on `bevel`.
pub(super) fn own_gear(given: &drawn::BevelGear, mate: Option<&BevelPair>) -> Result<BevelGear, RunFailure> {
    match mate {
        Some(pair) => Ok(pair.gears[0].clone()),
        None => BevelGear::new(given.data())
            .map_err(|error| RunFailure::bad_input(geometry_finding(&error, "bevel"))),
    }
}

/// A nominal flank with an offset.
pub(super) fn flank_surface(
    gear: &BevelGear,
    form: BevelFlank,
    side: Flank,
    offset: Option<Arc<dyn NormalOffset>>,
) -> Arc<dyn Surface> {
    match form {
        BevelFlank::SphericalInvolute => with_offset(SphericalInvolute::new(gear, side), offset),
        BevelFlank::Octoid => with_offset(Octoid::new(gear, side), offset),
    }
}

/// The gear of a job, its flank so long as the tip of the mate needs it where there is one.
///
/// # Errors
/// [`RunFailure`] with a finding on `bevel`.
pub(super) fn conical(
    loaded: &LoadedMillingJob,
    given: &drawn::BevelGear,
    mate: Option<&BevelPair>,
) -> Result<Body, RunFailure> {
    let job = &loaded.job;
    let on_bevel = |error: &_| RunFailure::bad_input(geometry_finding(error, "bevel"));
    let gear = own_gear(given, mate)?;
    let wanted = Wanted::of_job(job).compensated(job);
    let mut flanks = Vec::new();
    for side in Flank::BOTH {
        let heights = heights(&gear, given.flank, side).map_err(|error| on_bevel(&error))?;
        let offset = wanted.offset(loaded, &gear, given.flank, side)?;
        let surface = flank_surface(&gear, given.flank, side, offset);
        let active =
            ActiveFlank { surface, heights: HeightLimits::Constant(heights), face: gear.face(), kink: None };
        flanks.push(SpaceFlank { side, active });
    }
    let [inner, outer] = gear.face();
    let (sin, cos) = gear.tip_angle().sin_cos();
    let ends: Vec<f64> = equidistant([inner, outer], LAND_PIECES + 1);
    let spaces = given.teeth as usize;
    let lands = lands(&flanks, spaces, &ends, |r| [r * sin, r * cos, -gear.line().angle(r)], 1.0);
    // The blank: tip cone, and a hub a little below the root cone.
    let (root_sin, root_cos) = gear.root_angle().sin_cos();
    let hub = |r: f64| [0.5 * r * root_sin, r * root_cos];
    let lead = Arc::new(CurveOnCone { cone_angle: gear.root_angle(), line: gear.line().clone() });
    let mut space = part(job.milling.skew_deg, flanks, lead, spaces, lands);
    space.walls.push(root_cone(&gear, below_root_body(job.milling.root.as_ref(), 0.0)));
    Ok(Body {
        parts: vec![space],
        unknown: Vec::new(),
        spaces,
        retraction: Retraction::OutsideCone { half_angle: gear.tip_angle(), distance: CLEARANCE, apex: 0.0 },
        blank: [[inner * sin, inner * cos], [outer * sin, outer * cos], hub(outer), hub(inner)],
        floor: floor([inner, outer].map(|r| [r * root_sin, r * root_cos]), 1.0),
    })
}
