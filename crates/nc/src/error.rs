//! Errors of a neutral program, and why a control cannot take it (`docs/mathematics/programs.md#limits`). Knows no dialect's grammar.

use thiserror::Error;

/// Why a program is refused. Blocks are counted from 1; 0 is the header.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum NcError {
    /// The axes, the tolerance or the options of a program do not fit together.
    #[error("the header of the program is wrong: {reason}")]
    BadHeader {
        /// What is wrong.
        reason: Box<str>,
    },
    /// An axis index beyond the axes of the program.
    #[error("block {block} names axis {index}, the program has {count}")]
    UnknownAxis {
        /// Block.
        block: usize,
        /// Index of the axis.
        index: usize,
        /// Axes of the program.
        count: usize,
    },
    /// A spindle was given a position to go to, or follows.
    #[error("block {block}: axis {axis} is a spindle and cannot be positioned")]
    NotMovable {
        /// Block.
        block: usize,
        /// Name of the axis.
        axis: Box<str>,
    },
    /// A motion without any axis.
    #[error("block {block} moves no axis")]
    EmptyMotion {
        /// Block.
        block: usize,
    },
    /// A curve starts where an axis stands, but nothing said where that is.
    #[error("block {block}: where axis {axis} stands at its start is not known")]
    UnknownStart {
        /// Block.
        block: usize,
        /// Name of the axis.
        axis: Box<str>,
    },
    /// A value that is not finite or that no control takes.
    #[error("block {block}: {axis} = {value}; allowed: {allowed}")]
    NumberRange {
        /// Block.
        block: usize,
        /// Name of the axis or of the word.
        axis: Box<str>,
        /// The value in the unit of the text: mm, deg, 1/min.
        value: f64,
        /// What is allowed.
        allowed: &'static str,
    },
    /// The target has no such axis word.
    #[error("axis {axis} cannot have the word {word} here; allowed: {allowed}")]
    AxisNotAvailable {
        /// Name of the axis.
        axis: Box<str>,
        /// Its word.
        word: Box<str>,
        /// Words of the target.
        allowed: &'static str,
    },
    /// A line longer than the control reads.
    #[error("block {block} is a line of {length} characters; allowed: {limit}")]
    BlockTooLong {
        /// Block.
        block: usize,
        /// Characters of the line.
        length: usize,
        /// Characters allowed.
        limit: usize,
    },
    /// A time that is not above 0, or an inverse-time feed out of its range.
    #[error(
        "block {block} of {duration} s; allowed: 6e-8 to 6e5 s, that is a feed F = 60/s of 0.0001 to 1e9"
    )]
    FeedRange {
        /// Block.
        block: usize,
        /// Its time, s.
        duration: f64,
    },
    /// A feed motion under a gear that a spindle leads, while that spindle stands.
    #[error("block {block} moves under a gear that spindle {spindle} leads, but the spindle stands")]
    SpindleStopped {
        /// Block.
        block: usize,
        /// The spindle, counted from 0.
        spindle: u8,
    },
    /// The target cannot couple axes this way, or not with these options.
    #[error("block {block}: this control cannot take the coupling: {reason}")]
    UnsupportedCoupling {
        /// Block.
        block: usize,
        /// What it cannot.
        reason: &'static str,
    },
    /// A gear term outside what the control takes.
    #[error("block {block}: {quantity} = {value}; allowed: {allowed}")]
    RatioRange {
        /// Block.
        block: usize,
        /// The word and what it means.
        quantity: &'static str,
        /// Its value in the unit of the text.
        value: f64,
        /// What is allowed.
        allowed: &'static str,
    },
    /// A curve table that no control could run.
    #[error("block {block}: table {table} {reason}")]
    BadTable {
        /// Block.
        block: usize,
        /// Number of the table.
        table: u32,
        /// What is wrong.
        reason: &'static str,
    },
    /// A degree that the target or the neutral program does not have.
    #[error("block {block}: a curve of degree {degree}; allowed: {allowed}")]
    DegreeNotSupported {
        /// Block.
        block: usize,
        /// The degree.
        degree: usize,
        /// What is allowed.
        allowed: &'static str,
    },
    /// Control points and knots that make no B-spline.
    #[error("block {block}: {reason}")]
    BadSpline {
        /// Block.
        block: usize,
        /// What is wrong.
        reason: &'static str,
    },
    /// A target that has no such block.
    #[error("block {block}: this control has no {what}")]
    BlockNotAvailable {
        /// Block.
        block: usize,
        /// The kind of block.
        what: &'static str,
    },
    /// Gears that are switched in an impossible order.
    #[error("block {block}: the gear of axis {axis} {reason}")]
    GearState {
        /// Block.
        block: usize,
        /// Name of the follower.
        axis: Box<str>,
        /// What is wrong.
        reason: &'static str,
    },
    /// Blocks of tip control in an impossible order, or that contradict how it was switched on.
    #[error("block {block} {reason}")]
    TipControlState {
        /// Block.
        block: usize,
        /// What is wrong.
        reason: &'static str,
    },
    /// A digital output that is switched where no motion carries it out.
    #[error("block {block}: an output {reason}")]
    OutputState {
        /// Block.
        block: usize,
        /// What is wrong.
        reason: &'static str,
    },
    /// A control that cannot guide the tip of the tool.
    #[error("block {block}: this control has no tool centre point control in its standard kinematics")]
    TipControlNotAvailable {
        /// Block.
        block: usize,
    },
    /// A name or comment that a control could misread.
    #[error("block {block}: the text {text:?} cannot stand in a program; allowed: {allowed}")]
    BadText {
        /// Block.
        block: usize,
        /// The text.
        text: Box<str>,
        /// What is allowed.
        allowed: &'static str,
    },
    /// The last block is no end, or an end stands before the last block.
    #[error("block {block}: a program ends with its one block `End`")]
    EndMisplaced {
        /// Block.
        block: usize,
    },
    /// What was written reads back as something else: a fault of the writer or the reader, never of the input.
    #[error("block {block}: {axis} reads back {delta} off what was to be written")]
    ReadBackMismatch {
        /// Block.
        block: usize,
        /// Name of the axis or of what differs.
        axis: Box<str>,
        /// Difference in the unit of the text; NaN if the kinds of block differ.
        delta: f64,
    },
    /// The reader refuses what was written: a fault of the writer or the reader, never of the input.
    #[error("what was written cannot be read back: {0}")]
    NotReadBack(Box<str>),
}

