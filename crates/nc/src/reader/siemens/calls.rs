//! Calls of a Siemens program: the electronic gearbox and the head of a curve table.

use super::words::{CALLS, Name};
use super::{Defined, OpenTable, Siemens};
use crate::reader::error::{ReadError, ReadProblem};
use crate::reader::machine::Machine;
use crate::reader::scan::{Decimal, Scan};
use crate::{AxisMotion, Block, Coupling, CurveTable, Gear, GearLeader, GearSynchronisation, Repetition};

impl Siemens<'_> {
    /// `NAME(argument, ...)`.
    pub(super) fn call(&mut self, scan: &mut Scan<'_>, name: &Name, start: usize) -> Result<(), ReadError> {
        self.begun = true;
        self.end_spline();
        scan.at += 1;
        let mut call = Call { scan, start, first: true };
        match name.bytes() {
            _ if self.machine.ended => {
                return Err(call.fault(ReadProblem::End, "comments after the end"));
            }
            _ if self.machine.tip.is_some() => {
                return Err(call.fault(ReadProblem::Conflict, "TRAFOOF before the call"));
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
