//! Words of a Siemens line: names, numbers, axis words, codes, polynomials. What they do is not known here.

use super::{CODES, Siemens, TipSwitch};
use crate::reader::error::{ReadError, ReadProblem};
use crate::reader::machine::{Fault, Meaning, Motion};
use crate::reader::scan::{Decimal, Scan};
use crate::{Block, Coolant, TipControl, Word};

const WORDS: &str = "G M N F S, axes of the axis map, X1=.. IC() AC(), S1= M1=, T D M6, TRAORI ORIWKS ORIMKS A3= B3= C3= TRAFOOF, POLY PO[] PL=, BSPLINE SD=, WHEN TRUE DO $A_OUT[]=, comments ;";

/// The calls.
pub(super) const CALLS: &str = "EGDEL EGDEF EGON EGONSYN EGOFS CTABDEF, alone in their line";

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
        54..=57 | 500 | 505..=599 => 6,
        90 | 91 => 7,
        93 | 94 => 8,
        _ => return None,
    })
}

/// A word of letters and digits in capitals.
#[derive(Clone, Copy)]
pub(super) struct Name {
    pub bytes: [u8; NAME],
    pub length: usize,
    /// How many letters it begins with.
    letters: usize,
}

impl Name {
    pub fn bytes(&self) -> &[u8] {
        &self.bytes[..self.length]
    }

    /// The number after one letter `letter`, e.g. 2 of `M2`.
    pub fn index(&self, letter: u8) -> Option<usize> {
        match self.bytes() {
            [first, digit @ b'1'..=b'8'] if *first == letter => Some(usize::from(digit - b'0')),
            _ => None,
        }
    }
}

impl Siemens<'_> {
    /// Letters and then digits; the digits stay unread if a single letter stands before them and no sign of an address follows.
    pub(super) fn name(scan: &mut Scan<'_>) -> Result<Name, ReadError> {
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
    /// The words of a line into `self.line`; true if there was any. A call is carried out at once.
    pub(super) fn words(&mut self, scan: &mut Scan<'_>) -> Result<bool, ReadError> {
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
            let before = std::mem::replace(&mut any, true);
            match name.bytes() {
                b"POLY" if !self.line.poly => self.line.poly = true,
                b"BSPLINE" if !self.line.spline => self.line.spline = true,
                b"POLY" | b"BSPLINE" => return conflict(scan),
                b"TRAORI" | b"TRAFOOF" | b"ORIWKS" | b"ORIMKS" => {
                    let switch = match name.bytes() {
                        b"TRAORI" => TipSwitch::On,
                        b"TRAFOOF" => TipSwitch::Off,
                        b"ORIWKS" => TipSwitch::By(TipControl::Directions),
                        _ => TipSwitch::By(TipControl::Angles),
                    };
                    scan.skip_blanks();
                    let alone = !before && self.table.is_none() && matches!(scan.peek(), None | Some(b';'));
                    if !alone {
                        return Err(scan.fault(ReadProblem::Conflict, start, "this word alone in its line"));
                    }
                    self.line.tip.switch = Some(switch);
                }
                b"WHEN" => {
                    let switch = Self::output(scan, start)?;
                    let alone = !before && self.table.is_none() && matches!(scan.peek(), None | Some(b';'));
                    if !alone {
                        return Err(scan.fault(
                            ReadProblem::Conflict,
                            start,
                            "this action alone in its line",
                        ));
                    }
                    self.line.output = Some(switch);
                }
                b"T" | b"D" => {
                    scan.take(b'=');
                    let number = scan.number()?;
                    let tip = &mut self.line.tip;
                    let place = if name.bytes()[0] == b'T' { &mut tip.tool } else { &mut tip.offset };
                    if place.replace(number).is_some() {
                        return conflict(scan);
                    }
                }
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
                    if self.machine.tip.is_some()
                        && let Some((direction, part)) = Self::tip_word(&name, equals)
                    {
                        let number = scan.number()?;
                        let tip = &mut self.line.tip;
                        let three = if direction { &mut tip.direction } else { &mut tip.places };
                        if three[part].replace(number).is_some() {
                            return conflict(scan);
                        }
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

    /// `TRUE DO $A_OUT[1]=1`, what follows WHEN: the output and whether it goes on.
    fn output(scan: &mut Scan<'_>, start: usize) -> Result<(Option<u32>, bool), ReadError> {
        let grammar = "WHEN TRUE DO $A_OUT[1 to 15]= with 0 or 1";
        for word in [&b"TRUE"[..], b"DO", b"$A_OUT"] {
            scan.skip_blanks();
            let text = scan.bytes.get(scan.at..scan.at + word.len());
            if !text.is_some_and(|text| text.eq_ignore_ascii_case(word)) {
                return Err(scan.fault(ReadProblem::UnknownWord, start, grammar));
            }
            scan.at += word.len();
        }
        let opened = scan.take(b'[');
        let number = scan.number()?;
        if !opened || !scan.take(b']') || !scan.take(b'=') {
            return Err(scan.fault(ReadProblem::Missing, start, grammar));
        }
        let on = match scan.number()?.count() {
            Some(value @ (0 | 1)) => value == 1,
            _ => return Err(scan.fault(ReadProblem::OutOfRange, start, grammar)),
        };
        scan.skip_blanks();
        Ok((number.count(), on))
    }

    /// Whether a word is of a direction or else of the tip, and which part of it.
    fn tip_word(name: &Name, equals: bool) -> Option<(bool, usize)> {
        match name.bytes() {
            [b'X'] => Some((false, 0)),
            [b'Y'] => Some((false, 1)),
            [b'Z'] => Some((false, 2)),
            b"A3" if equals => Some((true, 0)),
            b"B3" if equals => Some((true, 1)),
            b"C3" if equals => Some((true, 2)),
            _ => None,
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
            Some(6) if spindle == 0 && !self.line.tip.change => {
                self.line.tip.change = true;
                return Ok(());
            }
            Some(code @ 7..=9) if spindle == 0 => {
                let coolant = [Coolant::Mist, Coolant::Flood, Coolant::Off][code as usize - 7];
                return match self.line.coolant.replace(coolant) {
                    None => Ok(()),
                    Some(_) => Err((ReadProblem::Conflict, "one of M7, M8, M9")),
                };
            }
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
}
