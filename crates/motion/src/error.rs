//! Why a motion cannot be driven or read back.

use finding::Finding;
use machine::MachineError;
use nc::NcError;
use thiserror::Error;

/// Why a motion cannot be driven by a machine, or a program not be followed.
#[derive(Clone, Debug, PartialEq, Error, Finding)]
pub enum MotionError {
    /// The machine cannot stand where a stroke needs it.
    #[error("{stroke}, at {v:.3} mm: {error}")]
    #[finding(transparent = error)]
    Machine {
        /// The stroke.
        stroke: String,
        /// Its path parameter there, mm.
        v: f64,
        /// What the machine says.
        error: MachineError,
    },
    /// The machine cannot stand at a place of a cutter's path.
    #[error("place {place} of the cutter: {error}")]
    #[finding(transparent = error)]
    Place {
        /// Number of the place, from 1.
        place: usize,
        /// What the machine says.
        error: MachineError,
    },
    /// Two places one after the other are one place.
    #[error("places {place} and {next} of the cutter are one: a block between them has no duration", next = place + 1)]
    #[finding(code = "no-motion")]
    #[way_out("leave out one of the two places")]
    NoMotion {
        /// Number of the first of them, from 1.
        place: usize,
    },
    /// Straight blocks do not come near enough to the cutter's path.
    #[error(
        "after place {place} of the cutter straight blocks still miss it by {tip_um:.6} um at the tip and {axis_deg:.6} deg after \
         {pieces} pieces; wanted: {tip_tolerance_um} um, {axis_tolerance_deg} deg"
    )]
    #[finding(code = "tolerance-not-reached")]
    #[way_out("raise the tolerances, or keep the path away from the pole by a tilted mount")]
    CutterMissed {
        /// Number of the place before, from 1.
        place: usize,
        /// Pieces tried.
        pieces: usize,
        /// Deviation of the tip left, um.
        tip_um: f64,
        /// Wanted, um.
        tip_tolerance_um: f64,
        /// Deviation of the axis left, deg.
        axis_deg: f64,
        /// Wanted, deg.
        axis_tolerance_deg: f64,
    },
    /// A rotary axis is to stand still near the pole for a cutter that needs its axis.
    #[error("near the pole the first rotary axis can be held for ball cutters only")]
    #[finding(code = "hold-needs-ball")]
    #[way_out("take a ball cutter, slow down near the pole, or tilt the mount")]
    HoldNeedsBall,
    /// No mount keeps a path away from the pole.
    #[error(
        "no mount tilted by up to {greatest_deg} deg keeps the path {clearance_deg} deg away from the pole"
    )]
    #[finding(code = "no-tilt")]
    #[way_out("allow a greater tilt, divide the path, or ask for a smaller distance")]
    NoTilt {
        /// Greatest tilt tried, deg.
        greatest_deg: f64,
        /// Wanted distance, deg.
        clearance_deg: f64,
    },
    /// The machine itself lacks something.
    #[error(transparent)]
    #[finding(transparent)]
    Lacking(#[from] MachineError),
    /// An axis that moves has no word in this control's programs.
    #[error("{axis} moves by {travel:.6} {unit} in this program and has no word on the control")]
    #[finding(code = "axis-not-available")]
    #[way_out("give {axis} a word in the machine's [controls], or take another control")]
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
    #[finding(code = "axis-not-available")]
    #[way_out("correct `letter` or `words` of the machine description")]
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
    #[finding(code = "tolerance-not-reached")]
    #[way_out("raise chord_tolerance_um of the control")]
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
    #[finding(code = "unsupported-coupling")]
    #[way_out("set coupling = \"blocks\" for this control")]
    UnsupportedCoupling {
        /// Why.
        reason: String,
    },
    /// A quantity that is no number or out of range.
    #[error("{field} = {value} is not usable; allowed: {allowed}")]
    #[finding(code = "invalid-number")]
    #[way_out("give a number in the range")]
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
    #[finding(transparent)]
    Program(#[from] NcError),
    /// A program that does not move two bodies against each other as this job needs.
    #[error("block {block} of the program cannot be followed: {reason}")]
    #[finding(code = "program-not-followed")]
    #[way_out("take a program that was written for this job and machine")]
    NotFollowed {
        /// Block, from 1.
        block: usize,
        /// Why.
        reason: String,
    },
}
