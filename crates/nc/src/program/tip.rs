//! The tip of a milling tool and its axis (`docs/mathematics/milling.md#cutter-location` and `docs/mathematics/programs.md#cutters`): what
//! a control with tool centre point control (RTCP) receives instead of axis values. Knows no dialect.

/// How the blocks under tip control give the tool's axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum TipControl {
    /// As a direction in the frame of the workpiece.
    Directions,
    /// As values of the rotary axes.
    Angles,
}

/// Most rotary axes that turn a tool.
pub const MAXIMUM_ANGLES: usize = 3;

/// Values of one to three rotary axes in the order in which they are written.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Angles {
    values: [f64; MAXIMUM_ANGLES],
    axes: [u8; MAXIMUM_ANGLES],
    count: u8,
}

impl Angles {
    /// Axis index and value in rad of each axis; none without an axis, with more than [`MAXIMUM_ANGLES`], with one twice or beyond
    /// those that a program can have.
    pub fn new(angles: &[(usize, f64)]) -> Option<Self> {
        if angles.is_empty() || angles.len() > MAXIMUM_ANGLES {
            return None;
        }
        let mut made = Self { values: [0.0; MAXIMUM_ANGLES], axes: [0; MAXIMUM_ANGLES], count: 0 };
        for &(axis, value) in angles {
            if axis >= super::MAXIMUM_AXES || made.get(axis).is_some() {
                return None;
            }
            let place = usize::from(made.count);
            (made.values[place], made.axes[place]) = (value, axis as u8);
            made.count += 1;
        }
        Some(made)
    }

    /// Axis index and value, rad.
    pub fn iter(&self) -> impl Iterator<Item = (usize, f64)> + '_ {
        (0..usize::from(self.count)).map(|k| (usize::from(self.axes[k]), self.values[k]))
    }

    /// The value of an axis, if it has one.
    pub fn get(&self, axis: usize) -> Option<f64> {
        self.iter().find(|(of, _)| *of == axis).map(|(_, value)| value)
    }
}

/// Where the tool's axis points at the end of a block.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Orientation {
    /// Where it points already.
    Kept,
    /// Unit vector from the tip towards the holder, in the frame of the workpiece. It may be a thousandth off its length, as one is
    /// that was rounded.
    Direction([f64; 3]),
    /// By the rotary axes.
    Angles(Angles),
}

/// How fast a block under tip control is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Pace {
    /// As fast as the axes can.
    Rapid,
    /// Speed of the tip on the workpiece, mm/s: 0.1 to 1e6 mm/min. Where the tip rests while the axis turns, controls count it in
    /// ways of their own: such a block wants a time.
    Speed(f64),
    /// At the speed that was given last.
    Kept,
    /// Time of the block, s: a feed in inverse time.
    Duration(f64),
}

/// A straight motion of the tip in the frame of the workpiece; the axis goes from where it points to where it shall.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TipMotion {
    /// Where the tip goes, mm.
    pub tip: [f64; 3],
    /// Where the axis points there.
    pub orientation: Orientation,
    /// How fast.
    pub pace: Pace,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn angles_keep_their_order_and_no_axis_stands_twice() {
        let angles = Angles::new(&[(4, 0.5), (3, -1.0)]).unwrap();
        assert_eq!(angles.iter().collect::<Vec<_>>(), [(4, 0.5), (3, -1.0)]);
        assert_eq!((angles.get(3), angles.get(0)), (Some(-1.0), None));
        for wrong in [&[][..], &[(0, 0.0), (0, 1.0)], &[(16, 0.0)], &[(0, 0.0), (1, 0.0), (2, 0.0), (3, 0.0)]]
        {
            assert_eq!(Angles::new(wrong), None);
        }
    }
}
