//! A stroke of generating grinding through a real gearbox and a real servo: encoders and scales are counted, the gearbox sums the counts,
//! the servo follows with inertia, friction and disturbances. What remains is the error of the workpiece's angle over time
//! (`docs/mathematics/gearbox.md`).

use super::drive::{ClosedGearbox, PulseDrive, worm_ratio};
use super::error::ControlError;
use super::interpolation::Interpolation;
use super::rotation::Rotation;
use super::servo::{Disturbances, Moment, ServoLoop, ServoParameters};
use super::slide::SlideMotion;
use electronic_gearbox::Error as GearboxError;
use electronic_gearbox::coupling::{CubicTable, EndRule, Gearbox, LinearTerm, dyadic, solve_slopes};
use electronic_gearbox::pulse::Status;
use finding::Finding;
use foundation::kinematics::GeneratingMotion;
use std::f64::consts::TAU;

/// The control of a machine.
#[derive(Clone, Debug, PartialEq)]
pub struct StrokeControl {
    /// Scale of the axial slide.
    pub feed: Interpolation,
    /// How its pulses turn the workpiece.
    pub rotation: Rotation,
    /// Pulses per revolution of the worm's encoder.
    pub worm_pulses: u32,
    /// Pulses per revolution of the workpiece's encoder; the setpoint resolves 1/P of one.
    pub workpiece_pulses: u32,
    /// Distance of the counts of the shift's scale, mm; `None` if the shift is known exactly.
    pub shift_pitch: Option<f64>,
    /// Loop and motor of the workpiece spindle.
    pub servo: ServoParameters,
    /// Torques on it.
    pub disturbances: Disturbances,
}

/// What leads: constant speeds. mm, rad, s.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StrokeSpeeds {
    /// Of the worm, rad/s, positive.
    pub worm: f64,
    /// First and last z_V2, in the order in which they are driven, mm.
    pub feed_range: [f64; 2],
    /// Amount of d z_V2/dt, mm/s.
    pub feed: f64,
}

impl StrokeSpeeds {
    /// d z_V2/dt with its sign, mm/s.
    pub fn velocity(&self) -> f64 {
        let [first, last] = self.feed_range;
        (last - first).signum() * self.feed
    }
}

/// The error of the workpiece's angle over a stroke.
#[derive(Clone, Debug, PartialEq)]
pub struct StrokeRecord {
    /// Time of the first sample, s.
    pub start: f64,
    /// Distance of samples, s.
    pub sample_time: f64,
    /// Setpoint of the gearbox less the ideal angle, mean of the first stroke removed, rad.
    pub setpoint: Vec<f64>,
    /// Actual less ideal angle, mean of the first stroke removed, rad.
    pub actual: Vec<f64>,
    /// The means that were removed: setpoint and actual, rad. Centring the tooth space in the machine removes them there.
    pub means: [f64; 2],
    /// Share of samples in which the torque was at its limit.
    pub limited: f64,
    /// Greatest torque of the motor, Nm.
    pub greatest_torque: f64,
    /// State of the feed's interpolator at the end, with its alarms.
    pub interpolator: Status,
    drive: StrokeSpeeds,
    /// z_V2 at time 0 if it moved at its speed from there on, mm.
    origin: f64,
}

