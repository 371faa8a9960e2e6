//! One stroke of a grinding pass: what it leaves, how fast it runs, where it begins and ends.

use foundation::geometry::Sides;
use foundation::kinematics::MotionLaw;
use foundation::numerics::extremes;
use grinding_technology::{Direction, Ground};
use motion::in_words;

/// Which law of the shift a stroke follows.
#[derive(Clone, Debug, PartialEq)]
pub enum StrokeLaw {
    /// That of the plan; of a roughing stroke that of the roughing areas, where the worm has some.
    Planned,
    /// Its own, z_V1 over z_V2, mm.
    Own(MotionLaw),
}

/// Where a stroke meets stock.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StockContact {
    /// Feeds z_V2 of the first and of the last contact, mm.
    pub feeds: [f64; 2],
    /// How far the stroke goes on beyond both, mm.
    pub overrun: f64,
}

impl StockContact {
    /// What holds for both.
    pub fn joined(self, other: Self) -> Self {
        let all = extremes(self.feeds.into_iter().chain(other.feeds));
        Self { feeds: all, overrun: self.overrun.min(other.overrun) }
    }

    /// Whether no stock is met at a feed, mm.
    pub fn is_clear(&self, feed: f64) -> bool {
        let [a, b] = self.feeds;
        feed <= a.min(b) || feed >= a.max(b)
    }
}

/// One stroke. mm, rad, s.
#[derive(Clone, Debug, PartialEq)]
pub struct GrindingStroke {
    /// Flanks that it grinds; both where it is driven for every flank.
    pub ground: Ground,
    /// Stock that it leaves on each flank, normal.
    pub left: Sides<f64>,
    /// Speed of the worm, rad/s.
    pub worm_speed: f64,
    /// Feed z_V2 per revolution of the workpiece.
    pub feed_per_revolution: f64,
    /// Sense of the feed.
    pub direction: Direction,
    /// Shift of the worm.
    pub shift: StrokeLaw,
    /// Where it meets the stock; `None` where the stock is not known: it begins and ends clear of the blank.
    pub contact: Option<StockContact>,
    /// Pause after it.
    pub dwell: f64,
}

impl GrindingStroke {
    /// A stroke with rising feed that leaves the same on both flanks of stock that is not known.
    pub fn up(left: f64, worm_speed: f64, feed_per_revolution: f64) -> Self {
        Self {
            ground: Ground::Both,
            left: Sides::both(left),
            worm_speed,
            feed_per_revolution,
            direction: Direction::Up,
            shift: StrokeLaw::Planned,
            contact: None,
            dwell: 0.0,
        }
    }

    /// Whether it leaves nothing.
    pub fn finishes(&self) -> bool {
        self.ground.flanks().all(|flank| self.left[flank] == 0.0)
    }

    /// Its name in a program: capital letters, digits, blanks.
    pub fn name(&self, after_finishing: bool) -> String {
        let um = |left: f64| in_words(left * 1e3, "um");
        let Sides { left, right } = match self.ground {
            Ground::Both => self.left,
            Ground::Only(flank) => Sides::both(self.left[flank]),
        };
        if self.finishes() {
            return if after_finishing { "SPARK OUT".into() } else { "FINISHING".into() };
        }
        if left == right {
            return format!("ROUGHING STOCK {}", um(left));
        }
        format!("ROUGHING STOCK LEFT {} RIGHT {}", um(left), um(right))
    }
}
