//! The strokes of a run through the job's control, mapped to the flanks, with rays in time as their referee.

use super::pass::{ControlledPass, ControlledRun, GroundFlank};
use super::result::{ControlFlankResult, ControlResult, ErrorTrace, Trace};
use contact::Pair;
use control::{
    ControlledFlank, FlankPlaces, FlankSlopes, StrokeControl, StrokeError, StrokeRecord, StrokeSpeeds,
    run_stroke, run_there_and_back,
};
use electronic_gearbox::Sign;
use electronic_gearbox::coefficient::{Coefficient, GearGeometry};
use foundation::geometry::Flank;
use foundation::kinematics::{GeneratingMotion, GeneratingState, Pose, Workpiece};
use foundation::numerics::{equidistant, extremes};
use job::Diagnostic;
use job::tables::{Control, FeedSenses};
use referee::{RayGrid, TimedGrinding, WormArea, grind_in_time};
use run::RunFailure;
use run::control::{
    disturbances, interpolation, interpolator_alarms, of_servo, on_field, rotation, rotation_refused,
    servo_parameters,
};
use std::collections::BTreeMap;
use std::f64::consts::TAU;
use verdict::Remark;

/// Where the tables of the control stand in the job.
const BELOW: &str = "control.";
/// Points of a trace.
const TRACE: usize = 161;
/// Teeth whose traces are shown.
const TRACED_TEETH: usize = 4;
/// Stretches of time of the error's chart.
const STRETCHES: usize = 700;
/// Rays over the profile and the face width whose lengths are compared, on two teeth.
const SAMPLE: usize = 3;
/// Samples of the loop that one stroke may have.
const MOST_SAMPLES: f64 = 5e7;

