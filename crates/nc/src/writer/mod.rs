//! The writers: one file per control dialect over the lines that they share (`docs/mathematics/programs.md`). A writer gives the
//! same bytes for the same program and options. Knows no file, and nothing of the readers.

mod cl;
mod fanuc;
mod hal;
mod lines;
mod linuxcnc;
mod notes;
mod number;
mod options;
mod rounding;
mod siemens;
mod tip;
mod unconfirmed;

pub use cl::{ClCutter, write_cl};
pub(super) use cl::{cl_options, resolved};
pub use notes::{cl_with_notes, netlist_with_notes, with_notes};
pub use options::{
    Decimals, FanucOptions, FeedWords, HalOptions, LinuxCncOptions, Rounding, TipDecimals, Warning,
    WriteOptions, Written,
};
pub use rounding::{RoundingBound, rounding_bound};

use super::{Dialect, NcError, Program};

/// The program in a control's language. Who writes it to a file takes [`super::write_checked`] instead.
///
/// # Errors
/// `BadHeader` for options out of range, `AxisNotAvailable`, `BlockTooLong`, `UnsupportedCoupling`, `RatioRange`,
/// `BlockNotAvailable`, `TipControlNotAvailable`, `BadText`, and `NumberRange` where the control takes less than the neutral program.
pub fn write(program: &Program, dialect: Dialect, options: &WriteOptions) -> Result<Written, NcError> {
    match dialect {
        Dialect::LinuxCnc => linuxcnc::write(program, options),
        Dialect::Siemens => siemens::write(program, options),
        Dialect::Fanuc => fanuc::write(program, options),
    }
}
