//! Cutter locations in the words of APT back into neutral blocks. Shares nothing with their writer; takes blanks, small letters,
//! comments after `$$`, records in any order, and a direction that holds on.

use super::error::{ReadError, ReadProblem};
use super::machine::Fault;
use super::scan::Scan;
use super::tip::unit;
use super::{Grammar, program_name};
use crate::{Block, ClCutter, Coolant, Orientation, Pace, TipControl, TipMotion};

const WORDS: &str =
    "PARTNO UNITS TOOL LOADTL SPINDL FEDRAT RAPID GOTO MULTAX DELAY COOLNT STOP PPRINT FINI, comments $$";
/// What five decimals may do to a corner's radius that is half the diameter, mm.
const ROUNDED: f64 = 1e-5;
/// Most numbers of a record.
const NUMBERS: usize = 6;
/// Most words of a record.
const MINORS: usize = 2;

/// What was read from cutter locations.
#[derive(Clone, Debug, PartialEq)]
pub struct ClProgram {
    /// The name, if the text has one that a program can have.
    pub name: Option<String>,
    /// The cutter, if the text names it.
    pub cutter: Option<ClCutter>,
    /// The blocks; the last is [`Block::End`].
    pub blocks: Vec<Block>,
}

/// A speed or a feed that FEDRAT has given.
#[derive(Clone, Copy)]
enum Feed {
    None,
    /// mm/s.
    Speed(f64),
    /// s, of one motion.
    Duration(f64),
}

pub(super) struct Cl {
    name: Option<String>,
    cutter: Option<ClCutter>,
    blocks: Vec<Block>,
    millimetres: bool,
    tip_control: bool,
    oriented: bool,
    rapid: bool,
    feed: Feed,
    ended: bool,
}

/// What stands after the slash of a record: numbers and words in their order.
#[derive(Default)]
struct Values<'a> {
    numbers: [f64; NUMBERS],
    count: usize,
    minors: [&'a [u8]; MINORS],
    minor_count: usize,
}

impl<'a> Values<'a> {
    fn read(scan: &mut Scan<'a>) -> Result<Self, ReadError> {
        let mut values = Self::default();
        loop {
            scan.skip_blanks();
            let start = scan.at;
            match scan.peek() {
                Some(byte) if byte.is_ascii_alphabetic() => {
                    while scan.peek().is_some_and(|byte| byte.is_ascii_alphanumeric()) {
                        scan.at += 1;
                    }
                    let Some(place) = values.minors.get_mut(values.minor_count) else {
                        return Err(scan.fault(ReadProblem::Conflict, start, "one or two words in a record"));
                    };
                    *place = &scan.bytes[start..scan.at];
                    values.minor_count += 1;
                }
                _ => {
                    let number = scan.number()?;
                    let Some(place) = values.numbers.get_mut(values.count) else {
                        return Err(scan.fault(
                            ReadProblem::Conflict,
                            start,
                            "at most six numbers in a record",
                        ));
                    };
                    *place = number.value();
                    values.count += 1;
                }
            }
            if !scan.take(b',') {
                scan.skip_blanks();
                return match scan.peek() {
                    None => Ok(values),
                    Some(_) => Err(scan.fault(ReadProblem::Conflict, scan.at, "a comma between two values")),
                };
            }
        }
    }

    fn numbers(&self) -> &[f64] {
        &self.numbers[..self.count]
    }

    /// Whether the words are these, in whatever letters.
    fn are(&self, words: &[&str]) -> bool {
        let minors = &self.minors[..self.minor_count];
        minors.len() == words.len()
            && minors.iter().zip(words).all(|(a, b)| a.eq_ignore_ascii_case(b.as_bytes()))
    }
}

/// A number that counts something, from 1.
fn count(number: f64, most: f64, allowed: &'static str) -> Result<u32, Fault> {
    if number.fract() == 0.0 && (1.0..=most).contains(&number) {
        return Ok(number as u32);
    }
    Err((ReadProblem::OutOfRange, allowed))
}

