//! Toothed bodies as reference files write them, and the comparison of their base data.

use super::expected::Expected;
use super::ledger::Ledger;
use foundation::geometry::{Flank, Gear, GearData, GeometryError, Sides};
use foundation::kinematics::GeneratingChain;
use serde::Deserialize;

/// Drawing data of a body in a reference file.
#[derive(Clone, Copy, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Body {
    pub z: i32,
    m_n_mm: f64,
    alpha_n_left_deg: f64,
    alpha_n_right_deg: f64,
    beta_deg: f64,
    x: f64,
    theta_deg: f64,
}

impl Body {
    pub fn gear(&self) -> Result<Gear, GeometryError> {
        Gear::new(GearData {
            teeth: self.z,
            normal_module: self.m_n_mm,
            pressure_angle: Sides {
                left: self.alpha_n_left_deg.to_radians(),
                right: self.alpha_n_right_deg.to_radians(),
            },
            helix_angle: self.beta_deg.to_radians(),
            profile_shift: self.x,
            cone_angle: self.theta_deg.to_radians(),
        })
    }
}

/// The chain of worm and workpiece in a reference file.
#[derive(Clone, Copy, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct ChainInput {
    gamma_deg: f64,
    d_mm: f64,
    theta_1_deg: f64,
    theta_2_deg: f64,
    r_w1_mm: f64,
    r_w2_mm: f64,
}

impl ChainInput {
    pub fn chain(&self) -> GeneratingChain {
        GeneratingChain {
            centre_distance: self.d_mm,
            crossed_axes_angle: self.gamma_deg.to_radians(),
            worm_cone: self.theta_1_deg.to_radians(),
            work_cone: self.theta_2_deg.to_radians(),
            worm_pivot: self.r_w1_mm,
            work_pivot: self.r_w2_mm,
        }
    }
}

/// Tolerances of base data.
#[derive(Clone, Copy)]
pub(super) struct BaseTolerances {
    pub length: f64,
    pub angle_deg: f64,
    pub ratio: f64,
}

/// Compares pitch radius, transverse module and the base data of both flanks.
pub(super) fn base_data(expected: &mut Expected<'_>, gear: &Gear, tol: BaseTolerances, ledger: &mut Ledger) {
    let lengths = [("r_w_mm", gear.pitch_radius()), ("m_t_mm", gear.transverse_module())];
    expected.numbers(&lengths, tol.length, ledger);
    for flank in Flank::BOTH {
        let Some(mut side) = expected.object(flank.name(), ledger) else { continue };
        let f = gear.flank(flank);
        let lengths = [
            ("r_b_mm", f.base_radius),
            ("m_b_mm", gear.base_module(flank)),
            ("p_bn_mm", gear.normal_base_pitch(flank)),
        ];
        let angles = [
            ("beta_b_deg", f.base_helix_angle.to_degrees()),
            ("eta_b_deg", f.base_space_half_angle.to_degrees()),
            ("alpha_t_deg", gear.transverse_pressure_angle(flank).to_degrees()),
        ];
        let ratios =
            [("m_F", gear.rack_height_slope(flank)), ("tan_beta_b_over_r_b_per_mm", f.twist_per_length())];
        side.numbers(&lengths, tol.length, ledger);
        side.numbers(&angles, tol.angle_deg, ledger);
        side.numbers(&ratios, tol.ratio, ledger);
        side.finish(ledger);
    }
}
