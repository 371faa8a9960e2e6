//! The axes of a program, their words on a control, and values for some of them. Knows no block.

/// Most axes of a program.
pub const MAXIMUM_AXES: usize = 16;

/// What an axis does and in which unit its values are.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum AxisMotion {
    /// Straight, mm.
    Linear,
    /// Turning, rad in the program and degrees in a control's text; endless, never reduced to one turn.
    Rotary,
}

/// What a control calls an axis.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum Word {
    /// One of X Y Z A B C U V W.
    Letter(char),
    /// An address with an equals sign, such as `B1` in `B1=30.5`; 2 to 8 characters of A-Z and 0-9, the first a letter, the last a
    /// digit.
    Named(String),
    /// A spindle, counted from 0: it turns at a speed and may lead a gear, but has no target.
    Spindle(u8),
}

/// A machine axis and its word on the control.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct AxisWord {
    /// Name of the machine axis, e.g. `C2`: [A-Z0-9_]{1,24}.
    pub name: String,
    /// Straight or turning.
    pub motion: AxisMotion,
    /// Its word in the text.
    pub word: Word,
}

impl AxisWord {
    /// An axis with a letter of its own.
    pub fn letter(name: &str, motion: AxisMotion, letter: char) -> Self {
        Self { name: name.to_owned(), motion, word: Word::Letter(letter) }
    }

    /// An axis with an address that is its own name.
    pub fn named(name: &str, motion: AxisMotion) -> Self {
        Self { name: name.to_owned(), motion, word: Word::Named(name.to_owned()) }
    }

    /// A turning axis that the control runs as a spindle.
    pub fn spindle(name: &str, spindle: u8) -> Self {
        Self { name: name.to_owned(), motion: AxisMotion::Rotary, word: Word::Spindle(spindle) }
    }
}

/// What stands before the blocks.
#[derive(Clone, Debug, PartialEq)]
pub struct Header {
    /// Name of the program: [A-Z0-9_]{1,24}.
    pub name: String,
    /// The axes, 1 to [`MAXIMUM_AXES`], with names and words of their own.
    pub axes: Vec<AxisWord>,
    /// Largest deviation of the path that a control may make to keep its speed, mm; 0 asks for exact stops.
    pub chord_tolerance: f64,
}

/// Values for some of the axes, mm or rad. Copied as a whole, so that a block needs no memory of its own.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Targets {
    values: [f64; MAXIMUM_AXES],
    present: u16,
}

impl Targets {
    /// No axis.
    pub const NONE: Self = Self { values: [0.0; MAXIMUM_AXES], present: 0 };

    /// Values of the axes 0, 1, ...; those beyond [`MAXIMUM_AXES`] are left out.
    pub fn of_first(values: &[f64]) -> Self {
        let mut targets = Self::NONE;
        for (axis, &value) in values.iter().enumerate() {
            targets.set(axis, value);
        }
        targets
    }

    /// The same with one axis set.
    pub fn with(mut self, axis: usize, value: f64) -> Self {
        self.set(axis, value);
        self
    }

    /// Sets an axis; false if there cannot be such an axis.
    pub fn set(&mut self, axis: usize, value: f64) -> bool {
        let Some(place) = self.values.get_mut(axis) else { return false };
        *place = value;
        self.present |= 1 << axis;
        true
    }

    /// The value of an axis, if it has one.
    pub fn get(&self, axis: usize) -> Option<f64> {
        if axis < MAXIMUM_AXES && self.present >> axis & 1 == 1 { Some(self.values[axis]) } else { None }
    }

    /// Axis index and value, ascending.
    pub fn iter(&self) -> impl Iterator<Item = (usize, f64)> + '_ {
        let mut left = self.present;
        std::iter::from_fn(move || {
            if left == 0 {
                return None;
            }
            let axis = left.trailing_zeros() as usize;
            left &= left - 1;
            Some((axis, self.values[axis]))
        })
    }

    /// One bit for every axis that has a value, axis 0 the lowest.
    pub fn mask(&self) -> u16 {
        self.present
    }

    /// Whether no axis has a value.
    pub fn is_empty(&self) -> bool {
        self.present == 0
    }

    /// Takes over the values of `other` where it has some.
    pub fn update(&mut self, other: &Self) {
        for (axis, value) in other.iter() {
            self.set(axis, value);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn targets_hold_what_was_set_and_nothing_else() {
        let mut targets = Targets::of_first(&[1.0, 2.0]).with(15, -3.0);
        assert!(!targets.set(16, 1.0));
        assert_eq!(targets.iter().collect::<Vec<_>>(), [(0, 1.0), (1, 2.0), (15, -3.0)]);
        assert_eq!((targets.get(1), targets.get(2), targets.get(16)), (Some(2.0), None, None));
        targets.update(&Targets::NONE.with(1, 5.0));
        assert_eq!((targets.get(1), targets.mask()), (Some(5.0), 0b1000_0000_0000_0011));
        assert!(Targets::NONE.is_empty() && !targets.is_empty());
    }
}
