//! What a control leaves on the flank, in closed form against the referee: rays in true feed marks under the motion that was really driven
//! (`docs/mathematics/gearbox.md`).

use contact::Pair;
use control::servo::{Disturbance, Disturbances, Drive, Gains, Quantisation, ServoParameters, Spindle};
use control::{
    FlankPlaces, FlankSlopes, Interpolation, Rotation, StrokeControl, StrokeRecord, StrokeSpeeds, run_stroke,
    run_there_and_back,
};
use electronic_gearbox::pulse::{Mode, Settings};
use foundation::geometry::{Flank, Gear, GearData, Sides, WormChoice, worm_for_gear};
use foundation::kinematics::{GeneratingMotion, GeneratingState, MotionLaw, Pose, Workpiece};
use referee::{RayGrid, TimedGrinding, Unmodified, WormArea, grind_in_time};
use std::f64::consts::TAU;

fn pair(teeth: i32, helix_angle: f64) -> Pair {
    let gear = Gear::new(GearData {
        teeth,
        normal_module: 3.5,
        pressure_angle: Sides::both(20f64.to_radians()),
        helix_angle,
        profile_shift: 0.0,
        cone_angle: 0.0,
    })
    .unwrap();
    let choice = WormChoice {
        threads: 3,
        hand: if helix_angle < 0.0 { -1.0 } else { 1.0 },
        pitch_diameter: None,
        tip_diameter: Some(220.0),
        pressure_angle: None,
        profile_shift: 0.0,
        cone_angle: 0.0,
    };
    let made = worm_for_gear(&gear, &choice).unwrap();
    Pair::without_backlash(made.worm, gear, made.crossed_axes_angle).unwrap()
}

fn control(pair: &Pair, disturbances: Vec<Disturbance>, quantised: bool) -> StrokeControl {
    let drive = Drive {
        inertia: 0.12,
        viscous_friction: 0.05,
        coulomb_friction: 0.5,
        friction_speed: 0.05,
        torque_limit: 60.0,
    };
    let (workpiece_pulses, p) = (9_000_000u32, 64);
    let feed = Interpolation {
        settings: Settings::new(p, Settings::COUNTER_LIMIT, Mode::NoBacklash).unwrap(),
        clock: 10e6,
        pitch: 0.004,
    };
    let parts = f64::from(workpiece_pulses) * f64::from(p);
    let flank = &pair.flanks[Flank::Left];
    let turns = flank.feed_coupling / f64::from(pair.work.data().teeth) / TAU;
    StrokeControl {
        feed,
        rotation: Rotation::exact(turns, parts, feed.pitch / f64::from(p)).unwrap(),
        worm_pulses: 1 << 24,
        workpiece_pulses,
        shift_pitch: Some(1e-5),
        servo: ServoParameters {
            sample_time: 62.5e-6,
            drive,
            gains: Gains::triple_pole(60.0, &drive).unwrap(),
            feed_forward: 1.0,
            quantisation: quantised
                .then_some(Quantisation { counts_per_revolution: workpiece_pulses, multiplier: p }),
        },
        disturbances: Disturbances::new(disturbances).unwrap(),
    }
}

/// Torques as cutting makes them: once a turn of the workpiece, at the threads, at the cogs of a motor, and slow ones.
fn torques() -> Vec<Disturbance> {
    let turning =
        |spindle, amplitude, order, phase| Disturbance::HarmonicInAngle { spindle, amplitude, order, phase };
    vec![
        Disturbance::Constant { torque: 1.0 },
        Disturbance::HarmonicInTime { amplitude: 0.3, frequency: 1.7, phase: 0.4 },
        turning(Spindle::Workpiece, 0.3, 1.0, 0.3),
        turning(Spindle::Workpiece, 0.2, 7.0, 1.0),
        turning(Spindle::Worm, 2.5, 3.0, 0.7),
    ]
}

/// The referee's rays with the errors of the record as part of the motion less those without, um.
fn by_rays(
    pair: &Pair,
    flank: Flank,
    motion: &GeneratingMotion,
    record: &StrokeRecord,
    grid: &RayGrid,
    tooth: usize,
) -> Vec<f64> {
    let speeds = record.speeds();
    let phase = motion.phase[flank];
    let angle = |time: f64| motion.state(speeds.worm * time, record.feed(time), phase).work_angle;
    let turning = angle(1.0) - angle(0.0);
    let to_tooth = Pose::<Workpiece, Workpiece>::rz(-TAU * tooth as f64 / motion.teeth);
    let rays = |error: &(dyn Fn(f64) -> f64 + Sync)| {
        let pose = |time: f64| {
            let state = motion.state(speeds.worm * time, record.feed(time), phase);
            let driven = GeneratingState { work_angle: state.work_angle + error(time), ..state };
            motion.chain.pose(&driven).then(&to_tooth)
        };
        let setup = TimedGrinding {
            worm: pair.worm.flank(flank),
            area: WormArea { w: [50.0, 140.0], z: [-60.0, 60.0] },
            modification: &Unmodified,
            work: pair.work.flank(flank),
            pose: &pose,
            span: [record.start, record.start + record.sample_time * (record.actual.len() - 1) as f64],
            revolution: TAU / turning.abs(),
            stock: 0.1,
        };
        grind_in_time(&setup, grid).unwrap()
    };
    let disturbed = rays(&|time| record.error(time));
    disturbed.iter().zip(rays(&|_| 0.0)).map(|(with, without)| 1e3 * (with - without)).collect()
}

