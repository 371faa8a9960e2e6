//! Single blocks of a stroke that leave its course: rays stand millimetres apart, and a block of some tenths of a millimetre would go
//! unseen between them. What a stroke is off the job's is compared with the same a block before and behind: an offset, a slope or a bow
//! of the whole stroke is checked by the referee, a jump is reported here.

use super::indexing::{Served, dressing_stock, shown_blocks};
use super::work::{DressingWork, GrindingWork};
use foundation::kinematics::{DressingMotion, GeneratingMotion};
use foundation::numerics::equidistant;
use motion::ReadStroke;
use verdict::Remark;

/// Places a block at which a stroke is looked at, and fewest and most places of a stroke.
const PLACES_A_BLOCK: usize = 4;
const PLACES: [usize; 2] = [64, 20_000];
/// What blocks and digits do is no jump, um.
const LEAST_UM: f64 = 0.2;
/// A block is at most this share of its stroke.
const LONGEST: f64 = 0.125;

/// Dressing strokes whose blocks leave their course by more than the tolerance.
pub fn jumps_of_dressing(
    works: &[&DressingWork],
    served: &[Served<DressingMotion>],
    tolerance_um: f64,
) -> Vec<Remark> {
    let of_stroke = |(work, stroke): (&&DressingWork, &ReadStroke<DressingMotion>)| {
        let off = |v: f64| dressing_stock(work, stroke, v);
        told(&work.name, "v_zS", stroke, work.interval, tolerance_um, off)
    };
    served.iter().flat_map(|of| works.iter().zip(&of.strokes).filter_map(of_stroke)).collect()
}

/// Grinding strokes whose blocks leave their course by more than the tolerance.
pub fn jumps_of_grinding(
    works: &[&GrindingWork],
    served: &[Served<GeneratingMotion>],
    tolerance_um: f64,
) -> Vec<Remark> {
    let of_stroke = |(work, stroke): (&&GrindingWork, &ReadStroke<GeneratingMotion>)| {
        let (is, wanted) = (&stroke.motion, &work.motion);
        let off = |v: f64| {
            let lifted = work.per_distance() * (is.delta_d.value(v) - wanted.delta_d.value(v));
            let turned = work.per_turn() * (is.delta_phi_2.value(v) - wanted.delta_phi_2.value(v));
            vec![lifted - turned, lifted + turned]
        };
        told(&work.name, "z_V2", stroke, work.feeds, tolerance_um, off)
    };
    served.iter().flat_map(|of| works.iter().zip(&of.strokes).filter_map(of_stroke)).collect()
}

/// The largest jump of a stroke over its working part, if it is beyond the tolerance; `off` are distances along the flanks' normals, mm.
fn told<M>(
    name: &str,
    along: &str,
    stroke: &ReadStroke<M>,
    working: [f64; 2],
    tolerance_um: f64,
    off: impl Fn(f64) -> Vec<f64>,
) -> Option<Remark> {
    let [first, last] = stroke.range;
    let [from, to] = [working[0].max(first), working[1].min(last)];
    if from.partial_cmp(&to) != Some(std::cmp::Ordering::Less) {
        return None;
    }
    let blocks = stroke.blocks[1].saturating_sub(stroke.blocks[0]) + 1;
    let step = ((last - first) / blocks as f64).min(LONGEST * (last - first));
    let count = (PLACES_A_BLOCK * blocks).clamp(PLACES[0], PLACES[1]);
    let mut worst = (0.0f64, from);
    for v in equidistant([from, to], count) {
        let [before, behind] = [(v - step).max(from), (v + step).min(to)];
        let share = (v - before) / (behind - before);
        let ends = off(before).into_iter().zip(off(behind));
        for (here, (a, b)) in off(v).into_iter().zip(ends) {
            let jump = (here - (1.0 - share) * a - share * b).abs();
            if jump > worst.0 || jump.is_nan() {
                worst = (jump, v);
            }
        }
    }
    let (jump_um, at) = (1e3 * worst.0, worst.1);
    // Written so that NaN is told.
    let smooth = jump_um <= tolerance_um.max(LEAST_UM);
    (!smooth).then(|| {
        let text = format!(
            "{name}, blocks {}: at {along} = {at:.3} mm a block leaves the course of its stroke by {jump_um:.4} um; the tolerance is {tolerance_um} um",
            shown_blocks(std::iter::once(stroke.blocks))
        );
        Remark::new("block-astray", text, "correct the axes of the block there")
    })
}
