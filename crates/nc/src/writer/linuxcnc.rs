//! LinuxCNC (RS274/NGC), `docs/mathematics/programs.md#the-independent-reader`. What is here was measured on the client, except the netlist
//! of `hal.rs`.

use super::lines::{Lines, PLAIN_DECIMALS, per_minute};
use super::{Warning, WriteOptions, Written, hal};
use crate::{AxisMotion, Block, Gear, NcError, Program, Targets, Word};

/// Longest line before its end.
const LINE: usize = 252;
const ALLOWED: &str = "X Y Z A B C U V W and spindles; stand-alone X Y Z A B C and spindle 0";

pub(super) fn write(program: &Program, options: &WriteOptions) -> Result<Written, NcError> {
    let stand_alone = options.linuxcnc.stand_alone;
    // Before all else: a tool's length offset, which tip control needs, would be refused first.
    let guided = |block: &Block| matches!(block, Block::TipControlOn(_));
    if let Some(k) = program.blocks().iter().position(guided) {
        return Err(NcError::TipControlNotAvailable { block: k + 1 });
    }
    let mut out = Lines::new(program, options, LINE, ALLOWED, |word| match word {
        Word::Letter(letter) if !stand_alone || "XYZABC".contains(*letter) => Some(letter.to_string()),
        Word::Spindle(spindle) if !stand_alone || *spindle == 0 => Some(format!("${spindle}")),
        _ => None,
    })?;
    let header = program.header();
    out.push_format(format_args!("({})", header.name));
    out.end_line()?;
    out.push("G21 G90 G17 G40 G49 G80 G64 P");
    out.fixed(header.chord_tolerance, PLAIN_DECIMALS);
    out.end_line()?;
    out.push_line("G93")?;
    let mut gear: Option<&Gear> = None;
    let mut netlist = None;
    let mut spindles = 0u8;
    let mut keeper = TimeKeeper::new(program, options);
    for (k, block) in program.blocks().iter().enumerate() {
        out.block = k + 1;
        match block {
            Block::Rapid(target) => {
                out.moded_targets("G0", target)?;
                out.end_line()?;
                keeper.places.update(target);
            }
            Block::Linear { target, duration } => {
                out.moded_targets("G1", target)?;
                out.feed(*duration)?;
                keeper.block(out.block, target, *duration);
            }
            Block::Cubic(_) => {
                return Err(NcError::BlockNotAvailable { block: out.block, what: "cubic of all axes" });
            }
            Block::BSpline(_) => {
                return Err(NcError::BlockNotAvailable { block: out.block, what: "B-spline of all axes" });
            }
            Block::Dwell(duration) => {
                out.push("G4 P");
                out.fixed(*duration, PLAIN_DECIMALS);
                out.end_line()?;
            }
            Block::Spindle { spindle, speed } => {
                if stand_alone && *spindle > 0 {
                    let (axis, word) = ("-".into(), format!("spindle {spindle}").into());
                    return Err(NcError::AxisNotAvailable { axis, word, allowed: ALLOWED });
                }
                spindles |= 1 << spindle;
                if *speed == 0.0 {
                    out.push("M5");
                } else {
                    out.push("S");
                    out.fixed(per_minute(speed.abs()), PLAIN_DECIMALS);
                    out.push(if *speed > 0.0 { " M3" } else { " M4" });
                }
                which_spindle(&mut out, *spindle);
                out.end_line()?;
            }
            Block::Output { number, on } => {
                // With the next motion, so that the path goes on; M64 and M65 switch gears.
                out.push_format(format_args!("M{} P{number}", if *on { 62 } else { 63 }));
                out.end_line()?;
            }
            Block::Comment(text) => {
                // (MSG, ..), (DEBUG, ..), (LOGOPEN, ..): a word before a comma is a command.
                let active = text
                    .split_once(',')
                    .is_some_and(|(word, _)| word.bytes().all(|b| b.is_ascii_alphabetic()));
                if active {
                    let allowed = "no single word before a comma: LinuxCNC carries out such comments";
                    return Err(NcError::BadText { block: out.block, text: text.clone(), allowed });
                }
                out.push_format(format_args!("({text})"));
                out.end_line()?;
            }
            Block::Stop => out.push_line("M0")?,
            Block::End => {
                out.push_line("G94")?;
                out.push_line("M5")?;
                for spindle in (1..8).filter(|spindle| spindles >> spindle & 1 == 1) {
                    out.push("M5");
                    which_spindle(&mut out, spindle);
                    out.end_line()?;
                }
                out.push_line("M2")?;
            }
            Block::GearDefine(defined) => {
                if gear.is_some_and(|gear| gear != &**defined) {
                    let reason = "one netlist runs one gear";
                    return Err(NcError::UnsupportedCoupling { block: out.block, reason });
                }
                gear = Some(defined);
            }
            Block::GearOn { follower, synchronisation } => {
                let (Some(options), Some(gear)) = (&options.linuxcnc.hal, gear) else {
                    let reason =
                        "LinuxCNC has no gear in its programs; the option of a HAL netlist makes one";
                    return Err(NcError::UnsupportedCoupling { block: out.block, reason });
                };
                let made = hal::netlist(&out, gear, synchronisation.as_deref(), options)?;
                if netlist.as_ref().is_some_and(|before| *before != made) {
                    let reason = "one netlist couples at one set of synchronous positions";
                    return Err(NcError::UnsupportedCoupling { block: out.block, reason });
                }
                netlist = Some(made);
                out.push_format(format_args!("M64 P{follower}"));
                out.end_line()?;
                out.loose(*follower);
            }
            Block::GearOff { follower } => {
                out.push_format(format_args!("M65 P{follower}"));
                out.end_line()?;
            }
            Block::Table(_) => {
                let reason = "LinuxCNC has no curve tables";
                return Err(NcError::UnsupportedCoupling { block: out.block, reason });
            }
            Block::Tool { number, length_offset } => {
                if length_offset.is_some() {
                    let what = "length offset of a tool: its axis values have the tool's length in them";
                    return Err(NcError::BlockNotAvailable { block: out.block, what });
                }
                out.push_format(format_args!("T{number} M6"));
                out.end_line()?;
            }
            Block::LengthOffset(length) => {
                match length {
                    Some(length) => out.push_format(format_args!("G43 H{length}")),
                    None => out.push("G49"),
                }
                out.end_line()?;
                out.loose_all();
                keeper.places = Targets::NONE;
            }
            Block::WorkOffset(number) => {
                match number {
                    1..=6 => out.push_format(format_args!("G{}", 53 + number)),
                    7..=9 => out.push_format(format_args!("G59.{}", number - 6)),
                    _ => return Err(out.no_such_offset(*number, "1 to 9: G54 to G59, G59.1 to G59.3")),
                }
                out.end_line()?;
                out.loose_all();
                keeper.places = Targets::NONE;
            }
            Block::Probe(motion) => {
                let place = letter_number(&out, motion.axis)?;
                out.probe("G38.2", motion)?;
                out.push_format(format_args!("#{}=#{}", KEPT + u32::from(motion.slot), PROBED + place));
                out.end_line()?;
                keeper.places = Targets::NONE;
            }
            Block::ShiftOffset(shift) => {
                let place = letter_number(&out, shift.axis)?;
                if shift.number > 9 {
                    return Err(out.no_such_offset(shift.number, "1 to 9: G54 to G59, G59.1 to G59.3"));
                }
                let offset = OFFSETS + 20 * (u32::from(shift.number) - 1) + place;
                let [first, second] = shift.slots.map(|slot| KEPT + u32::from(slot));
                let letter = out.axes[shift.axis].address.clone();
                out.push_format(format_args!(
                    "G10 L2 P{} {letter}[#{offset}+[#{first}+#{second}]/2-[",
                    shift.number
                ));
                out.axis_value(shift.axis, shift.middle);
                out.push_line("]]")?;
                out.loose_all();
                keeper.places = Targets::NONE;
            }
            Block::Coolant(coolant) => out.coolant(*coolant)?,
            Block::TipControlOn(_) | Block::TipControlOff | Block::Tip(_) | Block::TipSpeed(_) => {
                return Err(NcError::TipControlNotAvailable { block: out.block });
            }
        }
    }
    let mut written = out.finish();
    written.hal = netlist;
    written.warnings = keeper.warnings();
    Ok(written)
}

