//! Random toothed bodies for property tests.

use foundation::geometry::{Gear, GearData, Sides};
use proptest::prelude::*;

/// Drawing data of a body that can be made: external or internal, symmetric or not, cylindrical or conical, both hands.
pub fn gear_data() -> impl Strategy<Value = GearData> {
    let angles = (14.0..28.0f64, 14.0..28.0f64, any::<bool>());
    (8..90i32, any::<bool>(), 0.8..6.0f64, angles, -40.0..40.0f64, -0.3..0.5f64, -6.0..6.0f64, 0..3u8)
        .prop_map(|(teeth, internal, module, (left, right, symmetric), beta, x, cone, kind)| {
            let right = if symmetric { left } else { right };
            let conical = !internal && kind == 0;
            GearData {
                teeth: if internal { -teeth } else { teeth },
                normal_module: module,
                pressure_angle: Sides { left: left.to_radians(), right: right.to_radians() },
                helix_angle: if kind == 1 { 0.0 } else { beta.to_radians() },
                profile_shift: x,
                cone_angle: if conical { cone.to_radians() } else { 0.0 },
            }
        })
}

/// A random body.
pub fn gear() -> impl Strategy<Value = Gear> {
    gear_data().prop_filter_map("no body", |data| Gear::new(data).ok())
}
