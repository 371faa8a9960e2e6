//! Left and right: the two flanks of a tooth space and pairs of values that belong to them.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Flank of a tooth space, seen from +z towards -z. The left flank lies at x > 0 for z = 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Flank {
    /// s = +1
    Left,
    /// s = -1
    Right,
}

impl Flank {
    /// Both flanks, left first.
    pub const BOTH: [Flank; 2] = [Flank::Left, Flank::Right];

    /// The sign s of `docs/mathematics/conventions.md`: +1 for left, -1 for right.
    pub fn sign(self) -> f64 {
        match self {
            Flank::Left => 1.0,
            Flank::Right => -1.0,
        }
    }

    /// The flank across the tooth space.
    pub fn other(self) -> Flank {
        match self {
            Flank::Left => Flank::Right,
            Flank::Right => Flank::Left,
        }
    }

    /// `"left"` or `"right"`, as job files spell it.
    pub const fn name(self) -> &'static str {
        match self {
            Flank::Left => "left",
            Flank::Right => "right",
        }
    }
}

impl std::fmt::Display for Flank {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(self.name())
    }
}

/// One value for each flank.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
pub struct Sides<T> {
    /// Value of the left flank.
    pub left: T,
    /// Value of the right flank.
    pub right: T,
}

impl<T> Sides<T> {
    /// Builds both values by the same rule.
    pub fn from_fn(mut build: impl FnMut(Flank) -> T) -> Self {
        Self { left: build(Flank::Left), right: build(Flank::Right) }
    }

    /// As [`Sides::from_fn`]; the first error (left before right) ends it.
    pub fn try_from_fn<E>(mut build: impl FnMut(Flank) -> Result<T, E>) -> Result<Self, E> {
        Ok(Self { left: build(Flank::Left)?, right: build(Flank::Right)? })
    }

    /// Applies a function to both values.
    pub fn map<U>(&self, mut f: impl FnMut(Flank, &T) -> U) -> Sides<U> {
        Sides { left: f(Flank::Left, &self.left), right: f(Flank::Right, &self.right) }
    }

    /// Left and right with their names, left first.
    pub fn iter(&self) -> impl Iterator<Item = (Flank, &T)> {
        [(Flank::Left, &self.left), (Flank::Right, &self.right)].into_iter()
    }
}

impl<T: Clone> Sides<T> {
    /// The same value on both flanks.
    pub fn both(value: T) -> Self {
        Self { left: value.clone(), right: value }
    }
}

impl<T> std::ops::Index<Flank> for Sides<T> {
    type Output = T;
    fn index(&self, flank: Flank) -> &T {
        match flank {
            Flank::Left => &self.left,
            Flank::Right => &self.right,
        }
    }
}

impl<T> std::ops::IndexMut<Flank> for Sides<T> {
    fn index_mut(&mut self, flank: Flank) -> &mut T {
        match flank {
            Flank::Left => &mut self.left,
            Flank::Right => &mut self.right,
        }
    }
}
