//! What a program must keep whatever control it is for (`docs/mathematics/programs.md#limits`): indices, ranges, order of the gears,
//! tables, texts. Knows no dialect.

use super::check_state::{GearPlace, SPINDLES, State, TipState};
use super::{
    AxisMotion, AxisWord, BSplineMotion, Block, Coupling, CubicMotion, CurveTable, Gear, GearSynchronisation,
    Header, MAXIMUM_AXES, OffsetShift, ProbeMove, Repetition, SLOTS, Targets, WORK_OFFSETS, Word,
};
use crate::NcError;
use std::collections::BTreeMap;

/// Shortest and longest time of a block, s: F = 60/s from 1e9 down to 1e-4.
const DURATION: [f64; 2] = [60.0 / 1e9, 60.0 / 1e-4];
/// Shortest and longest dwell, s: six decimals are written.
const DWELL: [f64; 2] = [1e-6, 1e5];
/// Numerators and denominators of gears, and how far apart they may be: what fits in the eighteen digits that a reader takes.
const RATIO: [f64; 2] = [1e-12, 1e13];
const RATIO_SPREAD: f64 = 1e15;
/// Least step of a leader in a table, mm or rad: ten decimals are written.
const LEADER_STEP: f64 = 1e-9;
/// Spindle speeds that a text with six decimals still tells from a standstill, 1/min.
const SPEED: [f64; 2] = [1e-4, 1e6];
/// Longest text of a comment: what the shortest line of all controls (252) leaves.
const COMMENT: usize = 200;
const COMMENT_ALLOWED: &str =
    "1 to 200 printable ASCII characters without brackets, semicolons, percent signs and blanks at the ends";

/// Checks everything; the first fault is returned.
pub(super) fn check(header: &Header, blocks: &[Block]) -> Result<(), NcError> {
    check_header(header)?;
    let mut state = State {
        axes: &header.axes,
        known: 0,
        gears: [const { GearPlace::Absent }; MAXIMUM_AXES],
        tables: BTreeMap::new(),
        speeds: [0.0; SPINDLES],
        switched: 0,
        tip: TipState::default(),
        probed: 0,
        block: 0,
    };
    for (k, block) in blocks.iter().enumerate() {
        state.block = k + 1;
        state.block(block, k + 1 == blocks.len())?;
    }
    if blocks.is_empty() { Err(NcError::EndMisplaced { block: 1 }) } else { Ok(()) }
}

/// Outputs that all controls have: Siemens counts from 1, Fanuc has #1100 to #1115.
const OUTPUTS: std::ops::RangeInclusive<u8> = 1..=15;

fn check_header(header: &Header) -> Result<(), NcError> {
    let bad = |reason: String| Err(NcError::BadHeader { reason: reason.into() });
    check_name(&header.name)?;
    let tolerance = header.chord_tolerance;
    if !(1e-6..=1.0).contains(&tolerance) {
        return bad(format!("chord tolerance {tolerance} mm; allowed: 1e-6 to 1 mm"));
    }
    if header.axes.is_empty() || header.axes.len() > MAXIMUM_AXES {
        return bad(format!("{} axes; allowed: 1 to {MAXIMUM_AXES}", header.axes.len()));
    }
    for (k, axis) in header.axes.iter().enumerate() {
        check_name(&axis.name)?;
        for other in &header.axes[..k] {
            if other.name == axis.name || other.word == axis.word {
                return bad(format!("axes {} and {} share a name or a word", other.name, axis.name));
            }
        }
        let fits = match &axis.word {
            Word::Letter(letter) => "XYZABCUVW".contains(*letter),
            Word::Named(name) => is_address(name),
            Word::Spindle(spindle) => usize::from(*spindle) < SPINDLES && axis.motion == AxisMotion::Rotary,
        };
        if !fits {
            return bad(format!(
                "axis {} has the word {:?}; allowed: a letter of XYZABCUVW, an address such as B1, a turning spindle 0 to 7",
                axis.name, axis.word
            ));
        }
    }
    Ok(())
}

/// An address that no control takes for a word of its own: a single letter of those with a number is G1, M3, R1, S1 and so on.
fn is_address(name: &str) -> bool {
    let bytes = name.as_bytes();
    let letters = bytes.iter().take_while(|byte| byte.is_ascii_uppercase()).count();
    let digits = bytes.len() - letters;
    (2..=8).contains(&bytes.len())
        && letters >= 1
        && (1..=3).contains(&digits)
        && bytes[letters..].iter().all(u8::is_ascii_digit)
        && !(letters == 1 && b"DEFGHIJKLMNOPQRST".contains(&bytes[0]))
}

