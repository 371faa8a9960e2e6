//! Which way round an axis is mounted.

/// +1 or -1.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Sign {
    /// +1.
    #[default]
    Plus,
    /// -1.
    Minus,
}

impl Sign {
    /// The sign of a number, `Plus` for 0.
    pub(crate) fn of(value: f64) -> Self {
        if value < 0.0 { Self::Minus } else { Self::Plus }
    }

    /// The product of two signs.
    pub(crate) const fn times(self, other: Self) -> Self {
        match (self, other) {
            (Self::Plus, Self::Plus) | (Self::Minus, Self::Minus) => Self::Plus,
            (Self::Plus, Self::Minus) | (Self::Minus, Self::Plus) => Self::Minus,
        }
    }

    /// +1 or -1 as an integer.
    pub const fn as_i64(self) -> i64 {
        match self {
            Self::Plus => 1,
            Self::Minus => -1,
        }
    }

    /// +1.0 or -1.0.
    pub const fn as_f64(self) -> f64 {
        match self {
            Self::Plus => 1.0,
            Self::Minus => -1.0,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Sign;

    #[test]
    fn signs_multiply_as_their_numbers_do() {
        for a in [Sign::Plus, Sign::Minus] {
            for b in [Sign::Plus, Sign::Minus] {
                assert_eq!(a.times(b).as_i64(), a.as_i64() * b.as_i64());
                assert_eq!(Sign::of(a.as_f64()), a);
            }
        }
        assert_eq!(Sign::of(0.0), Sign::Plus);
    }
}
