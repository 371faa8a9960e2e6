//! The control that receives a course: words of the axes, options, the neutral program, and what of it can be read back.

use super::course::Course;
use super::failure::{of_motion, of_writer};
use super::replay::{Move, recorded};
use super::task::ToolMachining;
use job::machine::Control;
use motion::AxisWords;
use nc::{
    Block, Dialect, FanucOptions, Header, NcError, Program, ReadProgram, RoundingBound, WriteOptions, read,
    rounding_bound, split_turns,
};
use run::RunFailure;
use run::program_check::{control_of, decimals_of, name_of, words_for};

/// Tolerance of paths where the control gives none, mm.
const CHORD_TOLERANCE: f64 = 5e-5;

/// A control of the machine with its words and options.
pub(super) struct Target<'a> {
    pub dialect: Dialect,
    control: &'a Control,
    pub words: AxisWords,
    pub options: WriteOptions,
}

impl<'a> Target<'a> {
    pub fn new(
        machining: &ToolMachining<'a>,
        dialect: Dialect,
        course: &Course<'_>,
    ) -> Result<Self, RunFailure> {
        let name = name_of(dialect);
        let control = control_of(machining.machine, name)?;
        let axes = &course.stander.axes;
        let words = words_for(machining.machine, Some(control), axes).map_err(|error| of_motion(&error))?;
        course.moved(&words)?;
        let mut options = WriteOptions {
            decimals: decimals_of(control).unwrap_or_default(),
            incremental_rotary: control.modulo,
            ..WriteOptions::default()
        };
        options.fanuc = FanucOptions {
            program_number: control.program_number.unwrap_or(1),
            contour_mode: control.contour_mode,
        };
        Ok(Self { dialect, control, words, options })
    }

    pub fn refused(&self, error: &NcError) -> RunFailure {
        of_writer(error, self.dialect)
    }

    /// Half a unit of the last digit of angles, rad.
    pub fn half_angle(&self) -> f64 {
        0.5 * 10f64.powi(-i32::from(self.options.decimals.deg)).to_radians()
    }

    pub fn read(&self, text: &str) -> Result<ReadProgram, RunFailure> {
        read(text.as_bytes(), self.dialect, &self.words.words)
            .map_err(|error| self.refused(&NcError::NotReadBack(error.to_string().into())))
    }

    pub fn moves(
        &self,
        machining: &ToolMachining<'_>,
        blocks: &[Block],
    ) -> Result<Vec<Vec<Move>>, RunFailure> {
        recorded(blocks, &machining.machine.machine, &self.words, machining.output)
    }
}

/// The neutral program of a course.
pub(super) fn planned(
    course: &Course<'_>,
    target: &Target<'_>,
    machining: &ToolMachining<'_>,
    (name, heading): (&str, &str),
) -> Result<Program, RunFailure> {
    let mut blocks: Vec<Block> = Vec::new();
    if !heading.is_empty() {
        blocks.push(Block::Comment(heading.into()));
        let machine = plain(&machining.machine.file.name);
        blocks.push(Block::Comment(format!("MACHINE {machine}").trim_end().into()));
    }
    blocks.extend(course.blocks(&target.words, machining.output));
    let header = Header {
        name: program_name(name),
        axes: target.words.words.clone(),
        chord_tolerance: target.control.chord_tolerance_um.map_or(CHORD_TOLERANCE, |um| um * 1e-3),
    };
    let program = Program::new(header, blocks).map_err(|error| target.refused(&error))?;
    if !target.control.modulo {
        return Ok(program);
    }
    split_turns(&program).map_err(|error| target.refused(&error))
}

pub(super) fn bound(program: &Program, target: &Target<'_>, lever: f64) -> Result<RoundingBound, RunFailure> {
    rounding_bound(program, &target.options, lever, 0.0).map_err(|error| target.refused(&error))
}

/// Capitals, digits and single blanks, as every control takes them.
pub(super) fn plain(text: &str) -> String {
    let capital = |c: char| if c.is_ascii_alphanumeric() { c.to_ascii_uppercase() } else { ' ' };
    let letters: String = text.chars().map(capital).take(60).collect();
    letters.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// [A-Z0-9_]{1,24} of the job's name and T.
fn program_name(name: &str) -> String {
    let letter = |c: char| if c.is_ascii_alphanumeric() { c.to_ascii_uppercase() } else { '_' };
    let word: String = name.chars().map(letter).take(22).collect();
    format!("{word}_T")
}
