//! How the dresser stands to the worm while it dresses with constant corrections: its circles in the room, where the worm axis
//! is z (`docs/mathematics/dressing.md#the-conjugate-profile`). Knows no flank.

use crate::limits::dresser_section::SectionCircle;
use foundation::kinematics::{DressingChain, DressingCorrection};
use std::f64::consts::{FRAC_PI_2, PI};

/// Pose of the dresser in the room (worm axis = z) and the screw along which the worm passes it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct DresserPose {
    worm_angle: f64,
    /// sin and cos of the crossing angle.
    tilt: [f64; 2],
    centre: [f64; 3],
    /// Direction from the worm axis to the dresser's centre, rad.
    centre_angle: f64,
    /// Direction from the dresser's centre to the worm axis, angle in the plane of the disc, rad.
    towards_worm: f64,
    screw_parameter: f64,
}

impl DresserPose {
    pub fn new(chain: &DressingChain, dk: &DressingCorrection) -> Self {
        let (sin, cos) = (chain.crossing_angle + dk[1]).sin_cos();
        let (d, v_y) = (chain.centre_distance + dk[2], chain.offset + dk[3]);
        let centre = [d, -v_y * cos, v_y * sin];
        Self {
            worm_angle: chain.worm_angle + dk[0],
            tilt: [sin, cos],
            centre,
            centre_angle: centre[1].atan2(centre[0]),
            towards_worm: (-centre[1] * cos).atan2(-centre[0]),
            screw_parameter: chain.screw_parameter,
        }
    }

    /// phi_S at v_zS = 0, rad.
    pub fn worm_angle(&self) -> f64 {
        self.worm_angle
    }

    /// Screw parameter of the dressing motion, mm/rad.
    pub fn screw_parameter(&self) -> f64 {
        self.screw_parameter
    }

    /// Room coordinates of the point at the angle psi of a circle, and their derivatives by psi, r and z.
    pub fn point(&self, circle: &SectionCircle, psi: f64) -> ([f64; 3], [[f64; 3]; 3]) {
        let [sin, cos] = self.tilt;
        let (s, c) = (self.towards_worm + psi).sin_cos();
        let ([x, y, h], (r, z)) = (self.centre, (circle.r, circle.z));
        (
            [x + r * c, y + r * s * cos + z * sin, h - r * s * sin + z * cos],
            [[-r * s, r * c * cos, -r * c * sin], [c, s * cos, -s * sin], [0.0, sin, cos]],
        )
    }

    /// Axial position, mm, at which a room point passes the plane through the worm axis and +x as the worm is screwed along.
    pub fn axial_position(&self, q: [f64; 3]) -> f64 {
        q[2] - self.screw_parameter * self.direction(q)
    }

    /// Direction of a room point seen from the worm axis without jump around the dresser, rad.
    pub fn direction(&self, [x, y, _]: [f64; 3]) -> f64 {
        let [c_x, c_y, _] = self.centre;
        self.centre_angle + (c_x * y - c_y * x).atan2(c_x * x + c_y * y)
    }

    /// Angles psi between which a circle comes within `reach` of the worm axis, on the half that faces it; `None` where it does
    /// not.
    pub fn arc(&self, circle: &SectionCircle, reach: f64) -> Option<[f64; 2]> {
        let [sin, cos] = self.tilt;
        let (c_x, c_y, r) = (self.centre[0], self.centre[1] + circle.z * sin, circle.r);
        let (along, across) = (c_x, c_y * cos);
        let amplitude = along.hypot(across);
        let middle = (-across).atan2(-along);
        let offset = middle - self.towards_worm;
        let offset = offset - 2.0 * PI * (offset / (2.0 * PI)).round();
        // distance^2 = c_x^2 + c_y^2 + r^2 - 2 r amplitude cos(psi - middle) - (r sin gamma sin psi)^2: the last term is small and
        // bounded by what is known of the arc.
        let mut half = FRAC_PI_2;
        for _ in 0..3 {
            // sin^2 of the largest angle against the direction -x or +x.
            let lean = (half + middle.sin().abs().asin()).min(FRAC_PI_2).sin();
            let bent = (r * sin * lean).powi(2);
            let level = (c_x * c_x + c_y * c_y + r * r - reach * reach - bent) / (2.0 * r * amplitude);
            if level.is_nan() || level >= 1.0 {
                return None;
            }
            half = half.min(level.max(-1.0).acos());
        }
        let ends = [(offset - half).max(-FRAC_PI_2), (offset + half).min(FRAC_PI_2)];
        (ends[0] < ends[1]).then_some(ends)
    }
}
