//! How a slide moves: pieces of constant acceleration, and when it passes the lines of its scale.

use super::error::{ControlError, within};
use super::interpolation::Extremes;
use super::line_errors::LineErrors;
use electronic_gearbox::pulse::Direction;

/// One order of a motion. mm, mm/s, mm/s^2, s.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Move {
    /// Goes there from rest to rest: constant acceleration, constant speed, constant deceleration.
    To {
        /// Position.
        position: f64,
        /// Speed that it reaches if the way is long enough.
        speed: f64,
        /// Amount of the acceleration.
        acceleration: f64,
    },
    /// Stands still.
    Rest {
        /// How long.
        duration: f64,
    },
}

/// A piece of constant acceleration.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Piece {
    start: f64,
    duration: f64,
    position: f64,
    speed: f64,
    acceleration: f64,
}

impl Piece {
    fn position(&self, after: f64) -> f64 {
        self.position + after * (self.speed + 0.5 * self.acceleration * after)
    }

    fn speed(&self, after: f64) -> f64 {
        self.speed + self.acceleration * after
    }

    /// Time after the start of the piece at which it turns, if it does so inside.
    fn turn(&self) -> Option<f64> {
        let after = -self.speed / self.acceleration;
        (after > 0.0 && after < self.duration).then_some(after)
    }
}

/// A line of the scale that the slide passes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Crossing {
    /// When, s.
    pub time: f64,
    /// Number of the line; it lies at number times pitch.
    pub line: i64,
    /// Which way.
    pub direction: Direction,
}

/// State of a slide at one time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SlideState {
    /// mm.
    pub position: f64,
    /// mm/s.
    pub speed: f64,
    /// mm/s^2.
    pub acceleration: f64,
}

/// A motion that begins at rest at time 0.
#[derive(Clone, Debug, PartialEq)]
pub struct SlideMotion {
    start: f64,
    pieces: Vec<Piece>,
    /// Of the scale that it passes.
    lines: LineErrors,
}

/// Most lines of a scale that a motion may pass: some minutes of work, some GiB of pulses.
const MOST_LINES: f64 = 2e8;
const RANGE: std::ops::RangeInclusive<f64> = -1e6..=1e6;

impl SlideMotion {
    /// From pieces of constant acceleration, each (duration in s, acceleration in mm/s^2), beginning at rest at `start`.
    ///
    /// # Errors
    /// [`ControlError::BadParameter`].
    pub fn from_rest(start: f64, pieces: impl IntoIterator<Item = (f64, f64)>) -> Result<Self, ControlError> {
        within("start", start, RANGE, "-1e6 to 1e6 mm")?;
        let mut motion = Self { start, pieces: Vec::new(), lines: LineErrors::default() };
        let (mut time, mut position, mut speed) = (0.0, start, 0.0);
        for (duration, acceleration) in pieces {
            within("duration", duration, 0.0..=1e6, "0 to 1e6 s")?;
            within("acceleration", acceleration, -1e9..=1e9, "-1e9 to 1e9 mm/s^2")?;
            let piece = Piece { start: time, duration, position, speed, acceleration };
            position = within("position", piece.position(duration), RANGE, "-1e6 to 1e6 mm")?;
            (time, speed) = (time + duration, piece.speed(duration));
            motion.pieces.push(piece);
        }
        Ok(motion)
    }

