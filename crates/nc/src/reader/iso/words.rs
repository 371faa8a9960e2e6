//! Words of a line of letters and numbers, and its codes. What they do is not known here.

use super::Iso;
use crate::Dialect;
use crate::reader::error::{ReadError, ReadProblem};
use crate::reader::machine::Meaning;
use crate::reader::scan::{Decimal, Scan};

/// Most codes of one line.
const CODES: usize = 16;

const LINUXCNC_CODES: &str = "G0 G1 G4 G17 G20 G21 G40 G43 G49 G54 to G59.3 G61 G64 G80 G90 G91 G93 G94, M0 M1 M2 M3 M4 M5 M6 M7 M8 M9 M30 M62 M63 M64 M65";
const FANUC_CODES: &str = "G0 G1 G4 G5.1 G17 G20 G21 G40 G43 G43.4 G43.5 G49 G53 G54 to G59 G54.1 G64 G80 G81 G90 G91 G93 G94, M0 M1 M2 M3 M4 M5 M6 M7 M8 M9 M30";
const LINUXCNC_WORDS: &str = "G M N F S P T H $, letters of the axis map, comments ( ) and ;";
const FANUC_WORDS: &str = "G M N O F S P Q T L H, letters of the axis map, X Y Z I J K under G43.4 and G43.5, #1101= to #1115=, comments ( ), capital letters only";

/// Codes of G in tenths, and the group that allows one of them in a line.
fn group(dialect: Dialect, tenths: u32) -> Option<u32> {
    let group = match tenths {
        0 | 10 | 800 => 0,
        40 => 1,
        170 => 2,
        200 | 210 => 3,
        400 => 4,
        430 | 490 => 5,
        540 | 550 | 560 | 570 | 580 | 590 => 11,
        541 if dialect == Dialect::Fanuc => 11,
        591..=593 if dialect == Dialect::LinuxCnc => 11,
        434 | 435 if dialect == Dialect::Fanuc => 5,
        610 | 640 => 6,
        900 | 910 => 7,
        930 | 940 => 8,
        51 if dialect == Dialect::Fanuc => 9,
        530 if dialect == Dialect::Fanuc => 10,
        810 if dialect == Dialect::Fanuc => 0,
        _ => return None,
    };
    (!(tenths == 610 && dialect == Dialect::Fanuc)).then_some(group)
}

/// The words of one line, by letter.
pub(super) struct Words {
    pub values: [Decimal; 26],
    pub columns: [usize; 26],
    /// Letters that stand in the line, and those that somebody asked for, as bits.
    pub present: u32,
    pub used: u32,
}

/// Place of a capital letter.
pub(super) const fn letter(byte: u8) -> usize {
    (byte - b'A') as usize
}

impl Words {
    pub fn get(&mut self, byte: u8) -> Option<Decimal> {
        let bit = 1 << letter(byte);
        self.used |= bit;
        (self.present & bit != 0).then(|| self.values[letter(byte)])
    }
}

/// The codes of one line.
#[derive(Default)]
pub(super) struct Codes {
    pub g: CodeList,
    pub m: CodeList,
    groups: u32,
    pub spindle: Option<u32>,
    /// Number and state of the output that a macro statement switches.
    pub output: Option<(Option<u32>, bool)>,
}

#[derive(Default)]
pub(super) struct CodeList {
    codes: [u32; CODES],
    count: usize,
}

impl CodeList {
    /// False if there is no more room or the code is there already.
    fn push(&mut self, code: u32) -> bool {
        if self.count == CODES || self.has(code) {
            return false;
        }
        self.codes[self.count] = code;
        self.count += 1;
        true
    }

    pub fn has(&self, code: u32) -> bool {
        self.list().contains(&code)
    }

    pub fn list(&self) -> &[u32] {
        &self.codes[..self.count]
    }
}

/// Variable of the output 0.
const OUTPUTS: u32 = 1100;

