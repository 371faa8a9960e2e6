//! Bodies and strokes for the tests.

use foundation::geometry::{Gear, GearData, Sides, WormChoice, worm_for_gear};
use foundation::kinematics::GeneratingChain;
use grinding_technology::{Axes, Axis, Bodies, Direction, Ground, RunOut, Shift, Stock, StockTerm, Stroke};

/// A gear and its worm: teeth, module, pressure angle, helix angle (degrees), face width, form and tip diameter; threads and hand, pitch
/// and tip diameter.
pub fn bodies(gear: (i32, f64, f64, f64, f64, [f64; 2]), worm: (i32, f64, [f64; 2])) -> Bodies {
    let (teeth, normal_module, angle, helix, face_width, [form, tip]) = gear;
    let gear = Gear::new(GearData {
        teeth,
        normal_module,
        pressure_angle: Sides::both(f64::to_radians(angle)),
        helix_angle: f64::to_radians(helix),
        profile_shift: 0.0,
        cone_angle: 0.0,
    })
    .unwrap();
    let (threads, hand, [pitch_diameter, tip_diameter]) = worm;
    let choice = WormChoice {
        threads,
        hand,
        pitch_diameter: Some(pitch_diameter),
        tip_diameter: Some(tip_diameter),
        pressure_angle: None,
        profile_shift: 0.0,
        cone_angle: 0.0,
    };
    let made = worm_for_gear(&gear, &choice).unwrap();
    let chain = GeneratingChain {
        centre_distance: made.worm.pitch_radius() + gear.pitch_radius(),
        crossed_axes_angle: made.crossed_axes_angle,
        worm_cone: 0.0,
        work_cone: 0.0,
        worm_pivot: 0.0,
        work_pivot: 0.0,
    };
    let roll = Sides::from_fn(|flank| {
        [form, tip].map(|diameter| gear.flank(flank).length_of_roll(0.5 * diameter).unwrap())
    });
    let pair = contact::Pair::new(made.worm, gear, chain).unwrap();
    Bodies::new(pair, made.tip_radius, face_width, roll).unwrap()
}

pub fn helical() -> Bodies {
    bodies((19, 3.5, 17.5, -35.0, 40.0, [76.2065, 88.5315]), (3, -1.0, [191.25, 200.0]))
}

pub fn spur() -> Bodies {
    bodies((40, 2.0, 20.0, 0.0, 35.0, [76.8, 84.0]), (3, 1.0, [275.0, 280.0]))
}

pub fn stroke(left: f64, ratio: f64, direction: Direction) -> Stroke {
    Stroke {
        ground: Ground::Both,
        left: Sides::both(left),
        feed_per_revolution: 0.3,
        cutting_speed: 50.0,
        direction,
        shift: Shift::straight(ratio, 0.0),
        overrun: 1.0,
        dwell: 0.0,
        zone: "all".into(),
    }
}

/// Stock that differs over the flank and from space to space.
pub fn uneven() -> Stock {
    Stock {
        profile: vec![(78.0, -0.05), (78.8, 0.0)],
        terms: vec![
            StockTerm { i: 0, j: 2, amount: 0.012, flank: None },
            StockTerm { i: 1, j: 1, amount: -0.008, flank: None },
        ],
        run_out: Some(RunOut { eccentricity: 0.03, angle: 0.7 }),
        ..Stock::constant(Sides { left: 0.11, right: 0.095 })
    }
}

pub fn axes() -> Axes {
    let linear = Axis { speed: 250.0, acceleration: 2500.0, jerk: 50_000.0 };
    let rotary = Axis { speed: 36_000.0, acceleration: 36_000.0, jerk: 720_000.0 };
    Axes { x: linear, z: linear, v: linear, b: rotary, c: rotary }
}
