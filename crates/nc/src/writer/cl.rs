//! Cutter locations as text in the words of APT (`docs/mathematics/programs.md#cutters`): what postprocessors of other systems read. One
//! record a line; lengths in mm with five decimals, directions with seven.
//!
//! ```text
//! PARTNO/NAME                     UNITS/MM                    TOOL/MILL,diameter,corner radius,cutting length
//! LOADTL/number,OSETNO,offset     SPINDL/RPM,speed,CLW        SPINDL/OFF      DELAY/seconds   STOP   PPRINT/text
//! COOLNT/FLOOD   COOLNT/MIST      COOLNT/OFF
//! MULTAX/ON   MULTAX/OFF          FEDRAT/speed,MMPM           FEDRAT/feed,INVERS (of the next GOTO, 1/min)
//! RAPID (the next GOTO)           GOTO/x,y,z,i,j,k            FINI
//! ```

use super::lines::per_minute;
use super::number::push_fixed;
use super::options::{Decimals, TipDecimals, WriteOptions};
use crate::{Block, Coolant, NcError, Orientation, Pace, Program, TipControl, TipMotion};
use std::io::Write as _;

/// The cutter as a CL text names it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ClCutter {
    /// Diameter, mm, above 0.
    pub diameter: f64,
    /// Radius of the corner, mm, 0 to half the diameter.
    pub corner_radius: f64,
    /// Cutting length, mm, above 0.
    pub cutting_length: f64,
}

/// How far a corner's radius may be beyond half the diameter: both may have been rounded.
const SLACK: f64 = 1e-5;

/// Decimals of a CL text.
pub(crate) fn cl_options() -> WriteOptions {
    WriteOptions {
        decimals: Decimals { mm: 5, deg: 9, feed: 6 },
        tip_decimals: TipDecimals { speed: 4, direction: 7 },
        ..WriteOptions::default()
    }
}

/// The cutter locations of a program whose motions are all under tip control by directions. Who writes it to a file takes
/// [`crate::write_cl_checked`] instead.
///
/// # Errors
/// `BlockNotAvailable` for axis values, angles, gears, tables and a second spindle, `BadText` for a comment with a dollar sign,
/// `NumberRange` for a cutter that cannot be.
pub fn write_cl(program: &Program, cutter: Option<&ClCutter>) -> Result<String, NcError> {
    let options = cl_options();
    let (place, part) = (options.decimals.mm, options.tip_decimals.direction);
    let mut text = Vec::with_capacity(64 * program.blocks().len() + 256);
    // Writing into memory does not fail.
    macro_rules! line {
        ($($arguments:tt)*) => { drop(writeln!(text, $($arguments)*)) };
    }
    line!("PARTNO/{}", program.header().name);
    line!("UNITS/MM");
    if let Some(cutter) = cutter {
        check(cutter)?;
        text.extend_from_slice(b"TOOL/MILL");
        for length in [cutter.diameter, cutter.corner_radius, cutter.cutting_length] {
            text.push(b',');
            push_fixed(&mut text, length, place);
        }
        text.push(b'\n');
    }
    // The last FEDRAT, which holds on.
    let (mut fedrat, mut next) = (Vec::new(), Vec::new());
    for block in resolved(program)? {
        match block {
            Block::Tool { number, length_offset: None } => line!("LOADTL/{number}"),
            Block::Tool { number, length_offset: Some(offset) } => {
                line!("LOADTL/{number},OSETNO,{offset}");
            }
            Block::Spindle { speed: 0.0, .. } => line!("SPINDL/OFF"),
            Block::Spindle { speed, .. } => {
                text.extend_from_slice(b"SPINDL/RPM,");
                push_fixed(&mut text, per_minute(speed.abs()), 6);
                line!(",{}", if speed > 0.0 { "CLW" } else { "CCLW" });
            }
            Block::Coolant(coolant) => line!(
                "COOLNT/{}",
                match coolant {
                    Coolant::Off => "OFF",
                    Coolant::Flood => "FLOOD",
                    Coolant::Mist => "MIST",
                }
            ),
            Block::Dwell(seconds) => {
                text.extend_from_slice(b"DELAY/");
                push_fixed(&mut text, seconds, 6);
                line!("");
            }
            Block::Comment(comment) => line!("PPRINT/{comment}"),
            Block::Stop => line!("STOP"),
            Block::End => line!("FINI"),
            Block::TipControlOn(_) => line!("MULTAX/ON"),
            Block::TipControlOff => line!("MULTAX/OFF"),
            Block::Tip(motion) => {
                next.clear();
                match motion.pace {
                    Pace::Rapid => line!("RAPID"),
                    Pace::Speed(speed) => {
                        next.extend_from_slice(b"FEDRAT/");
                        push_fixed(&mut next, speed * 60.0, options.tip_decimals.speed);
                        next.extend_from_slice(b",MMPM\n");
                        if next != fedrat {
                            text.extend_from_slice(&next);
                            std::mem::swap(&mut fedrat, &mut next);
                        }
                    }
                    Pace::Duration(duration) => {
                        let feed = 60.0 / duration;
                        let decimals = options.decimals.feed;
                        text.extend_from_slice(b"FEDRAT/");
                        push_fixed(&mut text, feed, if feed < 1.0 { decimals + 4 } else { decimals });
                        line!(",INVERS");
                        fedrat.clear();
                    }
                    Pace::Kept => {}
                }
                text.extend_from_slice(b"GOTO/");
                let direction =
                    if let Orientation::Direction(parts) = motion.orientation { parts } else { [0.0; 3] };
                let values = motion.tip.map(|value| (value, place)).into_iter();
                for (n, (value, decimals)) in values.chain(direction.map(|value| (value, part))).enumerate() {
                    if n > 0 {
                        text.push(b',');
                    }
                    push_fixed(&mut text, value, decimals);
                }
                text.push(b'\n');
            }
            _ => {}
        }
    }
    // ASCII by construction: names and comments are checked, the rest is written here.
    Ok(String::from_utf8(text).unwrap_or_else(|error| String::from_utf8_lossy(error.as_bytes()).into_owned()))
}

