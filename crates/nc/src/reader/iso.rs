//! Letter-and-number programs: LinuxCNC and Fanuc (`docs/mathematics/programs.md#the-independent-reader`; tips of tools:
//! `docs/mathematics/programs.md#cutters`). Here is what a line does; `words.rs` knows how it is spelt.

mod words;

use super::error::{ReadError, ReadProblem};
use super::machine::{AxisWords, Fault, Machine, Motion};
use super::probing::matched;
use super::scan::{Decimal, Scan};
use super::{Grammar, ReadProgram, program_name};
use crate::{AxisMotion, Block, Coolant, Coupling, Dialect, Gear, GearLeader, TipControl, ToothData, Word};
use words::{Codes, Words, letter};

const BELONG: &str = "only words that belong to the codes of the line";

pub(super) struct Iso<'a> {
    dialect: Dialect,
    machine: Machine<'a>,
    /// Axis of each letter.
    letters: [Option<u8>; 26],
    words: Words,
    axis_words: AxisWords,
    name: Option<String>,
    chord_tolerance: Option<f64>,
    /// Whether anything but comments and the program's number was read, whether that number was, and whether a percent sign opened
    /// the text.
    begun: bool,
    numbered: bool,
    percent: bool,
    /// Follower of the gear that is on.
    coupled: Option<usize>,
    /// Whether the line before was G53, which keeps a Fanuc from reading ahead.
    waits: bool,
}

impl<'a> Iso<'a> {
    pub fn new(dialect: Dialect, machine: Machine<'a>) -> Self {
        let mut letters = [None; 26];
        for (axis, word) in machine.axes.iter().enumerate() {
            if let Word::Letter(name @ 'A'..='Z') = word.word {
                letters[letter(name as u8)] = Some(axis as u8);
            }
        }
        let words = Words { values: [Decimal::default(); 26], columns: [0; 26], present: 0, used: 0 };
        Self {
            dialect,
            machine,
            letters,
            words,
            axis_words: AxisWords::NONE,
            name: None,
            chord_tolerance: None,
            begun: false,
            numbered: false,
            percent: false,
            coupled: None,
            waits: false,
        }
    }

    /// A line of a probing cycle; false if it is none.
    fn probing_line(&mut self, bytes: &[u8]) -> Result<bool, Fault> {
        let fanuc = self.is_fanuc();
        let code = if fanuc { "G94G31@%F%" } else { "G94G38.2@%F%" };
        if let Some(found) = matched(bytes, code, &self.machine) {
            self.machine.motion = Motion::None;
            return self.machine.probing(&found).map(|()| true);
        }
        // Nothing was touched: an alarm.
        if fanuc && matched(bytes, "IF[ABS[#%-[%]]LT%]THEN#3000=%(NOTOUCH)", &self.machine).is_some() {
            let open = self.machine.probing.is_some();
            return if open { Ok(true) } else { Err((ReadProblem::Missing, "a probing motion before")) };
        }
        if let Some(found) = matched(bytes, "#%=#%", &self.machine) {
            let [slot, place] = found.numbers[..] else { return Ok(false) };
            let axis = self.axis_numbered(place - 5060.0);
            let axis =
                axis.ok_or((ReadProblem::OutOfRange, "the place of an axis at the touch, from #5061"))?;
            return self.machine.probed(axis, slot).map(|()| true);
        }
        for (pattern, first, before) in [
            ("G10L2P%@[#%+[#%+#%]/2-[%]]", 5220.0, 0.0),
            ("G90G10L2P%@[#%+[#%+#%]/2.-[%]]", 5220.0, 0.0),
            ("G90G10L20P%@[#%+[#%+#%]/2.-[%]]", 7000.0, 6.0),
        ] {
            let Some(found) = matched(bytes, pattern, &self.machine) else { continue };
            let ([number, offset, a, b, middle], [axis]) = (&found.numbers[..], &found.axes[..]) else {
                continue;
            };
            let most = if first > 7e3 - 1.0 {
                48.0
            } else if fanuc {
                6.0
            } else {
                9.0
            };
            if number.fract() != 0.0 || !(1.0..=most).contains(number) {
                return Err((ReadProblem::OutOfRange, "the number of a work offset behind P"));
            }
            if self.axis_numbered(offset - first - 20.0 * (number - 1.0)) != Some(*axis) {
                return Err((ReadProblem::Conflict, "the variable of the same axis in the same work offset"));
            }
            return self.machine.offset_by_probe(number + before, *axis, [*a, *b], *middle).map(|()| true);
        }
        Ok(false)
    }

