//! The usual sets of four conditions by name, and the worm position that puts a contact line through a point
//! (`docs/mathematics/dressing.md#conditions`). Knows no solver.

use crate::{Condition, DressedProfile, DresserTool, DressingError, FlankDresser};
use foundation::geometry::Flank;
use foundation::kinematics::DressingCorrection;

/// A pitch point: a modification wanted at a length of roll.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PitchPoint {
    /// Flank.
    pub flank: Flank,
    /// Length of roll, mm.
    pub w: f64,
    /// Wanted f_n, mm.
    pub f: f64,
}

impl From<PitchPoint> for Condition {
    fn from(PitchPoint { flank, w, f }: PitchPoint) -> Self {
        Self::Point { flank, w, f }
    }
}

/// Four pitch points, on one flank or spread over both. Four points on one flank of a worm are practically singular
/// (`docs/mathematics/dressing.md`).
pub fn four_points(points: [PitchPoint; 4]) -> [Condition; 4] {
    points.map(Condition::from)
}

/// Three pitch points, on one flank or spread over both, and one more condition: a radius map, a head height or a fixed axis.
pub fn three_points(points: [PitchPoint; 3], further: Condition) -> [Condition; 4] {
    let [a, b, c] = points.map(Condition::from);
    [a, b, c, further]
}

/// Two pitch points, on one flank or one on each, and two more conditions: two head heights, head height and radius map, axes
/// that the machine does not have.
pub fn two_points(points: [PitchPoint; 2], further: [Condition; 2]) -> [Condition; 4] {
    let ([a, b], [c, d]) = (points.map(Condition::from), further);
    [a, b, c, d]
}

/// The radius map that leaves the upper end of the profile in its place: what was designed for w_NaS dresses w_NaS.
pub fn map_of_upper_end(dresser: &FlankDresser) -> Condition {
    Condition::Map { flank: dresser.worm.flank, t: dresser.designed.w_na, w: dresser.range.w_na }
}

/// Modifications `f` (mm) at both ends and in the middle of the used range with [`map_of_upper_end`].
pub fn three_points_with_map(dresser: &FlankDresser, f: [f64; 3]) -> [Condition; 4] {
    let (flank, range) = (dresser.worm.flank, &dresser.range);
    let rolls = [range.w_nf, range.middle(), range.w_na];
    let points = std::array::from_fn(|i| PitchPoint { flank, w: rolls[i], f: f[i] });
    three_points(points, map_of_upper_end(dresser))
}

/// Modifications (mm) at both ends of the used range of both flanks: allowance and profile angle of each.
pub fn two_flank_points(tool: &DresserTool, left: [f64; 2], right: [f64; 2]) -> [Condition; 4] {
    let point = |flank: Flank, upper: bool| {
        let (range, f) = (&tool.flanks[flank].range, if flank == Flank::Left { left } else { right });
        let w = if upper { range.w_na } else { range.w_nf };
        PitchPoint { flank, w, f: f[usize::from(upper)] }
    };
    four_points([
        point(Flank::Left, false),
        point(Flank::Left, true),
        point(Flank::Right, false),
        point(Flank::Right, true),
    ])
}

/// Worm position v_zS (mm) at which the contact line of a correction goes through the worm point (w, b): the fifth condition
/// beside four on the corrections, which do not depend on it.
///
/// # Errors
/// As [`DressedProfile::at_roll`]; [`DressingError::InvalidNumber`].
pub fn shift_through(
    tool: &DresserTool,
    flank: Flank,
    dk: &DressingCorrection,
    w: f64,
    b: f64,
) -> Result<f64, DressingError> {
    if !b.is_finite() {
        let (field, allowed) = ("worm z of a point on the contact line", "finite numbers");
        return Err(DressingError::InvalidNumber { field, value: b, allowed });
    }
    Ok(DressedProfile::new(tool, flank, *dk).at_roll(w)?.b - b)
}
