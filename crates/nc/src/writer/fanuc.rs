//! Fanuc 30i family, `docs/mathematics/programs.md#the-independent-reader`: straight blocks, tool tips, and the gear of a hobbing machine,
//! which is given by the bodies. What is not confirmed stands in `unconfirmed.rs`.

use super::lines::{Lines, PLAIN_DECIMALS, per_minute};
use super::unconfirmed::{
    FANUC_CONTOUR_OFF, FANUC_CONTOUR_ON, FANUC_DWELL, FANUC_FIRST_OUTPUT, FANUC_KEPT, FANUC_LINE,
    FANUC_MORE_OFFSETS, FANUC_NO_TOUCH, FANUC_OFFSETS, FANUC_PREAMBLE, FANUC_READ_NO_FURTHER,
    FANUC_SKIP_POSITION, FANUC_SPINDLE_WORD, FANUC_TOOL_CHANGE, is_fanuc_comment,
};
use super::{WriteOptions, Written};
use crate::{Block, Coupling, Gear, MAXIMUM_AXES, NcError, Program, TipControl, ToothData, Word};

/// A lead ratio may differ from that of the bodies by this share: rounding by the program that computed it.
const SAME_LEAD: f64 = 1e-9;

pub(super) fn write(program: &Program, options: &WriteOptions) -> Result<Written, NcError> {
    let allowed = "X Y Z A B C U V W, spindles";
    let mut out = Lines::new(program, options, FANUC_LINE, allowed, |word| match word {
        Word::Letter(letter) => Some(letter.to_string()),
        Word::Spindle(spindle) => Some(format!("S{spindle}")),
        Word::Named(_) => None,
    })?;
    let number = options.fanuc.program_number;
    out.push_line("%")?;
    if number < 10_000 {
        out.push_format(format_args!("O{number:04}"));
    } else {
        out.push_format(format_args!("O{number:08}"));
    }
    out.push_format(format_args!(" ({})", program.header().name.replace('_', " ")));
    out.end_line()?;
    out.push_line(FANUC_PREAMBLE)?;
    if options.fanuc.contour_mode {
        out.push_line(FANUC_CONTOUR_ON)?;
    }
    out.push_line("G93")?;
    let mut gears: [Option<&Gear>; MAXIMUM_AXES] = [None; MAXIMUM_AXES];
    let mut spindles = 0u8;
    let mut offset = 0;
    for (k, block) in program.blocks().iter().enumerate() {
        out.block = k + 1;
        match block {
            Block::Rapid(target) => {
                out.moded_targets("G0", target)?;
                out.end_line()?;
            }
            Block::Linear { target, duration } => {
                out.moded_targets("G1", target)?;
                out.feed(*duration)?;
            }
            Block::Cubic(_) => {
                return Err(NcError::BlockNotAvailable { block: out.block, what: "cubic of all axes" });
            }
            Block::BSpline(_) => {
                return Err(NcError::BlockNotAvailable { block: out.block, what: "B-spline of all axes" });
            }
            Block::Dwell(duration) => {
                out.push(FANUC_DWELL);
                out.fixed(*duration, PLAIN_DECIMALS);
                out.end_line()?;
            }
            Block::Spindle { spindle, speed } => {
                spindles |= 1 << spindle;
                turn(&mut out, *spindle, *speed)?;
            }
            Block::Output { number, on } => {
                out.push_line(FANUC_READ_NO_FURTHER)?;
                let (variable, value) = (FANUC_FIRST_OUTPUT + u16::from(*number), u8::from(*on));
                out.push_format(format_args!("#{variable}={value}"));
                out.end_line()?;
            }
            Block::Comment(text) => {
                if !text.bytes().all(is_fanuc_comment) {
                    let allowed = "A-Z, 0-9 and blanks";
                    return Err(NcError::BadText { block: out.block, text: text.clone(), allowed });
                }
                out.push_format(format_args!("({text})"));
                out.end_line()?;
            }
            Block::Stop => out.push_line("M0")?,
            Block::End => {
                out.push_line("G94")?;
                for spindle in (0..8).filter(|spindle| *spindle == 0 || spindles >> spindle & 1 == 1) {
                    turn(&mut out, spindle, 0.0)?;
                }
                if options.fanuc.contour_mode {
                    out.push_line(FANUC_CONTOUR_OFF)?;
                }
                out.push_line("M30")?;
                out.push_line("%")?;
            }
            Block::GearDefine(gear) => {
                gear_words(&mut out, gear)?;
                gears[gear.follower] = Some(gear);
            }
            Block::GearOn { follower, synchronisation } => {
                let Some(gear) = gears[*follower] else { continue };
                if synchronisation.is_some() {
                    let reason = "G81 couples the axes as they stand, not at synchronous positions";
                    return Err(NcError::UnsupportedCoupling { block: out.block, reason });
                }
                let words = gear_words(&mut out, gear)?;
                out.push_line(&words)?;
                out.loose(*follower);
            }
            Block::GearOff { .. } => out.push_line("G80")?,
            Block::Table(_) => {
                let reason = "G81 has no curve tables";
                return Err(NcError::UnsupportedCoupling { block: out.block, reason });
            }
            Block::Tool { number, length_offset } => {
                offset = length_offset.unwrap_or_default();
                out.push_format(format_args!("T{number}"));
                out.push_line(FANUC_TOOL_CHANGE)?;
            }
            Block::LengthOffset(length) => {
                match length {
                    Some(length) => out.push_format(format_args!("G43 H{length}")),
                    None => out.push("G49"),
                }
                out.end_line()?;
                out.loose_all();
            }
            Block::WorkOffset(number) => {
                match number {
                    1..=6 => out.push_format(format_args!("G{}", 53 + number)),
                    7..=306 => out.push_format(format_args!("G54.1 P{}", number - 6)),
                    _ => return Err(out.no_such_offset(*number, "1 to 306: G54 to G59, G54.1 P1 to P300")),
                }
                out.end_line()?;
                out.loose_all();
            }
            Block::Probe(motion) => {
                out.probe("G31", motion)?;
                // The skip position is the end of the block where nothing was touched.
                let place = FANUC_SKIP_POSITION + motion.axis;
                out.push_format(format_args!("IF[ABS[#{place}-["));
                out.axis_value(motion.axis, motion.to);
                out.push_line(FANUC_NO_TOUCH)?;
                out.push_format(format_args!("#{}=#{place}", FANUC_KEPT + u16::from(motion.slot)));
                out.end_line()?;
            }
            Block::ShiftOffset(shift) => {
                let (word, number, first) = match shift.number {
                    1..=6 => ("L2", shift.number, FANUC_OFFSETS + 20 * (usize::from(shift.number) - 1)),
                    7..=54 => {
                        ("L20", shift.number - 6, FANUC_MORE_OFFSETS + 20 * (usize::from(shift.number) - 7))
                    }
                    _ => {
                        return Err(out.no_such_offset(
                            shift.number,
                            "1 to 54 where it is measured: G54 to G59, G54.1 P1 to P48",
                        ));
                    }
                };
                let [first_slot, second_slot] = shift.slots.map(|slot| FANUC_KEPT + u16::from(slot));
                let letter = out.axes[shift.axis].address.clone();
                out.push_format(format_args!(
                    "G90 G10 {word} P{number} {letter}[#{}+[#{first_slot}+#{second_slot}]/2.-[",
                    first + shift.axis
                ));
                out.axis_value(shift.axis, shift.middle);
                out.push_line("]]")?;
                out.loose_all();
            }
            Block::Coolant(coolant) => out.coolant(*coolant)?,
            Block::TipControlOn(control) => {
                let code = if *control == TipControl::Angles { "G43.4" } else { "G43.5" };
                // A program has an offset before it has tip control.
                out.push_format(format_args!("{code} H{offset}"));
                out.end_line()?;
            }
            Block::TipControlOff => {
                out.push_line("G49")?;
                out.loose_all();
            }
            Block::Tip(motion) => out.tip(motion, [" I", " J", " K"])?,
            Block::TipSpeed(speed) => out.tip_speed(*speed)?,
        }
    }
    Ok(out.finish())
}