impl Cl {
    pub fn new() -> Self {
        Self {
            name: None,
            cutter: None,
            blocks: Vec::new(),
            millimetres: false,
            tip_control: false,
            oriented: false,
            rapid: false,
            feed: Feed::None,
            ended: false,
        }
    }

    fn record(&mut self, major: &[u8], values: &Values<'_>) -> Result<(), Fault> {
        const MISSING: ReadProblem = ReadProblem::Missing;
        let numbers = values.numbers();
        match major {
            b"UNITS" => {
                if !values.are(&["MM"]) || !numbers.is_empty() {
                    return Err((ReadProblem::OutOfRange, "UNITS/MM"));
                }
                self.millimetres = true;
            }
            b"TOOL" => {
                let [diameter, corner_radius, cutting_length] = *numbers else {
                    return Err((MISSING, "TOOL/MILL,diameter,corner radius,cutting length"));
                };
                let fits = values.are(&["MILL"])
                    && diameter > 0.0
                    && cutting_length > 0.0
                    && (0.0..=0.5 * diameter + ROUNDED).contains(&corner_radius);
                if !fits || self.cutter.is_some() {
                    return Err((
                        ReadProblem::OutOfRange,
                        "one TOOL/MILL with a diameter, a corner within it and a length",
                    ));
                }
                self.cutter = Some(ClCutter { diameter, corner_radius, cutting_length });
            }
            b"LOADTL" => {
                let offsets = "LOADTL/number or LOADTL/number,OSETNO,offset";
                let length_offset = match (numbers, values.are(&["OSETNO"]), values.minor_count) {
                    ([_], false, 0) => None,
                    ([_, offset], true, _) => Some(count(*offset, 999.0, offsets)?),
                    _ => return Err((MISSING, offsets)),
                };
                if self.tip_control {
                    return Err((ReadProblem::Conflict, "MULTAX/OFF before the next tool"));
                }
                self.blocks
                    .push(Block::Tool { number: count(numbers[0], 99_999_999.0, offsets)?, length_offset });
            }
            b"SPINDL" => {
                let speed = match numbers {
                    [] if values.are(&["OFF"]) => 0.0,
                    [speed] if (0.0..=1e6).contains(speed) && values.are(&["RPM", "CLW"]) => *speed,
                    [speed] if (0.0..=1e6).contains(speed) && values.are(&["RPM", "CCLW"]) => -speed,
                    _ => return Err((MISSING, "SPINDL/RPM,speed,CLW, CCLW in its place, or SPINDL/OFF")),
                };
                self.blocks.push(Block::Spindle { spindle: 0, speed: speed * std::f64::consts::PI / 30.0 });
            }
            b"FEDRAT" => {
                self.feed = match numbers {
                    [feed] if !(1e-4..=1e9).contains(feed) => {
                        return Err((ReadProblem::OutOfRange, "a feed from 0.0001 to 1e9"));
                    }
                    [feed] if values.are(&["MMPM"]) => Feed::Speed(feed / 60.0),
                    [feed] if values.are(&["INVERS"]) => Feed::Duration(60.0 / feed),
                    _ => return Err((MISSING, "FEDRAT/feed,MMPM or FEDRAT/feed,INVERS")),
                };
            }
            b"MULTAX" => {
                let on = values.are(&["ON"]);
                if !on && !values.are(&["OFF"]) || on == self.tip_control || !numbers.is_empty() {
                    return Err((ReadProblem::Conflict, "MULTAX/ON and MULTAX/OFF in turn"));
                }
                self.tip_control = on;
                self.oriented = false;
                self.blocks.push(match on {
                    true => Block::TipControlOn(TipControl::Directions),
                    false => Block::TipControlOff,
                });
            }
            b"COOLNT" => {
                let words = [("OFF", Coolant::Off), ("FLOOD", Coolant::Flood), ("MIST", Coolant::Mist)];
                let named = words.into_iter().find(|(word, _)| values.are(&[word]) && numbers.is_empty());
                let (_, coolant) = named.ok_or((MISSING, "COOLNT/FLOOD, COOLNT/MIST or COOLNT/OFF"))?;
                self.blocks.push(Block::Coolant(coolant));
            }
            b"DELAY" => match numbers {
                [seconds] if values.minor_count == 0 && (1e-6..=1e5).contains(seconds) => {
                    self.blocks.push(Block::Dwell(*seconds));
                }
                _ => return Err((ReadProblem::OutOfRange, "DELAY/seconds from 0.000001 to 100000")),
            },
            b"GOTO" if values.minor_count == 0 => self.go(numbers)?,
            _ => return Err((ReadProblem::UnknownWord, WORDS)),
        }
        Ok(())
    }

