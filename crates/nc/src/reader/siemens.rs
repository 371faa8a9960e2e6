//! Siemens 840D programs (`docs/mathematics/programs.md#the-independent-reader`): letters with numbers, addresses with an equals sign,
//! calls, polynomials, splines and tables. Here is what a line does; `words.rs` and `calls.rs` know how it is spelt, `curves.rs` what takes
//! several lines.

mod calls;
mod curves;
mod words;

use super::error::{ReadError, ReadProblem};
use super::machine::{AxisWords, Fault, Machine, Motion, Places};
use super::probing::matched;
use super::scan::{Decimal, Scan};
use super::tip::Three;
use super::{Grammar, ReadProgram, program_name};
use crate::{Block, Coolant, CurveTable, Gear, MAXIMUM_AXES, Targets, TipControl, Word};
use words::Name;

const CODES: &str = "G0 G1 G4 G17 G40 G54 to G57 G64 G70 G71 G90 G91 G93 G94 G500 G505 to G599 G700 G710, M0 M1 M2 M3 M4 M5 M6 M7 M8 M9 M30";

/// What one line says.
struct Line {
    axes: AxisWords,
    codes: [u32; 10],
    code_count: usize,
    groups: u32,
    /// Stop or end of the program.
    halt: Option<u32>,
    feed: Option<Decimal>,
    speeds: [Option<Decimal>; 8],
    directions: [Option<f64>; 8],
    poly: bool,
    spline: bool,
    /// Axis, a2 and a3.
    coefficients: Vec<(usize, f64, f64)>,
    interval: Option<Decimal>,
    degree: Option<Decimal>,
    tip: TipWords,
    coolant: Option<Coolant>,
    /// Number and state of the output that an action of the line switches.
    output: Option<(Option<u32>, bool)>,
}

/// What a line says of the tool and its tip.
#[derive(Clone, Copy, Default)]
struct TipWords {
    /// T, D and whether M6 changes the tool.
    tool: Option<Decimal>,
    offset: Option<Decimal>,
    change: bool,
    /// A word that switches tip control or says how directions come.
    switch: Option<TipSwitch>,
    /// X, Y, Z and A3, B3, C3.
    places: Three,
    direction: Three,
}

/// Words that stand alone in their lines.
#[derive(Clone, Copy, PartialEq, Eq)]
enum TipSwitch {
    On,
    Off,
    By(TipControl),
}

impl Line {
    fn new() -> Self {
        Self {
            axes: AxisWords::NONE,
            codes: [0; 10],
            code_count: 0,
            groups: 0,
            halt: None,
            feed: None,
            speeds: [None; 8],
            directions: [None; 8],
            poly: false,
            spline: false,
            coefficients: Vec::new(),
            interval: None,
            degree: None,
            tip: TipWords::default(),
            coolant: None,
            output: None,
        }
    }

    fn clear(&mut self) {
        let coefficients = std::mem::take(&mut self.coefficients);
        let axes = self.axes;
        *self = Self { coefficients, axes, ..Self::new() };
        self.coefficients.clear();
        self.axes.clear();
    }

    fn has(&self, code: u32) -> bool {
        self.codes[..self.code_count].contains(&code)
    }
}

/// The number behind D; 0 is no edge.
fn edge(word: Option<Decimal>) -> Result<Option<u32>, Fault> {
    let Some(word) = word else { return Ok(None) };
    let number = word.count().filter(|number| *number <= 999);
    let number = number.ok_or((ReadProblem::OutOfRange, "D0 to D999"))?;
    Ok(Some(number).filter(|number| *number > 0))
}

/// A spline whose lines are being read.
struct Spline {
    degree: usize,
    points: Vec<Targets>,
    intervals: Vec<f64>,
    duration: f64,
}

/// A table whose lines are being read.
struct OpenTable {
    table: CurveTable,
    started: bool,
    /// Where the axes stand: a table moves nothing.
    outside: Places,
}

