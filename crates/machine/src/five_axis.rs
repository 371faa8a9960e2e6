//! Machines with two rotary axes and three slides and no ends of travel worth the name, as
//! `docs/mathematics/milling.md#positions-of-five-axes` names them: for comparisons that no machine of a workshop is needed for.

use crate::{Axis, AxisLimits, InvalidMachine, Joint, Limb, Machine, MachineParts};
use nalgebra::Vector3;
use std::f64::consts::{FRAC_1_SQRT_2, PI, TAU};

/// Travel of the slides, mm.
const FAR: f64 = 1e6;

/// What carries what.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Chain {
    /// The trunnion A carries the table C.
    AcTable,
    /// The trunnion B carries the table C.
    BcTable,
    /// A table C on an axis inclined by 45 degrees.
    NutatingTable,
    /// The head swivels about B, the table turns about C.
    HeadTable,
    /// The fork C carries the head A.
    HeadHead,
}

/// Where the axes stand and how fast they are.
pub struct Places {
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

/// The machine: axes X, Y, Z, C and the tilt, in this order. C turns twice to either side, the tilt once.
///
/// # Errors
/// [`InvalidMachine`] for places or speeds that are not finite.
pub fn chain(chain: Chain, places: &Places) -> Result<Machine, InvalidMachine> {
    let head = Vector3::new(0.0, 0.0, places.pivot);
    let [q_1, q_2] = places.points;
    let (name, tool, work, points, tilt): (_, &[usize], &[usize], _, _) = match chain {
        Chain::AcTable => ("A-C table", &[0, 1, 2], &[4, 3], [q_1, q_2], ("A", Vector3::x())),
        Chain::BcTable => ("B-C table", &[0, 1, 2], &[4, 3], [q_1, q_2], ("B", Vector3::y())),
        Chain::NutatingTable => {
            let inclined = Vector3::new(0.0, FRAC_1_SQRT_2, FRAC_1_SQRT_2);
            ("nutating table", &[0, 1, 2], &[4, 3], [q_1, q_2], ("B", inclined))
        }
        Chain::HeadTable => ("B head, C table", &[0, 1, 2, 4], &[3], [q_1, head], ("B", Vector3::y())),
        Chain::HeadHead => ("C-A head", &[0, 1, 2, 3, 4], &[], [head, head], ("A", Vector3::x())),
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
    Machine::new(MachineParts {
        name: name.into(),
        axes: vec![
            slide("X", Vector3::x()),
            slide("Y", Vector3::y()),
            slide("Z", Vector3::z()),
            axis("C", Joint::Rotary, Vector3::z(), points[0], TAU),
            axis(tilt.0, Joint::Rotary, tilt.1, points[1], PI),
        ],
        roles: Vec::new(),
        tool: limb(tool),
        work: limb(work),
        dresser: None,
    })
}
