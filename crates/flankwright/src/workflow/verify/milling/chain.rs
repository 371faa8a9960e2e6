//! Machines of the file: chains of two rotary axes and three slides (spec 50 section 11).

use super::super::given::Checked;
use crate::machine::{Axis, AxisLimits, Joint, Limb, Machine, MachineParts};
use nalgebra::Vector3;
use std::f64::consts::{FRAC_1_SQRT_2, PI, TAU};

/// Travel of the slides, mm: the file gives none.
const FAR: f64 = 1e6;

/// Where the axes stand and how fast they are.
pub(super) struct Places {
    /// q_1 and q_2: points on the rotary axes of tables, mm.
    pub points: [Vector3<f64>; 2],
    /// Lp: from the pivot of a head to the tip, mm.
    pub pivot: f64,
    /// Greatest speeds of rotary axes (rad/s) and slides (mm/s).
    pub speeds: Option<[f64; 2]>,
}

impl Default for Places {
    fn default() -> Self {
        Self { points: [Vector3::zeros(); 2], pivot: 0.0, speeds: None }
    }
}

/// The machine of that name: axes X, Y, Z, C and the tilt, in this order. C turns twice to either side, the tilt once.
pub(super) fn chain(name: &str, places: &Places) -> Checked<Machine> {
    let head = Vector3::new(0.0, 0.0, places.pivot);
    let [q_1, q_2] = places.points;
    let (tool, work, points, tilt): (&[usize], &[usize], _, _) = match name {
        "AC_table_table" => (&[0, 1, 2], &[4, 3], [q_1, q_2], Vector3::x()),
        "BC_table_table" => (&[0, 1, 2], &[4, 3], [q_1, q_2], Vector3::y()),
        "CB_nutating45_table_table" => {
            (&[0, 1, 2], &[4, 3], [q_1, q_2], Vector3::new(0.0, FRAC_1_SQRT_2, FRAC_1_SQRT_2))
        }
        "B_head_C_table" => (&[0, 1, 2, 4], &[3], [q_1, head], Vector3::y()),
        "CA_head_head" => (&[0, 1, 2, 3, 4], &[], [head, head], Vector3::x()),
        _ => return Err(format!("the chain {name:?} is unknown").into()),
    };
    let limb = |axes: &[usize]| Limb {
        axes: axes.to_vec(),
        origin: Vector3::zeros(),
        x: Vector3::x(),
        z: Vector3::z(),
    };
    let axis = |name: &str, joint: Joint, direction: Vector3<f64>, point: Vector3<f64>, reach: f64| Axis {
        name: name.into(),
        joint,
        direction,
        point,
        travel: Some([-reach, reach]),
        nc_sign: 1.0,
        limits: AxisLimits {
            velocity: places.speeds.map(|[rotary, linear]| match joint {
                Joint::Rotary => rotary,
                Joint::Linear => linear,
            }),
            ..AxisLimits::default()
        },
        resolution: None,
    };
    let slide = |name, direction| axis(name, Joint::Linear, direction, Vector3::zeros(), FAR);
    Ok(Machine::new(MachineParts {
        name: name.into(),
        axes: vec![
            slide("X", Vector3::x()),
            slide("Y", Vector3::y()),
            slide("Z", Vector3::z()),
            axis("C", Joint::Rotary, Vector3::z(), points[0], TAU),
            axis("tilt", Joint::Rotary, tilt, points[1], PI),
        ],
        roles: Vec::new(),
        tool: limb(tool),
        work: limb(work),
        dresser: None,
    })?)
}
