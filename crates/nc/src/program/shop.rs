//! What a shop sets up beside motions: coolant, work offsets, and how one is measured. Knows no dialect.

/// A supply of coolant, or none.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Coolant {
    /// All supplies are off.
    Off,
    /// The first supply is on, commonly flood.
    Flood,
    /// The second supply is on: mist, or what the builder of the machine has there.
    Mist,
}

/// An axis goes towards a place until a probe touches.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ProbeMove {
    /// Axis index.
    pub axis: usize,
    /// Where it stops if nothing is touched, which ends the program, mm or rad.
    pub to: f64,
    /// Its speed, mm/s or rad/s.
    pub speed: f64,
    /// Number, 1 to 9, under which the place of the axis at the touch is kept.
    pub slot: u8,
}

/// A work offset that is measured: the value of an axis in it grows by the mean of two kept places less what that would be otherwise.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OffsetShift {
    /// The work offset.
    pub number: u16,
    /// Axis index.
    pub axis: usize,
    /// Numbers of the places.
    pub slots: [u8; 2],
    /// Their mean where the offset is right, mm or rad.
    pub middle: f64,
}

/// Places that can be kept.
pub(crate) const SLOTS: std::ops::RangeInclusive<u8> = 1..=9;

/// Work offsets that can be numbered; each control has some of them.
pub const WORK_OFFSETS: std::ops::RangeInclusive<u16> = 1..=354;
