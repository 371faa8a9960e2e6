//! Texts that were read back before anybody has them: written, read by a reader that shares nothing with the writer, compared
//! (`docs/mathematics/programs.md#the-independent-reader`).

use super::compare::{CONVERSION, compare, compare_blocks};
use super::writer::{cl_options, resolved};
use super::{
    ClCutter, Dialect, NcError, Program, ReadProgram, WriteOptions, Written, read, read_cl, write, write_cl,
};

/// A text with what was read from it.
#[derive(Clone, Debug, PartialEq)]
pub struct Checked {
    /// The text, and what rounding did.
    pub written: Written,
    /// What the reader found in the text; [`ReadProgram::with_netlist`] adds the gears of a netlist.
    pub read: ReadProgram,
}

/// Writes the program, reads it with the reader that shares nothing with the writer, and compares: what comes out was read back.
///
/// # Errors
/// Those of [`write()`]; `NotReadBack` and `ReadBackMismatch` tell of a fault in this library.
pub fn write_checked(
    program: &Program,
    dialect: Dialect,
    options: &WriteOptions,
) -> Result<Checked, NcError> {
    let written = write(program, dialect, options)?;
    let read = read(written.text.as_bytes(), dialect, program.axes())
        .map_err(|error| NcError::NotReadBack(error.to_string().into()))?;
    compare(program, &read, &written, options)?;
    Ok(Checked { written, read })
}

/// Writes the cutter locations, reads them with the reader that shares nothing with the writer, and compares.
///
/// # Errors
/// Those of [`write_cl()`]; `NotReadBack` and `ReadBackMismatch` tell of a fault in this library.
pub fn write_cl_checked(program: &Program, cutter: Option<&ClCutter>) -> Result<String, NcError> {
    let text = write_cl(program, cutter)?;
    let found = read_cl(text.as_bytes()).map_err(|error| NcError::NotReadBack(error.to_string().into()))?;
    let wanted = Program::new(program.header().clone(), resolved(program)?)?;
    let options = cl_options();
    let lengths = |cutter: &ClCutter| [cutter.diameter, cutter.corner_radius, cutter.cutting_length];
    let half = 0.5 * 10f64.powi(-i32::from(options.decimals.mm));
    let same = match (cutter.map(lengths), found.cutter.as_ref().map(lengths)) {
        (None, None) => true,
        (Some(a), Some(b)) => a.iter().zip(b).all(|(a, b)| (a - b).abs() <= half + CONVERSION * a.abs()),
        _ => false,
    };
    if !same || found.name.as_ref() != Some(&program.header().name) {
        return Err(NcError::ReadBackMismatch { block: 0, axis: "name or cutter".into(), delta: f64::NAN });
    }
    let read = ReadProgram { name: found.name, chord_tolerance: None, blocks: found.blocks };
    compare_blocks(&wanted, &read, 0.0, None, &options)?;
    Ok(text)
}