    /// From orders, beginning at rest at `start`.
    ///
    /// # Errors
    /// [`ControlError::BadParameter`].
    pub fn of_moves(start: f64, moves: &[Move]) -> Result<Self, ControlError> {
        let mut motion = Self::from_rest(start, [])?;
        let (mut time, mut at) = (0.0, start);
        for order in moves {
            let (target, pieces): (f64, [(f64, f64); 3]) = match *order {
                Move::Rest { duration } => {
                    (at, [(within("rest", duration, 0.0..=1e6, "0 to 1e6 s")?, 0.0), (0.0, 0.0), (0.0, 0.0)])
                }
                Move::To { position, speed, acceleration } => {
                    within("position", position, RANGE, "-1e6 to 1e6 mm")?;
                    within("speed", speed, 1e-6..=1e6, "1e-6 to 1e6 mm/s")?;
                    within("acceleration", acceleration, 1e-6..=1e9, "1e-6 to 1e9 mm/s^2")?;
                    let way = position - at;
                    // A way too short for the speed is a triangle.
                    let reached = speed.min((way.abs() * acceleration).sqrt());
                    let rise = reached / acceleration;
                    let flat = if reached > 0.0 { (way.abs() / reached - rise).max(0.0) } else { 0.0 };
                    let signed = acceleration.copysign(way);
                    (position, [(rise, signed), (flat, 0.0), (rise, -signed)])
                }
            };
            let order = Self::from_rest(at, pieces)?;
            motion.pieces.extend(
                order
                    .pieces
                    .iter()
                    .filter(|piece| piece.duration > 0.0)
                    .map(|piece| Piece { start: piece.start + time, ..*piece }),
            );
            time += pieces.iter().map(|(duration, _)| duration).sum::<f64>();
            // Not where rounding has led, so that it does not add up.
            at = target;
        }
        Ok(motion)
    }

    /// The same motion along a scale with these errors.
    pub fn with_line_errors(self, lines: LineErrors) -> Self {
        Self { lines, ..self }
    }

    /// Errors of the scale that it passes.
    pub fn line_errors(&self) -> &LineErrors {
        &self.lines
    }

    /// Displacements of lines over the travel, mm.
    pub fn line_limits(&self) -> Extremes {
        let mut travel = Extremes { least: self.start, greatest: self.start };
        self.legs().iter().for_each(|leg| travel.add(leg.end));
        self.lines.limits(travel, self.start)
    }

    /// Length of the motion, s.
    pub fn duration(&self) -> f64 {
        self.pieces.last().map_or(0.0, |piece| piece.start + piece.duration)
    }

    /// Position, speed and acceleration at a time (s); after the end it rests.
    pub fn at(&self, time: f64) -> SlideState {
        self.cursor().at(time)
    }

    /// For many times in rising order.
    pub fn cursor(&self) -> SlideCursor<'_> {
        SlideCursor { motion: self, piece: 0 }
    }

    /// Times at which it turns or comes to rest, in order.
    pub fn stops(&self) -> Vec<f64> {
        let mut stops = Vec::new();
        for piece in &self.pieces {
            stops.extend(piece.turn().map(|after| piece.start + after));
            let end = piece.speed(piece.duration);
            if end.abs() <= 1e-9 * piece.speed.abs().max((piece.acceleration * piece.duration).abs()) {
                stops.push(piece.start + piece.duration);
            }
        }
        stops
    }

    /// Greatest speed, mm/s, and greatest acceleration, mm/s^2, as amounts.
    pub fn greatest(&self) -> (f64, f64) {
        let speed = self.pieces.iter().map(|piece| piece.speed.abs().max(piece.speed(piece.duration).abs()));
        let acceleration = self.pieces.iter().map(|piece| piece.acceleration.abs());
        (speed.fold(0.0, f64::max), acceleration.fold(0.0, f64::max))
    }

    /// All lines of a scale of this pitch (mm) that it passes, in order. A line is passed upwards when the slide reaches it, downwards
    /// when the slide leaves it; the line on which it starts gives nothing upwards.
    ///
    /// # Errors
    /// [`ControlError::BadParameter`] for a pitch that is not positive, or so small that the motion passes more than 2e8 lines.
    pub fn crossings(&self, pitch: f64) -> Result<Crossings<'_>, ControlError> {
        within("pitch", pitch, 1e-9..=1e6, "1e-9 to 1e6 mm")?;
        let legs = self.legs();
        let way: f64 = legs.iter().map(|leg| (leg.end - leg.begin).abs()).sum();
        within("lines", way / pitch, 0.0..=MOST_LINES, "0 to 2e8 lines in one motion")?;
        let mut cell = (self.start / pitch).floor() as i64;
        // The line below the start, wherever it has been displaced to.
        while self.place_of(cell, pitch, Direction::Forward) > self.start {
            cell -= 1;
        }
        while self.place_of(cell + 1, pitch, Direction::Forward) <= self.start {
            cell += 1;
        }
        Ok(Crossings { motion: self, legs: legs.into_iter().peekable(), pitch, cell })
    }

    /// Where a slide that goes this way passes a line.
    fn place_of(&self, line: i64, pitch: f64, direction: Direction) -> f64 {
        let place = line as f64 * pitch;
        if self.lines.is_none() {
            place
        } else {
            place + self.lines.displacement(place, self.start, direction)
        }
    }

    /// The pieces cut where they turn.
    fn legs(&self) -> Vec<Leg<'_>> {
        let mut legs = Vec::with_capacity(self.pieces.len() + 4);
        for piece in &self.pieces {
            let turn = piece.turn();
            let middle = piece.position(turn.unwrap_or(piece.duration));
            legs.push(Leg {
                piece,
                begin: piece.position,
                end: middle,
                from: 0.0,
                to: turn.unwrap_or(piece.duration),
            });
            if let Some(turn) = turn {
                let end = piece.position(piece.duration);
                legs.push(Leg { piece, begin: middle, end, from: turn, to: piece.duration });
            }
        }
        legs
    }
}

