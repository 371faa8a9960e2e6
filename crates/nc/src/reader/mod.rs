//! The reader: a program of one of the dialects back into neutral blocks (`docs/mathematics/programs.md#what-rounding-adds`). It has
//! nothing of the writers but the neutral types, and reads line by line, so that a text without end is refused early. A word that no writer
//! emits is refused, except what a plain program of straight moves has besides: numbers of lines, lower case where the control
//! takes it, feed per minute, inches, steps. Knows no file.

mod cl;
mod detect;
mod error;
mod hal;
mod iso;
mod machine;
mod probing;
mod scan;
mod siemens;
mod tip;

pub use cl::ClProgram;
pub use detect::detect_dialect;
pub use error::{ReadError, ReadProblem};
pub(super) use hal::{HalGear, read_hal};

use super::{AxisWord, Block, Dialect, MAXIMUM_AXES};
use machine::Machine;
use scan::shown;
use std::io::{BufRead, Read as _};

/// Longest text that is read.
pub const MAXIMUM_BYTES: usize = 256 << 20;

/// What was read.
#[derive(Clone, Debug, PartialEq)]
pub struct ReadProgram {
    /// The name, if the text has one.
    pub name: Option<String>,
    /// Tolerance of the path, mm, if the text has one.
    pub chord_tolerance: Option<f64>,
    /// The blocks; the last is [`Block::End`].
    pub blocks: Vec<Block>,
}

/// What a grammar does with the lines of a text.
trait Grammar {
    /// Longest line before its end.
    const LINE: usize;
    /// What comes out.
    type Read;
    /// One line without its end.
    fn line(&mut self, bytes: &[u8], number: usize) -> Result<(), ReadError>;
    /// After the last line.
    fn finish(self, last: usize) -> Result<Self::Read, ReadError>;
}

/// Reads a program; `axes` says which word is which axis.
///
/// # Errors
/// The first thing that is no program of the dialect, with its place.
pub fn read(text: impl BufRead, dialect: Dialect, axes: &[AxisWord]) -> Result<ReadProgram, ReadError> {
    // Axes beyond those that a program can have have no place in its blocks.
    let machine = Machine::new(&axes[..axes.len().min(MAXIMUM_AXES)]);
    match dialect {
        Dialect::LinuxCnc | Dialect::Fanuc => read_lines(text, iso::Iso::new(dialect, machine)),
        Dialect::Siemens => read_lines(text, siemens::Siemens::new(machine)),
    }
}

/// Reads a LinuxCNC program whose gears are in a netlist beside it.
///
/// # Errors
/// As [`read`]; a gear that the netlist does not hold.
pub fn read_with_netlist(
    text: impl BufRead,
    netlist: &str,
    axes: &[AxisWord],
) -> Result<ReadProgram, ReadError> {
    read(text, Dialect::LinuxCnc, axes)?.with_netlist(netlist, axes)
}

/// Reads cutter locations in the words of APT, as [`crate::write_cl`] writes them.
///
/// # Errors
/// The first thing that is no such record, with its place.
pub fn read_cl(text: impl BufRead) -> Result<ClProgram, ReadError> {
    read_lines(text, cl::Cl::new())
}

fn read_lines<G: Grammar>(mut text: impl BufRead, mut grammar: G) -> Result<G::Read, ReadError> {
    let mut buffer = Vec::with_capacity(G::LINE + 2);
    let (mut number, mut total) = (0, 0);
    loop {
        buffer.clear();
        number += 1;
        let fault = |problem, word: &[u8], column, allowed| ReadError {
            line: number,
            column,
            problem,
            word: shown(word),
            allowed,
        };
        // One character more than allowed, CR and LF.
        let limit = G::LINE as u64 + 3;
        let taken = text.by_ref().take(limit).read_until(b'\n', &mut buffer).map_err(|error| {
            fault(ReadProblem::Unreadable, error.to_string().as_bytes(), 1, "a text that can be read")
        })?;
        if taken == 0 {
            return grammar.finish(number);
        }
        total += taken;
        if total > MAXIMUM_BYTES {
            return Err(fault(ReadProblem::TextTooLong, b"", 1, "256 MiB"));
        }
        let line = buffer.strip_suffix(b"\n").unwrap_or(&buffer);
        let line = line.strip_suffix(b"\r").unwrap_or(line);
        if line.len() > G::LINE {
            let start = &line[..20.min(line.len())];
            return Err(fault(
                ReadProblem::LineTooLong,
                start,
                G::LINE + 1,
                "252 (linuxcnc), 512 (siemens, CL), 256 (fanuc) characters",
            ));
        }
        if let Some(at) = line.iter().position(|byte| !(b' '..=b'~').contains(byte) && *byte != b'\t') {
            return Err(fault(ReadProblem::BadCharacter, &line[at..=at], at + 1, "printable ASCII"));
        }
        grammar.line(line, number)?;
    }
}

/// The name that a comment before everything else is, if it looks like one.
fn program_name(comment: &str) -> Option<String> {
    let name = comment.trim().replace(' ', "_");
    let fits = (1..=24).contains(&name.len())
        && name.bytes().all(|byte| byte.is_ascii_uppercase() || byte.is_ascii_digit() || byte == b'_');
    fits.then_some(name)
}
