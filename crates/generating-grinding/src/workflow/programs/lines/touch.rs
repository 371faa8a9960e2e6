//! Where the rounded tip of a disc comes nearest to a flank of the worm: by the closed distance of a point to an involute flank, then by
//! the foot of the perpendicular on the modified one. Knows one position of the bodies, no line.

use crate::workflow::line_dressing::LineBodies;
use contact::{ModifiedThread, ToolSurface};
use dressing::TipDisc;
use foundation::geometry::InvoluteFlank;
use foundation::kinematics::{DressingPosition, Pose, Worm};
use nalgebra::Vector3;
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// The tip of a disc beside a flank.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Touch {
    /// Length of roll and axial position of the flank there, mm.
    pub w: f64,
    pub z: f64,
    /// Distance from the flank, mm; negative where the disc cuts.
    pub gap: f64,
    /// Number of the tooth space that the flank belongs to, not reduced modulo the threads.
    pub space: i64,
}

/// The foot of the perpendicular from a point to a flank.
struct Foot {
    w: f64,
    z: f64,
    distance: f64,
    normal: Vector3<f64>,
    space: i64,
}

/// Steps of the search along the disc, the first of them and the largest, rad, and the step that ends it.
const STEPS: usize = 40;
const FIRST: f64 = 0.01;
const LARGEST: f64 = 0.2;
const SETTLED: f64 = 1e-9;
/// Steps to the foot on the modified flank: each leaves the tip radius over the radius of curvature of what was missing, some 2 %.
const PROJECTIONS: usize = 5;

/// Foot on the involute flank of the nearest thread.
fn plain_foot(flank: &InvoluteFlank, at: &Vector3<f64>) -> Foot {
    let (foot, space) = (flank.deviation(at), flank.nearest_space(at));
    // The frame is that of space 0; the other spaces stand turned against it.
    let normal = Pose::<Worm, Worm>::rz(turned(flank, space)).rotation() * flank.frame(foot.w, foot.z).n;
    Foot { w: foot.w, z: foot.z, distance: foot.f_n, normal, space }
}

/// Angle at which a space stands against space 0, rad.
fn turned(flank: &InvoluteFlank, space: i64) -> f64 {
    TAU / flank.teeth * space as f64
}

/// Foot on the wanted flank of the nearest thread; `None` beside its table.
fn wanted_foot(bodies: &LineBodies, at: &Vector3<f64>) -> Option<Foot> {
    let (plain, space) = (bodies.worm.deviation(at), bodies.worm.nearest_space(at));
    let turn = Pose::<Worm, Worm>::rz(turned(&bodies.worm, space));
    let at = turn.inverse().rotation() * at;
    let surface = ModifiedThread::new(bodies.worm, &bodies.wanted);
    let (mut w, mut z) = (plain.w, plain.z);
    for _ in 0..PROJECTIONS {
        let jet = surface.jet(w, z)?;
        let off = at - jet.p;
        let (pp, pq, qq) = (jet.p_p.dot(&jet.p_p), jet.p_p.dot(&jet.p_q), jet.p_q.dot(&jet.p_q));
        let (p, q) = (off.dot(&jet.p_p), off.dot(&jet.p_q));
        let determinant = pp * qq - pq * pq;
        w += (qq * p - pq * q) / determinant;
        z += (pp * q - pq * p) / determinant;
    }
    let jet = surface.jet(w, z)?;
    let normal = jet.n.normalize();
    let distance = normal.dot(&(at - jet.p));
    distance.is_finite().then(|| Foot { w, z, distance, normal: turn.rotation() * normal, space })
}

/// Where the circle of the tip's centres is nearest to a surface, from the angle `from` on the disc: the angle, and the foot there.
fn nearest(
    disc: &TipDisc,
    position: &DressingPosition,
    from: f64,
    foot: impl Fn(&Vector3<f64>) -> Option<Foot>,
) -> Option<(f64, Foot)> {
    let pose = position.pose();
    let radius = disc.centre_radius();
    let at = |psi: f64| {
        let (sin, cos) = psi.sin_cos();
        pose.rotation() * Vector3::new(radius * cos, radius * sin, 0.0) + pose.translation()
    };
    // The distance changes along the circle by the normal at its foot.
    let slope = |psi: f64| {
        let (sin, cos) = psi.sin_cos();
        let along = pose.rotation() * Vector3::new(-radius * sin, radius * cos, 0.0);
        Some(foot(&at(psi))?.normal.dot(&along))
    };
    let mut before = (from, slope(from)?);
    let mut now = from - FIRST * before.1.signum();
    for _ in 0..STEPS {
        let here = slope(now)?;
        let step = -here * (now - before.0) / (here - before.1);
        if here == 0.0 || step.abs() < SETTLED {
            return Some((now, foot(&at(now))?));
        }
        if !step.is_finite() {
            return None;
        }
        before = (now, here);
        now += step.clamp(-LARGEST, LARGEST);
        if (now - PI).abs() > FRAC_PI_2 {
            return None;
        }
    }
    None
}