impl ControlledRun<'_> {
    /// What the control leaves, with the alarms of its interpolator.
    ///
    /// # Errors
    /// [`RunFailure`] on a key of `[control]`.
    pub fn through_control(&self) -> Result<(ControlResult, Vec<Remark>), RunFailure> {
        let (control, pair) = (self.control, self.pair);
        let (threads, teeth) = (pair.worm.tooth_count().abs(), pair.work.tooth_count().abs());
        let worm = control.worm_speed_rpm.map_or(self.worm_speed, |rpm| rpm * TAU / 60.0);
        let turning = worm * threads / teeth / TAU;
        let feed = self.feed_per_revolution * turning;
        let speeds = self
            .passes
            .iter()
            .map(|pass| speeds(control, StrokeSpeeds { worm, feed_range: pass.feed_range, feed }))
            .collect::<Result<Vec<_>, _>>()?;
        let (stroke, per_metre) = stroke_control(control, pair)?;
        let work = pair.work.flank(Flank::Left);
        let arm_um = 1e3 * work.base_radius * work.base_helix_angle.cos();
        let frequency = worm / TAU * threads;
        let response = stroke.servo.disturbance_response(frequency);
        let response = response.map_err(|error| of_servo(&error, &control.servo, BELOW))?;
        let (mut flanks, mut alarms) = (BTreeMap::new(), Vec::new());
        for (pass, speeds) in self.passes.iter().zip(&speeds) {
            let mut of_pass = Vec::new();
            for ground in &pass.flanks {
                let records = self.records(&stroke, pass, speeds, ground.flank)?;
                // The slide is the same for both flanks of a pass, and so are its pulses.
                of_pass = records
                    .last()
                    .map_or(Vec::new(), |record| interpolator_alarms(&control.feed, &record.interpolator));
                flanks.insert(ground.flank.name(), self.flank_result(pass, ground, &records)?);
            }
            if self.passes.len() > 1 {
                let name = pass.name();
                of_pass.iter_mut().for_each(|alarm| alarm.text = format!("{name}: {}", alarm.text));
            }
            alarms.extend(of_pass);
        }
        let turn_um = TAU * arm_um;
        let result = ControlResult {
            worm_speed_rpm: worm * 60.0 / TAU,
            work_speed_rpm: turning * 60.0,
            feed_mm_per_min: feed * 60.0,
            scale_pitch_um: stroke.feed.pitch * 1e3,
            setpoint_step_um: turn_um / stroke.rotation.parts_per_revolution,
            encoder_step_um: turn_um / f64::from(stroke.workpiece_pulses),
            ratio_error_um_per_m: per_metre * arm_um,
            compliance_at_threads_um_per_n_m: response.norm() * arm_um,
            thread_frequency_hz: frequency,
            flanks,
        };
        Ok((result, alarms))
    }

    /// The strokes of a pass with the errors that one of its flanks sees.
    fn records(
        &self,
        stroke: &StrokeControl,
        pass: &ControlledPass<'_>,
        speeds: &StrokeSpeeds,
        flank: Flank,
    ) -> Result<Vec<StrokeRecord>, RunFailure> {
        let phase = pass.motion.phase[flank];
        let records = match self.control.feed_senses {
            FeedSenses::One => run_stroke(stroke, pass.motion, speeds, phase).map(|record| vec![record]),
            FeedSenses::Both => run_there_and_back(stroke, pass.motion, speeds, phase).map(Vec::from),
        };
        records.map_err(|error| match error {
            StrokeError::Control(error) => of_servo(&error, &self.control.servo, BELOW),
            StrokeError::Gearbox(error) => on_field(&error, "control.worm"),
        })
    }

    fn flank_result(
        &self,
        pass: &ControlledPass<'_>,
        ground: &GroundFlank<'_>,
        records: &[StrokeRecord],
    ) -> Result<ControlFlankResult, RunFailure> {
        let (pair, motion, deviation) = (&self.pair.flanks[ground.flank], pass.motion, &ground.deviation);
        let (left_by_stroke, of_worm) = (ground.slopes(), ground.worm_slopes());
        let slopes = FlankSlopes { ground: &left_by_stroke, worm: &of_worm };
        let places = records.iter().map(|record| FlankPlaces { pair, motion, record, slopes });
        let places = Strokes(places.collect());
        let count = pair.work.teeth.abs() as usize;
        let all: Vec<usize> = (0..count).collect();
        let left = places.flank(&deviation.w, &deviation.z, &all);
        let [least, greatest] = left.extremes();
        let (mut with, mut share) = (0.0f64, 0.0f64);
        let points: Vec<(f64, f64)> =
            deviation.w.iter().flat_map(|&w| deviation.z.iter().map(move |&z| (w, z))).collect();
        for tooth in &left.teeth {
            for ((&(w, z), f), control) in points.iter().zip(&deviation.f).zip(tooth) {
                let sum = (f * 1e3 + control).abs();
                with = with.max(sum);
                share = share.max(sum / (1e3 * (self.tolerance)(w, z)));
            }
        }
        let means = left.means();
        let step = |k: usize| (means[(k + 1) % count] - means[k]).abs();
        let [w, z] = [
            [deviation.w[0], deviation.w[deviation.w.len() - 1]],
            [deviation.z[0], deviation.z[deviation.z.len() - 1]],
        ];
        let (trace_w, trace_z) = (equidistant(w, TRACE), equidistant(z, TRACE));
        let traced: Vec<usize> =
            (0..TRACED_TEETH.min(count)).map(|k| k * count / TRACED_TEETH.min(count)).collect();
        let named = |teeth: Vec<Vec<f64>>| {
            traced.iter().zip(teeth).map(|(&tooth, f_um)| Trace { tooth, f_um }).collect::<Vec<_>>()
        };
        let [mid_w, mid_z] = [0.5 * (w[0] + w[1]), 0.5 * (z[0] + z[1])];
        let profiles = named(places.flank(&trace_w, &[mid_z], &traced).teeth);
        let helices = named(places.flank(&[mid_w], &trace_z, &traced).teeth);
        let sample = RayGrid::equidistant(w, SAMPLE, z, SAMPLE);
        let sample = sample.map_err(|error| RunFailure::of_removal(&error, "control"))?;
        let mut difference = 0.0f64;
        for tooth in [0, count / 2] {
            let mut rays = vec![f64::INFINITY; sample.count()];
            for record in records {
                let of_stroke = self.by_rays(motion, ground, record, &sample, tooth)?;
                rays.iter_mut().zip(of_stroke).for_each(|(least, f)| *least = least.min(f));
            }
            for (k, f) in rays.iter().enumerate() {
                let (w, z) = sample.ray(k);
                difference = difference.max((f - 1e3 * places.deviation(w, z, tooth)).abs());
            }
        }
        let arm_um = 1e3 * pair.work.base_radius * pair.work.base_helix_angle.cos();
        let [low, high] = extremes(means.iter().copied());
        Ok(ControlFlankResult {
            largest_um: greatest.max(-least),
            rms_um: left.rms(),
            topography_um: left.teeth[0].chunks(deviation.z.len()).map(<[f64]>::to_vec).collect(),
            deviation_with_control_um: with,
            tolerance_share: share,
            single_pitch_um: (0..count).map(step).fold(0.0, f64::max),
            cumulative_pitch_um: high - low,
            tooth_means_um: means,
            trace_w_mm: trace_w,
            trace_z_mm: trace_z,
            profiles,
            helices,
            model_difference_um: difference,
            sample: 2 * sample.count(),
            error: records.first().map(|record| error_trace(record, arm_um)).unwrap_or_default(),
            means_um: records.first().map_or([0.0; 2], |record| record.means.map(|mean| mean * arm_um)),
            torque_limited_share: records.iter().map(|record| record.limited).fold(0.0, f64::max),
            greatest_torque_n_m: records.iter().map(|record| record.greatest_torque).fold(0.0, f64::max),
            senses_apart_um: places.apart(&deviation.w, &deviation.z, &all),
        })
    }

    /// Rays of one tooth under the motion that was really driven less those under the ideal one, um.
    fn by_rays(
        &self,
        motion: &GeneratingMotion,
        ground: &GroundFlank<'_>,
        record: &StrokeRecord,
        grid: &RayGrid,
        tooth: usize,
    ) -> Result<Vec<f64>, RunFailure> {
        let (pair, flank) = (self.pair, ground.flank);
        let speeds = record.speeds();
        let phase = motion.phase[flank];
        let state = |time: f64| motion.state(speeds.worm * time, record.feed(time), phase);
        let to_tooth = Pose::<Workpiece, Workpiece>::rz(-TAU * tooth as f64 / motion.teeth.abs());
        let last = record.start + record.sample_time * (record.actual.len() - 1) as f64;
        // Laws of the feed need not hold beyond the stroke.
        let turning = (state(last).work_angle - state(record.start).work_angle).abs() / (last - record.start);
        let rays = |share: f64| {
            let pose = |time: f64| {
                let ideal = state(time);
                let driven =
                    GeneratingState { work_angle: ideal.work_angle + share * record.error(time), ..ideal };
                motion.chain.pose(&driven).then(&to_tooth)
            };
            let setup = TimedGrinding {
                worm: pair.worm.flank(flank),
                area: WormArea { w: [1e-3, 1e4], z: [-1e4, 1e4] },
                modification: &ground.worm,
                work: pair.work.flank(flank),
                pose: &pose,
                span: [record.start, last],
                revolution: TAU / turning,
                stock: ground.stock,
            };
            grind_in_time(&setup, grid).map_err(|error| RunFailure::of_removal(&error, "control"))
        };
        Ok(rays(1.0)?.iter().zip(rays(0.0)?).map(|(with, without)| 1e3 * (with - without)).collect())
    }
}