/// A gear as the calls have described it so far.
struct Defined {
    leaders: Vec<usize>,
    gear: Option<Gear>,
    on: bool,
}

pub(super) struct Siemens<'a> {
    machine: Machine<'a>,
    letters: [Option<u8>; 26],
    addresses: Vec<(&'a [u8], usize)>,
    line: Line,
    spline: Option<Spline>,
    table: Option<OpenTable>,
    gears: [Option<Defined>; MAXIMUM_AXES],
    name: Option<String>,
    begun: bool,
}

impl<'a> Siemens<'a> {
    pub fn new(machine: Machine<'a>) -> Self {
        let mut letters = [None; 26];
        let mut addresses = Vec::new();
        for (axis, word) in machine.axes.iter().enumerate() {
            match &word.word {
                Word::Letter(letter @ 'A'..='Z') => {
                    letters[*letter as usize - 'A' as usize] = Some(axis as u8)
                }
                Word::Named(name) => addresses.push((name.as_bytes(), axis)),
                _ => {}
            }
        }
        Self {
            machine,
            letters,
            addresses,
            line: Line::new(),
            spline: None,
            table: None,
            gears: [const { None }; MAXIMUM_AXES],
            name: None,
            begun: false,
        }
    }

    fn letter_axis(&self, letter: u8) -> Option<usize> {
        self.letters.get(usize::from(letter.wrapping_sub(b'A'))).copied().flatten().map(usize::from)
    }

    /// The axis of an address, spindles among them.
    fn axis(&self, name: &Name) -> Option<usize> {
        if name.length == 1 {
            return self.letter_axis(name.bytes[0]);
        }
        if let Some((_, axis)) = self.addresses.iter().find(|(address, _)| *address == name.bytes()) {
            return Some(*axis);
        }
        let spindle = name.index(b'S')? - 1;
        self.machine.axes.iter().position(|axis| axis.word == Word::Spindle(spindle as u8))
    }

    fn comment(&mut self, bytes: &[u8]) {
        let text = String::from_utf8_lossy(bytes.trim_ascii()).into_owned();
        if !self.begun && self.name.is_none() && self.machine.blocks.is_empty() {
            self.name = program_name(&text);
            if self.name.is_some() {
                return;
            }
        }
        // What stands between name and first word is a note of the text, no block.
        let is_note = !self.begun && self.name.is_some() && self.machine.blocks.is_empty();
        if !text.is_empty() && !is_note && !self.machine.ended {
            self.machine.blocks.push(Block::Comment(text.into()));
        }
    }

    /// The tool, and the words that switch tip control.
    fn tool_words(&mut self) -> Result<(), Fault> {
        let tip = self.line.tip;
        if tip.change {
            let count = |word: Option<Decimal>| word.and_then(Decimal::count);
            let edge = edge(tip.offset)?;
            self.machine.tool(count(tip.tool), edge)?;
            if edge.is_some() {
                self.machine.length(edge)?;
            }
        } else if tip.tool.is_some() {
            return Err((ReadProblem::Missing, "M6 beside T"));
        } else if tip.offset.is_some() {
            if !self.line.axes.is_empty() || self.line.code_count > 0 {
                return Err((ReadProblem::Conflict, "D beside M6, or alone in its line"));
            }
            self.machine.length(edge(tip.offset)?)?;
        }
        match tip.switch {
            None => Ok(()),
            Some(TipSwitch::On) if self.gears.iter().flatten().any(|gear| gear.on) => {
                Err((ReadProblem::Conflict, "EGOFS before TRAORI"))
            }
            Some(TipSwitch::On) => {
                self.machine.length_for_tip()?;
                self.machine.tip_on(None)
            }
            Some(TipSwitch::Off) => {
                self.machine.tip_off();
                Ok(())
            }
            Some(TipSwitch::By(control)) => self.machine.tip_control(control),
        }
    }

