//! A workpiece that is brought up to the speed of its running worm and into the gap: counters of limited width, the gearbox, the
//! engagement, cycle by cycle (`docs/mathematics/gearbox.md#engagement`). The workpiece follows its setpoint.

use super::drive::worm_ratio;
use super::following::FollowedWorm;
use super::interpolation::Extremes;
use electronic_gearbox::Error as GearboxError;
use electronic_gearbox::coupling::{
    Engagement, EngagementSettings, EngagementState, Gearbox, IncrementalGearbox, LinearTerm, Motion,
    WrappingCounter,
};
use std::f64::consts::TAU;

/// What is engaged, and how. Angles in degrees.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Engaging {
    /// The worm, at constant speed.
    pub worm: FollowedWorm,
    /// Parts of a revolution of the workpiece in which the gearbox counts.
    pub parts: i64,
    /// Limits, in degrees and s.
    pub settings: EngagementSettings,
    /// Where a tooth space stands while the worm is at its zero.
    pub gap: f64,
    /// Cycle of the gearbox, s.
    pub cycle: f64,
    /// Width of the worm's counter.
    pub counter_bits: u32,
}

/// An instant of an engagement.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EngagingSample {
    /// s since it began.
    pub time: f64,
    /// Speed of the workpiece, degrees/s.
    pub speed: f64,
    /// Way still missing to the gap, degrees; `None` before it was named.
    pub to_gap: Option<f64>,
}

/// How it went.
#[derive(Clone, Debug, PartialEq)]
pub struct EngagingRecord {
    /// Time until the workpiece runs along, s.
    pub ramp: f64,
    /// Way that it went meanwhile.
    pub ramp_way: f64,
    /// The move into the gap.
    pub phase_move: f64,
    /// Time until it is in phase, s.
    pub coupled: f64,
    /// Speeds of the workpiece.
    pub speed: Extremes,
    /// Accelerations of it.
    pub acceleration: Extremes,
    /// Least and greatest distance to the gap over the cycles behind, while coupled.
    pub miss: Extremes,
    /// How often the counter of the worm wrapped.
    pub wraps: u64,
    /// Greatest way of that counter in a cycle.
    pub largest_step: i64,
    /// What happened over time.
    pub samples: Vec<EngagingSample>,
}

/// Cycles behind the moment of coupling in which the miss is looked at.
const LOOKED_AT: u64 = 1000;
/// Samples for a chart.
const SAMPLES: u64 = 600;

impl Engaging {
    /// Pitch, degrees.
    fn pitch(&self) -> f64 {
        360.0 / f64::from(self.worm.teeth.unsigned_abs())
    }

    /// Longest time that the two stages can take, by their rules, s.
    fn longest(&self) -> f64 {
        let speed = (self.worm.workpiece_turns() * self.worm.speed.to_degrees()).abs();
        let way = self.pitch() / 2.0;
        let EngagementSettings { phase_speed, acceleration, .. } = self.settings;
        1.875 * speed / acceleration
            + (1.875 * way / phase_speed).max((10.0 / 3f64.sqrt() * way / acceleration).sqrt())
    }

    /// Counts of the worm in a cycle.
    pub fn counts_a_cycle(&self) -> f64 {
        self.worm.speed * self.cycle / TAU * f64::from(self.worm.pulses)
    }

    /// Cycles that an engagement takes at most.
    pub fn most_cycles(&self) -> f64 {
        self.longest() / self.cycle + 10.0
    }

