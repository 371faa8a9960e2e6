//! Siemens 840D programs (spec 80 section 5): letters with numbers, addresses with an equals sign, calls, polynomials, splines
//! and tables. Everything about their order of words is here.

use super::error::{ReadError, ReadProblem};
use super::machine::{AxisWords, Fault, Machine, Meaning, Motion, Places, inverse_time, span};
use super::scan::{Decimal, Scan};
use super::{Grammar, ReadProgram, program_name};
use crate::nc::{
    AxisMotion, BSplineMotion, Block, Coupling, CurveTable, Gear, GearLeader, GearSynchronisation,
    MAXIMUM_AXES, Repetition, TablePiece, Targets, Word,
};

const CODES: &str = "G0 G1 G4 G17 G40 G64 G70 G71 G90 G91 G93 G94 G500 G700 G710, M0 M1 M2 M3 M4 M5 M30";
const WORDS: &str =
    "G M N F S, axes of the axis map, X1=.. IC() AC(), S1= M1=, POLY PO[] PL=, BSPLINE SD=, comments ;";
const CALLS: &str = "EGDEL EGDEF EGON EGONSYN EGOFS CTABDEF, alone in their line";
/// Longest word of letters and digits.
const NAME: usize = 16;

/// Codes of G and the group that allows one of them in a line.
fn group(code: u32) -> Option<u32> {
    Some(match code {
        0 | 1 => 0,
        4 => 1,
        17 => 2,
        70 | 71 | 700 | 710 => 3,
        40 => 4,
        64 => 5,
        500 => 6,
        90 | 91 => 7,
        93 | 94 => 8,
        _ => return None,
    })
}

/// A word of letters and digits in capitals.
#[derive(Clone, Copy)]
struct Name {
    bytes: [u8; NAME],
    length: usize,
    /// How many letters it begins with.
    letters: usize,
}

impl Name {
    fn bytes(&self) -> &[u8] {
        &self.bytes[..self.length]
    }

    /// The number after one letter `letter`, e.g. 2 of `M2`.
    fn index(&self, letter: u8) -> Option<usize> {
        match self.bytes() {
            [first, digit @ b'1'..=b'8'] if *first == letter => Some(usize::from(digit - b'0')),
            _ => None,
        }
    }
}

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