    fn carry_out(&mut self) -> Result<(), Fault> {
        let line = &self.line;
        let feed = line.feed.map(Decimal::value);
        if feed.is_some_and(|feed| !(1e-4..=1e9).contains(&feed)) && !line.has(4) {
            return Err((ReadProblem::OutOfRange, "F from 0.0001 to 1e9"));
        }
        if !line.spline {
            self.end_spline();
        }
        if let Some((number, on)) = self.line.output {
            return self.machine.output(number, on);
        }
        let line = &self.line;
        for code in [93, 94] {
            if line.has(code) {
                self.machine.inverse_time = code == 93;
                self.machine.feed = None;
            }
        }
        self.tool_words()?;
        if let Some(coolant) = self.line.coolant {
            self.machine.blocks.push(Block::Coolant(coolant));
        }
        let line = &self.line;
        for spindle in 0..8 {
            let (speed, direction) = (line.speeds[spindle].map(Decimal::value), line.directions[spindle]);
            if speed.is_some() || direction.is_some() {
                self.machine.spindle(spindle, speed, direction)?;
            }
        }
        for &code in &line.codes[..line.code_count] {
            match code {
                0 => self.machine.motion = Motion::Rapid,
                1 => self.machine.motion = Motion::Linear,
                70 | 700 => self.machine.inch = true,
                71 | 710 => self.machine.inch = false,
                90 => self.machine.incremental = false,
                91 => self.machine.incremental = true,
                54..=57 => self.machine.origin(code as u16 - 53)?,
                500..=599 => self.machine.origin(code as u16 - 500)?,
                _ => {}
            }
        }
        let parameter = line.interval.map_or(1.0, Decimal::value);
        if line.has(4) {
            if !line.axes.is_empty() || line.poly || line.spline {
                return Err((ReadProblem::Conflict, "G4 with F alone"));
            }
            self.machine.dwell(feed.ok_or((ReadProblem::Missing, "G4 with F in seconds"))?)?;
        } else if line.poly && line.spline || (line.poly || line.spline) && line.groups & 1 != 0 {
            return Err((ReadProblem::Conflict, "one of G0, G1, POLY, BSPLINE"));
        } else if !line.poly && (!line.coefficients.is_empty() || !line.spline && line.interval.is_some()) {
            return Err((ReadProblem::Conflict, "PO[] and PL= beside POLY"));
        } else if !line.spline && line.degree.is_some() {
            return Err((ReadProblem::Conflict, "SD= beside BSPLINE"));
        } else if (line.poly || line.spline) && (line.axes.is_empty() || !self.machine.inverse_time) {
            return Err((ReadProblem::Missing, "axis words and G93 for POLY and BSPLINE"));
        } else if line.poly && (self.machine.incremental || self.machine.inch) {
            return Err((ReadProblem::Conflict, "POLY under G90 and G710"));
        } else if line.poly && !(1e-4..=1e5).contains(&parameter) {
            return Err((ReadProblem::OutOfRange, "PL from 0.0001 to 99999.9999"));
        } else if self.machine.tip.is_some() {
            if self.table.is_some() || line.poly || line.spline {
                return Err((ReadProblem::Conflict, "straight blocks under TRAORI"));
            }
            let (tip, angles) = (self.line.tip, self.line.axes);
            self.machine.tip_line(&tip.places, &tip.direction, &angles, feed)?;
        } else {
            // Coefficients of p in 0..PL as those of u in 0..1.
            for (_, a2, a3) in &mut self.line.coefficients {
                *a2 *= parameter * parameter;
                *a3 *= parameter * parameter * parameter;
            }
            if self.table.is_some() {
                if !self.line.axes.is_empty() {
                    self.table_line()?;
                }
            } else if self.line.poly {
                let words = self.line.axes;
                self.machine.cubic(&words, &self.line.coefficients, feed)?;
                self.machine.motion = Motion::None;
            } else if self.line.spline {
                self.spline_line()?;
            } else if !self.line.axes.is_empty() {
                let words = self.line.axes;
                self.machine.straight(&words, feed)?;
            } else if let (Some(feed), false) = (feed, self.machine.inverse_time) {
                self.machine.feed = Some(feed);
            }
        }
        match self.line.halt {
            Some(_) if self.table.is_some() => return Err((ReadProblem::Conflict, "CTABEND before the end")),
            Some(0 | 1) => self.machine.blocks.push(Block::Stop),
            Some(_) => {
                self.machine.blocks.push(Block::End);
                self.machine.ended = true;
            }
            None => {}
        }
        Ok(())
    }
}