/// Parameters of kept places, of the place at which a probe touched and of the first work offset, each before its first.
const KEPT: u32 = 100;
const PROBED: u32 = 5060;
const OFFSETS: u32 = 5220;

/// Which of X Y Z A B C U V W an axis is, from 1.
fn letter_number(out: &Lines<'_>, axis: usize) -> Result<u32, NcError> {
    let address = &out.axes[axis].address;
    let place = "XYZABCUVW".find(&**address).map(|place| place as u32 + 1);
    place.ok_or_else(|| NcError::AxisNotAvailable {
        axis: out.program.axes()[axis].name.as_str().into(),
        word: address.clone(),
        allowed: "X Y Z A B C U V W",
    })
}

/// The first spindle needs no word.
fn which_spindle(out: &mut Lines<'_>, spindle: u8) {
    if spindle > 0 {
        out.push_format(format_args!(" ${spindle}"));
    }
}

/// Judges whether the control can keep the time of a block with a rotary axis: two servo periods, and no look-ahead over blocks,
/// so that every axis needs l >= 2 v^2/a, that is a time of sqrt(2 l/a).
struct TimeKeeper<'a> {
    accelerations: &'a [f64],
    least: f64,
    rotary: u16,
    places: Targets,
    worst: Option<Warning>,
    worst_share: f64,
    count: usize,
}

impl<'a> TimeKeeper<'a> {
    fn new(program: &Program, options: &'a WriteOptions) -> Self {
        let rotary = program.axes().iter().enumerate().filter(|(_, axis)| axis.motion == AxisMotion::Rotary);
        Self {
            accelerations: &options.linuxcnc.accelerations,
            least: 2.0 * options.linuxcnc.servo_period,
            rotary: rotary.fold(0, |mask, (index, _)| mask | 1 << index),
            places: Targets::NONE,
            worst: None,
            worst_share: 1.0 - 1e-9,
            count: 0,
        }
    }

    fn block(&mut self, block: usize, target: &Targets, duration: f64) {
        // Without limits nothing was asked.
        if target.mask() & self.rotary != 0 && !self.accelerations.is_empty() {
            let ways = target.iter().filter_map(|(axis, to)| {
                let (from, limit) = (self.places.get(axis)?, self.accelerations.get(axis)?);
                Some((2.0 * (to - from).abs() / limit).sqrt())
            });
            let least = ways.fold(self.least, f64::max);
            if duration < least * (1.0 - 1e-9) {
                self.count += 1;
                if duration / least < self.worst_share {
                    self.worst_share = duration / least;
                    self.worst = Some(Warning::TimeNotKept { count: 0, worst_block: block, duration, least });
                }
            }
        }
        self.places.update(target);
    }

    fn warnings(self) -> Vec<Warning> {
        let count = self.count;
        let counted = self.worst.map(|Warning::TimeNotKept { worst_block, duration, least, .. }| {
            Warning::TimeNotKept { count, worst_block, duration, least }
        });
        counted.into_iter().collect()
    }
}
