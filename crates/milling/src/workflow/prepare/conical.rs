//! Bevel gears of a job as spaces to be milled (`docs/mathematics/milling.md#flanks-as-patches`).

use super::bevel_offset::{Wanted, heights};
use super::bevel_pair::BevelPair;
use super::body::{Body, CLEARANCE, floor, join_halves, part, with_offset};
use super::lands::lands;
use super::walls::{below_root_body, root_cone};
use crate::job::{BevelFlank, LoadedMillingJob};
use crate::{ActiveFlank, Along, CurveOnCone, HeightLimits, Kink, Retraction, SpaceFlank, job as drawn};
use foundation::geometry::{BevelGear, Flank, NormalOffset, Octoid, SphericalInvolute, Surface};
use foundation::numerics::equidistant;
use run::{RunFailure, geometry_finding};
use std::f64::consts::{FRAC_PI_2, PI};
use std::sync::Arc;

/// From this angle on (80 deg) a root cone is so flat that there is no room for a hub inside of it, rad.
const FLAT: f64 = 80.0 * PI / 180.0;
/// How far the disc that the teeth of such a gear stand on reaches behind them, as a share of the outer cone distance.
const DISC: f64 = 0.2;

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

/// Teeth of a bevel gear: all of them, or one of two halves.
struct Teeth {
    gear: BevelGear,
    kink: Option<Kink>,
}

/// The teeth of a drawing: of a double-helical gear the half at the heel first.
fn teeth(given: &drawn::BevelGear, mate: Option<&BevelPair>) -> Result<Vec<Teeth>, RunFailure> {
    let Some(halves) = given.double_helical else {
        return Ok(vec![Teeth { gear: own_gear(given, mate)?, kink: None }]);
    };
    let meeting = given.meeting_distance(&halves);
    let made = given.halves(&halves).into_iter().zip([1.0, -1.0]).map(|((data, face), side)| {
        let gear = BevelGear::half(data, face, meeting)
            .map_err(|error| RunFailure::bad_input(geometry_finding(&error, "bevel")))?;
        Ok(Teeth { gear, kink: Some(Kink { length: meeting, side, along: Along::Rays }) })
    });
    made.collect()
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
    let all = teeth(given, mate)?;
    let spaces = given.teeth as usize;
    let outer = given.outer_cone_distance();
    let face = [outer - given.face_width, outer];
    let below = below_root_body(job.milling.root.as_ref(), 0.0);
    let wanted = Wanted::of_job(job).compensated(job);
    let mut parts = Vec::new();
    for Teeth { gear, kink } in &all {
        let mut flanks = Vec::new();
        for side in Flank::BOTH {
            let heights = heights(gear, given.flank, side).map_err(|error| on_bevel(&error))?;
            let offset = wanted.offset(loaded, gear, given.flank, side)?;
            let surface = flank_surface(gear, given.flank, side, offset);
            let heights = HeightLimits::Constant(heights);
            let active = ActiveFlank { surface, heights, face: gear.face(), kink: *kink };
            flanks.push(SpaceFlank { side, active });
        }
        let (sin, cos) = gear.tip_angle().sin_cos();
        let place = |r: f64| [r * sin, r * cos, -gear.line().angle(r)];
        let ends = equidistant(gear.face(), LAND_PIECES + 1);
        // Material lies towards the axis of a cone that opens towards +z, else on the other side.
        let lands = lands(&flanks, spaces, &ends, place, cos.signum());
        let lead = Arc::new(CurveOnCone { cone_angle: gear.root_angle(), line: gear.line().clone() });
        let mut space = part(job.milling.skew_deg, flanks, lead, spaces, lands);
        space.walls.push(root_cone(gear, face, below));
        parts.push(space);
    }
    join_halves(&mut parts);
    let [tip, root] = [all[0].gear.tip_angle(), all[0].gear.root_angle()];
    Ok(Body {
        parts,
        unknown: Vec::new(),
        spaces,
        retraction: retraction(tip, outer),
        blank: blank([tip, root], face),
        floor: floor(face.map(|r| [r * root.sin(), r * root.cos()]), 1.0),
    })
}

/// Where the cutter is out of the workpiece: outside of the cone through the tips, or, where that cone is a plane or opens towards -z, on the
/// other side of the plane through their heels.
fn retraction(tip: f64, outer: f64) -> Retraction {
    if tip < FRAC_PI_2 {
        return Retraction::OutsideCone { half_angle: tip, distance: CLEARANCE, apex: 0.0 };
    }
    Retraction::Below(outer * tip.cos() - CLEARANCE)
}

/// Section of the blank: the tip cone, and a hub a little below the root cone, or, where that is nearly a plane, a disc behind it.
fn blank([tip, root]: [f64; 2], [inner, outer]: [f64; 2]) -> [[f64; 2]; 4] {
    let on_tip = |r: f64| [r * tip.sin(), r * tip.cos()];
    let behind = |r: f64| {
        if root < FLAT {
            [0.5 * r * root.sin(), r * root.cos()]
        } else {
            [0.5 * r * root.sin(), outer * (root.cos() + DISC)]
        }
    };
    [on_tip(inner), on_tip(outer), behind(outer), behind(inner)]
}
