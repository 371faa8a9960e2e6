//! The blocks of a program. Every motion starts where the axes stand. Knows no dialect.

use super::cubic_span::CubicSpan;
use super::{
    Coolant, CurveTable, Gear, GearSynchronisation, OffsetShift, ProbeMove, Targets, TipControl, TipMotion,
};

/// One step of a program.
#[derive(Clone, Debug, PartialEq)]
pub enum Block {
    /// All axes named go to their targets, each at its own greatest speed.
    Rapid(Targets),
    /// All axes named go to their targets in proportion.
    Linear {
        /// Where to, mm or rad.
        target: Targets,
        /// Time of the block, s, above 0.
        duration: f64,
    },
    /// Cubics of one parameter.
    Cubic(Box<CubicMotion>),
    /// A B-spline.
    BSpline(Box<BSplineMotion>),
    /// All axes wait, s: 1e-6 to 1e5.
    Dwell(f64),
    /// A spindle turns at a speed.
    Spindle {
        /// The spindle, counted from 0.
        spindle: u8,
        /// rad/s, above 0 clockwise as the control names it, 0 stops.
        speed: f64,
    },
    /// A digital output is switched when the motion before it has ended; a motion must follow. At a light barrier it tells the
    /// recorder to take down where the tool spindle stands at every switch.
    Output {
        /// The output, 1 to 15: what all controls have.
        number: u8,
        /// Whether it is on from here.
        on: bool,
    },
    /// Text for people: printable ASCII without brackets and semicolons.
    Comment(Box<str>),
    /// The control waits for its operator.
    Stop,
    /// The last block: feed mode as before, spindles off.
    End,
    /// What a gear does once it is on.
    GearDefine(Box<Gear>),
    /// The follower is coupled from here on.
    GearOn {
        /// Axis index of the follower of a gear that is defined.
        follower: usize,
        /// Where follower and leaders stand to each other; none: as they stand now.
        synchronisation: Option<Box<GearSynchronisation>>,
    },
    /// The follower is free again.
    GearOff {
        /// Axis index.
        follower: usize,
    },
    /// A curve that a gear may use.
    Table(Box<CurveTable>),
    /// Another tool; the control stops spindle 0 for it.
    Tool {
        /// Its number, 1 to 99999999.
        number: u32,
        /// Number of its length offset on the control, 1 to 999; tip control needs one.
        length_offset: Option<u32>,
    },
    /// From here on the control adds the length that it holds under this number to axis values, which are those of the tip then, until
    /// it adds none or another tool comes; 1 to 999. Not under tip control, which adds the length of its tool itself.
    LengthOffset(Option<u32>),
    /// From here on values count from the origin that the control holds under this number, see [`super::WORK_OFFSETS`].
    WorkOffset(u16),
    /// An axis goes until a probe touches; where it stands then is known to the control alone.
    Probe(ProbeMove),
    /// A work offset is corrected by what was probed.
    ShiftOffset(OffsetShift),
    /// Coolant; a supply stays on until all are off.
    Coolant(Coolant),
    /// From here on the control guides the tip of the tool (RTCP): [`Block::Tip`] and no axis values.
    TipControlOn(TipControl),
    /// From here on axis values again.
    TipControlOff,
    /// The tip of the tool goes along a straight line, under tip control.
    Tip(TipMotion),
    /// Speed of the blocks under tip control that keep theirs, mm/s: 0.1 to 1e6 mm/min.
    TipSpeed(f64),
}

impl Block {
    /// Whether axes or the tip of the tool move.
    pub fn moves(&self) -> bool {
        matches!(
            self,
            Self::Rapid(_)
                | Self::Linear { .. }
                | Self::Cubic(_)
                | Self::BSpline(_)
                | Self::Tip(_)
                | Self::Probe(_)
        )
    }
}

/// Motion of some axes by cubics of one parameter u in 0..1.
#[derive(Clone, Debug, PartialEq)]
pub struct CubicMotion {
    /// Axis index and cubic, ascending in the index; each axis must stand at a known place.
    pub spans: Vec<(usize, CubicSpan)>,
    /// Time of the block, s, above 0.
    pub duration: f64,
}

/// Motion of some axes along one B-spline.
#[derive(Clone, Debug, PartialEq)]
pub struct BSplineMotion {
    /// 2 or 3.
    pub degree: usize,
    /// The control points after the first, which is where the axes stand; all name the same axes. At least `degree`.
    pub points: Vec<Targets>,
    /// Ascending, clamped: the first and the last `degree` + 1 are equal; as many as points + degree + 2.
    pub knots: Vec<f64>,
    /// Time of the whole curve, s, above 0.
    pub duration: f64,
}

impl BSplineMotion {
    /// Value of an axis at a parameter (de Boor); `start` is where the axis stands. None if the axis does not move here or the
    /// numbers of points and knots do not belong together.
    pub fn value(&self, axis: usize, start: f64, parameter: f64) -> Option<f64> {
        let count = self.points.len() + 1;
        if self.degree == 0 || count <= self.degree || self.knots.len() != count + self.degree + 1 {
            return None;
        }
        let interval = self.knots[self.degree..count].partition_point(|&knot| knot <= parameter);
        let interval = (self.degree + interval).saturating_sub(1).clamp(self.degree, count - 1);
        let first = interval - self.degree;
        let mut work = Vec::with_capacity(self.degree + 1);
        for point in first..=interval {
            work.push(if point == 0 {
                self.points[0].get(axis).map(|_| start)?
            } else {
                self.points[point - 1].get(axis)?
            });
        }
        for level in 1..=self.degree {
            for j in (level..=self.degree).rev() {
                let (low, high) = (self.knots[first + j], self.knots[first + j + self.degree + 1 - level]);
                let share = if high > low { (parameter - low) / (high - low) } else { 0.0 };
                work[j] = (1.0 - share) * work[j - 1] + share * work[j];
            }
        }
        work.last().copied()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_clamped_spline_of_one_interval_is_its_bezier_curve() {
        let point = |v: f64| Targets::NONE.with(2, v);
        let motion = BSplineMotion {
            degree: 3,
            points: vec![point(1.0), point(4.0), point(9.0)],
            knots: vec![0.0, 0.0, 0.0, 0.0, 2.0, 2.0, 2.0, 2.0],
            duration: 1.0,
        };
        for u in [0.0, 0.25, 0.7, 1.0] {
            let v = 1.0 - u;
            let bezier = -2.0 * v * v * v + 3.0 * v * v * u + 12.0 * v * u * u + 9.0 * u * u * u;
            assert!((motion.value(2, -2.0, 2.0 * u).unwrap() - bezier).abs() < 1e-14);
        }
        assert_eq!(motion.value(1, 0.0, 0.5), None);
    }

    #[test]
    fn a_block_stays_small() {
        assert!(size_of::<Block>() <= 152, "{}", size_of::<Block>());
    }
}