impl Siemens<'_> {
    /// A line of a probing cycle; false if it is none.
    fn probing_line(&mut self, bytes: &[u8]) -> Result<bool, Fault> {
        if let Some(found) = matched(bytes, "G94MEAS=1G1@%F%", &self.machine) {
            self.machine.motion = Motion::None;
            return self.machine.probing(&found).map(|()| true);
        }
        // The control waits, and an alarm ends a cycle that has touched nothing.
        let waits = ["STOPRE", "IF$AC_MEA[1]==0", "SETAL(65000)", "ENDIF"];
        if waits.iter().any(|pattern| matched(bytes, pattern, &self.machine).is_some()) {
            let open = self.machine.probing.is_some();
            return if open { Ok(true) } else { Err((ReadProblem::Missing, "a probing motion before")) };
        }
        if let Some(found) = matched(bytes, "R%=$AA_MW[@]", &self.machine) {
            let ([slot], [axis]) = (&found.numbers[..], &found.axes[..]) else { return Ok(false) };
            return self.machine.probed(*axis, *slot).map(|()| true);
        }
        if let Some(found) = matched(bytes, "$P_UIFR[%,@,TR]=$P_UIFR[%,@,TR]+(R%+R%)/2-(%)", &self.machine) {
            let ([number, again, a, b, middle], [axis, same]) = (&found.numbers[..], &found.axes[..]) else {
                return Ok(false);
            };
            if number != again || axis != same {
                return Err((ReadProblem::Conflict, "the same axis of the same work offset on both sides"));
            }
            if number.fract() != 0.0 || !(1.0..=99.0).contains(number) {
                return Err((ReadProblem::OutOfRange, "work offsets 1 to 99"));
            }
            return self.machine.offset_by_probe(*number, *axis, [*a, *b], *middle).map(|()| true);
        }
        Ok(false)
    }
}

impl Grammar for Siemens<'_> {
    const LINE: usize = 512;
    type Read = ReadProgram;

    fn line(&mut self, bytes: &[u8], number: usize) -> Result<(), ReadError> {
        let mut scan = Scan::new(bytes, number);
        let cycle = if self.machine.ended { Ok(false) } else { self.probing_line(bytes) };
        if self.machine.taken_by_probing(cycle, bytes, &mut scan)? {
            self.begun = true;
            return Ok(());
        }
        let any = self.words(&mut scan)?;
        if !any {
            return Ok(());
        }
        if self.machine.ended {
            return Err(scan.fault(ReadProblem::End, 0, "comments after the end"));
        }
        self.begun = true;
        self.carry_out().map_err(|(problem, allowed)| {
            scan.at = bytes.len();
            scan.fault(problem, 0, allowed)
        })
    }

    fn finish(self, last: usize) -> Result<ReadProgram, ReadError> {
        if !self.machine.ended {
            let allowed = "a program that ends with M30 or M2";
            return Err(ReadError {
                line: last,
                column: 1,
                problem: ReadProblem::End,
                word: "".into(),
                allowed,
            });
        }
        Ok(ReadProgram { name: self.name, chord_tolerance: None, blocks: self.machine.blocks })
    }
}