fn check(cutter: &ClCutter) -> Result<(), NcError> {
    let ClCutter { diameter, corner_radius, cutting_length } = *cutter;
    let cases = [
        ("diameter of the cutter", diameter, (1e-4..=1e4).contains(&diameter), "0.0001 to 10000 mm"),
        (
            "corner radius of the cutter",
            corner_radius,
            (0.0..=0.5 * diameter + SLACK).contains(&corner_radius),
            "0 to half the diameter",
        ),
        ("cutting length", cutting_length, (1e-4..=1e4).contains(&cutting_length), "0.0001 to 10000 mm"),
    ];
    for (name, value, fits, allowed) in cases {
        if !fits {
            return Err(NcError::NumberRange { block: 0, axis: name.into(), value, allowed });
        }
    }
    Ok(())
}

/// The blocks with every direction and every speed where it holds, so that what is kept does not matter.
///
/// # Errors
/// As [`write_cl`].
pub(crate) fn resolved(program: &Program) -> Result<Vec<Block>, NcError> {
    let mut blocks = Vec::with_capacity(program.blocks().len());
    let (mut orientation, mut pace) = (Orientation::Kept, Pace::Kept);
    for (k, block) in program.blocks().iter().enumerate() {
        let refused = |what| Err(NcError::BlockNotAvailable { block: k + 1, what });
        match block {
            Block::Tip(motion) => {
                if motion.orientation != Orientation::Kept {
                    orientation = motion.orientation;
                }
                if let Pace::Speed(_) = motion.pace {
                    pace = motion.pace;
                }
                let here = if motion.pace == Pace::Kept { pace } else { motion.pace };
                blocks.push(Block::Tip(TipMotion { tip: motion.tip, orientation, pace: here }));
            }
            Block::TipSpeed(speed) => pace = Pace::Speed(*speed),
            Block::TipControlOn(TipControl::Angles) => {
                return refused("angles of rotary axes: cutter locations have directions");
            }
            Block::Comment(comment) if comment.contains('$') => {
                let allowed = "no dollar sign, which ends a record of a CL text";
                return Err(NcError::BadText { block: k + 1, text: comment.clone(), allowed });
            }
            Block::Spindle { spindle: 1.., .. } => {
                return refused("second spindle: cutter locations have one");
            }
            Block::Tool { .. }
            | Block::TipControlOn(TipControl::Directions)
            | Block::TipControlOff
            | Block::Spindle { .. }
            | Block::Dwell(_)
            | Block::Coolant(_)
            | Block::Comment(_)
            | Block::Stop
            | Block::End => blocks.push(block.clone()),
            _ => return refused("motions of axes and couplings: cutter locations are of the tip"),
        }
    }
    Ok(blocks)
}
