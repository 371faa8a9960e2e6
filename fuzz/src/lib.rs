//! What every reader of files must hold, whatever bytes it is given: no panic, bounded results, no number that is not finite where none
//! is allowed, errors that say what to do, and the same content again when what was read is written and read. One function for each
//! target of `fuzz_targets/`; a property that does not hold is a panic.

mod complaints;
mod jobs;
mod klingelnberg;
mod machines;
mod modifications;
mod programs;
mod rexs;
mod tables;

pub use jobs::job;
pub use klingelnberg::klingelnberg;
pub use machines::{catalogue, history, machine};
pub use modifications::modification;
pub use programs::program;
pub use rexs::{rexs_json, rexs_packed, rexs_xml};
pub use tables::{measured_table, table};

/// Separates the files of an input that stands for several; the control character "record separator" stands in no text file.
const SEPARATOR: u8 = 0x1e;

/// The input up to the separator and what follows it.
fn two_files(data: &[u8]) -> (&[u8], Option<&[u8]>) {
    match data.iter().position(|byte| *byte == SEPARATOR) {
        Some(at) => (&data[..at], Some(&data[at + 1..])),
        None => (data, None),
    }
}
