//! Motions of a master and of one slave for each pair, count by count, and the quadrature signals of them.

use super::pair::{Pair, Slave};

/// Signals A and B of a count; a count up goes one place on.
const SIGNALS: [[u8; 2]; 4] = [[0, 0], [1, 0], [1, 1], [0, 1]];

/// Counts in one line of the stream: the master, then the slaves.
pub type Counts = Vec<i64>;

/// A fixed sequence of numbers without pattern (xorshift of 64 bits).
struct Draw(u64);

impl Draw {
    /// From `least` up to and including `greatest`.
    fn between(&mut self, least: i64, greatest: i64) -> i64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        least + ((self.0 >> 16) % (greatest - least + 1) as u64) as i64
    }
}

/// An axis at random speeds, each held for a while: the greatest is a count a line, either way.
struct Wandering {
    draw: Draw,
    /// Position and speed in parts of a count.
    position: i64,
    speed: i64,
    held: i64,
}

impl Wandering {
    const PARTS: i64 = 256;

    fn new(start: u64) -> Self {
        Self { draw: Draw(start), position: 0, speed: 0, held: 0 }
    }

    fn step(&mut self) -> i64 {
        if self.held == 0 {
            self.held = self.draw.between(1, 400);
            // Every fourth speed is the greatest one: reversals without a rest between the counts.
            let greatest = if self.draw.between(0, 3) == 0 { 1 } else { Self::PARTS };
            self.speed = self.draw.between(-greatest, greatest) * (Self::PARTS / greatest);
        }
        self.held -= 1;
        self.position += self.speed;
        self.position.div_euclid(Self::PARTS)
    }
}

/// The counts of every line. In the first line all axes stand at `start`.
pub fn motions(pairs: &[Pair], lines: usize, start: i64) -> Vec<Counts> {
    let mut axes: Vec<Wandering> =
        (0..=pairs.len() as u64).map(|axis| Wandering::new(0x9e37_79b9_7f4a_7c17 ^ (axis << 32))).collect();
    let mut all = vec![vec![start; pairs.len() + 1]];
    for line in 1..lines {
        let last = &all[line - 1];
        let mut counts = vec![start + axes[0].step()];
        for (channel, pair) in pairs.iter().enumerate() {
            let slave = last[channel + 1];
            counts.push(match pair.slave {
                Slave::Wanders => start + axes[channel + 1].step(),
                Slave::Follows => {
                    let target = start + pair.ours().position(counts[0] - start).0;
                    slave + (target - slave).signum()
                }
                Slave::Runs { lines } => slave + if line < lines { 1 } else { -1 },
            });
        }
        all.push(counts);
    }
    all
}

/// The stream as `halstreamer` reads it.
pub fn text(pairs: &[Pair], motions: &[Counts]) -> String {
    let mut text = String::new();
    for counts in motions {
        for (axis, count) in counts.iter().enumerate() {
            let [mut a, mut b] = SIGNALS[count.rem_euclid(4) as usize];
            if axis > 0 && pairs[axis - 1].crossed {
                (a, b) = (b, a);
            }
            text += &format!("{a} {b} ");
        }
        text.pop();
        text.push('\n');
    }
    text
}