/// A stretch in one sense.
struct Leg<'a> {
    piece: &'a Piece,
    begin: f64,
    end: f64,
    from: f64,
    to: f64,
}

impl Leg<'_> {
    /// Time after the start of the piece at which the place is passed.
    fn time_of(&self, place: f64) -> f64 {
        // From the start of the leg, where the form without cancellation is.
        let (way, speed) = (place - self.begin, self.piece.speed(self.from));
        let root = (speed * speed + 2.0 * self.piece.acceleration * way).max(0.0).sqrt();
        let sum = speed + root.copysign(self.end - self.begin);
        let after = if sum == 0.0 { 0.0 } else { 2.0 * way / sum };
        (self.from + after).clamp(self.from, self.to)
    }
}

/// Finds the lines of a scale one after the other.
pub struct Crossings<'a> {
    motion: &'a SlideMotion,
    legs: std::iter::Peekable<std::vec::IntoIter<Leg<'a>>>,
    pitch: f64,
    /// Kept as a number: the two passages of a line on which the slide turns belong together, whatever rounding says.
    cell: i64,
}

impl Iterator for Crossings<'_> {
    type Item = Crossing;

    fn next(&mut self) -> Option<Crossing> {
        while let Some(leg) = self.legs.peek() {
            let upwards = leg.end > leg.begin;
            let line = if upwards { self.cell + 1 } else { self.cell };
            let direction = if upwards { Direction::Forward } else { Direction::Backward };
            let place = self.motion.place_of(line, self.pitch, direction);
            let passed = if upwards { place <= leg.end } else { leg.end < place };
            if passed {
                let time = leg.piece.start + leg.time_of(place);
                self.cell += direction.sign();
                return Some(Crossing { time, line, direction });
            }
            self.legs.next();
        }
        None
    }
}

/// Looks a motion up at rising times.
#[derive(Clone, Debug)]
pub struct SlideCursor<'a> {
    motion: &'a SlideMotion,
    piece: usize,
}

