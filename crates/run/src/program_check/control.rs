//! The control that a program is for: its description in the machine, what it calls the axes, how it writes numbers.

use crate::finding::RunFailure;
use job::machine::{Control, LoadedMachine};
use job::tables::Program as DialectName;
use job::{Diagnostic, Problem};
use motion::{AxisWords, MotionError, axis_words};
use nc::{Decimals, Dialect};

/// A dialect by its key in files.
pub fn dialect_of(name: DialectName) -> Dialect {
    match name {
        DialectName::Linuxcnc => Dialect::LinuxCnc,
        DialectName::Siemens => Dialect::Siemens,
        DialectName::Fanuc => Dialect::Fanuc,
    }
}

/// The key of a dialect in files.
pub fn name_of(dialect: Dialect) -> DialectName {
    match dialect {
        Dialect::LinuxCnc => DialectName::Linuxcnc,
        Dialect::Siemens => DialectName::Siemens,
        Dialect::Fanuc => DialectName::Fanuc,
    }
}

/// How files of a dialect end.
pub fn ending_of(dialect: Dialect) -> &'static str {
    match dialect {
        Dialect::LinuxCnc => "ngc",
        Dialect::Siemens => "mpf",
        Dialect::Fanuc => "nc",
    }
}

/// The control of a dialect on a machine.
///
/// # Errors
/// A finding on `output.programs` if the machine has none.
pub fn control_of(machine: &LoadedMachine, name: DialectName) -> Result<&Control, RunFailure> {
    let file = &machine.file;
    file.controls.of(name).ok_or_else(|| {
        let dialect = dialect_of(name).name();
        let known: Vec<&str> = file.controls.present().map(|(key, _)| key).collect();
        let text = format!("the machine {} has no control {dialect:?}", file.name);
        let finding = Diagnostic::new(Problem::InvalidMachine, text)
            .field("output.programs")
            .value(format!("{dialect:?}"))
            .allowed(if known.is_empty() { "none".to_owned() } else { known.join(", ") })
            .way_out(format!("describe [controls.{dialect}] in {}, or leave it out", file.name));
        RunFailure::bad_input(finding)
    })
}

/// What a control calls these axes of a machine; without a control, or where it has no word of its own, by their letters.
///
/// # Errors
/// [`MotionError::InvalidWord`].
pub fn words_for(
    machine: &LoadedMachine,
    control: Option<&Control>,
    axes: &[usize],
) -> Result<AxisWords, MotionError> {
    axis_words(&machine.machine, axes, |name: &str| {
        let own = control.and_then(|control| control.words.get(name)).map(String::as_str);
        own.or_else(|| machine.file.axes.get(name).and_then(|axis| axis.letter.as_deref()))
    })
}

/// The digits that a control wants.
pub fn decimals_of(control: &Control) -> Option<Decimals> {
    control.decimals.map(|given| Decimals { mm: given.mm, deg: given.deg, feed: given.feed })
}
