//! Worms with their nominal dressers for tests of dressing: fixed ones of the reference file and random ones.

use dressing::{DresserTool, DressingError, GeometricRange};
use foundation::geometry::{Flank, Gear, GearData, Sides};
use foundation::kinematics::DressingChain;
use proptest::prelude::*;

/// A worm with its dresser: threads, normal module, reference diameter, profile angles (deg), hand, cone angle (deg), diameter of
/// the dresser.
#[derive(Clone, Copy, Debug)]
pub struct Bodies {
    pub threads: i32,
    pub module: f64,
    pub diameter: f64,
    pub angles: [f64; 2],
    pub hand: f64,
    pub cone: f64,
    pub dresser: f64,
}

/// Case A of the reference file without its working depth: 5 threads, diameter 100 mm, dresser 123 mm.
pub const CASE_A: Bodies = Bodies {
    threads: 5,
    module: 3.5,
    diameter: 100.0,
    angles: [17.5, 17.5],
    hand: 1.0,
    cone: 0.0,
    dresser: 123.0,
};

impl Bodies {
    pub fn worm(&self) -> Gear {
        Gear::new(GearData {
            teeth: self.threads,
            normal_module: self.module,
            pressure_angle: Sides { left: self.angles[0].to_radians(), right: self.angles[1].to_radians() },
            helix_angle: self.hand * (f64::from(self.threads) * self.module / self.diameter).acos(),
            profile_shift: 0.0,
            cone_angle: self.cone.to_radians(),
        })
        .unwrap()
    }

    pub fn radius(&self) -> f64 {
        0.5 * self.diameter
    }

    pub fn chains(&self) -> Sides<DressingChain> {
        let worm = self.worm();
        Sides::from_fn(|flank| {
            let p = worm.screw_parameter(flank);
            DressingChain {
                worm_angle: -std::f64::consts::FRAC_PI_2,
                crossing_angle: -(p / self.radius()).atan(),
                centre_distance: 0.5 * (self.dresser + self.diameter) - 1.25 * self.module,
                offset: 0.0,
                screw_parameter: p,
            }
        })
    }

    pub fn ranges(&self) -> Sides<GeometricRange> {
        let worm = self.worm();
        Sides::from_fn(|flank| {
            let roll =
                |height: f64| worm.flank(flank).length_of_roll(self.radius() + height * self.module).unwrap();
            GeometricRange { w_nf: roll(-0.9), w_na: roll(0.9) }
        })
    }

    /// The conjugate dresser, if the worm has one.
    pub fn tool(&self) -> Result<DresserTool, DressingError> {
        DresserTool::conjugate(&self.worm(), self.chains(), self.ranges())
    }
}

/// Worms of 1 to 7 threads, both hands, diameters 60 to 300 mm with dressers of 60 to 200 mm, symmetric and not.
pub fn bodies() -> impl Strategy<Value = Bodies> {
    let angles = (15.0..24.0f64, 15.0..24.0f64, any::<bool>());
    (1..8i32, 0.4..0.9f64, 60.0..300.0f64, angles, any::<bool>(), 60.0..200.0f64).prop_map(
        |(threads, size, diameter, (left, right, symmetric), right_hand, dresser)| Bodies {
            threads,
            // Leads up to 15 degrees, thread heights up to a twelfth of the diameter and a sixth of the dresser's.
            module: size * (0.26 * diameter / f64::from(threads)).min(diameter / 25.0).min(dresser / 13.0),
            diameter,
            angles: [left, if symmetric { left } else { right }],
            hand: if right_hand { 1.0 } else { -1.0 },
            cone: 0.0,
            dresser,
        },
    )
}

pub fn flanks() -> impl Strategy<Value = Flank> {
    any::<bool>().prop_map(|left| if left { Flank::Left } else { Flank::Right })
}