    /// The axis that the variables of a control count as this, from 1: by its letter on LinuxCNC, by its place on Fanuc.
    fn axis_numbered(&self, number: f64) -> Option<usize> {
        if number.fract() != 0.0 || !(1.0..=16.0).contains(&number) {
            return None;
        }
        let place = number as usize - 1;
        if self.is_fanuc() {
            return (place < self.machine.axes.len()).then_some(place);
        }
        let letter = *b"XYZABCUVW".get(place)?;
        self.letters[usize::from(letter - b'A')].map(usize::from)
    }

    fn is_fanuc(&self) -> bool {
        self.dialect == Dialect::Fanuc
    }

    fn comment(&mut self, bytes: &[u8], scan: &Scan<'_>, start: usize) -> Result<(), ReadError> {
        if bytes.contains(&b'(') {
            return Err(scan.fault(ReadProblem::Conflict, start, "comments without brackets inside"));
        }
        let text = String::from_utf8_lossy(bytes.trim_ascii()).into_owned();
        if !self.begun && self.name.is_none() && self.machine.blocks.is_empty() {
            self.name = program_name(&text);
            if self.name.is_some() {
                return Ok(());
            }
        }
        // What stands between name and first word is a note of the text, no block.
        let is_note = !self.begun && self.name.is_some() && self.machine.blocks.is_empty();
        if !text.is_empty() && !is_note {
            self.machine.blocks.push(Block::Comment(text.into()));
        }
        Ok(())
    }

    /// Carries a line out in the order that controls do.
    fn carry_out(&mut self, codes: &Codes) -> Result<(), Fault> {
        let alone = codes.g.list().len() + codes.m.list().len() == usize::from(codes.output.is_none())
            && self.words.present == 0;
        let waited = std::mem::replace(&mut self.waits, codes.g.has(530));
        match codes.output {
            Some(_) if !alone => return Err((ReadProblem::Conflict, "# alone in its line")),
            Some(_) if !waited => {
                return Err((
                    ReadProblem::Missing,
                    "G53 in the line before: macro statements are read ahead",
                ));
            }
            Some((number, on)) => return self.machine.output(number, on),
            None if self.waits && !alone => return Err((ReadProblem::Conflict, "G53 alone in its line")),
            None => {}
        }
        let dwell = codes.g.has(40);
        let axis_bits = self.letters.iter().enumerate().filter(|(_, axis)| axis.is_some());
        let axis_bits = axis_bits.fold(0u32, |mask, (k, _)| mask | 1 << k);
        let tipped = self.machine.tip.is_some();
        let moves = !dwell && !codes.g.has(51) && !codes.g.has(810);
        if moves {
            self.words.used |= axis_bits;
        }
        if codes.g.has(930) {
            self.machine.inverse_time = true;
            self.machine.feed = None;
        }
        if codes.g.has(940) {
            self.machine.inverse_time = false;
            self.machine.feed = None;
        }
        let feed = self.words.get(b'F').map(Decimal::value);
        if feed.is_some_and(|feed| !(1e-4..=1e9).contains(&feed)) {
            return Err((ReadProblem::OutOfRange, "F from 0.0001 to 1e9"));
        }
        if codes.m.has(6) {
            let number = self.words.get(b'T').and_then(Decimal::count);
            self.machine.tool(number, None)?;
        }
        self.coolant(codes)?;
        self.spindle(codes)?;
        if dwell {
            self.dwell()?;
        }
        for &code in codes.g.list() {
            match code {
                200 => self.machine.inch = true,
                210 => self.machine.inch = false,
                900 => self.machine.incremental = false,
                910 => self.machine.incremental = true,
                0 => self.machine.motion = Motion::Rapid,
                10 => self.machine.motion = Motion::Linear,
                640 if !self.is_fanuc() => {
                    if let Some(tolerance) = self.words.get(b'P') {
                        let scale = if self.machine.inch { 25.4 } else { 1.0 };
                        self.chord_tolerance = Some(tolerance.value() * scale);
                    }
                }
                51 if !matches!(self.words.get(b'Q').and_then(Decimal::count), Some(0 | 1)) => {
                    return Err((ReadProblem::Missing, "G5.1 with Q0 or Q1"));
                }
                810 => self.couple()?,
                434 | 435 => self.tip_on(codes)?,
                430 => self.lengthened()?,
                490 if self.machine.tip.is_some() => self.machine.tip_off(),
                490 => self.machine.length(None)?,
                540 | 550 | 560 | 570 | 580 | 590 => self.machine.origin((code / 10) as u16 - 53)?,
                591..=593 => self.machine.origin(code as u16 - 584)?,
                541 => {
                    let number = self.words.get(b'P').and_then(Decimal::count);
                    let number = number.filter(|number| (1..=300).contains(number));
                    let number = number.ok_or((ReadProblem::Missing, "G54.1 with P1 to P300"))?;
                    self.machine.origin(number as u16 + 6)?;
                }
                800 => {
                    self.machine.motion = Motion::None;
                    if let (true, Some(follower)) = (self.is_fanuc(), self.coupled.take()) {
                        self.machine.blocks.push(Block::GearOff { follower });
                    }
                }
                _ => {}
            }
        }
        for (code, on) in [(62, true), (63, false)] {
            if codes.m.has(code) {
                let number = self.words.get(b'P').and_then(Decimal::count);
                self.machine.output(number, on)?;
            }
        }
        for (code, on) in [(64, true), (65, false)] {
            if codes.m.has(code) {
                let axis = self.words.get(b'P').and_then(Decimal::count).map(|axis| axis as usize);
                let follower = axis.filter(|axis| *axis < self.machine.axes.len());
                let follower = follower.ok_or((ReadProblem::Missing, "P with the index of an axis"))?;
                // At which positions is said by the netlist.
                self.machine.blocks.push(match on {
                    true => Block::GearOn { follower, synchronisation: None },
                    false => Block::GearOff { follower },
                });
            }
        }
        if tipped && moves {
            self.tip_line(feed)?;
        } else if !self.axis_words.is_empty() && moves {
            let words = self.axis_words;
            self.machine.straight(&words, feed)?;
        } else if let (Some(feed), false) = (feed, self.machine.inverse_time) {
            self.machine.feed = Some(feed);
        }
        if codes.m.has(0) || codes.m.has(1) {
            self.machine.blocks.push(Block::Stop);
        }
        if codes.m.has(2) || codes.m.has(30) {
            self.machine.blocks.push(Block::End);
            self.machine.ended = true;
        }
        if self.words.present & !self.words.used != 0 {
            return Err((ReadProblem::Conflict, BELONG));
        }
        Ok(())
    }