/// The speeds of a stroke whose samples can be counted.
fn speeds(control: &Control, speeds: StrokeSpeeds) -> Result<StrokeSpeeds, RunFailure> {
    let [first, last] = speeds.feed_range;
    let duration = (last - first).abs() / speeds.feed;
    let step = control.servo.sample_time_us * 1e-6;
    let strokes = match control.feed_senses {
        FeedSenses::One => 1.0,
        FeedSenses::Both => 2.0,
    };
    let samples = strokes * duration / step;
    if samples > MOST_SAMPLES {
        let least = strokes * duration / MOST_SAMPLES * 1e6;
        let message = format!("a stroke of {duration:.1} s would have {samples:.1e} samples of the servo");
        let finding = Diagnostic::with_code("too-many-samples", message)
            .field("control.servo.sample_time_us".to_owned())
            .value(control.servo.sample_time_us.to_string())
            .allowed(format!("at least {least:.3} for this stroke"))
            .way_out("take a longer sample time, or a larger feed per revolution");
        return Err(RunFailure::bad_input(finding));
    }
    Ok(speeds)
}

/// The control, and what the ratio of its additional rotation is off by, rad per metre.
fn stroke_control(control: &Control, pair: &Pair) -> Result<(StrokeControl, f64), RunFailure> {
    let feed = interpolation(&control.feed, BELOW)?;
    let p = feed.settings.pulses_per_interval();
    let pulses = control.workpiece.pulses_per_revolution;
    let data = pair.work.data();
    // The coupling of the feed, which a conical workpiece does not have from its lead.
    let turns = pair.flanks.left.feed_coupling / f64::from(data.teeth) / TAU;
    let coefficient = || {
        let angle = data.pressure_angle.left;
        let gear = GearGeometry::new(data.normal_module, data.teeth, data.helix_angle, angle)?;
        Coefficient::new(&gear, pulses, control.feed.pulses_per_metre, Sign::Plus)
    };
    let rotation = rotation(control.workpiece, turns, &feed, coefficient)
        .map_err(|error| rotation_refused(&error, control.workpiece, BELOW))?;
    let per_metre = rotation.error_per_metre(feed.pitch / f64::from(p));
    let stroke = StrokeControl {
        feed,
        rotation,
        worm_pulses: control.worm.pulses_per_revolution,
        workpiece_pulses: pulses,
        shift_pitch: control.shift.as_ref().map(|scale| 1e3 / scale.pulses_per_metre),
        servo: servo_parameters(&control.servo, pulses, p, BELOW)?,
        disturbances: disturbances(&control.servo, BELOW)?,
    };
    Ok((stroke, per_metre))
}

