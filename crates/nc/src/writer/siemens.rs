//! Siemens 840D family, `docs/mathematics/programs.md#the-independent-reader`: electronic gearbox, curve tables, cubics and B-splines of
//! all axes, tool tips. What is not confirmed stands in `unconfirmed.rs`.

use super::lines::{Lines, PLAIN_DECIMALS, per_minute};
use super::number::push_significant;
use super::unconfirmed::{
    SIEMENS_BLOCK_CHANGE, SIEMENS_KEPT, SIEMENS_LEADER_TYPE, SIEMENS_LINE, SIEMENS_NO_TOUCH, SIEMENS_OUTPUT,
    SIEMENS_PREAMBLE, SIEMENS_PROBE, SIEMENS_SPLINE_END, SIEMENS_TABLE_FEED, SIEMENS_TOOL_CHANGE,
};
use super::{WriteOptions, Written};
use crate::{
    AxisMotion, BSplineMotion, Block, Coupling, CubicMotion, CubicSpan, CurveTable, Gear,
    GearSynchronisation, MAXIMUM_AXES, NcError, Program, Repetition, Targets, TipControl, Word,
};

/// Most leading axes of a gear.
const LEADERS: usize = 5;
/// Digits of a ratio that is not of integers.
const RATIO_DIGITS: u8 = 15;

/// Decimals of polynomials and knots, so that a cubic comes back within 1e-9 of its unit: as many as an f64 of that size holds, and
/// at most 18 digits in all.
fn polynomial_decimals(value: f64) -> u8 {
    if value.abs() < 1e7 { 10 } else { 8 }
}

pub(super) fn write(program: &Program, options: &WriteOptions) -> Result<Written, NcError> {
    let allowed = "X Y Z A B C U V W, addresses such as B1, spindles";
    let out = Lines::new(program, options, SIEMENS_LINE, allowed, |word| match word {
        Word::Letter(letter) => Some(letter.to_string()),
        Word::Named(name) => Some(name.clone()),
        Word::Spindle(spindle) => Some(format!("S{}", u16::from(*spindle) + 1)),
    })?;
    let mut writer =
        Siemens { out, places: Targets::NONE, gears: [None; MAXIMUM_AXES], spindles: 0, edge: None };
    writer.program()?;
    Ok(writer.out.finish())
}

/// The same ratio of numbers from 1e-3, so that fifteen digits of them do not need more decimals than are read; integers stay.
fn enlarged(num: f64, den: f64) -> (f64, f64) {
    let least = if num == 0.0 { den.abs() } else { num.abs().min(den.abs()) };
    let factor = if least < 1e-3 { 10f64.powi((-3.0 - least.log10()).ceil() as i32) } else { 1.0 };
    (num * factor, den * factor)
}

struct Siemens<'a> {
    out: Lines<'a>,
    /// Where the axes stand: POLY is written from the end value and two coefficients.
    places: Targets,
    gears: [Option<&'a Gear>; MAXIMUM_AXES],
    spindles: u8,
    /// The edge of the tool, whose length tip control adds.
    edge: Option<u32>,
}