/// A spindle word; the speed must be whole revolutions per minute.
fn turn(out: &mut Lines<'_>, spindle: u8, speed: f64) -> Result<(), NcError> {
    if speed == 0.0 {
        out.push("M5");
    } else {
        let shown = per_minute(speed);
        let whole = shown.abs().round();
        if (shown.abs() - whole).abs() > 1e-6 || whole < 1.0 {
            let axis = format!("speed of spindle {spindle}").into();
            let allowed = "whole numbers of 1/min";
            return Err(NcError::NumberRange { block: out.block, axis, value: shown, allowed });
        }
        out.push_format(format_args!("S{whole:.0} {}", if speed > 0.0 { "M3" } else { "M4" }));
    }
    if spindle > 0 {
        out.push_format(format_args!(" {FANUC_SPINDLE_WORD}{}", u16::from(spindle) + 1));
    }
    out.end_line()
}

/// `G81 T L Q P`: spindle 0 drives C by threads/teeth, and Z adds the lead of the helix.
fn gear_words(out: &mut Lines<'_>, gear: &Gear) -> Result<String, NcError> {
    let block = out.block;
    let refused = |reason| Err(NcError::UnsupportedCoupling { block, reason });
    let axes = out.program.axes();
    if axes[gear.follower].word != Word::Letter('C') {
        return refused("G81 couples the axis C");
    }
    let Some(teeth) = gear.teeth else {
        return refused("G81 needs teeth, threads, module and helix angle, which are not given");
    };
    let (mut tool, mut lead) = (None, None);
    for leader in &gear.leaders {
        let place = match (&axes[leader.axis].word, leader.coupling) {
            (Word::Spindle(0), Coupling::Ratio { num, den }) => (&mut tool, num, den),
            (Word::Letter('Z'), Coupling::Ratio { num, den }) => (&mut lead, num, den),
            _ => return refused("G81 follows spindle 0 and Z only, by ratios: no shift and no table"),
        };
        *place.0 = Some((place.1, place.2));
    }
    let Some((num, den)) = tool else {
        return refused("G81 follows spindle 0, which does not lead this gear");
    };
    if num * f64::from(teeth.teeth) != den * f64::from(teeth.threads) {
        return refused("the ratio to the spindle is not that of threads to teeth");
    }
    let ToothData { teeth: t, threads: l, normal_module: q, helix_angle } = teeth;
    let p = helix_angle.to_degrees();
    range(block, t, l, q, p)?;
    let Some((num, den)) = lead else { return Ok(format!("G81 T{t} L{l}")) };
    let by_bodies = |angle: f64| 2.0 * angle.sin() / (q * f64::from(t));
    let (given, wanted) = (num / den, by_bodies(helix_angle));
    // Written so that NaN fails.
    let same = (given - wanted).abs() <= SAME_LEAD * wanted.abs();
    if !same {
        return refused("the ratio to Z is not that of module, teeth and helix angle");
    }
    // Q to 0.00001 mm, P to 0.0001 deg: what that does to the lead is reported.
    let (q_text, p_text) = (format!("{q:.5}"), format!("{p:.4}"));
    let p_text = if p_text == "-0.0000" { "0.0000".to_owned() } else { p_text };
    if let (Ok(q), Ok(p)) = (q_text.parse::<f64>(), p_text.parse::<f64>()) {
        let kept = 2.0 * p.to_radians().sin() / (q * f64::from(t));
        out.lead_ratio = out.lead_ratio.max((kept - given).abs());
    }
    Ok(format!("G81 T{t} L{l} Q{q_text} P{p_text}"))
}

fn range(block: usize, teeth: u32, threads: i32, module: f64, helix_angle: f64) -> Result<(), NcError> {
    let cases = [
        (
            "T (teeth of the workpiece)",
            f64::from(teeth),
            (1.0..=1000.0).contains(&f64::from(teeth)),
            "1 to 1000",
        ),
        (
            "L (threads of the worm)",
            f64::from(threads),
            (1..=21).contains(&threads.unsigned_abs()),
            "-21 to 21 without 0",
        ),
        ("Q (normal module)", module, (0.1..=25.0).contains(&module), "0.1 to 25 mm"),
        ("P (helix angle)", helix_angle, (-90.0..=90.0).contains(&helix_angle), "-90 to 90 deg"),
    ];
    for (quantity, value, fits, allowed) in cases {
        if !fits {
            return Err(NcError::RatioRange { block, quantity, value, allowed });
        }
    }
    Ok(())
}