/// The places of a flank under one stroke, or under one there and one back: the deeper of them stays.
struct Strokes<'a>(Vec<FlankPlaces<'a>>);

impl Strokes<'_> {
    fn flank(&self, w: &[f64], z: &[f64], teeth: &[usize]) -> ControlledFlank {
        let mut all = self.0.iter().map(|places| places.flank(w, z, teeth));
        let first = all.next().unwrap_or(ControlledFlank { w: w.to_vec(), z: z.to_vec(), teeth: Vec::new() });
        all.fold(first, |mut deepest, other| {
            let pairs = deepest.teeth.iter_mut().flatten().zip(other.teeth.iter().flatten());
            pairs.for_each(|(least, f)| *least = least.min(*f));
            deepest
        })
    }

    fn deviation(&self, w: f64, z: f64, tooth: usize) -> f64 {
        self.0.iter().map(|places| places.deviation(w, z, tooth)).fold(f64::INFINITY, f64::min)
    }

    /// Largest difference of the flanks that either sense would leave by itself, um; `None` of one sense.
    fn apart(&self, w: &[f64], z: &[f64], teeth: &[usize]) -> Option<f64> {
        let [there, back] = self.0.as_slice() else { return None };
        let (there, back) = (there.flank(w, z, teeth), back.flank(w, z, teeth));
        let pairs = there.teeth.iter().flatten().zip(back.teeth.iter().flatten());
        Some(pairs.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max))
    }
}

/// The error over the stroke in stretches of time.
fn error_trace(record: &StrokeRecord, arm_um: f64) -> ErrorTrace {
    let count = record.actual.len();
    let width = count.div_ceil(STRETCHES).max(1);
    let mut trace = ErrorTrace::default();
    for (k, (setpoint, actual)) in record.setpoint.chunks(width).zip(record.actual.chunks(width)).enumerate()
    {
        let time = record.start + record.sample_time * (k as f64 + 0.5) * width as f64;
        trace.feed_mm.push(record.feed(time));
        for (lines, values) in [(&mut trace.setpoint_um, setpoint), (&mut trace.actual_um, actual)] {
            for (line, end) in lines.iter_mut().zip(extremes(values.iter().copied())) {
                line.push(arm_um * end);
            }
        }
    }
    trace
}
