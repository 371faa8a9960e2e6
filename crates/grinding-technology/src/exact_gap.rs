//! The gap that the worm leaves over one passage, exactly: the shortest ray of the workpiece over all rolls at one feed. The parabola that
//! rates and wear use is held against it.

use super::Bodies;
use foundation::geometry::Flank;
use foundation::kinematics::{GeneratingState, Point};
use foundation::numerics::golden_section;

/// Rolls looked at to either side, as lengths of roll of the workpiece, mm, and how many.
const ROLLS: f64 = 8.0;
const LOOKED_AT: usize = 64;
const REFINED: usize = 60;
/// Steps of a ray's length; its slope along the ray is near 1.
const STEPS: usize = 60;

/// Gap at length of roll `w`, the distance `ahead` of the contact line of a feed that rises; worm at the finished flank. mm; `None` where no
/// roll grinds the place.
pub fn exact_gap(bodies: &Bodies, flank: Flank, w: f64, ahead: f64) -> Option<f64> {
    let pair = &bodies.flanks[flank].pair;
    // Contact at z = 0 at this feed; the place looked at lies ahead of it.
    let feed = pair.c_c2 + pair.c_w2 * w;
    let z = -ahead;
    let (point, normal) = (pair.work.point(w, z), pair.work.normal(w, z));
    let length = |at: f64| -> f64 {
        let worm_roll = pair.worm_roll(at, 0.0, feed);
        let worm_angle = pair.worm_angle(worm_roll, pair.worm_z(worm_roll, 0.0, feed));
        let state = GeneratingState {
            worm_angle,
            work_angle: pair.work_angle(at, pair.work_z(at, 0.0, feed)),
            shift: 0.0,
            feed,
            delta_d: 0.0,
            delta_gamma: 0.0,
        };
        let pose = bodies.pair.chain.pose(&state);
        let mut long = 0.0;
        for _ in 0..STEPS {
            let off = pair.worm.deviation(&pose.point(&Point::from_vector(point + normal * long)).xyz).f_n;
            long += off;
            if off.is_nan() || off.abs() < 1e-13 {
                break;
            }
        }
        if long.is_nan() { f64::INFINITY } else { long }
    };
    let step = 2.0 * ROLLS / LOOKED_AT as f64;
    let place = |k: usize| w - ROLLS + step * k as f64;
    let best = (0..=LOOKED_AT).map(place).min_by(|a, b| length(*a).total_cmp(&length(*b)))?;
    let least = golden_section(best - step, best + step, REFINED, length);
    Some(length(least)).filter(|gap| gap.is_finite())
}
