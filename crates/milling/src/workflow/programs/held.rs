//! What a control adds to the positions of a text: a work offset, and the length of the tool where it holds that.

use super::task::MillingMachining;
use crate::workflow::prepare::ToolData;
use job::Diagnostic;
use machine::{Positions, Station};
use motion::AxisWords;
use motion::milling::MillingSetup;
use nc::{Dialect, Targets, Word};
use run::RunFailure;

/// A work offset as the control holds it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HeldOffset {
    /// Its number: 1 is G54.
    pub number: u16,
    /// Its values of X, Y and Z, mm.
    pub position: [f64; 3],
}

/// What positions of a text are short of those of the machine.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Held {
    /// The work offset.
    pub offset: Option<HeldOffset>,
    /// Axis of the program that the length of a tool is added to, where the control holds lengths.
    pub lengthened: Option<usize>,
}

/// Positions of the rotary axes (rad) at which it is looked which way the tool points.
const LOOKED_AT: [[f64; 2]; 3] = [[0.0, 0.0], [0.7, -0.4], [-0.3, 1.1]];
/// How far the tip may be beside where an axis takes the nose, mm for each mm of the tool.
const ALONG: f64 = 1e-9;

impl Held {
    /// On a machine with its words.
    ///
    /// # Errors
    /// [`RunFailure`] for a control that is to hold lengths on a machine that tilts its tools, and an offset of axes without the letters
    /// that it names.
    pub fn of(
        machining: &MillingMachining<'_>,
        setup: &MillingSetup<'_>,
        words: &AxisWords,
    ) -> Result<Self, RunFailure> {
        let lengthened = machining.holds_lengths.then(|| along_the_tool(setup, words)).transpose()?;
        let held = Self { offset: machining.work_offset, lengthened };
        if held.offset.is_some() {
            let known: Vec<usize> = words.words.iter().filter_map(|word| component(&word.word)).collect();
            if (0..3).any(|part| known.iter().filter(|at| **at == part).count() != 1) {
                let text = "a work offset is for axes X, Y and Z, and the linear axes of the machine have other words";
                let finding = Diagnostic::with_code("axis-not-available", text).field("machine.work_offset");
                let way_out = "leave `work_offset` out, or give the linear axes the letters X, Y and Z in the machine description";
                return Err(RunFailure::bad_input(finding.way_out(way_out)));
            }
        }
        Ok(held)
    }

    /// Positions of the machine's axes with a tool of this length (mm) as the text has them.
    pub fn written(&self, words: &AxisWords, targets: &Targets, length: f64) -> Targets {
        self.shifted(words, targets, -1.0, length)
    }

    /// Positions of a text as those of the machine's axes.
    pub fn meant(&self, words: &AxisWords, targets: &Targets, length: f64) -> Targets {
        self.shifted(words, targets, 1.0, length)
    }

    fn shifted(&self, words: &AxisWords, targets: &Targets, sense: f64, length: f64) -> Targets {
        let of = |place: usize| {
            let origin = self.offset.zip(words.words.get(place).and_then(|word| component(&word.word)));
            let origin = origin.map_or(0.0, |(offset, part)| offset.position[part]);
            origin + if self.lengthened == Some(place) { length } else { 0.0 }
        };
        targets.iter().fold(Targets::NONE, |all, (place, value)| all.with(place, value + sense * of(place)))
    }
}

/// The number that a control holds the length of a tool under.
pub(super) fn length_number(tool: &ToolData, dialect: Dialect) -> u32 {
    let usual = if dialect == Dialect::Siemens { 1 } else { tool.number.min(MOST_LENGTHS) };
    tool.length_offset.unwrap_or(usual)
}

/// The numbers behind H and D.
pub fn length_numbers(tool: &ToolData) -> [u32; 2] {
    [Dialect::Fanuc, Dialect::Siemens].map(|dialect| length_number(tool, dialect))
}

/// Lengths that controls have numbers for.
const MOST_LENGTHS: u32 = 999;

/// Which of X, Y and Z a word is.
fn component(word: &Word) -> Option<usize> {
    let letter = match word {
        Word::Letter(letter) => *letter,
        Word::Named(name) => name.chars().next()?,
        Word::Spindle(_) => return None,
    };
    "XYZ".find(letter)
}

/// The axis of the program along which every tool points away from the workpiece in the sense in which the control counts.
fn along_the_tool(setup: &MillingSetup<'_>, words: &AxisWords) -> Result<usize, RunFailure> {
    let machine = setup.machine();
    let axes = setup.axes();
    let stands = |at: &Positions, reach: f64| {
        let tip = foundation::kinematics::Point::new(0.0, 0.0, -reach);
        machine.tool_stands(Station::Work, at, &tip).map(|(tip, _)| tip.xyz)
    };
    let same = |axis: usize| {
        LOOKED_AT.into_iter().all(|angles| {
            let mut at = Positions::default();
            for (rotary, angle) in axes.rotary.into_iter().zip(angles) {
                at[rotary] = angle;
            }
            let mut drawn_in = at;
            drawn_in[axis] -= machine.axes()[axis].nc_sign;
            match (stands(&at, 1.0), stands(&drawn_in, 0.0)) {
                (Ok(tip), Ok(nose)) => (tip - nose).norm() <= ALONG,
                _ => false,
            }
        })
    };
    let found = axes.linear.into_iter().find(|axis| same(*axis)).and_then(|axis| words.place(axis));
    found.ok_or_else(|| {
        let text = "no linear axis stays along the tool, so that a control that adds its length to positions cuts elsewhere";
        let finding = Diagnostic::with_code("length-not-addable", text)
            .field("machine.tool_length_in")
            .value("\"control\"")
            .allowed("\"program\", or a machine whose rotary axes both turn the workpiece");
        RunFailure::bad_input(finding.way_out("take \"program\", or rtcp = \"on\", with which the control holds the length anyway"))
    })
}
