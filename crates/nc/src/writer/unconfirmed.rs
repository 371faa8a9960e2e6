//! What the writers take for granted about a control without a manual or a measurement behind it (marked [U] in
//! `docs/mathematics/programs.md`). It stands here and nowhere else, so that an owner of the control changes one file. The reader has its
//! own list.

/// Siemens: metric, absolute, plane, no radius compensation, no frame, path mode.
pub(super) const SIEMENS_PREAMBLE: &str = "G710 G90 G17 G40 G500 G64";
/// Siemens: when the block after a coupling starts: `NOC`, `FINE`, `COARSE` or `IPOSTOP`.
pub(super) const SIEMENS_BLOCK_CHANGE: &str = "FINE";
/// Siemens: what a leading axis gives: 0 its actual value, 1 its setpoint.
pub(super) const SIEMENS_LEADER_TYPE: u8 = 1;
/// Siemens: longest line.
pub(super) const SIEMENS_LINE: usize = 512;
/// Siemens: feed of the blocks of a table, which do not move anything, in inverse time.
pub(super) const SIEMENS_TABLE_FEED: &str = " F60.000000";
/// Siemens: a spline ends with the next motion command, also without axes.
pub(super) const SIEMENS_SPLINE_END: &str = "G1";

/// Siemens: what makes the assignment to an output an action of the next motion block, in the interpolator and without a stop; by
/// itself the assignment would need STOPRE before it, which ends the motion.
pub(super) const SIEMENS_OUTPUT: &str = "WHEN TRUE DO ";

/// Siemens: what changes the tool that T has named, after D with its offset.
pub(super) const SIEMENS_TOOL_CHANGE: &str = " M6";

/// Siemens: a motion that a probe at the first input ends.
pub(super) const SIEMENS_PROBE: &str = "MEAS=1 G1";
/// Siemens: an alarm of the user where the probe has touched nothing, after the control has waited for the motion.
pub(super) const SIEMENS_NO_TOUCH: &str = "STOPRE\nIF $AC_MEA[1]==0\nSETAL(65000)\nENDIF";
/// Siemens: R parameters of kept places, before the first.
pub(super) const SIEMENS_KEPT: u16 = 100;

/// Fanuc: variables of kept places, before the first.
pub(super) const FANUC_KEPT: u16 = 100;
/// Fanuc: variable of the skip position of the first axis; axes follow in the order of the machine description.
pub(super) const FANUC_SKIP_POSITION: usize = 5061;
/// Fanuc: variables of the first axis in G54, and in G54.1 P1; twenty for each offset.
pub(super) const FANUC_OFFSETS: usize = 5221;
pub(super) const FANUC_MORE_OFFSETS: usize = 7001;
/// Fanuc: an alarm where the skip position is the end of the block.
pub(super) const FANUC_NO_TOUCH: &str = "]]LT0.0005]THEN#3000=101(NO TOUCH)";

/// Fanuc: metric, absolute, plane, no radius and length compensation, no cycle.
pub(super) const FANUC_PREAMBLE: &str = "G21 G90 G17 G40 G49 G80";
/// Fanuc: contour mode on, alone in its block.
pub(super) const FANUC_CONTOUR_ON: &str = "G05.1 Q1";
/// Fanuc: contour mode off.
pub(super) const FANUC_CONTOUR_OFF: &str = "G05.1 Q0";
/// Fanuc: longest line.
pub(super) const FANUC_LINE: usize = 256;
/// Fanuc: what a comment may hold.
pub(super) fn is_fanuc_comment(byte: u8) -> bool {
    byte.is_ascii_uppercase() || byte.is_ascii_digit() || byte == b' '
}
/// Fanuc: a dwell in seconds takes X with a point.
pub(super) const FANUC_DWELL: &str = "G4 X";
/// Fanuc: keeps the control from reading ahead, so that the macro statement after it waits until the axes stand.
pub(super) const FANUC_READ_NO_FURTHER: &str = "G53";
/// Fanuc: system variable of output 0; that of output n follows n places later.
pub(super) const FANUC_FIRST_OUTPUT: u16 = 1100;
/// Fanuc: the word that picks a spindle other than the first; its number counts from 1.
pub(super) const FANUC_SPINDLE_WORD: char = 'P';
/// Fanuc: what changes the tool that T has named; its offset stands beside G43.4 and G43.5.
pub(super) const FANUC_TOOL_CHANGE: &str = " M6";
