//! Why a motion cannot be driven or read back.

use crate::machine::MachineError;
use crate::nc::NcError;
use thiserror::Error;

/// Why a motion cannot be driven by a machine, or a program not be followed.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum MotionError {
    /// The machine cannot stand where a stroke needs it.
    #[error("{stroke}, at {v:.3} mm: {error}")]
    Machine {
        /// The stroke.
        stroke: String,
        /// Its path parameter there, mm.
        v: f64,
        /// What the machine says.
        error: MachineError,
    },
    /// The machine itself lacks something.
    #[error(transparent)]
    Lacking(#[from] MachineError),
    /// An axis that moves has no word in this control's programs.
    #[error("{axis} moves by {travel:.6} {unit} in this program and has no word on the control")]
    NoWord {
        /// Name of the axis.
        axis: String,
        /// How far it moves.
        travel: f64,
        /// "mm" or "deg".
        unit: &'static str,
    },
    /// A word that no control has.
    #[error(
        "the word {word:?} of {axis} is none; allowed: a letter of XYZABCUVW, a name such as B1, \"spindle 0\" .. \"spindle 7\", \"none\""
    )]
    InvalidWord {
        /// Name of the axis.
        axis: String,
        /// The word.
        word: String,
    },
    /// Straight blocks do not come near enough to the path.
    #[error(
        "{stroke}: straight blocks still miss the path by {deviation_um:.6} um on the flank after {pieces} pieces; wanted: {tolerance_um} um"
    )]
    ToleranceNotReached {
        /// The stroke.
        stroke: String,
        /// Pieces tried.
        pieces: usize,
        /// Largest deviation left, um.
        deviation_um: f64,
        /// Wanted, um.
        tolerance_um: f64,
    },
    /// A coupling that the electronic gearbox cannot keep.
    #[error("the electronic gearbox cannot couple this stroke: {reason}")]
    UnsupportedCoupling {
        /// Why.
        reason: String,
    },
    /// A quantity that is no number or out of range.
    #[error("{field} = {value} is not usable; allowed: {allowed}")]
    InvalidNumber {
        /// Name of the quantity.
        field: &'static str,
        /// Its value.
        value: f64,
        /// What is allowed.
        allowed: &'static str,
    },
    /// The neutral program refuses a block.
    #[error(transparent)]
    Program(#[from] NcError),
    /// A program that does not move two bodies against each other as this job needs.
    #[error("block {block} of the program cannot be followed: {reason}")]
    NotFollowed {
        /// Block, from 1.
        block: usize,
        /// Why.
        reason: String,
    },
}

impl MotionError {
    /// Stable kebab-case code.
    pub fn code(&self) -> &'static str {
        match self {
            Self::Machine { error, .. } | Self::Lacking(error) => error.code(),
            Self::NoWord { .. } | Self::InvalidWord { .. } => "axis-not-available",
            Self::ToleranceNotReached { .. } => "tolerance-not-reached",
            Self::UnsupportedCoupling { .. } => "unsupported-coupling",
            Self::InvalidNumber { .. } => "invalid-number",
            Self::Program(error) => error.code(),
            Self::NotFollowed { .. } => "program-not-followed",
        }
    }

    /// What the user can do about it, in one sentence.
    pub fn way_out(&self) -> String {
        match self {
            Self::Machine { error, .. } | Self::Lacking(error) => error.way_out(),
            Self::NoWord { axis, .. } => {
                format!("give {axis} a word in the machine's [controls], or take another control")
            }
            Self::InvalidWord { .. } => "correct `letter` or `words` of the machine description".into(),
            Self::ToleranceNotReached { .. } => "raise chord_tolerance_um of the control".into(),
            Self::UnsupportedCoupling { .. } => "set coupling = \"blocks\" for this control".into(),
            Self::InvalidNumber { .. } => "give a number in the range".into(),
            Self::Program(error) => error.way_out().to_string(),
            Self::NotFollowed { .. } => "take a program that was written for this job and machine".into(),
        }
    }
}
