//! Figures of what a job adds to the chain: rotation over feed and worm, whole pulses and voltage, engagement, older multipliers.

use super::finding::of_feed;
use super::prepare::{Chain, Compared, Driven};
use super::result::{ComparedResult, CorrectionResult, EngagementResult, RangeUm, SplitResult};
use control::{
    AxisState, Converter, Correction, Engaging, EngagingRecord, Extremes, InterpolationRun, LeadingAxis,
    MultiplierRun,
};
use electronic_gearbox::chain::Split;
use electronic_gearbox::pulse::{Direction, TimedPulse};
use run::RunFailure;
use run::control::on_field;
use std::f64::consts::TAU;

/// Instants of a motion at which added rotation is looked at.
const INSTANTS: u32 = 4000;

fn range(extremes: Extremes, um: f64) -> RangeUm {
    RangeUm { least_um: extremes.least * um, greatest_um: extremes.greatest * um }
}

/// What is added over the motion; over turns of the worm for what follows it.
///
/// # Errors
/// [`RunFailure`] on `correction`: a value beyond the range of numbers.
pub(super) fn corrections(
    list: &[Correction],
    chain: &Chain,
    driven: &Driven,
    worm_speed: f64,
) -> Result<Vec<CorrectionResult>, RunFailure> {
    let um = chain.gear.flank_per_angle();
    list.iter()
        .enumerate()
        .map(|(i, correction)| {
            let refused = |error| on_field(&error, &format!("correction.curves[{i}]"));
            let (mut flank, mut speed) = (None::<[f64; 2]>, 0.0f64);
            let mut look = |state: AxisState| {
                let at = correction.at(state)?;
                let [least, greatest] = flank.get_or_insert([at.position; 2]);
                (*least, *greatest) = (least.min(at.position), greatest.max(at.position));
                speed = speed.max(at.speed.abs());
                Ok(())
            };
            let mut feed_speed = 0.0;
            match (correction.axis, &driven.motion) {
                (LeadingAxis::Worm, _) => {
                    for k in 0..INSTANTS {
                        // A turn and more in steps that meet no period.
                        let position = 360.0 * 1.618_033_988_75 * f64::from(k);
                        look(AxisState { position, speed: worm_speed.to_degrees(), acceleration: 0.0 })
                            .map_err(refused)?;
                    }
                }
                (LeadingAxis::Feed, Some(motion)) => {
                    (feed_speed, _) = motion.greatest();
                    for k in 0..=INSTANTS {
                        let state = motion.at(motion.duration() * f64::from(k) / f64::from(INSTANTS));
                        let (position, speed, acceleration) =
                            (state.position, state.speed, state.acceleration);
                        look(AxisState { position, speed, acceleration }).map_err(refused)?;
                    }
                }
                (LeadingAxis::Feed, None) => {
                    let travel = driven.travel(&chain.interpolation);
                    for k in 0..=INSTANTS {
                        let position = travel * f64::from(k) / f64::from(INSTANTS);
                        look(AxisState { position, ..AxisState::default() }).map_err(refused)?;
                    }
                }
            }
            let [least, greatest] = flank.unwrap_or_default();
            Ok(CorrectionResult {
                axis: match correction.axis {
                    LeadingAxis::Feed => "feed",
                    LeadingAxis::Worm => "worm",
                },
                flank: range(Extremes { least, greatest }, um),
                greatest_speed_deg_per_s: speed.to_degrees(),
                speed_jump_deg_per_s: (correction.end_slope().map_err(refused)? * feed_speed).to_degrees(),
                rounding_um: 0.5 * TAU / chain.rotation.parts_per_revolution * um,
            })
        })
        .collect()
}

/// A change of whole pulses or voltage.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SplitChange {
    /// Clock tick.
    pub tick: u64,
    /// Coarse pulses that went out with it: +1 on the forward line, -1 on the backward one.
    pub coarse_pulses: i64,
    /// Whole workpiece pulses.
    pub coarse: i64,
    /// Parts of one.
    pub fine: u32,
    /// Voltage of them.
    pub volts: f64,
}

/// Follows the parts that pulses turn, as counter and converter do.
pub(super) struct SplitFollower {
    split: Split,
    converter: Converter,
    forward: u64,
    backward: u64,
    error: Extremes,
    /// Every change, where a trace is wanted.
    pub trace: Option<Vec<SplitChange>>,
}

impl SplitFollower {
    /// At 0.
    ///
    /// # Errors
    /// The gearbox's own for P out of its range.
    pub fn new(chain: &Chain, converter: Converter, traced: bool) -> Result<Self, RunFailure> {
        let split = Split::new(chain.interpolation.settings.pulses_per_interval())
            .map_err(|error| on_field(&error, "feed.pulses_per_interval"))?;
        let at = converter.error(0, split.parts());
        Ok(Self {
            split,
            converter,
            forward: 0,
            backward: 0,
            error: Extremes { least: at, greatest: at },
            trace: traced.then(Vec::new),
        })
    }