/// A stroke back behind the one there: without the pulses taken back at the reversal the flank stands off by all but one of an interval,
/// with them it does not. The first stroke is the same with and without the second.
#[test]
fn both_senses_of_a_stroke_count_through_the_reversal() {
    let pair = pair(31, -0.4);
    let motion = pair.motion(MotionLaw::polynomial(0.0, vec![0.0, 0.0]));
    let speeds = StrokeSpeeds { worm: 300.0, feed_range: [-6.0, 6.0], feed: 1.4 };
    let work = pair.work.flank(Flank::Left);
    let arm = 1e3 * work.base_radius * work.base_helix_angle.cos();
    let apart = |mode: Mode| {
        let mut control = control(&pair, Vec::new(), true);
        control.feed.settings = Settings::new(64, Settings::COUNTER_LIMIT, mode).unwrap();
        let phase = motion.phase[Flank::Left];
        let [there, back] = run_there_and_back(&control, &motion, &speeds, phase).unwrap();
        let alone = run_stroke(&control, &motion, &speeds, phase).unwrap();
        let most = there.setpoint.iter().zip(&alone.setpoint).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        assert!(most * arm < 1e-6, "{most}");
        assert!((back.feed(back.start) - 6.0).abs() < 1e-3 && back.speeds().velocity() < 0.0);
        let mean = |errors: &[f64]| errors.iter().sum::<f64>() / errors.len() as f64;
        [mean(&back.setpoint) * arm, mean(&back.actual) * arm]
    };
    // sin(beta_b) of the way between two reference pulses.
    let interval = 4.0 * work.base_helix_angle.sin().abs();
    let [setpoint, actual] = apart(Mode::OneWay).map(f64::abs);
    assert!((setpoint - interval * 63.0 / 64.0).abs() < 0.1 * interval, "{setpoint} of {interval}");
    assert!((actual - setpoint).abs() < 0.1 * interval, "{actual}");
    let [setpoint, actual] = apart(Mode::NoBacklash).map(f64::abs);
    assert!(setpoint < 0.05 * interval && actual < 0.1 * interval, "{setpoint} {actual}");
}

#[test]
fn places_keep_what_the_referee_leaves() {
    for (teeth, helix, ratio, sense) in [(31, -0.4, 0.0, 1.0), (31, -0.4, 0.6, -1.0), (24, 0.25, -0.3, 1.0)] {
        let pair = pair(teeth, helix);
        let motion = pair.motion(MotionLaw::polynomial(0.0, vec![0.0, ratio]));
        let control = control(&pair, torques(), true);
        let speeds = StrokeSpeeds { worm: 300.0, feed_range: [-sense * 9.0, sense * 9.0], feed: 1.4 };
        let phase = motion.phase[Flank::Left];
        let record = run_stroke(&control, &motion, &speeds, phase).unwrap();
        let alarms = (record.interpolator.too_fast, record.interpolator.overruns);
        assert_eq!((alarms, record.limited), ((0, 0), 0.0));
        for flank in Flank::BOTH {
            let work = pair.work.flank(flank);
            let at = |radius: f64| work.length_of_roll(radius).unwrap();
            let pitch_radius = 0.5 * 3.5 * f64::from(teeth) / helix.cos();
            let grid =
                RayGrid::equidistant([at(pitch_radius - 1.5), at(pitch_radius + 3.0)], 4, [-2.0, 2.0], 5)
                    .unwrap();
            let places = FlankPlaces {
                pair: &pair.flanks[flank],
                motion: &motion,
                record: &record,
                slopes: FlankSlopes { ground: &|_, _| [0.0; 2], worm: &|_, _| [0.0; 2] },
            };
            for tooth in [0, 1, 11] {
                let simulated = by_rays(&pair, flank, &motion, &record, &grid, tooth);
                let (mut worst, mut largest) = (0.0f64, 0.0f64);
                for (k, f) in simulated.iter().enumerate() {
                    let (w, z) = grid.ray(k);
                    worst = worst.max((f - 1e3 * places.deviation(w, z, tooth)).abs());
                    largest = largest.max(f.abs());
                }
                assert!(largest > 0.5, "the errors are seen: {largest} um");
                // Second order in time: feed and error are straight and parabolic over a pass for the closed form.
                assert!(worst < 0.001, "{teeth} teeth, {flank}, tooth {tooth}: {worst} of {largest} um");
            }
        }
    }
}

/// An ideal control leaves what its resolution leaves.
#[test]
fn without_disturbances_only_the_resolution_is_left() {
    let pair = pair(31, -0.4);
    let mut motion = pair.motion(MotionLaw::polynomial(0.0, vec![0.0, 0.6]));
    motion.delta_phi_2 = MotionLaw::polynomial(0.0, vec![0.0, 1e-6, 3e-7]);
    let speeds = StrokeSpeeds { worm: 300.0, feed_range: [-9.0, 9.0], feed: 1.4 };
    let arm_um =
        1e3 * pair.work.flank(Flank::Left).base_radius * pair.work.flank(Flank::Left).base_helix_angle.cos();
    for sense in [1.0, -1.0] {
        let speeds = StrokeSpeeds { feed_range: speeds.feed_range.map(|feed| sense * feed), ..speeds };
        let record = run_stroke(&control(&pair, Vec::new(), false), &motion, &speeds, 0.3).unwrap();
        let worst = |errors: &[f64]| arm_um * errors.iter().fold(0.0f64, |a, e| a.max(e.abs()));
        // Half a count of the worm's encoder, 2 pi/2^24 over the ratio of 31/3, 1e-5 mm of the shift, 4 um/64 of the scale by sin(beta_b).
        assert!(worst(&record.setpoint) < 0.05, "{}", worst(&record.setpoint));
        // The loop follows the steps of its setpoint in part.
        assert!(worst(&record.actual) < 0.05, "{}", worst(&record.actual));
    }
}
