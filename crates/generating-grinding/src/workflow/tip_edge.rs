//! What the tip edge of the worm cuts out of the evaluated flank: rays of the gear at the start of its profile, shortened by the
//! edge. The flank stage of the referee knows the thread's flank only, so that an undercut would pass it.

use super::execution::Execution;
use super::prepare::Prepared;
use super::referee::{Cutting, Verdict as Ground, rays_at};
use foundation::geometry::{Flank, Sides};
use foundation::kinematics::MotionLaw;
use foundation::numerics::equidistant;
use referee::{RayGrid, RemovalError, RootGrinding, RootRay};
use run::RunFailure;
use verdict::{Remark, Verdict};

/// Edges with which the rays are cut, mm. A ray falls in proportion to the radius, so that both give that of a sharp edge; the
/// larger one is as fine as the raster of the search resolves.
const EDGE_RADII: [f64; 2] = [0.2, 0.1];
/// Rays stand at these shares of the evaluated profile: an undercut is deepest at its start.
const PLACES: [f64; 3] = [0.0, 0.1, 0.25];
/// Sections over the face in which rays stand, where the motion or the worm changes along it.
const SECTIONS: usize = 7;
/// Feeds at which the infeed of the motion is looked at.
const FEEDS: usize = 61;

/// Largest depth that the tip edge cuts below each ground flank, mm; `None` where the tip does not reach past the point that
/// grinds the base circle, so that it cannot undercut an involute, and where the worm's tip is made to grind the root.
///
/// # Errors
/// [`RunFailure`]: an edge that does not fit on the worm; a ray that nothing reaches.
pub fn tip_edge_depths(
    prepared: &Prepared,
    execution: &Execution,
    (verdicts, cutting): (&Sides<Option<Ground>>, Cutting<'_>),
) -> Result<Sides<Option<f64>>, RunFailure> {
    let setup = &prepared.setup;
    if setup.input.gear_root.is_some() {
        return Ok(Sides { left: None, right: None });
    }
    let cone = setup.pair.worm.data().cone_angle.tan();
    let tip = MotionLaw::polynomial(0.0, vec![setup.worm_tip_radius, cone]);
    let motion = &execution.motion;
    let feeds = equidistant(execution.feed_range, FEEDS);
    let infeed = feeds.iter().map(|&feed| -motion.delta_d.value(feed)).fold(0.0, f64::max);
    Sides::try_from_fn(|flank| {
        let (Some(executed), Some(ground)) = (&execution.flanks[flank], &verdicts[flank]) else {
            return Ok(None);
        };
        // The point of the path of contact that grinds the base circle moves on the worm as the worm comes nearer.
        if setup.undercut + infeed / setup.lines[flank].sin_an <= 0.0 {
            return Ok(None);
        }
        let Some(modification) = ground.worm(&executed.tool) else { return Ok(None) };
        let work = setup.pair.work.flank(flank);
        let (w, z) = (&executed.target.w, &executed.target.z);
        let [first, last] = [w[0], w[w.len() - 1]];
        // The edge leaves the flank no further from the centre line than the path of contact of the whole profile reaches.
        let along = last;
        let failed = |e: RemovalError| RunFailure::of_removal(&e, "worm.tip_diameter");
        let grid = RayGrid::new(
            PLACES.map(|share| first + share * (last - first)).to_vec(),
            equidistant([z[0], z[z.len() - 1]], SECTIONS),
        );
        let grid = grid.map_err(failed)?;
        let Some(by_flank) = rays_at(setup, execution, (flank, ground), cutting, &grid).map_err(failed)?
        else {
            return Ok(None);
        };
        let places = grid.w().iter().flat_map(|&w| grid.z().iter().map(move |&z| (w, z)));
        let rays: Vec<RootRay> =
            places.map(|(w, z)| RootRay { foot: work.point(w, z), direction: work.normal(w, z) }).collect();
        let cut = |corner_radius: f64| {
            let worm = setup.pair.worm.flank(flank);
            let feeds = execution.feed_range;
            let grinding =
                RootGrinding { worm, modification, corner_radius, tip: &tip, motion, feeds, along };
            grinding.lengths(&rays).map_err(failed)
        };
        let [coarse, fine] = [cut(EDGE_RADII[0])?, cut(EDGE_RADII[1])?];
        let share = EDGE_RADII[1] / (EDGE_RADII[0] - EDGE_RADII[1]);
        let mut deepest: f64 = 0.0;
        for ((coarse, fine), by_flank) in coarse.iter().zip(&fine).zip(by_flank) {
            let (Some(coarse), Some(fine)) = (coarse, fine) else { continue };
            let sharp = fine + share * (fine - coarse);
            deepest = deepest.max(by_flank - sharp);
        }
        Ok(Some(deepest))
    })
}

/// Judges the depths: the flank has lost more than its tolerance or not.
pub fn judge_tip_edge(verdict: &mut Verdict, depths: &Sides<Option<f64>>, tolerance_um: f64) {
    for flank in Flank::BOTH {
        let Some(depth) = depths[flank] else { continue };
        let depth_um = depth * 1e3;
        let detail = format!("the tip edge cuts {depth_um:.3} um deep (tolerance {tolerance_um} um)");
        verdict.judge(format!("{flank} flank: tip edge of the worm"), depth_um <= tolerance_um, detail, || {
            Remark::new(
                "flank-cut-by-worm-tip",
                format!(
                    "The tip edge of the worm cuts the {flank} flank {depth_um:.1} um deep at the start of the evaluated profile; the tolerance is {tolerance_um} um."
                ),
                "Reduce worm.tip_diameter, raise gear.form_diameter or gear.evaluation.start_diameter, or take more profile shift.",
            )
        });
    }
}
