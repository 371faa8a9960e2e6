//! Centre distance and workpiece angle that leave given amounts on both flanks: an involute flank stays one when the centre distance changes.

use super::Bodies;
use foundation::geometry::{Flank, Sides};

/// How a stroke stands off the finished flank.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Infeed {
    /// Added to the centre distance, mm.
    pub delta_d: f64,
    /// Added to the workpiece's angle, rad.
    pub delta_phi_2: f64,
}

impl Infeed {
    /// That leaves `left` (normal, mm).
    pub fn new(bodies: &Bodies, left: Sides<f64>) -> Self {
        let sine = |flank: Flank| bodies.flanks[flank].pair.operating_alpha_n.sin();
        let lever = |flank: Flank| {
            let work = bodies.flanks[flank].work();
            work.base_radius * work.base_helix_angle.cos()
        };
        let (sin_l, sin_r) = (sine(Flank::Left), sine(Flank::Right));
        let (lever_l, lever_r) = (lever(Flank::Left), lever(Flank::Right));
        let by = sin_l * lever_r + sin_r * lever_l;
        Self {
            delta_d: (left.left * lever_r + left.right * lever_l) / by,
            delta_phi_2: (left.right * sin_l - left.left * sin_r) / by,
        }
    }
}