impl SlideCursor<'_> {
    /// State at a time (s), not before the one asked for last.
    pub fn at(&mut self, time: f64) -> SlideState {
        let pieces = &self.motion.pieces;
        while self.piece + 1 < pieces.len() && time >= pieces[self.piece + 1].start {
            self.piece += 1;
        }
        let Some(piece) = pieces.get(self.piece) else {
            return SlideState { position: self.motion.start, speed: 0.0, acceleration: 0.0 };
        };
        let after = time - piece.start;
        if after < 0.0 || after > piece.duration {
            let position = piece.position(after.clamp(0.0, piece.duration));
            return SlideState { position, speed: 0.0, acceleration: 0.0 };
        }
        SlideState {
            position: piece.position(after),
            speed: piece.speed(after),
            acceleration: piece.acceleration,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_move_ends_where_it_is_sent() {
        let moves = [
            Move::To { position: 30.0, speed: 5.0, acceleration: 200.0 },
            Move::Rest { duration: 0.5 },
            Move::To { position: 29.9, speed: 5.0, acceleration: 100.0 },
        ];
        let motion = SlideMotion::of_moves(0.0, &moves).unwrap();
        let first = 30.0 / 5.0 + 5.0 / 200.0;
        assert!((motion.at(first).position - 30.0).abs() < 1e-12);
        assert!((motion.at(first + 0.2).speed).abs() < 1e-12);
        // Too short for 5 mm/s: a triangle of sqrt(0.1*100) = 3.16 mm/s.
        assert!((motion.duration() - (first + 0.5 + 2.0 * (0.1f64 / 100.0).sqrt())).abs() < 1e-12);
        assert!((motion.at(1e3).position - 29.9).abs() < 1e-12);
        assert_eq!(motion.greatest(), (5.0, 200.0));
        assert_eq!(motion.stops().len(), 3);
    }

    #[test]
    fn lines_are_passed_when_the_slide_is_there() {
        let moves = [
            Move::To { position: 0.995, speed: 3.0, acceleration: 50.0 },
            Move::To { position: -0.503, speed: 2.0, acceleration: 80.0 },
        ];
        let motion = SlideMotion::of_moves(0.0, &moves).unwrap();
        let crossings: Vec<Crossing> = motion.crossings(0.01).unwrap().collect();
        assert_eq!(crossings.len(), 99 + 99 + 51);
        assert_eq!(crossings[0].line, 1);
        assert_eq!(crossings.last().unwrap().line, -50);
        for pair in crossings.windows(2) {
            assert!(pair[0].time <= pair[1].time);
            // Up and down the same line, or one line further.
            let turned = pair[0].direction != pair[1].direction;
            assert_eq!(pair[1].line - pair[0].line, if turned { 0 } else { pair[0].direction.sign() });
        }
        for crossing in &crossings {
            assert!(
                (motion.at(crossing.time).position - crossing.line as f64 * 0.01).abs() < 1e-12,
                "{crossing:?}"
            );
        }
    }

    #[test]
    fn a_turn_on_a_line_passes_it_twice_or_not_at_all() {
        for speed in [0.7, 1.0, 3.3] {
            for target in [0.07, 0.3, 1.1] {
                let back = Move::To { position: 0.0, speed, acceleration: 17.0 };
                let motion = SlideMotion::of_moves(
                    0.0,
                    &[Move::To { position: target, speed, acceleration: 17.0 }, back],
                )
                .unwrap();
                let crossings: Vec<Crossing> = motion.crossings(0.01).unwrap().collect();
                let sum: i64 = crossings.iter().map(|crossing| crossing.direction.sign()).sum();
                // Coming home to line 0 may pass it by a rounding, which is one pulse, never half a pair at the turn.
                assert!(sum == 0 || sum == -1 && crossings.last().unwrap().line == 0, "{sum}");
            }
        }
    }

    #[test]
    fn bad_motions_name_what_is_wrong() {
        let refused = |moves: &[Move]| match SlideMotion::of_moves(0.0, moves) {
            Err(ControlError::BadParameter { name, .. }) => name,
            other => panic!("{other:?}"),
        };
        let to = |position, speed, acceleration| Move::To { position, speed, acceleration };
        assert_eq!(refused(&[to(f64::NAN, 1.0, 1.0)]), "position");
        assert_eq!(refused(&[to(1.0, 0.0, 1.0)]), "speed");
        assert_eq!(refused(&[to(1.0, 1.0, -1.0)]), "acceleration");
        assert_eq!(refused(&[Move::Rest { duration: -1.0 }]), "rest");
        let motion = SlideMotion::of_moves(0.0, &[to(1000.0, 1.0, 1.0)]).unwrap();
        assert!(motion.crossings(1e-6).is_err());
        assert!(motion.crossings(0.0).is_err());
    }
}
