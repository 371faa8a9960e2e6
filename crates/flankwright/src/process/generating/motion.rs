//! The grinding motion that makes F_K on one flank or on both at once (spec 25 section 3).

use super::{Decomposition, FlankLines};
use crate::geometry::Sides;
use crate::kinematics::MotionLaw;

/// f_F(z_V2) = cos b2 F_K as a polynomial of degree 3 in z_V2, normal, mm, under z_V1 = `shift`[0] + `shift`[1] z_V2.
fn normal_share(lines: &FlankLines, parts: &Decomposition, shift: [f64; 2]) -> [f64; 4] {
    // X_K = c_K (zeta - zeta_m) with the path coordinate zeta = z_2 + t_K w_2 affine in the feed.
    let c_k = 1.0 / parts.t_k.hypot(1.0);
    let [by_shift, by_feed] = lines.work_feeds;
    let origin = by_shift * shift[0] + lines.c_c2 - lines.z_m - lines.t_k * lines.w_m;
    let slope = by_shift * shift[1] + by_feed;
    let mut powers = [0.0; 4];
    let mut power = vec![1.0];
    for &coefficient in &parts.kinematic {
        for (sum, p) in powers.iter_mut().zip(&power) {
            *sum += lines.cos_b2 * coefficient * p;
        }
        let mut next = vec![0.0; power.len() + 1];
        for (j, p) in power.iter().enumerate() {
            next[j] += c_k * origin * p;
            next[j + 1] += c_k * slope * p;
        }
        power = next;
    }
    powers
}

/// Delta_d(z_V2) and Delta_phi_2(z_V2) that give the normal amounts `[left, right]` (polynomials in z_V2, mm) on both flanks.
pub fn motion_of_flanks(
    lines: &Sides<FlankLines>,
    left: &[f64; 4],
    right: &[f64; 4],
) -> (MotionLaw, MotionLaw) {
    let (l, r) = (&lines.left, &lines.right);
    let denominator = l.sin_an * r.lever + r.sin_an * l.lever;
    let delta_d = (0..4).map(|k| (left[k] * r.lever + right[k] * l.lever) / denominator).collect();
    let delta_phi = (0..4).map(|k| (right[k] * l.sin_an - left[k] * r.sin_an) / denominator).collect();
    (MotionLaw::polynomial(0.0, delta_d), MotionLaw::polynomial(0.0, delta_phi))
}

/// Delta_d and Delta_phi_2 of two decompositions ground at once. A flank that is not ground leaves its share to the other:
/// with one flank alone Delta_d carries all and Delta_phi_2 is zero. The tool shift is z_V1 = `shift`[0] + `shift`[1] z_V2.
pub fn common_motion(
    lines: &Sides<FlankLines>,
    parts: &Sides<Option<Decomposition>>,
    shift: [f64; 2],
) -> (MotionLaw, MotionLaw) {
    let share = |l: &FlankLines, p: &Option<Decomposition>| p.as_ref().map(|p| normal_share(l, p, shift));
    match (share(&lines.left, &parts.left), share(&lines.right, &parts.right)) {
        (Some(left), Some(right)) => motion_of_flanks(lines, &left, &right),
        (Some(f), None) => (single(&f, lines.left.sin_an), MotionLaw::zero()),
        (None, Some(f)) => (single(&f, lines.right.sin_an), MotionLaw::zero()),
        (None, None) => (MotionLaw::zero(), MotionLaw::zero()),
    }
}

fn single(f: &[f64; 4], sin_an: f64) -> MotionLaw {
    MotionLaw::polynomial(0.0, f.iter().map(|x| x / sin_an).collect())
}
