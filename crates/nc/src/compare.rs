//! What was written against what was read back (`docs/mathematics/programs.md#what-rounding-adds`): no text and no dialect's grammar is
//! known here, only neutral programs and how far rounding may have moved them.

use super::reader::{HalGear, read_hal};
use super::{
    AxisMotion, AxisWord, BSplineMotion, Block, Coupling, CubicMotion, CubicSpan, CurveTable, Gear,
    GearSynchronisation, MAXIMUM_AXES, NcError, Orientation, Pace, Program, ReadProgram, Targets, TipMotion,
    Word, WriteOptions, Written,
};

/// Relative difference of times.
const DURATION: f64 = 1e-6;
/// Difference of dwells and of spindle speeds: half of their sixth decimal.
const PLAIN: f64 = 0.5e-6;
/// Difference of speeds of probing, mm/min or deg/min: half of the third decimal.
const PROBING: f64 = 0.5e-3;
/// Difference of polynomials, mm or deg.
const POLYNOMIAL: f64 = 1e-9;
/// Relative difference of ratios: two numbers of 15 digits.
const RATIO: f64 = 2e-14;
/// Rounding of the conversions themselves, relative.
pub(super) const CONVERSION: f64 = 1e-15;
/// Times of feeds from here on, and from there on, have other decimals (see the writers' options).
const SMALL_FEED: f64 = 1.0;
const LARGE_FEED: f64 = 1e8;
/// Where polynomials are compared.
const PLACES: [f64; 5] = [0.0, 0.25, 0.5, 0.75, 1.0];

/// Compares a program with what was read from its text, and the netlist of its gear with the gear.
///
/// # Errors
/// `ReadBackMismatch` with the block of the program, counted from 1.
pub fn compare(
    program: &Program,
    found: &ReadProgram,
    written: &Written,
    options: &WriteOptions,
) -> Result<(), NcError> {
    compare_blocks(program, found, written.rounding.lead_ratio, written.hal.as_deref(), options)
}

/// The same with what the text came with: the change of the lead ratio, and the netlist.
pub(super) fn compare_blocks(
    program: &Program,
    found: &ReadProgram,
    lead_ratio: f64,
    hal: Option<&str>,
    options: &WriteOptions,
) -> Result<(), NcError> {
    let half = |decimals: u8| 0.5 * 10f64.powi(-i32::from(decimals));
    let mut wanted = Side::new(program.blocks());
    let mut read = Side::new(&found.blocks);
    let mut comparison = Comparison {
        axes: program.axes(),
        half: [half(options.decimals.mm), half(options.decimals.deg)],
        half_direction: half(options.tip_decimals.direction),
        half_speed: half(options.tip_decimals.speed),
        feed_decimals: options.decimals.feed,
        lead_ratio,
        hal,
        block: 0,
    };
    loop {
        let (first, second) = (wanted.next(), read.next());
        comparison.block = first.as_ref().map_or(program.blocks().len(), |(index, _)| index + 1);
        match (first, second) {
            (None, None) => return Ok(()),
            (Some((_, a)), Some((_, b))) => comparison.block(a, b, &mut wanted, &mut read)?,
            _ => return Err(comparison.mismatch("number of blocks", f64::NAN)),
        }
    }
}

/// One of the two programs on the way through its blocks.
struct Side<'a> {
    blocks: &'a [Block],
    at: usize,
    /// From here on spindles are only stopped before the end, which stops them anyway.
    tail: usize,
    places: Targets,
    gears: [Option<&'a Gear>; MAXIMUM_AXES],
}

impl<'a> Side<'a> {
    fn new(blocks: &'a [Block]) -> Self {
        let end = blocks.len().saturating_sub(1);
        let stops = blocks[..end].iter().rev();
        let stops = stops.take_while(|block| matches!(block, Block::Spindle { speed: 0.0, .. })).count();
        Self { blocks, at: 0, tail: end - stops, places: Targets::NONE, gears: [None; MAXIMUM_AXES] }
    }

    /// Whether tip control is switched on before the next tool, for the tool that was just passed.
    fn guides_the_tip(&self) -> bool {
        let rest = self.blocks[self.at.min(self.blocks.len())..].iter();
        let mut rest = rest.take_while(|block| !matches!(block, Block::Tool { .. }));
        rest.any(|block| matches!(block, Block::TipControlOn(_)))
    }