/// A gear as the calls have told it so far.
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

    /// Letters and then digits; the digits stay unread if a single letter stands before them and no sign of an address follows.
    fn name(scan: &mut Scan<'_>) -> Result<Name, ReadError> {
        scan.skip_blanks();
        let start = scan.at;
        let mut name = Name { bytes: [0; NAME], length: 0, letters: 0 };
        let mut digits_from = start;
        while let Some(byte) = scan.peek() {
            let in_digits = name.letters < name.length;
            match byte {
                b'0'..=b'9' if name.length > 0 => {
                    if !in_digits {
                        digits_from = scan.at;
                        name.letters = name.length;
                    }
                }
                _ if byte.is_ascii_alphabetic() && digits_from == start => name.letters += 1,
                _ => break,
            }
            if name.length == NAME {
                // Numbers may be longer than names.
                if digits_from > start {
                    break;
                }
                return Err(scan.fault(ReadProblem::UnknownWord, start, WORDS));
            }
            name.bytes[name.length] = byte.to_ascii_uppercase();
            name.length += 1;
            scan.at += 1;
        }
        if name.length == 0 {
            return Err(scan.fault(ReadProblem::UnknownWord, start, WORDS));
        }
        if name.letters == 1 && !matches!(scan.peek(), Some(b'=' | b'(' | b']' | b')' | b',')) {
            scan.at = start + 1;
            name.length = 1;
        }
        Ok(name)
    }

    fn comment(&mut self, bytes: &[u8]) {
        let text = String::from_utf8_lossy(bytes.trim_ascii()).into_owned();
        if !self.begun && self.name.is_none() && self.machine.blocks.is_empty() {
            self.name = program_name(&text);
            if self.name.is_some() {
                return;
            }
        }
        if !text.is_empty() && !self.machine.ended {
            self.machine.blocks.push(Block::Comment(text.into()));
        }
    }

    /// The words of a line into `self.line`; true if there was any. A call is carried out at once.
    fn words(&mut self, scan: &mut Scan<'_>) -> Result<bool, ReadError> {
        self.line.clear();
        let mut any = false;
        loop {
            scan.skip_blanks();
            let start = scan.at;
            match scan.peek() {
                None => return Ok(any),
                Some(b';') => {
                    let bytes = &scan.bytes[start + 1..];
                    scan.at = scan.bytes.len();
                    // What the line does comes first in a line of both; the comment belongs to it.
                    self.comment(bytes);
                    return Ok(any);
                }
                _ => {}
            }
            let name = Self::name(scan)?;
            let conflict =
                |scan: &Scan<'_>| Err(scan.fault(ReadProblem::Conflict, start, "each word once in a line"));
            if scan.peek() == Some(b'(') && name.length > 1 {
                if any {
                    return Err(scan.fault(ReadProblem::Conflict, start, CALLS));
                }
                self.call(scan, &name, start)?;
                scan.skip_blanks();
                if !matches!(scan.peek(), None | Some(b';')) {
                    return Err(scan.fault(ReadProblem::Conflict, scan.at, CALLS));
                }
                continue;
            }
            if name.bytes() == b"N" {
                scan.number()?;
                continue;
            }
            any = true;
            match name.bytes() {
                b"POLY" if !self.line.poly => self.line.poly = true,
                b"BSPLINE" if !self.line.spline => self.line.spline = true,
                b"POLY" | b"BSPLINE" => return conflict(scan),
                b"CTABEND" => {
                    if self.line.code_count > 0 || !self.line.axes.is_empty() {
                        return Err(scan.fault(ReadProblem::Conflict, start, "CTABEND alone in its line"));
                    }
                    let open = self
                        .table
                        .take()
                        .ok_or_else(|| scan.fault(ReadProblem::Conflict, start, "CTABEND after CTABDEF"))?;
                    self.machine.motion = Motion::None;
                    self.machine.places = open.outside;
                    self.machine.blocks.push(Block::Table(Box::new(open.table)));
                    any = false;
                    scan.skip_blanks();
                    if !matches!(scan.peek(), None | Some(b';')) {
                        return Err(scan.fault(ReadProblem::Conflict, start, "CTABEND alone in its line"));
                    }
                }
                b"PO" => self.polynomial(scan, start)?,
                b"PL" | b"SD" => {
                    if !scan.take(b'=') {
                        return Err(scan.fault(ReadProblem::Missing, start, "an equals sign and a number"));
                    }
                    let number = scan.number()?;
                    let place =
                        if name.bytes()[0] == b'P' { &mut self.line.interval } else { &mut self.line.degree };
                    if place.replace(number).is_some() {
                        return conflict(scan);
                    }
                }
                b"G" => {
                    let code = scan.number()?.count();
                    let Some((code, group)) = code.and_then(|code| Some((code, group(code)?))) else {
                        return Err(scan.fault(ReadProblem::UnknownWord, start, CODES));
                    };
                    if self.line.groups & 1 << group != 0 {
                        return Err(scan.fault(
                            ReadProblem::Conflict,
                            start,
                            "one code of each group in a line",
                        ));
                    }
                    self.line.groups |= 1 << group;
                    // There are fewer groups than places.
                    self.line.codes[self.line.code_count] = code;
                    self.line.code_count += 1;
                }
                b"M" => {
                    let code = scan.number()?.count();
                    self.switch(code, 0).map_err(|(problem, allowed)| scan.fault(problem, start, allowed))?;
                }
                b"F" => {
                    scan.take(b'=');
                    let number = scan.number()?;
                    if self.line.feed.replace(number).is_some() {
                        return conflict(scan);
                    }
                }
                b"S" => {
                    scan.take(b'=');
                    let number = scan.number()?;
                    if self.line.speeds[0].replace(number).is_some() {
                        return conflict(scan);
                    }
                }
                _ => {
                    let equals = scan.take(b'=');
                    if let (Some(spindle), true) = (name.index(b'S'), equals) {
                        let number = scan.number()?;
                        if self.line.speeds[spindle - 1].replace(number).is_some() {
                            return conflict(scan);
                        }
                        continue;
                    }
                    if let (Some(spindle), true) = (name.index(b'M'), equals) {
                        let code = scan.number()?.count().filter(|code| matches!(code, 3..=5));
                        self.switch(code, spindle - 1)
                            .map_err(|(problem, allowed)| scan.fault(problem, start, allowed))?;
                        continue;
                    }
                    let axis = self.axis(&name).filter(|axis| {
                        !matches!(self.machine.axes[*axis].word, Word::Spindle(_))
                            && (equals || name.length == 1)
                    });
                    let Some(axis) = axis else {
                        return Err(scan.fault(ReadProblem::UnknownWord, start, WORDS));
                    };
                    let (value, meaning) = Self::axis_value(scan)?;
                    if !self.line.axes.add(axis, value, meaning) {
                        return conflict(scan);
                    }
                }
            }
        }
    }

    /// A number, `IC(number)` or `AC(number)`.
    fn axis_value(scan: &mut Scan<'_>) -> Result<(Decimal, Meaning), ReadError> {
        scan.skip_blanks();
        let start = scan.at;
        let meaning = match scan.peek().map(|byte| byte.to_ascii_uppercase()) {
            Some(b'I') => Meaning::Step,
            Some(b'A') => Meaning::Place,
            _ => return Ok((scan.number()?, Meaning::ByMode)),
        };
        let second = scan.bytes.get(start + 1).map(u8::to_ascii_uppercase);
        scan.at = (start + 2).min(scan.bytes.len());
        if second != Some(b'C') || !scan.take(b'(') {
            return Err(scan.fault(ReadProblem::BadNumber, start, "a number, IC(number) or AC(number)"));
        }
        let value = scan.number()?;
        if !scan.take(b')') {
            return Err(scan.fault(ReadProblem::Missing, start, "a bracket that closes"));
        }
        Ok((value, meaning))
    }

    fn switch(&mut self, code: Option<u32>, spindle: usize) -> Result<(), Fault> {
        let direction = match code {
            Some(3) => 1.0,
            Some(4) => -1.0,
            Some(5) => 0.0,
            Some(code @ (0 | 1 | 2 | 30)) => {
                return match self.line.halt.replace(code) {
                    None => Ok(()),
                    Some(_) => Err((ReadProblem::Conflict, "one of M0, M1, M2, M30")),
                };
            }
            _ => return Err((ReadProblem::UnknownWord, CODES)),
        };
        match self.line.directions[spindle].replace(direction) {
            None => Ok(()),
            Some(_) => Err((ReadProblem::Conflict, "one of M3, M4, M5 for each spindle")),
        }
    }

    /// `PO[X]=(xe,a2,a3)`; what is left out is 0.
    fn polynomial(&mut self, scan: &mut Scan<'_>, start: usize) -> Result<(), ReadError> {
        let grammar = "PO[axis]=(end,a2,a3)";
        if !scan.take(b'[') {
            return Err(scan.fault(ReadProblem::Missing, start, grammar));
        }
        let name = Self::name(scan)?;
        let axis = self.axis(&name).filter(|axis| !matches!(self.machine.axes[*axis].word, Word::Spindle(_)));
        let Some(axis) = axis else { return Err(scan.fault(ReadProblem::UnknownWord, start, grammar)) };
        if !scan.take(b']') || !scan.take(b'=') || !scan.take(b'(') {
            return Err(scan.fault(ReadProblem::Missing, start, grammar));
        }
        let end = scan.number()?;
        let mut coefficients = [0.0; 2];
        let mut count = 0;
        while scan.take(b',') {
            let Some(place) = coefficients.get_mut(count) else {
                let allowed = "degree 3: two coefficients after the end value";
                return Err(scan.fault(ReadProblem::DegreeNotSupported, start, allowed));
            };
            *place = scan.number()?.value();
            count += 1;
        }
        if !scan.take(b')') {
            return Err(scan.fault(ReadProblem::Missing, start, grammar));
        }
        if !self.line.axes.add(axis, end, Meaning::ByMode) {
            return Err(scan.fault(ReadProblem::Conflict, start, "each axis once in a line"));
        }
        self.line.coefficients.push((axis, coefficients[0], coefficients[1]));
        Ok(())
    }

    /// `NAME(argument, ...)`.
    fn call(&mut self, scan: &mut Scan<'_>, name: &Name, start: usize) -> Result<(), ReadError> {
        self.begun = true;
        self.end_spline();
        scan.at += 1;
        let mut call = Call { scan, start, first: true };
        match name.bytes() {
            _ if self.machine.ended => {
                return Err(call.fault(ReadProblem::End, "comments after the end"));
            }
            _ if self.table.is_some() => {
                return Err(call.fault(ReadProblem::Conflict, "motions and CTABEND after CTABDEF"));
            }
            b"EGDEL" => {
                let follower = call.axis(self)?;
                if self.gears[follower].as_ref().is_some_and(|gear| gear.on) {
                    return Err(call.fault(ReadProblem::Conflict, "EGOFS before EGDEL"));
                }
                self.gears[follower] = None;
            }
            b"EGDEF" => {
                let follower = call.axis(self)?;
                if self.gears[follower].is_some() {
                    return Err(call.fault(ReadProblem::Conflict, "EGDEL before EGDEF"));
                }
                let mut leaders = Vec::new();
                while call.more() {
                    let leader = call.axis(self)?;
                    let kind = call.number()?.count();
                    let fits = matches!(kind, Some(0 | 1)) && leaders.len() < 5 && !leaders.contains(&leader);
                    if !fits || leader == follower {
                        let allowed = "one to five leading axes, each once, each with a type 0 or 1";
                        return Err(call.fault(ReadProblem::OutOfRange, allowed));
                    }
                    leaders.push(leader);
                }
                if leaders.is_empty() {
                    return Err(call.fault(ReadProblem::Missing, "one to five leading axes"));
                }
                self.gears[follower] = Some(Defined { leaders, gear: None, on: false });
            }
            b"EGON" | b"EGONSYN" => self.switch_on(&mut call, name.length > 4)?,
            b"EGOFS" => {
                let follower = call.axis(self)?;
                match &mut self.gears[follower] {
                    Some(gear) if gear.on => gear.on = false,
                    _ => return Err(call.fault(ReadProblem::Conflict, "EGON before EGOFS")),
                }
                self.machine.blocks.push(Block::GearOff { follower });
            }
            b"CTABDEF" => {
                let (follower, leader) = (call.axis(self)?, call.axis(self)?);
                let id = call.number()?.count().filter(|id| *id > 0);
                let id = id.ok_or_else(|| call.fault(ReadProblem::OutOfRange, "numbers of tables from 1"))?;
                let repetition = match call.number()?.count() {
                    Some(0) => Repetition::Held,
                    Some(1) => Repetition::Leader,
                    Some(2) => Repetition::Both,
                    _ => return Err(call.fault(ReadProblem::OutOfRange, "0, 1 or 2 for the repetition")),
                };
                let start = [0.0; 2];
                let table = CurveTable { id, follower, leader, start, pieces: Vec::new(), repetition };
                self.table = Some(OpenTable { table, started: false, outside: self.machine.places });
            }
            _ => return Err(call.fault(ReadProblem::UnknownWord, CALLS)),
        }
        call.close()
    }

    fn switch_on(&mut self, call: &mut Call<'_, '_>, synchronous: bool) -> Result<(), ReadError> {
        let follower = call.axis(self)?;
        let mode = call.text()?;
        if !["NOC", "FINE", "COARSE", "IPOSTOP"].contains(&mode) {
            return Err(call.fault(ReadProblem::UnknownWord, "\"NOC\", \"FINE\", \"COARSE\" or \"IPOSTOP\""));
        }
        let place =
            |axis: usize, number: Decimal, machine: &Machine<'_>| machine.neutral(axis, number.value());
        let mut at = GearSynchronisation { follower: 0.0, leaders: Vec::new() };
        if synchronous {
            at.follower = place(follower, call.number()?, &self.machine);
        }
        let Some(expected) =
            self.gears[follower].as_ref().filter(|gear| !gear.on).map(|gear| gear.leaders.clone())
        else {
            return Err(call.fault(ReadProblem::Conflict, "EGDEF before EGON, EGOFS between two of them"));
        };
        let turns = |axis: usize| self.machine.axes[axis].motion == AxisMotion::Rotary;
        let mut leaders = Vec::new();
        while call.more() {
            let axis = call.axis(self)?;
            if expected.get(leaders.len()) != Some(&axis) {
                return Err(call.fault(ReadProblem::Conflict, "the leading axes of EGDEF in their order"));
            }
            if synchronous {
                at.leaders.push(place(axis, call.number()?, &self.machine));
            }
            let (num, den) = (call.number()?, call.number()?);
            let coupling = if den.mantissa == 0 {
                let table = num.count().filter(|table| *table > 0);
                Coupling::Table(table.ok_or_else(|| {
                    call.fault(ReadProblem::OutOfRange, "the number of a table before a denominator of 0")
                })?)
            } else {
                let (num, den) = (num.value(), den.value());
                match (turns(follower), turns(axis)) {
                    (true, false) => Coupling::Ratio { num: num.to_radians(), den },
                    (false, true) => Coupling::Ratio { num, den: den.to_radians() },
                    _ => Coupling::Ratio { num, den },
                }
            };
            leaders.push(GearLeader { axis, coupling });
        }
        if leaders.len() != expected.len() {
            return Err(call.fault(ReadProblem::Missing, "all leading axes of EGDEF"));
        }
        let gear = Gear { follower, leaders, teeth: None };
        if let Some(defined) = &mut self.gears[follower] {
            defined.on = true;
            if defined.gear.as_ref() != Some(&gear) {
                self.machine.blocks.push(Block::GearDefine(Box::new(gear.clone())));
                defined.gear = Some(gear);
            }
        }
        let synchronisation = synchronous.then(|| Box::new(at));
        self.machine.blocks.push(Block::GearOn { follower, synchronisation });
        Ok(())
    }

    /// Closes the spline whose lines have been read.
    fn end_spline(&mut self) {
        let Some(spline) = self.spline.take() else { return };
        let degree = spline.degree;
        let mut knots = vec![0.0; degree + 1];
        let mut knot = 0.0;
        for interval in &spline.intervals {
            knot += interval;
            knots.push(knot);
        }
        knots.push(knot);
        let motion = BSplineMotion { degree, points: spline.points, knots, duration: spline.duration };
        self.machine.blocks.push(Block::BSpline(Box::new(motion)));
    }

    fn spline_line(&mut self) -> Result<(), Fault> {
        let degree = self.line.degree.and_then(Decimal::count).unwrap_or(3) as usize;
        if !(2..=3).contains(&degree) {
            return Err((ReadProblem::DegreeNotSupported, "SD=2 or SD=3"));
        }
        let interval = self.line.interval.map_or(1.0, Decimal::value);
        if !(0.0..=1e9).contains(&interval) {
            return Err((ReadProblem::OutOfRange, "PL from 0"));
        }
        let duration = inverse_time(self.line.feed.map(Decimal::value))?;
        let words = self.line.axes;
        let point = self.machine.go(&words)?;
        let spline = self.spline.get_or_insert(Spline {
            degree,
            points: Vec::new(),
            intervals: Vec::new(),
            duration: 0.0,
        });
        if spline.degree != degree {
            return Err((ReadProblem::Conflict, "the same SD in all lines of a spline"));
        }
        spline.points.push(point);
        spline.intervals.push(interval);
        spline.duration += duration;
        self.machine.motion = Motion::None;
        Ok(())
    }

    /// A motion line between CTABDEF and CTABEND.
    fn table_line(&mut self) -> Result<(), Fault> {
        let Some(OpenTable { table, started, .. }) = &mut self.table else { return Ok(()) };
        let both = self.line.axes.has(table.leader) && self.line.axes.has(table.follower);
        if self.line.spline || !both {
            return Err((ReadProblem::Missing, "leader and follower in every line of a table"));
        }
        let bent = |axis: usize| self.line.coefficients.iter().find(|(of, ..)| *of == axis);
        if bent(table.leader).is_some_and(|&(_, a2, a3)| a2 != 0.0 || a3 != 0.0) {
            return Err((ReadProblem::DegreeNotSupported, "a leader that goes straight"));
        }
        let (a2, a3) = bent(table.follower).map_or((0.0, 0.0), |&(_, a2, a3)| (a2, a3));
        let (leader, follower) = (table.leader, table.follower);
        let words = self.line.axes;
        let target = self.machine.go(&words)?;
        let place = |axis| target.get(axis).unwrap_or_default();
        let end = place(follower);
        if *started {
            let before = table.pieces.last().map_or(table.start[1], |piece| piece.follower.end);
            let (a2, a3) = (self.machine.neutral(follower, a2), self.machine.neutral(follower, a3));
            let piece = TablePiece { leader: place(leader), follower: span(before, end, a2, a3) };
            table.pieces.push(piece);
        } else {
            if self.line.poly {
                return Err((ReadProblem::Missing, "a line G1 to the start of the table"));
            }
            table.start = [place(leader), end];
            *started = true;
        }
        Ok(())
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
        let line = &self.line;
        for code in [93, 94] {
            if line.has(code) {
                self.machine.inverse_time = code == 93;
                self.machine.feed = None;
            }
        }
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

/// The arguments of a call.
struct Call<'s, 'b> {
    scan: &'s mut Scan<'b>,
    start: usize,
    first: bool,
}

impl<'b> Call<'_, 'b> {
    fn fault(&self, problem: ReadProblem, allowed: &'static str) -> ReadError {
        self.scan.fault(problem, self.start, allowed)
    }

    fn more(&mut self) -> bool {
        self.scan.skip_blanks();
        self.scan.peek() == Some(b',')
    }

    fn next(&mut self) -> Result<(), ReadError> {
        if !std::mem::replace(&mut self.first, false) && !self.scan.take(b',') {
            return Err(self.fault(ReadProblem::Missing, "more arguments"));
        }
        self.scan.skip_blanks();
        Ok(())
    }

    fn axis(&mut self, reader: &Siemens<'_>) -> Result<usize, ReadError> {
        self.next()?;
        let name = Siemens::name(self.scan)?;
        reader.axis(&name).ok_or_else(|| self.fault(ReadProblem::UnknownWord, "axes of the axis map"))
    }

    fn number(&mut self) -> Result<Decimal, ReadError> {
        self.next()?;
        self.scan.number()
    }

    /// A text between double quotes.
    fn text(&mut self) -> Result<&'b str, ReadError> {
        self.next()?;
        let quoted = self.scan.take(b'"');
        let rest = &self.scan.bytes[self.scan.at..];
        let length = rest.iter().position(|byte| *byte == b'"').filter(|_| quoted);
        let text = length.and_then(|length| std::str::from_utf8(&rest[..length]).ok());
        let text = text.ok_or_else(|| self.fault(ReadProblem::Missing, "a word between double quotes"))?;
        self.scan.at += text.len() + 1;
        Ok(text)
    }

    fn close(&mut self) -> Result<(), ReadError> {
        if self.scan.take(b')') {
            return Ok(());
        }
        Err(self.fault(ReadProblem::Missing, "a bracket that closes the call after its arguments"))
    }
}

impl Grammar for Siemens<'_> {
    const LINE: usize = 512;

    fn line(&mut self, bytes: &[u8], number: usize) -> Result<(), ReadError> {
        let mut scan = Scan::new(bytes, number);
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
