//! The gears that the closed loop is shown on.

use contact::Pair;
use foundation::geometry::{Flank, Gear, GearData, Sides, WormChoice, worm_for_gear};
use foundation::kinematics::{GeneratingMotion, MotionLaw};
use foundation::modification::EvaluationField;
use foundation::numerics::equidistant;
use generating::FlankLines;
use generating::correction::{FlankPoint, Setting};

pub const UM: f64 = 1e-3;
pub const RATIO: f64 = 0.8;

/// A pair with its fields and lines at the diagonal ratio 0.8.
pub struct Ground {
    pub pair: Pair,
    pub fields: Sides<EvaluationField>,
    pub lines: Sides<FlankLines>,
    pub width: f64,
}

struct Numbers {
    teeth: i32,
    module: f64,
    angles: [f64; 2],
    helix: f64,
    width: f64,
    diameters: [f64; 2],
    threads: i32,
    worm: f64,
    extra: f64,
}

impl Ground {
    /// Helical, right-hand, three threads.
    pub fn helical() -> Self {
        Self::new(&Numbers {
            teeth: 31,
            module: 2.5,
            angles: [20.0, 20.0],
            helix: 20.0,
            width: 30.0,
            diameters: [78.0, 87.4],
            threads: 3,
            worm: 250.0,
            extra: 0.0,
        })
    }

    /// Asymmetric, left-hand, two threads, worm further away than without backlash.
    pub fn asymmetric() -> Self {
        Self::new(&Numbers {
            teeth: 27,
            module: 3.0,
            angles: [25.0, 18.0],
            helix: -15.0,
            width: 24.0,
            diameters: [80.0, 89.6],
            threads: 2,
            worm: 220.0,
            extra: 0.3,
        })
    }

    fn new(n: &Numbers) -> Self {
        let gear = Gear::new(GearData {
            teeth: n.teeth,
            normal_module: n.module,
            pressure_angle: Sides { left: n.angles[0].to_radians(), right: n.angles[1].to_radians() },
            helix_angle: n.helix.to_radians(),
            profile_shift: 0.0,
            cone_angle: 0.0,
        })
        .unwrap();
        let choice = WormChoice {
            threads: n.threads,
            hand: 1.0,
            pitch_diameter: Some(n.worm),
            tip_diameter: None,
            pressure_angle: None,
            profile_shift: 0.0,
            cone_angle: 0.0,
        };
        let made = worm_for_gear(&gear, &choice).unwrap();
        let close = Pair::without_backlash(made.worm, gear, made.crossed_axes_angle).unwrap();
        let mut chain = close.chain;
        chain.centre_distance += n.extra;
        let pair = Pair::new(close.worm, close.work, chain).unwrap();
        let fields = Sides::from_fn(|flank| {
            let f = pair.work.flank(flank);
            let roll = n.diameters.map(|d| f.length_of_roll(d / 2.0).unwrap());
            let face = [-n.width / 2.0, n.width / 2.0];
            EvaluationField::new(roll, face, f.base_radius, f.base_helix_angle).unwrap()
        });
        let lines = Sides::from_fn(|flank| {
            let own = &pair.flanks[flank];
            let line = own.axial_section_line(fields[flank].roll_middle());
            FlankLines::new(own, &fields[flank], line.rho.tan())
        });
        Self { pair, fields, lines, width: n.width }
    }

    pub fn motion(&self) -> GeneratingMotion {
        self.pair.motion(MotionLaw::polynomial(0.0, vec![0.0, RATIO]))
    }

    /// An even grid over both flanks.
    pub fn points(&self, sizes: [usize; 2]) -> Vec<FlankPoint> {
        let mut points = Vec::new();
        for flank in Flank::BOTH {
            for w in equidistant(self.fields[flank].roll(), sizes[0]) {
                let z = equidistant(self.fields[flank].face(), sizes[1]);
                points.extend(z.into_iter().map(|z| FlankPoint { flank, w, z }));
            }
        }
        points
    }
}

/// Micrometres and arc seconds of the usual settings in units of the library.
pub fn amounts(values: &[(Setting, f64)]) -> Vec<(Setting, f64)> {
    let unit = |setting| match setting {
        Setting::WorkAngle(_) => (1f64 / 3600.0).to_radians(),
        _ => UM,
    };
    values.iter().map(|&(setting, value)| (setting, value * unit(setting))).collect()
}

/// Ten errors at once: size, taper, crownings, index, helix angle, profiles.
pub fn many_errors() -> Vec<(Setting, f64)> {
    use Setting::{ProfileCrown, ProfileSlope, RadialFeed, WorkAngle};
    amounts(&[
        (RadialFeed(0), 9.0),
        (RadialFeed(1), 6.0),
        (RadialFeed(2), -4.0),
        (WorkAngle(0), 15.0),
        (WorkAngle(1), 25.0),
        (WorkAngle(2), -10.0),
        (ProfileSlope(Flank::Left), 3.0),
        (ProfileCrown(Flank::Left), 1.5),
        (ProfileSlope(Flank::Right), -2.0),
        (ProfileCrown(Flank::Right), 2.2),
    ])
}

/// Root mean square, um.
pub fn rms_um(values: &[f64]) -> f64 {
    foundation::numerics::root_mean_square(values) / UM
}
