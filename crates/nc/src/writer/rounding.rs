//! How far the tool on the workpiece may be off because numbers are rounded (`docs/mathematics/programs.md#cutters`), stated for a whole
//! program from which words its blocks have. Knows no dialect and no machine: the distances from the axes of rotation are given.

use super::options::WriteOptions;
use crate::{AxisMotion, AxisWord, Block, NcError, Orientation, Program, Targets, Word};

/// What rounding adds at most.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RoundingBound {
    /// How far the cutting point is moved at most, mm.
    pub distance: f64,
    /// The block where it is, counted from 1; 0 if no block moves.
    pub block: usize,
    /// Share of rounded places, mm: half a unit of each straight axis or part of the tip, at right angles to each other.
    pub places: f64,
    /// Share of rounded angles and directions, mm.
    pub angles: f64,
}

/// States what rounding with these options adds at most, over all blocks: for straight axes at right angles half a unit each,
/// 0.087 um for three of four decimals, and for every rotary axis half a unit at the distance of the cutting point, 0.087e-3 um for
/// each mm at five decimals (`docs/mathematics/programs.md#cutters`). Axes that a block does not name stand where their last, rounded value
/// put them.
///
/// `from_axes` is the greatest distance of a cutting point from an axis of rotation, `from_tip` that of a cutting point from the
/// tip of its tool, both mm: under tip control the tip stays where it is when the tool turns. What happens inside a block and what
/// gears and curves do is not covered.
///
/// # Errors
/// `BadHeader` for options out of range or distances that are not finite and from 0.
pub fn rounding_bound(
    program: &Program,
    options: &WriteOptions,
    from_axes: f64,
    from_tip: f64,
) -> Result<RoundingBound, NcError> {
    options.check()?;
    // Written so that NaN fails.
    let fits = |distance: f64| (0.0..=1e6).contains(&distance);
    if !fits(from_axes) || !fits(from_tip) {
        return Err(NcError::BadHeader { reason: "distances from the axes; allowed: 0 to 1e6 mm".into() });
    }
    let half = |decimals: u8| 0.5 * 10f64.powi(-i32::from(decimals));
    let (place, angle) = (half(options.decimals.mm), half(options.decimals.deg).to_radians());
    // A unit vector whose three parts are each half a unit off.
    let direction = (3f64.sqrt() * half(options.tip_decimals.direction)).asin();
    let mut bound = RoundingBound { distance: 0.0, block: 0, places: 0.0, angles: 0.0 };
    let mut named = 0u16;
    let straight = axes_mask(program.axes(), AxisMotion::Linear);
    let turning = axes_mask(program.axes(), AxisMotion::Rotary);
    // Rotary axes and directions that were named under tip control.
    let (mut turned, mut tilt) = (0u16, 0.0);
    for (k, block) in program.blocks().iter().enumerate() {
        let (places, angles) = match block {
            Block::Rapid(target) | Block::Linear { target, .. } => {
                named |= Targets::mask(target);
                let count = |mask: u16| f64::from((named & mask).count_ones());
                (place * count(straight).sqrt(), angle * count(turning) * from_axes)
            }
            Block::Tip(motion) => {
                match motion.orientation {
                    Orientation::Kept => {}
                    Orientation::Direction(_) => tilt = direction,
                    Orientation::Angles(angles) => {
                        turned = angles.iter().fold(turned, |mask, (axis, _)| mask | 1 << axis);
                        tilt = angle * f64::from(turned.count_ones());
                    }
                }
                (place * 3f64.sqrt(), tilt * from_tip)
            }
            // The control has moved the axes on its own.
            Block::TipControlOff => {
                (named, turned, tilt) = (0, 0, 0.0);
                continue;
            }
            _ => continue,
        };
        if bound.block == 0 || places + angles > bound.distance {
            bound = RoundingBound { distance: places + angles, block: k + 1, places, angles };
        }
    }
    Ok(bound)
}

/// One bit for every axis of a kind that is no spindle.
fn axes_mask(axes: &[AxisWord], motion: AxisMotion) -> u16 {
    let of_kind = |axis: &AxisWord| axis.motion == motion && !matches!(axis.word, Word::Spindle(_));
    (0..).zip(axes).filter(|(_, axis)| of_kind(axis)).fold(0, |mask, (k, _)| mask | 1 << k)
}