    fn coolant(&mut self, codes: &Codes) -> Result<(), Fault> {
        let words = [(7, Coolant::Mist), (8, Coolant::Flood), (9, Coolant::Off)];
        let mut found = words.into_iter().filter(|(code, _)| codes.m.has(*code));
        if let Some((_, coolant)) = found.next() {
            self.machine.blocks.push(Block::Coolant(coolant));
        }
        found.next().map_or(Ok(()), |_| Err((ReadProblem::Conflict, "one of M7, M8, M9")))
    }

    /// G43 with the number of the tool's length offset.
    fn lengthened(&mut self) -> Result<(), Fault> {
        if self.coupled.is_some() || !self.axis_words.is_empty() {
            return Err((ReadProblem::Conflict, "G43 with H alone, not under G81"));
        }
        let offset = self.words.get(b'H').and_then(Decimal::count);
        let offset = offset.filter(|offset| (1..=999).contains(offset));
        let offset = offset.ok_or((ReadProblem::Missing, "G43 with H1 to H999"))?;
        if !self.machine.blocks.iter().any(|block| matches!(block, Block::Tool { .. })) {
            return Err((ReadProblem::Missing, "T and M6 before the length offset"));
        }
        self.machine.length(Some(offset))
    }

    /// G43.4 or G43.5 with the number of the tool's length offset.
    fn tip_on(&mut self, codes: &Codes) -> Result<(), Fault> {
        if self.coupled.is_some() || !self.axis_words.is_empty() {
            return Err((ReadProblem::Conflict, "G43.4 or G43.5 with H alone, not under G81"));
        }
        let offset =
            self.words.get(b'H').and_then(Decimal::count).filter(|offset| (1..=999).contains(offset));
        let offset = offset.ok_or((ReadProblem::Missing, "G43.4 or G43.5 with H1 to H999"))?;
        // It takes the place of G43.
        self.machine.length(None)?;
        self.machine.tool_offset(offset)?;
        let control = if codes.g.has(434) { TipControl::Angles } else { TipControl::Directions };
        self.machine.tip_on(Some(control))
    }