/// Why a stroke could not be simulated.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error, Finding)]
pub enum StrokeError {
    /// Numbers of control, servo or disturbances.
    #[error(transparent)]
    #[finding(transparent)]
    Control(#[from] ControlError),
    /// The gearbox.
    #[error(transparent)]
    #[finding(transparent)]
    Gearbox(#[from] GearboxError),
}

/// Knots of the table that holds the correction of phi_2 over the feed, a C2 spline as in a control.
const KNOTS: usize = 1025;

/// The correction of phi_2 as a table over the feed, counts.
struct CorrectionTable {
    from: f64,
    spacing: f64,
    values: Vec<f64>,
    slopes: Vec<f64>,
}

impl CorrectionTable {
    fn new(motion: &GeneratingMotion, range: [f64; 2], per_radian: f64) -> Result<Self, GearboxError> {
        let (from, to) = (range[0].min(range[1]), range[0].max(range[1]));
        let spacing = (to - from) / (KNOTS - 1) as f64;
        let values: Vec<f64> =
            (0..KNOTS).map(|k| motion.delta_phi_2.value(from + k as f64 * spacing) * per_radian).collect();
        let (mut slopes, mut room) = (vec![0.0; KNOTS], vec![0.0; 2 * KNOTS]);
        solve_slopes(&values, spacing, EndRule::Natural, &mut slopes, &mut room)?;
        Ok(Self { from, spacing, values, slopes })
    }

    fn table(&self) -> Result<CubicTable<'_>, GearboxError> {
        CubicTable::new(self.from, self.spacing, &self.values, &self.slopes, EndRule::Natural)
    }
}

/// Simulates a stroke; `phase` is k_0F of the flank looked at.
///
/// # Errors
/// [`StrokeError`].
pub fn run_stroke(
    control: &StrokeControl,
    motion: &GeneratingMotion,
    speeds: &StrokeSpeeds,
    phase: f64,
) -> Result<StrokeRecord, StrokeError> {
    let [record] = run_strokes(control, motion, speeds, phase)?;
    Ok(record)
}

/// Simulates a stroke there and the one back behind it, without a stop but the reversal, the same pulses counted on. What was centred for
/// the first holds for both: the means of the first are removed from either.
///
/// # Errors
/// [`StrokeError`].
pub fn run_there_and_back(
    control: &StrokeControl,
    motion: &GeneratingMotion,
    speeds: &StrokeSpeeds,
    phase: f64,
) -> Result<[StrokeRecord; 2], StrokeError> {
    run_strokes(control, motion, speeds, phase)
}

/// One stroke, or one there and one back.
fn run_strokes<const STROKES: usize>(
    control: &StrokeControl,
    motion: &GeneratingMotion,
    speeds: &StrokeSpeeds,
    phase: f64,
) -> Result<[StrokeRecord; STROKES], StrokeError> {
    let [first, last] = speeds.feed_range;
    let sense = (last - first).signum();
    let velocity = speeds.velocity();
    // The slide starts from rest, the loop settles, then the flank begins.
    let lead_in = control.servo.settling_time();
    let rise = lead_in / 3.0;
    let way = speeds.feed * (lead_in - 0.5 * rise);
    let duration = (last - first).abs() / speeds.feed;
    let settling = lead_in - rise;
    let there = [(rise, velocity / rise), (settling + duration, 0.0)];
    // It runs on as far as it began before the flank, turns, and has settled when it is back at the flank's end.
    let back = [(settling, 0.0), (2.0 * rise, -velocity / rise), (settling + duration, 0.0)];
    let returns = STROKES > 1;
    let step = control.servo.sample_time;
    let mut pieces: Vec<_> = there.into_iter().chain(back.into_iter().filter(|_| returns)).collect();
    // The last sample may lie behind the flank's end.
    pieces.push((step, 0.0));
    let slide = SlideMotion::from_rest(first - sense * way, pieces)?;
    // When each stroke begins at its end of the flank.
    let begins: [f64; STROKES] = std::array::from_fn(|k| lead_in + k as f64 * (duration + 2.0 * lead_in));
    let references = control.feed.references(&slide)?;

    let p = control.feed.settings.pulses_per_interval();
    let parts = control.rotation.parts_per_revolution;
    let whole_parts = i64::from(control.workpiece_pulses) * i64::from(p);
    let worm_ratio =
        worm_ratio(motion.threads as i64, motion.teeth as i64, whole_parts, control.worm_pulses)?;
    let shift_turn = motion.shift_coupling / motion.teeth * parts / TAU;
    let shift_ratio = dyadic(shift_turn * control.shift_pitch.unwrap_or(1.0))?.ratio();
    let gearbox = Gearbox::new(0, [LinearTerm::new(worm_ratio, 0), LinearTerm::new(shift_ratio, 0)]);
    let correction = match motion.delta_phi_2.is_zero() {
        true => None,
        false => {
            let beyond = if returns { sense * way } else { velocity * step };
            Some(CorrectionTable::new(motion, [first - sense * way, last + beyond], parts / TAU)?)
        }
    };
    let table = correction.as_ref().map(CorrectionTable::table).transpose()?;

    // First and last sample of each stroke.
    let windows =
        begins.map(|begin| [(begin / step).floor() as u64, ((begin + duration) / step).ceil() as u64]);
    let samples = windows.last().map_or(0, |window| window[1]);
    let mut pulses = PulseDrive::new(&control.feed, &control.rotation, &references)?;
    // Place of the slide at pulse position 0, in the middle of the staircase.
    let zero = slide.crossings(control.feed.pitch)?.next().map_or(first, |crossing| {
        crossing.line as f64 * control.feed.pitch - sense * 0.5 * control.feed.pitch / f64::from(p)
    });
    let mut cursor = slide.cursor();
    let ideal = |time: f64, feed: f64| motion.state(speeds.worm * time, feed, phase);
    let at_rest = cursor.at(0.0);
    let begin = ideal(0.0, at_rest.position).work_angle;
    let speed_of = |state: super::slide::SlideState| {
        let [_, shift_1, shift_2] = motion.shift.jet(state.position);
        let [_, turn_1, turn_2] = motion.delta_phi_2.jet(state.position);
        let by_feed = (motion.shift_coupling * shift_1 + motion.feed_coupling) / motion.teeth + turn_1;
        let bend = motion.shift_coupling / motion.teeth * shift_2 + turn_2;
        let speed = by_feed * state.speed - speeds.worm * motion.threads / motion.teeth;
        (speed, by_feed * state.acceleration + bend * state.speed * state.speed)
    };
    let mut servo = ServoLoop::new(control.servo)?.starting_at(begin, speed_of(at_rest).0)?;
    let mut closed = ClosedGearbox::new(parts, begin);

    let mut setpoints: [Vec<f64>; STROKES] = std::array::from_fn(|_| Vec::new());
    let mut actuals: [Vec<f64>; STROKES] = std::array::from_fn(|_| Vec::new());
    let (mut limited, mut greatest_torque) = ([0u64; STROKES], [0.0f64; STROKES]);
    for k in 0..=samples {
        let time = k as f64 * step;
        pulses.advance(time)?;
        let state = cursor.at(time);
        let wanted = ideal(time, state.position);
        let worm_counts = (wanted.worm_angle / TAU * f64::from(control.worm_pulses)).floor() as i64;
        let mut counts = match control.shift_pitch {
            Some(pitch) => {
                let shift_counts = (wanted.shift / pitch).floor() as i64;
                gearbox.position(&[worm_counts, shift_counts])?.counts as f64
            }
            None => gearbox.position(&[worm_counts, 0])?.counts as f64 + (shift_turn * wanted.shift).floor(),
        };
        counts += pulses.turned() as f64;
        if let Some(table) = &table {
            counts += table.counts(zero + pulses.net() as f64 / f64::from(p) * control.feed.pitch)? as f64;
        }
        let angle = closed.angle(counts);
        let (speed, acceleration) = speed_of(state);
        let setpoint = closed.setpoint(angle, speed, acceleration);
        let moment = Moment { time, worm_angle: wanted.worm_angle, workpiece_angle: wanted.work_angle };
        let before = servo.angle();
        let sample = servo.step(&setpoint, control.disturbances.torque(&moment)?)?;
        if let Some(stroke) = windows.iter().position(|&[from, to]| (from..=to).contains(&k)) {
            greatest_torque[stroke] = greatest_torque[stroke].max(sample.torque.abs());
            limited[stroke] += u64::from(sample.limited);
            setpoints[stroke].push(angle - wanted.work_angle);
            actuals[stroke].push(before - wanted.work_angle);
        }
    }
    let means = [&mut setpoints, &mut actuals].map(|errors| {
        let mean = errors.first().map_or(0.0, |first| first.iter().sum::<f64>() / first.len() as f64);
        errors.iter_mut().flatten().for_each(|error| *error -= mean);
        mean
    });
    let interpolator = pulses.status();
    Ok(std::array::from_fn(|k| {
        let (setpoint, actual) = (std::mem::take(&mut setpoints[k]), std::mem::take(&mut actuals[k]));
        let (feed_range, velocity) =
            if k == 0 { ([first, last], velocity) } else { ([last, first], -velocity) };
        StrokeRecord {
            start: windows[k][0] as f64 * step,
            sample_time: step,
            limited: limited[k] as f64 / actual.len() as f64,
            setpoint,
            actual,
            means,
            greatest_torque: greatest_torque[k],
            interpolator,
            drive: StrokeSpeeds { feed_range, ..*speeds },
            origin: feed_range[0] - velocity * begins[k],
        }
    }))
}

impl StrokeRecord {
    /// z_V2 at a time within the stroke, mm.
    pub fn feed(&self, time: f64) -> f64 {
        self.origin + self.drive.velocity() * time
    }