impl Siemens<'_> {
    fn program(&mut self) -> Result<(), NcError> {
        let program = self.out.program;
        self.out.push_format(format_args!("; {}", program.header().name));
        self.out.end_line()?;
        self.out.push_line(SIEMENS_PREAMBLE)?;
        self.out.push_line("G93")?;
        for (k, block) in program.blocks().iter().enumerate() {
            self.out.block = k + 1;
            match block {
                Block::Rapid(target) => {
                    self.motion("G0", target)?;
                    self.out.end_line()?;
                }
                Block::Linear { target, duration } => {
                    self.motion("G1", target)?;
                    self.out.feed(*duration)?;
                }
                Block::Cubic(motion) => self.cubic(motion)?,
                Block::BSpline(motion) => self.spline(motion)?,
                Block::Dwell(duration) => {
                    self.out.push("G4 F");
                    self.out.fixed(*duration, PLAIN_DECIMALS);
                    self.out.end_line()?;
                }
                Block::Spindle { spindle, speed } => self.spindle(*spindle, *speed)?,
                Block::Output { number, on } => {
                    let value = u8::from(*on);
                    self.out.push_format(format_args!("{SIEMENS_OUTPUT}$A_OUT[{number}]={value}"));
                    self.out.end_line()?;
                }
                Block::Comment(text) => {
                    self.out.push_format(format_args!("; {text}"));
                    self.out.end_line()?;
                }
                Block::Stop => self.out.push_line("M0")?,
                Block::End => self.end()?,
                Block::GearDefine(gear) => {
                    self.define(gear)?;
                    self.gears[gear.follower] = Some(gear);
                }
                Block::GearOn { follower, synchronisation } => {
                    self.couple(*follower, synchronisation.as_deref())?
                }
                Block::GearOff { follower } => self.gear_call("EGOFS", *follower)?,
                Block::Table(table) => self.table(table)?,
                Block::Tool { number, length_offset } => {
                    self.edge = *length_offset;
                    // Without a D the control takes one by itself, and adds its length to axis values.
                    self.out.push_format(format_args!("T{number} D0"));
                    self.out.push_line(SIEMENS_TOOL_CHANGE)?;
                }
                Block::LengthOffset(offset) => {
                    self.edge_line(*offset)?;
                    self.out.loose_all();
                    self.places = Targets::NONE;
                }
                Block::WorkOffset(number) => {
                    match number {
                        1..=4 => self.out.push_format(format_args!("G{}", 53 + number)),
                        5..=99 => self.out.push_format(format_args!("G{}", 500 + number)),
                        _ => {
                            return Err(self
                                .out
                                .no_such_offset(*number, "1 to 99: G54 to G57, G505 to G599"));
                        }
                    }
                    self.out.end_line()?;
                    self.out.loose_all();
                    self.places = Targets::NONE;
                }
                Block::Probe(motion) => {
                    self.out.probe(SIEMENS_PROBE, motion)?;
                    self.out.push_line(SIEMENS_NO_TOUCH)?;
                    let address = self.out.axes[motion.axis].address.clone();
                    let kept = SIEMENS_KEPT + u16::from(motion.slot);
                    self.out.push_format(format_args!("R{kept}=$AA_MW[{address}]"));
                    self.out.end_line()?;
                    self.places = Targets::NONE;
                }
                Block::ShiftOffset(shift) => {
                    if shift.number > 99 {
                        return Err(self
                            .out
                            .no_such_offset(shift.number, "1 to 99: G54 to G57, G505 to G599"));
                    }
                    let address = self.out.axes[shift.axis].address.clone();
                    let [first, second] = shift.slots.map(|slot| SIEMENS_KEPT + u16::from(slot));
                    let frame = format!("$P_UIFR[{},{address},TR]", shift.number);
                    self.out.push_format(format_args!("{frame}={frame}+(R{first}+R{second})/2-("));
                    self.out.axis_value(shift.axis, shift.middle);
                    self.out.push_line(")")?;
                    self.out.loose_all();
                    self.places = Targets::NONE;
                }
                Block::Coolant(coolant) => self.out.coolant(*coolant)?,
                Block::TipControlOn(control) => self.tip_control(*control)?,
                Block::TipControlOff => {
                    self.out.push_line("TRAFOOF")?;
                    self.edge_line(None)?;
                    self.out.loose_all();
                    self.places = Targets::NONE;
                }
                Block::Tip(motion) => self.out.tip(motion, [" A3=", " B3=", " C3="])?,
                Block::TipSpeed(speed) => self.out.tip_speed(*speed)?,
            }
        }
        Ok(())
    }

    fn tip_control(&mut self, control: TipControl) -> Result<(), NcError> {
        let taken = |word: &Word| matches!(word, Word::Named(name) if ["A3", "B3", "C3"].contains(&&**name));
        let mut axes = self.out.program.axes().iter().zip(&self.out.axes);
        if let Some((axis, text)) = axes.find(|(axis, _)| taken(&axis.word)) {
            return Err(NcError::AxisNotAvailable {
                axis: axis.name.as_str().into(),
                word: text.address.clone(),
                allowed: "addresses other than A3, B3 and C3, which are directions under TRAORI",
            });
        }
        self.edge_line(self.edge)?;
        self.out.push_line("TRAORI")?;
        self.out.push_line(match control {
            TipControl::Directions => "ORIWKS",
            TipControl::Angles => "ORIMKS",
        })
    }

    /// The edge whose length the control adds, in a line of its own.
    fn edge_line(&mut self, edge: Option<u32>) -> Result<(), NcError> {
        self.out.push_format(format_args!("D{}", edge.unwrap_or_default()));
        self.out.end_line()
    }

    fn end(&mut self) -> Result<(), NcError> {
        for follower in 0..MAXIMUM_AXES {
            if self.gears[follower].is_some() {
                self.gear_call("EGDEL", follower)?;
            }
        }
        self.out.push_line("G94")?;
        for spindle in (0..8).filter(|spindle| self.spindles >> spindle & 1 == 1).collect::<Vec<_>>() {
            self.spindle(spindle, 0.0)?;
        }
        self.out.push_line("M30")
    }

    /// Motion word and targets; a rotary axis of a modulo control by its increment once it stands somewhere.
    fn motion(&mut self, motion: &str, target: &Targets) -> Result<(), NcError> {
        self.out.start_axis_block(motion == "G0")?;
        self.out.push(motion);
        for (axis, value) in target.iter() {
            let one = Targets::NONE.with(axis, value);
            if self.out.is_incremental() && self.out.turns(&one) && self.out.stands(axis) {
                // A letter takes IC by an equals sign as well.
                let equals = matches!(self.out.program.axes()[axis].word, Word::Letter(_));
                self.out.increment(axis, value, if equals { "=IC(" } else { "IC(" }, ")")?;
            } else {
                self.out.targets(&one);
            }
        }
        self.out.moved(target);
        self.places.update(target);
        Ok(())
    }

    fn spindle(&mut self, spindle: u8, speed: f64) -> Result<(), NcError> {
        self.spindles |= 1 << spindle;
        let number = u16::from(spindle) + 1;
        if speed == 0.0 {
            self.out.push_format(format_args!("M{number}=5"));
        } else {
            self.out.push_format(format_args!("S{number}="));
            self.out.fixed(per_minute(speed.abs()), PLAIN_DECIMALS);
            self.out.push_format(format_args!(" M{number}={}", if speed > 0.0 { 3 } else { 4 }));
        }
        self.out.end_line()
    }

    fn precise(&mut self, value: f64) {
        self.out.fixed(value, polynomial_decimals(value));
    }

    /// ` PO[X]=(xe,a2,a3)`: a1 follows from where the axis stands.
    fn polynomial(&mut self, axis: usize, start: f64, span: &CubicSpan) {
        let scale = self.out.axes[axis].scale;
        let [_, _, a2, a3] = span.coefficients(start);
        let address = self.out.axes[axis].address.clone();
        self.out.push_format(format_args!(" PO[{address}]=("));
        for (separator, value) in [("", span.end), (",", a2), (",", a3)] {
            self.out.push(separator);
            self.precise(value * scale);
        }
        self.out.push(")");
    }

    fn cubic(&mut self, motion: &CubicMotion) -> Result<(), NcError> {
        self.out.inverse_time()?;
        self.out.push("POLY");
        let mut ends = Targets::NONE;
        for (axis, span) in &motion.spans {
            let start = self.places.get(*axis).unwrap_or_default();
            self.polynomial(*axis, start, span);
            ends.set(*axis, span.end);
        }
        self.places.update(&ends);
        self.out.moved(&ends);
        self.out.push(" PL=1.0");
        self.out.feed(motion.duration)
    }

    /// One line per control point after the first; the knot interval of a line is the one that its point completes, 0 for the
    /// last `degree` - 1, where the knots lie on each other. The lines share the time evenly.
    fn spline(&mut self, motion: &BSplineMotion) -> Result<(), NcError> {
        self.out.inverse_time()?;
        let (degree, knots) = (motion.degree, &motion.knots);
        let share = motion.duration / motion.points.len() as f64;
        for (k, point) in motion.points.iter().enumerate() {
            self.out.push("BSPLINE");
            self.out.targets(point);
            self.out.push_format(format_args!(" SD={degree} PL="));
            self.precise(knots[k + 1 + degree] - knots[k + degree]);
            self.out.feed(share)?;
            self.places.update(point);
            self.out.moved(point);
        }
        self.out.push_line(SIEMENS_SPLINE_END)
    }

    fn gear_call(&mut self, call: &str, follower: usize) -> Result<(), NcError> {
        let address = self.out.axes[follower].address.clone();
        self.out.push_format(format_args!("{call}({address})"));
        self.out.end_line()
    }

    fn define(&mut self, gear: &Gear) -> Result<(), NcError> {
        if gear.leaders.len() > LEADERS {
            let reason = "a gear has at most 5 leading axes";
            return Err(NcError::UnsupportedCoupling { block: self.out.block, reason });
        }
        self.gear_call("EGDEL", gear.follower)?;
        let address = self.out.axes[gear.follower].address.clone();
        self.out.push_format(format_args!("EGDEF({address}"));
        for leader in &gear.leaders {
            let address = self.out.axes[leader.axis].address.clone();
            self.out.push_format(format_args!(", {address}, {SIEMENS_LEADER_TYPE}"));
        }
        self.out.push(")");
        self.out.end_line()
    }

    fn couple(&mut self, follower: usize, at: Option<&GearSynchronisation>) -> Result<(), NcError> {
        let Some(gear) = self.gears[follower] else { return Ok(()) };
        let address = self.out.axes[follower].address.clone();
        let call = if at.is_some() { "EGONSYN" } else { "EGON" };
        self.out.push_format(format_args!("{call}({address}, \"{SIEMENS_BLOCK_CHANGE}\""));
        if let Some(at) = at {
            self.out.push(", ");
            self.out.axis_value(follower, at.follower);
        }
        let program = self.out.program;
        let turns = |axis: usize| program.axes()[axis].motion == AxisMotion::Rotary;
        for (k, leader) in gear.leaders.iter().enumerate() {
            let address = self.out.axes[leader.axis].address.clone();
            self.out.push_format(format_args!(", {address}, "));
            if let Some(at) = at {
                self.out.axis_value(leader.axis, at.leaders[k]);
                self.out.push(", ");
            }
            match leader.coupling {
                // Degrees where radians were: on one side only, so that ratios of turning axes stay integers.
                Coupling::Ratio { num, den } => {
                    let (num, den) = match (turns(follower), turns(leader.axis)) {
                        (true, false) => (num.to_degrees(), den),
                        (false, true) => (num, den.to_degrees()),
                        _ => (num, den),
                    };
                    let (num, den) = enlarged(num, den);
                    push_significant(&mut self.out.text, num, RATIO_DIGITS);
                    self.out.push(", ");
                    push_significant(&mut self.out.text, den, RATIO_DIGITS);
                }
                // A denominator of 0 says that the other number is a table.
                Coupling::Table(table) => self.out.push_format(format_args!("{table}, 0")),
            }
        }
        self.out.push(")");
        self.out.end_line()?;
        self.out.loose(follower);
        Ok(())
    }

    fn table(&mut self, table: &CurveTable) -> Result<(), NcError> {
        self.out.inverse_time()?;
        let [follower, leader] =
            [table.follower, table.leader].map(|axis| self.out.axes[axis].address.clone());
        let repetition = match table.repetition {
            Repetition::Held => 0,
            Repetition::Leader => 1,
            Repetition::Both => 2,
        };
        self.out.push_format(format_args!("CTABDEF({follower}, {leader}, {}, {repetition})", table.id));
        self.out.end_line()?;
        self.out.push("G1");
        self.plain(table.leader, table.start[0]);
        self.plain(table.follower, table.start[1]);
        self.out.push_line(SIEMENS_TABLE_FEED)?;
        let mut start = table.start[1];
        for piece in &table.pieces {
            self.out.push("POLY");
            self.plain(table.leader, piece.leader);
            self.polynomial(table.follower, start, &piece.follower);
            self.out.push(" PL=1.0");
            self.out.push_line(SIEMENS_TABLE_FEED)?;
            start = piece.follower.end;
        }
        self.out.push_line("CTABEND")
    }

    /// A word of a table, with the decimals of a polynomial.
    fn plain(&mut self, axis: usize, value: f64) {
        let equals = if matches!(self.out.program.axes()[axis].word, Word::Named(_)) { "=" } else { "" };
        let (address, scale) = (self.out.axes[axis].address.clone(), self.out.axes[axis].scale);
        self.out.push_format(format_args!(" {address}{equals}"));
        self.precise(value * scale);
    }
}