    /// The words of a line under tip control that began before it and is still on.
    fn tip_line(&mut self, feed: Option<f64>) -> Result<(), Fault> {
        let places = [b'X', b'Y', b'Z'].map(|letter| self.words.get(letter));
        let direction = [b'I', b'J', b'K'].map(|letter| self.words.get(letter));
        if self.machine.tip.is_none() {
            let any = places.iter().chain(&direction).any(Option::is_some) || !self.axis_words.is_empty();
            return if any { Err((ReadProblem::Conflict, "G49 alone in its line")) } else { Ok(()) };
        }
        let angles = self.axis_words;
        self.machine.tip_line(&places, &direction, &angles, feed)
    }

    fn spindle(&mut self, codes: &Codes) -> Result<(), Fault> {
        let speed = self.words.get(b'S').map(Decimal::value);
        let mut directions =
            [(3, 1.0), (4, -1.0), (5, 0.0)].into_iter().filter(|(code, _)| codes.m.has(*code));
        let direction = directions.next().map(|(_, direction)| direction);
        if directions.next().is_some() {
            return Err((ReadProblem::Conflict, "one of M3, M4, M5"));
        }
        if speed.is_none() && direction.is_none() {
            return match codes.spindle {
                Some(_) => Err((ReadProblem::Conflict, "$ beside S, M3, M4 or M5 only")),
                None => Ok(()),
            };
        }
        let mut spindle = codes.spindle.unwrap_or(0) as usize;
        if self.is_fanuc()
            && let Some(number) = self.words.get(b'P')
        {
            let number = number.count().filter(|number| *number > 0);
            spindle = number.ok_or((ReadProblem::OutOfRange, "spindles P1 to P8"))? as usize - 1;
        }
        self.machine.spindle(spindle, speed, direction)
    }

    fn dwell(&mut self) -> Result<(), Fault> {
        let seconds = if self.is_fanuc() {
            match (self.words.get(b'X'), self.words.get(b'P')) {
                (Some(seconds), None) if seconds.pointed => seconds.value(),
                // P counts milliseconds.
                (None, Some(number)) => {
                    f64::from(number.count().ok_or((ReadProblem::BadNumber, "P with whole milliseconds"))?)
                        / 1e3
                }
                _ => {
                    return Err((
                        ReadProblem::Missing,
                        "G4 with X in seconds, with a point, or P in milliseconds",
                    ));
                }
            }
        } else {
            self.words.get(b'P').ok_or((ReadProblem::Missing, "G4 with P in seconds"))?.value()
        };
        self.machine.dwell(seconds)
    }

    /// G81 of a hobbing machine: spindle 0 drives C, Z adds the lead.
    fn couple(&mut self) -> Result<(), Fault> {
        if self.coupled.is_some() {
            return Err((ReadProblem::Conflict, "G80 before the next G81"));
        }
        if self.machine.tip.is_some() {
            return Err((ReadProblem::Conflict, "G49 before G81"));
        }
        let axes = self.machine.axes;
        let axis = |word: Word| axes.iter().position(|axis| axis.word == word);
        let (Some(follower), Some(tool)) = (axis(Word::Letter('C')), axis(Word::Spindle(0))) else {
            return Err((ReadProblem::UnknownWord, "G81 with an axis C and a spindle 0 in the axis map"));
        };
        let teeth = self.words.get(b'T').and_then(Decimal::count).filter(|teeth| (1..=1000).contains(teeth));
        let teeth = teeth.ok_or((ReadProblem::OutOfRange, "T from 1 to 1000"))?;
        let threads = self.words.get(b'L').filter(|threads| {
            threads.decimals == 0 && threads.mantissa != 0 && threads.mantissa.unsigned_abs() <= 21
        });
        let threads = threads.ok_or((ReadProblem::OutOfRange, "L from -21 to 21 without 0"))?.mantissa as i32;
        let mut leaders = vec![GearLeader {
            axis: tool,
            coupling: Coupling::Ratio { num: threads.into(), den: teeth.into() },
        }];
        let (mut normal_module, mut helix_angle) = (f64::NAN, f64::NAN);
        match (self.words.get(b'Q'), self.words.get(b'P')) {
            (None, None) => {}
            (Some(q), Some(p)) if q.pointed && p.pointed => {
                normal_module = q.value();
                helix_angle = p.value().to_radians();
                if !(0.1..=25.0).contains(&normal_module) || !(-90.0..=90.0).contains(&p.value()) {
                    return Err((ReadProblem::OutOfRange, "Q from 0.1 to 25 mm, P from -90 to 90 deg"));
                }
                let lead = axis(Word::Letter('Z')).filter(|lead| axes[*lead].motion == AxisMotion::Linear);
                let lead = lead
                    .ok_or((ReadProblem::UnknownWord, "G81 with Q and P, and an axis Z in the axis map"))?;
                // dC/dZ = 360 sin(P)/(pi T Q) deg/mm.
                let (num, den) = (2.0 * helix_angle.sin(), f64::from(teeth) * normal_module);
                leaders.push(GearLeader { axis: lead, coupling: Coupling::Ratio { num, den } });
            }
            _ => return Err((ReadProblem::Missing, "Q and P together, with points")),
        }
        let teeth = ToothData { teeth, threads, normal_module, helix_angle };
        self.machine.blocks.push(Block::GearDefine(Box::new(Gear { follower, leaders, teeth: Some(teeth) })));
        self.machine.blocks.push(Block::GearOn { follower, synchronisation: None });
        self.coupled = Some(follower);
        Ok(())
    }
}