    /// A pulse that turned by some parts.
    pub fn pulse(&mut self, pulse: TimedPulse, turned: i64) {
        let Some(direction) = Direction::from_sign(turned.signum()) else { return };
        let mut sent = 0;
        for _ in 0..turned.unsigned_abs() {
            sent += self.split.pulse(direction).map_or(0, Direction::sign);
        }
        let count = sent.unsigned_abs();
        if sent > 0 {
            self.forward += count
        } else {
            self.backward += count
        }
        let position = self.split.position();
        let parts = self.split.parts();
        let error = self.converter.error(position.fine, parts);
        self.error =
            Extremes { least: self.error.least.min(error), greatest: self.error.greatest.max(error) };
        if let Some(trace) = &mut self.trace {
            trace.push(SplitChange {
                tick: pulse.tick,
                coarse_pulses: sent,
                coarse: position.coarse,
                fine: position.fine,
                volts: self.converter.volts(position.fine, parts),
            });
        }
    }

    /// Figures and trace.
    pub fn finish(self, chain: &Chain) -> (SplitResult, Option<Vec<SplitChange>>) {
        let parts = self.split.parts();
        let um = chain.gear.flank_per_angle() * TAU * f64::from(parts) / chain.rotation.parts_per_revolution;
        let position = self.split.position();
        let result = SplitResult {
            forward_pulses: self.forward,
            backward_pulses: self.backward,
            whole_pulses: position.coarse,
            part: position.fine,
            voltage_v: self.converter.volts(position.fine, parts),
            step_um: um / f64::from(parts),
            error: range(self.error, um),
            limits: range(self.converter.limits(parts), um),
            read_apart_um: um,
        };
        (result, self.trace)
    }
}

/// The engagement in figures.
pub(super) fn engagement(engaging: &Engaging, record: &EngagingRecord, chain: &Chain) -> EngagementResult {
    let um = chain.gear.flank_per_angle() * TAU / 360.0;
    let half = 2f64.powi(engaging.counter_bits as i32 - 1);
    EngagementResult {
        ramp_s: record.ramp,
        ramp_way_deg: record.ramp_way,
        phase_move_deg: record.phase_move,
        coupled_after_s: record.coupled,
        greatest_speed_deg_per_s: record.speed.greatest.max(-record.speed.least),
        greatest_acceleration_deg_per_s2: record.acceleration.greatest.max(-record.acceleration.least),
        miss: range(record.miss, um),
        counts_a_cycle: record.largest_step,
        counter_wraps: record.wraps,
        counter_used_percent: 1e2 * record.largest_step as f64 / half,
        greatest_worm_speed_rpm: 60.0 * (half - 1.0) / (f64::from(engaging.worm.pulses) * engaging.cycle),
    }
}

/// The interpolator and older multipliers on the same motion, errors along the feed and at the flank.
///
/// # Errors
/// [`RunFailure`] on the motion.
pub(super) fn comparison(
    compared: &Compared,
    run: &InterpolationRun,
    chain: &Chain,
    driven: &Driven,
) -> Result<(Vec<ComparedResult>, Vec<MultiplierRun>), RunFailure> {
    let (Some(motion), Some(whole)) = (&driven.motion, run.error) else { return Ok(Default::default()) };
    let share = chain.gear.flank_per_axial();
    let line = |multiplier: &'static str, whole: Extremes, steady: Option<Extremes>| ComparedResult {
        multiplier,
        whole: range(whole, 1e3),
        steady: steady.map(|steady| range(steady, 1e3)),
        flank_um: 1e3 * share * whole.greatest.max(-whole.least),
        steady_flank_um: steady.map(|steady| 1e3 * share * 0.5 * steady.range()),
    };
    let mut results = vec![line("pace of the interval before", whole, run.steady)];
    let mut runs = Vec::new();
    if let Some(pll) = &compared.pll {
        let run = pll.run(&chain.interpolation, motion, driven.rest).map_err(|error| of_feed(&error))?;
        results.push(line("phase-locked loop", run.whole, run.steady));
        runs.push(run);
    }
    if let Some(amplitude) = &compared.amplitude {
        let run =
            amplitude.run(&chain.interpolation, motion, driven.rest).map_err(|error| of_feed(&error))?;
        results.push(line("amplitudes of sine and cosine", run.whole, run.steady));
        runs.push(run);
    }
    Ok((results, runs))
}