    /// Runs it. At its beginning the workpiece stands at 0 and the worm passes its zero.
    ///
    /// # Errors
    /// Those of the gearbox: settings out of range, a counter that moves by half its range in a cycle.
    pub fn run(&self) -> Result<EngagingRecord, GearboxError> {
        let Self { worm, parts, cycle, .. } = *self;
        // From half the range on a counter shows a wrong way, and no reading of it tells.
        let difference = self.counts_a_cycle().ceil() as i64;
        if difference >= 1 << (self.counter_bits.clamp(2, 63) - 1) {
            return Err(GearboxError::EncoderJump { difference, bits: self.counter_bits });
        }
        let ratio = worm_ratio(worm.threads.into(), worm.teeth.into(), parts, worm.pulses)?;
        let mut closed = Gearbox::new(0, [LinearTerm::new(ratio, 0)]);
        closed.engage(&[0], 0)?;
        let mut gearbox = IncrementalGearbox::new(closed, &[0])?;
        let mut counter = WrappingCounter::new(self.counter_bits, 0)?;
        let mut engagement = Engagement::new(self.settings)?;
        let degrees = |counts: f64| counts * 360.0 / parts as f64;
        let speed = self.worm.workpiece_turns() * worm.speed.to_degrees();
        let wrap = 2f64.powi(self.counter_bits as i32);
        engagement.engage(Motion { position: 0.0, speed, acceleration: 0.0 })?;

        let mut record = EngagingRecord {
            ramp: 0.0,
            ramp_way: 0.0,
            phase_move: 0.0,
            coupled: 0.0,
            speed: Extremes { least: 0.0, greatest: 0.0 },
            acceleration: Extremes { least: 0.0, greatest: 0.0 },
            miss: Extremes::NONE,
            wraps: 0,
            largest_step: 0,
            samples: Vec::new(),
        };
        let cycles = self.most_cycles().ceil() as u64;
        let every = (cycles / SAMPLES).max(1);
        let (mut named, mut behind, mut turns) = (false, 0, 0);
        for k in 1..=cycles + LOOKED_AT {
            let time = k as f64 * cycle;
            let angle = worm.speed * time;
            let counts = (angle / TAU * f64::from(worm.pulses)).floor();
            let way = counter.read((counts.rem_euclid(wrap)) as u64)?;
            let now = (counts / wrap).floor() as i64;
            record.wraps += u64::from(now != turns);
            turns = now;
            record.largest_step = record.largest_step.max(way.abs());
            gearbox.advance(&[way])?;
            let position = degrees(gearbox.position()?.counts as f64);
            let coupled = Motion { position, speed, acceleration: 0.0 };
            let output = engagement.update(cycle, coupled, 0.0)?;
            let offset = output.offset.unwrap_or_default();
            let (place, gap) =
                (position + offset.position, self.gap + self.worm.workpiece_turns() * angle.to_degrees());
            record.speed.add(speed + offset.speed);
            record.acceleration.add(offset.acceleration);
            let missing = |way: f64| way - (way / self.pitch()).round() * self.pitch();
            if behind < LOOKED_AT / 10 && k % every == 0 {
                let to_gap = named.then(|| missing(gap - place));
                record.samples.push(EngagingSample { time, speed: speed + offset.speed, to_gap });
            }
            if engagement.awaits_target() && !named {
                (record.ramp, record.ramp_way) = (time, place);
                record.phase_move = missing(gap - place);
                engagement.synchronise(place, gap, self.pitch())?;
                named = true;
            }
            if output.state == EngagementState::Coupled {
                if behind == 0 {
                    record.coupled = time;
                }
                record.miss.add(missing(place - gap));
                behind += 1;
                if behind == LOOKED_AT {
                    break;
                }
            }
        }
        Ok(record)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn engaging() -> Engaging {
        Engaging {
            worm: FollowedWorm { threads: 3, teeth: 40, pulses: 4096, speed: 3000.0 / 60.0 * TAU },
            parts: 36_000 * 16,
            settings: EngagementSettings {
                phase_speed: 90.0,
                acceleration: 3600.0,
                fine_window: 1.0,
                coarse_window: 1.0,
                fault_time: 1.0,
                standstill_speed: 1e-3,
            },
            gap: 2.5,
            cycle: 1e-3,
            counter_bits: 16,
        }
    }

    /// The rules of the specification, section 7 of the electronic gearbox: T = 1.875 |v|/a, way v T/2, the move by the shorter way.
    #[test]
    fn times_and_ways_are_those_of_the_rules() {
        let engaging = engaging();
        let record = engaging.run().unwrap();
        let speed = -3.0 / 40.0 * 18_000.0;
        let ramp: f64 = 1.875 * 1350.0 / 3600.0;
        assert!((record.ramp - ramp).abs() <= 1e-3, "{}", record.ramp);
        // To the count of the worm, 0.0066 degrees.
        let way = speed * (record.ramp - ramp / 2.0);
        assert!((record.ramp_way - way).abs() < 0.01, "{} for {way}", record.ramp_way);
        let phase = (1.875 * record.phase_move.abs() / 90.0)
            .max((10.0 / 3f64.sqrt() * record.phase_move.abs() / 3600.0).sqrt());
        assert!((record.coupled - record.ramp - phase).abs() <= 2e-3, "{}", record.coupled);
        assert!(record.phase_move.abs() <= 4.5);
        // In the gap to the count of the worm, 3/40 of 360/4096 degrees, and a part of the workpiece.
        let count = 3.0 / 40.0 * 360.0 / 4096.0 + 360.0 / 576_000.0;
        assert!(
            record.miss.least >= -2.0 * count && record.miss.greatest <= 2.0 * count,
            "{:?}",
            record.miss
        );
        // 204.8 counts a cycle over 16 bits.
        assert_eq!(record.largest_step, 205);
        let cycles = (record.coupled / 1e-3).round() + LOOKED_AT as f64;
        assert_eq!(record.wraps, ((cycles - 1.0) * 204.8 / 65_536.0) as u64);
        assert!(record.speed.least >= speed - 90.0 - 1e-9 && record.speed.greatest <= 0.0);
        assert!(record.acceleration.least >= -3600.0 - 1e-6 && record.acceleration.greatest <= 3600.0 + 1e-6);
    }

    #[test]
    fn the_width_of_the_counter_does_not_matter_while_it_is_read_in_time() {
        let wide = engaging().run().unwrap();
        let narrow = Engaging { counter_bits: 9, ..engaging() }.run().unwrap();
        assert_eq!(
            (wide.coupled, wide.miss, wide.phase_move),
            (narrow.coupled, narrow.miss, narrow.phase_move)
        );
        assert!(narrow.wraps > wide.wraps);
        // 205 of 256 look like 51 backwards.
        let lost = Engaging { counter_bits: 8, ..engaging() }.run();
        assert_eq!(lost, Err(GearboxError::EncoderJump { difference: 205, bits: 8 }));
    }
}