impl Grammar for Iso<'_> {
    // The longer of the two; LinuxCNC's own is checked in `line`.
    const LINE: usize = 256;
    type Read = ReadProgram;

    fn line(&mut self, bytes: &[u8], number: usize) -> Result<(), ReadError> {
        let mut scan = Scan::new(bytes, number);
        if !self.is_fanuc() && bytes.len() > 252 {
            return Err(scan.fault(ReadProblem::LineTooLong, 252, "252 characters"));
        }
        if bytes.trim_ascii() == b"%" {
            let opened = self.begun || self.numbered || self.percent;
            let first = !opened && self.machine.blocks.is_empty() && self.name.is_none();
            if first {
                self.percent = true;
            } else if self.percent && !self.machine.ended {
                self.machine.blocks.push(Block::End);
                self.machine.ended = true;
            } else if !self.percent {
                return Err(scan.fault(ReadProblem::End, 0, "% in the first and the last line"));
            }
            return Ok(());
        }
        let cycle = if self.machine.ended { Ok(false) } else { self.probing_line(bytes) };
        if self.machine.taken_by_probing(cycle, bytes, &mut scan)? {
            self.begun = true;
            return Ok(());
        }
        let before = self.machine.ended;
        let blocks = self.machine.blocks.len();
        let codes = self.words(&mut scan)?;
        let empty = codes.g.list().is_empty()
            && codes.m.list().is_empty()
            && self.words.present == 0
            && codes.spindle.is_none()
            && codes.output.is_none();
        if before {
            self.machine.blocks.truncate(blocks);
            if !empty {
                return Err(scan.fault(ReadProblem::End, 0, "comments after the end"));
            }
            return Ok(());
        }
        if empty {
            return Ok(());
        }
        if let Some(number) = self.words.get(b'O') {
            let alone = self.words.present == 1 << letter(b'O')
                && codes.g.list().is_empty()
                && codes.m.list().is_empty();
            if self.begun || self.numbered || !alone || number.count().is_none_or(|number| number == 0) {
                return Err(scan.fault(
                    ReadProblem::Conflict,
                    0,
                    "the number O once, before everything else",
                ));
            }
            self.numbered = true;
            return Ok(());
        }
        self.begun = true;
        self.carry_out(&codes).map_err(|(problem, allowed)| {
            let unused = (0..26).find(|k| (self.words.present & !self.words.used) >> k & 1 == 1);
            let start = unused.filter(|_| allowed == BELONG).map_or(0, |k| self.words.columns[k]);
            scan.at = bytes.len();
            scan.fault(problem, start, allowed)
        })
    }

    fn finish(self, last: usize) -> Result<ReadProgram, ReadError> {
        if !self.machine.ended {
            let allowed = "a program that ends with M2 or M30";
            return Err(ReadError {
                line: last,
                column: 1,
                problem: ReadProblem::End,
                word: "".into(),
                allowed,
            });
        }
        Ok(ReadProgram {
            name: self.name,
            chord_tolerance: self.chord_tolerance,
            blocks: self.machine.blocks,
        })
    }
}
