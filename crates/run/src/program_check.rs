//! What a program does on a machine: the part that programs of all processes share, and what a process adds by its bodies.

pub mod axes;
pub mod control;
pub mod machine;
pub mod result;

pub use axes::{
    Moved, SPEED_ROUNDING, checked_axes, checked_program, figures, refused, shown_word, unreadable, words_of,
};
pub use control::{control_of, decimals_of, dialect_of, ending_of, name_of, words_for};
pub use machine::{dialects, machine_of_job};
pub use result::{
    BodyClearance, CheckedAxis, CheckedFlank, CheckedMeasuring, CheckedProgram, CheckedStroke, PartProof,
    ProgramFault, ThreadProof,
};

use super::finding::RunFailure;
use foundation::numerics::Progress;
use nc::Dialect;
use std::io::BufRead;

/// The bodies of a job on a machine, on which any number of programs is followed.
pub trait ProgramCheck {
    /// Reads a program of a dialect and follows it; `netlist`: the HAL netlist of a LinuxCNC program whose gears are in one.
    ///
    /// # Errors
    /// [`RunFailure`]: a text that is no program, axes that the machine has not, no stroke on these bodies.
    fn check(
        &self,
        text: &mut dyn BufRead,
        netlist: Option<&str>,
        dialect: Dialect,
        progress: &dyn Progress,
    ) -> Result<CheckedProgram, RunFailure>;
}