    fn go(&mut self, numbers: &[f64]) -> Result<(), Fault> {
        if !self.millimetres {
            return Err((ReadProblem::Missing, "UNITS/MM before the first GOTO"));
        }
        if !self.tip_control {
            return Err((ReadProblem::Missing, "MULTAX/ON before GOTO"));
        }
        let (tip, orientation) = match *numbers {
            [x, y, z] if self.oriented => ([x, y, z], Orientation::Kept),
            [x, y, z, i, j, k] => ([x, y, z], Orientation::Direction(unit([i, j, k])?)),
            _ => return Err((ReadProblem::Missing, "GOTO/x,y,z,i,j,k; i, j and k at least once")),
        };
        self.oriented = true;
        let pace = match self.feed {
            _ if self.rapid => Pace::Rapid,
            Feed::Speed(speed) => Pace::Speed(speed),
            Feed::Duration(duration) => {
                // It is the feed of one motion.
                self.feed = Feed::None;
                Pace::Duration(duration)
            }
            Feed::None => {
                return Err((
                    ReadProblem::Missing,
                    "FEDRAT or RAPID before GOTO, in inverse time before each",
                ));
            }
        };
        self.rapid = false;
        self.blocks.push(Block::Tip(TipMotion { tip, orientation, pace }));
        Ok(())
    }
}

impl Grammar for Cl {
    const LINE: usize = 512;
    type Read = ClProgram;

    fn line(&mut self, bytes: &[u8], number: usize) -> Result<(), ReadError> {
        let comment = bytes.windows(2).position(|pair| pair == b"$$");
        let bytes = bytes[..comment.unwrap_or(bytes.len())].trim_ascii_end();
        let mut scan = Scan::new(bytes, number);
        scan.skip_blanks();
        let start = scan.at;
        if scan.peek().is_none() {
            return Ok(());
        }
        if self.ended {
            return Err(scan.fault(ReadProblem::End, start, "comments after the end"));
        }
        while scan.peek().is_some_and(|byte| byte.is_ascii_alphabetic()) {
            scan.at += 1;
        }
        let major = bytes[start..scan.at].to_ascii_uppercase();
        scan.skip_blanks();
        let slash = scan.take(b'/');
        let rest = bytes[scan.at..].trim_ascii();
        match (&major[..], slash, rest.is_empty()) {
            (b"PARTNO", ..) if self.blocks.is_empty() && self.name.is_none() => {
                self.name = program_name(&String::from_utf8_lossy(rest));
                return Ok(());
            }
            (b"PPRINT", true, false) => {
                self.blocks.push(Block::Comment(String::from_utf8_lossy(rest).into()));
                return Ok(());
            }
            (b"RAPID", false, true) => {
                self.rapid = true;
                return Ok(());
            }
            (b"STOP", false, true) => {
                self.blocks.push(Block::Stop);
                return Ok(());
            }
            (b"FINI", false, true) => {
                self.blocks.push(Block::End);
                self.ended = true;
                return Ok(());
            }
            (_, true, _) => {}
            _ => return Err(scan.fault(ReadProblem::UnknownWord, start, WORDS)),
        }
        let values = Values::read(&mut scan)?;
        self.record(&major, &values).map_err(|(problem, allowed)| {
            scan.at = bytes.len();
            scan.fault(problem, start, allowed)
        })
    }

    fn finish(self, last: usize) -> Result<ClProgram, ReadError> {
        if self.ended {
            return Ok(ClProgram { name: self.name, cutter: self.cutter, blocks: self.blocks });
        }
        let allowed = "a text that ends with FINI";
        Err(ReadError { line: last, column: 1, problem: ReadProblem::End, word: "".into(), allowed })
    }
}