fn check_name(name: &str) -> Result<(), NcError> {
    let fits = (1..=24).contains(&name.len())
        && name.bytes().all(|byte| byte.is_ascii_uppercase() || byte.is_ascii_digit() || byte == b'_');
    if fits {
        return Ok(());
    }
    Err(NcError::BadText {
        block: 0,
        text: shortened(name),
        allowed: "a name of 1 to 24 characters of A-Z, 0-9 and _",
    })
}

/// A text as a message may quote it.
fn shortened(text: &str) -> Box<str> {
    text.chars().take(40).collect::<String>().into()
}

impl State<'_> {
    fn block(&mut self, block: &Block, last: bool) -> Result<(), NcError> {
        let here = self.block;
        if matches!(block, Block::End) != last {
            return Err(NcError::EndMisplaced { block: here });
        }
        self.fits_tip_control(block)?;
        if block.moves() {
            self.switched = 0;
        }
        match block {
            Block::Rapid(target) => {
                self.targets(target)?;
                self.known |= target.mask();
            }
            Block::Linear { target, duration } => {
                self.feed(*duration)?;
                self.targets(target)?;
                self.known |= target.mask();
            }
            Block::Cubic(motion) => self.cubic(motion)?,
            Block::BSpline(motion) => self.spline(motion)?,
            Block::Dwell(seconds) => {
                if !(DWELL[0]..=DWELL[1]).contains(seconds) {
                    let (axis, allowed) = ("dwell".into(), "0.000001 to 100000 s");
                    return Err(NcError::NumberRange { block: here, axis, value: *seconds, allowed });
                }
            }
            Block::Spindle { spindle, speed } => self.spindle(*spindle, *speed)?,
            Block::Comment(text) => {
                let fits = (1..=COMMENT).contains(&text.len())
                    && text.bytes().all(|byte| (b' '..=b'~').contains(&byte) && !b"()[]{};%".contains(&byte))
                    && text.trim_matches(' ') == &**text;
                if !fits {
                    return Err(NcError::BadText {
                        block: here,
                        text: shortened(text),
                        allowed: COMMENT_ALLOWED,
                    });
                }
            }
            Block::Stop => {}
            Block::Output { number, .. } => self.output(*number)?,
            Block::End => {
                if self.switched != 0 {
                    return Err(
                        self.output_state("is switched after the last motion, and waits for another one")
                    );
                }
                if let Some(axis) = self.gears.iter().position(|gear| matches!(gear, GearPlace::On(_))) {
                    return Err(self.gear_state(axis, "is still on at the end"));
                }
            }
            Block::GearDefine(gear) => self.define(gear)?,
            Block::GearOn { follower, synchronisation } => {
                self.couple(*follower, synchronisation.as_deref())?
            }
            Block::GearOff { follower } => {
                self.movable(*follower)?;
                let place = std::mem::replace(&mut self.gears[*follower], GearPlace::Absent);
                self.gears[*follower] = match place {
                    GearPlace::On(leaders) => GearPlace::Defined(leaders),
                    _ => return Err(self.gear_state(*follower, "is not on")),
                };
            }
            Block::Table(table) => self.table(table)?,
            Block::Coolant(_) => {}
            Block::Probe(motion) => self.probe(motion)?,
            Block::ShiftOffset(shift) => self.shift_offset(shift)?,
            Block::WorkOffset(number) => {
                if !WORK_OFFSETS.contains(number) {
                    let (axis, value) = ("work offset".into(), f64::from(*number));
                    return Err(NcError::NumberRange {
                        block: here,
                        axis,
                        value,
                        allowed: "work offsets 1 to 354",
                    });
                }
                // The axes stand elsewhere in the new count.
                self.known = 0;
            }
            Block::Tool { .. }
            | Block::LengthOffset(_)
            | Block::TipControlOn(_)
            | Block::TipControlOff
            | Block::Tip(_)
            | Block::TipSpeed(_) => self.tip_block(block)?,
        }
        Ok(())
    }

    fn probe(&mut self, motion: &ProbeMove) -> Result<(), NcError> {
        let axis = self.movable(motion.axis)?;
        self.value(axis, motion.to)?;
        let name = axis.name.as_str().into();
        let shown =
            60.0 * if axis.motion == AxisMotion::Rotary { motion.speed.to_degrees() } else { motion.speed };
        if !(0.1..=1e6).contains(&shown) {
            let allowed = "probing speeds of 0.1 to 1e6 mm/min or deg/min";
            return Err(NcError::NumberRange { block: self.block, axis: name, value: shown, allowed });
        }
        self.slot(motion.slot)?;
        self.known(motion.axis)?;
        self.probed |= 1 << motion.slot;
        // It stops wherever it touches.
        self.known &= !(1 << motion.axis);
        Ok(())
    }

    fn slot(&self, slot: u8) -> Result<(), NcError> {
        if SLOTS.contains(&slot) {
            return Ok(());
        }
        let (axis, value) = ("number of a probed place".into(), slot.into());
        Err(NcError::NumberRange { block: self.block, axis, value, allowed: "1 to 9" })
    }

    fn shift_offset(&mut self, shift: &OffsetShift) -> Result<(), NcError> {
        let axis = self.movable(shift.axis)?;
        self.value(axis, shift.middle)?;
        for slot in shift.slots {
            self.slot(slot)?;
            if self.probed >> slot & 1 == 0 {
                let (axis, value) = ("number of a probed place".into(), slot.into());
                let allowed = "places that were probed before";
                return Err(NcError::NumberRange { block: self.block, axis, value, allowed });
            }
        }
        if !WORK_OFFSETS.contains(&shift.number) {
            let (axis, value) = ("work offset".into(), f64::from(shift.number));
            let allowed = "work offsets 1 to 354";
            return Err(NcError::NumberRange { block: self.block, axis, value, allowed });
        }
        self.known = 0;
        Ok(())
    }

    fn output(&mut self, number: u8) -> Result<(), NcError> {
        if !OUTPUTS.contains(&number) {
            let (axis, value) = ("number of the output".into(), number.into());
            return Err(NcError::NumberRange { block: self.block, axis, value, allowed: "outputs 1 to 15" });
        }
        if self.switched >> number & 1 == 1 {
            return Err(self.output_state("is switched twice with the same motion"));
        }
        self.switched |= 1 << number;
        Ok(())
    }

    fn output_state(&self, reason: &'static str) -> NcError {
        NcError::OutputState { block: self.block, reason }
    }

    /// Whether a gear is on.
    pub(super) fn is_coupled(&self) -> bool {
        self.gears.iter().any(|gear| matches!(gear, GearPlace::On(_)))
    }

    fn gear_state(&self, axis: usize, reason: &'static str) -> NcError {
        let axis = self.axes.get(axis).map_or("?", |axis| &axis.name).into();
        NcError::GearState { block: self.block, axis, reason }
    }

    /// An axis of the program.
    fn axis(&self, index: usize) -> Result<&AxisWord, NcError> {
        self.axes.get(index).ok_or(NcError::UnknownAxis { block: self.block, index, count: self.axes.len() })
    }

    /// An axis that is no spindle.
    pub(super) fn movable(&self, index: usize) -> Result<&AxisWord, NcError> {
        let axis = self.axis(index)?;
        match axis.word {
            Word::Spindle(_) => {
                Err(NcError::NotMovable { block: self.block, axis: axis.name.as_str().into() })
            }
            _ => Ok(axis),
        }
    }

    /// A value of an axis, mm or rad.
    pub(super) fn value(&self, axis: &AxisWord, value: f64) -> Result<(), NcError> {
        let (shown, limit, allowed) = match axis.motion {
            AxisMotion::Linear => (value, 999_999.999_999, "-999999.999999 to 999999.999999 mm"),
            AxisMotion::Rotary => (value.to_degrees(), 99_999_999.0, "-99999999 to 99999999 deg"),
        };
        // Written so that NaN fails.
        if shown.abs() <= limit {
            return Ok(());
        }
        Err(NcError::NumberRange {
            block: self.block,
            axis: axis.name.as_str().into(),
            value: shown,
            allowed,
        })
    }

    fn targets(&self, targets: &Targets) -> Result<(), NcError> {
        if targets.is_empty() {
            return Err(NcError::EmptyMotion { block: self.block });
        }
        targets.iter().try_for_each(|(index, value)| self.value(self.movable(index)?, value))
    }

    pub(super) fn duration(&self, duration: f64) -> Result<(), NcError> {
        if (DURATION[0]..=DURATION[1]).contains(&duration) {
            return Ok(());
        }
        Err(NcError::FeedRange { block: self.block, duration })
    }

    /// A motion with feed: its time, and spindles that lead a gear must turn.
    fn feed(&self, duration: f64) -> Result<(), NcError> {
        self.duration(duration)?;
        for gear in &self.gears {
            let GearPlace::On(leaders) = gear else { continue };
            for &leader in leaders {
                if let Word::Spindle(spindle) = self.axis(leader)?.word
                    && self.speeds[usize::from(spindle)] == 0.0
                {
                    return Err(NcError::SpindleStopped { block: self.block, spindle });
                }
            }
        }
        Ok(())
    }

    fn known(&self, index: usize) -> Result<(), NcError> {
        if self.known >> index & 1 == 1 {
            return Ok(());
        }
        Err(NcError::UnknownStart { block: self.block, axis: self.axis(index)?.name.as_str().into() })
    }

    fn cubic(&mut self, motion: &CubicMotion) -> Result<(), NcError> {
        self.feed(motion.duration)?;
        if motion.spans.is_empty() || !motion.spans.is_sorted_by(|a, b| a.0 < b.0) {
            return Err(NcError::EmptyMotion { block: self.block });
        }
        for (index, span) in &motion.spans {
            let axis = self.movable(*index)?;
            self.known(*index)?;
            for value in [span.end, span.start_slope, span.end_slope] {
                self.value(axis, value)?;
            }
        }
        Ok(())
    }

    fn spline(&mut self, motion: &BSplineMotion) -> Result<(), NcError> {
        self.feed(motion.duration)?;
        // A control that takes one line for each point shares the time among them.
        self.duration(motion.duration / motion.points.len().max(1) as f64)?;
        let (block, degree) = (self.block, motion.degree);
        let bad = |reason| Err(NcError::BadSpline { block, reason });
        if !(2..=3).contains(&degree) {
            return Err(NcError::DegreeNotSupported { block, degree, allowed: "2 or 3" });
        }
        if motion.points.len() < degree {
            return bad("a B-spline of too few control points");
        }
        let mask = motion.points[0].mask();
        if motion.points.iter().any(|point| point.mask() != mask) {
            return bad("control points of a B-spline that name different axes");
        }
        for point in &motion.points {
            self.targets(point)?;
        }
        motion.points[0].iter().try_for_each(|(axis, _)| self.known(axis))?;
        let (knots, count) = (&motion.knots, motion.points.len() + 1);
        if knots.len() != count + degree + 1 {
            return bad("a B-spline whose numbers of points and knots do not belong together");
        }
        if !knots.iter().all(|knot| knot.abs() <= 1e9) || !knots.is_sorted() {
            return bad("knots of a B-spline that are not finite and ascending");
        }
        let clamped = knots[0] == knots[degree] && knots[count] == knots[count + degree];
        // Inner knots may be double (degree 2) or triple (degree 3) at most: beyond that the curve falls apart.
        let apart = (1..count).any(|k| knots[k] == knots[k + degree]) || knots[0] == knots[count];
        if !clamped || apart {
            return bad("a B-spline that is not clamped at both ends, or that falls apart at a knot");
        }
        Ok(())
    }

    fn spindle(&mut self, spindle: u8, speed: f64) -> Result<(), NcError> {
        let shown = speed * (30.0 / std::f64::consts::PI);
        let allowed = match self.speeds.get_mut(usize::from(spindle)) {
            None => "spindles 0 to 7",
            Some(place) if speed == 0.0 || (SPEED[0]..=SPEED[1]).contains(&shown.abs()) => {
                *place = speed;
                return Ok(());
            }
            Some(_) => "0, or 0.0001 to 1e6 1/min in both directions",
        };
        let axis = format!("speed of spindle {spindle}").into();
        Err(NcError::NumberRange { block: self.block, axis, value: shown, allowed })
    }

    fn define(&mut self, gear: &Gear) -> Result<(), NcError> {
        self.movable(gear.follower)?;
        if matches!(self.gears[gear.follower], GearPlace::On(_)) {
            return Err(self.gear_state(gear.follower, "cannot change while it is on"));
        }
        if gear.leaders.is_empty() {
            return Err(self.gear_state(gear.follower, "has no leading axis"));
        }
        for (k, leader) in gear.leaders.iter().enumerate() {
            self.axis(leader.axis)?;
            if leader.axis == gear.follower || gear.leaders[..k].iter().any(|other| other.axis == leader.axis)
            {
                return Err(self.gear_state(gear.follower, "has a leading axis twice, or leads itself"));
            }
            match leader.coupling {
                Coupling::Ratio { num, den } => {
                    let (n, d) = (if num == 0.0 { den.abs() } else { num.abs() }, den.abs());
                    let (least, largest) = (n.min(d), n.max(d));
                    // Written so that NaN, which min and max pass over, fails.
                    let fits = num.is_finite()
                        && den.is_finite()
                        && least >= RATIO[0]
                        && largest <= RATIO[1].min(RATIO_SPREAD * least);
                    if !fits {
                        let quantity = "a gear ratio";
                        let allowed = "numerator 0 or 1e-12 to 1e13, denominator 1e-12 to 1e13, not 1e15 times each other";
                        return Err(NcError::RatioRange {
                            block: self.block,
                            quantity,
                            value: num / den,
                            allowed,
                        });
                    }
                }
                Coupling::Table(table) => {
                    let reason = match self.tables.get(&table) {
                        Some(axes) if *axes == [gear.follower, leader.axis] => continue,
                        Some(_) => "is of other axes than the gear that uses it",
                        None => "is used before it is given",
                    };
                    return Err(NcError::BadTable { block: self.block, table, reason });
                }
            }
        }
        if let Some(teeth) = &gear.teeth {
            let fits = teeth.teeth > 0
                && teeth.threads != 0
                && teeth.normal_module > 0.0
                && teeth.normal_module.is_finite()
                && teeth.helix_angle.abs() < std::f64::consts::FRAC_PI_2;
            if !fits {
                return Err(self.gear_state(gear.follower, "has impossible tooth data"));
            }
        }
        self.gears[gear.follower] =
            GearPlace::Defined(gear.leaders.iter().map(|leader| leader.axis).collect());
        Ok(())
    }

    fn couple(&mut self, follower: usize, at: Option<&GearSynchronisation>) -> Result<(), NcError> {
        let axis = self.movable(follower)?;
        let GearPlace::Defined(leaders) = &self.gears[follower] else {
            return Err(self.gear_state(follower, "is not defined, or is on already"));
        };
        if let Some(at) = at {
            if at.leaders.len() != leaders.len() {
                return Err(self.gear_state(follower, "has another number of leading axes"));
            }
            self.value(axis, at.follower)?;
            for (&leader, &value) in leaders.iter().zip(&at.leaders) {
                self.value(self.axis(leader)?, value)?;
            }
        }
        self.gears[follower] = GearPlace::On(leaders.clone());
        // From here on it stands wherever its leaders take it.
        self.known &= !(1 << follower);
        Ok(())
    }

    fn table(&mut self, table: &CurveTable) -> Result<(), NcError> {
        let bad = |reason| Err(NcError::BadTable { block: self.block, table: table.id, reason });
        let follower = self.movable(table.follower)?;
        let leader = self.movable(table.leader)?;
        if table.id == 0 || table.id > 99_999 {
            return bad("has a number outside 1 to 99999");
        }
        if self.tables.contains_key(&table.id) {
            return bad("is given twice");
        }
        if table.follower == table.leader {
            return bad("leads itself");
        }
        let Some(last) = table.pieces.last() else { return bad("has no piece") };
        self.value(leader, table.start[0])?;
        self.value(follower, table.start[1])?;
        let sign = (last.leader - table.start[0]).signum();
        let mut before = table.start[0];
        for piece in &table.pieces {
            self.value(leader, piece.leader)?;
            for value in [piece.follower.end, piece.follower.start_slope, piece.follower.end_slope] {
                self.value(follower, value)?;
            }
            let goes_on = sign * (piece.leader - before) >= LEADER_STEP;
            if !goes_on {
                return bad("is not strictly monotone in its leader");
            }
            before = piece.leader;
        }
        if table.repetition == Repetition::Leader && (last.follower.end - table.start[1]).abs() > 1e-9 {
            return bad("repeats in its leader only, but ends elsewhere than it starts");
        }
        self.tables.insert(table.id, [table.follower, table.leader]);
        Ok(())
    }
}
