//! What a control leaves on the flank, in closed form against the referee: rays in true feed marks under the motion that was really driven
//! (spec 70 sections 7 and 8).

use electronic_gearbox::pulse::{Mode, Settings};
use flankwright::contact::Pair;
use flankwright::control::servo::{
    Disturbance, Disturbances, Drive, Gains, Quantisation, ServoParameters, Spindle,
};
use flankwright::control::{
    FlankPlaces, Interpolation, Rotation, StrokeControl, StrokeRecord, StrokeSpeeds, run_stroke,
};
use flankwright::geometry::{Flank, Gear, GearData, Sides, WormChoice, worm_for_gear};
use flankwright::kinematics::{GeneratingMotion, GeneratingState, MotionLaw};
use flankwright::removal::{RayGrid, TimedGrinding, Unmodified, WormArea, grind_in_time};
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
) -> Vec<f64> {
    let speeds = record.speeds();
    let phase = motion.phase[flank];
    let angle = |time: f64| motion.state(speeds.worm * time, record.feed(time), phase).work_angle;
    let turning = angle(1.0) - angle(0.0);
    let rays = |error: &(dyn Fn(f64) -> f64 + Sync)| {
        let pose = |time: f64| {
            let state = motion.state(speeds.worm * time, record.feed(time), phase);
            motion.chain.pose(&GeneratingState { work_angle: state.work_angle + error(time), ..state })
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

#[test]
fn places_keep_what_the_referee_leaves() {
    for (teeth, helix, ratio, sense) in [(31, -0.4, 0.0, 1.0), (31, -0.4, 0.6, -1.0), (24, 0.25, -0.3, 1.0)] {
        let pair = pair(teeth, helix);
        let motion = pair.motion(MotionLaw::polynomial(0.0, vec![0.0, ratio]));
        let control = control(&pair, torques(), true);
        let speeds = StrokeSpeeds { worm: 300.0, feed_range: [-sense * 9.0, sense * 9.0], feed: 1.4 };
        let phase = motion.phase[Flank::Left];
        let record = run_stroke(&control, &motion, &speeds, phase).unwrap();
        let big = record.actual.iter().fold(0.0f64, |a, e| a.max(e.abs()));
        let big2 = record.setpoint.iter().fold(0.0f64, |a, e| a.max(e.abs()));
        eprintln!(
            "{big} {big2} {:?} n {} limited {} torque {}",
            record.means,
            record.actual.len(),
            record.limited,
            record.greatest_torque
        );
        assert_eq!((record.alarms, record.limited), (0, 0.0));
        for flank in Flank::BOTH {
            let work = pair.work.flank(flank);
            let at = |radius: f64| work.length_of_roll(radius).unwrap();
            let pitch_radius = 0.5 * 3.5 * f64::from(teeth) / helix.cos();
            let grid =
                RayGrid::equidistant([at(pitch_radius - 1.5), at(pitch_radius + 3.0)], 7, [-2.0, 2.0], 9)
                    .unwrap();
            let simulated = by_rays(&pair, flank, &motion, &record, &grid);
            let places = FlankPlaces { pair: &pair.flanks[flank], motion: &motion, record: &record };
            let (mut worst, mut largest) = (0.0f64, 0.0f64);
            for (k, f) in simulated.iter().enumerate() {
                let (w, z) = grid.ray(k);
                let mapped = 1e3 * places.deviation(w, z, 0);
                eprintln!("{w:.3} {z:.3} {f:.4} {mapped:.4}");
                worst = worst.max((f - mapped).abs());
                largest = largest.max(f.abs());
            }
            eprintln!("{teeth} {ratio} {flank} worst {worst} of {largest}");
        }
    }
}