    /// The next block that is compared: a definition is compared where it is switched on.
    fn next(&mut self) -> Option<(usize, &'a Block)> {
        loop {
            if self.at == self.tail {
                self.at = self.blocks.len().saturating_sub(1).max(self.at);
            }
            let block = self.blocks.get(self.at)?;
            self.at += 1;
            match block {
                Block::GearDefine(gear) if gear.follower < MAXIMUM_AXES => {
                    self.gears[gear.follower] = Some(gear)
                }
                _ => return Some((self.at - 1, block)),
            }
        }
    }
}

struct Comparison<'a> {
    axes: &'a [AxisWord],
    /// Half a unit of the last digit of lengths and of angles.
    half: [f64; 2],
    /// The same of directions, and of speeds of the tip in mm/min.
    half_direction: f64,
    half_speed: f64,
    feed_decimals: u8,
    lead_ratio: f64,
    hal: Option<&'a str>,
    block: usize,
}

impl Comparison<'_> {
    fn mismatch(&self, what: &str, delta: f64) -> NcError {
        NcError::ReadBackMismatch { block: self.block, axis: what.into(), delta }
    }

    fn number(&self, what: &str, wanted: f64, found: f64, tolerance: f64) -> Result<(), NcError> {
        let delta = found - wanted;
        // Written so that NaN fails.
        if delta.abs() <= tolerance { Ok(()) } else { Err(self.mismatch(what, delta)) }
    }

    /// Units of the text per unit of the program.
    fn scale(&self, axis: usize) -> f64 {
        if self.is_rotary(axis) { 1f64.to_degrees() } else { 1.0 }
    }

    fn is_rotary(&self, axis: usize) -> bool {
        self.axes.get(axis).is_some_and(|axis| axis.motion == AxisMotion::Rotary)
    }

    fn name(&self, axis: usize) -> &str {
        self.axes.get(axis).map_or("?", |axis| &axis.name)
    }

    fn value(&self, axis: usize, wanted: f64, found: f64, half: f64) -> Result<(), NcError> {
        let (wanted, found) = (wanted * self.scale(axis), found * self.scale(axis));
        if (found - wanted).abs() <= half + CONVERSION * wanted.abs() {
            return Ok(());
        }
        Err(self.mismatch(self.name(axis), found - wanted))
    }

    fn rounded(&self, axis: usize, wanted: f64, found: f64) -> Result<(), NcError> {
        self.value(axis, wanted, found, self.half[usize::from(self.is_rotary(axis))])
    }

    fn targets(&self, wanted: &Targets, found: &Targets) -> Result<(), NcError> {
        if wanted.mask() != found.mask() {
            return Err(self.mismatch("axes of the block", f64::NAN));
        }
        wanted.iter().zip(found.iter()).try_for_each(|((axis, a), (_, b))| self.rounded(axis, a, b))
    }

    /// Time of a block that is written as `parts` lines of the same feed: half a unit of the feed's last digit, at least a
    /// millionth.
    fn duration(&self, wanted: f64, found: f64, parts: usize) -> Result<(), NcError> {
        let feed = 60.0 * parts as f64 / wanted;
        let decimals = match feed {
            _ if feed < SMALL_FEED => self.feed_decimals + 4,
            _ if feed >= LARGE_FEED => self.feed_decimals.min(8),
            _ => self.feed_decimals,
        };
        let share = 0.5 * 10f64.powi(-i32::from(decimals)) / feed;
        // The time is the inverse of the feed.
        let share = share / (1.0 - share).max(0.5) + 4.0 * CONVERSION;
        self.number("duration", wanted, found, DURATION.max(share) * wanted.abs())
    }

    fn block<'a>(
        &self,
        wanted: &'a Block,
        found: &'a Block,
        a_side: &mut Side<'a>,
        b_side: &mut Side<'a>,
    ) -> Result<(), NcError> {
        match (wanted, found) {
            (Block::Rapid(a), Block::Rapid(b)) => {
                self.targets(a, b)?;
                a_side.places.update(a);
                b_side.places.update(b);
            }
            (Block::Linear { target: a, duration: s }, Block::Linear { target: b, duration: t }) => {
                self.targets(a, b)?;
                self.duration(*s, *t, 1)?;
                a_side.places.update(a);
                b_side.places.update(b);
            }
            (Block::Cubic(a), Block::Cubic(b)) => self.cubic(a, b, a_side, b_side)?,
            (Block::BSpline(a), Block::BSpline(b)) => {
                self.spline(a, b)?;
                for (side, motion) in [(a_side, a), (b_side, b)] {
                    motion.points.iter().for_each(|point| side.places.update(point));
                }
            }
            (Block::Dwell(a), Block::Dwell(b)) => self.number("dwell", *a, *b, PLAIN + CONVERSION * a)?,
            (Block::Spindle { spindle: a, speed: s }, Block::Spindle { spindle: b, speed: t }) if a == b => {
                let per_minute = 30.0 / std::f64::consts::PI;
                let (s, t) = (s * per_minute, t * per_minute);
                // Fanuc takes whole numbers that are not further away than this.
                self.number("spindle speed", s, t, 2.0 * PLAIN + CONVERSION * s.abs())?;
            }
            (Block::Output { number: a, on: to }, Block::Output { number: b, on: found_to }) => {
                if (a, to) != (b, found_to) {
                    return Err(self.mismatch("digital output", f64::from(*b) - f64::from(*a)));
                }
            }
            (Block::Comment(a), Block::Comment(b)) if a == b => {}
            (Block::Stop, Block::Stop) | (Block::End, Block::End) => {}
            (
                Block::GearOn { follower: a, synchronisation: at },
                Block::GearOn { follower: b, synchronisation: found_at },
            ) if a == b => {
                let gear = a_side.gears[*a];
                match (self.hal, gear, b_side.gears[*a]) {
                    (Some(hal), Some(gear), None) => self.netlist(hal, gear, at.as_deref())?,
                    (None, Some(gear), Some(found)) => {
                        self.gear(gear, found)?;
                        self.synchronisation(gear, at.as_deref(), found_at.as_deref())?;
                    }
                    _ => return Err(self.mismatch("gear", f64::NAN)),
                }
            }
            (Block::GearOff { follower: a }, Block::GearOff { follower: b }) if a == b => {}
            (Block::Table(a), Block::Table(b)) => self.table(a, b)?,
            (
                Block::Tool { number: a, length_offset: offset },
                Block::Tool { number: b, length_offset: found_offset },
            ) if a == b => {
                // Where the offset stands beside tip control, a tool without tip control has none.
                let unused = found_offset.is_none() && !b_side.guides_the_tip();
                if offset != found_offset && !unused {
                    return Err(self.mismatch("length offset of the tool", f64::NAN));
                }
            }
            (Block::Coolant(a), Block::Coolant(b)) => {
                if a != b {
                    return Err(self.mismatch("coolant", f64::NAN));
                }
            }
            (Block::Probe(a), Block::Probe(b)) => {
                if (a.axis, a.slot) != (b.axis, b.slot) {
                    return Err(self.mismatch("probing", f64::NAN));
                }
                self.rounded(a.axis, a.to, b.to)?;
                let [wanted, found] = [a.speed, b.speed].map(|speed| 60.0 * self.scale(a.axis) * speed);
                self.number("speed of probing", wanted, found, PROBING + CONVERSION * wanted.abs())?;
                for side in [a_side, b_side] {
                    side.places = Targets::NONE;
                }
            }
            (Block::ShiftOffset(a), Block::ShiftOffset(b)) => {
                if (a.number, a.axis, a.slots) != (b.number, b.axis, b.slots) {
                    return Err(self.mismatch("measured work offset", f64::NAN));
                }
                self.rounded(a.axis, a.middle, b.middle)?;
                (a_side.places, b_side.places) = (Targets::NONE, Targets::NONE);
            }
            (Block::WorkOffset(a), Block::WorkOffset(b)) => {
                if a != b {
                    return Err(self.mismatch("work offset", f64::from(*b) - f64::from(*a)));
                }
                (a_side.places, b_side.places) = (Targets::NONE, Targets::NONE);
            }
            (Block::LengthOffset(a), Block::LengthOffset(b)) => {
                if a != b {
                    return Err(self.mismatch("length offset of the tool", f64::NAN));
                }
                (a_side.places, b_side.places) = (Targets::NONE, Targets::NONE);
            }
            (Block::TipControlOn(a), Block::TipControlOn(b)) if a == b => {}
            (Block::TipControlOff, Block::TipControlOff) => {
                (a_side.places, b_side.places) = (Targets::NONE, Targets::NONE);
            }
            (Block::Tip(a), Block::Tip(b)) => self.tip(a, b)?,
            (Block::TipSpeed(a), Block::TipSpeed(b)) => self.speed(*a, *b)?,
            _ => return Err(self.mismatch("kind of block", f64::NAN)),
        }
        Ok(())
    }

    fn three(&self, what: &str, wanted: [f64; 3], found: [f64; 3], half: f64) -> Result<(), NcError> {
        wanted
            .into_iter()
            .zip(found)
            .try_for_each(|(a, b)| self.number(what, a, b, half + CONVERSION * a.abs()))
    }

    fn speed(&self, wanted: f64, found: f64) -> Result<(), NcError> {
        let (wanted, found) = (wanted * 60.0, found * 60.0);
        self.number("speed of the tip", wanted, found, self.half_speed + CONVERSION * wanted.abs())
    }

    fn tip(&self, a: &TipMotion, b: &TipMotion) -> Result<(), NcError> {
        self.three("tip of the tool", a.tip, b.tip, self.half[0])?;
        match (a.orientation, b.orientation) {
            (Orientation::Kept, Orientation::Kept) => {}
            (Orientation::Direction(a), Orientation::Direction(b)) => {
                self.three("direction of the tool", a, b, self.half_direction)?;
            }
            (Orientation::Angles(a), Orientation::Angles(b)) if a.iter().count() == b.iter().count() => {
                for (axis, wanted) in a.iter() {
                    let found = b.get(axis).ok_or_else(|| self.mismatch(self.name(axis), f64::NAN))?;
                    self.rounded(axis, wanted, found)?;
                }
            }
            _ => return Err(self.mismatch("direction of the tool", f64::NAN)),
        }
        match (a.pace, b.pace) {
            (Pace::Rapid, Pace::Rapid) | (Pace::Kept, Pace::Kept) => Ok(()),
            (Pace::Speed(a), Pace::Speed(b)) => self.speed(a, b),
            (Pace::Duration(a), Pace::Duration(b)) => self.duration(a, b, 1),
            _ => Err(self.mismatch("kind of feed", f64::NAN)),
        }
    }

    /// Cubics at five places. They start where the axes stand, which the blocks before have settled: what their rounding leaves of
    /// the start fades to the end and is taken off.
    fn spans(&self, axis: usize, a: (f64, &CubicSpan), b: (f64, &CubicSpan)) -> Result<(), NcError> {
        PLACES.into_iter().try_for_each(|u| {
            let fading = (1.0 - u) * (b.0 - a.0);
            let size =
                (a.1.end.abs() + a.1.start_slope.abs() + a.1.end_slope.abs() + a.0.abs()) * self.scale(axis);
            let half = POLYNOMIAL + 8.0 * CONVERSION * size;
            self.value(axis, a.1.value(a.0, u), b.1.value(b.0, u) - fading, half)
        })
    }

    fn cubic(
        &self,
        a: &CubicMotion,
        b: &CubicMotion,
        a_side: &mut Side<'_>,
        b_side: &mut Side<'_>,
    ) -> Result<(), NcError> {
        self.duration(a.duration, b.duration, 1)?;
        if !a.spans.iter().map(|span| span.0).eq(b.spans.iter().map(|span| span.0)) {
            return Err(self.mismatch("axes of the block", f64::NAN));
        }
        for ((axis, a), (_, b)) in a.spans.iter().zip(&b.spans) {
            let starts = [&a_side.places, &b_side.places].map(|places| places.get(*axis).unwrap_or_default());
            self.spans(*axis, (starts[0], a), (starts[1], b))?;
            a_side.places.set(*axis, a.end);
            b_side.places.set(*axis, b.end);
        }
        Ok(())
    }

    fn spline(&self, a: &BSplineMotion, b: &BSplineMotion) -> Result<(), NcError> {
        self.duration(a.duration, b.duration, a.points.len())?;
        if a.degree != b.degree || a.points.len() != b.points.len() || a.knots.len() != b.knots.len() {
            return Err(self.mismatch("degree or number of points", f64::NAN));
        }
        a.points.iter().zip(&b.points).try_for_each(|(a, b)| self.targets(a, b))?;
        a.knots.windows(2).zip(b.knots.windows(2)).try_for_each(|(s, t)| {
            let size = s[1].abs() + t[1].abs();
            self.number("knot interval", s[1] - s[0], t[1] - t[0], POLYNOMIAL + 8.0 * CONVERSION * size)
        })
    }

    fn table(&self, a: &CurveTable, b: &CurveTable) -> Result<(), NcError> {
        let head = |table: &CurveTable| {
            (table.id, table.follower, table.leader, table.repetition, table.pieces.len())
        };
        if head(a) != head(b) {
            return Err(self.mismatch("head of the table", f64::NAN));
        }
        let polynomial = |axis, a, b| self.value(axis, a, b, POLYNOMIAL);
        polynomial(a.leader, a.start[0], b.start[0])?;
        polynomial(a.follower, a.start[1], b.start[1])?;
        let mut starts = [a.start[1], b.start[1]];
        for (p, q) in a.pieces.iter().zip(&b.pieces) {
            polynomial(a.leader, p.leader, q.leader)?;
            self.spans(a.follower, (starts[0], &p.follower), (starts[1], &q.follower))?;
            starts = [p.follower.end, q.follower.end];
        }
        Ok(())
    }

    fn gear(&self, a: &Gear, b: &Gear) -> Result<(), NcError> {
        if a.leaders.len() != b.leaders.len() {
            return Err(self.mismatch("leading axes", f64::NAN));
        }
        for leader in &a.leaders {
            let found = b.leaders.iter().find(|found| found.axis == leader.axis).map(|found| found.coupling);
            match (leader.coupling, found) {
                (Coupling::Table(s), Some(Coupling::Table(t))) if s == t => {}
                (Coupling::Ratio { num, den }, Some(Coupling::Ratio { num: n, den: d })) => {
                    // Ratios of endless rotations are exact or they drift.
                    let whole = |value: f64| value.fract() == 0.0;
                    let same = if self.is_rotary(leader.axis) && whole(num) && whole(den) {
                        num * d == n * den
                    } else {
                        let ratio = num / den;
                        (n / d - ratio).abs() <= self.lead_ratio * (1.0 + 1e-9) + RATIO * ratio.abs()
                    };
                    if !same {
                        return Err(self.mismatch(self.name(leader.axis), n / d - num / den));
                    }
                }
                _ => return Err(self.mismatch(self.name(leader.axis), f64::NAN)),
            }
        }
        match (a.teeth, b.teeth) {
            // Tooth data that a dialect does not tell are not lost: it tells the ratios.
            (_, None) => Ok(()),
            (Some(s), Some(t)) if (s.teeth, s.threads) == (t.teeth, t.threads) => Ok(()),
            _ => Err(self.mismatch("teeth or threads", f64::NAN)),
        }
    }

    fn synchronisation(
        &self,
        gear: &Gear,
        wanted: Option<&GearSynchronisation>,
        found: Option<&GearSynchronisation>,
    ) -> Result<(), NcError> {
        match (wanted, found) {
            (None, None) => Ok(()),
            (Some(a), Some(b)) if a.leaders.len() == b.leaders.len() => {
                self.rounded(gear.follower, a.follower, b.follower)?;
                let pairs = a.leaders.iter().zip(&b.leaders);
                gear.leaders
                    .iter()
                    .zip(pairs)
                    .try_for_each(|(leader, (a, b))| self.rounded(leader.axis, *a, *b))
            }
            _ => Err(self.mismatch("synchronous positions", f64::NAN)),
        }
    }

    /// The numbers of the netlist: each gain is its ratio in the units of HAL, and the synchronous positions fit.
    fn netlist(&self, hal: &str, gear: &Gear, at: Option<&GearSynchronisation>) -> Result<(), NcError> {
        let missing = || self.mismatch("netlist", f64::NAN);
        let at = at.ok_or_else(missing)?;
        let Some(Word::Letter(letter)) = self.axes.get(gear.follower).map(|axis| &axis.word) else {
            return Err(missing());
        };
        let name = format!("gear-{}", letter.to_ascii_lowercase());
        let HalGear { gains, offset, connected, guard } =
            read_hal(hal, &name, gear.leaders.len()).ok_or_else(missing)?;
        if !connected || guard.is_nan() || guard <= 0.0 {
            return Err(missing());
        }
        let mut place = offset;
        for ((leader, gain), stands) in gear.leaders.iter().zip(gains).zip(&at.leaders) {
            let Coupling::Ratio { num, den } = leader.coupling else { return Err(missing()) };
            let unit = match self.axes.get(leader.axis).map(|axis| &axis.word) {
                Some(Word::Spindle(_)) => 0.5 / std::f64::consts::PI,
                _ => self.scale(leader.axis),
            };
            let ratio = num / den * self.scale(gear.follower);
            self.number(self.name(leader.axis), ratio, gain * unit, 4.0 * CONVERSION * ratio.abs())?;
            place += gain * stands * unit;
        }
        let size = 16.0 * (1.0 + offset.abs() + place.abs());
        self.number(
            self.name(gear.follower),
            at.follower * self.scale(gear.follower),
            place,
            CONVERSION * size,
        )
    }
}
