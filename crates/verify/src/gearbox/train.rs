//! Reference trains of files: listed, or drawn at random.

use super::random::Draw;
use super::refusal::Refusal;
use electronic_gearbox::pulse::{Mode, Settings};
use serde::Deserialize;

/// The names of files for the modes of the interpolator.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "snake_case")]
pub(super) enum ModeName {
    #[serde(rename = "seed")]
    OneWay,
    NoBacklash,
    Literal,
}

impl ModeName {
    pub const fn mode(self) -> Mode {
        match self {
            Self::OneWay => Mode::OneWay,
            Self::NoBacklash => Mode::NoBacklash,
            Self::Literal => Mode::Literal,
        }
    }
}

/// A random train of `docs/mathematics/gearbox.md#limits`.
#[derive(Clone, Debug, PartialEq, Eq, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct RandomTrain {
    #[serde(rename = "seed")]
    pub start: u64,
    count: usize,
    lmin: u64,
    lmax: u64,
    flip_per_1024: u64,
    first: u64,
}

/// Longer trains and intervals are more than a check should take.
const MOST_REFERENCES: usize = 1_000_000;
const LONGEST_INTERVAL: u64 = 1 << 31;
pub(super) const MOST_TICKS: u64 = 1_000_000_000;

impl RandomTrain {
    /// Its references as (tick, sign), and the tick at which it ends.
    fn draw(&self) -> Result<(Vec<(u64, i64)>, u64), Refusal> {
        let usable = self.count <= MOST_REFERENCES
            && (1..=self.lmax).contains(&self.lmin)
            && self.lmax <= LONGEST_INTERVAL
            && self.first <= MOST_TICKS;
        if !usable {
            return Err(Refusal::of_case(format!("no check of a random train {self:?}")));
        }
        let mut draw = Draw::new(self.start);
        let (mut tick, mut sign) = (self.first, 1);
        let mut references = Vec::with_capacity(self.count);
        for _ in 0..self.count {
            references.push((tick, sign));
            tick += self.lmin + draw.below(self.lmax - self.lmin + 1);
            if draw.below(1024) < self.flip_per_1024 {
                sign = -sign;
            }
        }
        Ok((references, tick))
    }
}

/// Input of a case of `pulse_trains`.
#[derive(Clone, Debug, PartialEq, Eq, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct TrainInput {
    #[serde(rename = "P")]
    pub multiplier: u32,
    pub mode: ModeName,
    counter_max: u32,
    last_tick: u64,
    reference_tick: Option<Vec<i64>>,
    reference_sign: Option<Vec<i64>>,
    pub lcg: Option<RandomTrain>,
}

/// References as (tick, sign), and the last tick of the run.
#[derive(Clone, Debug)]
pub(super) struct Train {
    pub references: Vec<(u64, i64)>,
    pub last_tick: u64,
}

impl TrainInput {
    pub fn settings(&self) -> Result<Settings, Refusal> {
        Ok(Settings::new(self.multiplier, self.counter_max, self.mode.mode())?)
    }

    /// The train; the file's last tick has to be that of a random one.
    pub fn train(&self) -> Result<Train, Refusal> {
        let last_tick = self.last_tick;
        let references = match (&self.reference_tick, &self.reference_sign, &self.lcg) {
            (Some(ticks), Some(signs), None) if ticks.len() == signs.len() => {
                // A tick before the first is as bad as tick 0, whichever it is.
                let tick = |&tick| u64::try_from(tick).unwrap_or(0);
                ticks.iter().map(tick).zip(signs.iter().copied()).collect()
            }
            (None, None, Some(random)) => {
                let (references, end) = random.draw()?;
                if end != last_tick {
                    let told = format!("the random train ends at tick {end}, not at last_tick = {last_tick}");
                    return Err(Refusal::of_case(told));
                }
                references
            }
            _ => {
                let told = "either reference_tick and as many reference_sign are needed, or lcg";
                return Err(Refusal::of_case(told.into()));
            }
        };
        if last_tick > MOST_TICKS || references.iter().any(|(tick, _)| *tick > last_tick) {
            let told =
                format!("last_tick = {last_tick}; allowed: up to {MOST_TICKS}, and none before a reference");
            return Err(Refusal::of_case(told));
        }
        Ok(Train { references, last_tick })
    }

    /// Whether the other one has the same references and counters, in whatever mode.
    pub fn is_same_train(&self, other: &Self) -> bool {
        Self { mode: other.mode, ..self.clone() } == *other
    }
}
