//! Bevel gears of a job as spaces to be milled (`docs/mathematics/milling.md#flanks-as-patches`).

use super::body::{Body, CLEARANCE, floor, part, with_offset};
use super::ease_off::amounts;
use super::lands::lands;
use super::mate::MatePair;
use super::walls::{below_root_body, root_cone};
use crate::job::{BevelFlank, MillingJob};
use crate::{ActiveFlank, CurveOnCone, HeightLimits, Retraction, SpaceFlank, job as drawn};
use foundation::geometry::{BevelGear, EaseOff, Flank, NormalOffset, Octoid, SphericalInvolute};
use foundation::numerics::equidistant;
use run::{RunFailure, geometry_finding};
use std::sync::Arc;

/// Pieces of a bevel gear's land, between which the turn of the teeth is linear.
const LAND_PIECES: usize = 8;

/// The gear of a job, its flank so long as the tip of the mate needs it where there is one.
///
/// # Errors
/// [`RunFailure`] with a finding on `bevel`.
pub(super) fn conical(
    job: &MillingJob,
    given: &drawn::BevelGear,
    mate: Option<&MatePair>,
) -> Result<Body, RunFailure> {
    let on_bevel = |error: &_| RunFailure::bad_input(geometry_finding(error, "bevel"));
    let gear = match mate {
        Some(pair) => pair.gears[0].clone(),
        None => BevelGear::new(given.data()).map_err(|error| on_bevel(&error))?,
    };
    let ease = job.target.ease_off.map(amounts);
    let mut flanks = Vec::new();
    for side in Flank::BOTH {
        let octoid = Octoid::new(&gear, side);
        let heights = match given.flank {
            BevelFlank::SphericalInvolute => gear.heights(),
            BevelFlank::Octoid => {
                let height = |angle| octoid.height_of(angle).map_err(|error| on_bevel(&error));
                [height(gear.form_angle())?, height(gear.tip_angle())?]
            }
        };
        let mut offset: Option<Arc<dyn NormalOffset>> = None;
        if let Some(amounts) = ease {
            let ease = EaseOff::new(amounts, heights, gear.face()).map_err(|error| on_bevel(&error))?;
            offset = Some(Arc::new(ease));
        }
        let surface = match given.flank {
            BevelFlank::SphericalInvolute => with_offset(SphericalInvolute::new(&gear, side), offset),
            BevelFlank::Octoid => with_offset(octoid, offset),
        };
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
        retraction: Retraction::OutsideCone { half_angle: gear.tip_angle(), distance: CLEARANCE },
        blank: [[inner * sin, inner * cos], [outer * sin, outer * cos], hub(outer), hub(inner)],
        floor: floor([inner, outer].map(|r| [r * root_sin, r * root_cos]), 1.0),
    })
}