impl NcError {
    /// Stable kebab-case code.
    pub fn code(&self) -> &'static str {
        match self {
            Self::BadHeader { .. } => "nc-bad-header",
            Self::UnknownAxis { .. } => "nc-unknown-axis",
            Self::NotMovable { .. } => "nc-not-movable",
            Self::EmptyMotion { .. } => "nc-empty-motion",
            Self::UnknownStart { .. } => "nc-unknown-start",
            Self::NumberRange { .. } => "nc-number-range",
            Self::AxisNotAvailable { .. } => "nc-axis-not-available",
            Self::BlockTooLong { .. } => "nc-block-too-long",
            Self::FeedRange { .. } => "nc-feed-range",
            Self::SpindleStopped { .. } => "nc-spindle-stopped",
            Self::UnsupportedCoupling { .. } => "nc-unsupported-coupling",
            Self::RatioRange { .. } => "nc-ratio-range",
            Self::BadTable { .. } => "nc-bad-table",
            Self::DegreeNotSupported { .. } => "nc-degree-not-supported",
            Self::BadSpline { .. } => "nc-bad-spline",
            Self::BlockNotAvailable { .. } => "nc-block-not-available",
            Self::GearState { .. } => "nc-gear-state",
            Self::TipControlState { .. } => "nc-tip-control-state",
            Self::OutputState { .. } => "nc-output-state",
            Self::TipControlNotAvailable { .. } => "nc-tip-control-not-available",
            Self::BadText { .. } => "nc-bad-text",
            Self::EndMisplaced { .. } => "nc-end-misplaced",
            Self::ReadBackMismatch { .. } => "nc-read-back-mismatch",
            Self::NotReadBack(_) => "nc-not-read-back",
        }
    }

    /// What the user can do about it, in one sentence.
    pub fn way_out(&self) -> &'static str {
        match self {
            Self::BadHeader { .. } => "correct the axes, the tolerance or the options",
            Self::UnknownAxis { .. } => "use the axes that the header lists",
            Self::NotMovable { .. } => {
                "give the spindle a speed, or give the axis a letter or address of its own"
            }
            Self::EmptyMotion { .. } => "give a target, or a dwell if the axes shall wait",
            Self::UnknownStart { .. } => "move the axis to a known place by a rapid or linear block before",
            Self::NumberRange { .. } => "keep the value within the range of the control",
            Self::AxisNotAvailable { .. } => "give the axis another word in the axis map",
            Self::BlockTooLong { .. } => {
                "move fewer axes in one block, give fewer decimals or a shorter text"
            }
            Self::FeedRange { .. } => "give the block a time within the range, or divide the motion",
            Self::SpindleStopped { .. } => "start the spindle before the motion",
            Self::UnsupportedCoupling { .. } => {
                "expand the coupling into straight blocks, or take another control"
            }
            Self::RatioRange { .. } => "expand the coupling into straight blocks, or take another control",
            Self::BadTable { .. } => "let the leader rise or fall strictly and close a periodic table",
            Self::DegreeNotSupported { .. } => "divide the curve into cubics or straight blocks",
            Self::BadSpline { .. } => "give a clamped B-spline: points + degree + 2 ascending knots",
            Self::BlockNotAvailable { .. } => {
                "subdivide curves into straight blocks before, leave out what the control lacks, or take another control"
            }
            Self::GearState { .. } => "define a gear, switch it on, switch it off, in this order",
            Self::TipControlState { .. } => {
                "call a tool with its offset, switch tip control on, give directions, places and speeds, switch it off"
            }
            Self::OutputState { .. } => "let a motion follow after each switch of an output",
            Self::TipControlNotAvailable { .. } => {
                "transform the tip to axis values and give each block its time (G93), or take another control"
            }
            Self::BadText { .. } => "use plain ASCII letters, digits and blanks",
            Self::EndMisplaced { .. } => "put one `End` at the end of the program",
            Self::ReadBackMismatch { .. } | Self::NotReadBack(_) => {
                "report this: nothing was written, the fault is not in the input"
            }
        }
    }
}
