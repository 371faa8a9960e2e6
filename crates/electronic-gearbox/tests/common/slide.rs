//! Reference trains of slides that speed up, slow down, stand still and turn.

use super::draw::Draw;
use electronic_gearbox::pulse::Direction;

/// A slide whose speed wanders: intervals between `shortest` and `longest` ticks that change by up to a quarter from one to the next,
/// with reversals in which the turning interval is drawn anew.
pub struct Slide {
    draw: Draw,
    shortest: u64,
    longest: u64,
    length: f64,
    tick: u64,
    direction: Direction,
}

impl Slide {
    pub fn new(start: u64, shortest: u64, longest: u64) -> Self {
        let mut draw = Draw::new(start);
        let direction = if unit(&mut draw) < 0.5 { Direction::Forward } else { Direction::Backward };
        Self { draw, shortest, longest, length: longest as f64, tick: 0, direction }
    }
}

impl Iterator for Slide {
    type Item = (u64, Direction);

    fn next(&mut self) -> Option<Self::Item> {
        if self.tick > 0 && unit(&mut self.draw) < 0.08 {
            self.direction = self.direction.reversed();
            let span = (self.longest as f64 / self.shortest as f64).ln();
            self.length = self.shortest as f64 * (span * unit(&mut self.draw)).exp();
        } else {
            self.length *= 0.8 + 0.45 * unit(&mut self.draw);
        }
        self.length = self.length.clamp(self.shortest as f64, self.longest as f64);
        self.tick += (self.length as u64).clamp(self.shortest, self.longest);
        Some((self.tick, self.direction))
    }
}

/// A draw in [0, 1).
fn unit(draw: &mut Draw) -> f64 {
    draw.bits() as f64 / (1u64 << 31) as f64
}