impl Iso<'_> {
    /// `#1101=1` after its sign: the output and whether it goes on.
    fn statement(scan: &mut Scan<'_>, start: usize) -> Result<(Option<u32>, bool), ReadError> {
        let allowed = "#1101= to #1115= with 0 or 1";
        let variable = scan.number()?;
        if !scan.take(b'=') {
            return Err(scan.fault(ReadProblem::Missing, start, allowed));
        }
        let value = scan.number()?;
        let on = match value.count() {
            Some(value @ (0 | 1)) => value == 1,
            _ => return Err(scan.fault(ReadProblem::OutOfRange, start, allowed)),
        };
        Ok((variable.count().and_then(|variable| variable.checked_sub(OUTPUTS)), on))
    }

    /// Letters and numbers of the line into `words`, codes into the two lists.
    pub(super) fn words(&mut self, scan: &mut Scan<'_>) -> Result<Codes, ReadError> {
        let mut codes = Codes::default();
        let allowed = if self.is_fanuc() { FANUC_WORDS } else { LINUXCNC_WORDS };
        self.words.present = 0;
        self.words.used = 0;
        self.axis_words.clear();
        loop {
            scan.skip_blanks();
            let start = scan.at;
            let Some(byte) = scan.peek() else { return Ok(codes) };
            scan.at += 1;
            match byte {
                b'(' => {
                    let Some(length) = scan.bytes[scan.at..].iter().position(|byte| *byte == b')') else {
                        return Err(scan.fault(
                            ReadProblem::Missing,
                            start,
                            "a bracket that closes the comment",
                        ));
                    };
                    let text = &scan.bytes[scan.at..scan.at + length];
                    scan.at += length + 1;
                    self.comment(text, scan, start)?;
                    continue;
                }
                b';' if !self.is_fanuc() => {
                    let text = &scan.bytes[scan.at..];
                    scan.at = scan.bytes.len();
                    self.comment(text, scan, start)?;
                    continue;
                }
                b'#' if self.is_fanuc() && codes.output.is_none() => {
                    codes.output = Some(Self::statement(scan, start)?);
                    continue;
                }
                b'$' if !self.is_fanuc() => {
                    let number = scan.number()?;
                    if codes.spindle.is_some() {
                        return Err(scan.fault(ReadProblem::Conflict, start, "one word $"));
                    }
                    codes.spindle = number.count();
                    if codes.spindle.is_none() {
                        return Err(scan.fault(ReadProblem::OutOfRange, start, "$0 to $7"));
                    }
                    continue;
                }
                _ => {}
            }
            let name = if self.is_fanuc() { byte } else { byte.to_ascii_uppercase() };
            if !name.is_ascii_uppercase() {
                return Err(scan.fault(ReadProblem::UnknownWord, start, allowed));
            }
            let number = scan.number()?;
            match name {
                b'G' => {
                    let tenths = match number.decimals {
                        0 => number.mantissa.checked_mul(10),
                        1 => Some(number.mantissa),
                        _ => None,
                    };
                    let code = tenths.and_then(|tenths| u32::try_from(tenths).ok());
                    let known = code.and_then(|code| Some((code, group(self.dialect, code)?)));
                    let Some((code, group)) = known else {
                        let allowed = if self.is_fanuc() { FANUC_CODES } else { LINUXCNC_CODES };
                        return Err(scan.fault(ReadProblem::UnknownWord, start, allowed));
                    };
                    if codes.groups & 1 << group != 0 || !codes.g.push(code) {
                        return Err(scan.fault(
                            ReadProblem::Conflict,
                            start,
                            "one code of each group in a line",
                        ));
                    }
                    codes.groups |= 1 << group;
                }
                b'M' => {
                    let code = number.count().filter(|code| {
                        matches!(code, 0..=9 | 30) || (!self.is_fanuc() && matches!(code, 62..=65))
                    });
                    let Some(code) = code else {
                        let allowed = if self.is_fanuc() { FANUC_CODES } else { LINUXCNC_CODES };
                        return Err(scan.fault(ReadProblem::UnknownWord, start, allowed));
                    };
                    if !codes.m.push(code) {
                        return Err(scan.fault(ReadProblem::Conflict, start, "few codes in a line"));
                    }
                }
                b'N' => {}
                _ => {
                    let bit = 1 << letter(name);
                    // X may be a dwell where no axis has it.
                    let plain = if self.is_fanuc() { &b"FSPQTLOXH"[..] } else { b"FSPTH" };
                    let tip = self.machine.tip.is_some() && b"XYZIJK".contains(&name);
                    if let Some(axis) = self.letters[letter(name)].filter(|_| !tip) {
                        if self.is_fanuc() && !number.pointed {
                            let allowed = "a number with a point: without one it counts least increments";
                            return Err(scan.fault(ReadProblem::BadNumber, start, allowed));
                        }
                        self.axis_words.add(usize::from(axis), number, Meaning::ByMode);
                    } else if tip {
                        if !number.pointed {
                            let allowed = "a number with a point: without one it counts least increments";
                            return Err(scan.fault(ReadProblem::BadNumber, start, allowed));
                        }
                    } else if !plain.contains(&name) {
                        return Err(scan.fault(ReadProblem::UnknownWord, start, allowed));
                    }
                    if self.words.present & bit != 0 {
                        return Err(scan.fault(ReadProblem::Conflict, start, "each letter once in a line"));
                    }
                    self.words.present |= bit;
                    self.words.values[letter(name)] = number;
                    self.words.columns[letter(name)] = start;
                }
            }
        }
    }
}
