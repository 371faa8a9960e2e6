//! The neutral program (`docs/mathematics/programs.md#the-independent-reader`): axes, blocks, couplings, tool tips. Inside mm, rad and s. A
//! [`Program`] is checked when it is made for everything that does not depend on a control; it knows no dialect and no text but names and
//! comments.

mod axes;
mod blocks;
mod check;
mod check_state;
mod check_tip;
mod coupling;
mod cubic_span;
mod shop;
mod tip;

pub use axes::{AxisMotion, AxisWord, Header, MAXIMUM_AXES, Targets, Word};
pub use blocks::{BSplineMotion, Block, CubicMotion};
pub use coupling::{
    Coupling, CurveTable, Gear, GearLeader, GearSynchronisation, Repetition, TablePiece, ToothData,
};
pub use cubic_span::CubicSpan;
pub(crate) use shop::SLOTS;
pub use shop::{Coolant, OffsetShift, ProbeMove, WORK_OFFSETS};
pub use tip::{Angles, MAXIMUM_ANGLES, Orientation, Pace, TipControl, TipMotion};

use super::NcError;

/// A checked neutral program: a header and its blocks, the last of which is [`Block::End`].
#[derive(Clone, Debug, PartialEq)]
pub struct Program {
    header: Header,
    blocks: Vec<Block>,
}

impl Program {
    /// Checks the header and every block (`docs/mathematics/programs.md#limits`).
    ///
    /// # Errors
    /// `BadHeader`, `BadText`, `UnknownAxis`, `NotMovable`, `EmptyMotion`, `UnknownStart`, `NumberRange`, `FeedRange`, `BadTable`,
    /// `DegreeNotSupported`, `BadSpline`, `GearState`, `SpindleStopped`, `TipControlState`, `EndMisplaced`.
    pub fn new(header: Header, blocks: Vec<Block>) -> Result<Self, NcError> {
        check::check(&header, &blocks)?;
        Ok(Self { header, blocks })
    }

    /// Name, axes, tolerance.
    pub fn header(&self) -> &Header {
        &self.header
    }

    /// The blocks in their order.
    pub fn blocks(&self) -> &[Block] {
        &self.blocks
    }

    /// The axes: an axis index of a block counts in this list.
    pub fn axes(&self) -> &[AxisWord] {
        &self.header.axes
    }
}