    /// Time at which z_V2 is reached, s.
    pub fn time(&self, feed: f64) -> f64 {
        (feed - self.origin) / self.drive.velocity()
    }

    /// The speeds of the stroke.
    pub fn speeds(&self) -> &StrokeSpeeds {
        &self.drive
    }

    /// Error of the actual angle at a time, rad: a cubic through the four samples around it, held at the ends.
    pub fn error(&self, time: f64) -> f64 {
        self.error_with_slope(time)[0]
    }

    /// The same with its rate, rad/s.
    pub fn error_with_slope(&self, time: f64) -> [f64; 2] {
        let last = self.actual.len() as i64 - 1;
        let u = ((time - self.start) / self.sample_time).clamp(0.0, last as f64);
        let k = (u.floor() as i64).min(last - 1).max(0);
        let at = |j: i64| self.actual[j.clamp(0, last) as usize];
        let [a, b, c, d] = [at(k - 1), at(k), at(k + 1), at(k + 2)];
        let s = u - k as f64;
        let [c1, c2, c3] =
            [0.5 * (c - a), 0.5 * (2.0 * a - 5.0 * b + 4.0 * c - d), 0.5 * (3.0 * (b - c) + d - a)];
        [b + s * (c1 + s * (c2 + s * c3)), (c1 + s * (2.0 * c2 + 3.0 * s * c3)) / self.sample_time]
    }
}
