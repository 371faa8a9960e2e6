//! The grinding motion that makes F_K on one flank or on both at once
//! (`docs/mathematics/generating-contact.md#contact-path-lines-and-the-diagonal-ratio`).

use super::carried::RestFit;
use super::{Decomposition, FlankLines, GeneratingError, GrindingSetup};
use contact::{Lever, StandOff};
use foundation::geometry::{Flank, Sides};
use foundation::kinematics::MotionLaw;
use foundation::numerics::equidistant;
use std::sync::Arc;

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
    let (delta_d, delta_phi) = (0..4).map(|k| split(lines, left[k], right[k])).unzip();
    (MotionLaw::polynomial(0.0, delta_d), MotionLaw::polynomial(0.0, delta_phi))
}

/// Delta_d and Delta_phi_2 that give the normal amounts `left` and `right`, mm, rad
/// (`docs/mathematics/generating-contact.md#contact-path-lines-and-the-diagonal-ratio`).
fn split(lines: &Sides<FlankLines>, left: f64, right: f64) -> (f64, f64) {
    let levers = lines.map(|_, line| Lever { sine: line.sin_an, arm: line.lever });
    let off = StandOff::of_both(levers, Sides { left, right });
    (off.delta_d, off.delta_phi_2)
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

/// Nodes of motions that are no polynomials: far more than a fitted F_K has intervals.
const NODES: usize = 129;
/// Feed beyond the field over which such a motion is laid out, mm; it goes on straight from there.
const BEYOND: f64 = 6.0;

/// The common motion with the F_K of fitted parts added, as C2 splines over the feed.
///
/// # Errors
/// `Law` for amounts that are not finite.
pub(super) fn with_fitted_motion(
    setup: &GrindingSetup,
    (delta_d, delta_phi_2): (MotionLaw, MotionLaw),
    fits: &Sides<Option<Arc<RestFit>>>,
    shift: &MotionLaw,
    which: &[Flank],
) -> Result<(MotionLaw, MotionLaw), GeneratingError> {
    if fits.left.is_none() && fits.right.is_none() {
        return Ok((delta_d, delta_phi_2));
    }
    let [from, to] = setup.feed_range(shift, which);
    let feeds = equidistant([from - BEYOND, to + BEYOND], NODES);
    let amount = |flank: Flank, v: f64| {
        let (Some(fit), lines) = (&fits[flank], &setup.lines[flank]) else { return 0.0 };
        let [by_shift, by_feed] = lines.work_feeds;
        let zeta = by_shift * shift.value(v) + by_feed * v + lines.c_c2;
        lines.cos_b2 * fit.kinematic_part(lines.w_m, zeta - lines.t_k * lines.w_m).f
    };
    let both = which.len() == 2;
    let (d, phi): (Vec<f64>, Vec<f64>) = feeds
        .iter()
        .map(|&v| {
            let (more_d, more_phi) = match which {
                [only] if !both => (amount(*only, v) / setup.lines[*only].sin_an, 0.0),
                _ => split(&setup.lines, amount(Flank::Left, v), amount(Flank::Right, v)),
            };
            (delta_d.value(v) + more_d, delta_phi_2.value(v) + more_phi)
        })
        .unzip();
    let law = |values: &[f64]| MotionLaw::spline(&feeds, values).map_err(GeneratingError::Law);
    Ok((law(&d)?, law(&phi)?))
}