/// The tip of the disc beside an involute flank, or `None` where it faces no point of it. Of the flanks of all threads the nearest counts.
/// The worm lies on the side of -x of the disc.
fn touch(flank: &InvoluteFlank, disc: &TipDisc, position: &DressingPosition) -> Option<(f64, Touch)> {
    let (psi, foot) = nearest(disc, position, PI, |at| Some(plain_foot(flank, at)))?;
    let gap = foot.distance - disc.tip_radius();
    gap.is_finite().then_some((psi, Touch { w: foot.w, z: foot.z, gap, space: foot.space }))
}

/// The tip beside the flank that is written, its modification included; beside the table of the flank that is the modification of the
/// table's edge.
pub fn touch_written(bodies: &LineBodies, position: &DressingPosition) -> Option<Touch> {
    let (psi, plain) = touch(&bodies.worm, &bodies.disc, position)?;
    match nearest(&bodies.disc, position, psi, |at| wanted_foot(bodies, at)) {
        Some((_, foot)) => {
            let gap = foot.distance - bodies.disc.tip_radius();
            Some(Touch { w: foot.w, z: foot.z, gap, space: foot.space })
        }
        None => {
            let [w, z] = bodies.wanted.domain();
            let wanted = bodies.wanted.value(plain.w.clamp(w[0], w[1]), plain.z.clamp(z[0], z[1]));
            Some(Touch { gap: plain.gap - wanted, ..plain })
        }
    }
}

/// Share of a pitch by which the tip may stand in the opposite flank before it counts as being in front of that of the next thread.
const BEHIND: f64 = 0.1;

/// Distance of the tip from the other flank of the thread space, mm; negative where it cuts.
pub fn counter_gap(bodies: &LineBodies, position: &DressingPosition) -> Option<f64> {
    let flank = &bodies.counter;
    let pitch = TAU * flank.base_radius * flank.base_helix_angle.cos() / flank.teeth;
    let (_, found) = touch(flank, &bodies.disc, position)?;
    let to_centre = found.gap + bodies.disc.tip_radius();
    // The closed distance is that of the nearest flank, which behind the middle of the space is that of the next thread.
    let across = if to_centre < -BEHIND * pitch { to_centre + pitch } else { to_centre };
    Some(across - bodies.disc.tip_radius())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::workflow::run::plan_job;
    use foundation::geometry::Flank;
    use foundation::numerics::Silent;
    use job::{Source, parse_job_of};
    use std::path::Path;

    /// The disc in the positions of the plan touches the flank where the plan says, on whichever thread, and lifted it stands off by
    /// what the lift gives.
    #[test]
    fn the_disc_touches_where_the_plan_has_it() {
        let path = Path::new(env!("CARGO_MANIFEST_DIR"))
            .join("../flankwright-cli/tests/cli/every_key/grinding/line-dressing.toml");
        let text = std::fs::read_to_string(&path).unwrap().replace("threads = 1", "threads = 2");
        let run =
            plan_job(&parse_job_of::<crate::job::Job>(Source::new("lines.toml", &text)).unwrap(), &Silent)
                .unwrap();
        let written = run.written[Flank::Left].as_ref().unwrap();
        let mut seen = 0;
        for (k, (line, positions)) in written.plan.lines.iter().zip(&written.positions).enumerate().step_by(5)
        {
            for (t, position) in positions.iter().step_by(4) {
                let (w, z) = line.point(*t);
                for thread in 0..2 {
                    let mut turned = *position;
                    turned.worm_angle -= PI * f64::from(thread);
                    let touch = touch_written(&written.bodies, &turned).unwrap();
                    assert!(touch.gap.abs() < 1e-5, "line {k}: {touch:?}");
                    assert!((touch.w - w).hypot(touch.z - z) < 1e-4, "line {k}: {w} {z} {touch:?}");
                    assert_eq!(touch.space.rem_euclid(2), i64::from(thread), "line {k}: {touch:?}");
                    turned.centre_distance += 0.2;
                    let lifted = touch_written(&written.bodies, &turned).unwrap();
                    assert!(lifted.gap > 0.02 && lifted.gap < 0.2, "line {k}: {lifted:?}");
                    assert!(counter_gap(&written.bodies, &turned).unwrap() > 1.0);
                    seen += 1;
                }
            }
        }
        assert!(seen > 50);
    }
}
